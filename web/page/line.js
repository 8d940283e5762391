"use strict";

// The receiver's news, by their numbers: see `News` in view.rs.
const STARTED = 1, COMPLETE = 2, SILENT = 3;

/** A line with a receiver of its own at this end. */
class Line {
  /** `write` takes the bytes of an answer to the sender. */
  static async open(module, write) {
    const instance = await WebAssembly.instantiate(module, {});
    return new Line(instance.exports, write);
  }

  constructor(wasm, write) {
    Object.assign(this, { wasm, write });
  }

  /** Takes in bytes that the line brought, and yields the news. */
  *take(bytes) {
    const size = 1 << 16;
    for (let start = 0; start < bytes.length; start += size) {
      const part = bytes.subarray(start, start + size);
      memory(this.wasm, this.wasm.input(part.length), part.length).set(part);
      for (let news = -1; news; ) {
        news = this.wasm.receive(now());
        this.reply();
        if (news) yield news;
      }
    }
  }

  /** Looks at the clock; call it some times a second. */
  tick() {
    const news = this.wasm.tick(now());
    this.reply();
    return news;
  }

  reply() {
    for (let length; (length = this.wasm.answer()); ) {
      this.write(memory(this.wasm, this.wasm.answer_at(), length).slice());
    }
  }

  /** What has come so far. */
  get figures() {
    const names = ["width", "height", "format", "frame", "rows", "complete", "lost", "bytes", "packets",
      "damaged", "requests"];
    return Object.fromEntries(names.map((name, index) => [name, this.wasm.figure(index)]));
  }

  /** The last frame, or what there is of it; null if none has begun. */
  get image() {
    const { width, height } = this.figures;
    if (!width) return null;
    return pixels(this.wasm, this.wasm.received(), width, height);
  }
}

/** A module's memory, until the module is called again: that may move it. */
const memory = (wasm, at, length) => new Uint8Array(wasm.memory.buffer, at, length);

/** A text in a module's memory. */
const text = (wasm, length) => new TextDecoder().decode(memory(wasm, wasm.text_at(), length));

/** Pixels in a module's memory, for as long. */
const pixels = (wasm, at, width, height) =>
  new ImageData(new Uint8ClampedArray(wasm.memory.buffer, at, 4 * width * height), width, height);

/** Milliseconds that wrap around. */
const now = () => Math.trunc(performance.now()) >>> 0;
