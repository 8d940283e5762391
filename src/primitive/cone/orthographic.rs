//! The cone along parallel rays.
//!
//! All rays have the same angle to the axis. If they are clearly flatter than the side, a pixel's chord is
//! `middle ± √(w² − κ²) · stretch`, as a cylinder's, but w is affine in the column, as κ and the middle are.
//! With the coordinates x, κ and g of a [`Conic`](crate::quadric::Conic), whose steps are d, 0 and s,
//! `w = (g·d − s·x)/√a` and `middle = (g·s − x·d)/a`, where `a = d² − s²`. The lines w = ±κ are the outline
//! of the wall.
//!
//! If they are clearly steeper, a < 0, it is `middle ± √(w² + κ²) · stretch` with |a| under the root: one of
//! the two, and the cone is beyond it. Rays nearly along the side are asked one by one.

use super::pixel::{PixelView, after};
use super::{Cone, cut, set_common};
use crate::geom::{Affine, Extent, OrthographicRays, Vec3};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::bounds::{Rows, Steps};
use crate::scan::planes::{OrthographicRow as Caps, OrthographicView as CapsView, faces};
use crate::scan::{Empty, Leaf};
use crate::span::Span;

impl<S: Scalar> Leaf<OrthographicRays<S>> for Cone<S> {
    type View = Option<OrthographicView<S>>;
    type Row = OrthographicRow<S>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        let (mut wall, side) = PixelView::new(self, rays);
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
        let widest = self.widest() * S::wide_unit(self.taper.slant[0]);
        let (rows, along) =
            (self.strip(rays, rays.down), self.strip(rays, side.cross(rays.forward)));
        Some(OrthographicView {
            curve,
            stretch: S::scale(stretch),
            wall,
            sides: sides.map(|part| part * widest),
            along,
            caps: self.caps.orthographic_view(rays),
            rows: Rows::of(rows.steps(rows.at[0], rows.at[2])),
        })
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| view.rows.meet(rows))
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        let Some(OrthographicView { curve, wall, sides: [low, high], along, caps, .. }) = view
        else {
            return Extent::EMPTY;
        };
        let [middle, right, down] = &wall.from;
        row.from = after(middle, down, y);
        let ([width, distance, _], [to_width, to_distance, _]) = (row.from, *right);
        // A width has larger terms than a length.
        let size = along.size * S::Wide::from_int(8);
        let sides = |middle, step| Steps::between::<S>(Affine { middle, step }, *low, *high, size);
        let sides = if *curve == Curve::Ellipse {
            sides(width + distance, to_width + to_distance)
                .overlap(sides(width - distance, to_width - to_distance))
        } else {
            sides(distance, to_distance)
        };
        let ends = Affine::row(along.at, y);
        let steps = sides.overlap(along.steps(ends.middle, ends.step));
        if steps.are_beside(columns) {
            return Extent::EMPTY;
        }
        row.caps = self.caps.orthographic_row(caps, y, columns);
        steps.columns(columns)
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let Some(view) = view else { return };
        let (Curve::Ellipse, Caps::Across(ends)) = (view.curve, &row.caps) else {
            return self.set_rare(view, row, x, span);
        };
        match view.chord(row, x) {
            Some(chord) => {
                set_common(span, chord, ends.at(&view.caps, x), faces(view.caps.high_first()));
            }
            None => *span = Span::NOWHERE,
        }
    }
}

impl<S: Scalar> Cone<S> {
    /// Sets the span of a ray that is steeper than the side, or runs nearly along it or along the caps.
    #[inline(never)]
    fn set_rare(
        &self,
        view: &OrthographicView<S>,
        row: &OrthographicRow<S>,
        x: i32,
        span: &mut Span<S>,
    ) {
        let caps = match &row.caps {
            Caps::Across(ends) => ends.span(&view.caps, x),
            Caps::EdgeOn(caps) => self.caps.edge_on_span(caps, x),
            Caps::Nowhere => None,
        };
        *span = Span::NOWHERE;
        if let Some(chord) = view.chord(row, x) {
            cut(span, chord, caps);
        }
    }

