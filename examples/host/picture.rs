//! A frame as text: half blocks in colours, or characters.

use super::image::rgb;
use scancsg::stream::Assembler;

/// The picture in character cells of two pixels each, one above the other: the largest that fits so many
/// lines and columns.
pub fn half_blocks(frame: &Assembler<'_>, lines: usize, columns: usize) -> Vec<String> {
    let Some(header) = frame.header() else { return Vec::new() };
    let (width, height) = (usize::from(header.width), usize::from(header.height));
    let shrink = width.div_ceil(columns.max(1)).max(height.div_ceil(2 * lines.max(1))).max(1);
    let colors = console::colors_enabled_stderr();
    let area = |x: usize, y: usize| average(frame, x * shrink, y * shrink, shrink);
    let cell = |column: usize, line: usize| {
        let (upper, lower) = (area(column, 2 * line), area(column, 2 * line + 1));
        match (upper, lower) {
            (None, None) => " ".into(),
            _ if !colors => ascii(upper, lower).to_string(),
            _ => half_block(upper.unwrap_or_default(), lower.unwrap_or_default()),
        }
    };
    let line = |line| (0..width.div_ceil(shrink)).map(|column| cell(column, line)).collect();
    (0..height.div_ceil(2 * shrink)).map(line).collect()
}

/// A character cell whose halves have two colours.
fn half_block(upper: [u8; 3], lower: [u8; 3]) -> String {
    let style = console::Style::new().for_stderr();
    let style = if console::true_colors_enabled_stderr() {
        let ([r, g, b], [under_r, under_g, under_b]) = (upper, lower);
        style.true_color(r, g, b).on_true_color(under_r, under_g, under_b)
    } else {
        style.color256(color_cube(upper)).on_color256(color_cube(lower))
    };
    style.apply_to('▀').to_string()
}

/// The nearest of the 256 terminal colours that form a 6×6×6 cube, or of its 24 greys.
fn color_cube([r, g, b]: [u8; 3]) -> u8 {
    if r == g && g == b {
        return match r {
            0..4 => 16,
            247.. => 231,
            _ => 232 + (r - 4) / 10 % 24,
        };
    }
    // The levels of the cube are 0, 95, 135, 175, 215, 255.
    let [r, g, b] = [r, g, b].map(|channel| match channel {
        0..48 => 0,
        48..115 => 1,
        _ => (channel - 35) / 40,
    });
    16 + 36 * r + 6 * g + b
}

/// The mean colour of a square of pixels, of the rows that are there.
fn average(frame: &Assembler<'_>, x: usize, y: usize, side: usize) -> Option<[u8; 3]> {
    let header = frame.header()?;
    let (mut sum, mut count) = ([0_u32; 3], 0);
    let right = (x + side).min(header.width.into());
    for y in y..y + side {
        let Some(row) = u16::try_from(y).ok().and_then(|y| frame.row(y)) else { continue };
        for x in x..right {
            for (sum, channel) in sum.iter_mut().zip(rgb(header.format, row, x)) {
                *sum += u32::from(channel);
            }
            count += 1;
        }
    }
    (count > 0).then(|| sum.map(|sum| (sum / count) as u8))
}

/// A character as dark or light as two areas together, where there are no colours.
fn ascii(upper: Option<[u8; 3]>, lower: Option<[u8; 3]>) -> char {
    let channels = [upper.unwrap_or_default(), lower.unwrap_or_default()];
    let sum: usize = channels.iter().flatten().map(|channel| usize::from(*channel)).sum();
    const RAMP: &[u8; 10] = b" .:-=+*#%@";
    RAMP.get(sum * (RAMP.len() - 1) / (6 * 255)).map_or(' ', |byte| char::from(*byte))
}
