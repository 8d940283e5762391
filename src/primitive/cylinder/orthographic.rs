//! The cylinder along parallel rays.
//!
//! All rays have the same angle to the axis, so the view divides by it once: what is left for the
//! pixel is κ, the distance of its ray from the axis, which is affine in the column. The chord is
//! `middle ± √(r² − κ²) · stretch`, with an affine middle and `stretch` = 1/|d × axis|.

use super::{Cylinder, frame, set_common, wall_span};
use crate::geom::{Affine, Extent, OrthographicRays};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::bounds::{Rows, Steps};
use crate::scan::planes::{self, Ends};
use crate::scan::{Empty, Leaf};
use crate::span::Span;

impl<S: Scalar> Leaf<OrthographicRays<S>> for Cylinder<S> {
    type View = OrthographicView<S>;
    type Row = OrthographicRow<S>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        let axis = self.caps.normal.wide();
        let m = rays.forward.cross(axis);
        let steps = rays.steps(self.wall.base.wide());
        let moments = steps.map(|step| step.cross(axis));
        let (caps, rows) = (self.caps.orthographic_view(rays), self.rows(rays));
        // An angle too small to divide by hardly moves a ray within the length of a scene.
        let across = m.max_abs().is_divisor().then(|| m.normalized()).flatten();
        if let Some(n) = across {
            let exact = S::Wide::ONE / m.dot(n);
            let stretch = S::scale(exact);
            // The root of a square need not be what was squared.
            let reach = S::leg(self.wall.radius, S::ZERO).unwrap_or(self.wall.radius);
            OrthographicView {
                first: steps.map(|step| step.dot_compensated(n)),
                second: moments.map(|moment| -moment.dot_compensated(n) * exact),
                stretch,
                reach: reach.stretched(stretch),
                caps,
                rows,
            }
        } else {
            let [side, other] = frame(axis);
            OrthographicView {
                first: moments.map(|moment| moment.dot(side)),
                second: moments.map(|moment| moment.dot(other)),
                caps,
                rows,
                ..OrthographicView::EMPTY
            }
        }
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.rows.meet(rows)
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        let [first, second] = [view.first, view.second].map(|of| Affine::row(of, y));
        let beside = |length| Steps::within::<S>(length, self.wall.radius.wide());
        let within_wall = beside(first);
        (row.first, row.second) = (first.middle, second.middle);
        row.kind = Kind::Nowhere;
        if within_wall.are_beside(columns) {
            return Extent::EMPTY;
        }
        let steps = match (view.is_along(), self.caps.orthographic_row(&view.caps, y, columns)) {
            (false, planes::OrthographicRow::Across(caps)) => {
                row.kind = Kind::Across { caps, high_first: view.caps.high_first() };
                caps.steps(&view.caps, second, view.reach, columns)
            }
            (false, planes::OrthographicRow::EdgeOn(caps)) => {
                row.kind = Kind::EdgeOn(caps.height);
                self.caps.edge_on_steps(&caps)
            }
            (true, planes::OrthographicRow::Across(caps)) => {
                row.kind = Kind::Along(caps);
                beside(second)
            }
            // Who looks along the axis doesn't look along the caps.
            _ => Steps::NONE,
        };
        steps.overlap(within_wall).columns(columns)
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        let Kind::Across { caps, high_first } = &row.kind else {
            *span = self.rare_span(view, row, x).unwrap_or(Span::NOWHERE);
            return;
        };
        match self.chord(view, row, x) {
            Some(chord) => {
                set_common(span, chord, caps.at(&view.caps, x), planes::faces(*high_first));
            }
            None => *span = Span::NOWHERE,
        }
    }

    #[inline(always)]
    fn may_contain(&self, view: &Self::View, row: &Self::Row, x: i32, t: S) -> bool {
        let Kind::Across { .. } = row.kind else { return true };
        let [_, along, _] = view.second;
        let middle = row.second.after_steps(along, x);
        let [low, high] = middle.around(view.reach).map(S::from_wide);
        // Both together: one branch is predicted more often than two.
        (low <= t) & (t < high)
    }
}

