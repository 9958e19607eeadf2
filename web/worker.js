// Runs in a worker: holds the picture, and talks to the library by its C interface
// (kernels/include/thinbench.h), whose structs are written for 32-bit pointers.
"use strict";

const lineColours = ["#d9480f", "#2f9e44", "#1971c2", "#9c36b5", "#868e96"];  // graph: lines, nodes by kind
const regionColours = ["#00aa00", "#ff2828"];
const labelColours = ["#d6336c", "#2f9e44", "#f59f00", "#1c7ed6", "#ae3ec9", "#0ca678", "#f76707", "#4263eb",
                      "#74b816", "#e64980", "#15aabf", "#e8590c"];
const nodeKinds = ["isolated", "end", "junction", "cycle"];
const nodeCodes = [5, 2, 3, 4];  // by kind: index of the colour + 1
const tooLarge = "the picture needs more memory than the browser gives to a page";
let lib;
const started = makeThinbench().then(module => { lib = module; });
let picture = null, last = null;  // {name, width, height, grey}; what the latest operation gave
const owned = [];                 // what frees the memory of a request, last first

class Failure extends Error {}

function allocate(bytes) {
  const at = lib._malloc(Math.max(bytes, 1));
  if (at === 0) throw new Failure(tooLarge);
  owned.push(() => lib._free(at));
  return at;
}

/** A struct that begins with its size, of members of 32 bits. */
function struct(...members) {
  const at = allocate(4 * (members.length + 1));
  lib.HEAP32.set([4 * (members.length + 1), ...members], at >> 2);
  return at;
}

function text(string) {
  const bytes = new TextEncoder().encode(string + "\0");
  const at = allocate(bytes.length);
  lib.HEAPU8.set(bytes, at);
  return at;
}

const string = at => at === 0 ? "" : new TextDecoder().decode(lib.HEAPU8.slice(at, lib.HEAPU8.indexOf(0, at)));
const number = at => lib.HEAP32[at >> 2];

/** A new image of the picture's size; of bytes, or of labels or real numbers of so many bytes. */
function image(size = 1) {
  const {width, height} = picture;
  return struct(allocate(size * width * height), width, height, width, ...size === 1 ? [0, 0] : []);
}

function bytes(image) {
  const at = number(image + 4);
  return lib.HEAPU8.slice(at, at + picture.width * picture.height);
}

function greyImage() {
  const grey = image();
  lib.HEAPU8.set(picture.grey, number(grey + 4));
  return grey;
}

function call(name, ...args) {
  const status = lib["_thinbench_" + name](...args);
  if (status === 2) throw new Failure(tooLarge);
  if (status !== 0) throw new Failure(string(lib._thinbench_last_error()));
}

/** The handle that a function makes, which `destroy` frees. Its place among the arguments is the last. */
function made(destroy, name, ...args) {
  const out = allocate(4);
  call(name, ...args, out);
  const handle = number(out);
  owned.push(() => lib["_thinbench_" + destroy](handle));
  return handle;
}

/** A list of a handle, copied: elements of `size` bytes. */
function list(name, handle, size) {
  const count = allocate(4);
  const at = lib["_thinbench_" + name](handle, count, size);
  const copy = lib.HEAPU8.slice(at, at + number(count) * size).buffer;
  return {count: number(count), view: new DataView(copy), words: new Int32Array(copy)};
}

/** The time of an action in milliseconds: the mean of as many runs as take 50 ms, at most 500. */
function timed(action) {
  const begin = performance.now();
  const result = action();
  let runs = 1;
  while (performance.now() - begin < 50 && runs < 500) action(), ++runs;
  return {result, runs, ms: (performance.now() - begin) / runs};
}

