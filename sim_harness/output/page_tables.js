// SPDX-License-Identifier: Apache-2.0
// Shared by all pages: tables that a click sorts and a button copies.

// As another program reads it: a plain minus, no thin spaces.
function plainText(cell) {
  return cell.textContent.replace(/\u2212/g, "-").replace(/[\u202f\u00a0]/g, "").replace(/\s+/g, " ").trim();
}

// The first number of "-12.3", "(-12.3 ± 2.1 %)"; NaN for words.
function leadingNumber(text) {
  const match = /^\(?([+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?)(?![\w.-])/i.exec(text);
  return match ? Number(match[1]) : NaN;
}

// Numbers by value, before words; what is empty or "n/a" last, whichever way the rest goes.
function sortRows(body, column, descending) {
  const keyed = [...body.rows].map((row) => {
    const text = plainText(row.cells[column]);
    return {row, text, number: leadingNumber(text), none: text === "" || text === "n/a" || text === "-"};
  });
  const compare = (a, b) => {
    if (a.none || b.none) return a.none - b.none;
    const words = Number.isNaN(a.number) - Number.isNaN(b.number);
    const order = words || (Number.isNaN(a.number) ? a.text.localeCompare(b.text) : a.number - b.number);
    return descending ? -order : order;
  };
  body.append(...keyed.sort(compare).map((k) => k.row));
}

// Rows that are on display, one line each, cells apart by tabs.
function tabSeparated(table) {
  const line = (row) => [...row.cells].map(plainText).join("\t");
  return [...table.rows].filter((row) => !row.hidden).map(line).join("\n") + "\n";
}

async function toClipboard(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = element("textarea", {"aria-hidden": "true", style: "position:fixed;opacity:0"});
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

function makeSortable(table) {
  for (const heading of table.tHead.rows[0].cells) {
    const button = element("button", {type: "button", class: "sort", title: "Sort by this column"});
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener("click", () => {
      const descending = heading.getAttribute("aria-sort") === "ascending";
      for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
      heading.setAttribute("aria-sort", descending ? "descending" : "ascending");
      sortRows(table.tBodies[0], heading.cellIndex, descending);
    });
  }
}

// A line above the table with a button that copies it; other controls of the table go before it.
function makeCopyable(table) {
  const said = element("span", {role: "status"});
  const button = element("button", {type: "button", class: "copy"}, "Copy table");
  button.addEventListener("click", async () => {
    const text = tabSeparated(table);
    const rows = text.split("\n").length - 2;
    said.textContent = await toClipboard(text) ? "copied " + rows + (rows === 1 ? " row" : " rows")
      : "the browser does not let this page copy";
  });
  table.parentElement.before(element("div", {class: "table-tools"}, said, button));
}

for (const table of document.querySelectorAll("table.sortable")) {
  makeSortable(table);
  makeCopyable(table);
}