impl<S: Scalar> Cylinder<S> {
    /// The rows between the lowest and the highest point of balls around the middles of the caps.
    fn rows(&self, rays: &OrthographicRays<S>) -> Rows {
        let axis = &self.caps.normal;
        let base = self.wall.base.wide();
        let ends = [self.caps.low.wide(), self.caps.high.wide()];
        let along = axis.dot_wide(base);
        let slope = axis.dot_wide(rays.down);
        let from_center = base - rays.center;
        let across = from_center.dot_compensated(rays.down);
        let [low_end, high_end] = ends.map(|offset| across + slope * (offset - along));
        let radius = self.wall.radius.wide();
        let (low, high) = (low_end.min(high_end) - radius, low_end.max(high_end) + radius);
        let from_middle = Affine { middle: S::Wide::ZERO, step: rays.half_pixel };
        let size = from_center.max_abs() + along.abs() + ends[0].abs() + ends[1].abs() + radius;
        // Three coordinates, each of which is as large as that.
        let size = size + size + size;
        Rows::of(Steps::between::<S>(from_middle, low, high, size))
    }

    /// Where rays across the axis meet the wall.
    #[inline(always)]
    fn chord(
        &self,
        view: &OrthographicView<S>,
        row: &OrthographicRow<S>,
        x: i32,
    ) -> Option<[S; 2]> {
        let ([_, right, _], [_, along, _]) = (view.first, view.second);
        let distance = S::from_wide(row.first.after_steps(right, x));
        let half = S::leg(self.wall.radius, distance)?.stretched(view.stretch);
        let middle = row.second.after_steps(along, x);
        Some(middle.around(half).map(S::from_wide))
    }

    /// Of rays along the axis, or along the caps.
    #[inline(never)]
    fn rare_span(
        &self,
        view: &OrthographicView<S>,
        row: &OrthographicRow<S>,
        x: i32,
    ) -> Option<Span<S>> {
        match &row.kind {
            Kind::EdgeOn(height) => {
                let [enter, exit] = self.chord(view, row, x)?;
                self.caps
                    .edge_on_span(&view.caps.edge_on(*height), x)?
                    .overlap(wall_span(enter, exit)?)
            }
            Kind::Along(caps) => {
                let ([_, step, _], [_, other, _]) = (view.first, view.second);
                let across = [(row.first, step), (row.second, other)]
                    .map(|(middle, step)| S::from_wide(middle.after_steps(step, x)));
                let is_inside = S::length([across[0], across[1], S::ZERO]) < self.wall.radius;
                caps.span(&view.caps, x).filter(|_| is_inside)
            }
            Kind::Nowhere | Kind::Across { .. } => None,
        }
    }
}

/// A cylinder, seen along parallel rays: values in the middle of the picture, and their steps to
/// the right and down.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    /// κ; or, where the camera looks along the axis, a coordinate of the ray's place across it.
    first: [S::Wide; 3],
    /// The middle of the chord; or the other coordinate.
    second: [S::Wide; 3],
    /// 0 for a camera that looks along the axis: any other stretch is 1 at least.
    stretch: S::Scale,
    /// The longest half-chord.
    reach: S::Wide,
    caps: planes::OrthographicView<S>,
    rows: Rows,
}

impl<S: Scalar> OrthographicView<S> {
    fn is_along(&self) -> bool {
        self.stretch == S::NO_SCALE
    }
}

impl<S: Scalar> Empty for OrthographicView<S> {
    const EMPTY: Self = Self {
        first: [S::Wide::ZERO; 3],
        second: [S::Wide::ZERO; 3],
        stretch: S::NO_SCALE,
        reach: S::Wide::ZERO,
        caps: planes::OrthographicView::EMPTY,
        rows: Rows::EMPTY,
    };
}

/// A row of a cylinder, seen along parallel rays: values in the middle of the row.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicRow<S: Scalar> {
    /// As in the view.
    first: S::Wide,
    second: S::Wide,
    kind: Kind<S>,
}

#[derive(Debug, Clone, Copy)]
enum Kind<S: Scalar> {
    /// The cylinder can't be seen.
    Nowhere,
    /// The rays cross the wall and the caps.
    Across {
        caps: Ends<S>,
        /// Whether rays meet the high cap before the low one: here, where it takes no room.
        high_first: bool,
    },
    /// The rays run along the axis.
    Along(Ends<S>),
    /// The rays run along the caps, or almost: the height of [`EdgeOn`](planes::EdgeOn).
    EdgeOn(S::Wide),
}

impl<S: Scalar> Empty for OrthographicRow<S> {
    const EMPTY: Self = Self { first: S::Wide::ZERO, second: S::Wide::ZERO, kind: Kind::Nowhere };
}
