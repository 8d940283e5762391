//! Lines in fixed point: whole numbers throughout, and one rounding at the end.
//!
//! A line `p + t·d` is at distance r from a point, or from an axis A, at the roots of
//! `a t² + 2 b t + c = 0`. All coefficients are whole numbers of units, so the sign of the
//! discriminant is known exactly; so is on which side of a root any fraction lies, which makes
//! correctly rounded parameters out of approximate ones.
//!
//! Along a coordinate axis, and for spheres, 128 bits hold everything. Solids are within 2²⁸ units;
//! rays start there too and have directions up to 2³⁰, and when they are turned into a placed
//! solid's frame, less than 2³⁰ and |d|² ≤ 2⁶² remain, which is checked. So a ≤ 2⁶², |b| and |c| < 2⁶³,
//! and with parameters of 32 bits and a half `a t²` is at most 2¹²⁶. An oblique axis has 28 bits
//! more, and needs 256 bits.

use super::quadratic::{Integer, Quadratic, Root};
use super::{Intersect, Meeting, Passage};
use crate::geom::{Direction, Line, Vec3};
use crate::scalar::{FixedI32, Fraction, integer};
use crate::solid::cylinder::{Cylinder, Tube, WALL, wall_span};
use crate::solid::slab::Slab;
use crate::span::{Crossing, Span};
use ethnum::I256;

fn dot<const N: usize>(x: [i64; N], y: [i64; N]) -> i64 {
    x.into_iter().zip(y).map(|(x, y)| x * y).sum()
}

fn cross([x0, x1, x2]: [i64; 3], [y0, y1, y2]: [i64; 3]) -> [i64; 3] {
    [x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0]
}

/// `x·y` of numbers whose products need more than 64 bits.
fn wide_dot([x0, x1, x2]: [i64; 3], [y0, y1, y2]: [i64; 3]) -> i128 {
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    product(x0, y0) + product(x1, y1) + product(x2, y2)
}

fn bits<F: Fraction>(v: Vec3<FixedI32<F>>) -> [i64; 3] {
    v.to_array().map(|coordinate| i64::from(coordinate.to_bits()))
}

/// Whether a line is one that this module's integers have room for. All rays are; lines of a
/// caller's own need not be, and they meet nothing.
fn is_in_range<F: Fraction>(line: &Line<FixedI32<F>>) -> bool {
    let square = |x: i64| x.unsigned_abs() * x.unsigned_abs();
    let [dx, dy, dz] = bits(line.direction);
    let far = bits(line.origin).into_iter().any(|x| x.unsigned_abs() >= 1 << 30);
    !far && square(dx) + square(dy) + square(dz) <= 1 << 62
}

/// The square of a length.
fn square<F: Fraction>(length: FixedI32<F>) -> i64 {
    i64::from(length.to_bits()) * i64::from(length.to_bits())
}

/// The way from one point to another, in units.
fn way<F: Fraction>(from: Vec3<FixedI32<F>>, to: Vec3<FixedI32<F>>) -> [i64; 3] {
    let ([x0, y0, z0], [x1, y1, z1]) = (bits(from), bits(to));
    [x1 - x0, y1 - y0, z1 - z0]
}

/// |q + t·m|² − r² for a line in the plane across a coordinate axis.
fn round<F: Fraction>(q: [i64; 2], m: [i64; 2], radius: FixedI32<F>) -> Quadratic<i128> {
    let (square, a, k) = (square(radius), dot(m, m), dot(q, [m[1], -m[0]]));
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    Quadratic {
        a: a.into(),
        b: dot(q, m).into(),
        c: (dot(q, q) - square).into(),
        discriminant: product(square, a) - product(k, k),
    }
}

/// |u + t·d|² − r².
fn ball<F: Fraction>(u: [i64; 3], d: [i64; 3], radius: FixedI32<F>) -> Quadratic<i128> {
    let (square, a, k) = (square(radius), dot(d, d), cross(u, d));
    Quadratic {
        a: a.into(),
        b: dot(u, d).into(),
        c: (dot(u, u) - square).into(),
        discriminant: i128::from(square) * i128::from(a) - wide_dot(k, k),
    }
}

