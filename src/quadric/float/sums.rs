//! The quadratic from plain sums, and whether they are good enough.

use crate::scalar::{Double, Float, Roots, two_sum};

/// What plain sums say: |m|², q·m, |q|² and k².
pub(super) struct Sums<S> {
    pub(super) a: S,
    pub(super) b: S,
    pub(super) from_axis: S,
    pub(super) k: S,
}

impl<S: Float> Sums<S> {
    /// Where the line is inside, or `None` where that isn't clear, or not precise, from plain sums. Near
    /// the surface, `gap` is asked for c.
    ///
    /// The error of k is a few units of |u||m|, so that of D is as many of k|u||m|. It reaches s divided by
    /// 2√D, and is kept where that quotient is small. Plain sums are good enough for b if it isn't
    /// small beside |q||m| with s small as well, and for c from some way off the surface on.
    #[inline(always)]
    pub(super) fn meet(
        &self,
        radius: S,
        distance_squared: S,
        gap: impl FnOnce() -> S,
    ) -> Option<Roots<S>> {
        let &Self { a, b, from_axis, k } = self;
        let radius_squared = radius * radius;
        let largest = radius_squared * a;
        let discriminant = largest - k;
        // The square of what k's rounding error is a few units of, times k.
        let of_k = distance_squared * a * k;
        if discriminant < S::ZERO {
            let error = (largest + of_k.sqrt()) * S::EPSILON * S::from_int(8);
            return (discriminant < -error).then_some(Roots::Outside);
        }
        let s = discriminant.sqrt() + b.abs();
        let quotient = discriminant * s * s * S::from_int(2);
        let is_precise = quotient > largest * largest && quotient * S::from_int(4) > of_k;
        if !(is_precise && s * s * S::from_int(4) > from_axis * a) {
            return None;
        }
        let c = from_axis - radius_squared;
        let is_clear = c.abs() + c.abs() >= from_axis + radius_squared;
        let c = if is_clear { c } else { gap() };
        Some(points(s / a, c / s, b, discriminant))
    }
}

/// The points from the roots' sizes: `far` = (|b| + √D)/a, and `near` = c/(|b| + √D).
#[inline(always)]
pub(super) fn points<S: Float>(far: S, near: S, b: S, discriminant: S) -> Roots<S> {
    // A tangent has one root, but c/s would round to another number, or be 0/0.
    let near = if discriminant > S::ZERO { near } else { far };
    // With b = 0 both are ±√D/a: from either end of the line the same.
    let (one, other) = if b == S::ZERO {
        (-far, far)
    } else if b > S::ZERO {
        (-far, -near)
    } else {
        (near, far)
    };
    // Almost tangent, they may come out in the wrong order by a rounding error.
    if one < other { Roots::Between(one, other) } else { Roots::Between(other, one) }
}

/// `x² − y`, with the errors of the square and of the difference added back.
#[inline(always)]
pub(super) fn square_less<S: Float>(x: S, y: S) -> S {
    let (square, error) = S::two_product(x, x);
    let (difference, lost) = two_sum(square, -y);
    difference + (lost + error)
}

/// `|q|² − r²` with the errors of squares and sums added back.
#[inline]
pub(super) fn squared_less_square<S: Float, const N: usize>(q: [Double<S>; N], radius: S) -> S {
    let (square, square_error) = S::two_product(radius, radius);
    let [mut sum, mut errors, mut lost, mut cross] = [S::ZERO; 4];
    for coordinate in q {
        let (product, error) = S::two_product(coordinate.high, coordinate.high);
        let (next, rounded) = two_sum(sum, product);
        (sum, errors, lost) = (next, errors + error, lost + rounded);
        cross = cross + coordinate.high * coordinate.low;
    }
    let (sum, rounded) = two_sum(sum, -square);
    sum + ((errors - square_error) + (lost + rounded) + (cross + cross))
}
