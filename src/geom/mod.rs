//! Vectors, rays, rigid motions, and the rays of a picture as functions of the pixel.

mod direction;
mod pixels;
mod pose;
mod ray;
mod vec3;

pub(crate) use direction::{Axis, Direction};
pub use pixels::{
    Affine, Column, Extent, OrthographicRays, OrthographicRow, PerspectiveRays, PerspectiveRow,
    RayRow, Rays,
};
pub use pose::{Pose, PoseError};
pub use ray::{Line, Ray, RayError};
pub use vec3::{Vec3, vec3};
