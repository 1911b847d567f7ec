// SPDX-License-Identifier: Apache-2.0
// Power spectral densities in log-log axes with a frequency readout.
(function () {
  if (report.spectra.length === 0) return;
  const kTop = 6, kBottom = 40, kMostDecades = 8;
  document.getElementById("spectra").hidden = false;
  const holder = document.getElementById("spectrum-panels");
  const panels = report.spectra.map((spec) => {
    const panel = makePanel(holder, spec, "power spectral density over frequency", () => draw(panel));
    panel.frequency = null;
    return panel;
  });

  function logRange(values) {
    const usable = values.filter((v) => v > 0);
    if (usable.length === 0) return {low: 0, high: 1};
    const exponents = usable.map(Math.log10);
    let low = Infinity, high = -Infinity;
    for (const e of exponents) {
      low = Math.min(low, e);
      high = Math.max(high, e);
    }
    return {low, high: Math.max(high, low + 0.1)};
  }

  function ranges(spec) {
    const shown = spec.series.filter((s) => s.shown);
    const x = logRange(spec.series.flatMap((s) => s.f));
    const y = logRange((shown.length ? shown : spec.series).flatMap((s) => s.s));
    const low = Math.max(y.low, y.high - kMostDecades);
    const pad = 0.05 * (y.high - low) + 0.05;
    return {x, y: {low: low - pad, high: y.high + pad}};
  }

  // Decades with a text, the digits between them as faint lines.
  function logTicks({low, high}, onTick) {
    for (let decade = Math.floor(low); decade <= high; ++decade) {
      for (let digit = 1; digit < 10; ++digit) {
        const at = decade + Math.log10(digit);
        if (at >= low - 1e-9 && at <= high + 1e-9) onTick(at, digit === 1 ? decade : null);
      }
    }
  }

  function drawAxes(context, theme, panel, inner, range) {
    const crowded = range.y.high - range.y.low > 4;
    context.textBaseline = "middle";
    context.textAlign = "right";
    logTicks(range.y, (at, decade) => {
      if (decade === null && crowded) return;
      const y = Math.round(panel.yAt(at)) + 0.5;
      context.strokeStyle = theme.grid;
      context.globalAlpha = decade === null ? 0.55 : 1;
      strokeLine(context, inner.x, y, inner.x + inner.w, y);
      context.globalAlpha = 1;
      context.fillStyle = theme.muted;
      if (decade !== null) context.fillText(powerText(decade), inner.x - 7, y);
    });
    context.textBaseline = "top";
    context.textAlign = "center";
    logTicks(range.x, (at, decade) => {
      const x = Math.round(panel.xAt(at)) + 0.5;
      context.strokeStyle = theme.grid;
      context.globalAlpha = decade === null ? 0.55 : 1;
      strokeLine(context, x, inner.y, x, inner.y + inner.h);
      context.globalAlpha = 1;
      context.fillStyle = theme.muted;
      if (decade !== null) context.fillText(powerText(decade), x, inner.y + inner.h + 6);
    });
    context.fillText("Frequency [Hz]", inner.x + inner.w / 2, inner.y + inner.h + 22);
    context.strokeStyle = theme.line;
    context.strokeRect(Math.round(inner.x) + 0.5, inner.y + 0.5, Math.round(inner.w) - 1, inner.h - 1);
  }

  function draw(panel) {
    const {context, width, height} = prepare(panel.base);
    const theme = colours(), {left, right} = margins(width), range = ranges(panel.spec);
    const inner = {x: left, y: kTop, w: width - left - right, h: height - kTop - kBottom};
    panel.inner = inner;
    panel.xRange = range.x;
    panel.xAt = (e) => inner.x + (e - range.x.low) / (range.x.high - range.x.low) * inner.w;
    panel.yAt = (e) => inner.y + (range.y.high - e) / (range.y.high - range.y.low) * inner.h;
    drawAxes(context, theme, panel, inner, range);
    context.save();
    context.beginPath();
    context.rect(inner.x, inner.y, inner.w, inner.h);
    context.clip();
    for (const series of inDrawingOrder(panel.spec.series.filter((s) => s.shown))) {
      setLine(context, theme, series);
      context.beginPath();
      series.f.forEach((f, i) => {
        if (f > 0 && series.s[i] > 0) context.lineTo(panel.xAt(Math.log10(f)), panel.yAt(Math.log10(series.s[i])));
      });
      context.stroke();
    }
    context.restore();
    drawOverlay(panel);
  }

  function nearest(series, frequency) {
    let best = 0;
    const distance = (f) => Math.abs(Math.log(f / frequency));
    series.f.forEach((f, i) => {
      if (f > 0 && !(distance(series.f[best]) <= distance(f))) best = i;
    });
    return best;
  }

  function drawOverlay(panel) {
    const {context} = prepare(panel.overlay);
    const theme = colours(), reading = panel.frequency !== null;
    panel.root.classList.toggle("reading", reading);
    if (reading) {
      const x = panel.xAt(Math.log10(panel.frequency));
      context.strokeStyle = theme.muted;
      strokeLine(context, x, panel.inner.y, x, panel.inner.y + panel.inner.h);
      const right = x > panel.inner.x + panel.inner.w / 2;
      context.textAlign = right ? "right" : "left";
      context.textBaseline = "top";
      context.fillStyle = theme.ink;
      context.fillText(panel.frequency.toPrecision(3) + " Hz", x + (right ? -6 : 6), panel.inner.y + 6);
    }
    for (const series of panel.spec.series) {
      const show = reading && series.shown && series.f.length > 0;
      const at = show ? nearest(series, panel.frequency) : 0;
      series.output.textContent = show ? series.s[at].toPrecision(3).replace(/-/g, "\u2212") : "";
      if (!show || !(series.s[at] > 0)) continue;
      context.beginPath();
      context.arc(panel.xAt(Math.log10(series.f[at])), panel.yAt(Math.log10(series.s[at])), 3.5, 0, 2 * Math.PI);
      context.fillStyle = theme.of(series.run);
      context.fill();
    }
  }

  function moveTo(panel, exponent) {
    const {low, high} = panel.xRange;
    panel.frequency = Math.pow(10, Math.min(high, Math.max(low, exponent)));
    drawOverlay(panel);
  }

  for (const panel of panels) {
    panel.plot.addEventListener("pointermove", (event) => {
      const x = event.clientX - panel.plot.getBoundingClientRect().left;
      const {low, high} = panel.xRange;
      moveTo(panel, low + (x - panel.inner.x) / panel.inner.w * (high - low));
    });
    panel.plot.addEventListener("pointerleave", () => {
      panel.frequency = null;
      drawOverlay(panel);
    });
    panel.plot.addEventListener("keydown", (event) => {
      const by = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!by) return;
      event.preventDefault();
      const {low, high} = panel.xRange;
      const now = panel.frequency === null ? (low + high) / 2 : Math.log10(panel.frequency);
      moveTo(panel, now + by * (high - low) / 100);
    });
  }
  const drawAll = () => panels.forEach(draw);
  new ResizeObserver(drawAll).observe(holder);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
  drawAll();
})();
