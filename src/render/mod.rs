//! Cameras, pictures and their scanlines, shading and pixel formats.

mod camera;
mod picture;
mod pixel;
mod shade;
mod size;
mod smooth;

pub use crate::solid::Rgb;
pub use camera::{Camera, CameraError, Orthographic, Perspective};
pub use picture::{Picture, RowError, Run, Sample, Scanline};
pub use pixel::{Blend, Gray8, Pixel, PixelFormat, Rgb565};
pub use shade::{Depth, Lambert, ShadeError, Shader, XRay};
pub use size::{Size, SizeError};
pub use smooth::{SmoothColumn, SmoothError, SmoothPicture, Smoothing};
