//! The box with round edges and corners.

use crate::geom::{Axis, Vec3};
use crate::primitive::{Cuboid, CuboidError, Cylinder, Sphere};
use crate::quadric::WALL;
use crate::scalar::{ConstOps, Scalar, per_scalar};
use crate::solid::{Union, Wrap};
use crate::span::{Face, Shape};

/// What a rounded box is made of: plates across the axes, edges, corners.
type Parts<S> = Union<[Cuboid<S>; 3], Union<[Cylinder<S>; 12], [Sphere<S>; 8]>>;

/// The first face behind those of the plates.
const FIRST_EDGE: u16 = <[Cuboid<f32>; 3] as Shape>::FACES;

/// A box along the coordinate axes with edges and corners rounded by a radius.
///
/// ```
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::solid::RoundedCuboid;
///
/// const CASE: RoundedCuboid<f32> =
///     constant!(RoundedCuboid::<f32>::new(vec3(-2.0, -1.0, -0.5), vec3(2.0, 1.0, 0.5), 0.2));
/// # let _ = CASE;
/// ```
///
/// A radius of half the smallest size does not compile:
///
/// ```compile_fail,E0080
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::solid::RoundedCuboid;
///
/// const CASE: RoundedCuboid<f32> =
///     constant!(RoundedCuboid::<f32>::new(vec3(-2.0, -1.0, -0.5), vec3(2.0, 1.0, 0.5), 0.5));
/// # let _ = CASE;
/// ```
///
/// Of three plates, each with the faces of a [`Cuboid`], the outer ones of plate k are 8·k and 8·k + 1. The walls
/// of the edges are 20, 23 … 53, and the corners 54 to 61. All others lie inside. Within the rounding of a
/// parameter, a ray that meets a seam may meet one of them; there they have the normal of the face beside them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RoundedCuboid<S: Scalar> {
    parts: Parts<S>,
}

/// The lowest and the highest corner of a rounded box, and those of the box of its corners' middles.
struct Frame<S> {
    outer: [Vec3<S>; 2],
    inner: [Vec3<S>; 2],
}

impl<S: Copy> Frame<S> {
    /// The corners of the plate whose outer faces lie across an axis.
    const fn plate(&self, axis: Axis) -> [Vec3<S>; 2] {
        let ([low, high], [inner_low, inner_high]) = (self.outer, self.inner);
        match axis {
            Axis::X => [Vec3 { x: low.x, ..inner_low }, Vec3 { x: high.x, ..inner_high }],
            Axis::Y => [Vec3 { y: low.y, ..inner_low }, Vec3 { y: high.y, ..inner_high }],
            Axis::Z => [Vec3 { z: low.z, ..inner_low }, Vec3 { z: high.z, ..inner_high }],
        }
    }

    /// The middle of a corner: on the high side of x, y, z where a bit is 1.
    const fn corner(&self, bits: usize) -> Vec3<S> {
        let [x, y, z] = [bits & 1, (bits >> 1) & 1, (bits >> 2) & 1];
        Vec3::new(self.inner[x].x, self.inner[y].y, self.inner[z].z)
    }

    /// The middle of an edge along an axis, in the other two coordinates: on the high side where a bit is 1.
    const fn edge(&self, axis: Axis, bits: usize) -> [S; 2] {
        let [u, v] = [self.inner[bits & 1], self.inner[(bits >> 1) & 1]];
        match axis {
            Axis::X => [u.y, v.z],
            Axis::Y => [u.x, v.z],
            Axis::Z => [u.x, v.y],
        }
    }
}

