//! Lines in fixed point: whole numbers throughout, and one rounding at the end.
//!
//! A line `p + t·d` is at distance r from a point, or from an axis A, at the roots of
//! `a t² + 2 b t + c = 0`. All coefficients are whole numbers of units, so the sign of the
//! discriminant is known exactly; so is on which side of a root any fraction lies, which makes
//! correctly rounded parameters out of approximate ones.
//!
//! Along a coordinate axis, and for spheres, 128 bits hold everything: coordinates are at most 2²⁸
//! units (differences 2²⁹), directions 2³⁰, so a < 2⁶², b < 2⁶¹, c < 2⁶¹, and with parameters of 32
//! bits and a half `a t²` stays below 2¹²⁶. An oblique axis has 28 bits more, and needs 256 bits.

use super::{Intersect, Meeting, Passage};
use crate::geom::{Direction, Line, Vec3};
use crate::scalar::{FixedI32, Fraction, Scalar, whole};
use crate::solid::cylinder::Tube;
use crate::solid::slab::Slab;
use core::ops::{Add, Mul, Neg, Sub};
use ethnum::I256;

/// A signed integer wide enough for its use.
trait Wide:
    Copy
    + Ord
    + From<i128>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
    /// A number ≥ 0 as `mantissa · 2^exponent`, cut off, with an even exponent and 126 or 127
    /// significant bits (or 0).
    fn normalized(self) -> (u128, i32);
}

impl Wide for i128 {
    #[inline]
    fn normalized(self) -> (u128, i32) {
        let spare = (self.leading_zeros().max(1) - 1) & !1;
        (self.unsigned_abs() << spare, -(spare as i32))
    }
}

impl Wide for I256 {
    #[inline]
    fn normalized(self) -> (u128, i32) {
        let bits = 256 - self.leading_zeros() as i32;
        if bits <= 127 {
            return self.as_i128().normalized();
        }
        let surplus = (bits - 126) & !1;
        ((self >> surplus.unsigned_abs()).as_u128(), surplus)
    }
}

/// `a t² + 2 b t + c`, for t in parameters of the line: not in units of the grid.
struct Quadratic<W> {
    a: W,
    b: W,
    c: W,
    /// `b² − a·c`.
    discriminant: W,
}

/// Which root: the one where the line enters, or the one where it exits.
#[derive(Clone, Copy, PartialEq)]
enum Root {
    Enter,
    Exit,
}

impl<W: Wide> Quadratic<W> {
    /// Whether the quadratic's root is above the fraction, or at it.
    fn is_at_or_above(&self, root: Root, numerator: i128, denominator: i128) -> bool {
        let (n, d) = (W::from(numerator), W::from(denominator));
        let zero = W::from(0);
        let ascent = self.a * n + self.b * d;
        let value = n * (ascent + self.b * d) + self.c * d * d;
        match root {
            Root::Enter => value >= zero && ascent <= zero,
            Root::Exit => value <= zero || ascent <= zero,
        }
    }

    /// Whether the value at a fraction is below zero: the line is inside there.
    fn is_inside(&self, numerator: i128, denominator: i128) -> bool {
        let (n, d) = (W::from(numerator), W::from(denominator));
        n * (self.a * n + self.b * d + self.b * d) + self.c * d * d < W::from(0)
    }

    /// Both roots on the grid of `fraction` bits, rounded to nearest, halves upwards; two
    /// different numbers for a discriminant above zero.
    fn roots(&self, fraction: u32) -> [i32; 2] {
        let (root, to_root) = self.discriminant.normalized();
        let (root, to_root) = (root.isqrt(), to_root / 2);
        let (a, to_a) = self.a.normalized();
        let a = a >> 64;
        // Eight digits more than the grid has.
        let over_a = |number: u128, exponent: i32| {
            let quotient = number.checked_div(a).unwrap_or(u128::MAX);
            let exponent = exponent - 64 - to_a + fraction as i32 + 8;
            let quotient = if exponent <= 0 {
                quotient.checked_shr(exponent.unsigned_abs()).unwrap_or(0)
            } else if exponent.unsigned_abs() < quotient.leading_zeros() {
                quotient << exponent
            } else {
                u128::MAX
            };
            quotient.min(1 << 100).cast_signed()
        };
        let half = over_a(root << 63, to_root - 63);
        let is_negative = self.b < W::from(0);
        let (b, to_b) = if is_negative { -self.b } else { self.b }.normalized();
        let middle = over_a(b, to_b);
        let middle = if is_negative { middle } else { -middle };

        let enter = self.nearest(Root::Enter, middle - half, fraction);
        let exit = self.nearest(Root::Exit, middle + half, fraction);
        if enter < exit || self.discriminant <= W::from(0) {
            return [enter, exit];
        }
        // The span is shorter than the grid's step: it grows on the side that is nearer.
        if enter < i32::MAX && self.is_at_or_above(Root::Exit, enter.into(), 1 << fraction) {
            [enter, enter + 1]
        } else {
            [enter.saturating_sub(1), enter]
        }
    }

