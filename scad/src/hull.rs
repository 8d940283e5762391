//! The convex hull of points in space.

use crate::map::{Vector, length};
use crate::tree::Convex;
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::transformation::try_convex_hull;
use scancsg::geom::vec3;

/// How thin a hull may be, and how far a corner from its face, in terms of the hull's size.
const THIN: f64 = 1e-9;
const FLAT: f64 = 1e-7;

/// A convex hull.
#[derive(Debug, Clone, PartialEq)]
pub enum Hull {
    /// Of no points.
    Nothing,
    /// All points are the same.
    Point(Vector),
    /// All points are on a line.
    Segment([Vector; 2]),
    /// All points are in a plane: its normal, of length 1.
    Plane(Vector),
    /// A convex polyhedron.
    Solid(Box<Polyhedron>),
}

/// A convex polyhedron with its edges.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyhedron {
    /// Its planes and corners.
    pub convex: Convex,
    /// The corners of each face, by index, in no order.
    pub faces: Vec<Vec<usize>>,
    /// Between which corners the edges are.
    pub edges: Vec<[usize; 2]>,
}

/// The convex hull of points. Triangles that lie in one plane are one face. `None` if it can't be found.
#[must_use]
pub fn hull_of_points(points: &[Vector]) -> Option<Hull> {
    let Some(&first) = points.first() else { return Some(Hull::Nothing) };
    let far = |of: &dyn Fn(Vector) -> f64| {
        let farthest = points.iter().copied().max_by(|a, b| of(*a).total_cmp(&of(*b)));
        farthest.unwrap_or(first)
    };
    let second = far(&|point| length(point - first));
    let size = length(second - first);
    if size == 0.0 {
        return Some(Hull::Point(first));
    }
    let along = (second - first) * (1.0 / size);
    let beside = |point: Vector| length((point - first).cross(along));
    let third = far(&beside);
    if beside(third) < THIN * size {
        let reach = |point: Vector| (point - first).dot(along);
        let other = far(&|point| -reach(point));
        return Some(Hull::Segment([other, far(&reach)]));
    }
    let normal = along.cross(third - first).normalized()?;
    let above = |point: Vector| (point - first).dot(normal).abs();
    if above(far(&above)) < THIN * size {
        return Some(Hull::Plane(normal));
    }
    solid(points, size).map(|hull| Hull::Solid(Box::new(hull)))
}

fn solid(points: &[Vector], size: f64) -> Option<Polyhedron> {
    // Near the origin and of size 1, where the crate's tolerances are meant to be.
    let middle = points.iter().fold(vec3(0.0, 0.0, 0.0), |sum, point| sum + *point)
        * (1.0 / points.len() as f64);
    let near: Vec<ParryVector> = points
        .iter()
        .map(|point| (*point - middle) * (1.0 / size))
        .map(|point| ParryVector::new(point.x, point.y, point.z))
        .collect();
    let (corners, triangles) = try_convex_hull(&near).ok()?;
    // The given points, not what scaling makes of them.
    let given = |corner: &ParryVector| {
        let distance =
            |index: &usize| near.get(*index).map_or(f64::MAX, |p| p.distance_squared(*corner));
        let nearest = (0..near.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        points[nearest.unwrap_or(0)]
    };
    let corners: Vec<Vector> = corners.iter().map(given).collect();
    let mut triangles: Vec<([usize; 3], Vector)> = triangles
        .into_iter()
        .map(|triangle| triangle.map(|index| index as usize))
        .map(|[a, b, c]| ([a, b, c], (corners[b] - corners[a]).cross(corners[c] - corners[a])))
        .collect();
    triangles.sort_by(|a, b| length(b.1).total_cmp(&length(a.1)));
    let mut planes: Vec<(Vector, f64)> = Vec::new();
    let mut owners = Vec::new();
    for (triangle, area) in &triangles {
        let in_plane = |(normal, offset): &(Vector, f64)| {
            triangle
                .iter()
                .all(|corner| (normal.dot(corners[*corner]) - offset).abs() < FLAT * size)
        };
        let owner = planes.iter().position(in_plane).or_else(|| {
            let normal = tidy(area.normalized()?);
            let offset = corners.iter().map(|corner| normal.dot(*corner)).fold(f64::MIN, f64::max);
            planes.push((normal, offset));
            Some(planes.len() - 1)
        })?;
        owners.push(owner);
    }
    let mut sides: Vec<([usize; 2], usize)> = Vec::new();
    for (([a, b, c], _), owner) in triangles.iter().zip(&owners) {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            sides.push(([*from.min(to), *from.max(to)], *owner));
        }
    }
    sides.sort_unstable();
    let is_edge = |pair: &[([usize; 2], usize)]| matches!(pair, [(a, left), (b, right)] if a == b && left != right);
    let edges: Vec<_> =
        sides.windows(2).filter(|pair| is_edge(pair)).map(|pair| pair[0].0).collect();
    let mut faces = vec![Vec::new(); planes.len()];
    for (edge, owner) in sides.iter().filter(|(edge, _)| edges.binary_search(edge).is_ok()) {
        for corner in edge {
            if !faces[*owner].contains(corner) {
                faces[*owner].push(*corner);
            }
        }
    }
    Some(Polyhedron { convex: Convex { planes, corners }, faces, edges })
}

/// A unit vector along an axis, where it is but for rounding.
fn tidy(normal: Vector) -> Vector {
    let near = normal.map(|part| if part.abs() < 1e-12 { 0.0 } else { part });
    near.normalized().unwrap_or(normal)
}

#[cfg(test)]
mod tests {
    use super::{Hull, hull_of_points};
    use crate::map::Vector;
    use scancsg::geom::vec3;

    fn grid(count: [i32; 3]) -> Vec<Vector> {
        let [x, y, z] = count;
        let all = (0..x).flat_map(|i| (0..y).flat_map(move |j| (0..z).map(move |k| [i, j, k])));
        all.map(|at| Vector::from(at.map(f64::from))).collect()
    }

    #[test]
    fn coplanar_triangles_are_one_face() {
        let Some(Hull::Solid(hull)) = hull_of_points(&grid([4, 3, 5])) else {
            return assert_eq!("a solid", "");
        };
        assert_eq!((hull.convex.planes.len(), hull.faces.len(), hull.edges.len()), (6, 6, 12));
        assert!(hull.faces.iter().all(|face| face.len() == 4));
    }

    #[test]
    fn degenerate_hulls_say_so() {
        assert_eq!(hull_of_points(&[]), Some(Hull::Nothing));
        assert!(matches!(hull_of_points(&grid([1, 1, 1])), Some(Hull::Point(_))));
        let ends = [vec3(0.0, 0.0, 0.0), vec3(0.0, 4.0, 0.0)];
        assert_eq!(hull_of_points(&grid([1, 5, 1])), Some(Hull::Segment(ends)));
        assert!(matches!(hull_of_points(&grid([2, 5, 1])), Some(Hull::Plane(_))));
    }
}
