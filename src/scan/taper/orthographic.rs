//! The wall of a cone along parallel rays.
//!
//! All rays have the same angle to the axis. If they are clearly flatter than the side, a pixel's chord is
//! `middle ± √(w² − κ²) · stretch`, as a cylinder's, but w is affine in the column, as κ and the middle are.
//! With the coordinates x, κ and g of a [`Conic`](crate::quadric::Conic), whose steps are d, 0 and s,
//! `w = (g·d − s·x)/√a` and `middle = (g·s − x·d)/a`, where `a = d² − s²`. The lines w = ±κ are the outline
//! of the wall.
//!
//! If they are clearly steeper, a < 0, it is `middle ± √(w² + κ²) · stretch` with |a| under the root: one of
//! the two, and the cone is beyond it. Rays nearly along the side are asked one by one.

use super::{Pencil, after};
use crate::geom::{Affine, OrthographicRays, Vec3};
use crate::quadric::{Planes, Taper};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::bounds::Steps;

/// How rays meet the wall's nappe.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Curve {
    /// Nearly along the side, or however. Not 0: so a view that isn't set yet is all zeros.
    Any = 1,
    /// Flatter than the side: twice.
    Ellipse,
    /// Steeper than the side: once.
    Steep,
}

/// A cone's wall, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    curve: Curve,
    stretch: S::Scale,
    /// Its coordinates are the width w, κ and the middle, but for any curve.
    wall: Pencil<S>,
    /// Of κ or of w ± κ, the least and the most.
    sides: [S::Wide; 2],
}

impl<S: Scalar> OrthographicView<S> {
    /// What a camera decides, and a direction across the axis and its rays: `beside`, a unit vector across the
    /// axis, where they run along it.
    pub(crate) fn new(
        taper: &Taper<S>,
        caps: &Planes<S>,
        rays: &OrthographicRays<S>,
        beside: Vec3<S::Wide>,
    ) -> (Self, Vec3<S::Wide>) {
        let (mut wall, side) = Pencil::new(taper, caps, rays, beside);
        let [way, _, growth] = wall.step;
        let crossed = S::Wide::product_difference;
        let a = crossed(way, way, growth, growth);
        let (mut sides, mut stretch, mut curve) =
            ([-S::Wide::ONE, S::Wide::ONE], S::Wide::ZERO, Curve::Any);
        if a.abs() * S::Wide::from_int(32) > S::Wide::ONE {
            curve = if a > S::Wide::ZERO { Curve::Ellipse } else { Curve::Steep };
            stretch = S::Wide::ONE / a.abs().sqrt();
            let inverse = S::Wide::ONE / a;
            wall.from = wall.from.map(|[x, distance, radius]| {
                let width = crossed(radius, way, growth, x) * stretch;
                [width, distance, crossed(radius, growth, x, way) * inverse]
            });
        }
        if curve == Curve::Ellipse {
            // At a point inside, no coordinate is larger than r·cos.
            sides = [S::Wide::ZERO, S::Wide::ONE + (way + growth.abs()) * stretch];
        }
        let widest = taper.widest() * S::wide_unit(taper.slant[0]);
        let sides = sides.map(|part| part * widest);
        (Self { curve, stretch: S::scale(stretch), wall, sides }, side)
    }

    /// Whether the rays are clearly flatter than the side, and so cross the wall twice.
    #[inline(always)]
    pub(crate) fn is_crossed_twice(&self) -> bool {
        self.curve == Curve::Ellipse
    }

    /// The coordinates in the middle of a row.
    pub(crate) fn row(&self, y: i32) -> [S::Wide; 3] {
        self.wall.row(y)
    }

    /// Where rays of a row can meet the wall; `size` is that of a length across it.
    pub(crate) fn steps(&self, [width, distance, _]: [S::Wide; 3], size: S::Wide) -> Steps {
        // A width has larger terms than a length.
        let size = size * S::Wide::from_int(8);
        let ([to_width, to_distance, _], [low, high]) = (self.wall.from[1], self.sides);
        let sides = |middle, step| Steps::between::<S>(Affine { middle, step }, low, high, size);
        if self.is_crossed_twice() {
            sides(width + distance, to_width + to_distance)
                .overlap(sides(width - distance, to_width - to_distance))
        } else {
            sides(distance, to_distance)
        }
    }

    /// Where a ray is inside the wall, by the coordinates in its row's middle.
    #[inline(always)]
    pub(crate) fn chord(&self, from: &[S::Wide; 3], x: i32) -> Option<[S; 2]> {
        if self.curve == Curve::Any {
            return self.wall.chord(from, self.wall.step, x);
        }
        let [width, distance, middle] = after(from, &self.wall.from[1], x);
        let [width, distance] = [width, distance].map(S::from_wide);
        let around = |half: S| middle.around(half.stretched(self.stretch)).map(S::from_wide);
        if self.is_crossed_twice() {
            // Beyond the tip, the width is below zero.
            return S::leg(width.max(S::ZERO), distance).map(around);
        }
        let [first, last] = around(S::length([width, distance, S::ZERO]));
        let is_wider_behind = self.wall.step[2] > S::Wide::ZERO;
        Some(if is_wider_behind { [last, S::HIGHEST] } else { [S::LOWEST, first] })
    }
}
