//! Planes along parallel rays: they are crossed at parameters that are affine in the column.

use super::FaceView;
use crate::geom::{Affine, Direction, OrthographicRays, Vec3, signed};
use crate::quadric::{HalfSpace, Planes};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::Empty;
use crate::scan::bounds::Steps;
use crate::span::{Crossing, Face, Span};

impl<S: Scalar> Planes<S> {
    /// What a camera decides.
    pub(crate) fn orthographic_view(&self, rays: &OrthographicRays<S>) -> OrthographicView<S> {
        OrthographicView::new(&self.normal, rays)
    }

    /// What a row decides.
    pub(crate) fn orthographic_row(
        &self,
        view: &OrthographicView<S>,
        y: i32,
        columns: u32,
    ) -> OrthographicRow<S> {
        let OrthographicView { inverse, step, .. } = *view;
        let height = view.row_height(y);
        if inverse == S::Wide::ZERO {
            return OrthographicRow::EdgeOn(view.edge_on(height));
        }
        let [low, high] = [self.low, self.high].map(|offset| (offset.wide() - height) * inverse);
        if [low, high].iter().all(|at| at.holds_steps(step, signed(columns))) {
            let (near, far) = if view.high_first() { (high, low) } else { (low, high) };
            return OrthographicRow::Across(Ends { near, far });
        }
        OrthographicRow::EdgeOn(view.edge_on(height))
    }

    /// The span of a ray.
    #[inline]
    pub(crate) fn orthographic_span(
        &self,
        view: &OrthographicView<S>,
        row: &OrthographicRow<S>,
        x: i32,
    ) -> Option<Span<S>> {
        match row {
            OrthographicRow::Nowhere => None,
            OrthographicRow::Across(ends) => ends.span(view, x),
            OrthographicRow::EdgeOn(row) => self.edge_on_span(row, x),
        }
    }

    /// The span of a ray along the planes, or almost.
    #[inline]
    pub(crate) fn edge_on_span(&self, row: &EdgeOn<S>, x: i32) -> Option<Span<S>> {
        self.crossed(row.height.after_steps(row.step, x), row.speed).span()
    }

    /// Where rays along the planes, or almost, can be between them.
    pub(crate) fn edge_on_steps(&self, row: &EdgeOn<S>) -> Steps {
        if row.speed != S::Wide::ZERO {
            return Steps::ALL;
        }
        let (low, high) = (self.low.wide(), self.high.wide());
        let height = Affine { middle: row.height, step: row.step };
        let size = low.abs() + high.abs() + row.height.abs();
        Steps::between::<S>(height, low, high, size)
    }
}

impl<S: Scalar> Ends<S> {
    /// Where the planes are crossed.
    #[inline(always)]
    pub(crate) fn at(&self, view: &OrthographicView<S>, x: i32) -> [S; 2] {
        [self.near, self.far].map(|end| S::from_wide(end.after_steps(view.step, x)))
    }

    /// The span of a ray.
    #[inline]
    pub(crate) fn span(&self, view: &OrthographicView<S>, x: i32) -> Option<Span<S>> {
        let [enter, exit] = self.at(view, x);
        let [near, far] = faces(view.high_first());
        Span::new(Crossing { t: enter, face: near }, Crossing { t: exit, face: far })
    }

    /// Where rays of the columns can be between these planes and two others at the same time.
    pub(crate) fn common_steps(
        &self,
        view: &OrthographicView<S>,
        other: &Self,
        other_view: &OrthographicView<S>,
        columns: u32,
    ) -> Steps {
        let apart = Affine { middle: S::Wide::ZERO, step: view.step - other_view.step };
        let way = |step| S::Wide::ZERO.after_steps(step, signed(columns)).abs();
        let ends = [self.near, self.far, other.near, other.far];
        let size = ends.into_iter().fold(S::Wide::ZERO, |sum, end| sum + end.abs())
            + (way(view.step) + way(other_view.step));
        Steps::between::<S>(apart, other.near - self.far, other.far - self.near, size)
    }

    /// Where rays of the columns can be between the planes no farther than `reach` from `middle`.
    pub(crate) fn steps(
        &self,
        view: &OrthographicView<S>,
        middle: Affine<S::Wide>,
        reach: S::Wide,
        columns: u32,
    ) -> Steps {
        let (near, far) = (self.near - reach, self.far + reach);
        // The ends move as well: what counts is how the middle moves along them.
        let along = Affine { step: middle.step - view.step, ..middle };
        let way = S::Wide::ZERO.after_steps(middle.step, signed(columns));
        let size = near.abs().max(far.abs()) + middle.middle.abs() + way.abs() + reach;
        Steps::between::<S>(along, near, far, size)
    }
}

/// Planes, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    /// normal·p in the middle of the image plane, and its step down.
    height: [S::Wide; 2],
    /// 1/(normal·d), or 0 if the rays run along the planes.
    inverse: S::Wide,
    /// What half a column adds to where the planes are crossed; or to the height, for rays along
    /// the planes.
    step: S::Wide,
}

impl<S: Scalar> OrthographicView<S> {
    /// What a camera decides about all planes with a normal.
    pub(crate) fn new(normal: &Direction<S>, rays: &OrthographicRays<S>) -> Self {
        let speed = normal.dot_wide(rays.forward);
        let inverse = if speed.is_divisor() { S::Wide::ONE / speed } else { S::Wide::ZERO };
        let [middle, right, down] = rays.steps(Vec3::ZERO).map(|step| normal.dot_wide(step));
        let is_edge_on = inverse == S::Wide::ZERO;
        let step = if is_edge_on { right } else { -right * inverse };
        Self { height: [middle, down], inverse, step }
    }

