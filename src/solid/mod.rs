//! Solids: primitives, boolean combinations of them, and what they answer to lines and pictures.
//!
//! A solid is a typed expression, and what it does not mention is not linked:
//!
//! ```
//! use scancsg::geom::{Ray, vec3};
//! use scancsg::solid::{Cylinder, Solid};
//! use scancsg::span::SpanList;
//!
//! let shaft = Cylinder::<f32>::along_x(0.0, 0.0, 1.0, -2.0, 2.0)?;
//! let bore = Cylinder::<f32>::along_x(0.0, 0.0, 0.5, -3.0, 3.0)?;
//! let pipe = shaft - bore;
//!
//! let ray = Ray::new(vec3(0.0, 5.0, 0.0), vec3(0.0, -1.0, 0.0))?;
//! let mut spans = SpanList::<_, 4>::new();
//! let walls = pipe.trace(&ray, &mut spans);
//! assert_eq!(walls.len(), 2);
//! assert_eq!((walls[0].enter.t, walls[0].exit.t), (4.0, 4.5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Three traits say what a solid can do: [`Shape`] counts (spans, faces), [`Solid`] answers single
//! lines, and [`Scan`] gets ready for a picture. A primitive of your own needs none of them: see
//! [`Convex`].

#[macro_use]
mod boolean;
mod convex;
mod cylinder;
mod group;
mod hit;
mod intersect;
mod leaf;
mod moved;
mod paint;
mod pipe;
mod placed;
mod row;
mod silhouette;
mod slab;
mod sphere;
mod strip;
mod wall;

pub use boolean::{Difference, Intersection, Union};
pub use convex::Convex;
pub use cylinder::{Cylinder, CylinderError};
pub use hit::{Hit, Seen, first_seen};
pub use intersect::Intersect;
pub use paint::{Painted, Rgb};
pub use pipe::{Pipe, PipeError};
pub use placed::Placed;
pub use row::{Empty, Look, Outlook, Scan};
pub use slab::{Slab, SlabError};
pub use sphere::{Sphere, SphereError};
pub use wall::{CylinderWall, WallHit};

use self::hit::seen_at;
use self::moved::{is_near_start, seen_near, trace_moved};
use crate::geom::{Line, Ray, Vec3};
use crate::scalar::Scalar;
use crate::span::{Face, Span, SpanList, SpanStack};

/// The counts of a solid that its type alone decides.
pub trait Shape {
    /// The number type of the solid.
    type Scalar: Scalar;

    /// The most spans that any line can have with the solid.
    const SPANS: usize;

    /// The most spans that are in memory at any time while the spans of a line are merged: the
    /// capacity that a [`SpanList`] for this solid must have.
    const STACK: usize;

    /// The number of faces.
    const FACES: u16;
}

/// A solid that answers lines.
pub trait Solid: Shape {
    /// Pushes the spans of the line with the solid, in ascending order and regularised, with
    /// faces counted from `first` on.
    fn spans(
        &self,
        line: &Line<Self::Scalar>,
        first: Face,
        stack: &mut SpanStack<'_, Self::Scalar>,
    );

    /// The point of a face nearest to a point that lies beside it by a rounding error.
    ///
    /// [`hit`](Self::hit) reports such points, so that a ray that starts there starts on the surface.
    fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
        let _ = face;
        near
    }

    /// The normal of length 1 that points out of the solid, at a point on one of its faces.
    ///
    /// On curved faces its relative error is that of the point over the radius: a point with a
    /// coordinate of 1,000 in `f32` is known to 3·10⁻⁵.
    fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar>;

    /// The scalar product of that normal and another vector: of length 1, the cosine of the angle
    /// between them. The point on the face is asked for only where the normal depends on it.
    ///
    /// One number, where the normal is three that may go through memory. In fixed point it may be off
    /// by a unit from the product of a normal that was turned round, where that lies half-way
    /// between two numbers.
    #[inline]
    fn cosine(
        &self,
        face: Face,
        at: impl FnOnce() -> Vec3<Self::Scalar>,
        to: Vec3<Self::Scalar>,
    ) -> Self::Scalar {
        self.normal(face, at()).dot(to)
    }

    /// The colour of a face, or `None` where nothing painted it.
    fn color(&self, face: Face) -> Option<Rgb> {
        let _ = face;
        None
    }

    /// The spans of the whole line that `ray` lies on, in the ray's parameter: spans before the
    /// start of the ray have parameters below zero.
    ///
    /// A ray that starts very far away may enter and exit a thin solid at parameters that round
    /// to the same number; the span is reported all the same, if it has a length where the ray is counted
    /// from (see [`Ray`]). A parameter beyond the number type's range is infinite.
    // Always inline, so that a ray stays in registers.
    #[inline(always)]
    fn trace<'a, const N: usize>(
        &self,
        ray: &Ray<Self::Scalar>,
        list: &'a mut SpanList<Self::Scalar, N>,
    ) -> &'a [Span<Self::Scalar>] {
        if ray.is_moved() {
            // In pieces: a list copied as a whole waits for what was just written to it.
            let spans = trace_moved::<_, N>(self, ray);
            let mut stack = list.stack();
            for &Span { enter, exit } in spans.as_slice() {
                stack.put(Span { enter, exit });
            }
            return list.as_slice();
        }
        self.line_spans(ray.line(), list);
        for span in list.as_mut_slice() {
            span.enter.t = ray.scaled(span.enter.t);
            span.exit.t = ray.scaled(span.exit.t);
        }
        list.as_slice()
    }

    /// What the ray sees: the first crossing at t ≥ 0. From inside the solid that is an exit, and
    /// the normal points back into the solid, towards the ray's start.
    fn hit<const N: usize>(
        &self,
        ray: &Ray<Self::Scalar>,
        list: &mut SpanList<Self::Scalar, N>,
    ) -> Option<Hit<Self::Scalar>> {
        self.line_spans(ray.line(), list);
        let (ray, seen) = if is_near_start(ray, list) {
            seen_near(self, ray, list)?
        } else {
            (*ray, first_seen(list, ray.start())?)
        };
        let Seen { t, face, inside } = seen;
        let [point, normal] = seen_at(ray.line(), t, inside, |near| {
            let point = self.onto(face, near);
            [point, self.normal(face, point)]
        });
        Some(Hit { t: ray.parameter(t), face, point, normal, inside })
    }

    /// Fills the list with the spans of a line, in the line's own parameter.
    #[inline(always)]
    fn line_spans<const N: usize>(
        &self,
        line: &Line<Self::Scalar>,
        list: &mut SpanList<Self::Scalar, N>,
    ) {
        const {
            assert!(N >= Self::STACK, "the span list is too small: see Shape::STACK of the solid");
        }
        self.spans(line, Face(0), &mut list.stack());
    }
}
