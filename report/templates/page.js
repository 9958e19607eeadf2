"use strict";
(() => {
  const value = (row, column, isNumber) => {
    const cell = row.cells[column];
    if ("value" in cell.dataset) return Number(cell.dataset.value);
    const text = cell.textContent.trim();
    if (!isNumber) return text;
    const number = parseFloat(text.replaceAll(",", ""));
    return Number.isNaN(number) ? -Infinity : number;
  };

  const compare = (a, b) =>
    typeof a === "number" ? (a === b ? 0 : a - b) : a.localeCompare(b, "en", { numeric: true });

  const sortBy = (table, header, column) => {
    const sign = header.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    header.setAttribute("aria-sort", sign === 1 ? "ascending" : "descending");
    const isNumber = header.classList.contains("number");
    const rows = Array.from(table.tBodies[0].rows);
    rows.sort((a, b) => sign * compare(value(a, column, isNumber), value(b, column, isNumber)));
    table.tBodies[0].append(...rows);
  };

  const makeSortable = (table) => {
    Array.from(table.tHead.rows[0].cells).forEach((header, column) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = header.textContent;
      button.addEventListener("click", () => sortBy(table, header, column));
      header.replaceChildren(button);
    });
  };

  const makeFilter = (table, form, shown) => {
    const rows = Array.from(table.tBodies[0].rows);
    const texts = new Map(rows.map((row) => [row, row.textContent.toLowerCase()]));
    const filter = () => {
      const words = form.elements.text.value.toLowerCase().split(/\s+/).filter(Boolean);
      const scope = form.elements.scope.value;
      const input = form.elements.input.value;
      let count = 0;
      for (const row of rows) {
        row.hidden = !(words.every((word) => texts.get(row).includes(word)) &&
          (!scope || row.dataset.scope === scope) && (!input || row.dataset.input === input));
        count += row.hidden ? 0 : 1;
      }
      shown.textContent = `${count} of ${rows.length} rows`;
    };
    form.addEventListener("input", filter);
    form.addEventListener("submit", (event) => event.preventDefault());
    form.hidden = false;
    filter();
  };

  for (const table of document.querySelectorAll("table")) {
    if (table.tHead && table.tBodies.length) makeSortable(table);
  }
  makeFilter(document.getElementById("timings"), document.getElementById("filters"),
    document.getElementById("shown"));
})();