    /// As a pool keeps it.
    pub(crate) fn keep(&self) -> FaceView<S> {
        let [middle, down] = self.height;
        FaceView([middle, down, self.inverse, self.step])
    }

    /// One that a pool has kept.
    #[inline(always)]
    pub(crate) fn kept(&FaceView([middle, down, inverse, step]): &FaceView<S>) -> Self {
        Self { height: [middle, down], inverse, step }
    }

    /// Whether rays exit from a half-space with this normal.
    #[inline]
    pub(crate) fn exits(&self) -> bool {
        self.inverse > S::Wide::ZERO
    }

    /// What half a column adds to where the planes are crossed.
    #[inline]
    pub(crate) fn step(&self) -> S::Wide {
        self.step
    }

    /// normal·p in the middle of a row.
    fn row_height(&self, y: i32) -> S::Wide {
        let [middle, down] = self.height;
        middle.after_steps(down, y)
    }

    /// A row of rays along the planes, or almost.
    pub(crate) fn edge_on(&self, height: S::Wide) -> EdgeOn<S> {
        if self.inverse == S::Wide::ZERO {
            return EdgeOn { height, step: self.step, speed: S::Wide::ZERO };
        }
        let speed = S::Wide::ONE / self.inverse;
        EdgeOn { height, step: -(self.step * speed), speed }
    }

    /// Whether rays meet the high plane before the low one.
    #[inline]
    pub(crate) fn high_first(&self) -> bool {
        self.inverse < S::Wide::ZERO
    }
}

/// The planes in the order in which rays meet them.
#[inline]
pub(crate) fn faces(high_first: bool) -> [Face; 2] {
    let near = u16::from(high_first);
    [Face(near), Face(1 - near)]
}

impl<S: Scalar> Empty for OrthographicView<S> {
    const EMPTY: Self =
        Self { height: [S::Wide::ZERO; 2], inverse: S::Wide::ZERO, step: S::Wide::ZERO };
}

/// A row of planes, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub enum OrthographicRow<S: Scalar> {
    /// Not set yet.
    Nowhere,
    /// Both planes are crossed, at parameters that are affine in the column.
    Across(Ends<S>),
    /// The rays run along the planes, or almost.
    EdgeOn(EdgeOn<S>),
}

impl<S: Scalar> Empty for OrthographicRow<S> {
    const EMPTY: Self = Self::Nowhere;
}

/// A row of one plane, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub enum OrthographicFace<S: Scalar> {
    /// Not set yet.
    Nowhere,
    /// The plane is crossed at parameters that are affine in the column: this one in the middle.
    Across(S::Wide),
    /// The rays run along the plane, or almost.
    EdgeOn(EdgeOn<S>),
}

impl<S: Scalar> Empty for OrthographicFace<S> {
    const EMPTY: Self = Self::Nowhere;
}

impl<S: Scalar> HalfSpace<S> {
    /// What a row decides.
    pub(crate) fn orthographic_face(
        &self,
        view: &OrthographicView<S>,
        y: i32,
        columns: u32,
    ) -> OrthographicFace<S> {
        let height = view.row_height(y);
        let at = (self.offset.wide() - height) * view.inverse;
        if view.inverse != S::Wide::ZERO && at.holds_steps(view.step, signed(columns)) {
            return OrthographicFace::Across(at);
        }
        OrthographicFace::EdgeOn(view.edge_on(height))
    }

    /// Cuts off the part of a ray that is outside; `false` if all of it is.
    #[inline(always)]
    pub(crate) fn cut_orthographic(
        &self,
        view: &OrthographicView<S>,
        row: &OrthographicFace<S>,
        x: i32,
        face: Face,
        span: &mut Span<S>,
    ) -> bool {
        match row {
            OrthographicFace::Across(at) => {
                let t = S::from_wide(at.after_steps(view.step, x));
                span.cut(Crossing { t, face }, view.exits());
                true
            }
            OrthographicFace::EdgeOn(row) => {
                let height = row.height.after_steps(row.step, x);
                self.cut(height, row.speed, face, span)
            }
            OrthographicFace::Nowhere => false,
        }
    }

    /// The same, from how high the ray is at t = 0 and how it rises.
    #[inline]
    pub(crate) fn cut(
        &self,
        height: S::Wide,
        speed: S::Wide,
        face: Face,
        span: &mut Span<S>,
    ) -> bool {
        let above = self.offset.wide() - height;
        if speed == S::Wide::ZERO {
            return self.has_below(above, S::Wide::ZERO);
        }
        let [t, _] = S::quotients([above; 2], speed);
        span.cut(Crossing { t, face }, speed > S::Wide::ZERO);
        true
    }
}

/// Where the middle of a row crosses the planes: first the one, then the other.
#[derive(Debug, Clone, Copy)]
pub struct Ends<S: Scalar> {
    pub(crate) near: S::Wide,
    pub(crate) far: S::Wide,
}

/// A row of rays along the planes, or almost. The view knows it from the height alone.
#[derive(Debug, Clone, Copy)]
pub struct EdgeOn<S: Scalar> {
    /// normal·p in the middle, and what half a column adds to it.
    pub(crate) height: S::Wide,
    step: S::Wide,
    /// normal·d.
    speed: S::Wide,
}
