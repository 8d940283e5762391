//! The corners of a convex polyhedron from its faces, in double precision: when it is made, also in constants.

mod error;

pub use error::PolyhedronError;

use super::direction::Axis;
use crate::scalar::{Double, Grid, normalized};

/// A face: its normal, and how far along it the plane lies.
pub(crate) type Plane = ([f64; 3], f64);

/// A checked polyhedron: its first faces, how many there are, and its lowest and highest coordinates.
pub(crate) struct Hull<const N: usize> {
    pub(crate) planes: [Plane; N],
    pub(crate) count: usize,
    pub(crate) low: [f64; 3],
    pub(crate) high: [f64; 3],
}

/// A face beyond the last one.
pub(crate) const UNUSED: Plane = ([0.0; 3], 0.0);

/// What planes have in common.
pub(crate) const fn of_planes<const N: usize>(
    planes: [Plane; N],
    count: usize,
    grid: Grid,
) -> Result<Hull<N>, PolyhedronError> {
    let (faces, _) = planes.split_at(count);
    match bounds(faces, grid) {
        Ok([low, high]) => Ok(Hull { planes, count, low, high }),
        Err(error) => Err(error),
    }
}

/// The prism over a convex polygon.
pub(crate) const fn prism<const N: usize, const M: usize>(
    axis: Axis,
    polygon: [[f64; 2]; M],
    ends: [f64; 2],
    grid: Grid,
) -> Result<Hull<N>, PolyhedronError> {
    if M < 3 {
        return Err(PolyhedronError::NotConvex);
    }
    if M + 2 > N {
        return Err(PolyhedronError::TooManyFaces);
    }
    let mut points = [[0.0; 3]; M];
    let (mut twice_area, mut i) = (0.0, 0);
    while i < M {
        let ([u, v], [next_u, next_v]) = (polygon[i], polygon[(i + 1) % M]);
        twice_area += u * next_v - v * next_u;
        points[i] = axis.placed(0.0, [u, v]);
        i += 1;
    }
    if !twice_area.is_finite() {
        return Err(PolyhedronError::NotFinite);
    }
    let mut planes = [UNUSED; N];
    let mut i = 0;
    while i < M {
        let ([u, v], [next_u, next_v]) = (polygon[i], polygon[(i + 1) % M]);
        let (du, dv) = (next_u - u, next_v - v);
        // To the right of an edge, in a polygon that runs anticlockwise.
        let outward = if twice_area < 0.0 { [-dv, du] } else { [dv, -du] };
        let edge = [points[i], points[(i + 1) % M]];
        planes[i] = match touching(axis.placed(0.0, outward), &points, &edge, grid) {
            Ok(plane) => plane,
            Err(error) => return Err(error),
        };
        i += 1;
    }
    let [low, high] = ends;
    planes[M] = (axis.placed(-1.0, [0.0; 2]), -low);
    planes[M + 1] = (axis.placed(1.0, [0.0; 2]), high);
    of_planes(planes, M + 2, grid)
}

