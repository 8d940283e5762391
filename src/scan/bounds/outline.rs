//! What a solid says of its size, and the outline that rays see of that.

use super::strip::{Rows, Steps};
use crate::geom::{Affine, Extent, OrthographicRays, Pose, Rays, Vec3};
use crate::scalar::{Number, Real, Scalar};
use crate::scan::Empty;

/// A ball or a box around a solid. Say it, and a picture asks the solid only where it can be seen.
///
/// It may be too large, never too small.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::solid::Bounds;
///
/// let around_a_unit_cube = Bounds::Box { low: vec3(0.0, 0.0, 0.0), high: vec3(1.0, 1.0, 1.0) };
/// # let _: Bounds<f32> = around_a_unit_cube;
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Bounds<S> {
    /// Nothing is known, or the solid has no end.
    Unbounded,
    /// A ball.
    Ball {
        /// Its middle.
        center: Vec3<S>,
        /// Its radius.
        radius: S,
    },
    /// A box along the coordinate axes.
    Box {
        /// The corner with the smallest coordinates.
        low: Vec3<S>,
        /// The corner with the largest coordinates.
        high: Vec3<S>,
    },
}

impl<S: Scalar> Bounds<S> {
    /// A middle and half of the lengths along each axis. Bounds with NaN or infinity in them are none.
    pub(crate) fn middle(&self) -> Option<Around<S>> {
        let (center, half) = match *self {
            Self::Unbounded => return None,
            Self::Ball { center, radius } => {
                let radius = radius.wide();
                (center.wide(), Vec3::new(radius, radius, radius))
            }
            Self::Box { low, high } => {
                let (low, high) = (low.wide(), high.wide());
                let half = (high - low) * S::Wide::HALF;
                (low + half, half)
            }
        };
        let around = Around { center, half, is_ball: matches!(self, Self::Ball { .. }) };
        (center.is_finite() && half.is_finite()).then_some(around)
    }

    /// The middle and the radius of a ball around the bounds, or `None` if there are none: for a camera that
    /// is to see all of a solid that isn't known beforehand.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::render::Orthographic;
    /// use scancsg::solid::{Cuboid, Solid};
    ///
    /// let part = Cuboid::<f32>::new(vec3(0.0, 0.0, 0.0), vec3(2.0, 4.0, 4.0))?;
    /// let (middle, radius) = part.bounds().ball().ok_or("the part has no end")?;
    /// assert_eq!((middle, radius), (vec3(1.0, 2.0, 2.0), 3.0));
    /// let (along, up) = (vec3(-1.0, -1.0, -1.0), vec3(0.0, 0.0, 1.0));
    /// let camera = Orthographic::look_along(along, middle, up, 2.0 * radius)?;
    /// # let _ = camera;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn ball(&self) -> Option<(Vec3<S>, S)> {
        let around = self.middle()?;
        Some((around.center.map(S::from_wide), S::from_wide(around.radius())))
    }

    /// Bounds around two solids.
    pub(crate) fn united(&self, other: &Self) -> Self {
        let (Some([low, high]), Some([other_low, other_high])) = (self.corners(), other.corners())
        else {
            return Self::Unbounded;
        };
        let each = |of: fn(S, S) -> S, a: Vec3<S>, b: Vec3<S>| {
            Vec3::new(of(a.x, b.x), of(a.y, b.y), of(a.z, b.z))
        };
        Self::Box { low: each(S::min, low, other_low), high: each(S::max, high, other_high) }
    }

    /// The corners of a box around the bounds.
    fn corners(&self) -> Option<[Vec3<S>; 2]> {
        let Around { center, half, .. } = self.middle()?;
        if let Self::Box { low, high } = *self {
            return Some([low, high]);
        }
        // Room for what rounding may move.
        let room = S::uncertainty(center.max_abs() + half.max_abs()) + S::ROUNDING.wide();
        let half = half + Vec3::new(room, room, room);
        Some([center - half, center + half].map(|corner| corner.map(S::from_wide)))
    }

    /// The bounds of the solid moved by a pose.
    pub(crate) fn placed(&self, pose: &Pose<S>) -> Self {
        let Some(around) = self.middle() else { return Self::Unbounded };
        // Room for what turning, and rounding to the number type, may move.
        let (center, radius) = (around.center, around.radius());
        let size = center.max_abs() + radius;
        let room = S::uncertainty(size + size + size) + S::ROUNDING.wide();
        let radius = S::from_wide(radius + room + room);
        Self::Ball { center: pose.point(center.map(S::from_wide)), radius }
    }
}

