//! Text: the outlines of an installed font's letters.

use super::{Flat, Polygon};
use crate::map::Point;
use fontdb::{Database, Family, Query, Style, Weight};
use rustybuzz::ttf_parser::{GlyphId, OutlineBuilder};
use rustybuzz::{Face, UnicodeBuffer, shape};
use std::sync::OnceLock;

/// Into how many straight pieces a curve of a letter is divided.
const PIECES: usize = 5;

/// OpenSCAD divides the outlines of letters by 1,000, but the ways between them by 1,024.
const NARROWER: f64 = 1000.0 / 1024.0;

/// What a node `text` says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Text<'a> {
    /// The letters.
    pub text: &'a str,
    /// About the height of a capital letter.
    pub size: f64,
    /// How far apart letters are, where 1 is usual.
    pub spacing: f64,
    /// A family, then a style behind a colon: `Liberation Sans:style=Bold`. Empty for the usual one.
    pub font: &'a str,
    /// `left`, `center` or `right`.
    pub halign: &'a str,
    /// `baseline`, `bottom`, `center` or `top`.
    pub valign: &'a str,
}

/// The letters of a text, side by side. `None` if no font is installed.
#[must_use]
pub fn text(text: &Text<'_>) -> Option<Flat> {
    static FONTS: OnceLock<Database> = OnceLock::new();
    let fonts = FONTS.get_or_init(|| {
        let mut fonts = Database::new();
        fonts.load_system_fonts();
        fonts
    });
    let font = find(fonts, text.font)?;
    fonts.with_face_data(font, |data, index| {
        Face::from_slice(data, index).map(|face| set(text, &face))
    })?
}

/// The font that comes nearest to a name.
fn find(fonts: &Database, name: &str) -> Option<fontdb::ID> {
    let (family, style) = name.split_once(':').unwrap_or((name, ""));
    let style = style.to_lowercase();
    // Fonts of the same widths stand in for those that systems seldom have.
    let family = match family.trim() {
        "" | "Arial" | "Helvetica" => "Liberation Sans",
        "Times" | "Times New Roman" => "Liberation Serif",
        "Courier" | "Courier New" => "Liberation Mono",
        other => other,
    };
    let usual = match family {
        _ if family.contains("Mono") => "DejaVu Sans Mono",
        _ if family.contains("Serif") => "DejaVu Serif",
        _ => "DejaVu Sans",
    };
    let families = [Family::Name(family), Family::Name(usual), Family::SansSerif];
    let is = |word: &str| style.contains(word);
    let query = Query {
        families: &families,
        weight: if is("bold") { Weight::BOLD } else { Weight::NORMAL },
        style: if is("italic") || is("oblique") { Style::Italic } else { Style::Normal },
        ..Query::default()
    };
    fonts.query(&query).or_else(|| fonts.faces().next().map(|face| face.id))
}

fn set(text: &Text<'_>, face: &Face<'_>) -> Flat {
    // A size is in points of 72 to the inch, at 100 units to the inch.
    let scale = text.size * 100.0 / 72.0 / f64::from(face.units_per_em());
    let mut letters = UnicodeBuffer::new();
    letters.push_str(text.text);
    letters.guess_segment_properties();
    let set = shape(face, &[], letters);
    let (mut x, mut top, mut bottom) = (0.0, f64::NEG_INFINITY, f64::INFINITY);
    let mut shapes = Vec::new();
    for (glyph, at) in set.glyph_infos().iter().zip(set.glyph_positions()) {
        let mut outline = Outline {
            scale,
            shift: [x + f64::from(at.x_offset) * scale * NARROWER, f64::from(at.y_offset) * scale],
            outlines: Vec::new(),
        };
        let id = GlyphId(u16::try_from(glyph.glyph_id).unwrap_or(0));
        if let Some(bounds) = face.outline_glyph(id, &mut outline) {
            top = f64::max(top, f64::from(bounds.y_max) * scale);
            bottom = f64::min(bottom, f64::from(bounds.y_min) * scale);
            shapes.push(outline.outlines);
        }
        x += f64::from(at.x_advance) * scale * NARROWER * text.spacing;
    }
    let left = match text.halign {
        "center" => -x / 2.0,
        "right" => -x,
        _ => 0.0,
    };
    let low = match text.valign {
        "top" => -top,
        "center" => -(top + bottom) / 2.0,
        "bottom" => -bottom,
        _ => 0.0,
    };
    let low = if low.is_finite() { low } else { 0.0 };
    let moved = |[x, y]: Point| [x + left, y + low];
    Flat::union(shapes.into_iter().map(|outlines| {
        let outlines: Vec<Vec<Point>> =
            outlines.into_iter().map(|outline| outline.into_iter().map(moved).collect()).collect();
        Flat::Polygon(Polygon::of_letter(&outlines))
    }))
}

/// The straight pieces of a letter.
struct Outline {
    scale: f64,
    shift: Point,
    outlines: Vec<Vec<Point>>,
}

impl Outline {
    fn point(&self, x: f32, y: f32) -> Point {
        [f64::from(x) * self.scale + self.shift[0], f64::from(y) * self.scale + self.shift[1]]
    }

    fn last(&self) -> Point {
        self.outlines.last().and_then(|outline| outline.last()).copied().unwrap_or(self.shift)
    }

    fn push(&mut self, point: Point) {
        if let Some(outline) = self.outlines.last_mut() {
            outline.push(point);
        }
    }

    /// A Bézier curve by its control points, by de Casteljau's way.
    fn curve<const N: usize>(&mut self, control: [Point; N]) {
        for piece in 1..=PIECES {
            let t = piece as f64 / PIECES as f64;
            let mut points = control;
            for count in (1..N).rev() {
                for i in 0..count {
                    points[i] =
                        [0, 1].map(|k| points[i][k] + (points[i + 1][k] - points[i][k]) * t);
                }
            }
            self.push(points[0]);
        }
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        let point = self.point(x, y);
        self.outlines.push(vec![point]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.push(self.point(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.curve([self.last(), self.point(x1, y1), self.point(x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.curve([self.last(), self.point(x1, y1), self.point(x2, y2), self.point(x, y)]);
    }

    fn close(&mut self) {}
}
