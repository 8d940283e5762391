//! Ellipsoids: spheres that are scaled, turned and sheared.

use super::method::{Method, Query, dot as dot_f32, narrow};
use super::subject::{Spans, Subject};
use scancsg::geom::AffineMap;
use scancsg::solid::{Scaled, Sphere};
use testkit::limits::{self, SolidLimits};
use testkit::number::{Tested, coordinates, vector};
use testkit::random::Random;
use testkit::vector::{V, add, along, cross, dot, length, sub, times, unit};

#[derive(Clone, Copy)]
pub struct Ellipsoid {
    columns: [V; 3],
    middle: V,
    /// Of the sphere in its own frame.
    radius: f64,
}

/// In fixed point, a sphere is made larger than it shall be: then its own frame has more digits.
const FIXED_RADIUS: f64 = 16.0;

impl Ellipsoid {
    /// A vector of the own frame, in which the sphere has the radius 1, in the scene.
    fn way(&self, own: V) -> V {
        let [x, y, z] = self.columns.map(|column| times(column, self.radius));
        add(add(times(x, own[0]), times(y, own[1])), times(z, own[2]))
    }

    /// The rows of the inverse matrix.
    fn inverse(&self) -> [V; 3] {
        let [x, y, z] = self.columns;
        let rows = [cross(y, z), cross(z, x), cross(x, y)];
        let volume = dot(x, rows[0]);
        rows.map(|row| row.map(|entry| entry / volume))
    }
}

impl Subject for Ellipsoid {
    const NAME: &'static str = "ellipsoid";
    const LIMITS: SolidLimits = limits::SOLIDS;
    /// The ray is rounded to the own frame's grid.
    const FIXED_GROWTH: f64 = 1e-4;
    type Solid<S: Tested> = Scaled<Sphere<S>>;

    /// Semi-axes from 1/2 to 2, in any direction; a third of them mirrored.
    fn drawn(random: &mut Random) -> Self {
        let mut frame = || {
            let x = random.direction();
            let y = unit(cross(x, random.direction()));
            [x, y, cross(x, y)]
        };
        let (outer, inner) = (frame(), frame());
        let mut scale = [(); 3].map(|()| 2f64.powf(random.between(-1.0, 1.0)));
        if random.chance(0.3) {
            scale[0] = -scale[0];
        }
        let column =
            |j: usize| (0..3).fold([0.0; 3], |sum, k| along(sum, scale[k] * inner[k][j], outer[k]));
        Self { columns: std::array::from_fn(column), middle: random.point(3.0), radius: 1.0 }
    }

    fn rounded<S: Tested>(&self) -> Self {
        let held = |v: V| coordinates(vector::<S>(v));
        let radius = if S::IS_FIXED { FIXED_RADIUS } else { self.radius };
        let columns = self.columns.map(|column| held(times(column, self.radius / radius)));
        Self { columns, middle: held(self.middle), radius }
    }

    fn solid<S: Tested>(&self) -> Option<Scaled<Sphere<S>>> {
        let sphere = Sphere::around(vector([0.0; 3]), S::near(self.radius)).ok()?;
        let map = AffineMap::with_columns(self.columns.map(vector), vector(self.middle)).ok()?;
        Some(Scaled::new(sphere, map))
    }

    fn spans(&self, [origin, direction]: [V; 2], growth: f64) -> Spans<f64> {
        let rows = self.inverse();
        let own = |v: V| rows.map(|row| dot(row, v));
        let (start, d) = (own(sub(origin, self.middle)), own(direction));
        let shift = -dot(start, d) / dot(d, d);
        let p = along(start, shift, d);
        let radius = self.radius * (1.0 + growth);
        // Counted from the point nearest to the middle, where |p|² nearly is the distance of the line.
        let (a, b, c) = (dot(d, d), dot(p, d), dot(p, p) - radius * radius);
        let discriminant = b * b - a * c;
        let root = (discriminant > 0.0).then(|| discriminant.sqrt());
        [root.map(|root| [(-b - root) / a + shift, (-b + root) / a + shift]), None]
    }

    fn peers() -> Vec<Method<Self>> {
        let numbers = |Query { solid, ray }: &Query<Self>| {
            let rows = solid.inverse().map(narrow);
            let radius = solid.radius as f32;
            Some((ray.map(narrow), rows, [narrow(solid.middle), [radius; 3]]))
        };
        vec![Method::textbook(numbers, textbook)]
    }

    fn size(&self) -> f64 {
        1.0
    }

    fn on_surface(&self, random: &mut Random) -> [V; 2] {
        let own = random.direction();
        let rows = self.inverse();
        let normal = (0..3).fold([0.0; 3], |sum, i| along(sum, own[i], rows[i]));
        [add(self.middle, self.way(own)), unit(normal)]
    }

    fn core(&self, _: [V; 2]) -> V {
        self.middle
    }

    /// Along the longest of three axes that are conjugate.
    fn special(&self, random: &mut Random) -> [V; 2] {
        let [point, _] = self.on_surface(random);
        let longest = self.columns.into_iter().max_by(|a, b| length(*a).total_cmp(&length(*b)));
        [point, unit(longest.unwrap_or(point))]
    }
}

type Numbers = ([[f32; 3]; 2], [[f32; 3]; 3], [[f32; 3]; 2]);

/// The ray in the sphere's frame, and b² − 4ac.
fn textbook(&([origin, direction], rows, [middle, [radius, ..]]): &Numbers) -> Spans<f32> {
    let from_middle: [f32; 3] = std::array::from_fn(|i| origin[i] - middle[i]);
    let o = rows.map(|row| dot_f32(row, from_middle));
    let d = rows.map(|row| dot_f32(row, direction));
    let a = dot_f32(d, d);
    let b = 2.0 * dot_f32(o, d);
    let c = dot_f32(o, o) - radius * radius;
    let discriminant = b * b - 4.0 * a * c;
    let root = (discriminant >= 0.0).then(|| discriminant.sqrt());
    [root.map(|root| [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]), None]
}
