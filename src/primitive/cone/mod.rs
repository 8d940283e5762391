//! The cone and its frustum, with caps.

mod orthographic;
mod perspective;

use super::cylinder::{Cylinder, CylinderError, frame, set_common};
use crate::geom::{Axis, AxisLine, Line, Vec3};
use crate::quadric::{Planes, Taper, WALL, Wall, meet};
use crate::query::Solid;
use crate::scalar::{ConstOps, Scalar, per_scalar};
use crate::scan::bounds::Bounds;
use crate::scan::leaf;
use crate::span::{Face, Shape, Span, SpanStack};
use core::ops::Range;

/// A solid cone, or a piece of one between two flat caps: for countersinks, tapers and tips.
///
/// It has a radius at either end, and one of them may be 0: then that end is a tip. Equal radii make a
/// cylinder, for which a [`Cylinder`] is quicker.
///
/// Face 0 is the cap at the lower end of the axis, face 1 the one at the upper end, face 2 the wall. Caps are
/// those of a cylinder with the same ends, bit by bit.
///
/// ```
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::solid::{Cone, RayCast};
/// use scancsg::span::SpanList;
///
/// // A radius of 2 at z = 0, and a tip at z = 4.
/// let cone = Cone::<f32>::along_z(0.0, 0.0, [2.0, 0.0], 0.0, 4.0)?;
/// let ray = Ray::new(vec3(-5.0, 0.0, 2.0), vec3(1.0, 0.0, 0.0))?;
/// let hit = cone.hit(&ray, &mut SpanList::<_, 1>::new()).ok_or("a miss")?;
/// assert_eq!((hit.t, hit.point), (4.0, vec3(-1.0, 0.0, 2.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// In a constant, a bad cone doesn't compile:
///
/// ```compile_fail,E0080
/// use scancsg::solid::Cone;
///
/// const NEEDLE: Cone<f32> = match Cone::<f32>::along_z(0.0, 0.0, [0.0, 0.0], 0.0, 4.0) {
///     Ok(cone) => cone,
///     Err(_) => panic!("no needle has two tips"),
/// };
/// # let _ = NEEDLE;
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cone<S: Scalar> {
    pub(crate) taper: Taper<S>,
    /// Their normal is the axis.
    pub(crate) caps: Planes<S>,
}

crate::error_text! {
    /// Why a cone can't be made.
    pub enum ConeError {
        /// A coordinate or a radius is infinite or NaN.
        NotFinite => "a coordinate or a radius of the cone is infinite or not a number",
        /// Both radii are zero, or one is negative, or neither zero nor between [`Scalar::MIN_RADIUS`] and
        /// [`Scalar::MAX_COORDINATE`].
        Radius => "a radius of the cone is negative or out of its number type's range, or both are zero",
        /// A coordinate is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the cone is too far away for its number type",
        /// The lower end is not below the upper end, or the end points coincide.
        Empty => "the cone has no length: its ends coincide or are the wrong way round",
    }
}

/// What is wrong with a cylinder around the cone.
const fn of_cylinder(error: CylinderError) -> ConeError {
    match error {
        CylinderError::NotFinite => ConeError::NotFinite,
        CylinderError::Radius => ConeError::Radius,
        CylinderError::TooFar => ConeError::TooFar,
        CylinderError::Empty => ConeError::Empty,
    }
}

leaf!([S: Scalar] Cone<S>);

per_scalar! { $S: impl[] Cone<$S> {
    /// A cone along the x axis, around the line at (`y`, `z`), from `x_min` to `x_max`, with a radius
    /// at either end, in this order.
    ///
    /// # Errors
    /// [`ConeError::NotFinite`], [`ConeError::Radius`], [`ConeError::TooFar`], or
    /// [`ConeError::Empty`] where `x_min ≥ x_max`.
    pub const fn along_x(
        y: $S, z: $S, radii: [$S; 2], x_min: $S, x_max: $S,
    ) -> Result<Self, ConeError> {
        Self::inside(Cylinder::<$S>::along_x(y, z, Self::larger(radii), x_min, x_max), radii)
    }

    /// A cone along the y axis, around the line at (`x`, `z`), from `y_min` to `y_max`.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn along_y(
        x: $S, z: $S, radii: [$S; 2], y_min: $S, y_max: $S,
    ) -> Result<Self, ConeError> {
        Self::inside(Cylinder::<$S>::along_y(x, z, Self::larger(radii), y_min, y_max), radii)
    }

    /// A cone along the z axis, around the line at (`x`, `y`), from `z_min` to `z_max`.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn along_z(
        x: $S, y: $S, radii: [$S; 2], z_min: $S, z_max: $S,
    ) -> Result<Self, ConeError> {
        Self::inside(Cylinder::<$S>::along_z(x, y, Self::larger(radii), z_min, z_max), radii)
    }

    /// A cone along a coordinate axis, in a range of it, as [`Cylinder::spanning`]: with a radius at either
    /// end.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn spanning(
        axis: Axis, range: Range<$S>, at: [$S; 2], radii: [$S; 2],
    ) -> Result<Self, ConeError> {
        Self::inside(Cylinder::<$S>::spanning(axis, range, at, Self::larger(radii)), radii)
    }

    /// A cone from the middle of one cap to the middle of the other, with a radius at either.
    ///
    /// The axis is rounded as that of [`Cylinder::between`].
    ///
    /// # Errors
    /// [`ConeError::NotFinite`], [`ConeError::Radius`], [`ConeError::TooFar`], or
    /// [`ConeError::Empty`] where the points coincide.
    pub const fn between(
        from: Vec3<$S>,
        to: Vec3<$S>,
        radii: [$S; 2],
    ) -> Result<Self, ConeError> {
        Self::inside(Cylinder::<$S>::between(from, to, Self::larger(radii)), radii)
    }

    /// A cone on an axis that it may share with other solids, from one position along it to another: see
    /// [`AxisLine`].
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn on(
        axis: &AxisLine<$S>,
        radii: [$S; 2],
        from: $S,
        to: $S,
    ) -> Result<Self, ConeError> {
        Self::inside(Cylinder::<$S>::on(axis, Self::larger(radii), from, to), radii)
    }

    const fn larger([low, high]: [$S; 2]) -> $S {
        if ConstOps::<$S>::is_below(low, high) { high } else { low }
    }

    const fn inside(
        around: Result<Cylinder<$S>, CylinderError>,
        [low, high]: [$S; 2],
    ) -> Result<Self, ConeError> {
        let Cylinder { wall, caps } = match around {
            Ok(around) => around,
            Err(error) => return Err(of_cylinder(error)),
        };
        if !(ConstOps::<$S>::is_finite(low) && ConstOps::<$S>::is_finite(high)) {
            return Err(ConeError::NotFinite);
        }
        if !(ConstOps::<$S>::is_zero(low) || ConstOps::<$S>::is_radius(low))
            || !(ConstOps::<$S>::is_zero(high) || ConstOps::<$S>::is_radius(high))
        {
            return Err(ConeError::Radius);
        }
        match Taper::<$S>::from_caps(wall.base, [low, high], &caps) {
            Some(taper) => Ok(Self { taper, caps }),
            None => Err(ConeError::Empty),
        }
    }
} }