/// The corners of each face of a frustum, in order around it: of pairs of faces across x, y and z.
const AROUND: [[usize; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// The solid between eight corners.
pub(crate) const fn frustum<const N: usize>(
    corners: [[f64; 3]; 8],
    grid: Grid,
) -> Result<Hull<N>, PolyhedronError> {
    if N < 6 {
        return Err(PolyhedronError::TooManyFaces);
    }
    let (mut sum, mut i) = ([0.0; 3], 0);
    while i < 8 {
        let ([a, b, c], [x, y, z]) = (sum, corners[i]);
        sum = [a + x, b + y, c + z];
        i += 1;
    }
    let (mut planes, mut count, mut i) = ([UNUSED; N], 0, 0);
    while i < 6 {
        let [a, b, c, d] = AROUND[i];
        let around = [corners[a], corners[b], corners[c], corners[d]];
        let normal = cross(difference(around[2], around[0]), difference(around[3], around[1]));
        // Mirrored, the corners are the other way round.
        let [x, y, z] = normal;
        let is_inwards = dot(normal, sum) > 8.0 * dot(normal, around[0]);
        let outward = if is_inwards { [-x, -y, -z] } else { normal };
        // A face may be an edge or a point: those of a wedge or of a pyramid.
        if max_abs(outward) != 0.0 {
            planes[count] = match touching(outward, &corners, &around, grid) {
                Ok(plane) => plane,
                Err(error) => return Err(error),
            };
            count += 1;
        }
        i += 1;
    }
    of_planes(planes, count, grid)
}

/// The plane that touches all points from outside, if it does so at those of a face.
const fn touching(
    outward: [f64; 3],
    points: &[[f64; 3]],
    face: &[[f64; 3]],
    grid: Grid,
) -> Result<Plane, PolyhedronError> {
    if !(outward[0] + outward[1] + outward[2]).is_finite() {
        return Err(PolyhedronError::NotFinite);
    }
    let Some([x, y, z]) = normalized(outward) else { return Err(PolyhedronError::NotConvex) };
    let normal = [grid.unit(x), grid.unit(y), grid.unit(z)];
    let [inner_x, inner_y, inner_z] = [-normal[0], -normal[1], -normal[2]];
    let (most, least) = (support(normal, points), -support([inner_x, inner_y, inner_z], face));
    // What rounding turns the normal by, and the corners, as seen over the largest distance.
    let (mut size, mut i) = (0.0f64, 0);
    while i < points.len() {
        size = size.max(max_abs(points[i]));
        i += 1;
    }
    if most - least > 4.0 * (grid.turn() * size + grid.quantum()) {
        return Err(PolyhedronError::NotConvex);
    }
    Ok((normal, grid.length(most)))
}

/// Below this, a vector product or a determinant of normals is computed in twice the precision.
const SMALL: f64 = 1e-3;

/// Below this, it is nothing but what the normals themselves are rounded by.
const PARALLEL: f64 = 1e-28;

const fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

const fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

const fn difference([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [a - x, b - y, c - z]
}

/// As [`cross`], in twice the precision.
const fn long_cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [Double<f64>; 3] {
    const fn part([a, b]: [f64; 2], [c, d]: [f64; 2]) -> Double<f64> {
        let product = Double::exactly(a).mul(Double::exactly(b));
        product.sub(Double::exactly(c).mul(Double::exactly(d)))
    }
    [part([b, z], [c, y]), part([c, x], [a, z]), part([a, y], [b, x])]
}

/// The sum of three numbers, each times another one.
const fn weighted([a, b, c]: [Double<f64>; 3], [x, y, z]: [f64; 3]) -> Double<f64> {
    let (a, b) = (a.mul(Double::exactly(x)), b.mul(Double::exactly(y)));
    a.add(b).add(c.mul(Double::exactly(z)))
}

/// How far the outermost of some points lies along a normal.
const fn support(normal: [f64; 3], points: &[[f64; 3]]) -> f64 {
    let mut most = f64::NEG_INFINITY;
    let mut i = 0;
    while i < points.len() {
        most = most.max(dot(normal, points[i]));
        i += 1;
    }
    most
}

/// The lowest and the highest coordinates of the polyhedron: every corner is where three faces meet,
/// inside of all others.
///
/// What rounding may move is added, so the box may be too large by a millionth, never too small.
const fn bounds(faces: &[Plane], grid: Grid) -> Result<[[f64; 3]; 2], PolyhedronError> {
    let mut i = 0;
    while i < faces.len() {
        let ([x, y, z], offset) = faces[i];
        if !(x + y + z + offset).is_finite() {
            return Err(PolyhedronError::NotFinite);
        }
        i += 1;
    }
    if !is_bounded(faces) {
        return Err(PolyhedronError::Unbounded);
    }
    let mut corners = Corners {
        low: [f64::INFINITY; 3],
        high: [f64::NEG_INFINITY; 3],
        sum: [0.0; 3],
        count: 0.0,
    };
    let (mut i, mut j, mut k) = (0, 1, 2);
    while i + 2 < faces.len() {
        if let Some((corner, error)) = common_point(faces, [i, j, k])
            && is_inside(faces, corner, error)
        {
            corners.add(corner);
        }
        // The next three of all faces.
        k += 1;
        if k == faces.len() {
            j += 1;
            if j + 1 == faces.len() {
                i += 1;
                j = i + 1;
            }
            k = j + 1;
        }
    }
    if corners.count == 0.0 {
        return Err(PolyhedronError::Empty);
    }
    let Corners { mut low, mut high, sum: [x, y, z], count } = corners;
    let middle = [x / count, y / count, z / count];
    if !is_inside(faces, middle, -1e-14 * (largest_offset(faces) + max_abs(middle))) {
        return Err(PolyhedronError::Empty);
    }
    let mut axis = 0;
    while axis < 3 {
        let margin = 1e-6 * low[axis].abs().max(high[axis].abs()) + 2.0 * grid.quantum();
        (low[axis], high[axis]) = (low[axis] - margin, high[axis] + margin);
        axis += 1;
    }
    if max_abs(low).max(max_abs(high)) > grid.reach() {
        return Err(PolyhedronError::TooFar);
    }
    Ok([low, high])
}

struct Corners {
    low: [f64; 3],
    high: [f64; 3],
    sum: [f64; 3],
    count: f64,
}

impl Corners {
    const fn add(&mut self, corner: [f64; 3]) {
        let mut axis = 0;
        while axis < 3 {
            self.low[axis] = self.low[axis].min(corner[axis]);
            self.high[axis] = self.high[axis].max(corner[axis]);
            self.sum[axis] += corner[axis];
            axis += 1;
        }
        self.count += 1.0;
    }
}

const fn max_abs([x, y, z]: [f64; 3]) -> f64 {
    x.abs().max(y.abs()).max(z.abs())
}

const fn largest_offset(faces: &[Plane]) -> f64 {
    let (mut largest, mut i) = (0.0f64, 0);
    while i < faces.len() {
        largest = largest.max(faces[i].1.abs());
        i += 1;
    }
    largest
}

/// Whether a point is inside of all faces, or beyond by no more than `error`.
const fn is_inside(faces: &[Plane], point: [f64; 3], error: f64) -> bool {
    let mut i = 0;
    while i < faces.len() {
        let (normal, offset) = faces[i];
        if dot(normal, point) - offset > error {
            return false;
        }
        i += 1;
    }
    true
}

/// The point that three planes have in common, and an upper bound of its distance's rounding error to any
/// plane; `None` for parallel ones.
const fn common_point(faces: &[Plane], [i, j, k]: [usize; 3]) -> Option<([f64; 3], f64)> {
    let ((n0, d0), (n1, d1), (n2, d2)) = (faces[i], faces[j], faces[k]);
    let [c0, c1, c2] = [cross(n1, n2), cross(n2, n0), cross(n0, n1)];
    let determinant = dot(n0, c0);
    if determinant.abs() < SMALL {
        return common_point_closely([(n0, d0), (n1, d1), (n2, d2)]);
    }
    let mut point = [0.0; 3];
    let mut axis = 0;
    while axis < 3 {
        point[axis] = (d0 * c0[axis] + d1 * c1[axis] + d2 * c2[axis]) / determinant;
        axis += 1;
    }
    let size = d0.abs() + d1.abs() + d2.abs() + max_abs(point);
    Some((point, 1e-14 * size / determinant.abs()))
}

/// The same for planes that are nearly parallel, in twice the precision.
const fn common_point_closely(
    [(n0, d0), (n1, d1), (n2, d2)]: [Plane; 3],
) -> Option<([f64; 3], f64)> {
    let [c0, c1, c2] = [long_cross(n1, n2), long_cross(n2, n0), long_cross(n0, n1)];
    let determinant = weighted(c0, n0);
    if determinant.high.abs() < PARALLEL {
        return None;
    }
    let mut point = [0.0; 3];
    let mut axis = 0;
    while axis < 3 {
        let sum = weighted([c0[axis], c1[axis], c2[axis]], [d0, d1, d2]);
        point[axis] = sum.div(determinant).high;
        axis += 1;
    }
    let size = d0.abs() + d1.abs() + d2.abs() + max_abs(point);
    Some((point, 1e-15 * size + 1e-29 * size / determinant.high.abs()))
}

/// Whether no way leads out of all faces: if there is one, there is one along two of them.
const fn is_bounded(faces: &[Plane]) -> bool {
    let (mut i, mut j) = (0, 1);
    let mut is_across = false;
    while i + 1 < faces.len() {
        let [x, y, z] = long_cross(faces[i].0, faces[j].0);
        let [x, y, z] = [x.high, y.high, z.high];
        let length = max_abs([x, y, z]);
        if length > 1e-15 {
            is_across = true;
            let way = [x / length, y / length, z / length];
            let back = [-way[0], -way[1], -way[2]];
            if leads_out(faces, [i, j], way) || leads_out(faces, [i, j], back) {
                return false;
            }
        }
        j += 1;
        if j == faces.len() {
            i += 1;
            j = i + 1;
        }
    }
    is_across
}

/// Whether a way along two of the faces leads out of all others.
const fn leads_out(faces: &[Plane], along: [usize; 2], way: [f64; 3]) -> bool {
    let mut i = 0;
    while i < faces.len() {
        if i != along[0] && i != along[1] && dot(faces[i].0, way) > 1e-15 {
            return false;
        }
        i += 1;
    }
    true
}
