//! Shapes made larger or smaller by a distance.

use super::{Disc, Flat, Polygon, SIDES, hull_of_discs};
use crate::map::Point;
use i_overlay::mesh::float::outline::offset::OutlineOffset;
use i_overlay::mesh::float::style::{LineJoin, OutlineStyle};
use std::f64::consts::{PI, TAU};

/// What becomes of corners.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Join {
    /// They are rounded.
    Round,
    /// They stay corners.
    Sharp,
    /// They are cut off at the distance.
    Chamfer,
}

/// The shape whose edge is farther out by a distance; farther in, for one below zero. `None` if that isn't
/// modelled: chamfers of polygons that aren't convex.
#[must_use]
pub fn offset(shape: &Flat, by: f64, join: Join) -> Option<Flat> {
    match shape {
        Flat::Empty => Some(Flat::Empty),
        Flat::Disc(disc) => {
            let radius = disc.radius + by;
            Some(if radius > 0.0 { Flat::Disc(Disc { radius, ..*disc }) } else { Flat::Empty })
        }
        // Rounded, a union grows as its members do.
        Flat::Union(shapes) if by > 0.0 && join == Join::Round => {
            let grown: Option<Vec<_>> =
                shapes.iter().map(|shape| offset(shape, by, join)).collect();
            grown.map(Flat::union)
        }
        _ => offset_polygon(&shape.resolved(), by, join),
    }
}

fn offset_polygon(polygon: &Polygon, by: f64, join: Join) -> Option<Flat> {
    if let Some(corners) = polygon.convex()
        && by > 0.0
    {
        return Some(match join {
            Join::Round => {
                let discs: Vec<_> =
                    corners.into_iter().map(|center| Disc { center, radius: by }).collect();
                hull_of_discs(&discs)
            }
            Join::Sharp => Flat::Polygon(Polygon::of_outline(grown(&corners, by, false))),
            Join::Chamfer => Flat::Polygon(Polygon::of_outline(grown(&corners, by, true))),
        });
    }
    let join = match join {
        Join::Round => LineJoin::Round(TAU / SIDES as f64),
        Join::Sharp => LineJoin::Miter(0.0),
        Join::Chamfer => return None,
    };
    let style = OutlineStyle::new(by).line_join(join).miter_min_turn(0.0);
    let parts = polygon.parts().to_vec().outline_as::<i64>(&style);
    Some(if parts.is_empty() { Flat::Empty } else { Flat::Polygon(Polygon::of_parts(parts)) })
}

/// A convex polygon with its edges moved outwards. A corner that turns by θ stays a corner, or becomes an edge that
/// touches the circle around the old one: both ends are tan(θ/4) times the distance past it.
fn grown(corners: &[Point], by: f64, chamfer: bool) -> Vec<Point> {
    let count = corners.len();
    let along = |i: usize| {
        let [a, b] = [corners[i % count], corners[(i + 1) % count]];
        let [x, y] = [b[0] - a[0], b[1] - a[1]];
        let length = x.hypot(y);
        [x / length, y / length]
    };
    let mut outline = Vec::new();
    for (i, corner) in corners.iter().enumerate() {
        let [before, after] = [along(i + count - 1), along(i)];
        let turn = (before[0] * after[1] - before[1] * after[0])
            .atan2(before[0] * after[0] + before[1] * after[1])
            .clamp(0.0, PI * 0.999);
        let past = by * if chamfer { (turn / 4.0).tan() } else { (turn / 2.0).tan() };
        let moved = |[x, y]: Point, past: f64| {
            [corner[0] + by * y + past * x, corner[1] - by * x + past * y]
        };
        outline.push(moved(before, past));
        if chamfer {
            outline.push(moved(after, -past));
        }
    }
    outline
}

#[cfg(test)]
mod tests {
    use super::{Join, offset};
    use crate::flat::{Flat, Polygon};

    fn size(shape: Option<Flat>) -> [f64; 2] {
        let [low, high] = shape.and_then(|shape| shape.bounds()).unwrap_or_default();
        [high[0] - low[0], high[1] - low[1]]
    }

    #[test]
    fn edges_move_by_the_distance() {
        let square = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let ell = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]];
        for outline in [square, ell] {
            let shape = Flat::Polygon(Polygon::of_outline(outline));
            for join in [Join::Round, Join::Sharp] {
                for by in [0.5, -0.5] {
                    let got = size(offset(&shape, by, join));
                    assert!(got.iter().all(|side| (side - 4.0 - 2.0 * by).abs() < 1e-6), "{got:?}");
                }
            }
            assert!(matches!(offset(&shape, -3.0, Join::Round), Some(Flat::Empty)));
        }
    }

    #[test]
    fn chamfers_touch_the_circle() {
        let square = Polygon::of_outline(vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let grown = offset(&Flat::Polygon(square), 1.0, Join::Chamfer);
        let corners =
            grown.map(|shape| shape.resolved().points().collect::<Vec<_>>()).unwrap_or_default();
        assert_eq!(corners.len(), 8);
        // How far out the farthest edges are towards a corner of the square.
        let reach = corners.iter().map(|[x, y]| (x + y - 8.0) / 2f64.sqrt()).fold(0.0, f64::max);
        assert!((reach - 1.0).abs() < 1e-12, "{reach}");
    }
}
