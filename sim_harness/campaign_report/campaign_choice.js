// SPDX-License-Identifier: Apache-2.0
// What is on display: the quantity, the class of runs, the controller that is compared.
const campaign = (function () {
  const listeners = [];
  const state = {
    quantity: 0, view: 0, b: null,  // places in report.quantities, .views, .controllers
    rowShown: () => true,           // the filters, by row
    onChange: (listener) => listeners.push(listener),
    changed: () => listeners.forEach((listener) => listener()),
    // The comparison on display; undefined without one.
    versus: () => report.views[state.view].comparisons.find((c) => c.b === state.b),
    // Is the row of the class on display, and let through by the filters?
    inView: (row) => {
      const {column, value} = report.views[state.view];
      return (column === null || report.rows[row][column] === value) && state.rowShown(row);
    },
  };
  const quantity = document.getElementById("quantity");
  const view = document.getElementById("view");
  const against = document.getElementById("against");

  function fillQuantities() {
    const group = (label, shown) => {
      const options = report.quantities.flatMap((q, i) => q.shown === shown
        ? [element("option", {value: i}, q.name + " [" + q.unit + "]")] : []);
      if (options.length > 0) quantity.append(element("optgroup", {label}, ...options));
    };
    group("In the tables", true);
    group("All others", false);
    const first = report.quantities.findIndex((q) => q.name === "TwrBsMyt_del4" && q.shown);
    state.quantity = first >= 0 ? first : Math.max(0, report.quantities.findIndex((q) => q.shown));
    quantity.value = state.quantity;
  }

  function fillOthers() {
    report.views.forEach((v, i) => view.append(element("option", {value: i}, v.name)));
    view.parentElement.hidden = report.views.length < 2;
    const others = report.views[0].comparisons.map((c) => c.b);
    for (const b of others) against.append(element("option", {value: b}, report.controllers[b]));
    against.parentElement.hidden = others.length < 2;
    if (others.length > 0) state.b = others[0];
  }

  function choose(which, value) {
    state[which] = Number(value);
    quantity.value = state.quantity;
    state.changed();
  }

  // The names of quantities in the tables put them into the figures.
  function makePicks() {
    const places = new Map(report.quantities.map((q, i) => [q.name, i]));
    for (const heading of document.querySelectorAll(".comparison tbody th")) {
      const place = places.get(heading.textContent);
      if (place === undefined) continue;
      const button = element("button", {type: "button", class: "pick", title: "Show in the figures"});
      button.append(...heading.childNodes);
      heading.append(button);
      button.addEventListener("click", () => choose("quantity", place));
    }
  }

  function showTables() {
    for (const article of document.querySelectorAll(".comparison"))
      article.hidden = Number(article.dataset.view) !== state.view || Number(article.dataset.b) !== state.b;
    const name = report.quantities[state.quantity].name;
    for (const pick of document.querySelectorAll(".pick"))
      pick.setAttribute("aria-current", String(pick.textContent === name));
  }

  fillQuantities();
  fillOthers();
  makePicks();
  quantity.addEventListener("change", () => choose("quantity", quantity.value));
  view.addEventListener("change", () => choose("view", view.value));
  against.addEventListener("change", () => choose("b", against.value));
  state.onChange(showTables);
  showTables();
  document.getElementById("choice").hidden = false;
  return state;
})();