/// Bounds as what an outline needs.
pub(crate) struct Around<S: Scalar> {
    pub(crate) center: Vec3<S::Wide>,
    pub(crate) half: Vec3<S::Wide>,
    pub(crate) is_ball: bool,
}

impl<S: Scalar> Around<S> {
    /// The radius of a ball around all of it.
    pub(super) fn radius(&self) -> S::Wide {
        if self.is_ball { self.half.x } else { self.half.length() }
    }

    /// Half of the length along a direction.
    fn half_along(&self, direction: Vec3<S::Wide>) -> S::Wide {
        if self.is_ball {
            return self.half.x;
        }
        let Vec3 { x, y, z } = direction;
        self.half.x * x.abs() + self.half.y * y.abs() + self.half.z * z.abs()
    }
}

/// Rays that see an outline of [`Bounds`]. Implement it, with [`Rays`], for a camera of your own:
/// [`Anywhere`] will do.
pub trait Outline: Rays {
    /// The outline.
    type Silhouette: Silhouette + Empty;

    /// What these rays see of a solid inside the bounds.
    fn outline(&self, bounds: &Bounds<Self::Scalar>) -> Self::Silhouette;
}

/// The rows and columns in which a solid can be seen.
pub trait Silhouette {
    /// Whether any row from the first to the last of two is among them, in half pixels below the
    /// middle.
    fn is_in_rows(&self, rows: [i32; 2]) -> bool;

    /// The columns of the row `y` half pixels below the middle.
    fn extent(&self, y: i32, columns: u32) -> Extent;
}

/// Every pixel: the silhouette of what has no bounds, or of rays that know none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Anywhere;

impl Empty for Anywhere {
    const EMPTY: Self = Self;
}

impl Silhouette for Anywhere {
    fn is_in_rows(&self, _: [i32; 2]) -> bool {
        true
    }

    fn extent(&self, _: i32, columns: u32) -> Extent {
        Extent::all(columns)
    }
}

/// `None` is everywhere.
impl<T: Silhouette> Silhouette for Option<T> {
    fn is_in_rows(&self, rows: [i32; 2]) -> bool {
        self.as_ref().is_none_or(|outline| outline.is_in_rows(rows))
    }

    fn extent(&self, y: i32, columns: u32) -> Extent {
        self.as_ref().map_or(Extent::all(columns), |outline| outline.extent(y, columns))
    }
}

/// A rectangle in the image plane.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rectangle {
    pub(crate) rows: Rows,
    columns: Steps,
}

impl Silhouette for Rectangle {
    fn is_in_rows(&self, rows: [i32; 2]) -> bool {
        self.rows.meet(rows)
    }

    fn extent(&self, _: i32, columns: u32) -> Extent {
        self.columns.columns(columns)
    }
}

impl<S: Scalar> Outline for OrthographicRays<S> {
    type Silhouette = Option<Rectangle>;

    fn outline(&self, bounds: &Bounds<S>) -> Self::Silhouette {
        let around = bounds.middle()?;
        let from_middle = around.center - self.center;
        let size = from_middle.max_abs() + around.half.max_abs() + around.radius();
        let steps = |direction: Vec3<S::Wide>| {
            let (at, half) = (from_middle.dot_compensated(direction), around.half_along(direction));
            let along = Affine { middle: S::Wide::ZERO, step: self.half_pixel };
            Steps::between::<S>(along, at - half, at + half, size + size + size)
        };
        Some(Rectangle { rows: Rows::of(steps(self.down)), columns: steps(self.right) })
    }
}
