//! One row of symbols as decisions.
//!
//! A symbol is predicted from W (its left neighbour), N (the one above), NW, NE and NEE (above, one and two to
//! the right). Outside the row, W is N in the first column, and what is above beyond the last column is the
//! row's last symbol. In the first row of a payload there is nothing above: NW is W, N and NE carry on the
//! change from the pixel before W to W, and NEE is 0.
//!
//! 1. Where W = N = NW = NE, a run of up to 16 pixels is asked for that are like the pixel at the left.
//! 2. Otherwise: is the symbol as predicted? The prediction is the plane W + N − NW on a smooth surface, and
//!    at an edge the median of W, N and that (the predictor MED of LOCO-I: M. Weinberger, G. Seroussi,
//!    G. Sapiro, IEEE Transactions on Image Processing 9(8), 2000).
//! 3. If not, it is close to the prediction, or a neighbour's symbol, or far off, or the pixel has no symbol.

use super::alphabet::{Alphabet, Channels};
use super::model::{
    CHANNEL, CLASSES, ESCAPE, FLAT, JUMP, LARGE, NEAR, NEIGHBOR, SIGN, SIGNED, SMALL, Slot, ZERO,
};
use super::range::Bins;

/// The longest run.
const RUN: usize = 16;
/// Shorter runs are asked pixel by pixel.
const SHORTEST_RUN: usize = 4;
/// Gradients smaller than this are a smooth surface.
const SMOOTH: i32 = 16;
/// The largest small error.
const LIMIT: u32 = 4;

/// A row of pixels to be read, or to be written.
pub(crate) trait Line<P> {
    /// The pixel in a column, if pixels are read.
    fn get(&self, x: usize) -> Option<P>;

    /// Whether these columns are read and hold this pixel.
    fn holds(&self, from: usize, to: usize, pixel: P) -> bool;

    /// Sets these columns, if pixels are written.
    fn fill(&mut self, from: usize, to: usize, pixel: P);
}

/// What is known of a symbol that isn't as predicted.
struct Place {
    guess: i32,
    /// N, W, NE and NEE.
    near: [i32; 4],
    /// The context of gradients, and whether signs are turned around in it.
    gradients: usize,
    flip: bool,
    /// Twice the activity, and whether the last error was large.
    activity: usize,
}

/// What is known at the start of a row.
#[derive(Clone, Copy)]
pub(crate) struct Start<P> {
    /// The pixel that stands for the one at the left of the first: the one above it, or that of symbol 0.
    pub(crate) left: P,
    /// Whether the row is the first of its payload.
    pub(crate) is_first: bool,
}

