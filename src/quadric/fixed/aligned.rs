//! Where a line is inside a cylinder along a coordinate axis.
//!
//! Coefficients are integers of 64 bits. The discriminant has 128, so its sign is exact. Roots are products
//! of mantissas of 32 bits, each with a bound of its error. Where a bound leaves two numbers of the grid, and
//! where a span may have no length, integers of 128 bits decide, in cold paths.

use super::between::{cut_at, overlap, roots};
use super::lines::is_in_range;
use super::planes::Crossings;
use super::quadratic::{GUARD, Quadratic};
use crate::geom::{Axis, Line};
use crate::numeric::{product, unsigned_product};
use crate::quadric::{PlaneRoots, Planes, WALL, Wall};
use crate::scalar::integer::{leading_zeros, narrow, normalized, reciprocal, rough_root};
use crate::scalar::{FixedPoint, Number};
use crate::span::{Crossing, Span};

/// The part of a line inside a cylinder along a coordinate axis. There is none for another axis.
pub(in crate::quadric) fn aligned_cylinder<S: FixedPoint>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    let along = caps.normal.along()?;
    if !is_in_range(line) {
        return None;
    }
    let (section, caps_of) = (Section::new(along, wall, line), Caps::new(along, caps, line));
    if caps_of.speed == 0 && !caps_of.exact().is_between(caps) {
        return None;
    }
    let [enter, exit] = match section.quick_roots(S::BITS) {
        Quick::Outside => return None,
        Quick::Between(roots) => roots,
        Quick::Unsure => section.exact_roots::<S>()?,
    };
    let at = |bits| Crossing { t: S::from_bits(bits), face: WALL };
    if caps_of.speed == 0 {
        let [enter, exit] =
            if enter < exit { [enter, exit] } else { section.exact_chord(S::BITS)? };
        return Span { enter: at(enter), exit: at(exit) }.checked();
    }
    let between_caps =
        PlaneRoots::across(caps_of.rounded(S::BITS).map(S::from_bits), caps_of.speed > 0);
    let in_wall = Span { enter: at(enter), exit: at(exit) };
    cut_at(in_wall, between_caps, || section.overlaps(&caps_of))
}

/// A line and a wall in the plane across the axis, in units. Ways are below 2³¹, see `mod.rs`.
pub(super) struct Section {
    q: [i32; 2],
    m: [i32; 2],
    radius: i32,
}

/// What 64 bits tell of the roots.
enum Quick {
    Outside,
    Between([i32; 2]),
    /// 128 bits have to decide.
    Unsure,
}

impl Section {
    #[inline]
    pub(super) fn new<S: FixedPoint>(along: Axis, wall: &Wall<S>, line: &Line<S>) -> Self {
        let bits = |v| along.across(v).map(|coordinate: S| coordinate.to_bits());
        let ([u, v], [base_u, base_v]) = (bits(line.origin), bits(wall.base));
        let q = [u.wrapping_sub(base_u), v.wrapping_sub(base_v)];
        Self { q, m: bits(line.direction), radius: wall.radius.to_bits() }
    }

    /// The coefficients a, b and k of the quadratic, and r²; see `float/mod.rs`.
    #[inline]
    fn coefficients(&self) -> [i64; 4] {
        let Self { q: [qx, qy], m: [mx, my], radius } = *self;
        [
            product(mx, mx) + product(my, my),
            product(qx, mx) + product(qy, my),
            product(qx, my) - product(qy, mx),
            product(radius, radius),
        ]
    }

    fn quick_roots(&self, fraction: u32) -> Quick {
        let [a, b, k, square] = self.coefficients();
        let k = k.unsigned_abs();
        let (largest, least) = (wide_product(square as u64, a as u64), wide_product(k, k));
        if largest < least {
            return Quick::Outside;
        }
        let discriminant = largest - least;
        if a == 0 || discriminant == 0 {
            return Quick::Unsure;
        }
        // On the grid it is the error that counts, so −b/a ± √D/a are as good as roots that don't cancel.
        let a = Rough::of(a as u64);
        let (one_over_a, digits) = (inverse(a.mantissa), a.exponent - (fraction + GUARD) as i32);
        let middle = Rough::of(b.unsigned_abs()).times(one_over_a, digits);
        let half = Rough::root(discriminant).times(one_over_a, digits);
        let (Some(middle), Some(half)) = (middle, half) else { return Quick::Unsure };
        // Three mantissas and a reciprocal are cut off, and each part once more.
        let error = ((middle + half) >> 29) as u32 + 3;
        let middle = if b < 0 { middle } else { -middle };
        match (nearest(middle - half, error), nearest(middle + half, error)) {
            (Some(enter), Some(exit)) => Quick::Between([enter, exit]),
            _ => Quick::Unsure,
        }
    }

    pub(super) fn quadratic(&self) -> Quadratic<i128> {
        let [a, b, k, square] = self.coefficients().map(i128::from);
        let [qx, qy] = self.q.map(|coordinate| product(coordinate, coordinate));
        let c = i128::from(qx + qy) - square;
        Quadratic { a, b, c, discriminant: square * a - k * k }
    }

