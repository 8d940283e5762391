//! Frames as PNG data.

use super::receive::Frame;
use scancsg::stream::PixelFormat;

/// The colour of a pixel of a row, eight bits a channel: black where the row has none.
pub fn rgb(format: PixelFormat, row: &[u8], x: usize) -> [u8; 3] {
    let byte = |index: usize| row.get(index).copied().unwrap_or(0);
    match format {
        PixelFormat::Rgb565 => {
            let bits = u16::from_le_bytes([byte(2 * x), byte(2 * x + 1)]);
            // n bits to eight: the scale's ends meet.
            let widen = |value: u16, max: u16| ((value * 255 + max / 2) / max) as u8;
            [widen(bits >> 11, 31), widen(bits >> 5 & 63, 63), widen(bits & 31, 31)]
        }
        PixelFormat::Rgb888 => [byte(3 * x), byte(3 * x + 1), byte(3 * x + 2)],
        PixelFormat::Mono => [if byte(x / 8) << (x % 8) & 0x80 == 0 { 0 } else { 255 }; 3],
        _ => [byte(x); 3],
    }
}

/// The frame as a PNG file.
pub fn png(frame: &Frame) -> Result<Vec<u8>, String> {
    let header = frame.header;
    let (width, height) = (u32::from(header.width), u32::from(header.height));
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(match header.format {
        PixelFormat::Rgb565 | PixelFormat::Rgb888 => png::ColorType::Rgb,
        _ => png::ColorType::Grayscale,
    });
    encoder.set_depth(match header.format {
        PixelFormat::Mono => png::BitDepth::One,
        _ => png::BitDepth::Eight,
    });
    let expanded: Vec<u8>;
    let data = match header.format {
        PixelFormat::Rgb565 => {
            let rows = frame.pixels.chunks_exact(header.row_bytes());
            let pixels = rows.flat_map(|row| {
                (0..usize::from(header.width)).flat_map(|x| rgb(header.format, row, x))
            });
            expanded = pixels.collect();
            &expanded
        }
        _ => &frame.pixels,
    };
    let result = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(data)?;
        writer.finish()
    });
    result.map_err(|error| format!("can't make a PNG file: {error}"))?;
    Ok(file)
}
