// Boots a firmware in an emulator of the RP2040, and writes what came through the serial port: a frame, which
// is acknowledged, or so many bytes.
//
//     npm install rp2040js
//     node boot.mjs target/thumbv6m-none-eabi/release/rp2040 line.bin
//     cargo run --release --example view -- --replay line.bin --out pico.png   # in the repository's root
//
//     node boot.mjs target/thumbv6m-none-eabi/release/rtic part.pgm 19215

import fs from 'node:fs';
import { createRequire } from 'node:module';
import zlib from 'node:zlib';

const require = createRequire(process.env.NODE_MODULES_OF ?? import.meta.url);
const { RP2040 } = require('rp2040js');
const [elf, out, enough] = process.argv.slice(2);
if (!elf || !out) {
  console.error('usage: node boot.mjs FIRMWARE.elf LINE.bin [BYTES]');
  process.exit(2);
}

const FLASH = 0x10000000;
const VECTORS = FLASH + 0x100;
// Of a cycle. DMA goes by the clock.
const NANOSECONDS = 8;
// A frame takes some forty million; what needs more hangs.
const MOST = 400e6;

const mcu = new RP2040();
mcu.logger = { debug() {}, info() {}, warn() {}, error: console.error };

// The segments of the ELF file that are in flash.
const file = fs.readFileSync(elf);
const programs = file.readUInt32LE(28);
for (let i = 0; i < file.readUInt16LE(44); i++) {
  const at = programs + 32 * i;
  const [kind, offset, , address, size] = [0, 4, 8, 12, 16].map((o) => file.readUInt32LE(at + o));
  if (kind === 1 && address >= FLASH && address < FLASH + mcu.flash.length) mcu.flash.set(file.subarray(offset, offset + size), address - FLASH);
}
const vector = (index) => new DataView(mcu.flash.buffer, mcu.flash.byteOffset).getUint32(VECTORS - FLASH + 4 * index, true);
const core = mcu.core0 ?? mcu.core;
core.VTOR = VECTORS;
core.SP = vector(0);
core.PC = vector(1) & ~1;

// Contents of a packet without its COBS frame, and with it.
const unframed = (bytes) => {
  const contents = [];
  for (let at = 0; at < bytes.length; at += bytes[at]) {
    if (at > 0) contents.push(0);
    contents.push(...bytes.slice(at + 1, at + bytes[at]));
  }
  return Buffer.from(contents);
};
const framed = (contents) => {
  const crc = Buffer.alloc(4);
  crc.writeUInt32LE(zlib.crc32(contents));
  const frame = [0];
  let code = 0;
  for (const byte of [...contents, ...crc, 0]) {
    if (byte === 0) {
      frame[code] = frame.length - code;
      code = frame.length;
    }
    frame.push(byte);
  }
  return [0, ...frame.slice(0, -1), 0];
};

const line = [];
let packet = [];
let answer = [];
let acknowledged = false;
let done = false;
mcu.uart[0].onByte = (byte) => {
  if (enough) {
    done = line.push(byte) >= enough;
    return;
  }
  if (acknowledged && byte !== 0) done = true; // the next frame begins
  line.push(byte);
  if (byte !== 0) return packet.push(byte);
  const contents = unframed(packet);
  packet = [];
  // The end of a frame: acknowledge it.
  if (contents[0] === 0x03) answer = framed(Buffer.from([0x82, contents[1], contents[2]]));
};

let count = 0;
const start = Date.now();
for (; !done && count < MOST; count++) {
  mcu.clock.tick(core.executeInstruction() * NANOSECONDS);
  if (answer.length > 0 && count % 2000 === 0) {
    mcu.uart[0].feedByte(answer.shift());
    acknowledged = answer.length === 0;
  }
}
fs.writeFileSync(out, Buffer.from(line));
console.log(`${line.length} bytes after ${(count / 1e6).toFixed(1)} million instructions, ${Date.now() - start} ms`);
process.exit(done ? 0 : 1);
