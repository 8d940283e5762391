//! The adaptive probabilities: which decisions there are, and how they learn.

/// The number of a probability.
pub(crate) type Slot = usize;

/// Is a run, or a pixel, as the one at its left? Three kinds of question, each with 4 contexts.
pub(crate) const FLAT: Slot = 0;
/// Is the symbol as predicted? 66 contexts of gradients with 3 of the last error's sign.
pub(crate) const ZERO: Slot = FLAT + 3 * 4;
/// The error's sign: 66 contexts of gradients.
pub(crate) const SIGN: Slot = ZERO + GRADIENTS * 3;
/// Is it far from the prediction? 4 activities, and whether the last error was large.
pub(crate) const JUMP: Slot = SIGN + GRADIENTS;
/// Sizes of small errors: the same contexts, 3 steps each.
pub(crate) const SMALL: Slot = JUMP + 4 * 2;
/// Is it a neighbour's symbol? 4 activities, 4 neighbours.
pub(crate) const NEIGHBOR: Slot = SMALL + 4 * 2 * 3;
/// Sizes of large errors.
pub(crate) const LARGE: Slot = NEIGHBOR + 4 * 4;
/// Is the pixel in none of the chains?
pub(crate) const ESCAPE: Slot = LARGE + CLASSES;
/// The near symbol of such a pixel.
pub(crate) const NEAR: Slot = ESCAPE + 1;
/// What its three channels differ by.
pub(crate) const CHANNEL: Slot = NEAR + SIGNED;
/// How many there are.
pub(crate) const SLOTS: usize = CHANNEL + 3 * SIGNED;

/// Contexts of gradients: 63 in general, and 3 in a payload's first row.
const GRADIENTS: usize = 63 + 3;
/// Slots of the size of a number.
pub(crate) const CLASSES: usize = 8;
/// Slots of a number with a sign: whether it is zero, its sign, its size.
pub(crate) const SIGNED: usize = 2 + CLASSES;

/// How quickly probabilities adapt: by 1/16 of what they are off.
const RATE: u32 = 4;

/// The probability that each decision is a yes, in 65536ths.
#[derive(Debug, Clone)]
pub(crate) struct Model<const N: usize = SLOTS>([u16; N]);

impl<const N: usize> Model<N> {
    /// Memory only: a payload begins with [`restart`](Self::restart).
    pub(crate) const EMPTY: Self = Self([0; N]);

    /// Takes these probabilities, in 256ths, in its place.
    pub(crate) const fn restart(&mut self, start: &[u8; N]) {
        let (mut slots, mut start) = (self.0.as_mut_slice(), start.as_slice());
        while let ([slot, others @ ..], [first, rest @ ..]) = (slots, start) {
            *slot = u16::from_be_bytes([*first, 0x80]);
            (slots, start) = (others, rest);
        }
    }

    /// The probability of a yes.
    #[inline(always)]
    pub(crate) fn of(&mut self, slot: Slot) -> Probability<'_> {
        Probability(&mut self.0[if slot < N { slot } else { 0 }])
    }
}

/// One of the probabilities.
pub(crate) struct Probability<'a>(&'a mut u16);

impl Probability<'_> {
    /// In 4096ths: odd, so neither 0 nor 4096.
    #[inline(always)]
    pub(crate) fn yes(&self) -> u32 {
        u32::from(*self.0 >> 4) | 1
    }

    /// Takes in a decision that was made.
    #[inline(always)]
    pub(crate) fn learn(self, bit: bool) {
        if bit {
            *self.0 += (u16::MAX - *self.0) >> RATE;
        } else {
            *self.0 -= *self.0 >> RATE;
        }
    }
}
