//! Tori with an axis in any direction.

use super::method::{Method, Query, dot as dot_f32, from_middle, narrow};
use super::quartic;
use super::subject::{Spans, Subject};
use testkit::limits::{self, SolidLimits};
use testkit::number::{Tested, coordinates, vector};
use testkit::random::Random;
use testkit::vector::{V, add, along, cross, dot, length, sub, times, unit};

#[derive(Clone, Copy)]
pub struct Torus {
    middle: V,
    /// The vector that the axis is made of.
    way: V,
    /// As the number type holds it.
    axis: V,
    ring: f64,
    tube: f64,
}

impl Torus {
    /// For the exact oracle.
    pub fn model(&self) -> testkit::quartic::Torus {
        let Self { middle: center, axis, ring, tube, .. } = *self;
        testkit::quartic::Torus { center, axis, ring, tube }
    }
}

impl Subject for Torus {
    const NAME: &'static str = "torus";
    const LIMITS: SolidLimits = limits::TORI;
    type Solid<S: Tested> = scancsg::solid::Torus<S>;

    fn drawn(random: &mut Random) -> Self {
        let way = if random.chance(0.5) {
            random.direction()
        } else {
            let mut way = [0.0; 3];
            way[random.below(3)] = random.sign();
            way
        };
        let ring = random.between(0.5, 2.0);
        let tube = ring * random.between(0.1, 0.9);
        Self { middle: random.point(3.0), way, axis: way, ring, tube }
    }

    fn rounded<S: Tested>(&self) -> Self {
        let held = |x: f64| S::near(x).to_f64();
        let way = vector::<S>(self.way);
        Self {
            middle: self.middle.map(held),
            way: coordinates(way),
            axis: S::rounded_axis(way),
            ring: held(self.ring),
            tube: held(self.tube),
        }
    }

    fn solid<S: Tested>(&self) -> Option<Self::Solid<S>> {
        S::torus(vector(self.middle), vector(self.way), [self.ring, self.tube].map(S::near)).ok()
    }

    /// With P = p + t·d and n = |P|² + R² − r², a point is inside where |A|²n² < 4R²(|A|²|P|² − (A·P)²).
    fn spans(&self, [origin, direction]: [V; 2], growth: f64) -> Spans<f64> {
        let (start, speed) = (sub(origin, self.middle), length(direction));
        let d = unit(direction);
        let shift = -dot(start, d);
        let p = along(start, shift, d);
        let (ring, tube) = (self.ring, self.tube * (1.0 + growth));
        let square = [dot(p, p), 2.0 * dot(p, d), dot(d, d)];
        let n = [square[0] + (ring + tube) * (ring - tube), square[1], square[2]];
        let height = [dot(self.axis, p), dot(self.axis, d)];
        let axis = dot(self.axis, self.axis);
        let along_axis =
            [height[0] * height[0], 2.0 * height[0] * height[1], height[1] * height[1]];
        let mut f = [0.0; 5];
        for i in 0..3 {
            for j in 0..3 {
                f[i + j] += axis * n[i] * n[j];
            }
            f[i] -= 4.0 * ring * ring * (axis * square[i] - along_axis[i]);
        }
        let reach = 1.1 * (ring + tube);
        let roots = quartic::bracketed(&f, [-reach, reach]);
        let at = |i: usize| roots.get(i).map(|root| (root + shift) / speed);
        [0, 2].map(|i| at(i).zip(at(i + 1)).map(|(enter, exit)| [enter, exit]))
    }

    fn peers() -> Vec<Method<Self>> {
        let numbers = |Query { solid, ray }: &Query<Self>| {
            let radii = [solid.ring, solid.tube].map(|r| r as f32);
            Some((from_middle(*ray, solid.middle), narrow(solid.axis), radii))
        };
        vec![Method::textbook(numbers, textbook)]
    }

    fn size(&self) -> f64 {
        self.ring
    }

    fn on_surface(&self, random: &mut Random) -> [V; 2] {
        let first = unit(cross(self.axis, random.direction()));
        let [_, cos, sin] = random.across();
        let normal = add(times(first, cos), times(self.axis, sin));
        [along(along(self.middle, self.ring, first), self.tube, normal), normal]
    }

    fn core(&self, [point, normal]: [V; 2]) -> V {
        along(point, -self.tube, normal)
    }

    /// Along the axis, or in a plane across it.
    fn special(&self, random: &mut Random) -> [V; 2] {
        let [point, normal] = self.on_surface(random);
        let inside = along(point, -self.tube * random.between(0.0, 1.0), normal);
        let flat = unit(cross(self.axis, random.direction()));
        [inside, if random.chance(0.5) { unit(self.axis) } else { flat }]
    }
}

/// The quartic's coefficients as they are written down, and Ferrari's solution.
fn textbook(&([o, d], axis, [ring, tube]): &([[f32; 3]; 2], [f32; 3], [f32; 2])) -> Spans<f32> {
    let (dd, od, oo) = (dot_f32(d, d), dot_f32(o, d), dot_f32(o, o));
    let (along, at) = (dot_f32(axis, d), dot_f32(axis, o));
    let n = oo + ring * ring - tube * tube;
    let four = 4.0 * ring * ring;
    let coefficients = [
        n * n - four * (oo - at * at),
        4.0 * n * od - 2.0 * four * (od - at * along),
        2.0 * dd * n + 4.0 * od * od - four * (dd - along * along),
        4.0 * dd * od,
        dd * dd,
    ];
    let (mut roots, count) = quartic::ferrari(coefficients);
    roots[..count].sort_by(f32::total_cmp);
    [0, 2].map(|i| (i + 1 < count).then(|| [roots[i], roots[i + 1]]))
}
