//! Pieces of baked curves in fixed point: a piece to each span, or to a part of it.

use super::layout::Place;
use super::piece::Piece;
use super::polynomial::{Words, polynomials, words};
use crate::scalar::integer::narrow;
use crate::scalar::{ConstOps, FixedI32, Fraction};
use crate::spline::scalar::fixed::FixedMap;

/// How the parameters of a piece become local ones.
const fn map(start: i32, end: i32) -> FixedMap {
    let width = end.wrapping_sub(start).cast_unsigned();
    let shift = width.leading_zeros();
    // Rounded up, so that the end's local parameter fits 32 bits.
    let half = width.wrapping_shl(shift).div_ceil(2);
    let origin = start.cast_unsigned().wrapping_shl(shift).wrapping_add(half);
    FixedMap { start, origin, shift: shift as u8, guard: 0 }
}

/// The largest that a sum can be in Horner's rule, with 1 in place of the constant coefficient.
const fn largest<const K: usize>(polynomial: &[Words; K]) -> f64 {
    let (mut largest, mut sum) = (1.0f64, 0.0);
    let mut i = K;
    while i > 0 {
        i -= 1;
        sum = sum / 2.0 + if i > 0 { polynomial[i].high.abs() } else { 1.0 };
        largest = largest.max(sum);
    }
    largest
}

impl<F: Fraction> ConstOps<FixedI32<F>> {
    /// The piece of a span from one parameter to another.
    ///
    /// It has as many guard bits as the span's coefficients leave room for. Half a unit is added for the
    /// result, whose integer units at the origin are added at the end.
    pub(in crate::spline) const fn piece<const K: usize, const D: usize>(
        knots: &[f64],
        points: &[[f64; D]],
        (span, [start, stop]): Place<FixedI32<F>>,
    ) -> Option<Piece<FixedMap, [i32; D], [i32; D], K>> {
        let map = map(start.to_bits(), stop.to_bits());
        // Distances in units of 2^−shift, of which the local parameter 1 has 2³².
        let scale = (1u64 << map.shift) as f64;
        let origin = map.start as f64 * scale + map.half() as f64;
        let unit = (1u64 << 32) as f64;
        let polynomials = polynomials::<K, D>(knots, points, span, [scale, origin, unit]);
        let mut most = 1.0f64;
        let mut d = 0;
        while d < D {
            most = most.max(largest(&polynomials[d]));
            d += 1;
        }
        let mut guard = 20;
        while guard > 0 && most * (1u32 << guard) as f64 > (i32::MAX - 64) as f64 {
            guard -= 1;
        }
        if guard < 4 && K > 1 {
            return None;
        }
        let (mut coefficients, mut base) = ([[0; D]; K], [0; D]);
        let mut d = 0;
        while d < D {
            let mut rest = polynomials[d];
            let nearest = rest[0].nearest();
            base[d] = narrow(nearest);
            rest[0] = rest[0].sub(words(nearest as f64)).add(words(0.5));
            let mut i = 0;
            while i < K {
                // Half a unit makes up for the product that is cut off.
                let cut_off = words(if i + 1 < K { 0.5 } else { 0.0 });
                let scaled = rest[i].scaled((1u32 << guard) as f64);
                coefficients[K - 1 - i][d] = scaled.add(cut_off).nearest() as i32;
                i += 1;
            }
            d += 1;
        }
        Some(Piece { coefficients, map: FixedMap { guard, ..map }, base })
    }
}
