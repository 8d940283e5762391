//! Boxes and convex polyhedra.

use super::method::{Method, Query, dot as dot_f32, from_middle, narrow};
use super::subject::{Spans, Subject};
use scancsg::solid::{Cuboid, HalfSpace, Polyhedron};
use testkit::limits::{self, SolidLimits};
use testkit::number::{Tested, coordinates, vector};
use testkit::random::Random;
use testkit::vector::{V, along, cross, dot, sub, times, unit};

/// The points p with `normal · p ≤ offset`.
#[derive(Clone, Copy)]
struct Plane {
    normal: V,
    offset: f64,
}

/// A convex solid by its faces, with a point inside.
struct Faces<const N: usize> {
    planes: [Plane; N],
    middle: V,
}

impl<const N: usize> Faces<N> {
    /// Heights over a plane lose nothing that `f64` can't spare: what they are differences of has the 24 bits
    /// of an `f32`.
    fn spans(&self, [origin, direction]: [V; 2], growth: f64) -> Spans<f64> {
        let [mut enter, mut exit] = [f64::NEG_INFINITY, f64::INFINITY];
        for &Plane { normal, offset } in &self.planes {
            let (height, speed) = (offset - dot(normal, origin) + growth, dot(normal, direction));
            match speed {
                0.0 if height < 0.0 => return [None; 2],
                0.0 => {}
                _ if speed > 0.0 => exit = exit.min(height / speed),
                _ => enter = enter.max(height / speed),
            }
        }
        [(enter < exit).then_some([enter, exit]), None]
    }

    /// The first face ahead of a point inside, as its normal, and the point there.
    fn seen(&self, from: V, way: V) -> [V; 2] {
        let ahead = self.planes.iter().filter_map(|&Plane { normal, offset }| {
            let speed = dot(normal, way);
            (speed > 0.0).then(|| ((offset - dot(normal, from)) / speed, normal))
        });
        let first = ahead.min_by(|a, b| a.0.total_cmp(&b.0));
        first.map_or([from, way], |(t, normal)| [along(from, t, way), unit(normal)])
    }

    fn on_surface(&self, random: &mut Random) -> [V; 2] {
        self.seen(self.middle, random.direction())
    }

    /// At an edge.
    fn touch(&self, random: &mut Random) -> [V; 3] {
        let [point, normal] = self.on_surface(random);
        let within = along(point, 1e-9, sub(self.middle, point));
        let [edge, other] = self.seen(within, unit(cross(normal, random.direction())));
        let outwards = unit(along(normal, 1.0, other));
        [edge, outwards, unit(cross(outwards, random.direction()))]
    }

    fn special(&self, random: &mut Random) -> [V; 2] {
        let [point, normal] = self.on_surface(random);
        [point, unit(cross(normal, random.direction()))]
    }
}

macro_rules! by_faces {
    () => {
        fn spans(&self, ray: [V; 2], growth: f64) -> Spans<f64> {
            self.faces().spans(ray, growth * self.size())
        }

        fn on_surface(&self, random: &mut Random) -> [V; 2] {
            self.faces().on_surface(random)
        }

        fn core(&self, _: [V; 2]) -> V {
            self.faces().middle
        }

        fn touch(&self, random: &mut Random) -> [V; 3] {
            self.faces().touch(random)
        }

        fn special(&self, random: &mut Random) -> [V; 2] {
            self.faces().special(random)
        }
    };
}

/// Its corners.
#[derive(Clone, Copy)]
pub struct Block {
    low: V,
    high: V,
}

impl Block {
    fn middle(&self) -> V {
        times(along(self.low, 1.0, self.high), 0.5)
    }

    fn faces(&self) -> Faces<6> {
        let planes = std::array::from_fn(|face| {
            let (axis, is_high) = (face / 2, face % 2 == 1);
            let mut normal = [0.0; 3];
            normal[axis] = if is_high { 1.0 } else { -1.0 };
            Plane { normal, offset: if is_high { self.high[axis] } else { -self.low[axis] } }
        });
        Faces { planes, middle: self.middle() }
    }
}

impl Subject for Block {
    const NAME: &'static str = "box";
    const LIMITS: SolidLimits = limits::SOLIDS;
    type Solid<S: Tested> = Cuboid<S>;

    fn drawn(random: &mut Random) -> Self {
        let low = random.point(3.0);
        let high = low.map(|x| x + 10f64.powf(random.between(-0.7, 0.4)));
        Self { low, high }
    }

    fn rounded<S: Tested>(&self) -> Self {
        let [low, high] = [self.low, self.high].map(|v| coordinates(vector::<S>(v)));
        Self { low, high }
    }

    fn solid<S: Tested>(&self) -> Option<Cuboid<S>> {
        Cuboid::between(vector(self.low), vector(self.high)).ok()
    }

