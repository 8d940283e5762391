//! The growing picture in the terminal, above a progress bar.

use super::image::rgb;
use super::receive::Traffic;
use console::Term;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use scancsg::stream::Receiver;
use std::fmt::Write;

/// Shows frames while they arrive. Where standard error is no terminal, it shows nothing.
pub struct Display {
    bar: ProgressBar,
    term: Term,
}

impl Display {
    pub fn new() -> Self {
        let term = Term::stderr();
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr_with_hz(15));
        Self { bar, term }
    }

    /// Begins frame `index` of `count`, if it is known how many there will be.
    pub fn begin(&self, index: u32, count: Option<u32>) {
        let title = match count {
            Some(1) => String::new(),
            Some(count) => format!("frame {}/{count} ", index + 1),
            None => format!("frame {} ", index + 1),
        };
        let style = ProgressStyle::with_template(&format!(
            "{{msg}}{title}[{{bar:24}}] {{pos}}/{{len}} rows  {{per_sec}}  {{prefix}}"
        ));
        if let Ok(style) = style {
            self.bar.set_style(
                style
                    .with_key("per_sec", |state: &indicatif::ProgressState, w: &mut dyn Write| {
                        let _ = write!(w, "{:.0} rows/s", state.per_sec());
                    })
                    .progress_chars("=> "),
            );
        }
        self.bar.reset();
    }

    /// Draws what is there of a frame.
    pub fn show(&self, receiver: &Receiver<'_>, traffic: Traffic) {
        let Some(header) = receiver.header() else { return };
        self.bar.set_length(u64::from(header.height));
        self.bar.set_position(u64::from(receiver.rows_received()));
        self.bar.set_prefix(format!("{} bytes", traffic.bytes));
        if self.term.is_term() {
            self.bar.set_message(self.half_blocks(receiver));
        }
    }

    /// Leaves the picture on the screen.
    pub fn finish(&self) {
        self.bar.abandon();
    }

    /// The picture in character cells of two pixels each, one above the other: the largest that
    /// fits the terminal.
    fn half_blocks(&self, receiver: &Receiver<'_>) -> String {
        let Some(header) = receiver.header() else { return String::new() };
        let (lines, columns) = self.term.size();
        // One line for the bar and one for the shell's prompt.
        let columns = usize::from(columns).max(1);
        let lines = usize::from(lines).saturating_sub(2).max(1);
        let (width, height) = (usize::from(header.width), usize::from(header.height));
        let shrink = width.div_ceil(columns).max(height.div_ceil(2 * lines)).max(1);
        let colors = console::colors_enabled_stderr();

        let area = |x: usize, y: usize| average(receiver, x * shrink, y * shrink, shrink);
        let mut picture = String::new();
        for line in 0..height.div_ceil(2 * shrink) {
            for column in 0..width.div_ceil(shrink) {
                let upper = area(column, 2 * line);
                let lower = area(column, 2 * line + 1);
                let cell = match (upper, lower) {
                    (None, None) => " ".into(),
                    _ if !colors => ascii(upper, lower).to_string(),
                    _ => half_block(upper.unwrap_or_default(), lower.unwrap_or_default()),
                };
                picture.push_str(&cell);
            }
            picture.push('\n');
        }
        picture
    }
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
    let [r, g, b] = [r, g, b].map(|channel| ((u16::from(channel) * 5 + 127) / 255) as u8);
    16 + 36 * r + 6 * g + b
}

/// The mean colour of a square of pixels, of the rows that are there.
fn average(receiver: &Receiver<'_>, x: usize, y: usize, side: usize) -> Option<[u8; 3]> {
    let header = receiver.header()?;
    let bytes = header.format.bytes_per_pixel();
    let (mut sum, mut count) = ([0_u32; 3], 0);
    for y in y..y + side {
        let Some(row) = u16::try_from(y).ok().and_then(|y| receiver.row(y)) else { continue };
        for pixel in row.chunks_exact(bytes).skip(x).take(side) {
            for (sum, channel) in sum.iter_mut().zip(rgb(header.format, pixel)) {
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
