//! The convex polyhedron.

mod orthographic;
mod perspective;
mod pooled;

pub use crate::geom::hull::PolyhedronError;
pub use pooled::Pooled;

use crate::geom::hull::{self, Hull};
use crate::geom::{Axis, Direction, Line, Vec3};
use crate::quadric::{HalfSpace, meet};
use crate::query::Solid;
use crate::scalar::{ConstOps, Number, Scalar, per_scalar};
use crate::scan::bounds::Bounds;
use crate::scan::leaf;
use crate::span::{Face, Shape, SpanStack};

/// A convex polyhedron of up to `N` faces: what all of its half-spaces have in common. Use it for prisms,
/// wedges, frustums and convex hulls.
///
/// It owns its faces, or borrows a slice of them that several solids may share (see [`bounded_by`](Self::bounded_by)).
/// Redundant faces are harmless.
///
/// ```
/// use scancsg::constant;
/// use scancsg::geom::Axis;
/// use scancsg::solid::Polyhedron;
///
/// /// A hexagonal nut without its hole, 2 wide across its corners.
/// const NUT: Polyhedron<f32, 8> = constant!(Polyhedron::<f32, 8>::prism(
///     Axis::Z,
///     [[1.0, 0.0], [0.5, 0.866], [-0.5, 0.866], [-1.0, 0.0], [-0.5, -0.866], [0.5, -0.866]],
///     0.0,
///     0.5,
/// ));
/// # let _ = NUT;
/// ```
///
/// A prism that is open at one end does not compile:
///
/// ```compile_fail,E0080
/// use scancsg::constant;
/// use scancsg::geom::vec3;
/// use scancsg::solid::{HalfSpace, Polyhedron};
///
/// const HALF: HalfSpace<f32> = constant!(HalfSpace::<f32>::new(vec3(0.0, 0.0, 1.0), 1.0));
/// const OPEN: Polyhedron<f32, 1> = constant!(Polyhedron::<f32, 1>::new([HALF]));
/// # let _ = OPEN;
/// ```
///
/// Faces count in the order in which they are given. A polyhedron asks each face once for a ray: up to
/// twelve or so it is quicker than an [`Intersection`](crate::solid::Intersection) with silhouettes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Polyhedron<S: Scalar, const N: usize, F = [HalfSpace<S>; N]> {
    /// Those beyond `count` aren't used.
    pub(crate) faces: F,
    pub(crate) count: u16,
    pub(crate) low: Vec3<S>,
    pub(crate) high: Vec3<S>,
}

