// One picture of an explorer: the photograph, what is drawn over it, and what follows the pointer.
// Everything it shows was computed in Python, but for the image of the pointer's ray (drawTrail).

const BT601 = { matrix: "smpte170m", primaries: "bt709", transfer: "iec61966-2-1", fullRange: false };

function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

function rewrite(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// A minus sign, not a hyphen; long whole numbers in groups of three.
const typeset = (text) => text
  .replace(/(?<![\w.)])-(?=\.?\d)/g, "\u2212")
  .replace(/(?<![\d.])\d{5,}(?!\d)/g, (digits) => digits.replace(/\B(?=(\d{3})+$)/g, "\u202f"));

const decode = (data) => createImageBitmap(new Blob([data], { type: "image/jpeg" }));

function unpacked(picture, buffers) {
  const data = buffers[picture.image];
  const [codedWidth, codedHeight] = picture.size;
  return new VideoFrame(data, { format: "I420", codedWidth, codedHeight, timestamp: 0, colorSpace: BT601 });
}

function aligned(view) {
  return new Float32Array(view.buffer.slice(view.byteOffset, view.byteOffset + view.byteLength));
}

const VANISHING = 1e-3; // of the farther end: nearer than that an end of a ray has no image
const GRIP = 16; // px of the screen: how near to a handle a pointer takes it

