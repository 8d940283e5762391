//! Walking along a ray of the scene by the crossings in a solid's own frame.

use crate::geom::{OrthographicRays, Parameters};
use crate::scalar::Scalar;
use crate::scan::{ColumnRun, Empty, Scan};
use crate::span::walk::{Path, Step};
use crate::span::{Crossing, Face, Shape};

/// A solid's row of parallel rays in its own frame.
#[derive(Debug, Clone, Copy)]
pub struct OwnRow<V, D> {
    is_there: bool,
    view: V,
    row: D,
}

impl<V: Empty, D: Empty> Empty for OwnRow<V, D> {
    const EMPTY: Self = Self { is_there: false, view: V::EMPTY, row: D::EMPTY };
}

/// The row of a solid that parallel rays see in its own frame.
pub(super) type RowOf<T> = OwnRow<
    <T as Scan<OrthographicRays<<T as Shape>::Scalar>>>::View,
    <T as Scan<OrthographicRays<<T as Shape>::Scalar>>>::Row,
>;

impl<V, D: Empty> OwnRow<V, D> {
    /// Sets the row in the middle of a picture, or none.
    pub(super) fn set<S, T>(&mut self, solid: &T, rays: Option<&OrthographicRays<S>>)
    where
        S: Scalar,
        T: Scan<OrthographicRays<S>, Scalar = S, View = V, Row = D>,
    {
        self.is_there = false;
        if let Some(rays) = rays {
            self.is_there = true;
            // What a group keeps of a band of rows is true of one view.
            self.row = D::EMPTY;
            solid.view(rays, &mut self.view);
            solid.row(&self.view, 0, rays.columns, &mut self.row);
        }
    }

    pub(super) fn enter<S, T>(&mut self, column: u32) -> ColumnRun
    where
        S: Scalar,
        T: Scan<OrthographicRays<S>, Scalar = S, View = V, Row = D>,
    {
        if self.is_there { T::enter(&mut self.row, column) } else { ColumnRun::EMPTY }
    }

    /// Whether the ray is inside just behind `t`, of the scene's parameters; and its crossings from there on.
    #[inline]
    pub(super) fn from<'a, P: Path, S, T>(
        &'a mut self,
        solid: &'a T,
        ray: OwnRay<S>,
        t: S,
        first: Face,
    ) -> Crossings<S, impl FnMut(S) -> (Step<S>, S) + 'a>
    where
        S: Scalar,
        T: Scan<OrthographicRays<S>, Scalar = S, View = V, Row = D>,
    {
        // Which own parameter is the scene's `t` is never asked: rounding would decide. Each crossing's
        // parameter is computed in one way, and the walk starts at the first one.
        let mut own = move |t| {
            let own = solid.step::<P>(&self.view, &mut self.row, ray.x, t, first);
            (own, ray.parameters.of(own.next.t))
        };
        let (mut step, mut at) = own(S::LOWEST);
        while at <= t && at < S::HIGHEST {
            (step, at) = own(step.next.t);
        }
        Crossings { step, at, own }
    }
}

/// A ray in a solid's own frame: its place in the row, and what its parameters are in the scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct OwnRay<S: Scalar> {
    pub(super) x: i32,
    pub(super) parameters: Parameters<S>,
}

/// The crossings behind a parameter.
pub(super) struct Crossings<S, F> {
    /// What is there in the own frame, and the scene's parameter of the next crossing.
    step: Step<S>,
    at: S,
    /// What lies behind an own parameter, and the scene's parameter of the next crossing.
    own: F,
}

impl<S: Scalar, F: FnMut(S) -> (Step<S>, S)> Crossings<S, F> {
    #[inline]
    pub(super) fn is_inside(&self) -> bool {
        self.step.inside
    }

    /// The whole step. Crossings that round to one parameter are taken together.
    #[inline]
    pub(super) fn step(mut self) -> Step<S> {
        let inside = self.step.inside;
        loop {
            let next = Crossing { t: self.at, ..self.step.next };
            if next.t >= S::HIGHEST {
                return Step { inside, next: Crossing::NEVER };
            }
            while self.at == next.t {
                (self.step, self.at) = (self.own)(self.step.next.t);
            }
            if self.step.inside != inside {
                return Step { inside, next };
            }
        }
    }
}
