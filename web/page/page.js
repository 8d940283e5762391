const $ = (id) => document.getElementById(id);
const canvas = $("canvas");
const context = canvas.getContext("2d", { willReadFrequently: true });
const nextFrame = () => new Promise((done) => setTimeout(done, 16));

const FORMATS = ["Gray8", "RGB565", "RGB888", "1 bit"];
/** Frames that take longer than this are shown row by row, others when they are complete. */
const QUICK = 200;
/** So many milliseconds are drawn before the page does something else. */
const SLICE = 12;

let module;
/** What runs now: `stop` ends it. */
let current = { stop() {} };

function say(text) {
  if ($("status").textContent !== text) $("status").textContent = text;
}

function show(figures) {
  const entries = Object.entries(figures).filter(([, value]) => value !== undefined);
  $("figures").replaceChildren(...entries.map(([name, value]) => {
    const [group, term, figure] = ["div", "dt", "dd"].map((tag) => document.createElement(tag));
    [term.textContent, figure.textContent] = [name, value];
    figure.dataset.figure = name;
    group.append(term, figure);
    return group;
  }));
}

function resize(width, height) {
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  // As large as the frame allows, in whole pixels if it is the smaller one.
  const frame = canvas.parentElement;
  const zoom = Math.min(frame.clientWidth / width, frame.clientHeight / height);
  canvas.style.width = `${width * (zoom > 1 ? Math.floor(zoom) : zoom)}px`;
}

/** Frames a second, from the times of the last ones. */
class Rate {
  times = [];
  count() {
    this.times.push(performance.now());
    if (this.times.length > 30) this.times.shift();
  }
  get text() {
    const { times } = this;
    if (times.length < 2) return "–";
    return ((times.length - 1) * 1000 / (times.at(-1) - times[0])).toFixed(1);
  }
}

const grouped = (number) => number.toLocaleString("en");

// ---- The gallery.

class Gallery {
  rate = new Rate();
  drawing = 0;

  constructor(wasm) {
    this.wasm = wasm;
    this.draw();
  }

  stop() {
    this.drawing++;
    canvas.ariaBusy = "false";
  }

  async draw() {
    const drawing = ++this.drawing;
    canvas.ariaBusy = "true";
    const is = (number) => $(number).valueAsNumber;
    if (!$("width").validity.valid || !$("height").validity.valid) {
      return say("Width and height are whole numbers from 1 to 4096");
    }
    const [width, height] = [is("width"), is("height")];
    const choice = (id) => Number($(id).value);
    resize(width, height);
    const start = performance.now();
    let [busy, slice, band] = [0, start, Math.min(8, height)];
    for (let y = 0; y < height; ) {
      const count = Math.min(band, height - y);
      const begun = performance.now();
      const at = this.wasm.draw(choice("scene"), choice("number"), choice("camera"), choice("format"),
        choice("smooth"), is("turn") / 72, width, height, y, count);
      if (!at) return say(`This can't be drawn: ${text(this.wasm, this.wasm.text())}`);
      context.putImageData(pixels(this.wasm, at, width, count), 0, y);
      const end = performance.now();
      busy += end - begun;
      if (end - begun < SLICE / 3) band *= 2;
      y += count;
      $("progress").value = y / height;
      if (end - slice > SLICE) {
        await nextFrame();
        if (drawing !== this.drawing) return;
        slice = performance.now();
      }
    }
    this.rate.count();
    const name = $("scene").selectedOptions[0].textContent;
    canvas.ariaLabel = `The scene ${name}`;
    $("save").disabled = false;
    canvas.ariaBusy = "false";
    say("Drawn in this browser");
    show({ "Drawn in": `${busy.toFixed(1)} ms`, "Frames/s": $("spin").checked ? this.rate.text : undefined });
    if (!$("spin").checked) return;
    await nextFrame();
    if (drawing !== this.drawing) return;
    $("turn").value = (is("turn") + 1) % 72;
    this.draw();
  }
}

// ---- Lines.

/** Shows what a line brings, until it is closed. */
class Receiving {
  rate = new Rate();
  begun = 0;
  took = Infinity;
  isOpen = true;

  static async open(write) {
    return new Receiving(await Line.open(module, write));
  }

  constructor(line) {
    this.line = line;
    this.recording = [];
    this.timer = setInterval(() => this.look(), 50);
    this.wait = "Waiting for a frame";
    say(this.wait);
    this.update();
  }

  /** Bytes from a line that does not wait. */
  take(bytes) {
    this.guard(() => {
      this.recording.push(bytes);
      for (const news of this.line.take(bytes)) this.note(news);
    });
  }

