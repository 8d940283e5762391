//! The cone along parallel rays.
//!
//! All rays have the same angle to the axis. If they are clearly flatter than the side, a pixel's chord is
//! `middle ± √(w² − κ²) · stretch`, as a cylinder's, but w is affine in the column, as κ and the middle are.
//! With g the third coordinate of a [`Conic`](crate::quadric::Conic) and s its step, and with q the place
//! and |d| the way across the axis along the ray, `w = (g·|d| − s·q)/√a` and
//! `middle = (g·s − cos² q·|d|)/a`, where `a = cos²|d|² − s²`. The lines w = ±κ are the outline of the wall.
//!
//! If they are clearly steeper, a < 0, it is `middle ± √(w² + κ²) · stretch` with |a| under the root: one of
//! the two, and the cone is beyond it. Rays nearly along the side are asked one by one.

use super::pixel::{PixelView, after};
use super::{Cone, cut, frame, set_common};
use crate::geom::{Affine, Extent, OrthographicRays, Vec3};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::bounds::{Rows, Steps};
use crate::scan::planes::{OrthographicRow as Caps, OrthographicView as CapsView, faces};
use crate::scan::{Empty, Leaf};
use crate::span::Span;

impl<S: Scalar> Leaf<OrthographicRays<S>> for Cone<S> {
    type View = OrthographicView<S>;
    type Row = OrthographicRow<S>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> OrthographicView<S> {
        let from_base = rays.center - self.taper.base.wide();
        let [rows, columns] = [rays.down, rays.right].map(|way| {
            let at = Affine { middle: from_base.dot_compensated(way), step: rays.half_pixel };
            self.strip(rays, way).steps(at)
        });
        let fast = self.fast(rays);
        OrthographicView {
            wall: fast.map_or_else(|| PixelView::new(self, rays), |(wall, _)| wall),
            fast: fast.map(|(_, fast)| fast),
            caps: self.caps.orthographic_view(rays),
            rows: Rows::of(rows),
            columns,
        }
    }

    #[inline]
    fn is_in_rows(&self, view: &OrthographicView<S>, rows: [i32; 2]) -> bool {
        view.rows.meet(rows)
    }

    #[inline(never)]
    fn row(
        &self,
        view: &OrthographicView<S>,
        y: i32,
        columns: u32,
        row: &mut OrthographicRow<S>,
    ) -> Extent {
        let [middle, right, down] = &view.wall.from;
        row.from = after(middle, down, y);
        let steps = match &view.fast {
            Some(fast) => {
                let ([width, distance, _], [to_width, to_distance, _]) = (row.from, *right);
                let inside = |middle, step| fast.sides.steps(Affine { middle, step });
                let sides = if fast.curve == Curve::Ellipse {
                    inside(width + distance, to_width + to_distance)
                        .overlap(inside(width - distance, to_width - to_distance))
                } else {
                    inside(distance, to_distance)
                };
                fast.ends.steps(Affine::row(fast.along, y)).overlap(sides)
            }
            None => view.columns,
        };
        if steps.are_beside(columns) {
            return Extent::EMPTY;
        }
        row.caps = self.caps.orthographic_row(&view.caps, y, columns);
        steps.columns(columns)
    }

    #[inline(always)]
    fn spans(
        &self,
        view: &OrthographicView<S>,
        row: &OrthographicRow<S>,
        x: i32,
        [span]: &mut [Span<S>; 1],
    ) {
        *span = Span::NOWHERE;
        let wall = &view.wall;
        let chord = match &view.fast {
            Some(fast) => {
                let [width, distance, middle] = after(&row.from, &wall.from[1], x);
                fast.chord([width, distance].map(S::from_wide), middle)
            }
            None => wall.chord(&row.from, wall.step, x),
        };
        let Some(chord) = chord else { return };
        match &row.caps {
            Caps::Across(ends) => {
                let faces = faces(view.caps.high_first());
                set_common(span, chord, ends.at(&view.caps, x), faces);
            }
            Caps::EdgeOn(caps) => cut(span, chord, self.caps.edge_on_span(caps, x)),
            Caps::Nowhere => {}
        }
    }
}

impl<S: Scalar> Cone<S> {
    /// Where the cone is along a direction, as seen from its base.
    fn strip(&self, rays: &OrthographicRays<S>, way: Vec3<S::Wide>) -> Strip<S> {
        let Self { taper, caps } = self;
        let (axis, base) = (&caps.normal, taper.base.wide());
        let (slope, at_base) = (axis.dot_wide(way), axis.dot_wide(base));
        // The discs of the caps are so wide; what a square loses is added.
        let lost = S::Wide::QUANTUM * S::Wide::from_int(8);
        let part = (axis.wide().cross(way).length_squared() + lost).sqrt();
        let [low, high] =
            [(caps.low, taper.radii[0]), (caps.high, taper.radii[1])].map(|(offset, radius)| {
                let (middle, half) = ((offset.wide() - at_base) * slope, radius.wide() * part);
                [middle - half, middle + half]
            });
        let [low_end, high_end] = [caps.low, caps.high].map(|offset| offset.wide().abs());
        let widest = taper.radii[0].max(taper.radii[1]).wide();
        let size = (rays.center - base).max_abs() + at_base.abs() + low_end + high_end + widest;
        // Three coordinates, each of which is as large as that.
        Strip { low: low[0].min(high[0]), high: low[1].max(high[1]), size: size + size + size }
    }

