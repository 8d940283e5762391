//! Boxes and convex polyhedra against exact fractions: whether a line meets one, and where.
//!
//! A face is the plane that the type under test holds, with its rounded normal, so nothing is rounded but what
//! the crate rounds. In floating point, the class of a line is clear if the solid with all faces moved out by
//! 10⁻⁶ of its size has the same, and with all faces moved in as well. One exception is counted: a line that
//! cuts off an edge for a few units in the last place of t may miss it. In fixed point, every class must be
//! right; only a line along a face's plane is left out.

use dashu_int::IBig;
use scancsg::geom::Ray;
use scancsg::scalar::I16F16;
use scancsg::solid::{Cuboid, HalfSpace, Polyhedron, RayCast, Solid};
use scancsg::span::SpanList;
use testkit::cone_oracle::{is_ahead, to_f64};
use testkit::limits;
use testkit::number::{Tested, coordinates, vector};
use testkit::oracle::whole;
use testkit::random::Random;
use testkit::surd::Surd;
use testkit::ulp::percentiles;
use testkit::vector::{V, along, cross, dot, sub, times, unit};

/// Rays of a kind: 10⁵ of them with `--ignored`.
const FEW: usize = 1000;
const MANY: usize = 100_000;

/// By how much of its size a solid is grown and shrunk.
const GROWTH: f64 = 1e-6;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Ordinary,
    /// From 10³ to 10⁶ units away; in fixed point, from as far as its numbers reach.
    Far,
    /// Past an edge by 10⁻¹ to 10⁻⁶ of the size, inside or outside.
    Grazing,
    /// 10⁻¹ to 10⁻⁷ rad off a face, and as near to it.
    AlongFace,
    FromInside,
    FromSurface,
}

use Kind::{AlongFace, Far, FromInside, FromSurface, Grazing, Ordinary};

const KINDS: [Kind; 6] = [Ordinary, Far, Grazing, AlongFace, FromInside, FromSurface];

/// The points p with `normal · p ≤ offset`, by the numbers that a face has.
#[derive(Debug, Clone, Copy)]
struct Plane {
    normal: V,
    offset: f64,
}

/// A solid, its faces in order, and a point inside.
struct Subject<T> {
    solid: T,
    faces: Vec<Plane>,
    middle: V,
    size: f64,
}

trait Drawn<S: Tested>: Solid<Scalar = S> + Sized {
    fn drawn(random: &mut Random) -> Option<Subject<Self>>;
}

impl<S: Tested> Drawn<S> for Cuboid<S> {
    fn drawn(random: &mut Random) -> Option<Subject<Self>> {
        let low = vector::<S>(random.point(3.0));
        let size = [(); 3].map(|()| 10f64.powf(random.between(-1.0, 1.0)));
        let high = low + vector::<S>(size);
        let solid = Self::between(low, high).ok()?;
        let [low, high] = solid.corners().map(coordinates);
        let mut faces = Vec::new();
        for axis in 0..3 {
            let mut normal = [0.0; 3];
            normal[axis] = -1.0;
            faces.push(Plane { normal, offset: -low[axis] });
            normal[axis] = 1.0;
            faces.push(Plane { normal, offset: high[axis] });
        }
        let middle = times(along(low, 1.0, high), 0.5);
        Some(Subject { solid, faces, middle, size: size.into_iter().fold(0.0, f64::max) })
    }
}

/// Faces across coordinate axes, across sums of them, and in any direction.
impl<S: Tested> Drawn<S> for Polyhedron<S, 8> {
    fn drawn(random: &mut Random) -> Option<Subject<Self>> {
        let middle = random.point(2.0);
        let mut faces = Vec::new();
        let half_spaces = [(); 8].map(|()| {
            let way = match random.below(3) {
                0 => {
                    let mut axis = [0.0; 3];
                    axis[random.below(3)] = random.sign();
                    axis
                }
                1 => [(); 3].map(|()| random.below(5) as f64 - 2.0),
                _ => random.direction(),
            };
            let way = vector::<S>(if way == [0.0; 3] { [1.0, 2.0, 2.0] } else { way });
            let normal = S::rounded_axis(way);
            let offset = S::near(dot(normal, middle) + random.between(0.3, 1.5));
            faces.push(Plane { normal, offset: offset.to_f64() });
            HalfSpace::facing(way, offset).unwrap()
        });
        let solid = Self::bounded_by(half_spaces).ok()?;
        // A needle may end far away.
        let is_small = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].iter().all(|way| {
            let line = span(&faces, [middle, *way], 0.0);
            line.is_some_and(|[enter, exit]| to_f64(&exit) - to_f64(&enter) < 8.0)
        });
        is_small.then_some(Subject { solid, faces, middle, size: 1.0 })
    }
}