  /** Whatever goes wrong in here ends it, and is said. */
  guard(act) {
    try {
      if (this.isOpen) act();
    } catch (error) {
      this.stop();
      say(`The receiver failed: ${error.message}`);
    }
  }

  note(news) {
    const { width, height, frame, rows } = this.line.figures;
    if (news === STARTED) {
      this.begun = performance.now();
      resize(width, height);
      say("Receiving");
    } else if (news === COMPLETE) {
      this.took = performance.now() - this.begun;
      this.rate.count();
      this.paint();
      canvas.ariaLabel = `Frame ${frame}, ${width} by ${height} pixels`;
    } else if (news === SILENT) {
      say(`The sender has fallen silent. ${height - rows} of ${height} rows of frame ${frame} are missing`);
    }
  }

  look() {
    this.guard(() => {
      const news = this.line.tick();
      if (news) this.note(news);
      if (this.took > QUICK) this.paint();
      this.update();
    });
  }

  paint() {
    const image = this.line.image;
    if (image) context.putImageData(image, 0, 0);
  }

  update() {
    const figures = this.line.figures;
    const { width, height, frame, rows, complete, lost, bytes, packets, damaged, requests } = figures;
    if (bytes > 1000 && !packets) say("Bytes come, but no packet: is this the line's speed?");
    $("progress").value = height ? rows / height : 0;
    $("record").disabled = !this.recording.length;
    $("save").disabled = !width;
    show({
      "Frames": grouped(complete),
      "Frames/s": this.rate.text,
      "Frame": width ? `#${frame}` : "–",
      "Size": width ? `${width}×${height}` : "–",
      "Pixels": width ? FORMATS[figures.format] : "–",
      "Rows": `${rows}/${height}`,
      "Bytes": grouped(bytes),
      "Damaged packets": grouped(damaged),
      "Repairs asked for": grouped(requests),
      "Frames lost": grouped(lost),
    });
  }

  /** The line has ended by itself. */
  end(why) {
    if (!this.isOpen) return;
    const { height, rows, frame, complete } = this.line.figures;
    this.paint();
    this.update();
    this.stop();
    const missing = height - rows;
    say(missing ? `${why} in the middle of frame ${frame}: ${missing} of ${height} rows are missing`
      : height ? `${why} after ${grouped(complete)} complete frame${complete === 1 ? "" : "s"}`
      : `${why} before a frame began`);
  }

  stop() {
    this.isOpen = false;
    clearInterval(this.timer);
    this.close?.();
    this.close = undefined;
  }
}

async function playFile(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (chosenSource() !== "file") choose("file");
  current.stop();
  const receiving = current = await Receiving.open(() => {});
  $("replay").disabled = false;
  const pace = Number($("pace").value);
  const start = performance.now();
  try {
    for (let at = 0; at < bytes.length && receiving.isOpen; ) {
      // Ten bits a byte, with start and stop bit.
      const due = pace ? Math.trunc((performance.now() - start) * pace / 10_000) : at + 4096;
      const part = bytes.subarray(at, due);
      receiving.recording.push(part);
      at += part.length;
      for (const news of receiving.line.take(part)) {
        receiving.note(news);
        if (news === COMPLETE && !pace) await nextFrame();
        if (!receiving.isOpen) return;
      }
      if (pace) await nextFrame();
    }
    receiving.end("The recording ends");
  } catch (error) {
    receiving.guard(() => { throw error; });
  }
}

async function openSocket() {
  const address = $("address");
  if (!address.reportValidity()) return;
  current.stop();
  say(`Connecting to ${address.value}`);
  let socket;
  try {
    socket = new WebSocket(address.value);
  } catch (error) {
    return say(error.message);
  }
  socket.binaryType = "arraybuffer";
  const receiving = current = await Receiving.open((bytes) => {
    if (socket.readyState === WebSocket.OPEN) socket.send(bytes);
  });
  let wasOpen = socket.readyState === WebSocket.OPEN;
  say(wasOpen ? receiving.wait : `Connecting to ${address.value}`);
  socket.onopen = () => { wasOpen = true; say(receiving.wait); };
  socket.onmessage = ({ data }) => { if (data instanceof ArrayBuffer) receiving.take(new Uint8Array(data)); };
  socket.onclose = () => {
    if (wasOpen) return receiving.end("The connection was closed");
    if (!receiving.isOpen) return;
    receiving.stop();
    say(`Nothing answers at ${address.value}`);
  };
  receiving.close = () => { connected(undefined); socket.close(); };
  connected("open-socket");
}

