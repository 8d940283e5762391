//! The polynomials of a baked curve, computed while compiling.
//!
//! De Boor's algorithm with polynomials in place of numbers: in the blend
//! `a + (b − a)·(t − low)/(high − low)` the fraction is linear in the span's local parameter. Inside
//! of the span all of it is between 0 and 1, so coefficients are of the size of the control points,
//! however close knots are. It is computed in double words of `f64`; in a constant that costs
//! nothing.
//!
//! The local parameter y is a power of two times t, counted from the middle of the span, or in
//! floating point from about the middle of a piece: control points at full size that alternate then
//! have coefficients below twice their size.

use super::CurveError;
use super::fixed::FixedFrame;
use super::float::{order_f32, order_f64};
use super::long::{Long, power};
use crate::scalar::integer::narrow;
use crate::scalar::{FixedI32, FloatFrame, Fraction};

/// What baking a span needs to know of its number type.
pub(super) struct Bake<S>(core::marker::PhantomData<S>);

/// The polynomial of a span as coefficients of 1, y, y² and so on, where y·`unit` is the
/// distance from the point that knots are measured from.
///
/// `low` holds t_{j−k+1} … t_j and `high` t_{j+1} … t_{j+k}; `points` the span's control points.
pub(super) const fn polynomial<const K: usize>(
    low: [Long; K],
    high: [Long; K],
    points: [f64; K],
    unit: f64,
) -> [Long; K] {
    // blended[i] is a polynomial.
    let mut blended = [[Long::ZERO; K]; K];
    let mut i = 0;
    while i < K {
        blended[i][0] = Long::from(points[i]);
        i += 1;
    }
    let mut level = 1;
    while level < K {
        let mut i = 0;
        while i + level < K {
            // Near 1, so that nothing overflows.
            let width = high[i].minus(low[i + level]);
            let scale = power(width.round());
            let width = width.scaled(scale);
            // The fraction is constant + slope·y.
            let constant = Long::ZERO.minus(low[i + level].scaled(scale)).over(width);
            let slope = Long::from(unit * scale).over(width);
            let mut power = level + 1;
            while power > 0 {
                power -= 1;
                let mut more = blended[i + 1][power].minus(blended[i][power]).times(constant);
                if power > 0 {
                    let below = blended[i + 1][power - 1].minus(blended[i][power - 1]);
                    more = more.plus(below.times(slope));
                }
                blended[i][power] = blended[i][power].plus(more);
            }
            i += 1;
        }
        level += 1;
    }
    blended[0]
}

/// The largest that a sum can be in Horner's rule, with `first` in place of the constant
/// coefficient.
const fn largest<const K: usize>(polynomial: &[Long; K], first: f64) -> f64 {
    let (mut largest, mut sum) = (first, 0.0);
    let mut i = K;
    while i > 0 {
        i -= 1;
        sum = sum / 2.0 + if i > 0 { polynomial[i].round().abs() } else { first };
        if sum > largest {
            largest = sum;
        }
    }
    largest
}

/// h², where a piece's local parameters `t·scale + shift` are from about −h to h. 0 for a piece of a few
/// units, whose origin is at an end of it: large coefficients don't make up for one another there.
const fn square_of_half(scale: f64, shift: f64, [start, stop]: [f64; 2]) -> f64 {
    let (low, high) = ((start * scale + shift).abs(), (stop * scale + shift).abs());
    let half = low.max(high);
    if low.min(high) > 0.25 { half * half } else { 0.0 }
}

/// Coefficient `i` as a whole number: half a unit makes up for the product that is cut off.
const fn coefficient<const K: usize>(polynomial: &[Long; K], i: usize, scale: f64) -> i64 {
    let cut_off = if i + 1 < K { 0.5 } else { 0.0 };
    polynomial[i].scaled(scale).plus(Long::from(cut_off)).whole()
}

