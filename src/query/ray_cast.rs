//! What a single ray meets.

use super::hit::{Hit, Seen, first_seen, seen_at};
use super::rebased::{is_near_start, line_spans, seen_near, trace_rebased};
use crate::geom::Ray;
use crate::query::Solid;
use crate::span::{Span, SpanList};

/// Where a single ray meets a solid: distance sensors, picking, tests. Every [`Solid`] has it.
///
/// ```
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::solid::{RayCast, Sphere};
/// use scancsg::span::SpanList;
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let ray = Ray::new(vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, -1.0))?;
/// let hit = ball.hit(&ray, &mut SpanList::<_, 1>::new()).ok_or("a miss")?;
/// assert_eq!((hit.t, hit.normal), (4.0, vec3(0.0, 0.0, 1.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait RayCast: Solid {
    /// The spans of the whole line that `ray` lies on, in the ray's parameter: spans before the
    /// start of the ray have parameters below zero.
    ///
    /// A ray that starts very far away may enter and exit a thin solid at parameters that round
    /// to the same number. The span is reported all the same, if it has a length where the ray is
    /// counted from (see [`Ray`]). A parameter beyond the number type's range is infinite.
    // Always inline, so that a ray stays in registers.
    #[inline(always)]
    fn trace<'a, const N: usize>(
        &self,
        ray: &Ray<Self::Scalar>,
        list: &'a mut SpanList<Self::Scalar, N>,
    ) -> &'a [Span<Self::Scalar>] {
        if ray.is_moved() {
            // In pieces: a list copied as a whole waits for what was just written to it.
            let spans = trace_rebased::<_, N>(self, ray);
            let mut stack = list.stack();
            for &Span { enter, exit } in spans.as_slice() {
                stack.put(Span { enter, exit });
            }
            return list.as_slice();
        }
        line_spans(self, ray.line(), list);
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
        line_spans(self, ray.line(), list);
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
}

impl<T: Solid + ?Sized> RayCast for T {}
