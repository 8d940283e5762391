//! Pixels of the link as those of a canvas.

use scancsg::stream::PixelFormat;

/// Writes a row's pixels, as they are on the link, into `canvas`: red, green, blue and opacity.
pub fn to_canvas(format: PixelFormat, row: &[u8], canvas: &mut [u8]) {
    let (pixels, _) = canvas.as_chunks_mut::<4>();
    let opaque = |[red, green, blue]: [u8; 3]| [red, green, blue, u8::MAX];
    match format {
        PixelFormat::Gray8 => {
            pixels.iter_mut().zip(row).for_each(|(to, level)| *to = opaque([*level; 3]));
        }
        PixelFormat::Rgb565 => {
            let (row, _) = row.as_chunks::<2>();
            let colors = row.iter().map(|bytes| rgb565(u16::from_le_bytes(*bytes)));
            pixels.iter_mut().zip(colors).for_each(|(to, color)| *to = opaque(color));
        }
        PixelFormat::Rgb888 => {
            let (row, _) = row.as_chunks::<3>();
            pixels.iter_mut().zip(row).for_each(|(to, color)| *to = opaque(*color));
        }
        PixelFormat::Mono => {
            let bits = row.iter().flat_map(|byte| (0..8).map(move |bit| byte << bit & 0x80 != 0));
            let levels = bits.map(|is_lit| if is_lit { u8::MAX } else { 0 });
            pixels.iter_mut().zip(levels).for_each(|(to, level)| *to = opaque([level; 3]));
        }
        // A format that this page doesn't know stays blank.
        _ => {}
    }
}

/// Five and six bits to eight: the scale's ends meet.
fn rgb565(bits: u16) -> [u8; 3] {
    let widen = |value: u16, max: u16| ((value * 255 + max / 2) / max) as u8;
    [widen(bits >> 11, 31), widen(bits >> 5 & 63, 63), widen(bits & 31, 31)]
}