    /// The number of the grid nearest to a root that is known to within a unit or two, with
    /// eight more digits; held inside the grid's range.
    fn nearest(&self, root: Root, roughly: i128, fraction: u32) -> i32 {
        const LIMIT: i128 = 1 << 31;
        let start = ((roughly + 128) >> 8).clamp(-LIMIT, LIMIT);
        let is_at_or_above_half = |t: i128| self.is_at_or_above(root, 2 * t + 1, 2 << fraction);
        let mut t = start;
        while t < LIMIT && is_at_or_above_half(t) {
            t += 1;
        }
        while t > -LIMIT && !is_at_or_above_half(t - 1) {
            t -= 1;
        }
        t.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    }
}

fn dot<const N: usize>(x: [i128; N], y: [i128; N]) -> i128 {
    x.into_iter().zip(y).map(|(x, y)| x * y).sum()
}

fn cross([x0, x1, x2]: [i128; 3], [y0, y1, y2]: [i128; 3]) -> [i128; 3] {
    [x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0]
}

fn bits<F: Fraction>(v: Vec3<FixedI32<F>>) -> [i128; 3] {
    v.to_array().map(|coordinate| i128::from(coordinate.to_bits()))
}

/// The way from one point to another, in units.
fn way<F: Fraction>(from: Vec3<FixedI32<F>>, to: Vec3<FixedI32<F>>) -> [i128; 3] {
    let ([x0, y0, z0], [x1, y1, z1]) = (bits(from), bits(to));
    [x1 - x0, y1 - y0, z1 - z0]
}

/// |q + t·m|² − r² for a line in the plane across a coordinate axis.
fn round<F: Fraction>(q: [i128; 2], m: [i128; 2], radius: FixedI32<F>) -> Quadratic<i128> {
    let square = i128::from(radius.to_bits()).pow(2);
    let (a, k) = (dot(m, m), dot(q, [m[1], -m[0]]));
    Quadratic { a, b: dot(q, m), c: dot(q, q) - square, discriminant: square * a - k * k }
}

/// |(u + t·d) × A|² − r²|A|² for an axis A.
fn oblique<F: Fraction>(
    u: [i128; 3],
    d: [i128; 3],
    axis: [i128; 3],
    radius: FixedI32<F>,
) -> Quadratic<I256> {
    let (q, m) = (cross(u, axis), cross(d, axis));
    let wide = |x: [i128; 3], y: [i128; 3]| {
        let [x0, x1, x2] = x.map(I256::from);
        let [y0, y1, y2] = y.map(I256::from);
        x0 * y0 + x1 * y1 + x2 * y2
    };
    let square = I256::from(i128::from(radius.to_bits()).pow(2));
    let length_squared = I256::from(dot(axis, axis));
    let (a, k) = (wide(m, m), wide(u, m));
    Quadratic {
        a,
        b: wide(q, m),
        c: wide(q, q) - square * length_squared,
        // |q × m|² = |A|² (u·m)², because q and m are at right angles to A.
        discriminant: length_squared * (square * a - k * k),
    }
}

/// A tube's quadratic, in as many bits as its axis needs.
enum Section {
    Round(Quadratic<i128>),
    Oblique(Quadratic<I256>),
}

impl Section {
    fn new<F: Fraction>(
        tube: &Tube<FixedI32<F>>,
        axis: &Direction<FixedI32<F>>,
        line: &Line<FixedI32<F>>,
    ) -> Self {
        let [ux, uy, uz] = way(tube.base, line.origin);
        let [dx, dy, dz] = bits(line.direction);
        match axis.along() {
            Some(along) => {
                let q = along.across(Vec3::new(ux, uy, uz));
                let m = along.across(Vec3::new(dx, dy, dz));
                Self::Round(round(q, m, tube.radius))
            }
            None => {
                let axis = bits(axis.vector());
                Self::Oblique(oblique([ux, uy, uz], [dx, dy, dz], axis, tube.radius))
            }
        }
    }
}

fn meeting<F: Fraction, W: Wide>(quadratic: &Quadratic<W>) -> Meeting<FixedI32<F>> {
    let zero = W::from(0);
    if quadratic.a == zero {
        return if quadratic.c < zero { Meeting::Within } else { Meeting::Along };
    }
    if quadratic.discriminant < zero {
        return Meeting::Beside;
    }
    let [enter, exit] = quadratic.roots(F::BITS).map(FixedI32::from_bits);
    Meeting::Points(enter, exit)
}

