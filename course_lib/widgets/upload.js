// The box into which photographs are dropped. Each is sent in parts, and every part is answered
// before the next one leaves: so nothing piles up, and the verdicts come one by one.

const PART = 1 << 21; // bytes; JupyterLab closes the line at a message of 10 MB

function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

export default { render };

function render({ model, el }) {
  const spec = model.get("spec");
  const view = Math.random().toString(36).slice(2);
  const input = make("input", { type: "file", multiple: true, accept: "image/*,.heic,.heif", id: `cu-${view}` });
  const zone = make("label", { className: "cu-zone", htmlFor: input.id },
    make("b", { textContent: "Drop photographs here, or press to choose them" }),
    make("span", { textContent: `They are copied to ${spec.folder} and stay on this computer.` }));
  const bar = make("progress", { max: 1, value: 0, hidden: true, ariaLabel: "Photographs that were looked at" });
  const status = make("p", { className: "cu-status", role: "status" });
  const list = make("ul", { className: "cu-list" });
  const box = make("div", { className: "cu-box" }, input, zone);
  const root = make("section", { className: "course-explorer course-upload", ariaLabel: spec.title }, box, bar, status, list);
  el.append(root);

  const queue = [];
  const own = []; // what never left the browser
  let total = 0, done = 0, busy = false, answered = null;

  function show() {
    const rows = [...model.get("rows"), ...own];
    const ordered = [...rows.filter((row) => !row.used), ...rows.filter((row) => row.used)];
    list.replaceChildren(...ordered.map(item));
    root.dataset.rows = rows.length;
  }

  function item({ name, words, used, sign, picture }) {
    const shown = picture
      ? make("img", { src: picture, alt: used ? `${name}, with the corners that were found` : name })
      : make("span", { className: "cu-none", ariaHidden: true });
    const said = make("span", {}, make("b", { textContent: `${sign} ${name}` }), make("br"), words);
    return make("li", { className: used ? "cu-used" : "cu-aside" }, shown, said);
  }

  function say(now) {
    const rows = [...model.get("rows"), ...own];
    const used = rows.filter((row) => row.used).length;
    const aside = rows.length > used ? " Those that cannot come first, with the reason." : "";
    const counted = `${used} of ${rows.length} can be used.${aside}`;
    status.textContent = now ? `${now} ${rows.length ? counted : ""}` : `All are looked at: ${counted} Run the next cell.`;
    Object.assign(bar, { hidden: !now, value: total ? done / total : 0 });
  }

  const answer = () => new Promise((resolve) => { answered = resolve; });

  async function send(file) {
    for (let start = 0; start === 0 || start < file.size; start += PART) {
      const part = await file.slice(start, start + PART).arrayBuffer();
      const next = answer();
      model.send({ view, name: file.name, size: file.size, start, last: start + PART >= file.size }, undefined, [part]);
      await next;
    }
  }

  function refuse(file, words) {
    own.push({ name: file.name, words, used: false, sign: "✗", picture: "" });
    show();
  }

  async function work() {
    if (busy) return;
    busy = true;
    while (queue.length) {
      const file = queue.shift();
      say(`Looking at ${done + 1} of ${total}: ${file.name}.`);
      try {
        if (file.size > spec.most) refuse(file, "It is too large for a photograph: is it a film?");
        else await send(file);
      } catch {
        refuse(file, "It cannot be read. Is it a folder? Open it, and drop the photographs in it.");
      }
      done += 1;
    }
    busy = false;
    say("");
    [total, done] = [0, 0];
  }

  function take(files) {
    queue.push(...files);
    total += files.length;
    if (files.length) work();
  }

  input.addEventListener("change", () => { take([...input.files]); input.value = ""; });
  for (const name of ["dragenter", "dragover", "dragleave", "drop"]) {
    box.addEventListener(name, (event) => {
      event.preventDefault();
      event.stopPropagation(); // JupyterLab has plans of its own for what is dropped
      box.classList.toggle("cu-over", name === "dragenter" || name === "dragover");
      if (name === "drop") take([...event.dataTransfer.files]);
    });
  }
  const received = (message) => { if (message.view === view) answered?.(); };
  model.on("msg:custom", received);
  model.on("change:rows", show);
  show();
  return () => {
    model.off("msg:custom", received);
    model.off("change:rows", show);
  };
}