/** Red, green, blue and an ignored byte in the library's memory. What is transparent becomes white. */
function readColours(bitmap) {
  const {width, height} = bitmap;
  const at = allocate(4 * width * height);
  const rows = Math.max(1, Math.min(height, Math.floor(4e6 / width)));  // canvases have limits
  const context = new OffscreenCanvas(width, rows).getContext("2d", {willReadFrequently: true});
  context.fillStyle = "#fff";
  for (let y = 0; y < height; y += rows) {
    const count = Math.min(rows, height - y);
    context.fillRect(0, 0, width, count);
    context.drawImage(bitmap, 0, y, width, count, 0, 0, width, count);
    lib.HEAPU8.set(context.getImageData(0, 0, width, count).data, at + 4 * y * width);
  }
  return at;
}

/** Reads a file and keeps one channel of it as grey levels. */
async function open({file, channel}) {
  const bitmap = await createImageBitmap(file, {premultiplyAlpha: "none", colorSpaceConversion: "none"});
  const {width, height} = picture = {name: file.name, width: bitmap.width, height: bitmap.height};
  const grey = image();
  call("select_channel", struct(readColours(bitmap), width, height, 4 * width, 4, 0), grey, text(channel), 0, 0);
  picture.grey = bytes(grey);
  return {width, height, bitmaps: [bitmap]};
}

function binarised(request, facts, warnings) {
  const source = greyImage(), binary = image(), foreground = allocate(8);
  const offset = request.threshold === -2 ? request.offset : -1;
  const options = struct(text(request.foreground), request.threshold, 0, offset, 0);
  call("binarise", source, binary, options, 0, foreground, foreground + 4);
  const mask = bytes(binary);
  let count = 0;
  for (let i = 0; i < mask.length; ++i) count += mask[i] &= 1;
  const share = 100 * count / mask.length;
  const side = string(number(foreground));
  const level = `${side === "dark" ? "<" : "≥"} ${request.threshold === -2 ? "mean" : number(foreground + 4)}`;
  facts.push(["Foreground", `${side} (${level}), ${share.toFixed(1)} %`]);
  if (share > 50) warnings.push("Most of the picture is foreground; another choice of Foreground takes the rest.");
  return {binary, mask};
}

const objectsOf = source => list("regions_objects", made("regions_destroy", "find_objects", source, 0), 48);

function thinned(request, binary) {
  const rule = made("rule_destroy", "rule_named", text(request.rule));
  const skeleton = image(), iterations = allocate(4);
  const pruning = struct(0, 0, 0, 0, 0, 0, 0, 0, 0);
  lib.HEAPF64[(pruning + 8) >> 3] = request.prune;
  const run = () => call("thin", rule, binary, skeleton, 0, 0, iterations);
  return {skeleton, iterations, run, pruning: [skeleton, skeleton, pruning, 0]};
}

function thin(request, facts, warnings) {
  const {binary, mask} = binarised(request, facts, warnings);
  const {skeleton, iterations, run, pruning} = thinned(request, binary);
  const time = timed(() => {
    run();
    if (request.prune > 0) call("prune", ...pruning, 0);
  });
  const codes = bytes(skeleton);
  const [before, after] = [objectsOf(binary).count, objectsOf(skeleton).count];
  facts.push(["Objects", before], ["Parts of the skeleton", after], ["Iterations", number(iterations)]);
  if (before !== after) warnings.push(`${before} objects became ${after} parts: this rule does not keep topology.`);
  return {time, mask, isBinary: true, colours: lineColours, ...pixelsOf(codes, facts)};
}

function edges(request, facts) {
  const {edge, gradient, brightness} = request;
  const source = greyImage(), found = image(), name = text(edge);
  const time = timed(() => call("detect_edges", name, source, found, gradient, brightness, 0));
  facts.push(["Objects", objectsOf(found).count]);
  return {time, isBinary: true, colours: lineColours, ...pixelsOf(bytes(found), facts)};
}

/** What a binary result shows: its codes and the list of its pixels. */
function pixelsOf(codes, facts) {
  const {width} = picture;
  let count = 0;
  for (let i = 0; i < codes.length; ++i) count += codes[i] &= 1;
  facts.push(["Pixels", count]);
  const rows = function* () {
    for (let i = codes.indexOf(1); i >= 0; i = codes.indexOf(1, i + 1)) yield [i % width, Math.floor(i / width)];
  };
  return {codes, head: "x,y", rows, count};
}