function figure(dragged, pointed) {
  const canvas = make("canvas", { className: "ce-canvas", role: "img", tabIndex: 0 });
  const cross = make("canvas", { className: "ce-cross", ariaHidden: true, hidden: true });
  const thread = make("canvas", { className: "ce-cross", ariaHidden: true, hidden: true });
  const title = make("figcaption");
  const reading = make("p", { className: "ce-reading", ariaLive: "polite" });
  const box = make("div", { className: "ce-box" }, canvas, thread, cross);
  const element = make("figure", { className: "ce-figure" }, title, box, reading);
  let picture = null, photograph = null, floats = null, pointer = null, width = 0;
  let held = -1; // the handle that is being dragged
  let style = null; // colours by role and the font; asking the page for them is slow
  const size = new ResizeObserver(([entry]) => {
    width = entry.contentRect.width;
    draw();
  });
  size.observe(box);

  function fit(layer) {
    const dense = window.devicePixelRatio || 1;
    const [w, h] = [Math.round(width * dense), Math.round((width * dense * picture.size[1]) / picture.size[0])];
    if (layer.width !== w || layer.height !== h) Object.assign(layer, { width: w, height: h });
    const opaque = layer === canvas && photograph; // the browser then has less to blend
    const context = layer.getContext("2d", { alpha: !opaque });
    const scale = w / picture.size[0];
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, w, h);
    context.setTransform(scale, 0, 0, scale, 0.5 * scale, 0.5 * scale); // pixel (0, 0) is a centre
    return context;
  }

  function draw() {
    if (!picture || !width) return;
    style ??= styleOf(box);
    const context = fit(canvas);
    if (photograph) cover(context, photograph);
    else blank(context, style); // where a photograph was, the canvas is black
    for (const line of picture.lines) stroke(context, line, floats, style, Boolean(photograph));
    for (const handle of picture.handles) spot(context, handle, style, picture.size[0] / width);
    for (const label of picture.labels) write(context, label, style, Boolean(photograph));
    point(pointer);
  }

  const readable = () => picture.pixels || picture.probes.length > 0 || Boolean(picture.marks);

  function point(at) {
    pointer = at;
    pointed(picture.trails, at);
    cross.hidden = !at || !readable();
    if (cross.hidden) {
      rewrite(reading, readable() ? "Point at the picture to read it." : "");
      return;
    }
    const context = fit(cross);
    const [w, h] = picture.size;
    const [u, v] = (pointer = [Math.min(Math.max(at[0], 0), w - 1), Math.min(Math.max(at[1], 0), h - 1)]);
    for (const [lineWidth, strokeStyle] of [[3, "rgba(0,0,0,.55)"], [1, "#fff"]]) {
      Object.assign(context, { lineWidth: (lineWidth * w) / width, strokeStyle });
      context.beginPath();
      context.moveTo(u, -0.5); context.lineTo(u, h - 0.5);
      context.moveTo(-0.5, v); context.lineTo(w - 0.5, v);
      context.stroke();
    }
    const texts = picture.pixels ? [`(u, v) = (${u.toFixed(0)}, ${v.toFixed(0)}) px`] : [];
    for (const probe of picture.probes) {
      const value = interpolate(probe, floats, u / (w - 1), v / (h - 1));
      if (Number.isFinite(value)) texts.push(`${probe.label} ${value.toFixed(probe.digits)}${probe.gap}${probe.unit}`);
    }
    const near = picture.marks ? nearestMark(picture.marks, floats, u, v) : -1;
    if (near >= 0) {
      ringMark(context, picture.marks, floats, near, style, w / width);
      texts.push(...saidOfMark(picture.marks, floats, near));
    }
    rewrite(reading, typeset(texts.join("  ·  ")));
  }

  const under = (event) => [event.offsetX, event.offsetY].map((x) => (x * picture.size[0]) / width - 0.5);

  function gripped(event) {
    const [u, v] = under(event), reach = (GRIP * picture.size[0]) / width;
    const far = picture.handles.map(({ at }) => (at[0] - u) ** 2 + (at[1] - v) ** 2);
    const best = far.indexOf(Math.min(...far));
    return far[best] < reach ** 2 ? best : -1;
  }

  // The spot follows the pointer at once; all that depends on it comes from Python.
  function drag(event) {
    const handle = picture.handles[held];
    const [u, v] = under(event).map((x, i) => Math.min(Math.max(x, 0), picture.size[i] - 1));
    const free = [2, 3].map((i) => handle.moves.some((move) => move[i] !== 0)); // b, c
    handle.at = [free[0] ? u : handle.at[0], free[1] ? v : handle.at[1]];
    draw();
    dragged(handle.moves, u, v);
  }

  canvas.addEventListener("pointerdown", (event) => {
    if (!picture?.handles.length) return;
    held = gripped(event);
    const called = Boolean(picture.marks) || picture.trails.length > 0;
    if (held < 0 && called) held = 0; // a press beside it calls the spot there
    if (held < 0) return;
    event.preventDefault();
    canvas.setPointerCapture(event.pointerId);
    box.classList.add("ce-held");
    if (called) drag(event);
  });
  function release() {
    if (held < 0) return;
    const { moves, at } = picture.handles[held];
    held = -1;
    box.classList.remove("ce-held");
    dragged(moves, ...at); // the last frame puts it where its controls stand
  }
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  box.addEventListener("pointermove", (event) => {
    if (!picture) return;
    if (held >= 0) drag(event);
    else if (picture.handles.length) box.classList.toggle("ce-grip", gripped(event) >= 0);
    point(under(event));
  });
  box.addEventListener("pointerleave", () => { if (picture) point(null); });
  canvas.addEventListener("blur", () => { if (picture) point(null); });
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step || !picture) return;
    event.preventDefault();
    const from = pointer ?? picture.size.map((n) => Math.floor(n / 2));
    point(from.map((x, i) => x + step[i] * (event.shiftKey ? 10 : 1)));
  });

  return {
    element,
    // What the pointer in another picture draws here.
    follow(trails, at) {
      thread.hidden = !trails.length;
      if (thread.hidden || !width) return;
      style ??= styleOf(box);
      const context = fit(thread);
      for (const trail of trails) drawTrail(context, trail, at, style, picture.size);
    },
    restyle() { style = null; draw(); },
    remove() {
      size.disconnect();
      photograph?.close();
    },
    show(next, bitmap, numbers) {
      if (held >= 0 && next.handles[held]) next.handles[held].at = picture.handles[held].at;
      [picture, floats] = [next, numbers];
      if (bitmap !== "same") {
        photograph?.close();
        photograph = bitmap;
      }
      box.classList.toggle("ce-photograph", Boolean(photograph));
      box.classList.toggle("ce-draggable", picture.handles.length > 0);
      rewrite(title, picture.title);
      canvas.ariaLabel = picture.alt;
      element.style.setProperty("--ce-width", `${picture.size[0]}px`);
      element.style.setProperty("--ce-share", picture.size[0]);
      reading.classList.toggle("ce-readable", readable());
      box.style.aspectRatio = picture.size.join(" / ");
      draw();
    },
  };
}

