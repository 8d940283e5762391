//! The sphere along parallel rays.

use super::{Sphere, span};
use crate::geom::{Affine, Extent, OrthographicRays};
use crate::scalar::{Real, Scalar};
use crate::scan::Leaf;
use crate::scan::bounds::Steps;
use crate::span::Span;

/// In the image plane the ball is a disc, and a row cuts a chord out of it.
impl<S: Scalar> Leaf<OrthographicRays<S>> for Sphere<S> {
    type View = Option<OrthographicView<S>>;
    type Row = Option<OrthographicRow<S>>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        let from_center = rays.center - self.ball.center.wide();
        Some(OrthographicView {
            along: from_center.dot_compensated(rays.right),
            across: from_center.dot_compensated(rays.down),
            half_pixel: rays.half_pixel,
            middle: S::from_wide(-from_center.dot_compensated(rays.forward)),
        })
    }

    /// By the same numbers as [`row`](Leaf::row), so it is exact.
    #[inline]
    fn is_in_rows(&self, view: &Self::View, [first, last]: [i32; 2]) -> bool {
        view.as_ref().is_some_and(|view| {
            let radius = self.ball.radius;
            view.across(first) <= radius && radius.negated() <= view.across(last)
        })
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        *row = None;
        let Some(view) = view else { return Extent::EMPTY };
        let Some(radius) = S::leg(self.ball.radius, view.across(y)) else { return Extent::EMPTY };
        *row = Some(OrthographicRow { radius });
        let along = Affine { middle: view.along, step: view.half_pixel };
        Steps::within::<S>(along, radius.wide()).columns(columns)
    }

    #[inline]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [kept]: &mut [Span<S>; 1]) {
        *kept = Span::NOWHERE;
        let (Some(view), Some(row)) = (view, row) else { return };
        let across = S::from_wide(view.along.after_steps(view.half_pixel, x));
        if let Some(half) = S::leg(row.radius, across)
            && let Some(span) = span(view.middle.minus(half), view.middle.plus(half))
        {
            *kept = span;
        }
    }
}

/// A sphere, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    /// The middle of the picture, seen from the sphere's centre, to the right and down.
    along: S::Wide,
    across: S::Wide,
    /// The size of half a pixel.
    half_pixel: S::Wide,
    /// The parameter in the middle of chords.
    middle: S,
}

impl<S: Scalar> OrthographicView<S> {
    /// How far below the sphere's centre a row is.
    #[inline]
    fn across(&self, y: i32) -> S {
        S::from_wide(self.across.after_steps(self.half_pixel, y))
    }
}

/// A row of a sphere, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicRow<S: Scalar> {
    /// Of the circle that the row cuts out.
    radius: S,
}