per_scalar! { $S: impl[const N: usize] Polyhedron<$S, N> {
    /// What half-spaces have in common.
    ///
    /// What is thinner than 10⁻¹³ of its distance from the origin is empty. The corners are computed in twice the
    /// precision of `f64`, in N⁴ steps: better in a constant, for up to some 30 faces.
    ///
    /// # Errors
    /// [`PolyhedronError::Empty`], [`PolyhedronError::Unbounded`], [`PolyhedronError::TooFar`].
    pub const fn new(faces: [HalfSpace<$S>; N]) -> Result<Self, PolyhedronError> {
        type Units<S> = ConstOps<<S as Scalar>::Unit>;
        let mut planes = [hull::UNUSED; N];
        let mut i = 0;
        while i < N {
            let HalfSpace { normal, offset } = faces[i];
            let Vec3 { x, y, z } = normal.vector();
            let normal = [Units::<$S>::to_f64(x), Units::<$S>::to_f64(y), Units::<$S>::to_f64(z)];
            planes[i] = (normal, ConstOps::<$S>::to_f64(offset));
            i += 1;
        }
        Self::of_hull(hull::of_planes(planes, N, <$S>::GRID))
    }

    /// A prism over a convex polygon, from `low` to `high` along a coordinate axis.
    ///
    /// The polygon's points are in order, either way round, with the other two coordinates in the order x, y,
    /// z. Its edges are the first faces. Then come those at `low` and `high`, which lie exactly there.
    ///
    /// # Errors
    /// As [`new`](Self::new), and [`PolyhedronError::NotFinite`], [`PolyhedronError::NotConvex`],
    /// and [`PolyhedronError::TooManyFaces`] for more than N − 2 points.
    pub const fn prism<const M: usize>(
        axis: Axis,
        polygon: [[$S; 2]; M],
        low: $S,
        high: $S,
    ) -> Result<Self, PolyhedronError> {
        let mut points = [[0.0; 2]; M];
        let mut i = 0;
        while i < M {
            let [u, v] = polygon[i];
            points[i] = [ConstOps::<$S>::to_f64(u), ConstOps::<$S>::to_f64(v)];
            i += 1;
        }
        let ends = [ConstOps::<$S>::to_f64(low), ConstOps::<$S>::to_f64(high)];
        Self::of_hull(hull::prism(axis, points, ends, <$S>::GRID))
    }

    /// The solid between eight corners: a box, a frustum, a wedge or a pyramid, with flat faces.
    ///
    /// Bit 0 of a corner's index says on which side it is along the first direction, bit 1 along the second,
    /// bit 2 along the third: for a box these are x, y and z. Corners may coincide where faces shrink to edges
    /// or points.
    ///
    /// # Errors
    /// As [`prism`](Self::prism). N is 6 at least.
    pub const fn frustum(corners: [Vec3<$S>; 8]) -> Result<Self, PolyhedronError> {
        let mut points = [[0.0; 3]; 8];
        let mut i = 0;
        while i < 8 {
            let Vec3 { x, y, z } = corners[i];
            points[i] = [ConstOps::<$S>::to_f64(x), ConstOps::<$S>::to_f64(y), ConstOps::<$S>::to_f64(z)];
            i += 1;
        }
        Self::of_hull(hull::frustum(points, <$S>::GRID))
    }

    const fn of_hull(hull: Result<Hull<N>, PolyhedronError>) -> Result<Self, PolyhedronError> {
        type Units<S> = ConstOps<<S as Scalar>::Unit>;
        let Hull { planes, count, low, high } = match hull {
            Ok(hull) => hull,
            Err(error) => return Err(error),
        };
        let unused = HalfSpace { normal: Direction::<$S>::Z, offset: ConstOps::<$S>::ZERO };
        let mut faces = [unused; N];
        let mut i = 0;
        while i < count {
            let ([x, y, z], offset) = planes[i];
            let normal = [Units::<$S>::from_f64(x), Units::<$S>::from_f64(y), Units::<$S>::from_f64(z)];
            let normal = Direction::<$S>::new(normal);
            faces[i] = HalfSpace { normal, offset: ConstOps::<$S>::from_f64(offset) };
            i += 1;
        }
        let low = Vec3::new(ConstOps::<$S>::from_f64(low[0]), ConstOps::<$S>::from_f64(low[1]), ConstOps::<$S>::from_f64(low[2]));
        let high = Vec3::new(ConstOps::<$S>::from_f64(high[0]), ConstOps::<$S>::from_f64(high[1]), ConstOps::<$S>::from_f64(high[2]));
        Ok(Self { faces, count: count as u16, low, high })
    }
} }

/// For any number type: what a type parameter can call. In constants, use the constructors above.
impl<S: Scalar, const N: usize> Polyhedron<S, N> {
    /// A prism over a convex polygon, from `low` to `high` along a coordinate axis.
    ///
    /// # Errors
    /// As [`prism`](Self::prism).
    pub fn extruded<const M: usize>(
        axis: Axis,
        polygon: [[S; 2]; M],
        low: S,
        high: S,
    ) -> Result<Self, PolyhedronError> {
        let points = polygon.map(|point| point.map(S::to_f64));
        let ends = [low, high].map(S::to_f64);
        Self::rounded(hull::prism(axis, points, ends, S::GRID)?)
    }

