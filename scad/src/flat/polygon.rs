//! Polygons with holes: cleaning, booleans, and convex pieces.

use crate::map::{FlatMap, Point};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::simplify::SimplifyShape;
use i_overlay::float::single::SingleFloatOverlay;
use i_triangle::float::triangulatable::Triangulatable;

/// A region with straight edges: parts, each an outline (counted from right to left, that is
/// counter-clockwise) and the outlines of its holes (clockwise).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Polygon {
    parts: Vec<Vec<Vec<Point>>>,
}

impl Polygon {
    /// What is inside an odd number of outlines, whichever way round these are.
    #[must_use]
    pub fn of_outlines(outlines: &[Vec<Point>]) -> Self {
        let outlines: Vec<_> =
            outlines.iter().filter(|outline| outline.len() > 2).cloned().collect();
        if outlines.is_empty() {
            return Self::default();
        }
        // What is simple stays as it is, to the bit.
        if let [outline] = &outlines[..]
            && let Some(outline) = convex(outline)
        {
            return Self { parts: vec![vec![outline]] };
        }
        let parts = outlines.simplify_shape_as::<i64>(FillRule::EvenOdd);
        Self { parts }.on_points_of(outlines.iter().flatten())
    }

    /// What is inside of outlines, all of which count as often as they go around: a letter of a font.
    #[must_use]
    pub fn of_letter(outlines: &[Vec<Point>]) -> Self {
        let parts = outlines.to_vec().simplify_shape_as::<i64>(FillRule::NonZero);
        Self { parts }.on_points_of(outlines.iter().flatten())
    }

    /// What is inside one outline.
    #[must_use]
    pub fn of_outline(outline: Vec<Point>) -> Self {
        Self::of_outlines(&[outline])
    }

    /// What is in several parts that don't overlap: outlines counter-clockwise, holes clockwise.
    pub(super) fn of_parts(parts: Vec<Vec<Vec<Point>>>) -> Self {
        Self { parts }
    }

    /// An outline and its holes, each.
    #[must_use]
    pub fn parts(&self) -> &[Vec<Vec<Point>>] {
        &self.parts
    }

    /// All corners.
    pub fn points(&self) -> impl Iterator<Item = Point> + '_ {
        self.parts.iter().flatten().flatten().copied()
    }

    /// The lowest and the highest coordinates.
    #[must_use]
    pub fn bounds(&self) -> Option<[Point; 2]> {
        let join = |[low, high]: [Point; 2], [l, h]: [Point; 2]| {
            [[low[0].min(l[0]), low[1].min(l[1])], [high[0].max(h[0]), high[1].max(h[1])]]
        };
        self.points().map(|point| [point, point]).reduce(join)
    }

    /// Its image under a map.
    #[must_use]
    pub fn mapped(&self, map: &FlatMap) -> Self {
        if map.determinant() == 0.0 {
            return Self::default();
        }
        let turned = map.determinant() < 0.0;
        let outline = |points: &Vec<Point>| {
            let mut image: Vec<_> = points.iter().map(|point| map.point(*point)).collect();
            if turned {
                image.reverse();
            }
            image
        };
        let part = |part: &Vec<Vec<Point>>| part.iter().map(outline).collect();
        Self { parts: self.parts.iter().map(part).collect() }
    }

    /// A boolean of two polygons.
    #[must_use]
    pub fn combined(&self, other: &Self, rule: OverlayRule) -> Self {
        let parts = self.parts.overlay_as::<i64>(&other.parts, rule, FillRule::NonZero);
        let result = Self { parts };
        result.on_points_of(self.parts.iter().chain(&other.parts).flatten().flatten())
    }

    /// Its outline, if it is convex.
    #[must_use]
    pub fn convex(&self) -> Option<Vec<Point>> {
        match &self.parts[..] {
            [part] => match &part[..] {
                [outline] => convex(outline),
                _ => None,
            },
            _ => None,
        }
    }

    /// Convex polygons, counter-clockwise, that share no more than edges and together are this one.
    #[must_use]
    pub fn convex_pieces(&self) -> Vec<Vec<Point>> {
        let mut pieces = Vec::new();
        for part in &self.parts {
            match &part[..] {
                [outline] if convex(outline).is_some() => pieces.extend(convex(outline)),
                _ => {
                    let found = part.triangulate_as::<i64>().into_delaunay().to_convex_polygons();
                    let found = Self { parts: vec![found] }.on_points_of(part.iter().flatten());
                    pieces.extend(found.parts.into_iter().flatten());
                }
            }
        }
        pieces
    }

    /// Moves corners to the given points where they are the same but for rounding to a grid.
    fn on_points_of<'a>(mut self, points: impl Iterator<Item = &'a Point>) -> Self {
        let mut points: Vec<Point> = points.copied().collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let size = points.iter().flatten().fold(0.0f64, |size, part| size.max(part.abs()));
        let near = size * 1e-9;
        for corner in self.parts.iter_mut().flatten().flatten() {
            let first = points.partition_point(|point| point[0] < corner[0] - near);
            let candidates =
                points.iter().skip(first).take_while(|point| point[0] <= corner[0] + near);
            if let Some(point) =
                candidates.into_iter().find(|point| (point[1] - corner[1]).abs() <= near)
            {
                *corner = *point;
            }
        }
        self
    }
}

