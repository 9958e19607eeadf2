"use strict";

const maxPixels = 50e6;
const keys = {thin: ["skeleton"], edges: ["edges"], holes: ["objects", "holes"], labels: [],
              graph: ["lines", "ends", "junctions", "closed lines", "isolated pixels"]};
const element = id => document.getElementById(id);
const form = element("settings"), status = element("status"), field = form.elements;
let file = null, size = null, before = null, after = null;  // the picture, its bitmaps, and the result
let view = {x: 0, y: 0, scale: 1};                          // the centre, in pixels of the picture, and the zoom
let worker, nextId = 0;
const waiting = new Map();  // what is called with the answers of the worker

function startWorker() {
  const source = new Blob([element("worker").textContent], {type: "text/javascript"});
  worker = new Worker(URL.createObjectURL(source));
  worker.onmessage = ({data}) => answer(data);
  worker.onerror = ({message}) => waiting.forEach((_, id) => answer({id, error: message, isFatal: true}));
}

function answer({id, value, error, isFatal}) {
  const [resolve, reject] = waiting.get(id);
  waiting.delete(id);
  if (error === undefined) return resolve(value);
  reject(new Error(isFatal ? `the browser stopped the work (${error}); choose the picture again` : error));
  if (!isFatal) return;
  worker.terminate();
  startWorker();
  size = null;
}

const ask = (kind, request) => new Promise((...settle) => {
  waiting.set(++nextId, settle);
  worker.postMessage({id: nextId, kind, request});
});

const say = (text, kind = "") => Object.assign(status, {textContent: text, className: kind});

/** The size, from the header, before all pixels are decoded. */
function measured(blob) {
  const probe = new Image();
  return new Promise((resolve, reject) => {
    probe.onload = () => resolve([probe.naturalWidth, probe.naturalHeight]);
    probe.onerror = () => reject(new Error("expected a picture that this browser reads, such as PNG or JPEG"));
    probe.src = URL.createObjectURL(blob);
  }).finally(() => URL.revokeObjectURL(probe.src));
}

async function read(blob) {
  say(`Reading ${blob.name} …`);
  try {
    const [width, height] = await measured(blob);
    if (width * height > maxPixels) {
      throw new Error(`expected at most 50 megapixels, got ${width} x ${height} pixels`);
    }
    const opened = await ask("open", {file: blob, channel: field.channel.value});
    if (file !== blob) view.scale = 0;
    [file, size, before, after] = [blob, opened, opened.bitmaps, null];
    element("name").textContent = `${file.name}, ${size.width} x ${size.height} pixels`;
    document.body.classList.remove("empty");
    element("result").style.setProperty("--shape", `${size.width} / ${size.height}`);
    await refresh();
  } catch (error) {
    file = size = null;
    document.body.classList.add("empty");
    say(`${blob.name}: ${error.message}`, "failed");
  }
}

const readFirst = (files, missing) => files.length > 0 ? read(files[0]) : say(missing, "failed");

