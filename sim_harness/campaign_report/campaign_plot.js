// SPDX-License-Identifier: Apache-2.0
// A plot over two linear axes with zoom: what it shows comes from content(), which returns
// {title, unit, xLabel, yLabel, x: {low, high}, y: {low, high}, ticks (none: linear), lines(draw),
// points: [{x, y, run, large, open, low, high, text}]}.
const kPlotTop = 8, kPlotBottom = 42, kNearPixels = 30, kLeastDrag = 6;
const pointReadout = document.getElementById("point-readout");
const xyPlots = [];

function padded({low, high}, share) {
  if (!(low <= high)) return {low: 0, high: 1};
  const pad = high > low ? share * (high - low) : Math.max(Math.abs(low) * 0.05, 1e-3);
  return {low: low - pad, high: high + pad};
}

function extentOf(values) {
  let low = Infinity, high = -Infinity;
  for (const v of values) {
    if (v === null || !Number.isFinite(v)) continue;
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  return {low, high};
}

function makeXYPlot(holder, series, description, content) {
  const panel = makePanel(holder, {title: "", unit: "", series}, description, () => draw());
  const plot = {zoom: null, at: null, drag: null, content: null, panel};
  const axes = () => plot.zoom || {x: plot.content.x, y: plot.content.y};

  function scales(width, height) {
    const {left, right} = margins(width), {x, y} = axes();
    const inner = {x: left, y: kPlotTop, w: width - left - right, h: height - kPlotTop - kPlotBottom};
    plot.inner = inner;
    plot.xAt = (v) => inner.x + (v - x.low) / (x.high - x.low) * inner.w;
    plot.yAt = (v) => inner.y + (y.high - v) / (y.high - y.low) * inner.h;
    plot.xOf = (px) => x.low + (px - inner.x) / inner.w * (x.high - x.low);
    plot.yOf = (py) => y.high - (py - inner.y) / inner.h * (y.high - y.low);
  }

  function drawAxes(context, theme) {
    const {inner, xAt, yAt} = plot, {x, y} = axes();
    context.lineWidth = 1;
    context.textBaseline = "middle";
    context.textAlign = "right";
    const up = linearTicks(y.low, y.high, inner.h / 40);
    for (const v of up.ticks) {
      const py = Math.round(yAt(v)) + 0.5;
      context.strokeStyle = theme.grid;
      strokeLine(context, inner.x, py, inner.x + inner.w, py);
      context.fillStyle = theme.muted;
      context.fillText(tickText(v, up.step), inner.x - 7, py);
    }
    context.textBaseline = "top";
    context.textAlign = "center";
    const across = linearTicks(x.low, x.high, Math.min(12, inner.w / 60));
    const ticks = plot.content.ticks ? plot.content.ticks.filter(({at}) => at >= x.low && at <= x.high)
      : across.ticks.map((v) => ({at: v, text: tickText(v, across.step)}));
    for (const {at, text} of ticks) {
      const px = Math.round(xAt(at)) + 0.5;
      context.strokeStyle = theme.grid;
      strokeLine(context, px, inner.y, px, inner.y + inner.h);
      context.fillStyle = theme.muted;
      const half = context.measureText(text).width / 2, last = inner.x + inner.w + margins(0).right - half;
      context.fillText(text, Math.min(px, last), inner.y + inner.h + 6);
    }
    context.fillText(plot.content.xLabel, inner.x + inner.w / 2, inner.y + inner.h + 23);
    context.strokeStyle = theme.line;
    context.strokeRect(Math.round(inner.x) + 0.5, inner.y + 0.5, Math.round(inner.w) - 1, inner.h - 1);
  }

  function drawPoint(context, theme, p) {
    const x = plot.xAt(p.x), y = plot.yAt(p.y);
    context.strokeStyle = context.fillStyle = theme.of(p.run);
    context.globalAlpha = p.large ? 1 : 0.45;
    context.lineWidth = 2;
    if (Number.isFinite(p.low) && Number.isFinite(p.high)) {
      const low = plot.yAt(p.low), high = plot.yAt(p.high);
      strokeLine(context, x, low, x, high);
      for (const end of [low, high]) strokeLine(context, x - 5, end, x + 5, end);
    }
    context.beginPath();
    context.arc(x, y, p.large ? 5 : 2.5, 0, 2 * Math.PI);
    if (p.open) {
      context.fillStyle = theme.panel;
      context.fill();
      context.stroke();
    } else {
      context.fill();
    }
    context.globalAlpha = 1;
  }

  function describe() {
    const {title, unit, xLabel} = plot.content, {x, y} = axes();
    panel.root.querySelector("h3").replaceChildren(title + " ", element("small", {}, "[" + unit + "]"));
    const range = (r) => r.low.toPrecision(5) + " " + r.high.toPrecision(5);
    panel.plot.dataset.x = range(x);
    panel.plot.dataset.y = range(y);
    panel.plot.setAttribute("aria-label", title + " [" + unit + "] over " + xLabel + ", " + description);
    document.getElementById("reset-zoom").disabled = xyPlots.every((p) => p.zoom === null);
  }

  const shown = (run) => panel.spec.series.every((s) => s.run !== run || s.shown);
  const visible = () => plot.content.points.filter((p) => shown(p.run) && Number.isFinite(p.x) && Number.isFinite(p.y));

  function draw() {
    plot.content = content(shown);
    const {context, width, height} = prepare(panel.base), theme = colours();
    const {inner} = (scales(width, height), plot);
    drawAxes(context, theme);
    context.save();
    context.beginPath();
    context.rect(inner.x, inner.y, inner.w, inner.h);
    context.clip();
    plot.content.lines((run, points, dashed) => {
      context.strokeStyle = run === null ? theme.muted : theme.of(run);
      context.lineWidth = run === null ? 1 : 1.6;
      context.setLineDash(dashed ? [5, 4] : []);
      context.beginPath();
      for (const [x, y] of points) if (Number.isFinite(y) && y !== null) context.lineTo(plot.xAt(x), plot.yAt(y));
      context.stroke();
      context.setLineDash([]);
    });
    const points = visible();
    for (const large of [false, true])
      points.filter((p) => Boolean(p.large) === large).forEach((p) => drawPoint(context, theme, p));
    context.restore();
    panel.plot.dataset.marks = points.length;
    describe();
    drawOverlay();
  }

  function drawOverlay() {
    const {context} = prepare(panel.overlay), theme = colours();
    if (plot.drag && plot.drag.to) {
      const {from, to} = plot.drag;
      context.fillStyle = theme.select;
      context.fillRect(Math.min(from.x, to.x), Math.min(from.y, to.y), Math.abs(to.x - from.x), Math.abs(to.y - from.y));
    }
    if (plot.at === null) return;
    pointReadout.textContent = plot.at.text;
    const {x, y} = axes(), within = (v, {low, high}) => v >= low && v <= high;
    if (!within(plot.at.x, x) || !within(plot.at.y, y)) return;
    context.strokeStyle = theme.ink;
    context.lineWidth = 1.5;
    context.beginPath();
    context.arc(plot.xAt(plot.at.x), plot.yAt(plot.at.y), 8, 0, 2 * Math.PI);
    context.stroke();
  }

  function setZoom(x, y) {
    if (x.high > x.low && y.high > y.low) plot.zoom = {x, y};
    draw();
  }
  function showAll() {
    plot.zoom = null;
    draw();
  }
  function zoomBy(factor) {
    const {x, y} = axes();
    const around = (r, c) => ({low: c - (c - r.low) * factor, high: c + (r.high - c) * factor});
    const centre = plot.at || {x: (x.low + x.high) / 2, y: (y.low + y.high) / 2};
    setZoom(around(x, centre.x), around(y, centre.y));
  }
  function moveBy(across, up) {
    const {x, y} = axes();
    const moved = (r, share) => ({low: r.low + share * (r.high - r.low), high: r.high + share * (r.high - r.low)});
    setZoom(moved(x, across), moved(y, up));
  }

  function step(by) {
    const points = visible().sort((a, b) => a.x - b.x || a.y - b.y);
    if (points.length === 0) return;
    const now = plot.at === null ? -1 : points.findIndex((p) => p.text === plot.at.text);
    plot.at = points[(now + by + points.length) % points.length];
    drawOverlay();
  }

  const place = (event) => {
    const box = panel.plot.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  };

  function nearest({x, y}) {
    let best = null, least = kNearPixels;
    for (const p of visible()) {
      const distance = Math.hypot(plot.xAt(p.x) - x, plot.yAt(p.y) - y);
      if (distance < least) [best, least] = [p, distance];
    }
    return best;
  }

  function endDrag() {
    const {from, to, moving} = plot.drag;
    plot.drag = null;
    const wide = to && Math.abs(to.x - from.x) > kLeastDrag, tall = to && Math.abs(to.y - from.y) > kLeastDrag;
    if (moving || !(wide || tall)) return drawOverlay();
    const {x, y} = axes(), ordered = (a, b) => ({low: Math.min(a, b), high: Math.max(a, b)});
    setZoom(wide ? ordered(plot.xOf(from.x), plot.xOf(to.x)) : x, tall ? ordered(plot.yOf(from.y), plot.yOf(to.y)) : y);
  }

  panel.plot.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    panel.plot.setPointerCapture(event.pointerId);
    plot.drag = {from: place(event), to: null, moving: event.shiftKey};
  });
  panel.plot.addEventListener("pointermove", (event) => {
    const at = place(event);
    if (plot.drag === null) {
      plot.at = nearest(at);
      return drawOverlay();
    }
    if (!plot.drag.moving) {
      plot.drag.to = at;
      return drawOverlay();
    }
    moveBy((plot.drag.from.x - at.x) / plot.inner.w, (at.y - plot.drag.from.y) / plot.inner.h);
    plot.drag.from = at;
  });
  panel.plot.addEventListener("pointerup", () => plot.drag && endDrag());
  panel.plot.addEventListener("pointercancel", () => { plot.drag = null; drawOverlay(); });
  panel.plot.addEventListener("pointerleave", () => { if (plot.drag === null) { plot.at = null; drawOverlay(); } });
  panel.plot.addEventListener("dblclick", showAll);
  panel.plot.addEventListener("keydown", (event) => {
    const moves = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]};
    const actions = {ArrowLeft: () => step(-1), ArrowRight: () => step(1), "+": () => zoomBy(0.5),
      "=": () => zoomBy(0.5), "-": () => zoomBy(2), Escape: showAll, "0": showAll};
    const action = event.shiftKey && moves[event.key] ? () => moveBy(...moves[event.key]) : actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });

  Object.assign(plot, {draw, showAll});
  xyPlots.push(plot);
  return plot;
}
