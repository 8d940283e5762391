//! The ray sets: those of `tests/reference/README.md`, in draws as large as wanted, some of them with
//! the cylinder elsewhere, and some at the ends of what 32 bits of fixed point can hold.
//!
//! All geometry is done in `f64`; a method's [`Inputs`](crate::methods::Inputs) round it once.

use testkit::query::Query;
use testkit::random::Random;
use testkit::vector::{V, along, unit};

/// A kind of rays; the table is read in these groups.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    Benign,
    BenignMoved,
    Far,
    FarMoved,
    Graze,
    GrazeMoved,
    NearParallel,
    Tiny,
    Huge,
    Inside,
    InsideMoved,
    PastOrigin,
    OnSurface,
    Rim,
    Unnormalised,
    Exact,
    Fixed,
    FixedShort,
    Invalid,
    Sphere,
    SphereInside,
    SphereGraze,
    SphereNear,
}

impl Group {
    pub const ALL: [(Self, &str); 23] = [
        (Self::Benign, "benign"),
        (Self::BenignMoved, "benign_moved"),
        (Self::Far, "far"),
        (Self::FarMoved, "far_moved"),
        (Self::Graze, "graze"),
        (Self::GrazeMoved, "graze_moved"),
        (Self::NearParallel, "nearpar"),
        (Self::Tiny, "tiny"),
        (Self::Huge, "huge"),
        (Self::Inside, "inside"),
        (Self::InsideMoved, "inside_moved"),
        (Self::PastOrigin, "past_origin"),
        (Self::OnSurface, "onsurf"),
        (Self::Rim, "capedge"),
        (Self::Unnormalised, "unnorm"),
        (Self::Exact, "exact"),
        (Self::Fixed, "fixed"),
        (Self::FixedShort, "fixed_short"),
        (Self::Invalid, "invalid"),
        (Self::Sphere, "sphere"),
        (Self::SphereInside, "sphere_in"),
        (Self::SphereGraze, "sphere_graze"),
        (Self::SphereNear, "sphere_near"),
    ];
}

/// A set's name, its group, and what draws a ray for a cylinder (r, h) that may be replaced.
pub struct Set {
    pub name: &'static str,
    pub group: Group,
    pub size: Size,
    pub draw: fn(&mut Random, r: f64, h: f64) -> [V; 2],
}

/// Radius and half length of the set's cylinders, as ranges.
#[derive(Clone, Copy)]
pub enum Size {
    Usual,
    /// As usual, but elsewhere: along any coordinate axis, and up to 4 units from the origin each way.
    Moved,
    /// As moved, but so that the line comes 256 times nearer to the scene's origin than the ray starts.
    Past,
    /// Spheres, up to 4 units from the origin each way.
    Sphere,
    Tiny,
    Huge,
    /// A few units of 2⁻¹⁶ thick.
    Units,
    /// Up to 4096, and one half of them exactly that.
    Reach,
    /// Multiples of 5 units, so that 3-4-5 triangles have corners on the grid.
    Fifths,
}

macro_rules! sets {
    ($($group:ident $size:ident $name:literal $draw:expr;)+) => {
        &[$(Set { name: $name, group: Group::$group, size: Size::$size, draw: $draw }),+]
    };
}