function styleOf(element) {
  const computed = getComputedStyle(element);
  const colours = {};
  const ink = (role) => (colours[role] ??= computed.getPropertyValue(`--ce-${role}`).trim());
  return { ink, font: computed.fontFamily, lettering: new Map() };
}

function stroke(context, line, floats, { ink }, onPhotograph) {
  const { start, count } = line.points;
  const path = new Path2D();
  let down = false;
  for (let i = start; i < start + count; i += 2) {
    const [u, v] = [floats[i], floats[i + 1]];
    if (Number.isNaN(u)) down = false; // a NaN row lifts the pen
    else if (down) path.lineTo(u, v);
    else { path.moveTo(u, v); down = true; }
  }
  if (line.closed) path.closePath();
  Object.assign(context, { lineJoin: "round", lineCap: "round", fillStyle: ink(line.role) });
  context.setLineDash(line.dashed ? [5, 5] : []);
  if (line.fill) {
    context.globalAlpha = line.fill;
    context.fill(path);
    context.globalAlpha = 1;
  }
  if (!line.width) return;
  if (onPhotograph) {
    Object.assign(context, { lineWidth: line.width + 2, strokeStyle: "rgba(255,255,255,.7)" });
    context.stroke(path);
  }
  Object.assign(context, { lineWidth: line.width, strokeStyle: ink(line.role) });
  context.stroke(path);
}

function spot(context, { at, role }, { ink }, pixel) {
  context.setLineDash([]);
  context.beginPath();
  context.arc(at[0], at[1], 7 * pixel, 0, 7);
  Object.assign(context, { fillStyle: ink("paper"), strokeStyle: ink(role), lineWidth: 3 * pixel });
  context.fill();
  context.stroke();
}

function blank(context, { ink }) {
  context.save();
  context.resetTransform();
  context.fillStyle = ink("paper");
  context.fillRect(0, 0, context.canvas.width, context.canvas.height);
  context.restore();
}

// To the last row of the canvas, of which a rounded height may leave a part.
function cover(context, photograph) {
  context.save();
  context.resetTransform();
  context.drawImage(photograph, 0, 0, context.canvas.width, context.canvas.height);
  context.restore();
}

// Outlining letters is slow, and most labels stay: each is drawn once, then copied. One that would
// reach over the edge of the picture is moved inwards.
function write(context, label, { ink, font, lettering }, onPhotograph) {
  const halo = onPhotograph ? "rgba(255,255,255,.8)" : ink("paper");
  const key = [label.text, label.role, halo].join();
  if (lettering.size > 200) lettering.clear();
  if (!lettering.has(key)) lettering.set(key, lettered(typeset(label.text), font, ink(`${label.role}-text`), halo));
  const { canvas, margin } = lettering.get(key);
  const before = { start: 0, middle: 0.5, end: 1 }[label.anchor] * (canvas.width - 2 * margin) + margin;
  const place = context.getTransform().transformPoint(new DOMPoint(...label.at));
  context.save();
  context.resetTransform();
  const room = [context.canvas.width - canvas.width, context.canvas.height - canvas.height];
  const corner = [place.x - before, place.y - canvas.height / 2];
  const [x, y] = corner.map((at, i) => Math.round(Math.min(Math.max(at, -margin), room[i] + margin)));
  context.drawImage(canvas, x, y);
  context.restore();
}

