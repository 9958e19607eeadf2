"use strict";
(() => {
  // Switches of the operations: the attribute of a row, its words, and what is chosen at first.
  const SWITCHES = [["isa", "ISA", "all"], ["threads", "Threads", "1"], ["options", "Border", ""],
    ["scope", "Scope", "end to end"], ["image", "Image", ""]];
  const choice = {};

  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  const three = (value) => value.toLocaleString("en", value < 9.995 ? { minimumFractionDigits: 2, maximumFractionDigits: 2 }
    : value < 99.95 ? { minimumFractionDigits: 1, maximumFractionDigits: 1 } : { maximumFractionDigits: 0 });
  const duration = (ns) => {
    for (const [unit, scale] of [["s", 1e9], ["ms", 1e6], ["µs", 1e3]]) {
      if (ns >= 0.9999 * scale) return `${three(ns / scale)} ${unit}`;
    }
    return `${three(ns)} ns`;
  };
  const isPower = (value) => Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-6;

  // Whiskers of the points' intervals.
  const whiskers = {
    id: "whiskers",
    beforeDatasetsDraw(chart) {
      const { ctx, data, options } = chart;
      const alongX = options.indexAxis === "y";
      data.datasets.forEach((dataset, index) => {
        if (!chart.isDatasetVisible(index)) return;
        const axis = alongX ? chart.scales.x : chart.scales.y;
        ctx.strokeStyle = dataset.borderColor;
        ctx.lineWidth = 2;
        chart.getDatasetMeta(index).data.forEach((point, place) => {
          const raw = dataset.data[place];
          const [low, high] = [axis.getPixelForValue(raw.low), axis.getPixelForValue(raw.high)];
          ctx.beginPath();
          ctx.moveTo(alongX ? low : point.x, alongX ? point.y : low);
          ctx.lineTo(alongX ? high : point.x, alongX ? point.y : high);
          ctx.stroke();
        });
      });
    },
  };

  const base = () => ({
    responsive: true, maintainAspectRatio: false, animation: false, color: colour("ink"),
    plugins: {
      legend: { position: "top", align: "start", labels: { usePointStyle: true, boxWidth: 12, boxHeight: 7, padding: 8, color: colour("ink") } },
      tooltip: { displayColors: false },
    },
  });
  const axis = (text, more) => ({
    title: { display: Boolean(text), text, color: colour("muted") }, ...more,
    grid: { color: colour("line"), drawBorder: false },
    ticks: { color: colour("muted"), ...(more.ticks || {}) },
  });
  const logarithmic = (text, words) => axis(text, {
    type: "logarithmic", ticks: { autoSkip: false, maxRotation: 0, callback: (value) => (isPower(value) ? words(value) : null) },
  });
  const redraw = (canvas, settings) => {
    Chart.getChart(canvas)?.destroy();
    return new Chart(canvas, { ...settings, plugins: [whiskers] });
  };

  // ---- One operation ----
  const STYLES = { o: "circle", s: "rect", "^": "triangle", v: "triangle", X: "crossRot", D: "rectRot", d: "rectRot", "|": "line" };
  const nameOf = ({ technique, isa, threads }) => [technique, isa === "native" || technique === "reference" ? "" : isa,
    threads === "1" ? "" : `${threads} threads`].filter(Boolean).join(" · ");

  const pointOf = (row) => ({ x: Number(row.dataset.ns), y: nameOf(row.dataset), low: Number(row.dataset.ns),
    high: Number(row.dataset.high), speedup: row.dataset.speedup });

  const drawOperation = (section) => {
    const rows = Array.from(section.table.tBodies[0].rows).filter((row) => !row.hidden)
      .sort((a, b) => a.dataset.ns - b.dataset.ns);
    const labels = [...new Set(rows.map((row) => nameOf(row.dataset)))];
    const datasets = FAMILIES.map((family, index) => ({
      label: family.words, borderColor: family.colour, borderWidth: family.marker === "X" ? 3 : 2,
      backgroundColor: index === 0 || family.marker === "d" ? colour("card") : family.colour,
      pointStyle: STYLES[family.marker], rotation: family.marker === "v" ? 180 : family.marker === "|" ? 90 : 0,
      radius: 6, hoverRadius: 9, hitRadius: 6,
      data: rows.filter((row) => Number(row.dataset.family) === index).map(pointOf),
    })).filter((dataset) => dataset.data.length);
    const wide = section.figure.clientWidth || 600;
    const options = base();
    options.indexAxis = "y";
    options.interaction = { mode: "nearest", axis: "y", intersect: false };
    options.scales = {
      x: logarithmic("time of a call (logarithmic)", (ns) => (wide < 420 && Math.round(Math.log10(ns)) % 2 === 0 ? null
        : duration(ns).replace(/\.0+ /, " "))),
      y: axis("", { type: "category", labels, offset: true, ticks: { autoSkip: false, color: colour("ink") } }),
    };
    options.plugins.tooltip.callbacks = {
      title: (items) => items[0].raw.y,
      label: ({ raw }) => [duration(raw.x), `up to ${duration(raw.high)}`,
        ...(raw.speedup ? [`${raw.speedup} over plain C++`] : [])],
    };
    options.plugins.legend.labels.font = { size: 11 };
    options.scales.y.ticks.font = { size: wide < 360 ? 8 : wide < 420 ? 9 : 11 };
    section.canvas.parentElement.style.height = `${90 + 24 * Math.max(labels.length, 3)}px`;
    redraw(section.canvas, { type: "scatter", data: { datasets }, options });
  };

  // Peers and references belong to every ISA, a copy to every border.
  const isExempt = ({ dataset }, key) => (key === "isa" && (dataset.isa === "native" || dataset.technique === "reference")) ||
    (key === "options" && FAMILIES[dataset.family].marker === "|");

  const show = (section) => {
    const words = section.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const rows = Array.from(section.table.tBodies[0].rows);
    for (const row of rows) {
      const wanted = SWITCHES.every(([key]) => !section.values[key] || section.current[key] === "all" ||
        isExempt(row, key) || row.dataset[key] === section.current[key]);
      const text = row.textContent.toLowerCase();
      row.hidden = !(wanted && words.every((word) => text.includes(word)));
    }
    const count = rows.filter((row) => !row.hidden).length;
    section.output.textContent = `${count} of ${rows.length} rows`;
    drawOperation(section);
  };

  const addSwitch = (section, [key, words]) => {
    const fieldset = document.createElement("fieldset");
    const legend = document.createElement("legend");
    legend.textContent = words;
    fieldset.append(legend);
    for (const value of section.values[key]) {
      const input = document.createElement("input");
      const label = document.createElement("label");
      Object.assign(input, { type: "radio", name: key, value, id: `${section.name}-${key}-${value.replace(/\W+/g, "-")}` });
      label.htmlFor = input.id;
      label.textContent = value;
      input.checked = section.current[key] === value;
      input.addEventListener("change", () => {
        section.current[key] = choice[key] = value;
        show(section);
      });
      fieldset.append(input, label);
    }
    section.form.append(fieldset);
  };

  const compare = (a, b) => (typeof a === "number" ? a - b : a.localeCompare(b, "en", { numeric: true }));
  const sortBy = (table, header, column) => {
    const sign = header.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    header.setAttribute("aria-sort", sign === 1 ? "ascending" : "descending");
    const value = (row) => ("v" in row.cells[column].dataset ? Number(row.cells[column].dataset.v)
      : row.cells[column].textContent);
    table.tBodies[0].append(...Array.from(table.tBodies[0].rows).sort((a, b) => sign * compare(value(a), value(b))));
  };
  const makeSortable = (table) => Array.from(table.tHead.rows[0].cells).forEach((header, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = header.textContent;
    button.addEventListener("click", () => sortBy(table, header, column));
    header.replaceChildren(button);
  });

  const copyCsv = async (section) => {
    const quoted = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    const rows = [section.table.tHead.rows[0], ...Array.from(section.table.tBodies[0].rows).filter((row) => !row.hidden)];
    const text = rows.map((row) => Array.from(row.cells, (cell) => quoted(cell.textContent)).join(",")).join("\n") + "\n";
    const button = section.article.querySelector(".copy");
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "Copied";
    } catch {
      button.textContent = "The browser does not allow it";
    }
    setTimeout(() => { button.textContent = "Copy as CSV"; }, 2000);
  };

  const open = (article) => {
    const find = (selector) => article.querySelector(selector);
    const section = { article, name: article.id, table: find("table.rows"), form: find(".switches"), figure: find(".plot"),
      canvas: find("canvas"), search: find("input[type=search]"), output: find("output"), values: {}, current: {} };
    const rows = Array.from(section.table.tBodies[0].rows);
    for (const [key, , first] of SWITCHES) {
      const own = rows.filter((row) => !isExempt(row, key)).map((row) => row.dataset[key]);
      const found = [...new Set(own)].sort(key === "isa" ? (a, b) => ISAS.indexOf(a) - ISAS.indexOf(b) : compare);
      if (found.length < 2) continue;
      section.values[key] = key === "isa" || key === "threads" ? ["all", ...found] : found;
      const wanted = choice[key] ?? first;
      section.current[key] = section.values[key].includes(wanted) ? wanted
        : section.values[key].includes(first) ? first : section.values[key][0];
    }
    return section;
  };

  const sections = new Map();
  const choose = (article) => {
    for (const other of document.querySelectorAll(".operation")) other.classList.toggle("is-chosen", other === article);
    for (const link of document.querySelectorAll(".list a")) {
      if (link.hash === `#${article.id}`) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    }
    let section = sections.get(article.id);
    if (!section) {
      section = open(article);
      sections.set(article.id, section);
      makeSortable(section.table);
      section.search.addEventListener("input", () => show(section));
      section.article.querySelector(".copy").addEventListener("click", () => copyCsv(section));
      for (const part of article.querySelectorAll(".switches, .plot, .tools")) part.hidden = false;
    } else {
      Object.assign(section.current, open(article).current);
    }
    section.form.replaceChildren();
    SWITCHES.filter(([key]) => section.values[key]).forEach((one) => addSwitch(section, one));
    section.form.hidden = !section.form.children.length;
    show(section);
  };

  // ---- Sweeps ----
  const PALETTE = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#8b929b"];
  const drawSweep = (part) => {
    const { x, curves, places } = JSON.parse(part.dataset.chart);
    const named = places.some((place) => typeof place === "string");
    const spread = !named && places[0] > 0 && places.at(-1) / places[0] >= 8;
    const options = base();
    options.interaction = { mode: "nearest", intersect: false };
    options.scales = {
      x: named ? axis(x, { type: "category", labels: places }) : axis(x, { type: spread ? "logarithmic" : "linear",
        ...(spread ? { min: places[0] / 1.2, max: places.at(-1) * 1.2 } : {}),
        afterBuildTicks: (scale) => { if (places.length < 14) scale.ticks = places.map((value) => ({ value })); },
        ticks: { callback: (value) => String(value) } }),
      y: logarithmic("ns per pixel", (value) => String(value)),
    };
    options.scales.y.ticks.callback = (value) => (/^0?\.?0*[125]0*$/.test(String(value)) ? String(value) : null);
    options.plugins.tooltip.callbacks = { title: (items) => `${items[0].dataset.label}, ${items[0].label}`,
      label: ({ raw }) => `${raw.y} ns per pixel (up to ${raw.high})` };
    const datasets = curves.map(({ label, points }, index) => ({ label, borderColor: PALETTE[index % PALETTE.length],
      backgroundColor: PALETTE[index % PALETTE.length], borderWidth: 2, radius: 3.5, showLine: true,
      borderDash: index < PALETTE.length ? [] : [5, 3],
      data: points.map(([place, y, high]) => ({ x: place, y, low: y, high })) }));
    part.hidden = false;
    redraw(part.querySelector("canvas"), { type: "line", data: { datasets }, options });
  };

  const drawOpenSweeps = () => document.querySelectorAll("#sweeps[open] .sweep[open] [data-chart]").forEach(drawSweep);
  for (const part of document.querySelectorAll("#sweeps, .sweep")) part.addEventListener("toggle", drawOpenSweeps);

  // ---- The address keeps the choice ----
  const follow = () => {
    const target = document.getElementById(location.hash.slice(1));
    if (target?.matches("details")) target.open = true;
    const article = target?.matches(".operation") ? target
      : document.querySelector(".is-chosen") ?? document.querySelector(".operation");
    if (!article) return;
    choose(article);
    if (article === target) target.scrollIntoView();
  };
  window.addEventListener("hashchange", follow);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { follow(); drawOpenSweeps(); });
  follow();
})();
