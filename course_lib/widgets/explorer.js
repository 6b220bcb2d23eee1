// The front end of every explorer: its controls, and the talk with Python. Joined with picture.js,
// which draws; neither knows a formula of the course.

const IN_FLIGHT = 2; // states on their way to Python at most; the newest one waits behind them
// Decoding a JPEG waits for a turn of the main thread; on the same machine plain bytes are faster.
const LOCAL = ["localhost", "127.0.0.1", "[::1]"].includes(window.location.hostname) && "VideoFrame" in window;
const PATIENCE = 2000; // ms without an answer before the reader is told
const MANY = 8; // controls that have room in one column; more stand in two
const NARROW = 660; // px: beside pictures that take no more, many numbers find room
const LIST = 70; // letters of all options; more stand in a list that opens
const SENTENCE = 24; // letters of a value that does not fit into a column

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
  const stage = make("div", { className: "ce-stage" }, pictures, panel);
  stage.classList.toggle("ce-many", spec.controls.length > MANY);
  root.style.setProperty("--ce-longest", `${Math.max(...spec.controls.map(longest))}ch`);
  root.append(stage, status, settled);
  el.append(root);

  let figures = [];
  let sent = 0, answered = 0, waiting = false; // numbers of this view's messages
  let shown = 0; // the newest frame drawn; frames are numbered by Python
  let patience = 0, rest = 0;

  function moved() {
    waiting = true;
    flush();
  }

  // A spot of a picture was dragged to (u, v): it moves controls.
  function dragged(moves, u, v) {
    for (const [name, a, b, c] of moves) rows.get(name).value = a + b * u + c * v;
    moved();
  }

  // The pointer is at a pixel of a picture, or has left it: its ray shows in other pictures.
  function pointed(trails, at) {
    for (const place of new Set(trails.map((trail) => trail.picture))) {
      figures[place].follow(at ? trails.filter((trail) => trail.picture === place) : [], at);
    }
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
      figures = message.pictures.map(() => figure(dragged, pointed));
      pictures.replaceChildren(...figures.map((f) => f.element));
      const width = message.pictures.reduce((sum, p) => sum + p.size[0], 0);
      stage.classList.toggle("ce-beside", spec.controls.length > MANY && width <= NARROW);
      stage.style.setProperty("--ce-width", `${width}px`);
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

const newId = () => `ce-${Math.random().toString(36).slice(2)}`;

function labelled(control, id) {
  const label = make("label", { htmlFor: id, className: "ce-label" }, control.label);
  if (control.symbol) label.append(" ", make("i", { textContent: control.symbol }));
  return label;
}

const withUnit = (text, unit) => typeset(`${text}${unit === "°" ? "" : " "}${unit}`.trim());
const longest = ({ texts = [], unit }) => Math.max(0, ...texts.map((text) => withUnit(text, unit).length));

const CONTROLS = {
  slider(control, moved) {
    const { values, texts, unit } = control;
    const id = newId();
    const input = make("input", { type: "range", id, name: control.name, min: 0, max: values.length - 1, step: 1 });
    const output = make("span", { className: "ce-value", ariaHidden: true });
    const element = make("div", { className: "ce-row" }, labelled(control, id), input, output);
    const place = (value) => {
      input.value = nearest(values, value);
      say();
    };
    const say = () => {
      output.textContent = withUnit(texts[input.value], unit);
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
    if (control.options.join("").length > LIST) return CONTROLS.list(control, moved);
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

  list(control, moved) {
    const id = newId();
    const options = control.options.map((textContent) => make("option", { textContent }));
    const select = make("select", { id, name: control.name }, ...options);
    const element = make("div", { className: "ce-row ce-choice" }, labelled(control, id), select);
    select.addEventListener("change", moved);
    select.value = control.default;
    return {
      element,
      get value() { return select.value; },
      set value(value) { select.value = value; },
      follow() {},
    };
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
  if (same) return readouts.forEach((r, i) => say(values[i], r));
  const items = readouts.map((r) => make("div", {},
    make("dt", {}, r.label, " ", make("i", { textContent: r.symbol })),
    make("dd", { label: r.label })));
  list.replaceChildren(...items);
  items.forEach((item, i) => say(item.lastChild, readouts[i]));
}

// A number is text; a matrix is a table with a name.
function say(value, readout) {
  if (!readout.rows.length) {
    value.parentNode.classList.toggle("ce-wide", readout.quantity.length > SENTENCE);
    return rewrite(value, typeset(readout.quantity));
  }
  const cells = value.querySelectorAll("td");
  const texts = readout.rows.flat().map(typeset);
  if (cells.length === texts.length) return texts.forEach((text, i) => rewrite(cells[i], text));
  const rows = readout.rows.map((row) => make("tr", {}, ...row.map((text) => make("td", { textContent: typeset(text) }))));
  value.parentNode.classList.add("ce-wide");
  value.replaceChildren(make("table", { className: "ce-matrix", ariaLabel: readout.label }, make("tbody", {}, ...rows)));
}
