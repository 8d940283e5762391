//! Solids that are another solid inside, written once.

use super::nearby::{anchor, shifted};
use crate::geom::{Line, Pose, Rays, Vec3};
use crate::scalar::{Number, Scalar};
use crate::scan::bounds::Bounds;
use crate::scan::{ColumnRun, Scan};
use crate::solid::{Rgb, Solid};
use crate::span::walk::{Path, Step};
use crate::span::{Face, Shape, SpanStack};

/// A solid that is another one inside. Implement it to give solids names, data or colours of your
/// own: the wrapper can then be traced, combined and rendered like what it holds.
///
/// ```
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::solid::{Difference, RayCast, Sphere, Wrap};
/// use scancsg::span::SpanList;
///
/// /// A ball with a part number.
/// struct Bearing {
///     number: u32,
///     ball: Sphere<f32>,
/// }
///
/// impl Wrap for Bearing {
///     type Inner = Sphere<f32>;
///
///     fn inner(&self) -> &Sphere<f32> {
///         &self.ball
///     }
/// }
///
/// let bearing = Bearing { number: 608, ball: Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)? };
/// let ray = Ray::new(vec3(-3.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0))?;
/// assert_eq!(bearing.trace(&ray, &mut SpanList::<_, 1>::new())[0].enter.t, 2.0);
/// # let _ = bearing.number;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Wrap {
    /// What is inside.
    type Inner: Shape;

    /// The solid inside.
    fn inner(&self) -> &Self::Inner;

    /// Where the solid inside stands. `None` if it isn't moved.
    #[inline]
    fn pose(&self) -> Option<&Pose<<Self::Inner as Shape>::Scalar>> {
        None
    }

    /// Whether a face of the solid inside is covered by others. A ray may still meet it at its edge, within the
    /// rounding of a parameter; there it looks like the face [over it](Self::face_over).
    #[inline]
    fn is_covered(&self, face: Face) -> bool {
        let _ = face;
        false
    }

    /// The face over a covered one, near a point in the frame of the solid inside.
    fn face_over(&self, face: Face, at: Vec3<<Self::Inner as Shape>::Scalar>) -> Face {
        let _ = at;
        face
    }

    /// The colour of a face, by that of the solid inside.
    fn color(&self, inner: Option<Rgb>) -> Option<Rgb> {
        inner
    }
}

impl<T: Shape> Wrap for &T {
    type Inner = T;

    #[inline]
    fn inner(&self) -> &T {
        self
    }
}

#[diagnostic::do_not_recommend]
impl<W: Wrap> Shape for W {
    type Scalar = <W::Inner as Shape>::Scalar;
    const SPANS: usize = W::Inner::SPANS;
    const STACK: usize = W::Inner::STACK;
    const FACES: u16 = W::Inner::FACES;
}

/// The normal of a face in the frame of the solid inside.
#[inline]
fn own_normal<S: Scalar, W: Wrap<Inner: Solid<Scalar = S>>>(
    of: &W,
    face: Face,
    at: Vec3<S>,
) -> Vec3<S> {
    let face = if of.is_covered(face) { of.face_over(face, at) } else { face };
    of.inner().normal(face, at)
}

/// As [`own_normal`], its scalar product with a vector.
#[inline]
fn own_cosine<S: Scalar, W: Wrap<Inner: Solid<Scalar = S>>>(
    of: &W,
    face: Face,
    at: impl FnOnce() -> Vec3<S>,
    to: Vec3<S>,
) -> S {
    if of.is_covered(face) {
        return own_normal(of, face, at()).dot(to);
    }
    of.inner().cosine(face, at, to)
}

#[diagnostic::do_not_recommend]
impl<W: Wrap<Inner: Solid>> Solid for W {
    #[inline]
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    ) {
        match self.pose() {
            Some(pose) => {
                let (line, from) = pose.line_back_near(line, || anchor(&self.inner().bounds()));
                let start = stack.len();
                self.inner().spans(&line, first, stack);
                if from != Self::Scalar::ZERO {
                    stack.recount(start, |t| shifted(t, from));
                }
            }
            None => self.inner().spans(line, first, stack),
        }
    }

    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        match self.pose() {
            Some(pose) => pose.direction(own_normal(self, face, pose.point_back(at))),
            None => own_normal(self, face, at),
        }
    }

    fn bounds(&self) -> Bounds<Self::Scalar> {
        let bounds = self.inner().bounds();
        self.pose().map_or(bounds, |pose| bounds.placed(pose))
    }

    fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        match self.pose() {
            Some(pose) => pose.point(self.inner().onto(face, pose.point_back(near))),
            None => self.inner().onto(face, near),
        }
    }

    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<Self::Scalar>,
        to: Vec3<Self::Scalar>,
    ) -> Self::Scalar {
        match self.pose() {
            Some(pose) => own_cosine(self, face, || pose.point_back(at()), pose.direction_back(to)),
            None => own_cosine(self, face, at, to),
        }
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        Wrap::color(self, self.inner().color(face))
    }
}

#[diagnostic::do_not_recommend]
impl<R, W> Scan<R> for W
where
    W: Wrap<Inner: Scan<R>>,
    R: Rays<Scalar = Self::Scalar>,
{
    type View = <W::Inner as Scan<R>>::View;
    type Row = <W::Inner as Scan<R>>::Row;

    fn view(&self, rays: &R, view: &mut Self::View) {
        match self.pose() {
            Some(pose) => self.inner().view(&rays.back_from(pose), view),
            None => self.inner().view(rays, view),
        }
    }

    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        self.inner().is_in_rows(view, rows)
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
        self.inner().row(view, y, columns, row);
    }

    fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
        <W::Inner as Scan<R>>::enter(row, column)
    }

    #[inline]
    fn contains<P: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
    ) -> bool {
        self.inner().contains::<P>(view, row, x, t)
    }

    #[inline]
    fn step<P: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: Self::Scalar,
        first: Face,
    ) -> Step<Self::Scalar> {
        self.inner().step::<P>(view, row, x, t, first)
    }
}
