// SPDX-License-Identifier: Apache-2.0
// The table of all rows, and the filters.
(function () {
  const kMostChoices = 40;  // of a parameter that gets a filter
  document.getElementById("cases").hidden = false;
  const table = document.getElementById("case-table");
  const filters = document.getElementById("filters");
  const wanted = new Map();  // column: value
  let words = "", everything = false;
  const indexOf = (name) => report.columns.findIndex((c) => c.name === name);

  function columnsShown() {
    if (everything) return report.columns.map((_, i) => i);
    const named = ["table", "case", "file", "status"].map(indexOf).filter((c) => c >= 0);
    const shown = report.quantities.filter((q) => q.shown).map((q) => q.column);
    return [...new Set([...named, ...report.varied, ...[indexOf("controller")].filter((c) => c >= 0), ...shown])];
  }

  const cellText = (value) => value === null ? "" : String(value).replace("-", typeof value === "number" ? "\u2212" : "-");

  function build() {
    const columns = columnsShown();
    const head = element("tr", {}, ...columns.map((c) => element("th", {scope: "col"}, report.columns[c].name)));
    const body = element("tbody", {}, ...report.rows.map((row, i) => {
      const cells = columns.map((c, k) => element(k === 0 ? "th" : "td", k === 0 ? {scope: "row"} : {}, cellText(row[c])));
      const line = element("tr", {}, ...cells);
      line.dataset.row = i;
      return line;
    }));
    table.replaceChildren(element("thead", {}, head), body);
    makeSortable(table);
  }

  function apply() {
    const needle = words.toLowerCase();
    const shown = report.rows.map((row) => [...wanted].every(([c, value]) => String(row[c]) === value) &&
      (needle === "" || row.some((v, c) => !report.columns[c].figure && String(v).toLowerCase().includes(needle))));
    for (const line of table.tBodies[0].rows) line.hidden = !shown[Number(line.dataset.row)];
    count.textContent = shown.filter(Boolean).length + " of " + report.rows.length + " rows";
    campaign.rowShown = (row) => shown[row];
    campaign.changed();
  }

  function addFilter(column) {
    const values = [...new Set(report.rows.map((row) => String(row[column])))];
    if (values.length < 2 || values.length > kMostChoices) return;
    values.sort((a, b) => Number(a) - Number(b) || a.localeCompare(b));
    const choice = element("select", {}, element("option", {value: ""}, "all"),
      ...values.map((v, i) => element("option", {value: String(i)}, v === "" ? "(none)" : v)));
    choice.addEventListener("change", () => {
      if (choice.value === "") wanted.delete(column); else wanted.set(column, values[Number(choice.value)]);
      apply();
    });
    filters.append(element("label", {}, report.columns[column].name, choice));
  }

  const count = element("span", {role: "status"});
  for (const c of new Set([indexOf("status"), ...report.varied, indexOf("controller")])) if (c >= 0) addFilter(c);
  const search = element("input", {type: "search", placeholder: "part of a name"});
  search.addEventListener("input", () => { words = search.value.trim(); apply(); });
  const all = element("button", {type: "button", "aria-pressed": "false", id: "all-columns"}, "All columns");
  all.style.textDecoration = "none";
  all.addEventListener("click", () => {
    everything = !everything;
    all.setAttribute("aria-pressed", String(everything));
    build();
    apply();
  });
  filters.append(element("label", {}, "Words", search), all, count);
  build();
  makeCopyable(table);
  apply();
})();
