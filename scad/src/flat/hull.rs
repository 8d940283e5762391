//! The convex hull of discs.

use super::{Flat, Polygon};
use crate::map::Point;
use std::f64::consts::TAU;

/// A disc, or a point: a disc of radius 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Its middle.
    pub center: Point,
    /// Its radius.
    pub radius: f64,
}

impl Disc {
    /// A point.
    #[must_use]
    pub fn point(center: Point) -> Self {
        Self { center, radius: 0.0 }
    }

    /// The regular polygon inscribed in it, with the first corner towards +x.
    #[must_use]
    pub fn outline(&self, sides: usize) -> Vec<Point> {
        (0..sides).map(|side| self.towards(TAU * side as f64 / sides as f64)).collect()
    }

    /// The point of its edge in a direction.
    fn towards(&self, angle: f64) -> Point {
        let (sin, cos) = angle.sin_cos();
        [self.center[0] + self.radius * cos, self.center[1] + self.radius * sin]
    }
}

/// The convex hull of discs: the polygon through the points where tangents touch, and the discs that have an
/// arc in the hull's outline.
///
/// The hull's normal turns once around, from disc to disc: it leaves disc i for disc j where both reach equally
/// far, (cⱼ − cᵢ)·n = rᵢ − rⱼ.
#[must_use]
pub fn hull_of_discs(discs: &[Disc]) -> Flat {
    let furthest = |a: &&Disc, b: &&Disc| {
        let reach = |disc: &Disc| disc.center[0] + disc.radius;
        reach(a).total_cmp(&reach(b)).then(a.center[1].total_cmp(&b.center[1]))
    };
    let Some(first) = discs.iter().max_by(furthest) else { return Flat::Empty };
    let (mut current, mut angle, mut round) = (*first, 0.0f64, 0.0f64);
    let (mut corners, mut arcs) = (Vec::<Point>::new(), vec![*first]);
    for _ in 0..2 * discs.len() + 2 {
        let Some((disc, by)) = next(discs, &current, angle) else { break };
        round += by;
        if round > TAU + 1e-9 {
            break;
        }
        angle = (angle + by) % TAU;
        corners.push(current.towards(angle));
        corners.push(disc.towards(angle));
        current = disc;
        if !arcs.contains(&disc) {
            arcs.push(disc);
        }
        if round > TAU - 1e-9 {
            break;
        }
    }
    corners.dedup();
    let arcs = arcs.into_iter().filter(|disc| disc.radius > 0.0).map(Flat::Disc);
    let polygon = Polygon::of_outline(corners);
    let polygon = polygon.convex().map(|_| Flat::Polygon(polygon));
    Flat::union(polygon.into_iter().chain(arcs))
}

/// The disc that follows on the hull's outline, and by which angle the normal turns until there.
fn next(discs: &[Disc], current: &Disc, angle: f64) -> Option<(Disc, f64)> {
    let mut best: Option<(Disc, f64, f64)> = None;
    for disc in discs {
        let [x, y] = [0, 1].map(|i| disc.center[i] - current.center[i]);
        let distance = x.hypot(y);
        let slope = (current.radius - disc.radius) / distance;
        if slope.abs() >= 1.0 || slope.is_nan() {
            continue; // the same, or one is inside the other
        }
        let mut by = (y.atan2(x) - slope.acos() - angle) % TAU;
        if by < -1e-12 {
            by += TAU;
        }
        let is_better = best.is_none_or(|(_, least, far)| {
            by < least - 1e-12 || by < least + 1e-12 && distance > far
        });
        if is_better {
            best = Some((*disc, by, distance));
        }
    }
    best.map(|(disc, by, _)| (disc, by.max(0.0)))
}

#[cfg(test)]
mod tests {
    use super::{Disc, Flat, hull_of_discs};

    fn discs(hull: &Flat) -> (usize, usize) {
        let Flat::Union(members) = hull else { return (0, 0) };
        let corners = members.iter().find_map(|member| match member {
            Flat::Polygon(polygon) => polygon.convex(),
            _ => None,
        });
        let discs = members.iter().filter(|member| matches!(member, Flat::Disc(_))).count();
        (corners.map_or(0, |corners| corners.len()), discs)
    }

    #[test]
    fn hulls_have_tangents_and_arcs() {
        let disc = |x, y, radius| Disc { center: [x, y], radius };
        let corners =
            [disc(0.0, 0.0, 1.0), disc(9.0, 0.0, 1.0), disc(9.0, 5.0, 1.0), disc(0.0, 5.0, 1.0)];
        assert_eq!(discs(&hull_of_discs(&corners)), (8, 4));
        // One inside, one on an edge.
        let more = [&corners[..], &[disc(4.0, 2.0, 2.0), disc(4.0, 0.0, 1.0)]].concat();
        assert_eq!(discs(&hull_of_discs(&more)), (8, 4));
        // A large disc between two small ones has two arcs.
        let three = [disc(0.0, 0.0, 3.0), disc(9.0, 0.0, 1.0), disc(-9.0, 0.0, 1.0)];
        assert_eq!(discs(&hull_of_discs(&three)), (8, 3));
        assert!(matches!(hull_of_discs(&corners[..1]), Flat::Disc(_)));
    }

    #[test]
    fn hulls_of_points_are_polygons() {
        let points =
            [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 0.0], [1.0, 1.0], [4.0, 3.0]];
        let Flat::Polygon(hull) = hull_of_discs(&points.map(Disc::point)) else {
            return assert_eq!("a polygon", "");
        };
        assert_eq!(hull.convex().map(|corners| corners.len()), Some(4));
        assert!(hull_of_discs(&[[0.0, 0.0], [1.0, 1.0]].map(Disc::point)).is_empty());
    }
}
