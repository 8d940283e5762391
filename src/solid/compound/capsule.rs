//! The capsule: a cylinder with a sphere at either end.

use crate::geom::Vec3;
use crate::primitive::{Cylinder, CylinderError, Sphere, SphereError};
use crate::quadric::WALL;
use crate::scalar::{Scalar, per_scalar};
use crate::solid::{Union, Wrap};
use crate::span::Face;

/// What a capsule is made of.
type Parts<S> = Union<Cylinder<S>, [Sphere<S>; 2]>;

/// A rod with round ends: all points within a radius of the way from one point to another.
///
/// ```
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::solid::Capsule;
///
/// const HANDLE: Capsule<f32> =
///     constant!(Capsule::<f32>::new(vec3(0.0, 0.0, 0.0), vec3(3.0, 1.0, 0.0), 0.25));
/// # let _ = HANDLE;
/// ```
///
/// A radius of zero does not compile:
///
/// ```compile_fail,E0080
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::solid::Capsule;
///
/// const HANDLE: Capsule<f32> =
///     constant!(Capsule::<f32>::new(vec3(0.0, 0.0, 0.0), vec3(3.0, 1.0, 0.0), 0.0));
/// # let _ = HANDLE;
/// ```
///
/// Face 2 is the wall, 3 the sphere at the first point, 4 the one at the last. Faces 0 and 1, the wall's caps,
/// lie inside. Within the rounding of a parameter, a ray that meets a seam may meet one of them; there they have
/// the wall's normal.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Capsule<S: Scalar> {
    parts: Parts<S>,
}

/// A sphere's errors are among those of a cylinder.
impl From<SphereError> for CylinderError {
    fn from(error: SphereError) -> Self {
        as_cylinders(error)
    }
}

const fn as_cylinders(error: SphereError) -> CylinderError {
    match error {
        SphereError::NotFinite => CylinderError::NotFinite,
        SphereError::Radius => CylinderError::Radius,
        SphereError::TooFar => CylinderError::TooFar,
    }
}

per_scalar! { $S: impl[] Capsule<$S> {
    /// A rod with round ends from one point to another.
    ///
    /// # Errors
    /// As [`Cylinder::between`].
    pub const fn new(from: Vec3<$S>, to: Vec3<$S>, radius: $S) -> Result<Self, CylinderError> {
        let rod = match Cylinder::<$S>::between(from, to, radius) {
            Ok(rod) => rod,
            Err(error) => return Err(error),
        };
        match (Sphere::<$S>::new(from, radius), Sphere::<$S>::new(to, radius)) {
            (Ok(first), Ok(last)) => Ok(Self { parts: Parts::new(rod, [first, last]) }),
            (Err(error), _) | (_, Err(error)) => Err(as_cylinders(error)),
        }
    }
} }

impl<S: Scalar> Cylinder<S> {
    /// All points within `radius` of the way from one point to another: a rod with round ends. In constants, use
    /// [`Capsule::new`].
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::solid::{Capsule, Cylinder};
    ///
    /// let handle: Capsule<f32> =
    ///     Cylinder::capsule(vec3(0.0, 0.0, 0.0), vec3(3.0, 1.0, 0.0), 0.25)?;
    /// # let _ = handle;
    /// # Ok::<(), scancsg::solid::CylinderError>(())
    /// ```
    ///
    /// # Errors
    /// As [`from_to`](Self::from_to).
    pub fn capsule(from: Vec3<S>, to: Vec3<S>, radius: S) -> Result<Capsule<S>, CylinderError> {
        let rod = Self::from_to(from, to, radius)?;
        let ends = [Sphere::around(from, radius)?, Sphere::around(to, radius)?];
        Ok(Capsule { parts: Union::new(rod, ends) })
    }
}

impl<S: Scalar> Wrap for Capsule<S> {
    type Inner = Parts<S>;

    #[inline]
    fn inner(&self) -> &Parts<S> {
        &self.parts
    }

    #[inline]
    fn is_covered(&self, face: Face) -> bool {
        face.0 < WALL.0
    }

    fn face_over(&self, _: Face, _: Vec3<S>) -> Face {
        WALL
    }
}
