// The front end of every explorer: native controls, pictures, and what follows the pointer.
// It draws what Python sends and knows no formula of the course.

const IN_FLIGHT = 2; // states on their way to Python at most; the newest one waits behind them
// Decoding a JPEG waits for a turn of the main thread; on the same machine plain bytes are faster.
const LOCAL = ["localhost", "127.0.0.1", "[::1]"].includes(window.location.hostname) && "VideoFrame" in window;
const BT601 = { matrix: "smpte170m", primaries: "bt709", transfer: "iec61966-2-1", fullRange: false };
const PATIENCE = 2000; // ms without an answer before the reader is told

export default { render };

function render({ model, el }) {
  const spec = model.get("spec");
  const view = Math.random().toString(36).slice(2);
  const root = make("section", { className: "course-explorer", ariaLabel: spec.title });
  const pictures = make("div", { className: "ce-pictures" });
  const panel = make("div", { className: "ce-panel" });
  const controls = make("div", { className: "ce-controls" });
  const numbers = make("dl", { className: "ce-numbers" });
  const status = make("p", { className: "ce-status", role: "status" });
  const settled = make("p", { className: "ce-hidden", ariaLive: "polite" });
  const rows = new Map(spec.controls.map((c) => [c.name, CONTROLS[c.kind](c, moved)]));
  const reset = make("button", { type: "button", className: "ce-reset", textContent: "Reset" });
  controls.append(...[...rows.values()].map((row) => row.element), reset);
  panel.append(controls, numbers);
  root.append(pictures, panel, status, settled);
  el.append(root);

  let figures = [];
  let sent = 0, answered = 0, waiting = false; // numbers of this view's messages
  let shown = 0; // the newest frame drawn; frames are numbered by Python
  let patience = 0, rest = 0;

  function moved() {
    waiting = true;
    flush();
  }

  function flush() {
    if (!waiting || sent - answered >= IN_FLIGHT) return;
    waiting = false;
    ask({ state: Object.fromEntries([...rows].map(([name, row]) => [name, row.value])) });
  }

  function ask(content) {
    sent += 1;
    clearTimeout(patience);
    patience = setTimeout(() => tell("Waiting for Python. If no other cell is running, run this cell again."), PATIENCE);
    model.send({ view, seq: sent, raw: LOCAL, ...content });
  }

  function tell(sentence, wrong = false) {
    status.textContent = sentence;
    status.classList.toggle("ce-wrong", wrong);
  }

  function received(message, buffers) {
    if (message.view === view) {
      answered = Math.max(answered, message.seq);
      if (answered === sent) clearTimeout(patience);
      flush();
    }
    show(message, buffers);
  }

  let decoded = Promise.resolve(); // frames are painted in the order in which they came

  function show(message, buffers) {
    const images = message.error ? [] : message.pictures.map((p) => p.image);
    if (message.error || message.raw) {
      paint(message, buffers, images.map((image, i) => (Number.isInteger(image) ? unpacked(message.pictures[i], buffers) : image)));
      return;
    }
    const pending = Promise.all(images.map((image) => (Number.isInteger(image) ? decode(buffers[image]) : image)));
    decoded = decoded.then(() => pending).then((photographs) => paint(message, buffers, photographs));
  }

  function paint(message, buffers, photographs) {
    if (message.count < shown) return;
    shown = message.count;
    tell(message.error ?? "", Boolean(message.error));
    const quiet = sent === answered && !waiting;
    if (quiet) for (const [name, row] of rows) row.value = message.state[name];
    if (message.error) return;
    for (const [name, row] of rows) row.follow(message.follows[name]);
    if (figures.length !== message.pictures.length) {
      figures.forEach((f) => f.remove());
      figures = message.pictures.map(() => figure());
      pictures.replaceChildren(...figures.map((f) => f.element));
    }
    const floats = aligned(buffers[0]);
    message.pictures.forEach((p, i) => figures[i].show(p, photographs[i], floats));
    showNumbers(numbers, message.readouts);
    root.dataset.frame = message.count;
    clearTimeout(rest);
    rest = setTimeout(() => { settled.textContent = numbers.innerText.replace(/\s+/g, " "); }, 700);
  }

  reset.addEventListener("click", () => {
    for (const c of spec.controls) rows.get(c.name).value = c.default;
    moved();
  });
  const redraw = () => figures.forEach((f) => f.restyle());
  const theme = new MutationObserver(redraw);
  theme.observe(document.body, { attributes: true, attributeFilter: ["data-jp-theme-light", "class"] });
  const keep = (event) => { if (root.contains(event.target)) keepKey(event); };
  window.addEventListener("keydown", keep, { capture: true });
  model.on("msg:custom", received);
  const first = model.get("first");
  show(first.message, first.buffers);
  ask({}); // where the controls stand now
  return () => {
    model.off("msg:custom", received);
    window.removeEventListener("keydown", keep, { capture: true });
    theme.disconnect();
    figures.forEach((f) => f.remove());
    clearTimeout(patience);
    clearTimeout(rest);
  };
}