/// |(u + t·d) × A|² − r²|A|² for an axis A.
fn oblique<F: Fraction>(
    u: [i64; 3],
    d: [i64; 3],
    axis: [i64; 3],
    radius: FixedI32<F>,
) -> Quadratic<I256> {
    let (q, m) = (cross(u, axis), cross(d, axis));
    let square = I256::from(square(radius));
    let length_squared = I256::from(dot(axis, axis));
    let [a, b, c, k] = [wide_dot(m, m), wide_dot(q, m), wide_dot(q, q), wide_dot(u, m)];
    let [a, b, c, k] = [a, b, c, k].map(I256::from);
    Quadratic {
        a,
        b,
        c: c - square * length_squared,
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

/// Where the line crosses the wall, each parameter rounded.
fn meeting<F: Fraction, W: Integer>(quadratic: &Quadratic<W>) -> Meeting<FixedI32<F>> {
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
    heights: [i64; 2],
    speed: i64,
}

impl Planes {
    fn new<F: Fraction>(slab: &Slab<FixedI32<F>>, line: &Line<FixedI32<F>>) -> Self {
        let normal = bits(slab.normal.vector());
        let at_zero = dot(normal, bits(line.origin));
        let height = |offset: FixedI32<F>| (i64::from(offset.to_bits()) << 28) - at_zero;
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

    /// Where the line crosses the planes: the low one and the high one, each rounded.
    fn crossings<F: Fraction>(&self) -> [FixedI32<F>; 2] {
        self.heights.map(|height| {
            let t = integer::divide(i128::from(height) << F::BITS, self.speed.into());
            FixedI32::from_bits(t.clamp(i32::MIN.into(), i32::MAX.into()) as i32)
        })
    }

    /// The fractions at which the line crosses the planes, in ascending order.
    /// Their numerators, and their denominator, which is positive.
    fn fractions(&self) -> [i128; 3] {
        let [low, high] = self.heights;
        let [first, last] = if self.speed > 0 { [low, high] } else { [-high, -low] };
        [first, last, self.speed.abs()].map(i128::from)
    }

    /// Whether a line along the planes is between them.
    fn inside<F: Fraction>(&self, slab: &Slab<FixedI32<F>>) -> bool {
        let [low, high] = self.heights;
        slab.has(low <= 0, low < 0) && slab.has(0 < high, 0 <= high)
    }
}

/// Whether the line is inside the quadratic and between the planes for some time.
fn overlap<W: Integer>(quadratic: &Quadratic<W>, planes: &Planes) -> bool {
    let [first, last, speed] = planes.fractions();
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

/// Which of the two points of the wall are between the planes, or on one.
fn between<W: Integer>(quadratic: &Quadratic<W>, planes: &Planes) -> [bool; 2] {
    if planes.speed == 0 {
        let [low, high] = planes.heights;
        return [low <= 0 && 0 <= high; 2];
    }
    let [first, last, speed] = planes.fractions();
    [Root::Enter, Root::Exit].map(|root| {
        quadratic.is_at_or_above(root, first, speed) && quadratic.is_at_or_below(root, last, speed)
    })
}

impl<F: Fraction> Intersect for FixedI32<F> {
    fn cut(cylinder: &Cylinder<Self>, line: &Line<Self>) -> Option<Span<Self>> {
        if !is_in_range(line) {
            return None;
        }
        let Cylinder { tube, caps } = cylinder;
        let section = Section::new(tube, &caps.normal, line);
        let meeting = match &section {
            Section::Round(quadratic) => meeting(quadratic),
            Section::Oblique(quadratic) => meeting(quadratic),
        };
        let wall = match meeting {
            Meeting::Points(enter, exit) => {
                let at = |t| Crossing { t, face: WALL };
                Span { enter: at(enter), exit: at(exit) }
            }
            Meeting::Within => Span::whole_line(WALL),
            Meeting::Beside | Meeting::Along => return None,
        };
        let planes = Planes::new(caps, line);
        if planes.speed == 0 {
            // Parallel to the caps, it is between them all along the wall, or nowhere.
            let [enter, exit] = match &section {
                Section::Round(quadratic) => quadratic.chord(F::BITS)?,
                Section::Oblique(quadratic) => quadratic.chord(F::BITS)?,
            };
            let [enter, exit] = [enter, exit].map(Self::from_bits);
            return if planes.inside(caps) { wall_span(enter, exit) } else { None };
        }
        let passage = Passage::Across { at: planes.crossings(), upwards: planes.speed > 0 };
        let (enter, exit) = passage.ends()?.common_ends(wall);
        let is_beyond = exit.t == Self::MIN || enter.t == Self::MAX;
        if enter.t != exit.t || is_beyond {
            return Span::new(enter, exit);
        }
        // It is in there for so short a time, if at all, that both ends round to the same parameter.
        let is_inside = match &section {
            Section::Round(quadratic) => overlap(quadratic, &planes),
            Section::Oblique(quadratic) => overlap(quadratic, &planes),
        };
        let next = exit.t.saturating_add(Self::from_bits(1));
        is_inside.then_some(Span { enter, exit: Crossing { t: next, ..exit } })
    }

    fn meet_wall(cylinder: &Cylinder<Self>, line: &Line<Self>) -> [Option<Self>; 2] {
        if !is_in_range(line) {
            return [None; 2];
        }
        let planes = Planes::new(&cylinder.caps, line);
        let (meeting, between) = match Section::new(&cylinder.tube, &cylinder.caps.normal, line) {
            Section::Round(quadratic) => (meeting(&quadratic), between(&quadratic, &planes)),
            Section::Oblique(quadratic) => (meeting(&quadratic), between(&quadratic, &planes)),
        };
        let Meeting::Points(enter, exit) = meeting else { return [None; 2] };
        let [enters, exits] = between;
        [enters.then_some(enter), exits.then_some(exit)]
    }

    fn meet_ball(center: Vec3<Self>, radius: Self, line: &Line<Self>) -> Option<[Self; 2]> {
        if !is_in_range(line) {
            return None;
        }
        let quadratic = ball(way(center, line.origin), bits(line.direction), radius);
        Some(quadratic.chord(F::BITS)?.map(Self::from_bits))
    }

    fn pass(slab: &Slab<Self>, line: &Line<Self>) -> Passage<Self> {
        if !is_in_range(line) {
            return Passage::Along { inside: false };
        }
        let planes = Planes::new(slab, line);
        if planes.speed == 0 {
            return Passage::Along { inside: planes.inside(slab) };
        }
        let (upwards, [low, high]) = (planes.speed > 0, planes.crossings());
        let (first, last) = if upwards { (low, high) } else { (high, low) };
        // The planes are apart, however fast the line passes them: but not beyond the grid.
        let is_beyond = first == Self::MAX || first == Self::MIN;
        let last = if first == last && !is_beyond { last + Self::from_bits(1) } else { last };
        Passage::Across { at: if upwards { [first, last] } else { [last, first] }, upwards }
    }
}
