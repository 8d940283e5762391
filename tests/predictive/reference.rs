//! The decoder once more, written from its description as plainly as can be: tables of all pixels, rows as
//! lists, 64-bit arithmetic. It takes nothing from the coder; the start table is that of the description.

use std::iter::{Copied, repeat_n};
use std::slice::Iter;

const DESCRIPTION: &str = include_str!("../../docs/link_rows.md");

/// The start table.
fn start_table() -> impl Iterator<Item = u64> {
    let (_, rest) = DESCRIPTION.split_once("in hexadecimal:\n\n```text\n").unwrap();
    let (table, _) = rest.split_once("```").unwrap();
    let digits: Vec<u64> =
        table.chars().filter_map(|digit| digit.to_digit(16)).map(u64::from).collect();
    digits.chunks_exact(2).map(|pair| pair[0] * 16 + pair[1]).collect::<Vec<_>>().into_iter()
}

/// A pixel's channels.
pub(super) type Pixel = Vec<i64>;

pub(super) struct Reference<'a> {
    probabilities: Vec<u64>,
    bytes: Copied<Iter<'a, u8>>,
    low: u64,
    high: u64,
    value: u64,
    /// The pixels of all symbols.
    symbols: &'a [Pixel],
    /// The largest value of each channel.
    most: &'a [i64],
    left: Pixel,
    above: Option<Vec<i64>>,
}

impl<'a> Reference<'a> {
    pub(super) fn new(payload: &'a [u8], symbols: &'a [Pixel], most: &'a [i64]) -> Self {
        let probabilities = start_table().map(|start| start * 256 + 128).collect();
        let (bytes, left) = (payload.iter().copied(), symbols[0].clone());
        let (low, high, value, above) = (0, 0xFFFF_FFFF, 0, None);
        let mut new = Self { probabilities, bytes, low, high, value, symbols, most, left, above };
        (0..4).for_each(|_| new.read());
        new
    }

    fn read(&mut self) {
        self.value = self.value % (1 << 24) * 256 + u64::from(self.bytes.next().unwrap_or(0));
    }

    fn split(&mut self, yes: u64) -> bool {
        let middle = self.low + (self.high - self.low) / 4096 * yes;
        let bit = self.value <= middle;
        if bit {
            self.high = middle;
        } else {
            self.low = middle + 1;
        }
        while self.low / (1 << 24) == self.high / (1 << 24) {
            self.low = self.low % (1 << 24) * 256;
            self.high = self.high % (1 << 24) * 256 + 255;
            self.read();
        }
        bit
    }

    fn bin(&mut self, slot: usize) -> bool {
        let probability = self.probabilities[slot];
        let bit = self.split((probability / 16) | 1);
        self.probabilities[slot] = if bit {
            probability + (65535 - probability) / 16
        } else {
            probability - probability / 16
        };
        bit
    }

    fn number(&mut self, slot: usize) -> i64 {
        let mut bits = 0;
        while bits < 16 && self.bin(slot + bits.min(7)) {
            bits += 1;
        }
        (0..bits).fold(1, |value, _| 2 * value + i64::from(self.split(2048))) - 1
    }

    fn signed(&mut self, slot: usize) -> i64 {
        if self.bin(slot) {
            return 0;
        }
        let sign = if self.bin(slot + 1) { -1 } else { 1 };
        sign * (1 + self.number(slot + 2))
    }

    fn clamped(&self, symbol: i64) -> i64 {
        symbol.clamp(0, self.symbols.len() as i64 - 1)
    }

    fn pixel(&self, symbol: i64) -> Pixel {
        self.symbols[symbol as usize].clone()
    }