    /// What rays that are clearly flatter than the side, or steeper, have besides: with w, κ and the middle
    /// for the wall's coordinates.
    fn fast(&self, rays: &OrthographicRays<S>) -> Option<(PixelView<S>, Fast<S>)> {
        let Self { taper, caps } = self;
        let (axis, base) = (&caps.normal, taper.base.wide());
        let [cosine, sine] = taper.slant.map(S::wide_unit);
        let m = rays.forward.cross(axis.wide());
        // An angle too small to divide by hardly moves a ray within the length of a scene.
        let across = m.max_abs().is_divisor().then(|| m.normalized()).flatten();
        let [n, _] = across.map_or_else(|| frame(axis.wide()), |n| [n; 2]);
        let across = across.map_or(S::Wide::ZERO, |n| m.dot(n));
        let (way, growth) = (across * cosine, axis.dot_wide(rays.forward) * sine);
        let a = S::Wide::product_difference(way, way, growth, growth);
        if a.abs() * S::Wide::from_int(32) < S::Wide::ONE {
            return None;
        }
        let curve = match () {
            () if a > S::Wide::ZERO => Curve::Ellipse,
            () if growth > S::Wide::ZERO => Curve::After,
            () => Curve::Before,
        };
        let [root, inverse] = [S::Wide::ONE / a.abs().sqrt(), S::Wide::ONE / a];
        let values = |v: Vec3<S::Wide>, radius: S::Wide| {
            let radius = axis.dot_wide(v) * sine + radius;
            let place = v.cross(axis.wide()).dot_compensated(n);
            let width = S::Wide::product_difference(radius, across, growth, place) * root;
            let middle = S::Wide::product_difference(radius, growth, place * cosine, way);
            [width, v.dot_compensated(n), middle * inverse]
        };
        let radius =
            taper.radii[0].wide() * cosine + (axis.dot_wide(base) - caps.low.wide()) * sine;
        let steps @ [middle, right, down] = rays.steps(base);
        let still = S::Wide::ZERO;
        let from = [values(middle, radius), values(right, still), values(down, still)];
        let along = n.cross(rays.forward);
        let ends = self.strip(rays, along);
        let widest = taper.radii[0].max(taper.radii[1]).wide();
        let (low, high) = if curve == Curve::Ellipse {
            // At a point inside, g is at most r·cos, and q and κ are at most r.
            (S::Wide::ZERO, widest + widest * (way + growth.abs()) * root)
        } else {
            (-widest, widest)
        };
        let fast = Fast {
            curve,
            stretch: S::scale(cosine * root),
            along: steps.map(|step| step.dot_compensated(along)),
            sides: Strip { low, high, size: ends.size * S::Wide::from_int(8) },
            ends,
        };
        Some((PixelView { from, step: [S::Wide::ZERO; 3] }, fast))
    }
}

/// A cone, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    wall: PixelView<S>,
    fast: Option<Fast<S>>,
    caps: CapsView<S>,
    rows: Rows,
    columns: Steps,
}

/// How rays meet the wall's nappe.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Curve {
    /// They are flatter than the side: twice.
    Ellipse,
    /// They are steeper: once, and are inside behind that.
    After,
    /// They are steeper: once, and are inside before that.
    Before,
}

/// What all rays that are not nearly along the side have in common.
#[derive(Debug, Clone, Copy)]
struct Fast<S: Scalar> {
    curve: Curve,
    stretch: S::Scale,
    /// The place in the picture along the axis: in the middle, and its steps to the right and down.
    along: [S::Wide; 3],
    ends: Strip<S>,
    sides: Strip<S>,
}

impl<S: Scalar> Fast<S> {
    #[inline(always)]
    fn chord(&self, [width, distance]: [S; 2], middle: S::Wide) -> Option<[S; 2]> {
        let around = |half: S| middle.around(half.stretched(self.stretch)).map(S::from_wide);
        if self.curve == Curve::Ellipse {
            // Beyond the tip, it is below zero.
            return S::leg(width.max(S::ZERO), distance).map(around);
        }
        let [first, last] = around(S::length([width, distance, S::ZERO]));
        let is_after = self.curve == Curve::After;
        Some(if is_after { [last, S::HIGHEST] } else { [S::LOWEST, first] })
    }
}

/// Where a length is between two, with what its error depends on.
#[derive(Debug, Clone, Copy)]
struct Strip<S: Scalar> {
    low: S::Wide,
    high: S::Wide,
    size: S::Wide,
}

impl<S: Scalar> Strip<S> {
    fn steps(&self, at: Affine<S::Wide>) -> Steps {
        Steps::between::<S>(at, self.low, self.high, self.size)
    }
}

impl<S: Scalar> Empty for OrthographicView<S> {
    const EMPTY: Self = Self {
        wall: PixelView::EMPTY,
        fast: None,
        caps: CapsView::EMPTY,
        rows: Rows::EMPTY,
        columns: Steps::NONE,
    };
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