// JupyterLab takes plain keys as its own (arrows fold headings, letters edit cells) before the
// focused control sees them, unless the control has this attribute.
function keepKey(event) {
  const modified = event.ctrlKey || event.metaKey || event.altKey;
  const running = event.key === "Enter" && event.shiftKey;
  event.target.toggleAttribute("data-lm-suppress-shortcuts", !modified && !running);
}

// Elements ------------------------------------------------------------------------------------

function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

const newId = () => `ce-${Math.random().toString(36).slice(2)}`;

function labelled(control, id) {
  const label = make("label", { htmlFor: id, className: "ce-label" }, control.label);
  if (control.symbol) label.append(" ", make("i", { textContent: control.symbol }));
  return label;
}

const CONTROLS = {
  slider(control, moved) {
    const { values, texts, unit } = control;
    const id = newId();
    const input = make("input", { type: "range", id, min: 0, max: values.length - 1, step: 1 });
    const output = make("span", { className: "ce-value", ariaHidden: true });
    const element = make("div", { className: "ce-row" }, labelled(control, id), input, output);
    const place = (value) => {
      input.value = nearest(values, value);
      say();
    };
    const say = () => {
      output.textContent = `${texts[input.value]} ${unit}`.trim();
      input.ariaValueText = output.textContent;
      input.style.setProperty("--ce-filled", `${(100 * input.value) / (values.length - 1)}%`);
    };
    input.addEventListener("input", () => { say(); moved(); });
    place(control.default);
    return {
      element,
      get value() { return values[input.value]; },
      set value(value) { place(value); },
      follow(value) {
        input.disabled = value !== undefined;
        element.classList.toggle("ce-follows", input.disabled);
        if (input.disabled) place(value);
      },
    };
  },

  choice(control, moved) {
    const name = newId();
    const radios = control.options.map((value) => make("input", { type: "radio", name, value, id: newId() }));
    const options = radios.map((radio) => make("span", { className: "ce-option" }, radio, make("label", { htmlFor: radio.id, textContent: radio.value })));
    const label = make("span", { id: newId(), className: "ce-label", textContent: control.label });
    const group = make("div", { className: "ce-options", role: "radiogroup" }, ...options);
    group.setAttribute("aria-labelledby", label.id);
    const element = make("div", { className: "ce-row ce-choice" }, label, group);
    element.addEventListener("change", moved);
    const row = {
      element,
      get value() { return radios.find((radio) => radio.checked).value; },
      set value(value) { for (const radio of radios) radio.checked = radio.value === value; },
      follow() {},
    };
    row.value = control.default;
    return row;
  },

  switch(control, moved) {
    const id = newId();
    const input = make("input", { type: "checkbox", id, checked: control.default });
    const element = make("div", { className: "ce-row ce-switch" }, input, labelled(control, id));
    input.addEventListener("change", moved);
    return {
      element,
      get value() { return input.checked; },
      set value(value) { input.checked = value; },
      follow() {},
    };
  },
};

function nearest(values, value) {
  let best = 0;
  values.forEach((v, i) => { if (Math.abs(v - value) < Math.abs(values[best] - value)) best = i; });
  return best;
}

