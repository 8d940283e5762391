//! Vectors, rays, rigid motions, and the rays of a picture as functions of the pixel.

mod affine;
mod axis_line;
mod columns;
mod direction;
pub(crate) mod hull;
mod pose;
mod ray;
mod rays;
mod vec3;

pub(crate) use columns::signed;
pub(crate) use direction::Direction;

pub(crate) use affine::{Parameters, RaysBack};

pub use affine::{AffineError, AffineMap};
pub use axis_line::{AxisLine, AxisLineError};
pub use columns::{Affine, Column, Extent};
pub use direction::Axis;
pub use pose::{Pose, PoseError};
pub use ray::{Line, Ray, RayError};
pub use rays::{OrthographicRays, OrthographicRow, PerspectiveRays, PerspectiveRow, RayRow, Rays};
pub use vec3::{Vec3, vec3};