pub const SETS: &[Set] = sets! {
    Benign Usual "benign" benign;
    BenignMoved Moved "benign_moved" benign;
    Far Usual "far_1e3" |random, r, h| aimed(random, r, h, 1e3 * r);
    Far Usual "far_1e5" |random, r, h| aimed(random, r, h, 1e5 * r);
    Far Usual "far_1e6" |random, r, h| aimed(random, r, h, 1e6 * r);
    FarMoved Moved "far_moved" |random, r, h| aimed(random, r, h, 1e3 * r);
    Graze Usual "graze_1e-3" |random, r, h| graze(random, r, h, 1e-3);
    Graze Usual "graze_1e-4" |random, r, h| graze(random, r, h, 1e-4);
    Graze Usual "graze_1e-5" |random, r, h| graze(random, r, h, 1e-5);
    Graze Usual "graze_1e-6" |random, r, h| graze(random, r, h, 1e-6);
    Graze Usual "graze_1e-7" |random, r, h| graze(random, r, h, 1e-7);
    GrazeMoved Moved "graze_moved" |random, r, h| graze(random, r, h, 1e-5);
    NearParallel Usual "nearpar_1e-2" |random, r, h| near_parallel(random, r, h, 1e-2);
    NearParallel Usual "nearpar_1e-3" |random, r, h| near_parallel(random, r, h, 1e-3);
    NearParallel Usual "nearpar_1e-4" |random, r, h| near_parallel(random, r, h, 1e-4);
    NearParallel Usual "nearpar_1e-5" |random, r, h| near_parallel(random, r, h, 1e-5);
    NearParallel Usual "nearpar_1e-6" |random, r, h| near_parallel(random, r, h, 1e-6);
    Tiny Tiny "tiny" tiny;
    Huge Huge "huge" huge;
    Inside Usual "inside" inside;
    InsideMoved Moved "inside_moved" inside;
    PastOrigin Past "benign_past" benign;
    PastOrigin Past "inside_past" inside;
    OnSurface Usual "onsurf" on_surface;
    Rim Usual "capedge" rim;
    Unnormalised Usual "unnorm" |random, r, h| unnormalised(random, r, h, 0.0, 4.0);
    Unnormalised Usual "unnorm_ext" |random, r, h| unnormalised(random, r, h, 10.0, 30.0);
    Exact Usual "par_exact" parallel;
    Exact Usual "perp_exact" perpendicular;
    Fixed Usual "fixed_reach" from_reach;
    Fixed Units "fixed_units" at_a_wire;
    Fixed Reach "fixed_large" graze_large;
    FixedShort Tiny "fixed_short" short_chord;
    Fixed Fifths "fixed_rim" through_a_rim;
    Invalid Usual "zero" zero;
    Invalid Usual "nan" |random, r, h| spoilt(random, r, h, f64::NAN);
    Invalid Usual "inf" |random, r, h| spoilt(random, r, h, f64::INFINITY);
};

/// The largest coordinate of `I16F16`, and its unit.
pub const MAX_COORDINATE: f64 = 4096.0;
pub const UNIT: f64 = 1.0 / 65536.0;

/// Cylinders per set.
const CYLINDERS: usize = 16;

impl Set {
    /// `count` rays, cylinder after cylinder.
    pub fn queries(&self, count: usize) -> Vec<Query> {
        let mut random = Random::named(self.name);
        let mut queries = Vec::with_capacity(count);
        for i in 0..CYLINDERS {
            let (r, h) = match self.size {
                Size::Usual => (random.between(0.3, 1.5), random.between(0.5, 2.5)),
                // On the grid, as the middle is: both types' numbers have exact sums of these.
                Size::Moved | Size::Past => {
                    (random.between(0.3, 1.5), on_grid(random.between(0.5, 2.5)))
                }
                Size::Sphere => [random.between(0.3, 1.5); 2].into(),
                Size::Tiny => (random.between(1e-3, 2e-3), random.between(0.5, 1.5)),
                Size::Huge => (random.between(1e4, 2e4), random.between(0.5e4, 2.5e4)),
                Size::Units => (UNIT * (1.0 + random.below(64) as f64), random.between(0.5, 2.5)),
                Size::Fifths => {
                    let mut fifths = || 5.0 * UNIT * (1.0 + random.below(13_107) as f64);
                    (fifths(), fifths())
                }
                Size::Reach if random.chance(0.5) => (MAX_COORDINATE, MAX_COORDINATE),
                Size::Reach => (
                    random.between(0.25, 1.0) * MAX_COORDINATE,
                    random.between(0.25, 1.0) * MAX_COORDINATE,
                ),
            };
            let [r, h] = [r, h].map(rounded);
            while queries.len() < count * (i + 1) / CYLINDERS {
                let query = Query::new((self.draw)(&mut random, r, h), r, h);
                let [x, y, z] = match self.size {
                    Size::Moved | Size::Sphere => [(); 3].map(|()| random.between(-4.0, 4.0)),
                    Size::Past => past_origin(&mut random, &query),
                    _ => {
                        queries.push(query);
                        continue;
                    }
                };
                let moved = query.moved([on_grid(x), rounded(y), rounded(z)], i % 3);
                queries.push(Query { is_ball: matches!(self.size, Size::Sphere), ..moved });
            }
        }
        queries
    }
}

