//! Two planes along parallel rays: both are crossed at parameters that are affine in the column.

use crate::geom::{Affine, OrthographicRays, Vec3, signed};
use crate::quadric::Planes;
use crate::scalar::{Number, Real, Scalar};
use crate::scan::Empty;
use crate::scan::bounds::Steps;
use crate::span::{Crossing, Face, Span};

impl<S: Scalar> Planes<S> {
    /// What a camera decides.
    pub(crate) fn orthographic_view(&self, rays: &OrthographicRays<S>) -> OrthographicView<S> {
        let speed = self.normal.dot_wide(rays.forward);
        let inverse = if speed.is_divisor() { S::Wide::ONE / speed } else { S::Wide::ZERO };
        let [middle, right, down] = rays.steps(Vec3::ZERO).map(|step| self.normal.dot_wide(step));
        let is_edge_on = inverse == S::Wide::ZERO;
        let step = if is_edge_on { right } else { -right * inverse };
        OrthographicView { height: [middle, down], inverse, step }
    }

    /// What a row decides.
    pub(crate) fn orthographic_row(
        &self,
        view: &OrthographicView<S>,
        y: i32,
        columns: u32,
    ) -> OrthographicRow<S> {
        let OrthographicView { height: [middle, down], inverse, step } = *view;
        let height = middle.after_steps(down, y);
        if inverse == S::Wide::ZERO {
            return OrthographicRow::EdgeOn(EdgeOn { height, step, speed: S::Wide::ZERO });
        }
        let [low, high] = [self.low, self.high].map(|offset| (offset.wide() - height) * inverse);
        if [low, high].iter().all(|at| at.holds_steps(step, signed(columns))) {
            let (near, far) = if view.high_first() { (high, low) } else { (low, high) };
            return OrthographicRow::Across(Ends { near, far });
        }
        let speed = S::Wide::ONE / inverse;
        OrthographicRow::EdgeOn(EdgeOn { height, step: -(step * speed), speed })
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

/// Where the middle of a row crosses the planes: first the one, then the other.
#[derive(Debug, Clone, Copy)]
pub struct Ends<S: Scalar> {
    near: S::Wide,
    far: S::Wide,
}

/// A row of rays along the planes, or almost.
#[derive(Debug, Clone, Copy)]
pub struct EdgeOn<S: Scalar> {
    /// normal·p in the middle, and what half a column adds to it.
    height: S::Wide,
    step: S::Wide,
    /// normal·d.
    speed: S::Wide,
}
