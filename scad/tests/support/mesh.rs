//! Triangles, as OpenSCAD writes them to an STL file: their volume, and what of a picture they cover.

use scancsg_scad::map::Vector;
use scancsg_scad::picture::View;

/// A closed surface.
pub struct Mesh {
    triangles: Vec<[Vector; 3]>,
}

impl Mesh {
    /// The triangles of an STL file in text form.
    pub fn of_stl(text: &str) -> Option<Self> {
        let mut corners = Vec::new();
        for line in text.lines() {
            if let Some(rest) = line.trim().strip_prefix("vertex ") {
                let parts: Option<Vec<f64>> =
                    rest.split_whitespace().map(|part| part.parse().ok()).collect();
                corners.push(Vector::from(<[f64; 3]>::try_from(parts?).ok()?));
            }
        }
        let triangles =
            corners.chunks_exact(3).map(|three| [three[0], three[1], three[2]]).collect();
        Some(Self { triangles })
    }

    /// By the divergence theorem: a sixth of the triple products.
    pub fn volume(&self) -> f64 {
        self.triangles.iter().map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0).sum()
    }

    pub fn corners(&self) -> [Vector; 2] {
        let all = self.triangles.iter().flatten();
        let each = |pick: fn(f64, f64) -> f64| {
            let pick =
                |a: Vector, b: &Vector| Vector::new(pick(a.x, b.x), pick(a.y, b.y), pick(a.z, b.z));
            all.clone().skip(1).fold(self.triangles[0][0], pick)
        };
        [each(f64::min), each(f64::max)]
    }

    /// The pixels whose middle a triangle covers.
    pub fn silhouette(&self, view: &View, [width, height]: [u16; 2]) -> Vec<bool> {
        let [columns, rows] = [usize::from(width), usize::from(height)];
        let mut seen = vec![false; columns * rows];
        let [right, up, _] = view.angles.axes();
        let pixel = view.height / f64::from(height);
        let project = |point: Vector| {
            let from = point - view.target;
            let [x, y] = [from.dot(right) / pixel, -from.dot(up) / pixel];
            [x + f64::from(width) / 2.0 - 0.5, y + f64::from(height) / 2.0 - 0.5]
        };
        for triangle in &self.triangles {
            let mut corners = triangle.map(project);
            let edge = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| {
                (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
            };
            if edge(corners[0], corners[1], corners[2]) < 0.0 {
                corners.swap(1, 2);
            }
            let range = |i: usize, most: usize| {
                let low =
                    corners.iter().map(|corner| corner[i]).fold(f64::MAX, f64::min).ceil().max(0.0)
                        as usize;
                let high = corners.iter().map(|corner| corner[i]).fold(f64::MIN, f64::max).floor();
                low..if high < 0.0 { low } else { (high as usize + 1).min(most) }
            };
            for y in range(1, rows) {
                for x in range(0, columns) {
                    let p = [x as f64, y as f64];
                    let [a, b, c] = corners;
                    seen[y * columns + x] |=
                        edge(a, b, p) >= 0.0 && edge(b, c, p) >= 0.0 && edge(c, a, p) >= 0.0;
                }
            }
        }
        seen
    }
}
