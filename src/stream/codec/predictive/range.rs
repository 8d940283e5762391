//! A binary range coder: decisions into bytes, and back.
//!
//! It keeps the first and the last 32-bit number of an interval, and takes in each decision the lower or the
//! upper part of it. Bytes in which both bounds agree are written, so there is no carry (as in the coders of
//! M. Mahoney's PAQ). A decision costs one multiplication and no division.

use super::model::{Model, SLOTS, Slot};

/// Makes decisions one after the other: an encoder writes the ones that it is given, a decoder reads them.
pub(crate) trait Bins {
    /// A decision with an adaptive probability. An encoder returns `bit`; a decoder ignores it.
    fn bin(&mut self, slot: Slot, bit: bool) -> bool;

    /// A decision that is as likely as not, and stays so.
    fn even(&mut self, bit: bool) -> bool;
}

/// Half of all, in 4096ths.
const EVEN: u32 = 2048;

/// The interval, and how many bytes are settled: what an encoder is between two rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Interval {
    low: u32,
    high: u32,
    len: usize,
}

impl Interval {
    /// Memory only, and all zeros: a sender is made of zeros in its place then.
    pub(crate) const EMPTY: Self = Self { low: 0, high: 0, len: 0 };

    /// All numbers, and no bytes.
    pub(crate) const ALL: Self = Self { low: 0, high: u32::MAX, len: 0 };

    /// Takes the lower part, `one` 4096ths of it, or the upper part.
    #[inline(always)]
    fn middle(&self, one: u32) -> u32 {
        self.low + ((self.high - self.low) >> 12) * one
    }

    #[inline(always)]
    fn take(&mut self, middle: u32, bit: bool) {
        if bit {
            self.high = middle;
        } else {
            self.low = middle + 1;
        }
    }

    #[inline(always)]
    fn is_settled(&self) -> bool {
        (self.low ^ self.high) >> 24 == 0
    }

    /// Drops the first byte, in which both bounds agree.
    fn shift(&mut self) -> u8 {
        let byte = (self.high >> 24) as u8;
        self.low <<= 8;
        self.high = self.high << 8 | 0xFF;
        self.len += 1;
        byte
    }

    /// The fewest bytes that put the payload's number, zeros behind them, into the interval.
    fn ending(&self) -> ([u8; 4], usize) {
        // The shortest prefix of a number in it: low itself, or rounded up to fewer bytes.
        let fits = |kept: &u32| {
            let below = u32::MAX.checked_shr(8 * kept).unwrap_or(0);
            self.low.checked_add(below).is_some_and(|up| up & !below <= self.high)
        };
        let kept = (0..4).find(fits).unwrap_or(4);
        let below = u32::MAX.checked_shr(8 * kept).unwrap_or(0);
        ((self.low.saturating_add(below) & !below).to_be_bytes(), kept as usize)
    }

    /// Ends the payload in `out`. Returns its length.
    pub(crate) fn finish(&self, out: &mut [u8]) -> usize {
        let (bytes, kept) = self.ending();
        let rest = out.get_mut(self.len..).unwrap_or_default();
        rest.iter_mut().zip(bytes).take(kept).for_each(|(to, byte)| *to = byte);
        self.len + kept
    }
}

/// Writes decisions.
pub(crate) struct Encoder<'a, const N: usize = SLOTS> {
    model: &'a mut Model<N>,
    interval: Interval,
    out: &'a mut [u8],
}

impl<'a, const N: usize> Encoder<'a, N> {
    /// Goes on where an encoder was.
    pub(crate) fn resume(model: &'a mut Model<N>, interval: Interval, out: &'a mut [u8]) -> Self {
        Self { model, interval, out }
    }

    /// Where the encoder is, if all its decisions fit, with the bytes that end them.
    pub(crate) fn fits(&self) -> Option<Interval> {
        let len = self.interval.len + self.interval.ending().1;
        (len <= self.out.len()).then_some(self.interval)
    }

    #[inline(always)]
    fn take(&mut self, middle: u32, bit: bool) {
        self.interval.take(middle, bit);
        if self.interval.is_settled() {
            self.shift();
        }
    }

    /// A decision with an adaptive probability. What the caller knows isn't handed back: that would take
    /// one instruction in ten.
    #[inline(never)]
    fn adapt(&mut self, slot: Slot, bit: bool) {
        let probability = self.model.of(slot);
        let middle = self.interval.middle(probability.yes());
        probability.learn(bit);
        self.take(middle, bit);
    }

    /// Once in eight bits of payload, so it isn't inlined.
    #[cold]
    #[inline(never)]
    fn shift(&mut self) {
        while self.interval.is_settled() {
            let at = self.interval.len;
            let byte = self.interval.shift();
            if let Some(to) = self.out.get_mut(at) {
                *to = byte;
            }
        }
    }
}

impl<const N: usize> Bins for Encoder<'_, N> {
    #[inline(always)]
    fn bin(&mut self, slot: Slot, bit: bool) -> bool {
        self.adapt(slot, bit);
        bit
    }

    fn even(&mut self, bit: bool) -> bool {
        self.take(self.interval.middle(EVEN), bit);
        bit
    }
}

/// Reads decisions. Zeros follow the payload's last byte.
pub(crate) struct Decoder<'a, const N: usize = SLOTS> {
    model: &'a mut Model<N>,
    interval: Interval,
    value: u32,
    /// The bytes of the payload, and those that haven't been read.
    len: usize,
    rest: core::slice::Iter<'a, u8>,
}

impl<'a, const N: usize> Decoder<'a, N> {
    pub(crate) fn new(model: &'a mut Model<N>, payload: &'a [u8]) -> Self {
        let (len, rest) = (payload.len(), payload.iter());
        let mut new = Self { model, interval: Interval::ALL, value: 0, len, rest };
        (0..4).for_each(|_| new.next());
        new
    }

    /// Whether the payload has just the bytes that an encoder writes for these decisions.
    pub(crate) fn is_exact(&self) -> bool {
        self.len == self.interval.len + self.interval.ending().1
    }

    fn next(&mut self) {
        let byte = self.rest.next().copied().unwrap_or(0);
        self.value = self.value << 8 | u32::from(byte);
    }

    #[inline(always)]
    fn take(&mut self, middle: u32, bit: bool) {
        self.interval.take(middle, bit);
        if self.interval.is_settled() {
            self.shift();
        }
    }

    #[cold]
    #[inline(never)]
    fn shift(&mut self) {
        while self.interval.is_settled() {
            self.interval.shift();
            self.next();
        }
    }
}

impl<const N: usize> Bins for Decoder<'_, N> {
    #[inline(never)]
    fn bin(&mut self, slot: Slot, _: bool) -> bool {
        let probability = self.model.of(slot);
        let middle = self.interval.middle(probability.yes());
        let bit = self.value <= middle;
        probability.learn(bit);
        self.take(middle, bit);
        bit
    }

    fn even(&mut self, _: bool) -> bool {
        let middle = self.interval.middle(EVEN);
        let bit = self.value <= middle;
        self.take(middle, bit);
        bit
    }
}