function regions(request, facts, warnings) {
  const {binary, mask} = binarised(request, facts, warnings);
  const labels = image(4), count = allocate(4);
  const withHoles = request.operation === "holes";
  const time = timed(() => withHoles ? made("regions_destroy", "label_regions", binary, labels, 0)
    : call("label_image", binary, labels, 8, 0, 0, count));
  const objects = withHoles ? list("regions_objects", time.result, 48) : objectsOf(binary);
  const holes = withHoles ? list("regions_holes", time.result, 48) : {count: 0};
  const area = (region, i) => Number(region.view.getBigInt64(48 * i, true));
  const outer = i => withHoles ? holes.words[12 * i + 10] : 0;
  const newIds = new Uint32Array(1 + objects.count + holes.count);  // 0: omitted
  let objectCount = 0, holeCount = 0;
  for (let i = 0; i < objects.count; ++i) if (area(objects, i) >= request.area) newIds[i + 1] = ++objectCount;
  for (let i = 0; i < holes.count; ++i) {
    if (area(holes, i) >= request.area && newIds[outer(i)]) newIds[1 + objects.count + i] = ++holeCount;
  }
  facts.push(["Objects", objectCount], ...withHoles ? [["Holes", holeCount]] : []);
  const data = new Int32Array(lib.HEAPU8.buffer, number(labels + 4), mask.length);
  const codeOf = (id, label) => withHoles ? label <= objects.count ? 1 : 2 : 1 + (id - 1) % labelColours.length;
  const code = newIds.map((id, label) => id && codeOf(id, label));
  const codes = new Uint8Array(data.length);
  for (let i = 0; i < data.length; ++i) codes[i] = code[data[i]];
  const row = (kind, region, i, id, object) => {
    const [left, top, right, bottom] = region.words.subarray(12 * i + 6, 12 * i + 10);
    const centre = [8, 16].map(at => Number(region.view.getBigInt64(48 * i + at, true)) / area(region, i));
    return [kind, id, object, area(region, i), ...centre, left, top, right - left + 1, bottom - top + 1];
  };
  const rows = function* () {
    for (let i = 0; i < objects.count; ++i) if (newIds[i + 1]) yield row("object", objects, i, newIds[i + 1], 0);
    for (let i = 0; i < holes.count; ++i) {
      const id = newIds[1 + objects.count + i];
      if (id) yield row("hole", holes, i, id, newIds[outer(i)]);
    }
  };
  return {time, mask, codes, colours: withHoles ? regionColours : labelColours, isArea: true, rows,
          count: objectCount + holeCount,
          head: "kind,id,enclosing_object,area,centre_x,centre_y,left,top,width,height"};
}

