//! Solids that are stretched, mirrored or sheared.

mod orthographic;
mod perspective;
mod walk;

use super::nearby::anchor;
use crate::geom::{AffineError, AffineMap, Line, Vec3};
use crate::scalar::Scalar;
use crate::scan::bounds::{Around, Bounds};
use crate::solid::{Rgb, Solid};
use crate::span::{Face, Shape, SpanStack};

/// A solid that an [`AffineMap`] has scaled, mirrored or sheared, and moved: ellipsoids, elliptic cylinders,
/// mirror images. It owns its solid, or borrows it.
///
/// Rays are taken to the solid's own frame. To turn or move a solid, [`Placed`](super::Placed) is quicker.
///
/// ```
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::solid::{RayCast, Scaled, Sphere};
/// use scancsg::span::SpanList;
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let egg = Scaled::by(ball, [3.0, 1.0, 2.0])?;
/// let ray = Ray::new(vec3(9.0, 0.0, 0.0), vec3(-1.0, 0.0, 0.0))?;
/// let hit = egg.hit(&ray, &mut SpanList::<_, 1>::new()).ok_or("a miss")?;
/// assert_eq!((hit.t, hit.normal), (6.0, vec3(1.0, 0.0, 0.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// In a constant, make the map first:
///
/// ```
/// use scancsg::constant;
/// use scancsg::geom::{AffineMap, vec3};
/// use scancsg::solid::{Scaled, Sphere};
///
/// static EGG: Scaled<Sphere<f32>> = Scaled::new(
///     constant!(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)),
///     constant!(AffineMap::<f32>::scale([3.0, 1.0, 2.0])),
/// );
/// # let _ = EGG;
/// ```
///
/// A map that flattens does not compile there:
///
/// ```compile_fail,E0080
/// use scancsg::{constant, geom::AffineMap};
///
/// const FLAT: AffineMap<f32> = constant!(AffineMap::<f32>::scale([3.0, 0.0, 2.0]));
/// # let _ = FLAT;
/// ```
///
/// Seen along parallel rays it costs about as much as the solid inside. From an eye, each pixel has a camera of
/// its own: an ellipsoid takes 6 times as much there as along parallel rays, an elliptic cylinder 11 times.
///
/// In fixed point, a line is rounded in the solid's own frame, to units of that. So make the solid twice as large
/// as it is to be, or larger, and scale it down: then t is within about one unit for 99 % of ordinary rays. Scaled up, what
/// rounding loses is as much larger.
///
/// A camera of your own sees it inside a [`ByLine`](super::ByLine).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scaled<T: Shape> {
    pub(crate) solid: T,
    pub(crate) map: AffineMap<T::Scalar>,
}

impl<T: Shape> Scaled<T> {
    /// The solid as a map takes it.
    #[must_use]
    pub const fn new(solid: T, map: AffineMap<T::Scalar>) -> Self {
        Self { solid, map }
    }

    /// The solid scaled along each coordinate axis, about the origin; a factor below zero mirrors.
    ///
    /// # Errors
    /// [`AffineError`].
    pub fn by(solid: T, factors: [T::Scalar; 3]) -> Result<Self, AffineError> {
        AffineMap::scaling(factors).map(|map| Self { solid, map })
    }

    /// Takes the solid by another map: for what moves from frame to frame.
    pub const fn set_map(&mut self, map: AffineMap<T::Scalar>) {
        self.map = map;
    }
}

impl<T: Shape> Shape for Scaled<T> {
    type Scalar = T::Scalar;
    const SPANS: usize = T::SPANS;
    const STACK: usize = T::STACK;
    const FACES: u16 = T::FACES;
}

impl<T: Solid> Solid for Scaled<T> {
    fn spans(&self, line: &Line<T::Scalar>, first: Face, stack: &mut SpanStack<'_, T::Scalar>) {
        let back = self.map.line_back(line, anchor(&self.solid.bounds()));
        let start = stack.len();
        self.solid.spans(&back.line, first, stack);
        stack.recount(start, |t| back.parameters.of(t));
    }

    fn normal(&self, face: Face, at: Vec3<T::Scalar>) -> Vec3<T::Scalar> {
        self.map.normal(at, |own| self.solid.normal(face, own))
    }

    fn bounds(&self) -> Bounds<T::Scalar> {
        let Some(Around { center, half, is_ball }) = self.solid.bounds().middle() else {
            return Bounds::Unbounded;
        };
        let middle = self.map.point_wide(center);
        let reach = self.map.reach(half, is_ball);
        // Room for what mapping, and rounding to the number type, may move.
        let size = self.map.reach(center, false).max_abs() + middle.max_abs() + reach.max_abs();
        let room = T::Scalar::uncertainty(size + size) + T::Scalar::ROUNDING.wide();
        let reach = reach + Vec3::new(room, room, room);
        Bounds::Box {
            low: (middle - reach).map(T::Scalar::from_wide),
            high: (middle + reach).map(T::Scalar::from_wide),
        }
    }

    fn onto(&self, face: Face, near: Vec3<T::Scalar>) -> Vec3<T::Scalar> {
        self.map.point(self.solid.onto(face, self.map.point_back(near)))
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.solid.color(face)
    }
}