    fn other(
        &mut self,
        guess: i64,
        near: [i64; 4],
        [gradients, activity]: [usize; 2],
        flip: bool,
    ) -> (i64, Pixel) {
        let is_far = self.bin(276 + activity);
        if is_far {
            if self.most.len() > 1 && self.bin(332) {
                let off = self.signed(333);
                let symbol = self.clamped(guess + off);
                let mut pixel = self.pixel(symbol);
                for (i, channel) in pixel.iter_mut().enumerate() {
                    *channel = (*channel + self.signed(343 + 10 * i)).clamp(0, self.most[i]);
                }
                return (symbol, pixel);
            }
            for i in 0..4 {
                let is_new = !near[..i].contains(&near[i]) && (near[i] - guess).abs() > 4;
                if is_new && self.bin(308 + activity / 2 * 4 + i) {
                    return (near[i], self.pixel(near[i]));
                }
            }
        }
        let is_minus = self.bin(210 + gradients) != flip;
        let size = if is_far {
            5 + self.number(324)
        } else {
            let mut size = 1;
            while size < 4 && self.bin(284 + 3 * activity + size - 1) {
                size += 1;
            }
            size as i64
        };
        let symbol = self.clamped(if is_minus { guess - size } else { guess + size });
        (symbol, self.pixel(symbol))
    }

    pub(super) fn row(&mut self, width: usize) -> Vec<Pixel> {
        let is_first = self.above.is_none();
        let above = self.above.take().unwrap_or(vec![0; width]);
        let at = |x: usize| *above.get(x).unwrap_or(&above[width - 1]);
        let (mut symbols, mut pixels) = (Vec::new(), Vec::<Pixel>::new());
        let [mut w, mut n, mut nw, mut ne, mut last] = [at(0), at(0), at(0), at(1), 0];
        let mut pixel = self.left.clone();
        while pixels.len() < width {
            let symbol;
            if [n, nw, ne] == [w; 3] {
                let context = usize::from(w == 0) + 2 * usize::from(is_first);
                let x = pixels.len();
                let most = (width - x).min(16);
                let run = (0..most).find(|i| !is_first && at(x + i + 1) != w).unwrap_or(most);
                let mut same = 0;
                if run < 4 {
                    same = usize::from(self.bin(8 + context));
                } else if self.bin(context) {
                    same = run;
                } else {
                    while same + 1 < run && self.bin(4 + context) {
                        same += 1;
                    }
                }
                symbols.extend(repeat_n(w, same));
                pixels.extend(repeat_n(pixel.clone(), same));
                last = 0;
                let x = x + same;
                if !is_first {
                    (n, ne) = (at(x), at(x + 1));
                }
                if same == run || run < 4 && same == 1 {
                    continue;
                }
                let near = [w, w, ne, if is_first { 0 } else { at(x + 2) }];
                (symbol, pixel) = self.other(w, near, [0, 0], false);
                last = symbol - w;
            } else {
                let x = pixels.len();
                let (d1, d2, d3) = (w - nw, nw - n, n - ne);
                let guess = if d1.abs() < 16 && d2.abs() < 16 {
                    self.clamped(w + n - nw)
                } else {
                    let mut three = [w, n, w + n - nw];
                    three.sort_unstable();
                    three[1]
                };
                let level = |d: i64| d.clamp(-2, 2);
                let signed = 25 * level(d1) + 5 * level(d3) + level(d2);
                let gradients = signed.unsigned_abs() as usize + if is_first { 63 } else { 0 };
                let turn = match last.signum() * if signed < 0 { -1 } else { 1 } {
                    0 => 0,
                    1 => 1,
                    _ => 2,
                };
                if self.bin(12 + 3 * gradients + turn) {
                    (symbol, pixel) = (guess, self.pixel(guess));
                } else {
                    let steepest = d1.abs().max(d2.abs()).max(d3.abs());
                    let activity = match steepest {
                        0 => 0,
                        1 => 1,
                        2..=4 => 2,
                        _ => 3,
                    };
                    let activity = 2 * activity + usize::from(last.abs() > 1);
                    let near = [n, w, ne, if is_first { 0 } else { at(x + 2) }];
                    (symbol, pixel) = self.other(guess, near, [gradients, activity], signed < 0);
                }
                last = symbol - guess;
            }
            symbols.push(symbol);
            pixels.push(pixel.clone());
            let x = pixels.len();
            if is_first {
                let change = symbol - w;
                n = if change.abs() < 16 { self.clamped(symbol + change) } else { symbol };
                (nw, ne) = (symbol, n);
            } else {
                (nw, n, ne) = (at(x - 1), at(x), at(x + 1));
            }
            w = symbol;
        }
        self.left = pixels[0].clone();
        self.above = Some(symbols);
        pixels
    }
}