per_scalar! { $S: impl[] RoundedCuboid<$S> {
    /// A rounded box from its lowest corner to its highest.
    ///
    /// # Errors
    /// As [`Cuboid::new`], and [`CuboidError::Radius`] if twice the radius isn't below the smallest size.
    pub const fn new(low: Vec3<$S>, high: Vec3<$S>, radius: $S) -> Result<Self, CuboidError> {
        type Ops<S> = ConstOps<S>;
        if let Err(error) = Cuboid::<$S>::new(low, high) {
            return Err(error);
        }
        if !Ops::<$S>::is_radius(radius) {
            return Err(CuboidError::Radius);
        }
        let inner_low = Vec3::new(
            Ops::<$S>::sum(low.x, radius),
            Ops::<$S>::sum(low.y, radius),
            Ops::<$S>::sum(low.z, radius),
        );
        let inner_high = Vec3::new(
            Ops::<$S>::difference(high.x, radius),
            Ops::<$S>::difference(high.y, radius),
            Ops::<$S>::difference(high.z, radius),
        );
        let frame = Frame { outer: [low, high], inner: [inner_low, inner_high] };
        let edge = Cylinder::<$S>::along_x(low.y, low.z, radius, inner_low.x, inner_high.x);
        let (Ok(core), Ok(edge), Ok(corner)) = (
            Cuboid::<$S>::new(inner_low, inner_high),
            edge,
            Sphere::<$S>::new(inner_low, radius),
        ) else {
            return Err(CuboidError::Radius);
        };
        let (mut plates, mut edges, mut corners) = ([core; 3], [edge; 12], [corner; 8]);
        let mut index = 0;
        while index < 12 {
            let axis = Axis::ALL[index / 4];
            let [low, high] = frame.plate(axis);
            plates[index / 4] = match Cuboid::<$S>::new(low, high) {
                Ok(plate) => plate,
                Err(error) => return Err(error),
            };
            let length = axis.of(inner_low)..axis.of(inner_high);
            let edge = Cylinder::<$S>::spanning(axis, length, frame.edge(axis, index), radius);
            let (Ok(edge), Ok(corner)) = (edge, Sphere::<$S>::new(frame.corner(index), radius))
            else {
                return Err(CuboidError::Radius);
            };
            edges[index] = edge;
            corners[index % 8] = corner;
            index += 1;
        }
        Ok(Self { parts: Parts::new(plates, Union::new(edges, corners)) })
    }
} }

impl<S: Scalar> Cuboid<S> {
    /// A box from its lowest corner to its highest, with edges and corners rounded by a radius. In constants, use
    /// [`RoundedCuboid::new`].
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
        let frame = Frame { outer: [low, high], inner: [low + round, high - round] };
        let [inner_low, inner_high] = frame.inner;
        let core = Self::between(inner_low, inner_high).map_err(|_| CuboidError::Radius)?;
        let edge = |axis: Axis, bits| {
            let [low, high] = [axis.of(inner_low), axis.of(inner_high)];
            Cylinder::along(axis, frame.edge(axis, bits), radius, low, high)
                .map_err(|_| CuboidError::Radius)
        };
        let corner =
            |bits| Sphere::around(frame.corner(bits), radius).map_err(|_| CuboidError::Radius);
        let mut plates = [core; 3];
        let mut edges = [edge(Axis::X, 0)?; 12];
        let mut corners = [corner(0)?; 8];
        for (plate, axis) in plates.iter_mut().zip(Axis::ALL) {
            let [low, high] = frame.plate(axis);
            *plate = Self::between(low, high)?;
        }
        for (of_axis, axis) in edges.chunks_exact_mut(4).zip(Axis::ALL) {
            for (place, bits) in of_axis.iter_mut().zip(0..) {
                *place = edge(axis, bits)?;
            }
        }
        for (place, bits) in corners.iter_mut().zip(0..) {
            *place = corner(bits)?;
        }
        Ok(RoundedCuboid { parts: Union::new(plates, Union::new(edges, corners)) })
    }
}

impl<S: Scalar> Wrap for RoundedCuboid<S> {
    type Inner = Parts<S>;

    #[inline]
    fn inner(&self) -> &Parts<S> {
        &self.parts
    }

    fn is_covered(&self, Face(face): Face) -> bool {
        match face.checked_sub(FIRST_EDGE) {
            None => face % 6 / 2 != face / 6,
            Some(of_edges) => of_edges < 12 * 3 && of_edges % 3 != WALL.0,
        }
    }

    fn face_over(&self, Face(face): Face, at: Vec3<S>) -> Face {
        if face >= FIRST_EDGE {
            return Face(face - face % 3 + WALL.0);
        }
        let plate = face / 6;
        let mut plates = Axis::ALL.into_iter().zip(self.parts.left());
        let is_high = plates.nth(plate.into()).is_some_and(|(axis, plate)| {
            let [low, high] = plate.corners().map(|corner| axis.of(corner).wide());
            let at = axis.of(at).wide();
            at - low > high - at
        });
        Face(8 * plate + u16::from(is_high))
    }
}