/// Where to move a cylinder for its line to pass the origin.
fn past_origin(random: &mut Random, query: &Query) -> V {
    let passed = along(query.origin, random.sign() * random.between(1.0, 4.0), query.direction);
    along(random.direction().map(|x| 3e-3 * x), -1.0, passed)
}

pub fn rounded(x: f64) -> f64 {
    f64::from(x as f32)
}

pub fn on_grid(x: f64) -> f64 {
    (x / UNIT).round() * UNIT
}

/// A point of the cylinder, scaled by `scale`; uniform.
fn point_in(random: &mut Random, r: f64, h: f64, scale: f64) -> V {
    let distance = scale * r * random.between(0.0, 1.0).sqrt();
    along([scale * h * random.between(-1.0, 1.0), 0.0, 0.0], distance, random.across())
}

/// From `distance` away, towards a point in the cylinder scaled by 1.2.
fn aimed(random: &mut Random, r: f64, h: f64, distance: f64) -> [V; 2] {
    let origin = random.direction().map(|x| distance * x);
    let target = point_in(random, r, h, 1.2);
    [origin, unit(along(target, -1.0, origin))]
}

fn benign(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let distance = r * random.between(3.0, 10.0);
    aimed(random, r, h, distance)
}

/// Passes the wall at `gap` (to half or twice as much) of the radius, inside or outside.
fn graze(random: &mut Random, r: f64, h: f64, gap: f64) -> [V; 2] {
    let normal = random.across();
    let [_, y, z] = normal;
    let distance = r * (1.0 + random.sign() * gap * random.between(0.5, 2.0));
    let nearest = along([0.9 * h * random.between(-1.0, 1.0), 0.0, 0.0], distance, normal);
    let tilt = random.between(-1.0, 1.0);
    let direction = along([tilt, 0.0, 0.0], (1.0 - tilt * tilt).sqrt(), [0.0, -z, y]);
    [along(nearest, -r * random.between(2.0, 10.0), direction), direction]
}

/// `angle` off the axis, from beyond a cap; half of the rays cross the wall between the caps.
fn near_parallel(random: &mut Random, r: f64, h: f64, angle: f64) -> [V; 2] {
    let target = if random.chance(0.5) {
        along([h * random.between(-1.0, 1.0), 0.0, 0.0], r, random.across())
    } else {
        let [_, y, z] = point_in(random, r, h, 1.3);
        [0.0, y, z]
    };
    let direction = along([random.sign() * angle.cos(), 0.0, 0.0], angle.sin(), random.across());
    [along(target, -2.0 * h - random.between(1.0, 20.0) * r, direction), direction]
}

fn tiny(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let distance = random.between(2.0, 12.0);
    aimed(random, r, h, distance)
}

/// From within ten units of the wall, to a point inside.
fn huge(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let start = [0.9 * h * random.between(-1.0, 1.0), 0.0, 0.0];
    let origin = along(start, r + random.between(-10.0, 10.0), random.across());
    let target = point_in(random, r, h, 1.0);
    [origin, unit(along(target, -1.0, origin))]
}

fn inside(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    [point_in(random, r, h, 0.999), random.direction()]
}

fn on_surface(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let origin = if random.chance(0.5) {
        along([h * random.between(-1.0, 1.0), 0.0, 0.0], r, random.across())
    } else {
        let [_, y, z] = point_in(random, r, h, 1.0);
        [random.sign() * h, y, z]
    };
    [origin, random.direction()]
}

/// Meets a rim within 10⁻⁶.
fn rim(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let mut off_by = || 1.0 + 1e-6 * random.between(-1.0, 1.0);
    let (x, distance) = (h * off_by(), r * off_by());
    let target = along([random.sign() * x, 0.0, 0.0], distance, random.across());
    let direction = random.direction();
    [along(target, -r * random.between(3.0, 30.0), direction), direction]
}

/// As benign, but the direction is 10^±`low` to 10^±`high` long.
fn unnormalised(random: &mut Random, r: f64, h: f64, low: f64, high: f64) -> [V; 2] {
    let [origin, direction] = benign(random, r, h);
    let length = 10f64.powf(random.sign() * random.between(low, high));
    [origin, direction.map(|x| length * x)]
}