/** Something to try: a plate with holes, a ring and letters. */
function sample() {
  const canvas = new OffscreenCanvas(720, 480), draw = canvas.getContext("2d");
  const circle = (x, y, r) => `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
  const holes = [[110, 95, 16], [260, 95, 16], [110, 175, 16], [260, 175, 16], [185, 135, 34]];
  draw.fillStyle = "#eee";
  draw.fillRect(0, 0, 720, 480);
  draw.fillStyle = draw.strokeStyle = "#223";
  draw.lineWidth = 26;
  draw.fill(new Path2D("M60 50h250v170h-250z" + holes.map(hole => circle(...hole)).join("")), "evenodd");
  draw.stroke(new Path2D("M590 175A80 80 0 1 1 598 120H660"));
  draw.font = "bold 190px sans-serif";
  draw.fillText("thin", 170, 410);
  canvas.convertToBlob().then(blob => read(new File([blob], "drawing.png")));
}

function settings() {
  const value = Object.fromEntries(new FormData(form));
  const threshold = {otsu: -1, level: Number(value.level), local: -2}[value.method];
  for (const {name, type} of field) if (type === "number") value[name] = Number(value[name]);
  return {...value, threshold};
}

/** Throws if a visible field is wrong. */
function checkFields() {
  const wrong = [...field].find(one => one.offsetParent && !one.validity.valid);
  if (!wrong) return;
  const {labels: [label], min, max, value} = wrong;
  throw new Error(`${label.textContent}: expected a whole number from ${min} to ${max}, got '${value}'`);
}

/** Only the fields that the operation reads. */
function showFields() {
  const {operation, method, level} = settings();
  for (const part of form.querySelectorAll("[data-for]")) {
    part.hidden = !part.dataset.for.split(" ").includes(operation) || (part.dataset.method ?? method) !== method;
  }
  element("about").textContent = field.rule.selectedOptions[0]?.title;
  element("shown").textContent = level;
  element("masked").disabled = operation === "edges";
}

let isRunning = false, isStale = false;  // the latest settings win
async function refresh() {
  isStale = true;
  if (isRunning || !size) return;
  isRunning = true;
  document.body.classList.add("busy");
  try {
    isStale = false;
    checkFields();
    const request = settings();
    after = {...await ask("run", request), operation: request.operation};
    show();
  } catch (error) {
    after = null;
    draw();
    say(error.message, "failed");
  } finally {
    isRunning = false;
    document.body.classList.remove("busy");
    if (isStale) refresh();
  }
}

const shown = value => typeof value === "number" ? value.toLocaleString("en") : value;
const fill = (id, children) => element(id).replaceChildren(...children);

function made(tag, ...children) {
  const result = document.createElement(tag);
  result.append(...children);
  return result;
}

function show() {
  const repeated = after.runs > 1 ? `, mean of ${after.runs} runs` : "";
  const facts = [["Time", `${Number(after.ms.toPrecision(3))} ms${repeated}`], ...after.facts];
  fill("facts", facts.map(([label, value]) => made("div", made("dt", label), made("dd", shown(value)))));
  fill("warnings", after.warnings.map(text => made("p", text)));
  fill("key", keys[after.operation].map((text, i) => {
    const disc = made("i");
    disc.style.background = after.colours[i];
    return made("span", disc, text);
  }));
  const cell = value => typeof value === "number" ? Number(value.toFixed(2)) : value;
  fill("table", [made("tr", ...after.head.split(",").map(column => made("th", column))),
                 ...after.preview.map(row => made("tr", ...row.map(value => made("td", cell(value)))))]);
  fill("rows", [`rows: ${after.count > 100 ? "the first 100 of " : ""}${shown(after.count)}`]);
  say(after.facts.map(([label, value]) => `${label}: ${shown(value)}`).join(". "), "shown");
  draw();
}

async function save(kind) {
  try {
    const link = made("a");
    link.href = URL.createObjectURL(await ask(kind));
    link.download = `${file.name.replace(/\.[^.]*$/, "")}-${after.operation}.${kind}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  } catch (error) {
    say(`${kind.toUpperCase()}: ${error.message}`, "failed");
  }
}

const canvases = [element("before"), element("after")];
const fitting = () => Math.min(canvases[0].width / size.width, canvases[0].height / size.height);
const fit = () => zoom(0);

function zoom(factor, x = view.x, y = view.y) {
  const scale = Math.min(Math.max(view.scale * factor, fitting()), 64);
  view = {x: x + (view.x - x) * view.scale / scale, y: y + (view.y - y) * view.scale / scale, scale};
  draw();
}

function move(x, y) {
  view.x = Math.min(Math.max(view.x + x / view.scale, 0), size.width);
  view.y = Math.min(Math.max(view.y + y / view.scale, 0), size.height);
  draw();
}

/** From the level with at least a pixel per pixel of the screen, so that lines keep their colour. */
function drawLevels(context, levels) {
  const k = Math.min(Math.max(0, Math.floor(-Math.log2(view.scale))), levels.length - 1);
  context.drawImage(levels[k], 0, 0, levels[k].width * 2 ** k, levels[k].height * 2 ** k);
}

function drawDiscs(context) {
  if (after.discs.length * fitting() > 30000 * view.scale) return;  // a crowd, which the pixels show
  for (let i = 0; i < after.discs.length; i += 3) {
    context.beginPath();
    context.arc(after.discs[i] + 0.5, after.discs[i + 1] + 0.5, 3.5 * devicePixelRatio / view.scale, 0, 7);
    context.fillStyle = after.colours[after.discs[i + 2] - 1];
    context.fill();
  }
}

/** A context in pixels of the picture, whose ground is drawn. */
function begun(canvas, ground) {
  const context = canvas.getContext("2d"), {x, y, scale} = view;
  context.setTransform(scale, 0, 0, scale, canvas.width / 2 - x * scale, canvas.height / 2 - y * scale);
  context.imageSmoothingEnabled = scale < 1;
  context.imageSmoothingQuality = "medium";
  context.fillStyle = ground;
  context.fillRect(0, 0, size.width, size.height);
  return context;
}

