//! The solid cylinder with caps.

mod along_axis;
mod open;
mod orthographic;
mod perspective;

pub use along_axis::AxisCylinder;
pub use open::{CylinderWall, WallHit};

use crate::geom::{Axis, AxisLine, Direction, Line, Vec3};
use crate::quadric::{Planes, WALL, Wall, meet};
use crate::query::Solid;
use crate::scalar::{ConstOps, Number, Real, Scalar, Stretch, per_scalar};
use crate::scan::bounds::Bounds;
use crate::scan::leaf;
use crate::span::{Crossing, Face, Shape, Span, SpanStack};
use core::ops::Range;

/// A solid cylinder with flat caps: the infinite cylinder, cut by a slab.
///
/// Face 0 is the cap at the lower end of the axis, face 1 the one at the upper end, face 2 the
/// wall. For cylinders along coordinate axes, the caps lie exactly at the given coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cylinder<S: Scalar> {
    pub(crate) wall: Wall<S>,
    /// Their normal is the axis.
    pub(crate) caps: Planes<S>,
}

crate::error_text! {
    /// Why a cylinder can't be made.
    pub enum CylinderError {
        /// A coordinate or the radius is infinite or NaN.
        NotFinite => "a coordinate or the radius of the cylinder is infinite or not a number",
        /// The radius is zero, negative, or not between [`Scalar::MIN_RADIUS`] and [`Scalar::MAX_COORDINATE`].
        Radius => "the radius of the cylinder is not positive, or out of its number type's range",
        /// A coordinate is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the cylinder is too far away for its number type",
        /// The lower end is not below the upper end, or the end points coincide.
        Empty => "the cylinder has no length: its ends coincide or are the wrong way round",
    }
}

leaf!([S: Scalar] Cylinder<S>);

per_scalar! { $S: impl[] Cylinder<$S> {
    /// A cylinder along the x axis, around the line at (`y`, `z`), from `x_min` to
    /// `x_max`.
    ///
    /// # Errors
    /// [`CylinderError::NotFinite`], [`CylinderError::Radius`], [`CylinderError::TooFar`], or
    /// [`CylinderError::Empty`] where `x_min ≥ x_max`.
    pub const fn along_x(
        y: $S, z: $S, radius: $S, x_min: $S, x_max: $S,
    ) -> Result<Self, CylinderError> {
        let caps = Planes { normal: Direction::<$S>::X, low: x_min, high: x_max };
        Self::around(Vec3::new(ConstOps::<$S>::ZERO, y, z), radius, caps)
    }

    /// A cylinder along the y axis, around the line at (`x`, `z`), from `y_min` to
    /// `y_max`.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn along_y(
        x: $S, z: $S, radius: $S, y_min: $S, y_max: $S,
    ) -> Result<Self, CylinderError> {
        let caps = Planes { normal: Direction::<$S>::Y, low: y_min, high: y_max };
        Self::around(Vec3::new(x, ConstOps::<$S>::ZERO, z), radius, caps)
    }

    /// A cylinder along the z axis, around the line at (`x`, `y`), from `z_min` to
    /// `z_max`.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn along_z(
        x: $S, y: $S, radius: $S, z_min: $S, z_max: $S,
    ) -> Result<Self, CylinderError> {
        let caps = Planes { normal: Direction::<$S>::Z, low: z_min, high: z_max };
        Self::around(Vec3::new(x, y, ConstOps::<$S>::ZERO), radius, caps)
    }

    /// A cylinder along a coordinate axis, in a range of it, with the other two coordinates `at`, in the
    /// order x, y, z: as [`along_x`](Self::along_x) and its like, to be read without counting numbers.
    ///
    /// ```
    /// use scancsg::geom::Axis;
    /// use scancsg::solid::Cylinder;
    ///
    /// let shaft = Cylinder::<f32>::spanning(Axis::X, -2.0..2.0, [0.0, 1.0], 0.5);
    /// assert_eq!(shaft, Cylinder::<f32>::along_x(0.0, 1.0, 0.5, -2.0, 2.0));
    /// ```
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn spanning(
        axis: Axis, range: Range<$S>, at: [$S; 2], radius: $S,
    ) -> Result<Self, CylinderError> {
        let normal = Direction::<$S>::along_axis(axis);
        let [x, y, z] = axis.placed(ConstOps::<$S>::ZERO, at);
        let caps = Planes { normal, low: range.start, high: range.end };
        Self::around(Vec3::new(x, y, z), radius, caps)
    }

    /// A cylinder from the middle of one cap to the middle of the other.
    ///
    /// The axis is rounded once, to the number type or in fixed point to 2⁻²⁸, so a cap may
    /// lie off its end point by the rounding error of that point's coordinates. It is
    /// computed in `f64` or in integers of 128 bits: better in a constant.
    ///
    /// # Errors
    /// [`CylinderError::NotFinite`], [`CylinderError::Radius`], [`CylinderError::TooFar`], or
    /// [`CylinderError::Empty`] where the points coincide.
    pub const fn between(from: Vec3<$S>, to: Vec3<$S>, radius: $S) -> Result<Self, CylinderError> {
        if !(from.has_finite_coordinates() && to.has_finite_coordinates()) {
            return Err(CylinderError::NotFinite);
        }
        if !(from.is_within_reach() && to.is_within_reach()) {
            return Err(CylinderError::TooFar);
        }
        match ConstOps::<$S>::stretch(from.to_array(), to.to_array()) {
            Some(Stretch { direction, low, high }) => {
                let normal = Direction::<$S>::new(direction);
                Self::around(from, radius, Planes { normal, low, high })
            }
            None => Err(CylinderError::Empty),
        }
    }

    /// A cylinder on an axis that it may share with other solids, from one position along it to another:
    /// see [`AxisLine`].
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn on(
        axis: &AxisLine<$S>, radius: $S, from: $S, to: $S,
    ) -> Result<Self, CylinderError> {
        let [low, high] = [axis.plane_at(from), axis.plane_at(to)];
        Self::around(axis.first(), radius, Planes { normal: axis.direction(), low, high })
    }

    const fn around(base: Vec3<$S>, radius: $S, caps: Planes<$S>) -> Result<Self, CylinderError> {
        type Ops<S> = ConstOps<S>;
        let Planes { low, high, .. } = caps;
        let is_finite = base.has_finite_coordinates() && Ops::<$S>::is_finite(radius);
        let has_ends = Ops::<$S>::is_finite(low) && Ops::<$S>::is_finite(high);
        let has_near_ends = Ops::<$S>::is_within_reach(low) && Ops::<$S>::is_within_reach(high);
        match () {
            () if !is_finite => Err(CylinderError::NotFinite),
            () if !Ops::<$S>::is_radius(radius) => Err(CylinderError::Radius),
            () if !base.is_within_reach() => Err(CylinderError::TooFar),
            () if !has_ends => Err(CylinderError::NotFinite),
            () if !Ops::<$S>::is_below(low, high) => Err(CylinderError::Empty),
            () if !has_near_ends => Err(CylinderError::TooFar),
            () => {
                let curvature = Ops::<$S>::inverse(radius);
                Ok(Self { wall: Wall { base, radius, curvature }, caps })
            }
        }
    }
} }

