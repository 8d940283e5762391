//! Frames as PNG files.

use super::receive::Frame;
use scancsg::stream::PixelFormat;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

/// The colour of a pixel, eight bits a channel, from its bytes.
pub fn rgb(format: PixelFormat, pixel: &[u8]) -> [u8; 3] {
    match (format, pixel) {
        (PixelFormat::Gray8, &[level]) => [level; 3],
        (PixelFormat::Rgb565, &[low, high]) => {
            let bits = u16::from_le_bytes([low, high]);
            // n bits to eight: the scale's ends meet.
            let widen = |value: u16, max: u16| ((value * 255 + max / 2) / max) as u8;
            [widen(bits >> 11, 31), widen(bits >> 5 & 63, 63), widen(bits & 31, 31)]
        }
        _ => [0; 3],
    }
}

/// Writes frames of one size and format into a PNG file; more than one become an animation
/// (APNG), whose first frame is the still picture.
pub fn write_png(path: &Path, frames: &[Frame]) -> Result<(), String> {
    let fail = |error: &dyn std::fmt::Display| format!("can't write {}: {error}", path.display());
    let Some(first) = frames.first().map(|frame| frame.header) else { return Ok(()) };
    let file = File::create(path).map_err(|error| fail(&error))?;
    let mut encoder =
        png::Encoder::new(BufWriter::new(file), u32::from(first.width), u32::from(first.height));
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_color(match first.format {
        PixelFormat::Gray8 => png::ColorType::Grayscale,
        _ => png::ColorType::Rgb,
    });
    if frames.len() > 1 {
        encoder.set_animated(frames.len() as u32, 0).map_err(|error| fail(&error))?;
        encoder.set_frame_delay(1, 12).map_err(|error| fail(&error))?;
    }
    let mut writer = encoder.write_header().map_err(|error| fail(&error))?;
    for frame in frames {
        let data = match frame.header.format {
            PixelFormat::Gray8 => frame.pixels.clone(),
            format => frame
                .pixels
                .chunks_exact(format.bytes_per_pixel())
                .flat_map(|pixel| rgb(format, pixel))
                .collect(),
        };
        writer.write_image_data(&data).map_err(|error| fail(&error))?;
    }
    writer.finish().map_err(|error| fail(&error))
}