function graph(request, facts, warnings) {
  const {binary, mask} = binarised(request, facts, warnings);
  const {skeleton, iterations, run, pruning} = thinned(request, binary);
  const time = timed(() => {
    run();
    return request.prune > 0 ? made("graph_destroy", "prune", ...pruning)
      : made("graph_destroy", "skeleton_graph", skeleton, 0);
  });
  const distances = image(8);
  call("distances", binary, distances, 0, 0);
  const nodes = list("graph_nodes", time.result, 12), links = list("graph_edges", time.result, 44);
  const nodePixels = list("graph_node_pixels", time.result, 8).words;
  const linkPixels = list("graph_edge_pixels", time.result, 8).words;
  const widths = allocate(32 * links.count);
  call("edge_widths", time.result, distances, 0, widths, 32);
  const widthOf = new Float64Array(lib.HEAPU8.slice(widths, widths + 32 * links.count).buffer);
  const {width} = picture, codes = new Uint8Array(mask.length);
  for (let i = 0; i < linkPixels.length; i += 2) codes[linkPixels[i + 1] * width + linkPixels[i]] = 1;
  const discs = new Float32Array(3 * nodes.count), counts = [0, 0, 0, 0];
  for (let i = 0; i < nodes.count; ++i) {
    const [kind, first, count] = nodes.words.subarray(3 * i, 3 * i + 3);
    ++counts[kind];
    for (let k = 2 * first; k < 2 * (first + count); k += 2) {
      codes[nodePixels[k + 1] * width + nodePixels[k]] = nodeCodes[kind];
      discs[3 * i] += nodePixels[k] / count;
      discs[3 * i + 1] += nodePixels[k + 1] / count;
    }
    discs[3 * i + 2] = nodeCodes[kind];
  }
  facts.push(["Objects", objectsOf(binary).count], ["Ends", counts[1]], ["Junctions", counts[2]],
             ["Closed lines", counts[3]], ["Edges", links.count], ["Iterations", number(iterations)]);
  const line = function* (i) {
    const [startX, startY, stopX, stopY, first, count] = links.words.subarray(11 * i + 2, 11 * i + 8);
    yield [startX, startY];
    for (let k = 2 * first; k < 2 * (first + count); k += 2) yield [linkPixels[k], linkPixels[k + 1]];
    yield [stopX, stopY];
  };
  const kindOf = node => nodeKinds[nodes.words[3 * node]];
  const rows = function* () {
    for (let i = 0; i < links.count; ++i) {
      const [from, to, startX, startY, stopX, stopY, , pixels, horizontal, vertical, diagonal] =
        links.words.subarray(11 * i, 11 * i + 11);
      yield [i + 1, from + 1, to + 1, kindOf(from), kindOf(to), startX, startY, stopX, stopY, pixels,
             horizontal + vertical + diagonal * Math.SQRT2, Math.hypot(stopX - startX, stopY - startY),
             ...widthOf.subarray(4 * i, 4 * i + 4)];
    }
  };
  return {time, mask, codes, colours: lineColours, discs, line, rows, count: links.count,
          head: "id,from,to,from_kind,to_kind,start_x,start_y,stop_x,stop_y,pixels,length,chord," +
                "width_mean,width_median,width_min,width_max"};
}

const operations = {thin, holes: regions, labels: regions, graph, edges};

async function run(request) {
  const facts = [], warnings = [], preview = [];
  last = operations[request.operation](request, facts, warnings);
  for (const row of last.rows()) if (preview.push(row) === 100) break;
  const {time: {ms, runs}, head, count, isArea, discs, colours} = last;
  const levels = await layers(last.codes, colours);
  const mask = request.masked && last.mask ? await layers(last.mask, ["#ffffff"]) : null;
  return {facts, warnings, ms, runs, head, preview, count, isArea, discs, colours, levels, mask,
          bitmaps: [...levels, ...mask ?? []]};
}

/** The picture of codes, and its halves, where a pixel has the highest code of its four. */
async function layers(codes, colours) {
  const palette = paletteOf(colours, 0);
  const levels = [];
  for (let {width, height} = picture;;) {
    levels.push(await createImageBitmap(painted(codes, width, height, palette)));
    if (Math.max(width, height) <= 512) return levels;
    const [w, h] = [Math.ceil(width / 2), Math.ceil(height / 2)];
    const half = new Uint8Array(w * h);
    for (let y = 0, i = 0; y < height; ++y) {
      for (let x = 0, row = (y >> 1) * w; x < width; ++x, ++i) {
        if (codes[i] > half[row + (x >> 1)]) half[row + (x >> 1)] = codes[i];
      }
    }
    [codes, width, height] = [half, w, h];
  }
}

/** Colours as pixels, behind that of the ground, code 0. */
const paletteOf = (colours, ground) => Uint32Array.of(ground, ...colours.map(name => {
  const rgb = parseInt(name.slice(1), 16);
  return (0xff000000 | (rgb & 0xff) << 16 | rgb & 0xff00 | rgb >> 16) >>> 0;
}));

function painted(codes, width, height, palette) {
  const data = new ImageData(width, height);
  const pixels = new Uint32Array(data.data.buffer);
  for (let i = 0; i < pixels.length; ++i) pixels[i] = palette[codes[i]];
  return data;
}

