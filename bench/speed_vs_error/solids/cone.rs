//! Cones and frustums along a coordinate axis.

use super::method::{Method, Query, from_middle};
use super::subject::{Spans, Subject};
use testkit::limits::{self, SolidLimits};
use testkit::number::Tested;
use testkit::random::Random;
use testkit::vector::{V, add, along, cross, dot, sub, times, unit};

#[derive(Clone, Copy)]
pub struct Cone {
    axis: usize,
    /// The middle of the cap at the lower end.
    from: V,
    /// The coordinate of the upper end along the axis.
    high: f64,
    radii: [f64; 2],
}

impl Cone {
    fn length(&self) -> f64 {
        self.high - self.from[self.axis]
    }

    fn way(&self) -> V {
        let mut way = [0.0; 3];
        way[self.axis] = 1.0;
        way
    }

    fn middle(&self) -> V {
        along(self.from, self.length() / 2.0, self.way())
    }

    /// With the axis as the last coordinate; the other two follow in a circle.
    fn upright(&self, mut v: V) -> V {
        v.rotate_left((self.axis + 1) % 3);
        v
    }

    /// A point of the wall, the normal, and the way along the side.
    fn on_wall(&self, random: &mut Random) -> [V; 3] {
        let [low, high] = self.radii;
        let part = random.between(0.0, 1.0);
        let across = random.across();
        let mut outwards = [0.0; 3];
        outwards[(self.axis + 1) % 3] = across[1];
        outwards[(self.axis + 2) % 3] = across[2];
        let at = along(self.from, part * self.length(), self.way());
        let side = unit(along(times(self.way(), self.length()), high - low, outwards));
        let around = cross(self.way(), outwards);
        let point = along(at, low + (high - low) * part, outwards);
        [point, cross(around, side), side]
    }

    /// For the exact oracle.
    pub fn query(&self, [origin, direction]: [V; 2]) -> testkit::cone_oracle::Query {
        let axis = times(self.way(), self.length());
        let Self { from, radii, .. } = *self;
        testkit::cone_oracle::Query { from, axis, radii, origin, direction }
    }
}

impl Subject for Cone {
    const NAME: &'static str = "cone";
    const LIMITS: SolidLimits = limits::SOLIDS;
    type Solid<S: Tested> = scancsg::solid::Cone<S>;

    fn drawn(random: &mut Random) -> Self {
        let wide = random.between(0.4, 1.5);
        let narrow = if random.chance(0.5) { 0.0 } else { wide * random.between(0.0, 1.0) };
        // Few digits, so that the length is a number of every type.
        let few = |x: f64| (x * 1024.0).round() / 1024.0;
        let axis = random.below(3);
        let mut from = random.point(3.0);
        from[axis] = few(from[axis]);
        let high = from[axis] + few(random.between(0.5, 4.0));
        let radii = if random.chance(0.5) { [wide, narrow] } else { [narrow, wide] };
        Self { axis, from, high, radii }
    }

    fn rounded<S: Tested>(&self) -> Self {
        let held = |x: f64| S::near(x).to_f64();
        let Self { axis, from, high, radii } = *self;
        Self { axis, from: from.map(held), high: held(high), radii: radii.map(held) }
    }

    fn solid<S: Tested>(&self) -> Option<Self::Solid<S>> {
        let others = (0..3).filter(|&i| i != self.axis).map(|i| S::near(self.from[i]));
        let others: Vec<S> = others.collect();
        let radii = self.radii.map(S::near);
        let ends = [self.from[self.axis], self.high].map(S::near);
        S::cone_along(self.axis, [others[0], others[1]], radii, ends[0], ends[1]).ok()
    }

