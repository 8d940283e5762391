//! The rays of a picture, as affine functions of the pixel.
//!
//! A picture's *image plane* is the plane through the scene's centre at right angles to the
//! viewing direction. A pixel (X, Y), counted from the middle of the picture, sees the point
//! `P = centre + X·right + Y·down` of it, and the parameter t of its ray is zero there. So t stays
//! as small as the scene, however far away the camera is.

use super::{Line, Pose, Vec3};
use crate::scalar::Scalar;

/// A pixel's column: its index, and its centre counted from the middle of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column<S> {
    /// 0 at the left.
    pub index: u32,
    /// In pixels from the middle of the picture, positive to the right.
    pub x: S,
}

/// The columns, from `start` to before `end`, outside of which a solid can't be seen in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Extent {
    /// The first column.
    pub start: u32,
    /// Behind the last column.
    pub end: u32,
}

impl Extent {
    /// No column.
    pub const EMPTY: Self = Self { start: 0, end: 0 };

    /// All columns of a row.
    #[must_use]
    pub const fn all(columns: u32) -> Self {
        Self { start: 0, end: columns }
    }

    /// Whether no column is left.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.start >= self.end
    }

    /// Whether a column is inside.
    #[must_use]
    #[inline]
    pub const fn contains(self, index: u32) -> bool {
        self.start <= index && index < self.end
    }

    /// From the first column of either to the last of either.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        match (self.is_empty(), other.is_empty()) {
            (true, _) => other,
            (_, true) => self,
            _ => Self { start: self.start.min(other.start), end: self.end.max(other.end) },
        }
    }

    /// The columns of both.
    #[must_use]
    pub fn overlap(self, other: Self) -> Self {
        let (start, end) = (self.start.max(other.start), self.end.min(other.end));
        if start < end { Self { start, end } } else { Self::EMPTY }
    }
}

/// The rays of a picture, orthographic or perspective.
pub trait Rays: Copy {
    /// The number type.
    type Scalar: Scalar;

    /// The number of columns.
    fn columns(&self) -> u32;

    /// The ray through (x, y), in pixels from the middle of the picture.
    fn line(&self, x: Self::Scalar, y: Self::Scalar) -> Line<Self::Scalar>;

    /// The smallest parameter that the camera sees.
    fn start(&self) -> Self::Scalar;

    /// The same rays in the own frame of a solid that stands at `pose`.
    #[must_use]
    fn back_from(&self, pose: &Pose<Self::Scalar>) -> Self;
}

/// The rays of an orthographic picture: all parallel to `forward`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parallel<S> {
    /// What the middle of the picture shows.
    pub center: Vec3<S>,
    /// The step in the image plane from a pixel to its right neighbour.
    pub right: Vec3<S>,
    /// The step in the image plane from a pixel to the one below.
    pub down: Vec3<S>,
    /// The viewing direction, of length 1.
    pub forward: Vec3<S>,
    /// The number of columns.
    pub columns: u32,
}

impl<S: Scalar> Rays for Parallel<S> {
    type Scalar = S;

    fn columns(&self) -> u32 {
        self.columns
    }

    fn line(&self, x: S, y: S) -> Line<S> {
        Line { origin: self.center + self.right * x + self.down * y, direction: self.forward }
    }

    fn start(&self) -> S {
        S::LOWEST
    }

    fn back_from(&self, pose: &Pose<S>) -> Self {
        Self {
            center: pose.point_back(self.center),
            right: pose.direction_back(self.right),
            down: pose.direction_back(self.down),
            forward: pose.direction_back(self.forward),
            columns: self.columns,
        }
    }
}

/// The rays of a perspective picture: a pencil through the eye.
///
/// The ray of a pixel has the direction `forward + (X·right + Y·down)/distance`, so t is counted
/// along the viewing direction and the eye lies at t = −`distance`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pencil<S> {
    /// The steps of the image plane, as for parallel rays.
    pub plane: Parallel<S>,
    /// From the eye to the centre.
    pub distance: S,
    /// 1/`distance`.
    pub convergence: S,
}

impl<S: Scalar> Rays for Pencil<S> {
    type Scalar = S;

    fn columns(&self) -> u32 {
        self.plane.columns
    }

    fn line(&self, x: S, y: S) -> Line<S> {
        let offset = self.plane.right * x + self.plane.down * y;
        Line {
            origin: self.plane.center + offset,
            direction: self.plane.forward + offset * self.convergence,
        }
    }

    fn start(&self) -> S {
        -self.distance
    }

    fn back_from(&self, pose: &Pose<S>) -> Self {
        Self { plane: self.plane.back_from(pose), ..*self }
    }
}
