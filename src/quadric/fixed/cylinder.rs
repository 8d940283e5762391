//! Where a line is inside a cylinder's wall, between its caps.

use super::aligned::aligned_cylinder;
use super::between::{cut, overlap, roots};
use super::lines::{bits, cross, dot, is_in_range, square, unit_bits, way, wide_dot};
use super::planes::Crossings;
use super::quadratic::{Integer, Quadratic, Root};
use crate::geom::{Direction, Line, Vec3};
use crate::quadric::{Planes, WALL, Wall};
use crate::scalar::{FixedPoint, Roots};
use crate::span::{Crossing, Span};
use ethnum::I256;

/// |q + t·m|² − r² for a line in the plane across a coordinate axis.
fn aligned(q: [i64; 2], m: [i64; 2], square: i64) -> Quadratic<i128> {
    let (a, k) = (dot(m, m), dot(q, [m[1], -m[0]]));
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    Quadratic {
        a: a.into(),
        b: dot(q, m).into(),
        c: (dot(q, q) - square).into(),
        discriminant: product(square, a) - product(k, k),
    }
}

/// |(u + t·d) × A|² − r²|A|² for an axis A.
fn oblique(u: [i64; 3], d: [i64; 3], axis: [i64; 3], square: i64) -> Quadratic<I256> {
    let (q, m) = (cross(u, axis), cross(d, axis));
    let square = I256::from(square);
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

/// A wall's quadratic, in as many bits as its axis needs.
enum Section {
    Aligned(Quadratic<i128>),
    Oblique(Quadratic<I256>),
}

/// The same expression for either width.
macro_rules! of_section {
    ($section:expr, $quadratic:ident => $value:expr) => {
        match $section {
            Section::Aligned($quadratic) => $value,
            Section::Oblique($quadratic) => $value,
        }
    };
}

impl Section {
    fn new<S: FixedPoint>(wall: &Wall<S>, axis: &Direction<S>, line: &Line<S>) -> Self {
        let [ux, uy, uz] = way(wall.base, line.origin);
        let [dx, dy, dz] = bits(line.direction);
        let square = square(wall.radius);
        match axis.along() {
            Some(along) => {
                let q = along.across(Vec3 { x: ux, y: uy, z: uz });
                let m = along.across(Vec3 { x: dx, y: dy, z: dz });
                Self::Aligned(aligned(q, m, square))
            }
            None => {
                let axis = unit_bits::<S>(axis.vector());
                Self::Oblique(oblique([ux, uy, uz], [dx, dy, dz], axis, square))
            }
        }
    }
}

/// Which of the two points of the wall are between the planes, or on one.
fn between<W: Integer>(quadratic: &Quadratic<W>, caps: &Crossings) -> [bool; 2] {
    if caps.speed == 0 {
        return [caps.touches(); 2];
    }
    let [first, last, speed] = caps.fractions();
    [Root::Enter, Root::Exit].map(|root| {
        quadratic.is_at_or_above(root, first, speed) && quadratic.is_at_or_below(root, last, speed)
    })
}

pub(in crate::quadric) fn cylinder<S: FixedPoint>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    match caps.normal.along() {
        Some(_) => aligned_cylinder(wall, caps, line),
        None => oblique_cylinder(wall, caps, line),
    }
}

#[inline(never)]
fn oblique_cylinder<S: FixedPoint>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    if !is_in_range(line) {
        return None;
    }
    let axis = unit_bits::<S>(caps.normal.vector());
    let quadratic =
        oblique(way(wall.base, line.origin), bits(line.direction), axis, square(wall.radius));
    let (enter, exit) = roots::<S, _>(&quadratic).ends()?;
    let at = |t| Crossing { t, face: WALL };
    let crossings = Crossings::new(caps, line);
    if crossings.speed == 0 {
        // Parallel to the caps, it is between them all along the wall, or nowhere.
        let [enter, exit] = quadratic.chord(S::BITS)?;
        let span = Span { enter: at(S::from_bits(enter)), exit: at(S::from_bits(exit)) };
        return crossings.is_between(caps).then_some(span)?.checked();
    }
    let in_wall = Span { enter: at(enter), exit: at(exit) };
    cut(in_wall, &crossings, || overlap(&quadratic, &crossings))
}

pub(in crate::quadric) fn open_cylinder<S: FixedPoint>(
    wall: &Wall<S>,
    caps: &Planes<S>,
    line: &Line<S>,
) -> [Option<S>; 2] {
    if !is_in_range(line) {
        return [None; 2];
    }
    let crossings = Crossings::new(caps, line);
    let section = Section::new(wall, &caps.normal, line);
    let Roots::Between(enter, exit) = of_section!(&section, quadratic => roots(quadratic)) else {
        return [None; 2];
    };
    let [enters, exits] = of_section!(&section, quadratic => between(quadratic, &crossings));
    [enters.then_some(enter), exits.then_some(exit)]
}
