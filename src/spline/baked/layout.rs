//! Where the pieces of a baked curve begin.

use super::float::Float;
use super::search;
use crate::scalar::integer::divide;
use crate::spline::error::CurveError;
use crate::spline::scalar::order::{order_f32, order_f64};

/// The number type of knots.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Float(Float),
    /// In units.
    Fixed,
}

/// Where a piece is: on which span, from where to where.
type Place = (usize, [f64; 2]);

/// The pieces of all parts of spans, in order.
pub(super) struct Layout<const PIECES: usize, const SPANS: usize> {
    kind: Kind,
    places: [[Place; PIECES]; SPANS],
}

impl Kind {
    /// The key of a number: its bits are those of an integer in the order of the type's numbers.
    const fn key(self, x: f64) -> u64 {
        match self {
            Self::Float(Float { is_single: true, .. }) => order_f32(x as f32) as u64,
            Self::Float(_) => order_f64(x) as u64,
            Self::Fixed => x as i32 as u64,
        }
    }

    /// The numbers with these keys, which are their own inverse.
    pub(super) const fn numbers<const N: usize>(self, keys: &[i64; N]) -> [f64; N] {
        let mut numbers = [0.0; N];
        let mut i = 0;
        while i < N {
            let key = keys[i];
            numbers[i] = match self {
                Self::Float(Float { is_single: true, .. }) => {
                    f32::from_bits(order_f32(f32::from_bits(key as u32)) as u32) as f64
                }
                Self::Float(_) => f64::from_bits(order_f64(f64::from_bits(key as u64)) as u64),
                Self::Fixed => key as f64,
            };
            i += 1;
        }
        numbers
    }

    /// As [`numbers`](Self::numbers), for all coordinates of points.
    pub(super) const fn rows<const N: usize, const D: usize>(
        self,
        keys: &[[i64; D]; N],
    ) -> [[f64; D]; N] {
        let mut rows = [[0.0; D]; N];
        let mut i = 0;
        while i < N {
            rows[i] = self.numbers(&keys[i]);
            i += 1;
        }
        rows
    }

    /// `low + (high − low)·index/count`, rounded.
    const fn between(self, low: f64, high: f64, index: usize, count: usize) -> f64 {
        match self {
            _ if index == 0 => low,
            _ if index == count => high,
            Self::Float(float) => {
                let width = float.round(high - low);
                let part = float.round(float.round(width * index as f64) / count as f64);
                // The product of the widest spans overflows.
                let few = float.round(width / count as f64);
                let part = if part.is_finite() { part } else { float.round(few * index as f64) };
                float.round(low + part).min(high)
            }
            Self::Fixed => {
                let width = (high - low) as i128;
                low + divide(width * index as i128, count as i128) as f64
            }
        }
    }
}

impl<const PIECES: usize, const SPANS: usize> Layout<PIECES, SPANS> {
    /// What the pieces of a part begin with, and where they end, in quarters of it.
    const CUTS: &[usize] = if PIECES == 3 { &[0, 1, 3, 4] } else { &[0, 4] };

    /// For the spans of knots from t_first to t_last that aren't empty, each in as many parts as there is
    /// room for.
    pub(super) const fn new(
        kind: Kind,
        knots: &[f64],
        [first, last]: [usize; 2],
        spans: usize,
    ) -> Result<Self, CurveError> {
        const { assert!(SPANS > 0) };
        if spans == 0 || spans > SPANS || !SPANS.is_multiple_of(spans) {
            return Err(CurveError::SpanCount);
        }
        let parts = SPANS / spans;
        let mut places = [[(0, [0.0; 2]); PIECES]; SPANS];
        let (mut span, mut at) = (first, 0);
        while span < last {
            let (low, high) = (knots[span], knots[span + 1]);
            let mut part = 0;
            while low < high && part < parts && at < SPANS {
                let mut i = 0;
                while i < PIECES {
                    let (start, stop) = (4 * part + Self::CUTS[i], 4 * part + Self::CUTS[i + 1]);
                    let start = kind.between(low, high, start, 4 * parts);
                    places[at][i] = (span, [start, kind.between(low, high, stop, 4 * parts)]);
                    i += 1;
                }
                (part, at) = (part + 1, at + 1);
            }
            span += 1;
        }
        Ok(Self { kind, places })
    }

    /// Where the i-th piece is.
    pub(super) const fn place(&self, i: usize) -> Place {
        self.places.as_flattened()[i]
    }

    /// The key of the first number of a piece: −0 is as large as 0.
    pub(super) const fn start(&self, i: usize) -> u64 {
        let (_, [start, _]) = self.place(i);
        self.kind.key(if start == 0.0 { -0.0 } else { start })
    }

    /// The key of the last number: 0 is as small as −0.
    pub(super) const fn end(&self) -> u64 {
        let (_, [_, stop]) = self.place(SPANS * PIECES - 1);
        self.kind.key(stop + 0.0)
    }

    /// The key of a node of the [tree](search) that pieces are found with, counted from behind the end.
    pub(super) const fn node(&self, node: usize) -> u64 {
        match search::element(node, SPANS * PIECES) {
            Some(i) => self.start(i).wrapping_sub(self.end().wrapping_add(1)),
            None => 0,
        }
    }
}