async function openSerial() {
  const baud = $("baud");
  if (!baud.reportValidity()) return;
  current.stop();
  let port;
  try {
    port = await navigator.serial.requestPort();
    await port.open({ baudRate: baud.valueAsNumber, bufferSize: 1 << 16 });
  } catch (error) {
    return say(error.name === "NotFoundError" ? "No port was chosen" : `The port can't be opened: ${error.message}`);
  }
  const writer = port.writable.getWriter();
  const receiving = current = await Receiving.open((bytes) => writer.write(bytes).catch(() => {}));
  let reader;
  receiving.close = () => { connected(undefined); reader?.cancel().catch(() => {}); };
  connected("open-serial");
  let why = "The port was closed";
  while (port.readable && receiving.isOpen) {
    reader = port.readable.getReader();
    try {
      for (;;) {
        const { value, done } = await reader.read();
        if (done) break;
        receiving.take(value);
      }
      break;
    } catch (error) {
      // A break, a wrong parity bit or a full buffer: the port goes on, and what got lost is repaired.
      why = `The port is gone (${error.message})`;
    } finally {
      reader.releaseLock();
    }
  }
  receiving.end(why);
  writer.releaseLock();
  await port.close().catch(() => {});
}

/** Connect buttons become those that disconnect. */
function connected(button) {
  for (const id of ["open-serial", "open-socket"]) $(id).textContent = id === button ? "Disconnect" : "Connect";
}

function connectOr(open) {
  return ({ target }) => {
    if (target.textContent !== "Disconnect") return open();
    current.end("You disconnected");
  };
}

// ---- The page.

const chosenSource = () => document.querySelector("[name=source]:checked").value;

function choose(source) {
  document.querySelector(`[name=source][value=${source}]`).checked = true;
  for (const section of document.querySelectorAll("[data-source]")) {
    section.hidden = section.dataset.source !== source;
  }
  current.stop();
  current = { stop() {} };
  show({});
  $("progress").value = 0;
  $("record").disabled = $("save").disabled = true;
  context.clearRect(0, 0, canvas.width, canvas.height);
  canvas.ariaLabel = "No picture yet";
  if (source === "gallery") drawGallery();
  else say({ serial: "Not connected", file: "No recording yet", socket: "Not connected" }[source]);
}

let galleryModule;
function drawGallery() {
  $("about").textContent = $("scene").selectedOptions[0].title;
  // Pixels of one bit have no mean.
  $("smooth").disabled = $("format").value === "3";
  if (current instanceof Gallery) current.draw();
  else current = new Gallery(galleryModule);
}

function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function savePicture() {
  const name = current instanceof Receiving ? `frame-${current.line.figures.frame}`
    : $("scene").selectedOptions[0].textContent;
  canvas.toBlob((blob) => save(blob, `${name}.png`), "image/png");
}

async function start() {
  const bytes = atob($("module").textContent);
  module = await WebAssembly.compile(Uint8Array.from(bytes, (byte) => byte.charCodeAt(0)));
  galleryModule = (await WebAssembly.instantiate(module, {})).exports;
  const scenes = text(galleryModule, galleryModule.scenes());
  $("scene").append(...scenes.split("\n").map((line, index) => {
    const [name, about] = line.split("\t");
    const option = new Option(name, index);
    option.title = about;
    return option;
  }));
  $("no-serial").hidden = "serial" in navigator;
  $("open-serial").disabled = !("serial" in navigator);
  for (const radio of document.querySelectorAll("[name=source]")) {
    radio.addEventListener("change", () => choose(radio.value));
  }
  document.querySelector("[data-source=gallery]").addEventListener("input", drawGallery);
  $("open-serial").addEventListener("click", connectOr(openSerial));
  $("open-socket").addEventListener("click", connectOr(openSocket));
  $("controls").addEventListener("submit", (event) => event.preventDefault());
  const replay = () => { if ($("file").files[0]) playFile($("file").files[0]); };
  $("file").addEventListener("change", replay);
  $("replay").addEventListener("click", replay);
  $("save").addEventListener("click", savePicture);
  $("record").addEventListener("click", () => save(new Blob(current.recording), "recording.bin"));
  addEventListener("resize", () => resize(canvas.width, canvas.height));
  for (const kind of ["dragover", "dragleave", "drop"]) {
    addEventListener(kind, (event) => {
      event.preventDefault();
      document.body.classList.toggle("dropping", kind === "dragover");
      if (kind !== "drop" || !event.dataTransfer.files[0]) return;
      $("file").files = event.dataTransfer.files;
      playFile($("file").files[0]);
    });
  }
  choose("gallery");
}

start().catch((error) => say(`This page can't start: ${error.message}`));