    #[cold]
    #[inline(never)]
    fn exact_roots<S: FixedPoint>(&self) -> Option<[i32; 2]> {
        let (enter, exit) = roots::<S, _>(&self.quadratic()).ends()?;
        Some([enter.to_bits(), exit.to_bits()])
    }

    #[cold]
    #[inline(never)]
    fn exact_chord(&self, fraction: u32) -> Option<[i32; 2]> {
        self.quadratic().chord(fraction)
    }

    #[cold]
    #[inline(never)]
    fn overlaps(&self, caps: &Caps) -> bool {
        overlap(&self.quadratic(), &caps.exact())
    }
}

/// The number of the grid nearest to a root with [`GUARD`] more digits, if that tells which it is.
#[inline]
fn nearest(roughly: i64, error: u32) -> Option<i32> {
    let raised = roughly + (1 << (GUARD - 1));
    let beyond = raised as u32 & ((1 << GUARD) - 1);
    let t = raised >> GUARD;
    let is_sure = beyond >= error && beyond + error < 1 << GUARD && t == i64::from(t as i32);
    is_sure.then_some(t as i32)
}

/// The caps' planes as they are seen from the line's origin, along the axis.
struct Caps {
    heights: [i32; 2],
    speed: i32,
}

impl Caps {
    #[inline]
    fn new<S: FixedPoint>(along: Axis, caps: &Planes<S>, line: &Line<S>) -> Self {
        let is_forward = along.of(caps.normal.vector()) > S::Unit::ZERO;
        let seen = |v| {
            let bits = along.of::<S>(v).to_bits();
            if is_forward { bits } else { bits.wrapping_neg() }
        };
        let from = seen(line.origin);
        let heights = [caps.low, caps.high].map(|offset| offset.to_bits().wrapping_sub(from));
        Self { heights, speed: seen(line.direction) }
    }

    fn exact(&self) -> Crossings {
        Crossings { heights: self.heights.map(i64::from), speed: self.speed.into() }
    }

    /// The parameters of both planes, each rounded to nearest, halves upwards; for a speed that isn't 0.
    fn rounded(&self, fraction: u32) -> [i32; 2] {
        let speed = self.speed.unsigned_abs();
        let zeros = speed.leading_zeros();
        let inverse = inverse(speed << zeros);
        self.heights.map(|height| {
            let is_negative = (height < 0) != (self.speed < 0);
            let height = height.unsigned_abs();
            // Cut off, and too small by less than two up to 2³¹.
            let roughly = unsigned_product(height, inverse) >> (63 - zeros - fraction);
            let mut t = roughly.min(1 << 31) as u32;
            let mut rest = (u64::from(height) << fraction) - unsigned_product(t, speed);
            while rest >= u64::from(speed) && t < 1 << 31 {
                rest -= u64::from(speed);
                t += 1;
            }
            let is_more = 2 * rest >= u64::from(speed) + u64::from(is_negative);
            let t = i64::from(t) + i64::from(is_more);
            narrow(if is_negative { -t } else { t })
        })
    }
}

/// `mantissa · 2^exponent`, with the highest bit of the mantissa set unless it is 0; the rest cut off.
#[derive(Clone, Copy)]
struct Rough {
    mantissa: u32,
    exponent: i32,
}

impl Rough {
    fn of(bits: u64) -> Self {
        let (mantissa, exponent) = normalized(bits);
        Self { mantissa, exponent }
    }

    /// The square root of a number above zero.
    fn root(square: u128) -> Self {
        let (high, low) = ((square >> 64) as u64, square as u64);
        // An even exponent can be halved.
        let (bits, zeros) = if high == 0 {
            let zeros = leading_zeros(low) & !1;
            (low << zeros, zeros)
        } else {
            let zeros = leading_zeros(high) & !1;
            (high << zeros | low >> 1 >> (63 - zeros), zeros.wrapping_sub(64))
        };
        Self { mantissa: rough_root(bits), exponent: -(zeros.cast_signed() / 2) }
    }

    /// The product with `inverse · 2^(−63 − digits)`, cut off; `None` where it has more than 46 bits.
    fn times(self, inverse: u32, digits: i32) -> Option<i64> {
        let all = unsigned_product(self.mantissa, inverse);
        match 63 + digits - self.exponent {
            digits @ 18..64 => Some((all >> digits).cast_signed()),
            64.. => Some(0),
            _ if all == 0 => Some(0),
            _ => None,
        }
    }
}

/// `2^63 / mantissa`.
#[inline(never)]
fn inverse(mantissa: u32) -> u32 {
    reciprocal(mantissa)
}

/// `a · b`.
fn wide_product(a: u64, b: u64) -> u128 {
    let halves = |x: u64| [x as u32, (x >> 32) as u32];
    let ([a_low, a_high], [b_low, b_high]) = (halves(a), halves(b));
    // Often a number has 32 bits only.
    let part = |x: u32, y: u32| if x == 0 || y == 0 { 0 } else { unsigned_product(x, y) };
    let low = u128::from(unsigned_product(a_low, b_low));
    let middle = u128::from(part(a_low, b_high)) + u128::from(part(a_high, b_low));
    low + (middle << 32) + (u128::from(part(a_high, b_high)) << 64)
}
