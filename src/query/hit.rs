//! What a ray sees: the first crossing, the point there, and the normal.

use crate::geom::{Line, Ray, RayError, Vec3};
use crate::scalar::Scalar;
use crate::span::{Face, Span};

/// What a ray sees of a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Hit<S> {
    /// The ray's parameter, ≥ 0; infinite where it is beyond the number type's range.
    pub t: S,
    /// The face that is seen.
    pub face: Face,
    /// Where, moved onto the face: its distance from there is that of its coordinates' rounding.
    pub point: Vec3<S>,
    /// The normal of length 1 on the side that is seen.
    pub normal: Vec3<S>,
    /// Whether the ray starts inside the solid, and sees the face from within.
    pub inside: bool,
}

impl<S: Scalar> Hit<S> {
    /// A ray from the point along `direction` that doesn't meet the same face again at once: for shadows,
    /// reflections, and rays that go on through the face.
    ///
    /// Its start is moved off the face, to the side that `direction` points to: by 8 ε of `size` in floating
    /// point, by 4 units and 2 more for each 1 of `size` in fixed point. That is an upper bound of the point's
    /// rounding error where no coordinate of the solid and no radius of its faces is larger than `size`, and
    /// for solids that are [`Placed`](crate::solid::Placed).
    ///
    /// It isn't for a solid that [`Scaled`](crate::solid::Scaled) enlarges in fixed point, because a unit is as
    /// much larger there, nor for a torus whose hole is smaller than 10⁻³ of its ring: see
    /// [`leave_by`](Self::leave_by).
    ///
    /// ```
    /// use scancsg::geom::{Ray, vec3};
    /// use scancsg::solid::{RayCast, Sphere};
    /// use scancsg::span::SpanList;
    ///
    /// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 0.015)?;
    /// let mut list = SpanList::<_, 1>::new();
    /// let ray = Ray::new(vec3(0.3, 0.2, 5.0), vec3(-0.3, -0.199, -5.0))?;
    /// let hit = ball.hit(&ray, &mut list).ok_or("a miss")?;
    /// let shadow = hit.leave(vec3(0.0, 1.0, 1.0), 0.015)?;
    /// assert!(ball.hit(&shadow, &mut list).is_none());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Ray::new`].
    pub fn leave(&self, direction: Vec3<S>, size: S) -> Result<Ray<S>, RayError> {
        let size = size.max(self.point.max_abs());
        let by = S::from_wide(S::uncertainty(size.wide())).plus(S::ROUNDING.times(size));
        self.leave_by(direction, by)
    }

    /// As [`leave`](Self::leave), with the start moved by a length of your choice.
    ///
    /// # Errors
    /// As [`Ray::new`].
    pub fn leave_by(&self, direction: Vec3<S>, by: S) -> Result<Ray<S>, RayError> {
        let by = if self.normal.dot(direction) < S::ZERO { by.negated() } else { by };
        Ray::new(self.point + self.normal * by, direction)
    }
}

/// The first surface that is seen from parameter `start` on.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Seen<S> {
    /// The line's parameter.
    pub t: S,
    /// The face.
    pub face: Face,
    /// Whether it is seen from inside the solid.
    pub inside: bool,
}

/// Looks for the first crossing at or after `start` in a sorted list of spans.
///
/// Ends that lie at infinity are no surface and are passed over.
#[must_use]
pub fn first_seen<S: Scalar>(spans: &[Span<S>], start: S) -> Option<Seen<S>> {
    for span in spans {
        for (crossing, inside) in [(span.enter, false), (span.exit, true)] {
            if crossing.t >= start && crossing.t > S::LOWEST && crossing.t < S::HIGHEST {
                return Some(Seen { t: crossing.t, face: crossing.face, inside });
            }
        }
    }
    None
}

/// The point of a surface where a line meets it at `t`, and the normal on the side that is seen; `at`
/// gives the point of the surface nearest to another one, and the normal that points outwards.
///
/// The line's point at the rounded `t` is up to half a unit times the direction's length beside the
/// surface. Where that is as far as to the axis, or beyond it, the point nearest to it is on the far side,
/// or any. One unit farther outside, it is on the side that is seen.
pub(crate) fn seen_at<S: Scalar>(
    line: &Line<S>,
    t: S,
    inside: bool,
    at: impl Fn(Vec3<S>) -> [Vec3<S>; 2],
) -> [Vec3<S>; 2] {
    let seen = |t| {
        let [point, outward] = at(line.at(t));
        [point, if inside { -outward } else { outward }]
    };
    // By more than an eighth: the sign alone would also tell of a tangent whose normal was rounded.
    let is_away = |normal: Vec3<S>| {
        let along = (0..3).fold(normal.dot(line.direction), |along, _| along.plus(along));
        along > line.direction.max_abs()
    };
    let is_fine = |normal: Vec3<S>| {
        let length = S::length(normal.to_array());
        length.minus(S::ONE).abs() < S::from_ratio(1, 16) && !is_away(normal)
    };
    let first @ [_, normal] = seen(t);
    if is_fine(normal) {
        return first;
    }
    // Or about zero: near an oblique axis, what is left of the way from there is rounding errors.
    let is_some = |normal: Vec3<S>| {
        let length = S::length(normal.to_array());
        length.plus(length) > S::ONE
    };
    let [point, normal] = if is_some(normal) && !is_away(normal) {
        first
    } else {
        seen(if inside { t.negated().next_below().negated() } else { t.next_below() })
    };
    // Of a few units, a solid has no normals of its own: the nearest one that doesn't point away.
    let of_length_1 = |v: Vec3<S>| Vec3::from(S::with_length(v.to_array(), S::ONE));
    let towards_start = of_length_1(-line.direction);
    let unit = of_length_1(normal);
    let across = unit - towards_start * unit.dot(towards_start);
    match () {
        () if is_fine(normal) => [point, normal],
        () if !is_away(unit) && unit != Vec3::ZERO => [point, unit],
        () if is_some(across) => [point, of_length_1(across)],
        () => [point, towards_start],
    }
}