macro_rules! floats {
    ($($Float:ident $Whole:ident $order:ident),+) => {$(
        impl Bake<$Float> {
            pub(super) const EMPTY: FloatFrame<$Float> = FloatFrame { scale: 0.0, shift: 0.0 };

            pub(super) const ZERO: $Float = 0.0;
            pub(super) const NO_BASE: () = ();

            pub(super) const fn f64(x: $Float) -> f64 {
                x as f64
            }

            /// The key of the first number of a span: −0 is as large as 0.
            pub(super) const fn key(x: $Float) -> $Whole {
                $order(if x == 0.0 { -0.0 } else { x })
            }

            /// The key of the last number of a span: 0 is as small as −0.
            pub(super) const fn last_key(x: $Float) -> $Whole {
                $order(x + 0.0)
            }

            /// A span's frame.
            pub(super) const fn frame(start: $Float, end: $Float) -> FloatFrame<$Float> {
                let middle = start + (end - start) / 2.0;
                // A span of a unit in the last place has no other number than its start.
                let origin = if middle < end { middle } else { start };
                // A piece without a length has some scale, with which nothing overflows.
                let least = (origin.abs() * ($Float::EPSILON / 2.0)).max($Float::MIN_POSITIVE);
                let far = (origin - start).max(end - origin).max(least);
                let scale = power(far as f64) as $Float;
                let origin = Self::moved(start, origin, end, scale);
                FloatFrame { scale, shift: -origin * scale }
            }

            /// The origin at a distance of 1/2 from the end that is nearer to 0, where that pays.
            ///
            /// With t below half of the origin, the difference of the two is rounded, and twice as much
            /// from 1/2 on. Where the middle is little farther away, the other end may be so instead.
            const fn moved(
                start: $Float,
                middle: $Float,
                end: $Float,
                scale: $Float,
            ) -> $Float {
                let is_start_near = start.abs() < end.abs();
                let near = if is_start_near { start } else { end };
                let far = (middle - start).max(end - middle) * scale;
                // Below 1/2 are pieces that are too short for a scale.
                if far < 0.5 || far > 0.7 || near / middle >= 0.5 {
                    return middle;
                }
                // A multiple of 2⁻¹², so that t above it has exact differences; up to 1/2 away when rounded.
                let half = (0.5 - 1.0 / 4096.0) / scale;
                let origin = if is_start_near { start + half } else { end - half };
                let coarse = 1.5 / $Float::EPSILON / 4096.0 / scale;
                let moved = (origin + coarse) - coarse;
                // Of the widest pieces, that overflows.
                if moved.is_finite() { moved } else { middle }
            }

            /// The distance of a knot from the origin of a frame.
            pub(super) const fn distance(knot: $Float, frame: FloatFrame<$Float>) -> Long {
                Long::sum(knot as f64, frame.shift as f64 / frame.scale as f64)
            }

            /// The distance that the local parameter 1 stands for.
            pub(super) const fn unit(frame: FloatFrame<$Float>) -> f64 {
                1.0 / frame.scale as f64
            }

            /// Coefficients of a span's polynomials, and what is added at the end.
            ///
            /// What rounding leaves of the coefficient of yⁱ is carried to that of yⁱ⁻²: for |y| ≤ h,
            /// yⁱ is (i/4)h²yⁱ⁻² and little else, by Chebyshev's polynomials (Lanczos, *Applied Analysis*,
            /// 1956).
            #[allow(clippy::type_complexity)]
            pub(super) const fn coefficients<const K: usize, const D: usize>(
                polynomials: [[Long; K]; D],
                frame: FloatFrame<$Float>,
                [start, stop]: [$Float; 2],
            ) -> Result<(FloatFrame<$Float>, [[$Float; D]; K], [(); D]), CurveError> {
                let mut coefficients = [[0.0; D]; K];
                let (scale, shift) = (frame.scale as f64, frame.shift as f64);
                let square = square_of_half(scale, shift, [start as f64, stop as f64]);
                let mut d = 0;
                while d < D {
                    let mut rest = polynomials[d];
                    let mut i = K;
                    while i > 0 {
                        i -= 1;
                        let rounded = rest[i].round() as $Float;
                        coefficients[K - 1 - i][d] = rounded;
                        if i > 1 {
                            let left = rest[i].minus(Long::from(rounded as f64));
                            rest[i - 2] = rest[i - 2].plus(left.scaled(i as f64 / 4.0 * square));
                        }
                    }
                    d += 1;
                }
                Ok((frame, coefficients, [(); D]))
            }
        }
    )+};
}

