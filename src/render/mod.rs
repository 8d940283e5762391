//! Cameras, views and rows, shading and pixel formats.

mod pixel;

pub use pixel::{Gray8, Pixel, PixelFormat, Rgb, Rgb565};