function showNumbers(list, readouts) {
  const values = list.querySelectorAll("dd");
  const same = values.length === readouts.length && readouts.every((r, i) => values[i].label === r.label);
  if (same) return readouts.forEach((r, i) => rewrite(values[i], r.quantity));
  const items = readouts.map((r) => make("div", {},
    make("dt", {}, r.label, " ", make("i", { textContent: r.symbol })),
    make("dd", { textContent: r.quantity, label: r.label })));
  list.replaceChildren(...items);
}

function rewrite(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// Pictures ------------------------------------------------------------------------------------

const decode = (data) => createImageBitmap(new Blob([data], { type: "image/jpeg" }));

function unpacked(picture, buffers) {
  const data = buffers[picture.image];
  const [codedWidth, codedHeight] = picture.size;
  const frame = new VideoFrame(data, { format: "I420", codedWidth, codedHeight, timestamp: 0, colorSpace: BT601 });
  const canvas = new OffscreenCanvas(codedWidth, codedHeight);
  canvas.getContext("2d").drawImage(frame, 0, 0);
  frame.close();
  return canvas;
}

function aligned(view) {
  return new Float32Array(view.buffer.slice(view.byteOffset, view.byteOffset + view.byteLength));
}

function figure() {
  const canvas = make("canvas", { className: "ce-canvas", role: "img", tabIndex: 0 });
  const cross = make("canvas", { className: "ce-cross", ariaHidden: true });
  const title = make("figcaption");
  const reading = make("p", { className: "ce-reading", ariaLive: "polite" });
  const box = make("div", { className: "ce-box" }, canvas, cross);
  const element = make("figure", { className: "ce-figure" }, title, box, reading);
  let picture = null, photograph = null, floats = null, pointer = null, width = 0;
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
    const context = layer.getContext("2d");
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
    if (photograph) context.drawImage(photograph, -0.5, -0.5, ...picture.size);
    for (const line of picture.lines) stroke(context, line, floats, style, Boolean(photograph));
    for (const label of picture.labels) write(context, label, style, picture.size[0] / width, Boolean(photograph));
    point(pointer);
  }

  const readable = () => picture.pixels || picture.probes.length > 0;

  function point(at) {
    pointer = at;
    const context = fit(cross);
    if (!at || !readable()) {
      rewrite(reading, readable() ? "Point at the picture to read it." : "");
      return;
    }
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
    rewrite(reading, texts.join("  ·  "));
  }

  cross.addEventListener("pointermove", (event) => {
    if (!picture) return;
    const scale = picture.size[0] / width;
    point([event.offsetX * scale - 0.5, event.offsetY * scale - 0.5]);
  });
  cross.addEventListener("pointerleave", () => { if (picture) point(null); });
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
    restyle() { style = null; draw(); },
    remove() { size.disconnect(); },
    show(next, bitmap, numbers) {
      [picture, floats] = [next, numbers];
      if (bitmap !== "same") photograph = bitmap;
      box.classList.toggle("ce-photograph", Boolean(photograph));
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
  return { ink, font: computed.fontFamily };
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

function write(context, label, { ink, font }, scale, onPhotograph) {
  context.font = `${12 * scale}px ${font}`;
  context.textAlign = label.anchor === "middle" ? "center" : label.anchor;
  context.textBaseline = "middle";
  context.setLineDash([]);
  Object.assign(context, { lineWidth: 4 * scale, strokeStyle: onPhotograph ? "rgba(255,255,255,.8)" : ink("paper") });
  context.strokeText(label.text, ...label.at);
  context.fillStyle = ink(label.role);
  context.fillText(label.text, ...label.at);
}

function interpolate(probe, floats, x, y) {
  const [rows, columns] = probe.shape;
  const [gx, gy] = [x * (columns - 1), y * (rows - 1)];
  const [c, r] = [Math.min(Math.floor(gx), columns - 2), Math.min(Math.floor(gy), rows - 2)];
  const [s, t] = [gx - c, gy - r];
  const at = (i, j) => floats[probe.values.start + i * columns + j];
  return (1 - t) * ((1 - s) * at(r, c) + s * at(r, c + 1)) + t * ((1 - s) * at(r + 1, c) + s * at(r + 1, c + 1));
}