/// For any number type: what a type parameter can call. In constants, use the constructors above.
impl<S: Scalar> Cone<S> {
    /// A cone along a coordinate axis from `low` to `high`, with a radius at either end and the other two
    /// coordinates `at`, in the order x, y, z.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub fn along(
        axis: Axis,
        at: [S; 2],
        radii: [S; 2],
        low: S,
        high: S,
    ) -> Result<Self, ConeError> {
        Self::checked(Cylinder::<S>::along(axis, at, radii[0].max(radii[1]), low, high), radii)
    }

    /// A cone from the middle of one cap to the middle of the other, with a radius at either.
    ///
    /// # Errors
    /// As [`between`](Self::between).
    pub fn from_to(from: Vec3<S>, to: Vec3<S>, radii: [S; 2]) -> Result<Self, ConeError> {
        Self::checked(Cylinder::<S>::from_to(from, to, radii[0].max(radii[1])), radii)
    }

    /// A cone on an axis that it may share with other solids, from one position along it to another.
    ///
    /// # Errors
    /// As [`on`](Self::on).
    pub fn on_axis(axis: &AxisLine<S>, radii: [S; 2], from: S, to: S) -> Result<Self, ConeError> {
        Self::checked(Cylinder::on_axis(axis, radii[0].max(radii[1]), from, to), radii)
    }

    pub(crate) fn checked(
        around: Result<Cylinder<S>, CylinderError>,
        radii @ [low, high]: [S; 2],
    ) -> Result<Self, ConeError> {
        let Cylinder { wall, caps } = around.map_err(of_cylinder)?;
        if !(low.is_finite() && high.is_finite()) {
            return Err(ConeError::NotFinite);
        }
        if radii.into_iter().any(|radius| radius != S::ZERO && !radius.is_radius()) {
            return Err(ConeError::Radius);
        }
        let taper = Taper::between(wall.base, radii, &caps).ok_or(ConeError::Empty)?;
        Ok(Self { taper, caps })
    }
}

/// Sets a span to what a ray's part inside the wall and its part between the caps have in common.
#[inline(always)]
fn cut<S: Scalar>(span: &mut Span<S>, chord: [S; 2], caps: Option<Span<S>>) {
    if let Some(Span { enter: near, exit: far }) = caps {
        set_common(span, chord, [near.t, far.t], [near.face, far.face]);
    }
}

impl<S: Scalar> Shape for Cone<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = 3;
}

impl<S: Scalar> Solid for Cone<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        if let Some(span) = meet::cone(&self.taper, &self.caps, line) {
            stack.put(span.with_faces_from(first));
        }
    }

    fn bounds(&self) -> Bounds<S> {
        let (center, radius) = self.taper.bounding_ball(&self.caps);
        Bounds::Ball { center: center.map(S::from_wide), radius: S::from_wide(radius) }
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        let Self { taper: Taper { base, radii: [low, high], .. }, caps } = *self;
        if face == WALL {
            return self.taper.onto(&caps, near);
        }
        let radius = if face.0 == 0 { low } else { high };
        let rim = Wall { base, radius, curvature: S::NO_SCALE };
        let on_plane = caps.onto_face(face, near);
        if rim.has(&caps.normal, on_plane) { on_plane } else { rim.onto(&caps.normal, on_plane) }
    }

    #[inline]
    fn normal(&self, face: Face, at: Vec3<S>) -> Vec3<S> {
        if face == WALL {
            self.taper.normal(&self.caps.normal, at)
        } else {
            self.caps.face_normal(face)
        }
    }
}
