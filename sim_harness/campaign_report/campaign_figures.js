// SPDX-License-Identifier: Apache-2.0
// The three figures: values by wind speed, change by wind speed, B against A pair by pair.
(function () {
  const holder = document.getElementById("campaign-panels");
  document.getElementById("figures").hidden = false;
  const quantity = () => report.quantities[campaign.quantity];
  const valueAt = (row) => report.rows[row][quantity().column];
  const usable = (v) => v !== null && Number.isFinite(v);
  const significant = (v, digits) => usable(v) ? grouped(String(Number(v.toPrecision(digits)))) : "n/a";
  const percent = (share) => usable(share) ? (share < 0 ? "\u2212" : "+") + Math.abs(100 * share).toFixed(2) + " %" : "n/a";
  const file = report.columns.findIndex((c) => c.name === "file");
  const told = report.varied.filter((c) => report.columns[c].name !== "table");
  const rowText = (row) => [...(file < 0 ? [] : [report.rows[row][file]]),
    ...told.map((c) => report.columns[c].name + " " + report.rows[row][c])].join(", ");
  const speedText = (v) => grouped(String(v)) + " m/s";

  function spacingOf(speeds) {
    let least = Infinity;
    for (let i = 1; i < speeds.length; ++i) least = Math.min(least, speeds[i] - speeds[i - 1]);
    return Number.isFinite(least) ? least : 2;
  }

  // Controllers beside each other at one speed, so that their marks do not cover each other.
  function values(shown) {
    const view = report.views[campaign.view], lives = view.lives;
    const speeds = [...new Set(lives.flatMap((life) => life.speeds))].sort((a, b) => a - b);
    const aside = (c) => (c - (report.controllers.length - 1) / 2) * 0.14 * spacingOf(speeds);
    const points = report.runs.flatMap(([row, c, speed]) => campaign.inView(row) && usable(valueAt(row))
      ? [{x: speed + aside(c), y: valueAt(row), run: c,
          text: report.controllers[c] + ", " + rowText(row) + ": " + significant(valueAt(row), 5)}] : []);
    const means = lives.map((life, c) => life.speeds.map((speed, i) =>
      ({x: speed + aside(c), y: life.values[campaign.quantity][i], run: c, large: true,
        text: report.controllers[c] + " at " + speedText(speed) + ": " + significant(life.values[campaign.quantity][i], 5)})));
    const all = [...points, ...means.flat()].filter((p) => shown(p.run));
    return {
      title: quantity().name, unit: quantity().unit, xLabel: "Mean wind speed [m/s]",
      x: padded(extentOf(speeds), 0.09), y: padded(extentOf(all.map((p) => p.y)), 0.06),
      points: [...points, ...means.flat()],
      ticks: speeds.length <= 12 ? speeds.map((speed) => ({at: speed, text: String(speed)})) : undefined,
      lines: (line) => means.forEach((m, c) => { if (shown(c)) line(c, m.map((p) => [p.x, p.y])); }),
    };
  }

  // [pairs, a, b, relative, low, high, significant] as a large mark.
  function changeMark(x, name, change, run) {
    if (!change) return [];
    const [pairs, , , relative, low, high, is] = change, has = usable(low) && usable(high);
    return [{x, y: 100 * relative, low: has ? 100 * low : NaN, high: has ? 100 * high : NaN, run, large: true, open: !is,
      text: name + ": " + percent(relative) + (has ? " (" + percent(low) + " \u2026 " + percent(high) + ")" : ", no interval") +
        ", " + pairs + (pairs === 1 ? " pair, " : " pairs, ") + (is ? "significant" : "not significant")}];
  }

  // Every pair, relative to the same mean of A as its change.
  function pairMarks(versus, changes) {
    const meanOf = new Map(versus.speeds.map((speed, i) => [speed, changes[i] && changes[i][1]]));
    return pairsInView(versus).flatMap(([a, b, speed]) => {
      const mean = meanOf.get(speed);
      if (!usable(valueAt(a)) || !usable(valueAt(b)) || !mean) return [];
      const relative = (valueAt(b) - valueAt(a)) / Math.abs(mean);
      return [{x: speed, y: 100 * relative, run: versus.b, text: rowText(a) + ": " + percent(relative)}];
    });
  }

  // Pairs stand with all runs; of a class they are those that are in it.
  function pairsInView(versus) {
    const all = report.views[0].comparisons.find((c) => c.b === versus.b);
    return all.pairs.filter(([a, b]) => campaign.inView(a) && campaign.inView(b));
  }

  function change() {
    const versus = campaign.versus();
    const title = "Change of " + quantity().name;
    const none = {title: versus ? title : "No comparison here", unit: "%", xLabel: "Mean wind speed [m/s]",
      x: {low: 0, high: 1}, y: {low: -1, high: 1}, points: [], lines: () => {}};
    if (!versus) return none;
    const changes = versus.changes[campaign.quantity], spacing = spacingOf(versus.speeds);
    const lifeAt = versus.speeds[versus.speeds.length - 1] + 1.5 * spacing;
    const life = changes[versus.speeds.length];
    const large = [...versus.speeds.flatMap((speed, i) => changeMark(speed, speedText(speed), changes[i], versus.b)),
      ...changeMark(lifeAt, "over a life", life, versus.b)];
    const points = [...pairMarks(versus, changes).map((p) => ({...p, x: p.x - 0.12 * spacing})), ...large];
    const ticks = versus.speeds.map((speed) => ({at: speed, text: String(speed)}));
    return {
      ...none, title, points,
      x: padded({low: versus.speeds[0], high: life ? lifeAt : versus.speeds[versus.speeds.length - 1]}, 0.09),
      y: padded(extentOf([0, ...points.flatMap((p) => [p.y, p.low, p.high])]), 0.06),
      ticks: life ? [...ticks, {at: lifeAt, text: "life"}] : ticks,
      lines: (line) => line(null, [[-1e3, 0], [1e3, 0]], true),
    };
  }

  function scatter() {
    const versus = campaign.versus();
    const [a, b] = versus ? [report.controllers[versus.a], report.controllers[versus.b]] : ["A", "B"];
    const points = !versus ? [] : pairsInView(versus).flatMap(([rowA, rowB]) => {
      const x = valueAt(rowA), y = valueAt(rowB);
      return usable(x) && usable(y) ? [{x, y, run: versus.b,
        text: rowText(rowA) + ": A " + significant(x, 5) + ", B " + significant(y, 5)}] : [];
    });
    const range = padded(extentOf(points.flatMap((p) => [p.x, p.y])), 0.05);
    const far = 50 * (range.high - range.low), ends = [range.low - far, range.high + far];
    return {
      title: quantity().name + ", B: " + b, unit: quantity().unit, xLabel: "A: " + a + " [" + quantity().unit + "]",
      x: range, y: range, points, lines: (line) => line(null, ends.map((v) => [v, v]), true),
    };
  }

  const series = () => report.controllers.map((name, run) => ({name, run}));
  const plots = [makeXYPlot(holder, series(), "every run and each controller's mean", values)];
  if (report.views[0].comparisons.length > 0) {
    plots.push(makeXYPlot(holder, [], "change of the mean with its interval", change));
    plots.push(makeXYPlot(holder, [], "one mark per pair of runs in the same wind", scatter));
  }
  const drawAll = () => plots.forEach((p) => p.draw());
  let last = null;
  campaign.onChange(() => {
    const now = [campaign.quantity, campaign.view, campaign.b].join();
    if (now !== last) plots.forEach((p) => { p.zoom = p.at = null; });
    last = now;
    pointReadout.textContent = "";
    drawAll();
  });
  document.getElementById("reset-zoom").addEventListener("click", () => plots.forEach((p) => p.showAll()));
  new ResizeObserver(drawAll).observe(holder);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
  drawAll();
})();