/// Inside, outside, within a thousandth of the wall, or on it as nearly as `f32` can be.
fn parallel(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let distance = match random.below(3) {
        0 => r,
        1 => r * (1.0 + 1e-3 * random.between(-1.0, 1.0)),
        _ => 1.5 * r * random.between(0.0, 1.0).sqrt(),
    };
    let x = random.between(-10.0, 10.0) * h;
    let length = if random.chance(0.5) { 1.0 } else { 10f64.powf(random.between(0.0, 2.0)) };
    [along([x, 0.0, 0.0], distance, random.across()), [random.sign() * length, 0.0, 0.0]]
}

/// Between the caps, beside them, or in a cap's plane; a quarter along coordinate axes.
fn perpendicular(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let x = if random.chance(0.2) { random.sign() } else { random.between(-1.2, 1.2) } * h;
    let origin = along([x, 0.0, 0.0], r * random.between(2.0, 5.0), random.across());
    if random.chance(0.25) {
        let [y, z] = [[1.0, 0.0], [0.0, 1.0]][random.below(2)].map(|c| random.sign() * c);
        return [origin, [0.0, y, z]];
    }
    let [_, y, z] = point_in(random, r, h, 1.2);
    [origin, unit([0.0, y - origin[1], z - origin[2]])]
}

/// From as far as can be, to a point near the cylinder, with a direction of any length.
fn from_reach(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let way = random.direction();
    let largest = way.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let origin = way.map(|x| x / largest * MAX_COORDINATE * random.between(0.9, 1.0));
    let target = point_in(random, r, h, 1.2);
    let length = 10f64.powf(random.between(0.0, 4.0));
    [origin, unit(along(target, -1.0, origin)).map(|x| length * x)]
}

/// From nearby, to a point in or beside a cylinder of a few units.
fn at_a_wire(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let distance = random.between(1.0, 4.0);
    let origin = random.direction().map(|x| distance * x);
    let target = point_in(random, r, h, 1.5);
    [origin, along(target, -1.0, origin)]
}

/// Passes the wall of a cylinder as large as can be at up to 4 units, inside or outside; where that
/// is a chord at all, it has a thousandth of the radius.
fn graze_large(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let normal = random.across();
    let [_, y, z] = normal;
    let distance = r + UNIT * random.between(-4.0, 4.0);
    let nearest = along([0.9 * h * random.between(-1.0, 1.0), 0.0, 0.0], distance, normal);
    let tilt = random.between(-1.0, 1.0);
    let direction = along([tilt, 0.0, 0.0], (1.0 - tilt * tilt).sqrt(), [0.0, -z, y]);
    [along(nearest, random.between(-8.0, 8.0), direction), direction]
}

/// As benign, with directions so long that all of the chord lies in a unit or two of the parameter.
fn short_chord(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let [origin, direction] = benign(random, r, h);
    let length = random.between(0.25, 1.0) * 4.0 * MAX_COORDINATE;
    [origin, direction.map(|x| length * x)]
}

/// From a point of the grid nearby, exactly through a point of a rim, where wall and cap are crossed
/// at one parameter: half of the rays only touch the cylinder there.
fn through_a_rim(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    const CORNERS: [[f64; 2]; 4] = [[5.0, 0.0], [3.0, 4.0], [-4.0, 3.0], [0.0, -5.0]];
    let [y, z] = CORNERS[random.below(CORNERS.len())].map(|fifths| fifths * r / 5.0);
    let rim = [random.sign() * h, y, z];
    let distance = random.between(1.0, 4.0);
    let origin = random.direction().map(|x| on_grid(distance * x));
    [origin, along(rim, -1.0, origin)]
}

fn zero(random: &mut Random, r: f64, h: f64) -> [V; 2] {
    let origin = point_in(random, r, h, 4.0);
    [origin, [0.0; 3].map(|x: f64| x * random.sign())]
}

/// As benign, with one or more coordinates replaced by `by`, of either sign.
fn spoilt(random: &mut Random, r: f64, h: f64, by: f64) -> [V; 2] {
    let mut ray = benign(random, r, h);
    let certain = random.below(6);
    for i in 0..6 {
        if i == certain || random.chance(0.3) {
            ray[i / 3][i % 3] = random.sign() * by;
        }
    }
    ray
}
