//! The rays of a picture, as affine functions of the pixel.
//!
//! A picture's *image plane* is the plane through the scene's centre at right angles to the
//! viewing direction. A pixel (X, Y), counted from the middle of the picture, sees the point
//! `P = centre + X·right + Y·down` of it, and the parameter t of its ray is zero there. So t stays
//! as small as the scene, however far away the camera is.
//!
//! X and Y are counted in half pixels, because the middle of a picture of even width lies between
//! two pixels. So they are whole numbers.

mod orthographic;
mod perspective;

pub use orthographic::{OrthographicRays, OrthographicRow};
pub use perspective::{PerspectiveRays, PerspectiveRow};

use super::pose::Pose;
use super::ray::Line;
use crate::scalar::Scalar;

/// The rays of a picture, orthographic or perspective.
pub trait Rays: Copy {
    /// The number type.
    type Scalar: Scalar;

    /// The rays of one row.
    type Row: RayRow<Scalar = Self::Scalar>;

    /// The rays of the row `y` half pixels below the middle of the picture.
    fn row(&self, y: i32) -> Self::Row;

    /// The smallest parameter that the camera sees.
    fn start(&self) -> Self::Scalar;

    /// Whether a picture of so many rows keeps inside the number type's range. In fixed point, the image
    /// plane may reach to half of that ([`Scalar::HIGHEST`]), and an eye may see as far to the side as
    /// directions have numbers for: with w columns, h rows and the field of view φ, (1 + w/h)·tan φ/2 < 7.
    fn fits(&self, rows: u16) -> bool;

    /// The same rays in the own frame of a solid that stands at `pose`.
    #[must_use]
    fn back_from(&self, pose: &Pose<Self::Scalar>) -> Self;
}

/// The rays of one row of a picture.
pub trait RayRow: Copy {
    /// The number type.
    type Scalar: Scalar;

    /// The ray `x` half pixels to the right of the middle.
    fn line(&self, x: i32) -> Line<Self::Scalar>;
}