/// For any number type: what a type parameter can call. In constants, use the constructors above.
impl<S: Scalar> Cylinder<S> {
    /// A cylinder along a coordinate axis from `low` to `high`, with the other two coordinates `at`, in
    /// the order x, y, z.
    ///
    /// ```
    /// use scancsg::geom::Axis;
    /// use scancsg::scalar::{I16F16, Scalar};
    /// use scancsg::solid::{Cylinder, CylinderError};
    ///
    /// fn shaft<S: Scalar>() -> Result<Cylinder<S>, CylinderError> {
    ///     let n = |tenths| S::from_ratio(tenths, 10);
    ///     Cylinder::along(Axis::X, [n(0), n(0)], n(5), n(-20), n(20))
    /// }
    /// assert!(shaft::<f32>().is_ok() && shaft::<I16F16>().is_ok());
    /// ```
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub fn along(
        axis: Axis,
        at: [S; 2],
        radius: S,
        low: S,
        high: S,
    ) -> Result<Self, CylinderError> {
        let caps = Planes { normal: Direction::along_axis(axis), low, high };
        Self::checked(Vec3::from(axis.placed(S::ZERO, at)), radius, caps)
    }

    /// A cylinder from the middle of one cap to the middle of the other.
    ///
    /// # Errors
    /// As [`between`](Self::between).
    pub fn from_to(from: Vec3<S>, to: Vec3<S>, radius: S) -> Result<Self, CylinderError> {
        if !(from.is_finite() && to.is_finite()) {
            return Err(CylinderError::NotFinite);
        }
        if !(from.is_within_range() && to.is_within_range()) {
            return Err(CylinderError::TooFar);
        }
        let (normal, [low, high]) = Direction::between(from, to).ok_or(CylinderError::Empty)?;
        Self::checked(from, radius, Planes { normal, low, high })
    }

    /// A cylinder on an axis that it may share with other solids, from one position along it to another.
    ///
    /// # Errors
    /// As [`on`](Self::on).
    pub fn on_axis(axis: &AxisLine<S>, radius: S, from: S, to: S) -> Result<Self, CylinderError> {
        let [low, high] = [from, to].map(|position| axis.offset(position));
        Self::checked(axis.first(), radius, Planes { normal: axis.direction(), low, high })
    }