/// Where a line crosses a plane that is moved out by `growth`, and whether it exits there; or, of a line along
/// the plane, whether it is behind it, or `None` in it.
enum Meeting {
    Along(Option<bool>),
    At(Surd, bool),
}

fn meeting(face: &Plane, [origin, direction]: [V; 2], growth: f64) -> Meeting {
    let ([a, b, c], [x, y, z], [u, v, w]) = (face.normal, origin, direction);
    let ([a, b, c, x, y, z, u, v, w, offset, growth], unit) =
        whole([a, b, c, x, y, z, u, v, w, face.offset, growth]);
    // Products are in units of a square.
    let height = ((offset + growth) << -unit as usize) - (&a * x + &b * y + &c * z);
    let speed = a * u + b * v + c * w;
    if speed == IBig::ZERO {
        Meeting::Along((height != IBig::ZERO).then_some(height > IBig::ZERO))
    } else {
        let exits = speed > IBig::ZERO;
        Meeting::At(Surd::ratio(height, speed), exits)
    }
}

/// The part of a line behind all faces, moved out by `growth`; `None` if it has no length.
fn span(faces: &[Plane], line: [V; 2], growth: f64) -> Option<[Surd; 2]> {
    let [mut enter, mut exit] = [None::<Surd>, None::<Surd>];
    for face in faces {
        match meeting(face, line, growth) {
            Meeting::Along(Some(true)) => {}
            Meeting::Along(_) => return None,
            Meeting::At(at, true) => {
                if exit.as_ref().is_none_or(|exit| at.order(exit).is_lt()) {
                    exit = Some(at);
                }
            }
            Meeting::At(at, false) => {
                if enter.as_ref().is_none_or(|enter| at.order(enter).is_gt()) {
                    enter = Some(at);
                }
            }
        }
    }
    let (enter, exit) = (enter?, exit?);
    enter.order(&exit).is_lt().then_some([enter, exit])
}

impl<T> Subject<T> {
    /// The first face behind a point inside, and the point there.
    fn seen(&self, from: V, way: V) -> (usize, V) {
        let ahead = self.faces.iter().enumerate().filter_map(|(index, face)| {
            let speed = dot(face.normal, way);
            (speed > 0.0).then(|| ((face.offset - dot(face.normal, from)) / speed, index))
        });
        let (t, index) = ahead.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        (index, along(from, t, way))
    }

    /// A point of the surface and the normal there.
    fn on_face(&self, random: &mut Random) -> [V; 2] {
        let (index, point) = self.seen(self.middle, random.direction());
        [point, unit(self.faces[index].normal)]
    }

    /// A point of an edge, and the way from it that halves the angle outside.
    fn on_edge(&self, random: &mut Random) -> [V; 2] {
        let [point, normal] = self.on_face(random);
        let inside = along(point, 1e-9 * self.size, sub(self.middle, point));
        let (other, edge) = self.seen(inside, unit(cross(normal, random.direction())));
        [edge, unit(along(normal, 1.0, unit(self.faces[other].normal)))]
    }

    fn inside(&self, random: &mut Random) -> V {
        let [point, _] = self.on_face(random);
        along(self.middle, random.between(0.0, 1.0), sub(point, self.middle))
    }