    fn spans(&self, [origin, direction]: [V; 2], growth: f64) -> Spans<f64> {
        let d = self.upright(direction);
        let start = self.upright(sub(origin, self.middle()));
        let shift = -dot(start, d) / dot(d, d);
        let p = along(start, shift, d);
        // As in the exact oracle: the caps are moved out by `growth`, and the radii grow by twice as much.
        let (half, widest) = (self.length() / 2.0, self.radii[0].max(self.radii[1]));
        let [low, high] = self.radii.map(|radius| (radius + 2.0 * growth * widest).max(0.0));
        let end = half * (1.0 + 2.0 * growth);
        let rise = (high - low) / (2.0 * end);
        let radius = (low + high) / 2.0 + rise * p[2];
        let a = d[0] * d[0] + d[1] * d[1] - rise * d[2] * rise * d[2];
        let b = p[0] * d[0] + p[1] * d[1] - radius * rise * d[2];
        let c = p[0] * p[0] + p[1] * p[1] - radius * radius;
        let roots = quadratic(a, b, c);
        let caps = if d[2] == 0.0 {
            if p[2].abs() >= end {
                return [None; 2];
            }
            None
        } else {
            let far = end.copysign(d[2]);
            Some([(-far - p[2]) / d[2], (far - p[2]) / d[2]])
        };
        let ends = match (caps, roots) {
            (None, roots) => roots,
            (Some([first, last]), roots) => {
                let is_inside = |t: f64| (a * t + 2.0 * b) * t + c < 0.0;
                let mut between =
                    roots.into_iter().flatten().filter(|&root| first < root && root < last);
                let enter = if is_inside(first) { Some(first) } else { between.next() };
                let exit = if is_inside(last) { Some(last) } else { between.next_back() };
                enter.zip(exit).map(|(enter, exit)| [enter, exit])
            }
        };
        [ends.filter(|[enter, exit]| enter < exit).map(|ends| ends.map(|t| t + shift)), None]
    }

    fn peers() -> Vec<Method<Self>> {
        let numbers = |Query { solid, ray }: &Query<Self>| {
            let line = ray.map(|v| solid.upright(v));
            let [low, high] = solid.radii.map(|r| r as f32);
            Some((from_middle(line, solid.upright(solid.from)), [low, high, solid.length() as f32]))
        };
        // Its cones stand along y and have a tip at the upper end.
        let parry = |Query { solid, ray }: &Query<Self>| {
            let wide = match solid.radii {
                [wide, 0.0] | [0.0, wide] => wide as f32,
                _ => return None,
            };
            let line = ray.map(|v| solid.upright(v));
            let [o, d] = from_middle(line, solid.upright(solid.middle()));
            let up = if solid.radii[0] == 0.0 { -1.0 } else { 1.0 };
            let standing = |[x, y, z]: [f32; 3]| [x, up * z, y].into();
            let half = (solid.length() / 2.0) as f32;
            let ray = parry3d::query::Ray::new(standing(o), standing(d));
            Some((ray, parry3d::shape::Cone::new(half, wide)))
        };
        vec![Method::textbook(numbers, textbook), Method::parry(parry)]
    }

    fn size(&self) -> f64 {
        self.radii[0].max(self.radii[1])
    }

    fn on_surface(&self, random: &mut Random) -> [V; 2] {
        let [point, normal, _] = self.on_wall(random);
        [point, normal]
    }

    fn core(&self, _: [V; 2]) -> V {
        self.middle()
    }

    /// Along the side, or along the axis.
    fn special(&self, random: &mut Random) -> [V; 2] {
        let [point, _, side] = self.on_wall(random);
        if random.chance(0.5) {
            return [point, times(side, random.sign())];
        }
        let inside = along(self.middle(), random.between(0.0, 1.0), sub(point, self.middle()));
        [add(inside, random.point(0.1)), times(self.way(), random.sign())]
    }
}

/// The roots of a·t² + 2·b·t + c, in order.
fn quadratic(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let q = -(b + discriminant.sqrt().copysign(b));
    let roots = [q / a, c / q];
    let [first, last] = if roots[0] < roots[1] { roots } else { [roots[1], roots[0]] };
    Some([first, last])
}

/// b² − 4ac for the wall, and the caps' discs.
fn textbook(&([o, d], [low, high, length]): &([[f32; 3]; 2], [f32; 3])) -> Spans<f32> {
    let slope = (high - low) / length;
    let radius = low + slope * o[2];
    let a = d[0] * d[0] + d[1] * d[1] - slope * slope * d[2] * d[2];
    let b = 2.0 * (o[0] * d[0] + o[1] * d[1] - slope * radius * d[2]);
    let c = o[0] * o[0] + o[1] * o[1] - radius * radius;
    let [mut enter, mut exit] = [f32::INFINITY, f32::NEG_INFINITY];
    let mut found = |t: f32| {
        enter = enter.min(t);
        exit = exit.max(t);
    };
    let discriminant = b * b - 4.0 * a * c;
    if discriminant >= 0.0 {
        let root = discriminant.sqrt();
        for t in [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)] {
            let height = o[2] + t * d[2];
            if 0.0 <= height && height <= length {
                found(t);
            }
        }
    }
    for (height, radius) in [(0.0, low), (length, high)] {
        let t = (height - o[2]) / d[2];
        let [x, y] = [o[0] + t * d[0], o[1] + t * d[1]];
        if x * x + y * y <= radius * radius {
            found(t);
        }
    }
    [(enter < exit).then_some([enter, exit]), None]
}