async function encoded(data) {
  const canvas = new OffscreenCanvas(data.width, data.height);
  canvas.getContext("2d").putImageData(data, 0, 0);
  return canvas.convertToBlob({type: "image/png"});
}

function csv() {
  const lines = [`file,image_width,image_height,${last.head}\n`];
  const file = /[",\n]/.test(picture.name) ? `"${picture.name.replaceAll('"', '""')}"` : picture.name;
  const cell = value => Number.isFinite(value) || typeof value === "string" ? value : "";
  for (const row of last.rows()) lines.push(`${[file, picture.width, picture.height, ...row.map(cell)]}\n`);
  return new Blob(lines, {type: "text/csv"});
}

/** For each code the runs of its pixels, as lines that are one pixel wide. */
function runs() {
  const {width, height} = picture;
  const paths = last.colours.map(() => []);
  for (let y = 0, row = 0; y < height; ++y, row += width) {
    for (let x = 0; x < width;) {
      const [begin, code] = [x, last.codes[row + x]];
      while (x < width && last.codes[row + x] === code) ++x;
      if (code > 0) paths[code - 1].push(`M${begin} ${y}.5H${x}`);
    }
  }
  return paths.flatMap((path, i) => [`<path stroke="${last.colours[i]}" d="`, ...path, '"/>\n']);
}

function linesAndDiscs() {
  const parts = ['<g transform="translate(0.5 0.5)">\n'];
  for (let i = 0; i < last.count; ++i) {
    parts.push(`<polyline fill="none" stroke="${lineColours[0]}" points="${[...last.line(i)].join(" ")}"/>\n`);
  }
  for (let i = 0; i < last.discs.length; i += 3) {
    const [x, y, code] = last.discs.subarray(i, i + 3);
    parts.push(`<circle cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="1.5" fill="${lineColours[code - 1]}"/>\n`);
  }
  return [...parts, "</g>\n"];
}

/** The result over the grey picture, which is faded. */
async function svg() {
  const {width, height, grey} = picture;
  const greys = Uint32Array.from({length: 256}, (_, level) => 0xff000000 + 0x10101 * level);
  const address = new FileReaderSync().readAsDataURL(await encoded(painted(grey, width, height, greys)));
  return new Blob([
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">\n`,
    `<image width="${width}" height="${height}" style="image-rendering: pixelated; opacity: 0.5" href="${address}"/>\n`,
    ...last.line ? linesAndDiscs() : runs(), "</svg>\n"], {type: "image/svg+xml"});
}

function png() {
  const colours = last.isBinary ? ["#ffffff"] : last.colours;
  return encoded(painted(last.codes, picture.width, picture.height, paletteOf(colours, 0xff000000)));
}

/** Names of the library: rules with what they are, and edge operators. */
function names() {
  const rules = [], edgeOperators = [];
  for (let i = 0, name; (name = string(lib._thinbench_rule_name(i))); ++i) {
    const info = struct(0, 0, 0, 0, 0, 0, 0, 0, 0);
    call("rule_describe", made("rule_destroy", "rule_named", text(name)), info);
    rules.push({name, description: string(number(info + 8)), isBuiltIn: number(info + 16) !== 0});
  }
  for (let i = 0, name; (name = string(lib._thinbench_edge_operator_name(i))); ++i) edgeOperators.push(name);
  return {rules, edgeOperators};
}

const requests = {names, open, run, png, svg, csv};
let queue = started.catch(() => {});
onmessage = ({data: {id, kind, request}}) => {
  queue = queue.then(async () => {
    try {
      await started;
      const value = await requests[kind](request);
      postMessage({id, value}, value.bitmaps ?? []);
    } catch (error) {
      // Anything else, such as a lack of memory, may leave the library in an unknown state.
      const isFatal = !(error instanceof Failure || error instanceof DOMException);
      postMessage({id, error: error.message, isFatal});
    } finally {
      while (owned.length > 0) owned.pop()();
    }
  });
};
