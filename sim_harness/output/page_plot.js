// SPDX-License-Identifier: Apache-2.0
// Shared by both kinds of plots: data, colours, ticks, number texts, canvases.
const report = JSON.parse(document.getElementById("report-data").textContent);
const kRunColours = 6;

function colours() {
  const style = getComputedStyle(document.documentElement);
  const get = (name) => style.getPropertyValue(name).trim();
  return {
    ink: get("--ink"), muted: get("--muted"), grid: get("--grid"), line: get("--line"),
    panel: get("--panel"), select: get("--select"), runIn: get("--run-in"),
    of: (run) => get(run < 0 ? "--common" : "--run-" + (run % kRunColours)),
  };
}

function colourVariable(run) {
  return run < 0 ? "var(--common)" : "var(--run-" + (run % kRunColours) + ")";
}

// The second series of a run in one panel is wide and pale and lies behind the others, so that
// colour keeps its meaning.
function markSecondSeries(series) {
  const seen = new Set();
  for (const one of series) {
    one.second = seen.has(one.run);
    seen.add(one.run);
  }
}

function inDrawingOrder(series) {
  return [...series.filter((s) => s.second), ...series.filter((s) => !s.second)];
}

function setLine(context, theme, series) {
  context.strokeStyle = theme.of(series.run);
  context.globalAlpha = series.second ? 0.55 : 1;
  context.lineWidth = series.second ? 3 : 1.35;
  context.lineJoin = "round";
}

function element(tag, attributes, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

function toggleButton(name, run, second, onToggle) {
  const swatch = element("span", {class: second ? "swatch second" : "swatch",
    style: "border-color:" + colourVariable(run)});
  const button = element("button", {type: "button", "aria-pressed": "true"}, swatch, name);
  button.addEventListener("click", () => {
    const shown = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(shown));
    onToggle(shown);
  });
  return button;
}

function niceStep(span, count) {
  const raw = span / Math.max(count, 1);
  const decade = Math.pow(10, Math.floor(Math.log10(raw)));
  const factor = [1, 2, 5, 10].find((f) => f * decade >= raw * 0.999);
  return factor * decade;
}

function linearTicks(low, high, count) {
  const step = niceStep(high - low, count);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + step * 1e-9; ++k) ticks.push(k * step);
  return {step, ticks};
}

function grouped(text) {
  const [whole, fraction] = text.split(".");
  const digits = whole.replace("-", "");
  const body = digits.length > 4 ? digits.replace(/\B(?=(\d{3})+$)/g, "\u202f") : digits;
  return (whole.startsWith("-") ? "\u2212" : "") + body + (fraction ? "." + fraction : "");
}

function tickText(value, step) {
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  if (decimals > 4) return value === 0 ? "0" : value.toExponential(1).replace("-", "\u2212");
  const text = value.toFixed(decimals);
  return grouped(Number(text) === 0 ? text.replace("-", "") : text);
}

const kSuperscripts = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
function powerText(exponent) {
  const digits = String(Math.abs(exponent)).replace(/\d/g, (d) => kSuperscripts[d]);
  return "10" + (exponent < 0 ? "\u207b" : "") + digits;
}

// Four digits of the range that is on display.
function readoutText(value, range) {
  if (!Number.isFinite(value)) return "n/a";
  const decimals = Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(range || 1))));
  return tickText(value, Math.pow(10, -decimals));
}

// Size in CSS pixels; the backing store follows the device's resolution.
function prepare(canvas) {
  const box = canvas.getBoundingClientRect();
  const ratio = window.devicePixelRatio || 1;
  const width = Math.max(1, Math.round(box.width * ratio));
  const height = Math.max(1, Math.round(box.height * ratio));
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, box.width, box.height);
  context.font = "12px " + getComputedStyle(document.body).fontFamily;
  return {context, width: box.width, height: box.height};
}

function margins(width) {
  return {left: width < 560 ? 52 : 66, right: 10};
}

function strokeLine(context, x1, y1, x2, y2) {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}

// Panel with heading, legend and two canvases: data below, crosshair above.
function makePanel(parent, spec, description, onToggle) {
  const heading = element("h3", {}, spec.title + " ", element("small", {}, "[" + spec.unit + "]"));
  const legend = element("div", {class: "legend", role: "group", "aria-label": "Series of " + spec.title});
  const base = element("canvas", {"aria-hidden": "true"});
  const overlay = element("canvas", {"aria-hidden": "true"});
  const names = spec.series.map((s) => s.name).join(", ");
  const plot = element("div", {class: "plot", tabindex: "0", role: "img",
    "aria-label": spec.title + " [" + spec.unit + "] " + description + ": " + names}, base, overlay);
  const root = element("div", {class: "panel"},
    element("div", {class: "panel-head"}, heading, legend), plot);
  markSecondSeries(spec.series);
  for (const series of spec.series) {
    series.shown = true;
    series.button = toggleButton(series.name, series.run, series.second, (shown) => {
      series.shown = shown;
      onToggle();
    });
    series.output = element("output", {});
    series.button.append(series.output);
    legend.append(series.button);
  }
  parent.append(root);
  return {root, plot, base, overlay, spec};
}
