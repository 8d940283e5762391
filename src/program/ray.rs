//! Single rays at programs, with a checked number of spans.

use super::build::Program;
use crate::geom::{Line, Ray, Vec3};
use crate::solid::{Hit, RayCast, Rgb, Solid};
use crate::span::{Face, Shape, Span, SpanList, SpanStack};
use core::cell::Cell;

crate::error_text! {
    /// Why a single ray has no answer.
    pub enum LineError {
        /// The line has more spans than a list of the program's `SPANS` has room for, on the way to its
        /// result or in it.
        Spans => "the line has more spans with the program than it has room for",
    }
}

/// A program that notices when a line has too many spans.
struct Checked<'a, P> {
    program: &'a P,
    is_full: Cell<bool>,
}

type Scalar<L> = <L as Shape>::Scalar;

impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize> Shape
    for Checked<'_, Program<L, PARTS, POSES, SPANS, POOL>>
{
    type Scalar = L::Scalar;
    const SPANS: usize = SPANS;
    const FACES: u16 = Program::<L, PARTS, POSES, SPANS, POOL>::FACES;
}

impl<L: Solid, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize> Solid
    for Checked<'_, Program<L, PARTS, POSES, SPANS, POOL>>
{
    fn spans(&self, line: &Line<L::Scalar>, first: Face, stack: &mut SpanStack<'_, L::Scalar>) {
        if self.program.push_spans(line, first, stack).is_err() {
            self.is_full.set(true);
        }
    }

    fn normal(&self, face: Face, at: Vec3<L::Scalar>) -> Vec3<L::Scalar> {
        self.program.normal(face, at)
    }

    fn onto(&self, face: Face, near: Vec3<L::Scalar>) -> Vec3<L::Scalar> {
        self.program.onto(face, near)
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.program.color(face)
    }
}

impl<L: Solid, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    Program<L, PARTS, POSES, SPANS, POOL>
{
    fn checked<T>(&self, ask: impl FnOnce(&Checked<'_, Self>) -> T) -> Result<T, LineError> {
        let checked = Checked { program: self, is_full: Cell::new(false) };
        let answer = ask(&checked);
        if checked.is_full.get() { Err(LineError::Spans) } else { Ok(answer) }
    }

    /// As [`RayCast::trace`], checked.
    ///
    /// # Errors
    /// [`LineError::Spans`].
    pub fn trace<'a, const N: usize>(
        &self,
        ray: &Ray<Scalar<L>>,
        list: &'a mut SpanList<Scalar<L>, N>,
    ) -> Result<&'a [Span<Scalar<L>>], LineError> {
        self.checked(|checked| RayCast::trace(checked, ray, list))
    }

    /// As [`RayCast::hit`], checked.
    ///
    /// # Errors
    /// [`LineError::Spans`].
    pub fn hit<const N: usize>(
        &self,
        ray: &Ray<Scalar<L>>,
        list: &mut SpanList<Scalar<L>, N>,
    ) -> Result<Option<Hit<Scalar<L>>>, LineError> {
        self.checked(|checked| RayCast::hit(checked, ray, list))
    }
}