function lettered(text, font, fillStyle, strokeStyle) {
  const dense = window.devicePixelRatio || 1;
  const margin = Math.ceil(3 * dense), canvas = new OffscreenCanvas(1, 1), context = canvas.getContext("2d");
  const style = { font: `${12 * dense}px ${font}`, textBaseline: "middle", lineWidth: 4 * dense, fillStyle, strokeStyle };
  context.font = style.font;
  canvas.width = Math.ceil(context.measureText(text).width) + 2 * margin;
  canvas.height = Math.ceil(20 * dense);
  Object.assign(context, style);
  context.strokeText(text, margin, canvas.height / 2);
  context.fillText(text, margin, canvas.height / 2);
  return { canvas, margin };
}

function nearestMark({ points }, floats, u, v) {
  let best = -1, least = Infinity;
  for (let i = 0; i < points.count; i += 2) {
    const far = (floats[points.start + i] - u) ** 2 + (floats[points.start + i + 1] - v) ** 2;
    if (far < least) [best, least] = [i / 2, far]; // never a point that is NaN
  }
  return best;
}

function ringMark(context, { points }, floats, index, { ink }, pixel) {
  const at = points.start + 2 * index;
  for (const [lineWidth, strokeStyle] of [[5, ink("paper")], [2, ink("camera")]]) {
    Object.assign(context, { lineWidth: lineWidth * pixel, strokeStyle });
    context.beginPath();
    context.arc(floats[at], floats[at + 1], 8 * pixel, 0, 7);
    context.stroke();
  }
}

// The image of a ray: A x + s e for s = 1 / depth, from 0 to 1 / near, where it is in front.
function drawTrail(context, { A, e, near, depths, unit, role }, [u, v], style, size) {
  const far = A.map(([a, b, c]) => a * u + b * v + c);
  const at = (s) => [0, 1].map((i) => (far[i] + s * e[i]) / (far[2] + s * e[2]));
  const w = [far[2], far[2] + e[2] / near];
  const least = VANISHING * Math.max(...w.map(Math.abs));
  if (Math.max(...w) < least || least === 0) return;
  const [start, stop] = w.map((end, i) => (end < least ? (least - far[2]) / e[2] : i / near));
  context.setLineDash([]);
  for (const [lineWidth, strokeStyle] of [[5, "rgba(255,255,255,.7)"], [2.5, style.ink(role)]]) {
    Object.assign(context, { lineWidth, strokeStyle, lineCap: "round" });
    context.beginPath();
    context.moveTo(...at(start));
    context.lineTo(...at(stop));
    context.stroke();
  }
  let last = null; // labels that would overlap are left out
  for (const depth of depths) {
    const [x, y] = at(1 / depth);
    if (!(far[2] + e[2] / depth > 0 && x > 4 && y > 4 && x < size[0] - 4 && y < size[1] - 4)) continue;
    if (last && (x - last[0]) ** 2 + (y - last[1]) ** 2 < 26 ** 2) continue;
    last = [x, y];
    context.beginPath();
    context.arc(x, y, 3.5, 0, 7);
    context.fillStyle = style.ink(role);
    context.fill();
    write(context, { text: `${depth} ${unit}`, role, at: [x, y - 12], anchor: "middle" }, style, true);
  }
}

function saidOfMark({ values, names, units, digits, gaps }, floats, index) {
  const own = values.start + index * names.length;
  return names.map((name, i) => `${name} ${floats[own + i].toFixed(digits[i])}${gaps[i]}${units[i]}`);
}

function interpolate(probe, floats, x, y) {
  const [rows, columns] = probe.shape;
  const [gx, gy] = [x * (columns - 1), y * (rows - 1)];
  const [c, r] = [Math.min(Math.floor(gx), columns - 2), Math.min(Math.floor(gy), rows - 2)];
  const [s, t] = [gx - c, gy - r];
  const at = (i, j) => floats[probe.values.start + i * columns + j];
  return (1 - t) * ((1 - s) * at(r, c) + s * at(r, c + 1)) + t * ((1 - s) * at(r + 1, c) + s * at(r + 1, c + 1));
}