    fn ray(&self, kind: Kind, is_fixed: bool, random: &mut Random) -> [V; 2] {
        let size = self.size;
        let little = |random: &mut Random| 10f64.powf(random.between(-7.0, -1.0)) * random.sign();
        let back = |random: &mut Random, point: V, way: V| {
            [along(point, -random.between(2.0, 20.0), way), way]
        };
        match kind {
            Ordinary | Far => {
                let target = along(self.inside(random), 0.5 * size, random.point(1.0));
                let [low, high] = match kind {
                    Ordinary => [0.3, 1.3],
                    _ if is_fixed => [2.0, 3.5],
                    _ => [3.0, 6.0],
                };
                let way = random.direction();
                [along(target, -10f64.powf(random.between(low, high)), way), way]
            }
            Grazing => {
                let [edge, outwards] = self.on_edge(random);
                let past = 10f64.powf(random.between(-6.0, -1.0)) * random.sign() * size;
                let way = unit(cross(outwards, random.direction()));
                back(random, along(edge, past, outwards), way)
            }
            AlongFace => {
                let [point, normal] = self.on_face(random);
                let flat = unit(cross(normal, random.direction()));
                let way = along(flat, little(random), normal);
                let beside = along(point, little(random) * size, normal);
                back(random, beside, way)
            }
            FromInside => [self.inside(random), random.direction()],
            FromSurface => [self.on_face(random)[0], random.direction()],
        }
    }
}

/// What is wrong, and how far ends are off.
#[derive(Default)]
struct Found {
    clear: [usize; 2],
    wrong: Vec<String>,
    /// In units in the last place, or of the grid.
    off: Vec<f64>,
    /// The same, of spans of less than a unit of the grid: these are made a unit long.
    short: Vec<f64>,
    /// Clear spans that were missed in floating point, all of them shorter than two parameters' errors.
    missed: usize,
}

/// The unit in the last place of a parameter, but not of one below 10⁻³; or that of the grid.
fn unit_of<S: Tested>(t: f64) -> f64 {
    if S::IS_FIXED { S::UNIT } else { t.abs().max(1e-3).log2().floor().exp2() * S::UNIT }
}

fn found<S: Tested, T: Drawn<S>>(kind: Kind, count: usize) -> Found {
    let mut random = Random::named(&format!("planes {kind:?}"));
    let mut found = Found::default();
    while found.clear[0] + found.clear[1] < count {
        let Some(subject) = T::drawn(&mut random) else { continue };
        // A few rays each: a polyhedron's corners take longer to find.
        for _ in 0..10 {
            let [origin, direction] = subject.ray(kind, S::IS_FIXED, &mut random).map(vector::<S>);
            if let Ok(ray) = Ray::new(origin, direction) {
                found.cast(&subject, &ray, [origin, direction].map(coordinates));
            }
        }
    }
    found
}

impl Found {
    fn cast<S: Tested, T: Solid<Scalar = S>>(
        &mut self,
        Subject { solid, faces, size, .. }: &Subject<T>,
        ray: &Ray<S>,
        line: [V; 2],
    ) {
        let by = if S::IS_FIXED { 0.0 } else { GROWTH * size };
        let [grown, exact, shrunk] = [by, 0.0, -by].map(|growth| span(faces, line, growth));
        if faces.iter().any(|face| matches!(meeting(face, line, 0.0), Meeting::Along(None))) {
            return;
        }
        let got = solid.trace(ray, &mut SpanList::<S, 1>::new()).first().copied();
        let hit = solid.hit(ray, &mut SpanList::<S, 1>::new());
        let want = exact.as_ref().map(|ends| ends.each_ref().map(to_f64));
        let report = || format!("{faces:?} {line:?}: {got:?}, {hit:?}, not {want:?}");

        if grown.is_some() == shrunk.is_some() {
            self.clear[usize::from(grown.is_some())] += 1;
            let is_hit =
                |ends: &Option<[Surd; 2]>| ends.as_ref().is_some_and(|[_, exit]| is_ahead(exit));
            // On a grid, what ends just behind the start may end in it, or end before it.
            let ends_at_start = want.is_some_and(|[_, exit]| exit.abs() <= S::UNIT);
            let is_clear = is_hit(&grown) == is_hit(&shrunk) && !(S::IS_FIXED && ends_at_start);
            // Of a line that is counted from its start: parameters of others are known better.
            let is_unresolved = |[enter, exit]: [f64; 2]| {
                let errors = 2.0 * limits::SHARP_P99 * unit_of::<S>(exit);
                !S::IS_FIXED && ray.start() == S::ZERO && exit - enter < errors
            };
            if got.is_none() && hit.is_none() && want.is_some_and(is_unresolved) {
                self.missed += 1;
                return;
            }
            if got.is_some() != grown.is_some() || is_clear && hit.is_some() != is_hit(&grown) {
                self.wrong.push(report());
                return;
            }
        }
        if let (Some(got), Some(want), Some(_)) = (got, want, shrunk) {
            let is_short = S::IS_FIXED && want[1] - want[0] < S::UNIT;
            let errors = if is_short { &mut self.short } else { &mut self.off };
            for (t, want) in [got.enter.t, got.exit.t].into_iter().zip(want) {
                errors.push((t.to_f64() - want).abs() / unit_of::<S>(want));
            }
        }
        if let Some(hit) = hit {
            let Plane { normal, offset } = faces[usize::from(hit.face.0)];
            let [point, seen] = [hit.point, hit.normal].map(coordinates);
            let outwards = if hit.inside { -1.0 } else { 1.0 };
            let reach = 1.0 + point.into_iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            let is_off = (dot(normal, point) - offset).abs() > 4.0 * S::UNIT * reach;
            let is_other = dot(seen, normal) * outwards < 1.0 - 4.0 * S::UNIT;
            if is_off || is_other {
                self.wrong.push(format!("not on face {}: {}", hit.face.0, report()));
            }
        }
    }
}

