//! Cameras, pictures and their scanlines, shading and pixels.

mod camera;
mod dither;
mod palette;
mod picture;
pub mod pixel;
mod sample;
mod shade;
mod size;
mod smooth;
mod source;

pub use crate::solid::Rgb;
pub use camera::{Camera, CameraError, Orthographic, Perspective};
pub use dither::{Bayer, Dithered};
pub use palette::Palette;
pub use picture::{Picture, RowError, Run, Scanline};
pub use pixel::{Blend, Gray8, Mono, Pixel, Rgb565, Rgb565Be, Rgb888};
pub use sample::Sample;
pub use shade::{Depth, Lambert, ShadeError, Shader, XRay};
pub use size::{Size, SizeError};
pub use smooth::{SmoothColumn, SmoothError, SmoothPicture, Smoothing};
pub use source::{RowSource, RunSource};