/// Codes a row as wide as `above`, which holds the symbols of the row above and then those of this one.
pub(crate) fn code<C: Bins, A: Alphabet>(
    coder: &mut C,
    alphabet: &mut A,
    above: &mut [A::Symbol],
    line: &mut impl Line<A::Pixel>,
    start: Start<A::Pixel>,
) {
    let Start { left: mut pixel, is_first } = start;
    let (width, top) = (above.len(), alphabet.top());
    // Of the first row's gradients only d2 isn't 0, so it has 3 contexts.
    let contexts = if is_first { 63 } else { 0 };
    let (mut w, mut n, mut nw, mut ne) = (0, 0, 0, 0);
    if !is_first {
        n = recall::<A>(above, 0, 0);
        (w, nw, ne) = (n, n, recall::<A>(above, 1, n));
    }
    let mut last = 0;
    let mut x = 0;
    while x < width {
        let mut nee = if is_first { 0 } else { recall::<A>(above, x + 2, ne) };
        let symbol;
        if w == n && n == nw && nw == ne {
            let context = FLAT + usize::from(w == 0) + 2 * usize::from(is_first);
            let run = flat::<A>(above, x, w, is_first);
            let mut is_same = false;
            if run >= SHORTEST_RUN {
                let end = x + run;
                if coder.bin(context, line.holds(x, end, pixel)) {
                    line.fill(x, end, pixel);
                    if is_first {
                        above.iter_mut().take(end).skip(x).for_each(|kept| *kept = A::kept(w));
                    } else {
                        n = recall::<A>(above, end, w);
                        ne = recall::<A>(above, end + 1, n);
                    }
                    last = 0;
                    x = end;
                    continue;
                }
                // One of them differs: the last, if all others don't.
                let from = x;
                while x + 1 < end && coder.bin(context + 4, line.holds(x, x + 1, pixel)) {
                    x += 1;
                }
                line.fill(from, x, pixel);
                if is_first {
                    above.iter_mut().take(x).skip(from).for_each(|kept| *kept = A::kept(w));
                } else {
                    ne = recall::<A>(above, x + 1, w);
                    nee = recall::<A>(above, x + 2, ne);
                }
            } else {
                is_same = coder.bin(context + 8, line.holds(x, x + 1, pixel));
            }
            if is_same {
                symbol = w;
            } else {
                let near = [w, w, ne, nee];
                let place = Place { guess: w, near, gradients: 0, flip: false, activity: 0 };
                (symbol, pixel) = other(coder, alphabet, line.get(x), &place, top);
            }
            last = symbol - w;
        } else {
            let (d1, d2, d3) = (w - nw, nw - n, n - ne);
            let guess =
                if is_smooth(d1) && is_smooth(d2) { (w - d2).clamp(0, top) } else { med(w, n, nw) };
            let signed = level(d1) * 25 + level(d3) * 5 + level(d2);
            let flip = signed < 0;
            let gradients = signed.unsigned_abs() as usize + contexts;
            let turn = if last == 0 { 0 } else { 1 + usize::from((last < 0) != flip) };
            let known = line.get(x).map(|pixel| (pixel, alphabet.symbol(pixel)));
            let is_guess = known.is_some_and(|(_, symbol)| symbol == (guess, true));
            if coder.bin(ZERO + gradients * 3 + turn, is_guess) {
                symbol = guess;
                pixel = match known {
                    Some((pixel, _)) => pixel,
                    None => alphabet.pixel(symbol),
                };
            } else {
                let steepest = d1.abs().max(d2.abs()).max(d3.abs());
                let activity = 2 * size(steepest) + usize::from(last.abs() > 1);
                let near = [n, w, ne, nee];
                let place = Place { guess, near, gradients, flip, activity };
                (symbol, pixel) = other(coder, alphabet, line.get(x), &place, top);
            }
            last = symbol - guess;
        }
        line.fill(x, x + 1, pixel);
        if let Some(kept) = above.get_mut(x) {
            *kept = A::kept(symbol);
        }
        x += 1;
        if is_first {
            let change = symbol - w;
            n = if is_smooth(change) { (symbol + change).clamp(0, top) } else { symbol };
            (nw, ne) = (symbol, n);
        } else {
            (nw, n, ne) = (n, ne, nee);
        }
        w = symbol;
    }
}

/// The symbol of the row above in a column, or beyond the row the one before it.
#[inline(always)]
fn recall<A: Alphabet>(above: &[A::Symbol], x: usize, before: i32) -> i32 {
    above.get(x).map_or(before, |symbol| (*symbol).into())
}

/// How many columns from here on, at most [`RUN`], have this symbol at their upper right.
#[inline(always)]
fn flat<A: Alphabet>(above: &[A::Symbol], x: usize, symbol: i32, is_first: bool) -> usize {
    let left = above.len() - x;
    if is_first {
        return left.min(RUN);
    }
    let right = above.get(x + 1..).unwrap_or_default();
    let run = right.iter().take(RUN).take_while(|kept| (**kept).into() == symbol).count();
    // What is beyond the row is like its last column.
    if run + 1 == left { left.min(RUN) } else { run }
}

/// Whether a gradient is smaller than [`SMOOTH`].
#[inline(always)]
fn is_smooth(gradient: i32) -> bool {
    // One comparison, where the absolute value isn't needed otherwise.
    ((gradient + (SMOOTH - 1)) as u32) < 2 * SMOOTH as u32 - 1
}

/// Five levels of a gradient.
#[inline(always)]
fn level(gradient: i32) -> i32 {
    gradient.clamp(-2, 2)
}

/// Four levels of an absolute gradient.
#[inline(always)]
fn size(gradient: i32) -> usize {
    usize::from(gradient > 0) + usize::from(gradient > 1) + usize::from(gradient > 4)
}

