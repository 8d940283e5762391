//! Where a line is inside a cylinder along a coordinate axis.
//!
//! Coefficients are integers of 64 bits. The discriminant has 128, so its sign is exact. Roots are products
//! of mantissas of 32 bits, each with a bound of its error. Where a bound leaves two numbers of the grid, and
//! where a span may have no length, integers of 128 bits decide, in cold paths.

use super::cylinder::{cut_at, overlap, roots};
use super::lines::is_in_range;
use super::planes::Crossings;
use super::quadratic::{GUARD, Quadratic};
use crate::geom::{Axis, Line};
use crate::numeric::{product, unsigned_product};
use crate::quadric::{PlaneRoots, Planes, WALL, Wall};
use crate::scalar::integer::{leading_zeros, narrow, normalized, reciprocal, sqrt};
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
struct Section {
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
    fn new<S: FixedPoint>(along: Axis, wall: &Wall<S>, line: &Line<S>) -> Self {
        let bits = |v| along.across(v).map(|coordinate: S| coordinate.to_bits());
        let ([u, v], [base_u, base_v]) = (bits(line.origin), bits(wall.base));
        let q = [u.wrapping_sub(base_u), v.wrapping_sub(base_v)];
        Self { q, m: bits(line.direction), radius: wall.radius.to_bits() }
    }

    /// The coefficients a, b, c and k of the quadratic; see `float/mod.rs`.
    #[inline]
    fn coefficients(&self) -> [i64; 4] {
        let Self { q: [qx, qy], m: [mx, my], .. } = *self;
        let square = self.square();
        [
            product(mx, mx) + product(my, my),
            product(qx, mx) + product(qy, my),
            product(qx, qx) + product(qy, qy) - square,
            product(qx, my) - product(qy, mx),
        ]
    }

    #[inline]
    fn square(&self) -> i64 {
        product(self.radius, self.radius)
    }

    fn quick_roots(&self, fraction: u32) -> Quick {
        let [a, b, c, k] = self.coefficients();
        let (largest, square) = (
            wide_product(self.square().unsigned_abs(), a.unsigned_abs()),
            wide_product(k.unsigned_abs(), k.unsigned_abs()),
        );
        if largest < square {
            return Quick::Outside;
        }
        let discriminant = largest - square;
        if a == 0 || discriminant == 0 {
            return Quick::Unsure;
        }
        // s/a and c/s with s = |b| + √D, as in `quadratic.rs`.
        let s = Rough::of(b.unsigned_abs()).plus(Rough::root(discriminant));
        let far = s.over(Rough::of(a.unsigned_abs()), fraction);
        let near = Rough::of(c.unsigned_abs()).over(s, fraction);
        let (Some(far), Some(near)) = (far, near) else { return Quick::Unsure };
        let near = if c < 0 { -near } else { near };
        let [enter, exit] = match () {
            () if b == 0 => [-far, far],
            () if b > 0 => [-far, -near],
            () => [near, far],
        };
        match (nearest(enter), nearest(exit)) {
            (Some(enter), Some(exit)) => Quick::Between([enter, exit]),
            _ => Quick::Unsure,
        }
    }

    fn quadratic(&self) -> Quadratic<i128> {
        let [a, b, c, k] = self.coefficients().map(i128::from);
        Quadratic { a, b, c, discriminant: i128::from(self.square()) * a - k * k }
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

/// The number of the grid nearest to a root with [`GUARD`] more digits and a relative error of 2^−28, if
/// that tells which it is.
#[inline]
fn nearest(roughly: i64) -> Option<i32> {
    let raised = roughly + (1 << (GUARD - 1));
    let error = (roughly.unsigned_abs() >> 28) as u32 + 2;
    let beyond = raised as u32 & ((1 << GUARD) - 1);
    let is_sure = beyond >= error && beyond + error < 1 << GUARD;
    is_sure.then_some((raised >> GUARD) as i32)
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
        Self { mantissa: sqrt(bits), exponent: -(zeros.cast_signed() / 2) }
    }

    fn plus(self, other: Self) -> Self {
        let is_larger =
            other.mantissa == 0 || self.mantissa != 0 && self.exponent >= other.exponent;
        let (large, small) = if is_larger { (self, other) } else { (other, self) };
        let apart = (large.exponent - small.exponent).unsigned_abs();
        let (sum, carries) =
            large.mantissa.overflowing_add(small.mantissa.checked_shr(apart).unwrap_or(0));
        if carries {
            Self { mantissa: sum >> 1 | 1 << 31, exponent: large.exponent + 1 }
        } else {
            Self { mantissa: sum, ..large }
        }
    }

    /// `self / other` with [`GUARD`] more digits than the grid has, with a relative error of less than
    /// 2^−28, and cut off. `None` beyond the grid.
    fn over(self, other: Self, fraction: u32) -> Option<i64> {
        let quotient = unsigned_product(self.mantissa, inverse(other.mantissa));
        let digits = 63 + other.exponent - self.exponent - (fraction + GUARD).cast_signed();
        match digits {
            // A quotient of 64 bits, of which 47 are kept.
            17..64 => Some((quotient >> digits).cast_signed()),
            64.. => Some(0),
            _ if quotient == 0 => Some(0),
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
