//! Prisms, frustums and what else has its corners in two planes.

use crate::hull::{Hull, hull_of_points};
use crate::map::{Point, Vector};
use crate::tree::{Convex, Form};
use scancsg::geom::vec3;
use std::sync::Arc;

/// The prism over a convex polygon, counter-clockwise, from one height to another: a box, where it is one.
#[must_use]
pub fn prism(polygon: &[Point], heights: [f64; 2]) -> Form {
    if let Some([low, high]) = rectangle(polygon) {
        let corner = |[x, y]: Point, z: f64| vec3(x, y, z);
        return Form::Cuboid([corner(low, heights[0]), corner(high, heights[1])]);
    }
    let mut planes: Vec<_> = edges(polygon).map(|[a, b]| wall(a, b)).collect();
    planes.push((vec3(0.0, 0.0, -1.0), -heights[0]));
    planes.push((vec3(0.0, 0.0, 1.0), heights[1]));
    let corners =
        heights.iter().flat_map(|z| polygon.iter().map(|[x, y]| vec3(*x, *y, *z))).collect();
    Form::Convex(Arc::new(Convex { planes, corners }))
}

/// The plane upright over an edge, outwards. Two polygons that share an edge get the same numbers but for the sign.
fn wall(a: Point, b: Point) -> (Vector, f64) {
    let (first, last, sign) = if a < b { (a, b, 1.0) } else { (b, a, -1.0) };
    let [x, y] = [last[0] - first[0], last[1] - first[1]];
    let length = x.hypot(y);
    let (x, y) = (x / length, y / length);
    // Of the middle, so that both ends are as near.
    let offset = y * ((first[0] + last[0]) / 2.0) - x * ((first[1] + last[1]) / 2.0);
    (vec3(sign * y, -sign * x, 0.0), sign * offset)
}

/// The edges of a polygon, each from its first corner to its last.
pub fn edges(polygon: &[Point]) -> impl Iterator<Item = [Point; 2]> + '_ {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(a, b)| [*a, *b])
}

/// The lowest and the highest corner, of a polygon that is a rectangle along the axes.
fn rectangle(polygon: &[Point]) -> Option<[Point; 2]> {
    if polygon.len() != 4 || !edges(polygon).all(|[a, b]| a[0] == b[0] || a[1] == b[1]) {
        return None;
    }
    let bound =
        |pick: fn(f64, f64) -> f64, i: usize| polygon.iter().map(|point| point[i]).reduce(pick);
    let corner = |pick| Some([bound(pick, 0)?, bound(pick, 1)?]);
    Some([corner(f64::min)?, corner(f64::max)?])
}

/// The convex hull of points, if it is a solid.
#[must_use]
pub fn convex_hull(points: &[Vector]) -> Option<Form> {
    match hull_of_points(points)? {
        Hull::Solid(hull) => Some(Form::Convex(Arc::new(hull.convex))),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{prism, wall};
    use crate::tree::Form;

    #[test]
    fn shared_edges_have_the_same_numbers() {
        let (a, b) = ([0.1, 0.7], [1.3, -0.2]);
        let ((there, to), (back, from)) = (wall(a, b), wall(b, a));
        assert_eq!((there, to), (-back, -from));
        // Outside is to the right of an edge.
        assert!(there.dot(scancsg::geom::vec3(0.0, -9.0, 0.0)) > to);
    }

    #[test]
    fn rectangles_are_boxes() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
        assert!(matches!(prism(&square, [0.0, 1.0]), Form::Cuboid(_)));
        let Form::Convex(wedge) = prism(&square[..3], [0.0, 1.0]) else {
            return assert_eq!("convex", "");
        };
        assert_eq!((wedge.planes.len(), wedge.corners.len()), (5, 6));
        let inside = |(normal, offset): &(crate::map::Vector, f64)| {
            wedge.corners.iter().all(|corner| normal.dot(*corner) <= offset + 1e-12)
        };
        assert!(wedge.planes.iter().all(inside));
    }
}