/// Twice the area of a triangle, positive if it is counter-clockwise.
fn turn(a: Point, b: Point, c: Point) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The outline counter-clockwise and without repeated points or points on straight edges, if it is convex.
fn convex(outline: &[Point]) -> Option<Vec<Point>> {
    let size = outline.iter().flatten().fold(0.0f64, |size, part| size.max(part.abs()));
    let none = size * size * 1e-13;
    let mut corners: Vec<Point> = outline.to_vec();
    corners.dedup();
    if corners.first() == corners.last() {
        corners.pop();
    }
    let count = corners.len();
    let turns = |corners: &[Point], i: usize| {
        let n = corners.len();
        turn(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n])
    };
    let mut kept: Vec<Point> =
        (0..count).filter(|i| turns(&corners, *i).abs() > none).map(|i| corners[i]).collect();
    if kept.len() < 3 {
        return None;
    }
    let left = (0..kept.len()).filter(|i| turns(&kept, *i) > 0.0).count();
    if left == 0 {
        kept.reverse();
    } else if left != kept.len() {
        return None;
    }
    // A star turns one way, too, but more than once around: its edges' directions aren't in order.
    let angle = |i: usize| {
        let [a, b] = [kept[i], kept[(i + 1) % kept.len()]];
        (b[1] - a[1]).atan2(b[0] - a[0])
    };
    let wraps = (0..kept.len()).filter(|i| angle((i + 1) % kept.len()) < angle(*i)).count();
    (wraps == 1).then_some(kept)
}

#[cfg(test)]
mod tests {
    use super::{Polygon, turn};
    use crate::map::Point;

    fn area(outline: &[Point]) -> f64 {
        (2..outline.len()).map(|i| turn(outline[0], outline[i - 1], outline[i]) / 2.0).sum()
    }

    #[test]
    fn pieces_are_convex_and_fill_the_polygon() {
        let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
        let frame = Polygon::of_outlines(&[square(0.0, 3.0), square(1.0, 2.0)]);
        let ell = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        for (polygon, want) in [(frame, 8.0), (Polygon::of_outline(ell), 3.0)] {
            assert!(polygon.convex().is_none());
            let pieces = polygon.convex_pieces();
            for piece in &pieces {
                assert!(super::convex(piece).is_some());
                assert!(piece.iter().flatten().all(|part| part.fract() == 0.0), "{piece:?}");
            }
            let got: f64 = pieces.iter().map(|piece| area(piece)).sum();
            assert!((got - want).abs() < 1e-9, "{got}");
        }
    }

    #[test]
    fn convex_outlines_are_cleaned() {
        let outline = vec![[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0], [2.0, 0.0]];
        let corners = Polygon::of_outline(outline).convex().unwrap_or_default();
        assert_eq!((corners.len(), area(&corners)), (4, 4.0));
        // Each corner turns left, but twice around.
        let star: Vec<_> =
            (0..5).map(|i| f64::from(i * 2) * 1.2566370614).map(|a| [a.cos(), a.sin()]).collect();
        assert_eq!(super::convex(&star), None);
    }
}