/// Where a line crosses a slab's planes: at `heights / speed`, in whole numbers.
struct Planes {
    heights: [i128; 2],
    speed: i128,
}

impl Planes {
    fn new<F: Fraction>(slab: &Slab<FixedI32<F>>, line: &Line<FixedI32<F>>) -> Self {
        let normal = bits(slab.normal.vector());
        let at_zero = dot(normal, bits(line.origin));
        let height = |offset: FixedI32<F>| (i128::from(offset.to_bits()) << 28) - at_zero;
        let planes = Self {
            heights: [height(slab.low), height(slab.high)],
            speed: dot(normal, bits(line.direction)),
        };
        match slab.normal.along() {
            // All are multiples of 2^28, and short numbers are divided faster.
            Some(_) => Self { heights: planes.heights.map(|h| h >> 28), speed: planes.speed >> 28 },
            None => planes,
        }
    }

    /// The fractions at which the line crosses the planes, in ascending order.
    fn ascending(&self) -> [i128; 2] {
        let [low, high] = self.heights;
        if self.speed > 0 { [low, high] } else { [high, low] }
    }
}

/// Whether the line is inside the quadratic and between the planes for some time.
fn overlap<W: Wide>(quadratic: &Quadratic<W>, planes: &Planes) -> bool {
    let [first, last] = planes.ascending();
    let speed = planes.speed;
    let (first, last, speed) =
        if speed > 0 { (first, last, speed) } else { (-first, -last, -speed) };
    if quadratic.is_inside(first, speed) || quadratic.is_inside(last, speed) {
        return true;
    }
    // Both ends are outside. They are on either side of the roots if the vertex −b/a is between
    // them, where the quadratic is smallest.
    let (a, b, d) = (quadratic.a, quadratic.b, W::from(speed));
    let zero = W::from(0);
    quadratic.discriminant > zero
        && a * W::from(first) + b * d < zero
        && a * W::from(last) + b * d > zero
}

impl<F: Fraction> Intersect for FixedI32<F> {
    fn meet_tube(tube: &Tube<Self>, axis: &Direction<Self>, line: &Line<Self>) -> Meeting<Self> {
        match Section::new(tube, axis, line) {
            Section::Round(quadratic) => meeting(&quadratic),
            Section::Oblique(quadratic) => meeting(&quadratic),
        }
    }

    fn meet_ball(center: Vec3<Self>, radius: Self, line: &Line<Self>) -> Option<[Self; 2]> {
        let (u, d) = (way(center, line.origin), bits(line.direction));
        let square = i128::from(radius.to_bits()).pow(2);
        let (a, k) = (dot(d, d), cross(u, d));
        let discriminant = square * a - dot(k, k);
        let quadratic = Quadratic { a, b: dot(u, d), c: dot(u, u) - square, discriminant };
        (discriminant > 0).then(|| quadratic.roots(F::BITS).map(Self::from_bits))
    }

    fn pass(slab: &Slab<Self>, line: &Line<Self>) -> Passage<Self> {
        let planes = Planes::new(slab, line);
        let [low, high] = planes.heights;
        if planes.speed == 0 {
            let inside = slab.has(low <= 0, low < 0) && slab.has(0 < high, 0 <= high);
            return Passage::Along { inside };
        }
        let at = |height: i128| {
            let t = whole::divide(height << F::BITS, planes.speed);
            t.clamp(i32::MIN.into(), i32::MAX.into()) as i32
        };
        let (low, high, upwards) = (at(low), at(high), planes.speed > 0);
        // The planes are apart, however fast the line passes them.
        let (low, high) = match upwards {
            true if low >= high => (low, low.saturating_add(1)),
            false if high >= low => (high.saturating_add(1), high),
            _ => (low, high),
        };
        Passage::Across { at: [low, high].map(Self::from_bits), upwards }
    }

    fn is_between(slab: &Slab<Self>, line: &Line<Self>, t: Self) -> bool {
        match Self::pass(slab, line) {
            Passage::Along { inside } => inside,
            Passage::Across { at: [low, high], upwards: true } => low <= t && t <= high,
            Passage::Across { at: [low, high], upwards: false } => high <= t && t <= low,
        }
    }

    fn shortest(
        tube: &Tube<Self>,
        caps: &Slab<Self>,
        line: &Line<Self>,
        t: Self,
    ) -> Option<[Self; 2]> {
        let planes = Planes::new(caps, line);
        if planes.speed == 0 {
            return None;
        }
        let is_inside = match Section::new(tube, &caps.normal, line) {
            Section::Round(quadratic) => overlap(&quadratic, &planes),
            Section::Oblique(quadratic) => overlap(&quadratic, &planes),
        };
        let next = t.saturating_add(Self::from_bits(1));
        (is_inside && t < next && Self::LOWEST < t).then_some([t, next])
    }
}