    pub(crate) fn checked(
        base: Vec3<S>,
        radius: S,
        caps: Planes<S>,
    ) -> Result<Self, CylinderError> {
        let Planes { low, high, .. } = caps;
        match () {
            () if !(base.is_finite() && radius.is_finite()) => Err(CylinderError::NotFinite),
            () if !radius.is_radius() => Err(CylinderError::Radius),
            () if !base.is_within_range() => Err(CylinderError::TooFar),
            () if !(low.is_finite() && high.is_finite()) => Err(CylinderError::NotFinite),
            () if low >= high => Err(CylinderError::Empty),
            () if !(low.is_within_range() && high.is_within_range()) => Err(CylinderError::TooFar),
            () => Ok(Self { wall: Wall { base, radius, curvature: radius.inverse() }, caps }),
        }
    }
}

impl<S: Scalar> Shape for Cylinder<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = 3;
}

impl<S: Scalar> Solid for Cylinder<S> {
    #[inline(always)]
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        stack.put_all(meet::cylinder(&self.wall, &self.caps, line), first);
    }

    fn bounds(&self) -> Bounds<S> {
        let (center, radius) = self.bounding_ball();
        // Rounded to the number type, both may be off.
        let room = S::uncertainty(center.max_abs() + radius) + S::ROUNDING.wide();
        Bounds::Ball { center: center.map(S::from_wide), radius: S::from_wide(radius + room) }
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        // From afar, a point may be off along its ray by more than its distance from the rim.
        let Self { wall, caps } = self;
        if face == WALL {
            return caps.clamped(wall.onto(&caps.normal, near));
        }
        let on_plane = caps.onto_face(face, near);
        if wall.has(&caps.normal, on_plane) { on_plane } else { wall.onto(&caps.normal, on_plane) }
    }

    fn normal(&self, face: Face, at: Vec3<S>) -> Vec3<S> {
        if face == WALL {
            self.wall.normal(&self.caps.normal, at, |normal| normal)
        } else {
            self.caps.face_normal(face)
        }
    }

    // In its place, the point stays in registers: a tenth of a picture's time. On ARMv6-M,
    // which has few of them, that saves 3 of 100 instructions, and costs 800 bytes.
    // An attribute can't read `armv6m::IS_NARROW`: this is its condition.
    #[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline(always))]
    fn cosine(&self, face: Face, at: impl FnOnce() -> Vec3<S>, to: Vec3<S>) -> S {
        if face == WALL {
            self.wall.normal(&self.caps.normal, at(), |normal| normal.dot(to))
        } else {
            self.caps.face_cosine(face, to)
        }
    }
}

#[inline]
fn wall_span<S: Scalar>(enter: S, exit: S) -> Option<Span<S>> {
    let at = |t| Crossing { t, face: WALL };
    Span::new(at(enter), at(exit))
}

/// Sets a span to what the wall's and the caps' have in common. Where both begin or end together, the
/// face is the cap's.
#[inline(always)]
pub(super) fn set_common<S: Scalar>(
    span: &mut Span<S>,
    [enter, exit]: [S; 2],
    [near, far]: [S; 2],
    [near_face, far_face]: [Face; 2],
) {
    let later = |wall: S, cap| if wall > near { (wall, WALL) } else { (near, cap) };
    let earlier = |wall: S, cap| if wall < far { (wall, WALL) } else { (far, cap) };
    let (enter, exit) = (later(enter, near_face), earlier(exit, far_face));
    let is_met = enter.0 < exit.0;
    // Set before it is known: so the comparisons that find parameters find faces, too.
    span.enter = Crossing { t: enter.0, face: enter.1 };
    span.exit = Crossing { t: exit.0, face: exit.1 };
    if !is_met {
        *span = Span::NOWHERE;
    }
}

impl<S: Scalar> Cylinder<S> {
    /// A ball that holds the whole cylinder.
    fn bounding_ball(&self) -> (Vec3<S::Wide>, S::Wide) {
        let half = S::Wide::HALF;
        let (low, high) = (self.caps.low.wide(), self.caps.high.wide());
        let (base, radius) = (self.wall.base.wide(), self.wall.radius.wide());
        let axis = &self.caps.normal;
        let middle = (low + high) * half - axis.dot_wide(base);
        let half_length = (high - low) * half;
        let to_rim = Vec3::new(radius, half_length, S::Wide::ZERO);
        (base + axis.wide() * middle, to_rim.length())
    }
}

/// Two unit vectors that make a right-handed frame with `n`, a vector of length 1.
///
/// Duff et al., *Building an orthonormal basis, revisited*, Journal of Computer Graphics
/// Techniques 6 (2017), listing 3. Exact for coordinate axes.
pub(super) fn frame<T: Real>(n: Vec3<T>) -> [Vec3<T>; 2] {
    let sign = if n.z < T::ZERO { -T::ONE } else { T::ONE };
    let a = -(T::ONE / (sign + n.z));
    let b = n.x * n.y * a;
    [
        Vec3::new(T::ONE + sign * n.x * n.x * a, sign * b, -sign * n.x),
        Vec3::new(b, sign + n.y * n.y * a, -n.y),
    ]
}