floats!(f32 i32 order_f32, f64 i64 order_f64);

impl<F: Fraction> Bake<FixedI32<F>> {
    pub(super) const EMPTY: FixedFrame = FixedFrame { start: 0, origin: 0, shift: 0, guard: 0 };

    pub(super) const ZERO: i32 = 0;
    pub(super) const NO_BASE: i32 = 0;

    pub(super) const fn f64(x: FixedI32<F>) -> f64 {
        x.to_bits() as f64
    }

    pub(super) const fn key(x: FixedI32<F>) -> i32 {
        x.to_bits()
    }

    pub(super) const fn last_key(x: FixedI32<F>) -> i32 {
        x.to_bits()
    }

    pub(super) const fn frame(start: FixedI32<F>, end: FixedI32<F>) -> FixedFrame {
        let width = end.to_bits().wrapping_sub(start.to_bits()).cast_unsigned();
        let shift = width.leading_zeros();
        // Rounded up, so that the end's local parameter fits 32 bits.
        let half = width.wrapping_shl(shift).div_ceil(2);
        let origin = start.to_bits().cast_unsigned().wrapping_shl(shift).wrapping_add(half);
        FixedFrame { start: start.to_bits(), origin, shift: shift as u8, guard: 0 }
    }

    /// In units of 2^−shift, of which the local parameter 1 has 2³².
    pub(super) const fn distance(knot: FixedI32<F>, frame: FixedFrame) -> Long {
        let steps = knot.to_bits() as f64 - frame.start as f64;
        let half = frame.half();
        Long::sum(steps * (1u64 << frame.shift) as f64, -(half as f64))
    }

    pub(super) const fn unit(_: FixedFrame) -> f64 {
        (1u64 << 32) as f64
    }

    /// As many guard bits as the span's coefficients leave room for. Half a unit is added for the
    /// result, whose whole units at the origin are added at the end.
    #[allow(clippy::type_complexity)]
    pub(super) const fn coefficients<const K: usize, const D: usize>(
        polynomials: [[Long; K]; D],
        frame: FixedFrame,
        _: [FixedI32<F>; 2],
    ) -> Result<(FixedFrame, [[i32; D]; K], [i32; D]), CurveError> {
        let mut most = 1.0f64;
        let mut d = 0;
        while d < D {
            most = most.max(largest(&polynomials[d], 1.0));
            d += 1;
        }
        let mut guard = 20;
        while guard > 0 && most * (1u32 << guard) as f64 > (i32::MAX - 64) as f64 {
            guard -= 1;
        }
        if guard < 4 && K > 1 {
            return Err(CurveError::TooFar);
        }
        let one = (1u32 << guard) as f64;
        let (mut coefficients, mut base) = ([[0; D]; K], [0; D]);
        let mut d = 0;
        while d < D {
            let mut rest = polynomials[d];
            let whole = rest[0].whole();
            base[d] = narrow(whole);
            rest[0] = rest[0].minus(Long::from(whole as f64)).plus(Long::from(0.5));
            let mut i = 0;
            while i < K {
                coefficients[K - 1 - i][d] = coefficient(&rest, i, one) as i32;
                i += 1;
            }
            d += 1;
        }
        Ok((FixedFrame { guard, ..frame }, coefficients, base))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_in_bernsteins_form() {
        // x³ on [0, 2], about its middle: (1 + y)³.
        let (low, high) = ([Long::from(-1.0); 4], [Long::from(1.0); 4]);
        let cubic = polynomial(low, high, [0.0, 0.0, 0.0, 8.0], 1.0);
        assert_eq!(cubic.map(Long::round), [1.0, 3.0, 3.0, 1.0]);
    }
}