    /// Where the cone is along a direction, as seen from its base.
    fn strip(&self, rays: &OrthographicRays<S>, way: Vec3<S::Wide>) -> Strip<S> {
        let Self { taper, caps } = self;
        let (axis, base) = (&caps.normal, taper.base.wide());
        let (slope, at_base) = (axis.dot_wide(way), axis.dot_wide(base));
        // How much of a radius a cap's disc has along the direction; what squares lose is added.
        let lost = S::Wide::QUANTUM * S::Wide::from_int(8);
        let part = (axis.wide().cross(way).length_squared() + lost).sqrt();
        let ends = [(caps.low, taper.radii[0]), (caps.high, taper.radii[1])];
        let [[low, from], [high, to]] = ends.map(|(offset, radius)| {
            ((offset.wide() - at_base) * slope).around(radius.wide() * part)
        });
        let reach = caps.low.wide().abs() + caps.high.wide().abs() + self.widest();
        let size = (rays.center - base).max_abs() + at_base.abs() + reach;
        Strip {
            at: rays.steps(base).map(|step| step.dot_compensated(way)),
            ends: [low.min(high), from.max(to)],
            // Three coordinates, each of which is as large as that.
            size: size + size + size,
        }
    }
}

/// How rays meet the wall's nappe.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Curve {
    /// Nearly along the side, or however.
    Any,
    /// Flatter than the side: twice.
    Ellipse,
    /// Steeper than the side: once.
    Steep,
}

/// A cone, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    curve: Curve,
    stretch: S::Scale,
    /// Its coordinates are the width w, κ and the middle, but for any curve.
    wall: PixelView<S>,
    /// Of κ or of w ± κ, the least and the most.
    sides: [S::Wide; 2],
    along: Strip<S>,
    caps: CapsView<S>,
    rows: Rows,
}

impl<S: Scalar> OrthographicView<S> {
    /// Where a ray is inside the wall.
    #[inline(always)]
    fn chord(&self, row: &OrthographicRow<S>, x: i32) -> Option<[S; 2]> {
        if self.curve == Curve::Any {
            return self.wall.chord(&row.from, self.wall.step, x);
        }
        let [width, distance, middle] = after(&row.from, &self.wall.from[1], x);
        let [width, distance] = [width, distance].map(S::from_wide);
        let around = |half: S| middle.around(half.stretched(self.stretch)).map(S::from_wide);
        if self.curve == Curve::Ellipse {
            // Beyond the tip, the width is below zero.
            return S::leg(width.max(S::ZERO), distance).map(around);
        }
        let [first, last] = around(S::length([width, distance, S::ZERO]));
        let is_wider_behind = self.wall.step[2] > S::Wide::ZERO;
        Some(if is_wider_behind { [last, S::HIGHEST] } else { [S::LOWEST, first] })
    }
}

/// A length along a direction in the middle of a picture and its steps to the right and down, and from
/// where to where the cone is.
#[derive(Debug, Clone, Copy)]
struct Strip<S: Scalar> {
    at: [S::Wide; 3],
    ends: [S::Wide; 2],
    size: S::Wide,
}

impl<S: Scalar> Strip<S> {
    fn steps(&self, middle: S::Wide, step: S::Wide) -> Steps {
        let [low, high] = self.ends;
        Steps::between::<S>(Affine { middle, step }, low, high, self.size)
    }
}

/// A row of a cone, seen along parallel rays: the wall's coordinates in its middle.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicRow<S: Scalar> {
    from: [S::Wide; 3],
    caps: Caps<S>,
}

impl<S: Scalar> Empty for OrthographicRow<S> {
    const EMPTY: Self = Self { from: [S::Wide::ZERO; 3], caps: Caps::EMPTY };
}