function drawNow() {
  if (!size) return;
  for (const canvas of canvases) {
    canvas.width = canvas.clientWidth * devicePixelRatio;
    canvas.height = canvas.clientHeight * devicePixelRatio;
  }
  if (view.scale <= fitting()) view = {x: size.width / 2, y: size.height / 2, scale: fitting()};
  element("result").classList.toggle("zoomed", view.scale > fitting());
  const isOver = element("over").checked;
  drawLevels(begun(canvases[0], after?.mask ? "#000" : "#fff"), after?.mask ?? before);
  const context = begun(canvases[1], isOver ? "#fff" : "#000");
  context.globalAlpha = isOver ? 0.5 : 0;
  drawLevels(context, before);
  context.globalAlpha = isOver && after?.isArea ? 0.7 : 1;
  if (after) drawLevels(context, after.levels);
  if (after?.discs) drawDiscs(context);
}

let frame = 0;
function draw() {
  cancelAnimationFrame(frame);
  frame = requestAnimationFrame(drawNow);
}

const pointers = new Map();

/** Of the picture, under the pointer. */
function placeOf(event) {
  const {left, top, width, height} = event.target.getBoundingClientRect();
  return [view.x + (event.clientX - left - width / 2) * devicePixelRatio / view.scale,
          view.y + (event.clientY - top - height / 2) * devicePixelRatio / view.scale];
}

function drag(event) {
  const from = pointers.get(event.pointerId);
  if (!from) return;
  const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
  if (other) {
    const distance = one => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
    zoom(distance(event) / Math.max(distance(from), 1), ...placeOf(event));
  } else {
    move((from.clientX - event.clientX) * devicePixelRatio, (from.clientY - event.clientY) * devicePixelRatio);
  }
  pointers.set(event.pointerId, event);
}

const shortcuts = {"+": () => zoom(1.5), "=": () => zoom(1.5), "-": () => zoom(1 / 1.5), "0": fit,
                   ArrowLeft: () => move(-60, 0), ArrowRight: () => move(60, 0),
                   ArrowUp: () => move(0, -60), ArrowDown: () => move(0, 60)};

for (const canvas of canvases) {
  canvas.addEventListener("pointerdown", event => {
    pointers.set(event.pointerId, event);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", drag);
  canvas.addEventListener("lostpointercapture", event => pointers.delete(event.pointerId));
  canvas.addEventListener("wheel", event => {
    if (!event.ctrlKey && document.activeElement !== canvas) return;  // the page scrolls
    event.preventDefault();
    zoom(2 ** (-event.deltaY / 300), ...placeOf(event));
  }, {passive: false});
  canvas.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || !shortcuts[event.key]) return;
    event.preventDefault();
    shortcuts[event.key]();
  });
  new ResizeObserver(draw).observe(canvas);
}
element("in").onclick = () => zoom(1.5);
element("out").onclick = () => zoom(1 / 1.5);
element("fit").onclick = fit;
element("over").onchange = draw;
element("sample").onclick = sample;
for (const kind of ["png", "svg", "csv"]) element(kind).onclick = () => save(kind);
form.onsubmit = event => event.preventDefault();
addEventListener("input", ({target}) => {
  if (target.form !== form) return;
  showFields();
  if (target.name === "channel" && file) read(file);
  else refresh();
});
element("file").onchange = ({target}) => {
  if (target.files.length > 0) read(target.files[0]);
  target.value = "";
};
addEventListener("paste", ({clipboardData}) => readFirst(clipboardData.files, "The clipboard holds no picture."));
for (const kind of ["dragover", "dragleave", "drop"]) {
  addEventListener(kind, event => {
    event.preventDefault();
    document.body.classList.toggle("dragged", kind === "dragover");
    if (kind === "drop") readFirst(event.dataTransfer.files, "What was dropped is no file.");
  });
}

startWorker();
ask("names").then(({rules, edgeOperators}) => {
  for (const [label, isBuiltIn] of [["Built-in rules", true], ["Rules given by tables", false]]) {
    const names = rules.filter(one => one.isBuiltIn === isBuiltIn).map(({name, description}) =>
      Object.assign(new Option(name), {title: description}));
    field.rule.append(Object.assign(made("optgroup", ...names), {label}));
  }
  field.rule.value = "guo_hall";
  for (const operator of edgeOperators) field.edge.append(new Option(operator));
  field.edge.value = "sobel";
  showFields();
}).catch(error => say(`This browser cannot run the page: ${error.message}`, "failed"));
