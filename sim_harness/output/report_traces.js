// SPDX-License-Identifier: Apache-2.0
// Time traces, the picture: data, scales, lines, crosshair. The hand on it is report_trace_input.js.
function makeTraceView() {
  const kMissing = 65535;  // level that stands for "no value"
  const kTop = 6, kBottom = 6;
  const {t0, dt, n} = report;
  const end = t0 + dt * (n - 1);
  const view = {from: t0, to: end};
  const pointer = {time: null, dragFrom: null, moving: null};  // times; moving: screen x
  const hiddenRuns = new Set();
  let dirty = null;

  document.getElementById("traces").hidden = false;
  const holder = document.getElementById("trace-panels");
  const axis = document.getElementById("time-axis");
  const readout = document.getElementById("time-readout");
  const reset = document.getElementById("reset-zoom");

  // Base64 of little-endian uint16 levels between low and high.
  function decode(series) {
    const text = atob(series.data);
    const values = new Float32Array(n);
    const step = (series.high - series.low) / (kMissing - 1);
    for (let i = 0; i < n; ++i) {
      const level = text.charCodeAt(2 * i) + 256 * text.charCodeAt(2 * i + 1);
      values[i] = level === kMissing ? NaN : series.low + step * level;
    }
    series.values = values;
    delete series.data;
  }

  const panels = report.traces.map((spec) => {
    spec.series.forEach(decode);
    return makePanel(holder, spec, "over time", () => redraw("data"));
  });
  const visible = (series) => series.shown && !hiddenRuns.has(series.run);
  const indexAt = (time) => Math.min(n - 1, Math.max(0, Math.round((time - t0) / dt)));

  function yRange(spec) {
    const first = Math.max(0, Math.floor((view.from - t0) / dt));
    const last = Math.min(n - 1, Math.ceil((view.to - t0) / dt));
    let low = Infinity, high = -Infinity;
    for (const series of spec.series.filter(visible)) {
      for (let i = first; i <= last; ++i) {
        const v = series.values[i];
        if (v < low) low = v;
        if (v > high) high = v;
      }
    }
    if (low > high) return {low: 0, high: 1};
    const pad = high > low ? 0.06 * (high - low) : Math.max(Math.abs(low) * 0.01, 1e-3);
    return {low: low - pad, high: high + pad};
  }

  // As many line segments as pixels: the extremes of each column are kept.
  function traceLine(context, values, xAt, yAt) {
    const first = Math.max(0, Math.floor((view.from - t0) / dt));
    const last = Math.min(n - 1, Math.ceil((view.to - t0) / dt));
    const perPixel = (last - first) / Math.max(1, xAt(view.to) - xAt(view.from));
    const bucket = Math.max(1, Math.floor(perPixel));
    let pen = false;
    const to = (i) => {
      if (Number.isNaN(values[i])) { pen = false; return; }
      const x = xAt(t0 + i * dt), y = yAt(values[i]);
      if (pen) context.lineTo(x, y); else context.moveTo(x, y);
      pen = true;
    };
    context.beginPath();
    for (let begin = first; begin <= last; begin += bucket) {
      let low = begin, high = begin;
      const stop = Math.min(begin + bucket, last + 1);
      for (let i = begin + 1; i < stop; ++i) {
        if (Number.isNaN(values[i])) { low = high = i; break; }
        if (values[i] < values[low]) low = i;
        if (values[i] > values[high]) high = i;
      }
      to(Math.min(low, high));
      if (low !== high) to(Math.max(low, high));
    }
    context.stroke();
  }

  function drawPanel(panel, first) {
    const {context, width, height} = prepare(panel.base);
    const theme = colours(), {left, right} = margins(width);
    panel.range = yRange(panel.spec);
    panel.xAt = (t) => left + (t - view.from) / (view.to - view.from) * (width - left - right);
    panel.yAt = (v) => kTop + (panel.range.high - v) / (panel.range.high - panel.range.low) *
      (height - kTop - kBottom);
    const inner = {x: left, y: kTop, w: width - left - right, h: height - kTop - kBottom};
    if (report.runIn > view.from) {
      context.fillStyle = theme.runIn;
      const to = Math.min(panel.xAt(report.runIn), left + inner.w);
      context.fillRect(left, kTop, to - left, inner.h);
      context.fillStyle = theme.muted;
      context.textBaseline = "top";
      if (first && to - left > 50) context.fillText("run-in", left + 6, kTop + 4);
    }
    drawGrid(context, theme, panel, inner);
    context.save();
    context.beginPath();
    context.rect(inner.x, inner.y, inner.w, inner.h);
    context.clip();
    for (const series of inDrawingOrder(panel.spec.series.filter(visible))) {
      setLine(context, theme, series);
      traceLine(context, series.values, panel.xAt, panel.yAt);
    }
    context.restore();
  }

  function drawGrid(context, theme, panel, inner) {
    context.lineWidth = 1;
    context.textAlign = "right";
    context.textBaseline = "middle";
    const {step, ticks} = linearTicks(panel.range.low, panel.range.high, inner.h / 26);
    for (const v of ticks) {
      const y = Math.round(panel.yAt(v)) + 0.5;
      context.strokeStyle = theme.grid;
      strokeLine(context, inner.x, y, inner.x + inner.w, y);
      context.fillStyle = theme.muted;
      context.fillText(tickText(v, step), inner.x - 7, y);
    }
    context.textAlign = "left";
    context.strokeStyle = theme.grid;
    for (const t of timeTicks(inner.w).ticks) {
      const x = Math.round(panel.xAt(t)) + 0.5;
      strokeLine(context, x, inner.y, x, inner.y + inner.h);
    }
    context.strokeStyle = theme.line;
    context.strokeRect(Math.round(inner.x) + 0.5, inner.y + 0.5, Math.round(inner.w) - 1, inner.h - 1);
  }

  const timeTicks = (width) => linearTicks(view.from, view.to, Math.min(14, width / 75));

  function drawAxis() {
    const {context, width, height} = prepare(axis);
    const theme = colours(), {left, right} = margins(width);
    const {step, ticks} = timeTicks(width - left - right);
    context.strokeStyle = theme.muted;
    context.fillStyle = theme.muted;
    context.textBaseline = "top";
    context.textAlign = "center";
    for (const t of ticks) {
      const x = Math.round(panels[0].xAt(t)) + 0.5;
      strokeLine(context, x, 0, x, 4);
      context.fillText(tickText(t, step), x, 7);
    }
    context.fillText("Time [s]", left + (width - left - right) / 2, height - 18);
  }

  function drawOverlay(panel) {
    const {context, width, height} = prepare(panel.overlay);
    const theme = colours();
    const {left, right} = margins(width);
    if (pointer.dragFrom !== null) {
      const a = panel.xAt(pointer.dragFrom), b = panel.xAt(pointer.time);
      context.fillStyle = theme.select;
      context.fillRect(Math.min(a, b), kTop, Math.abs(b - a), height - kTop - kBottom);
    }
    const reading = pointer.time !== null;
    panel.root.classList.toggle("reading", reading);
    const index = reading ? indexAt(pointer.time) : 0;
    const x = panel.xAt(t0 + index * dt);
    const inside = reading && x >= left - 0.5 && x <= width - right + 0.5;
    if (inside) {
      context.strokeStyle = theme.muted;
      context.lineWidth = 1;
      strokeLine(context, x, kTop, x, height - kBottom);
    }
    const span = panel.range.high - panel.range.low;
    for (const series of panel.spec.series) {
      const value = series.values[index];
      const show = inside && visible(series);
      series.button.classList.toggle("hidden-run", hiddenRuns.has(series.run));
      series.output.textContent = show ? readoutText(value, span) : "";
      if (!show || !Number.isFinite(value)) continue;
      context.beginPath();
      context.arc(x, panel.yAt(value), 3.5, 0, 2 * Math.PI);
      context.fillStyle = theme.of(series.run);
      context.fill();
      context.strokeStyle = theme.panel;
      context.stroke();
    }
  }

  function drawReadout() {
    const zoomed = view.from > t0 || view.to < end;
    reset.disabled = !zoomed;
    const step = (view.to - view.from) / 1000;
    const text = (t) => tickText(t, Math.max(step, 0.01));
    readout.textContent = pointer.time !== null
      ? "t = " + tickText(t0 + dt * indexAt(pointer.time), 0.001) + " s"
      : text(view.from) + " to " + text(view.to) + " s";
  }

  function redraw(what) {
    if (dirty === null) requestAnimationFrame(draw);
    dirty = dirty === "data" ? "data" : what;
  }
  function draw() {
    if (dirty === "data") {
      panels.forEach((panel, i) => drawPanel(panel, i === 0));
      drawAxis();
    }
    dirty = null;
    panels.forEach(drawOverlay);
    drawReadout();
  }

  return {panels, view, pointer, hiddenRuns, redraw, holder, reset, start: t0, end, dt};
}