    fn peers() -> Vec<Method<Self>> {
        let numbers = |Query { solid, ray }: &Query<Self>| {
            let [origin, direction] = ray.map(narrow);
            Some(([origin, direction], [solid.low, solid.high].map(narrow)))
        };
        let parry = |Query { solid, ray }: &Query<Self>| {
            let [origin, direction] = from_middle(*ray, solid.middle());
            let half = narrow(times(sub(solid.high, solid.low), 0.5));
            let ray = parry3d::query::Ray::new(origin.into(), direction.into());
            Some((ray, parry3d::shape::Cuboid::new(half.into())))
        };
        vec![Method::textbook(numbers, slabs), Method::parry(parry)]
    }

    fn size(&self) -> f64 {
        sub(self.high, self.low).into_iter().fold(0.0, f64::max)
    }

    by_faces!();
}

/// Kay and Kajiya's slabs, with quotients by the direction computed once.
fn slabs(&([o, d], [low, high]): &([[f32; 3]; 2], [[f32; 3]; 2])) -> Spans<f32> {
    let [mut enter, mut exit] = [f32::NEG_INFINITY, f32::INFINITY];
    for axis in 0..3 {
        let inverse = 1.0 / d[axis];
        let [a, b] = [low, high].map(|side| (side[axis] - o[axis]) * inverse);
        enter = enter.max(a.min(b));
        exit = exit.min(a.max(b));
    }
    [(enter <= exit).then_some([enter, exit]), None]
}

/// How many faces a polyhedron has.
const FACES: usize = 8;

/// Half of the faces lie across coordinate axes or sums of two of them.
#[derive(Clone, Copy)]
pub struct Convex {
    /// The vectors that normals are made of.
    ways: [V; FACES],
    /// As the number type holds them.
    normals: [V; FACES],
    offsets: [f64; FACES],
    middle: V,
}

impl Convex {
    fn faces(&self) -> Faces<FACES> {
        let plane = |face: usize| Plane { normal: self.normals[face], offset: self.offsets[face] };
        Faces { planes: std::array::from_fn(plane), middle: self.middle }
    }

    /// How wide it is along the coordinate axes through its middle.
    fn width(&self) -> f64 {
        let across = |axis: usize| {
            let mut way = [0.0; 3];
            way[axis] = 1.0;
            let [span, _] = self.faces().spans([self.middle, way], 0.0);
            span.map_or(0.0, |[enter, exit]| exit - enter)
        };
        (0..3).map(across).fold(0.0, f64::max)
    }
}

impl Subject for Convex {
    const NAME: &'static str = "polyhedron";
    const LIMITS: SolidLimits = limits::SOLIDS;
    type Solid<S: Tested> = Polyhedron<S, FACES>;

    fn drawn(random: &mut Random) -> Self {
        loop {
            let middle = random.point(2.0);
            let ways: [V; FACES] = std::array::from_fn(|face| match face {
                0..4 => {
                    let mut way = [0.0; 3];
                    way[random.below(3)] = random.sign();
                    way[random.below(3)] = random.sign();
                    way
                }
                _ => random.direction(),
            });
            let normals = ways.map(unit);
            let offsets = normals.map(|n| dot(n, middle) + random.between(0.4, 1.2));
            let drawn = Self { ways, normals, offsets, middle };
            // Neither open nor a needle.
            if drawn.width() < 6.0 && drawn.solid::<f64>().is_some() {
                return drawn;
            }
        }
    }

    fn rounded<S: Tested>(&self) -> Self {
        let ways = self.ways.map(vector::<S>);
        Self {
            ways: ways.map(coordinates),
            normals: ways.map(S::rounded_axis),
            offsets: self.offsets.map(|offset| S::near(offset).to_f64()),
            ..*self
        }
    }

    fn solid<S: Tested>(&self) -> Option<Polyhedron<S, FACES>> {
        let mut faces = Vec::new();
        for (way, offset) in self.ways.into_iter().zip(self.offsets) {
            faces.push(HalfSpace::facing(vector(way), S::near(offset)).ok()?);
        }
        Polyhedron::bounded_by(faces.try_into().ok()?).ok()
    }

    fn peers() -> Vec<Method<Self>> {
        let numbers = |Query { solid, ray }: &Query<Self>| {
            let faces: FacesF32 =
                std::array::from_fn(|i| (narrow(solid.normals[i]), solid.offsets[i] as f32));
            Some((ray.map(narrow), faces))
        };
        vec![Method::textbook(numbers, clipped)]
    }

    fn size(&self) -> f64 {
        1.0
    }

    by_faces!();
}

/// Normal and offset of each face.
type FacesF32 = [([f32; 3], f32); FACES];

/// Cyrus and Beck's clipping, plane after plane.
fn clipped((line, faces): &([[f32; 3]; 2], FacesF32)) -> Spans<f32> {
    let &[origin, direction] = line;
    let [mut enter, mut exit] = [f32::NEG_INFINITY, f32::INFINITY];
    for &(normal, offset) in faces {
        let height = offset - dot_f32(normal, origin);
        let speed = dot_f32(normal, direction);
        if speed == 0.0 {
            if height < 0.0 {
                return [None; 2];
            }
        } else if speed > 0.0 {
            exit = exit.min(height / speed);
        } else {
            enter = enter.max(height / speed);
        }
    }
    [(enter <= exit).then_some([enter, exit]), None]
}