fn check<S: Tested, T: Drawn<S>>(count: usize) {
    for kind in KINDS {
        let Found { clear, wrong, off, short, missed } = found::<S, T>(kind, count);
        let [half, p99, largest] = percentiles(&off).unwrap();
        let [.., of_short] = percentiles(&short).unwrap_or_default();
        println!(
            "{:11} {clear:?} missed and hit, {} wrong, off {half:.2} {p99:.2} {largest:.2}; \
             {} short, {of_short:.2}; {missed} missed",
            format!("{kind:?}"),
            wrong.len(),
            short.len() / 2,
        );
        assert!(
            wrong.is_empty(),
            "{kind:?}: {}\n{}",
            wrong.len(),
            wrong[..wrong.len().min(3)].join("\n")
        );
        // 7 of 200,000 grazing rays were.
        assert!(missed <= 2 + count / 5000, "{kind:?}: {missed} missed");
        let is_near = if S::IS_FIXED {
            largest <= limits::SPANS.fixed + limits::WANTED && of_short <= limits::FIXED_MAX
        } else {
            p99 <= limits::SHARP_P99
        };
        assert!(is_near, "{kind:?}: {p99} {largest} {of_short}");
        assert!(clear[1] * 5 > count, "{kind:?}: {clear:?}");
    }
}

macro_rules! solids {
    ($($name:ident $S:ty, $count:expr, $($attribute:meta)?;)+) => {$(
        mod $name {
            use super::*;

            #[test]
            $(#[$attribute])?
            fn boxes() {
                check::<$S, Cuboid<$S>>($count);
            }

            #[test]
            $(#[$attribute])?
            fn polyhedra() {
                check::<$S, Polyhedron<$S, 8>>($count);
            }
        }
    )+};
}

solids! {
    f32s f32, FEW, ;
    f64s f64, FEW, ;
    i16f16s I16F16, FEW, ;
    many_f32s f32, MANY, ignore = "minutes";
    many_i16f16s I16F16, MANY, ignore = "minutes";
}

#[test]
fn lines_by_hand() {
    let face = |normal, offset| Plane { normal, offset };
    let wedge = [
        face([-1.0, 0.0, 0.0], 0.0),
        face([0.0, -1.0, 0.0], 0.0),
        face([1.0, 1.0, 0.0], 1.0),
        face([0.0, 0.0, -1.0], 0.0),
        face([0.0, 0.0, 1.0], 1.0),
    ];
    let ends = |line, growth| span(&wedge, line, growth).map(|ends| ends.map(|end| to_f64(&end)));
    let across = [[-1.0, 0.25, 0.5], [2.0, 0.0, 0.0]];
    assert_eq!(ends(across, 0.0), Some([0.5, 0.875]));
    assert_eq!(ends(across, 0.5), Some([0.25, 1.125]));
    assert_eq!(ends(across, -0.25), None);
    assert_eq!(ends([[-1.0, 0.0, 0.5], [1.0, 0.0, 0.0]], 0.0), None);
}