    /// The solid between eight corners.
    ///
    /// # Errors
    /// As [`frustum`](Self::frustum).
    pub fn with_corners(corners: [Vec3<S>; 8]) -> Result<Self, PolyhedronError> {
        let points = corners.map(|corner| corner.to_array().map(S::to_f64));
        Self::rounded(hull::frustum(points, S::GRID)?)
    }

    fn rounded(hull: Hull<N>) -> Result<Self, PolyhedronError> {
        let [low, high] = [hull.low, hull.high].map(|corner| Vec3::from(corner.map(S::from_f64)));
        let mut faces = [HalfSpace { normal: Direction::Z, offset: S::ZERO }; N];
        for (face, (normal, offset)) in faces.iter_mut().zip(hull.planes).take(hull.count) {
            *face = HalfSpace {
                normal: Direction::from_unit(normal.map(S::Unit::from_f64)),
                offset: S::from_f64(offset),
            };
        }
        Ok(Self { faces, count: hull.count as u16, low, high })
    }
}

impl<S: Scalar, const N: usize, F: AsRef<[HalfSpace<S>]>> Polyhedron<S, N, F> {
    /// What up to `N` half-spaces have in common: an array of them, or a slice that several solids may share.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::solid::{HalfSpace, Polyhedron};
    ///
    /// let wedge = [
    ///     HalfSpace::<f32>::new(vec3(-1.0, 0.0, 0.0), 0.0)?,
    ///     HalfSpace::<f32>::new(vec3(0.0, -1.0, 0.0), 0.0)?,
    ///     HalfSpace::<f32>::new(vec3(1.0, 1.0, 0.0), 1.0)?,
    ///     HalfSpace::<f32>::new(vec3(0.0, 0.0, -1.0), 0.0)?,
    ///     HalfSpace::<f32>::new(vec3(0.0, 0.0, 1.0), 1.0)?,
    /// ];
    /// let shared = Polyhedron::<f32, 8, &[_]>::bounded_by(&wedge)?;
    /// # let _ = shared;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](Polyhedron::new), and [`PolyhedronError::TooManyFaces`].
    pub fn bounded_by(faces: F) -> Result<Self, PolyhedronError> {
        let given = faces.as_ref();
        let count = u16::try_from(given.len()).ok().filter(|_| given.len() <= N);
        let count = count.ok_or(PolyhedronError::TooManyFaces)?;
        let mut planes = [hull::UNUSED; N];
        for (plane, face) in planes.iter_mut().zip(given) {
            let normal = face.normal.vector().to_array();
            *plane = (normal.map(S::Unit::to_f64), face.offset.to_f64());
        }
        let Hull { low, high, .. } = hull::of_planes(planes, given.len(), S::GRID)?;
        let [low, high] = [low, high].map(|corner| Vec3::from(corner.map(S::from_f64)));
        Ok(Self { faces, count, low, high })
    }

    /// The half-spaces.
    #[must_use]
    #[inline]
    pub fn faces(&self) -> &[HalfSpace<S>] {
        self.faces.as_ref().get(..self.count.into()).unwrap_or_default()
    }
}

impl<S: Scalar, const N: usize, F> Shape for Polyhedron<S, N, F> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = N as u16;
}

impl<S: Scalar, const N: usize, F: AsRef<[HalfSpace<S>]>> Solid for Polyhedron<S, N, F> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        stack.put_all(meet::half_spaces(self.faces(), line), first);
    }

    fn bounds(&self) -> Bounds<S> {
        Bounds::Box { low: self.low, high: self.high }
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        self.faces().get(usize::from(face.0)).map_or(near, |face| face.onto_plane(near))
    }

    fn normal(&self, face: Face, _: Vec3<S>) -> Vec3<S> {
        self.faces().get(usize::from(face.0)).map_or(Vec3::ZERO, HalfSpace::outward)
    }

    fn cosine(&self, face: Face, _: impl FnOnce() -> Vec3<S>, to: Vec3<S>) -> S {
        self.normal(face, to).dot(to)
    }
}

leaf!([S: Scalar, const N: usize, F: AsRef<[HalfSpace<S>]>] Polyhedron<S, N, F>);
