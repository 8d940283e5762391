//! Solids that are made of several primitives: capsules, rounded boxes, rings of holes.

use super::{Cuboid, CuboidError, Cylinder, CylinderError, Sphere, SphereError, Union};
use crate::geom::{Axis, Vec3};
use crate::scalar::{Number, Real, Scalar};

/// A cylinder with a sphere at either end: see [`Cylinder::capsule`].
///
/// Its parts overlap. At a seam, within the rounding of a parameter, a ray may meet a face that lies inside:
/// single pixels of pictures in fixed point show one.
pub type Capsule<S> = Union<Cylinder<S>, [Sphere<S>; 2]>;

/// A box with round edges and corners: see [`Cuboid::rounded`].
///
/// Its parts overlap, and what [`Capsule`] says of seams holds here, too.
pub type RoundedCuboid<S> = Union<[Cuboid<S>; 3], Union<[Cylinder<S>; 12], [Sphere<S>; 8]>>;

/// A sphere's errors are among those of a cylinder.
impl From<SphereError> for CylinderError {
    fn from(error: SphereError) -> Self {
        match error {
            SphereError::NotFinite => Self::NotFinite,
            SphereError::Radius => Self::Radius,
            SphereError::TooFar => Self::TooFar,
        }
    }
}

impl<S: Scalar> Cylinder<S> {
    /// All points within `radius` of the way from one point to another: a rod with round ends.
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
        Ok(Union::new(rod, [Sphere::around(from, radius)?, Sphere::around(to, radius)?]))
    }

    /// `N` cylinders along a coordinate axis, evenly spaced on a circle: a ring of bolt holes.
    ///
    /// `[u, v]` is the circle's middle in the other two coordinates, in the order x, y, z. Cylinder k is at the
    /// angle 2πk/N, counted from u to v. `ring_radius` is the circle's radius, `radius` that of each cylinder;
    /// they reach from `low` to `high` along the axis.
    ///
    /// ```
    /// use scancsg::geom::Axis;
    /// use scancsg::solid::Cylinder;
    ///
    /// let holes = Cylinder::<f32>::ring::<6>(Axis::Z, [0.0, 0.0], 1.5, 0.2, -1.0, 1.0)?;
    /// let flange = Cylinder::<f32>::along_z(0.0, 0.0, 2.0, -0.2, 0.2)? - holes;
    /// # let _ = flange;
    /// # Ok::<(), scancsg::solid::CylinderError>(())
    /// ```
    ///
    /// # Errors
    /// As [`along`](Self::along), and [`CylinderError::Radius`] for a `ring_radius` that isn't one.
    pub fn ring<const N: usize>(
        axis: Axis,
        [u, v]: [S; 2],
        ring_radius: S,
        radius: S,
        low: S,
        high: S,
    ) -> Result<[Self; N], CylinderError> {
        if !ring_radius.is_radius() {
            return Err(CylinderError::Radius);
        }
        let first = Self::along(axis, [u.plus(ring_radius), v], radius, low, high)?;
        let mut ring = [first; N];
        let turn = (S::Wide::PI + S::Wide::PI) / S::Wide::from_int(N as i32);
        for (hole, index) in ring.iter_mut().zip(0..).skip(1) {
            let (sin, cos) = (turn * S::Wide::from_int(index)).sin_cos();
            let [x, y] = [cos, sin].map(|part| S::from_wide(ring_radius.wide() * part));
            *hole = Self::along(axis, [u.plus(x), v.plus(y)], radius, low, high)?;
        }
        Ok(ring)
    }
}

impl<S: Scalar> Cuboid<S> {
    /// A box from its lowest corner to its highest, with edges and corners rounded by a radius.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::solid::{Cuboid, RoundedCuboid};
    ///
    /// let case: RoundedCuboid<f32> =
    ///     Cuboid::rounded(vec3(-2.0, -1.0, -0.5), vec3(2.0, 1.0, 0.5), 0.2)?;
    /// # let _ = case;
    /// # Ok::<(), scancsg::solid::CuboidError>(())
    /// ```
    ///
    /// # Errors
    /// As [`between`](Self::between), and [`CuboidError::Radius`] if twice the radius isn't below the
    /// smallest size.
    pub fn rounded(
        low: Vec3<S>,
        high: Vec3<S>,
        radius: S,
    ) -> Result<RoundedCuboid<S>, CuboidError> {
        Self::between(low, high)?;
        if !radius.is_radius() {
            return Err(CuboidError::Radius);
        }
        let round = Vec3::new(radius, radius, radius);
        let (inner_low, inner_high) = (low + round, high - round);
        let too_round = |_| CuboidError::Radius;
        Self::between(inner_low, inner_high).map_err(too_round)?;
        let plate = |axis: Axis| {
            let [low, high] = [(inner_low, low), (inner_high, high)].map(|(inner, outer)| {
                let along = |of: Axis| of.of(if of == axis { outer } else { inner });
                Vec3::new(along(Axis::X), along(Axis::Y), along(Axis::Z))
            });
            Self::between(low, high)
        };
        let plates = [plate(Axis::X)?, plate(Axis::Y)?, plate(Axis::Z)?];
        // The corner on the high side where a bit is 1.
        let corner = |bits: usize| {
            let pick = |bit: usize, axis: Axis| {
                axis.of(if bits & bit == 0 { inner_low } else { inner_high })
            };
            Vec3::new(pick(1, Axis::X), pick(2, Axis::Y), pick(4, Axis::Z))
        };
        let edge = |axis: Axis, bits: usize| {
            let at = match axis {
                Axis::X => [corner(bits << 1).y, corner(bits << 1).z],
                Axis::Y => [corner(bits & 1).x, corner((bits & 2) << 1).z],
                Axis::Z => [corner(bits).x, corner(bits).y],
            };
            Cylinder::along(axis, at, radius, axis.of(inner_low), axis.of(inner_high))
                .map_err(|_| CuboidError::Radius)
        };
        let mut edges = [edge(Axis::X, 0)?; 12];
        for (of_axis, axis) in edges.chunks_exact_mut(4).zip(Axis::ALL) {
            for (place, bits) in of_axis.iter_mut().zip(0..) {
                *place = edge(axis, bits)?;
            }
        }
        let ball = |bits| Sphere::around(corner(bits), radius).map_err(|_| CuboidError::Radius);
        let mut corners = [ball(0)?; 8];
        for (place, bits) in corners.iter_mut().zip(0..) {
            *place = ball(bits)?;
        }
        Ok(Union::new(plates, Union::new(edges, corners)))
    }
}
