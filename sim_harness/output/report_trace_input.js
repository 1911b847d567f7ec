// SPDX-License-Identifier: Apache-2.0
// Time traces, the hand: zoom, move, crosshair, keys, run buttons.
(function () {
  if (report.traces.length === 0) return;
  const {panels, view, pointer, hiddenRuns, redraw, holder, reset, start: t0, end, dt} = makeTraceView();

  function show(from, to) {
    const span = Math.min(Math.max(to - from, 20 * dt), end - t0);
    const start = Math.min(Math.max(from, t0), end - span);
    view.from = start;
    view.to = start + span;
    redraw("data");
  }
  const showAll = () => show(t0, end);
  const zoomBy = (factor) => {
    const centre = pointer.time === null ? (view.from + view.to) / 2 : pointer.time;
    show(centre - (centre - view.from) * factor, centre + (view.to - centre) * factor);
  };

  function timeAt(panel, event) {
    const box = panel.plot.getBoundingClientRect(), {left, right} = margins(box.width);
    const fraction = (event.clientX - box.left - left) / (box.width - left - right);
    return view.from + Math.min(1, Math.max(0, fraction)) * (view.to - view.from);
  }

  function onMove(panel, event) {
    if (pointer.moving !== null) {
      const width = panel.plot.getBoundingClientRect().width, {left, right} = margins(width);
      const perPixel = (view.to - view.from) / (width - left - right);
      const shift = (pointer.moving - event.clientX) * perPixel;
      pointer.moving = event.clientX;
      show(view.from + shift, view.to + shift);
      return;
    }
    pointer.time = timeAt(panel, event);
    redraw("overlay");
  }

  function onUp() {
    const {dragFrom, time} = pointer;
    pointer.dragFrom = pointer.moving = null;
    if (dragFrom !== null && Math.abs(time - dragFrom) > (view.to - view.from) * 0.008) {
      show(Math.min(dragFrom, time), Math.max(dragFrom, time));
    }
    redraw("overlay");
  }

  function onKey(event) {
    const step = Math.max(dt, (view.to - view.from) / 200);
    const move = (by) => {
      pointer.time = (pointer.time === null ? (view.from + view.to) / 2 : pointer.time) + by;
      pointer.time = Math.min(view.to, Math.max(view.from, pointer.time));
      redraw("overlay");
    };
    const actions = {
      ArrowLeft: () => move(-step), ArrowRight: () => move(step),
      "+": () => zoomBy(0.5), "=": () => zoomBy(0.5), "-": () => zoomBy(2), Escape: showAll, "0": showAll,
    };
    if (!(event.key in actions) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    actions[event.key]();
  }

  for (const panel of panels) {
    panel.plot.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      if (event.pointerType === "mouse") panel.plot.setPointerCapture(event.pointerId);
      pointer.time = timeAt(panel, event);
      if (event.shiftKey) pointer.moving = event.clientX; else pointer.dragFrom = pointer.time;
      redraw("overlay");
    });
    panel.plot.addEventListener("pointermove", (event) => onMove(panel, event));
    panel.plot.addEventListener("pointerup", onUp);
    panel.plot.addEventListener("pointercancel", () => {
      pointer.dragFrom = pointer.moving = null;
      redraw("overlay");
    });
    panel.plot.addEventListener("pointerleave", (event) => {
      if (event.pointerType !== "mouse" || pointer.dragFrom !== null) return;
      pointer.time = null;
      redraw("overlay");
    });
    panel.plot.addEventListener("dblclick", showAll);
    panel.plot.addEventListener("keydown", onKey);
  }
  reset.addEventListener("click", showAll);

  report.runs.forEach((name, run) => {
    const button = toggleButton(name, run, false, (shown) => {
      if (shown) hiddenRuns.delete(run); else hiddenRuns.add(run);
      redraw("data");
    });
    document.getElementById("run-toggles").append(button);
  });
  new ResizeObserver(() => redraw("data")).observe(holder);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => redraw("data"));
  redraw("data");
})();