/// The median of W, N and W + N − NW.
#[inline(always)]
fn med(w: i32, n: i32, nw: i32) -> i32 {
    let (low, high) = (w.min(n), w.max(n));
    (w + n - nw).clamp(low, high)
}

/// A pixel whose symbol is not as predicted, or that has none.
#[inline(never)]
fn other<C: Bins, A: Alphabet>(
    coder: &mut C,
    alphabet: &mut A,
    pixel: Option<A::Pixel>,
    place: &Place,
    top: i32,
) -> (i32, A::Pixel) {
    let Place { guess, near, gradients, flip, activity } = *place;
    let (symbol, is_exact) = pixel.map_or((0, true), |pixel| alphabet.symbol(pixel));
    let off = symbol - guess;
    let is_escape = A::ESCAPES && (!is_exact || off == 0);
    let size = off.unsigned_abs();
    let is_far = coder.bin(JUMP + activity, is_escape || size > LIMIT);
    if is_far {
        if A::ESCAPES && coder.bin(ESCAPE, is_escape) {
            return escape(coder, alphabet, pixel, guess, off, top);
        }
        for (i, candidate) in near.into_iter().enumerate() {
            let known = near.iter().take(i).any(|before| *before == candidate);
            if known || candidate.abs_diff(guess) <= LIMIT {
                continue;
            }
            if coder.bin(NEIGHBOR + activity / 2 * 4 + i, candidate == symbol) {
                return (candidate, pixel.unwrap_or_else(|| alphabet.pixel(candidate)));
            }
        }
    }
    let is_minus = coder.bin(SIGN + gradients, (off < 0) != flip) != flip;
    let size = if is_far {
        LIMIT + 1 + number(coder, LARGE, size.wrapping_sub(LIMIT + 1))
    } else {
        let slot = SMALL + activity * 3 - 1;
        let mut known = 1;
        while known < LIMIT && coder.bin(slot + known as usize, size > known) {
            known += 1;
        }
        known
    };
    let size = size as i32;
    let symbol = (if is_minus { guess - size } else { guess + size }).clamp(0, top);
    (symbol, pixel.unwrap_or_else(|| alphabet.pixel(symbol)))
}

/// A pixel that no chain has: the symbol of a near one, and what the channels differ by.
#[cold]
#[inline(never)]
fn escape<C: Bins, A: Alphabet>(
    coder: &mut C,
    alphabet: &mut A,
    pixel: Option<A::Pixel>,
    guess: i32,
    off: i32,
    top: i32,
) -> (i32, A::Pixel) {
    let symbol = (guess + signed(coder, NEAR, off)).clamp(0, top);
    let mut channels = alphabet.pixel(symbol).channels();
    let wanted = pixel.map_or(channels, Channels::channels);
    for (i, (channel, wanted)) in channels.iter_mut().zip(wanted).enumerate() {
        *channel += signed(coder, CHANNEL + i * SIGNED, wanted - *channel);
    }
    (symbol, pixel.unwrap_or_else(|| A::Pixel::with_channels(channels)))
}

/// A number with a sign.
fn signed<C: Bins>(coder: &mut C, slot: Slot, value: i32) -> i32 {
    if coder.bin(slot, value == 0) {
        return 0;
    }
    let is_minus = coder.bin(slot + 1, value < 0);
    let size = 1 + number(coder, slot + 2, value.unsigned_abs().wrapping_sub(1)) as i32;
    if is_minus { -size } else { size }
}

/// A number below 2¹⁷ − 1, in an Exp-Golomb code: how many bits the next larger one has behind its first,
/// and these.
fn number<C: Bins>(coder: &mut C, slot: Slot, value: u32) -> u32 {
    let value = value.wrapping_add(1);
    let width = value.checked_ilog2().unwrap_or(0);
    let mut bits = 0;
    while bits < 16 && coder.bin(slot + CLASSES.min(bits as usize + 1) - 1, width > bits) {
        bits += 1;
    }
    (0..bits).rev().fold(1, |read, bit| read << 1 | u32::from(coder.even(value >> bit & 1 == 1)))
        - 1
}
