//! What is compared: methods, and the numbers that they work with.

use crate::formulas;
use crate::rays::{MAX_COORDINATE, UNIT, on_grid, rounded};
use crate::timing::Pass;
use parry3d::math::Vector;
use parry3d::query::RayCast;
use scancsg::geom::{Ray, vec3};
use scancsg::scalar::I16F16;
use scancsg::solid::{Cylinder, RayCast as _};
use scancsg::span::{Face, SpanList};
use std::hint::black_box;
use std::ops::RangeInclusive;
use testkit::query::Query;
use testkit::ulp::ulp_at;

/// The exact numbers that a method is asked with, and the unit of its error.
///
/// The oracle is asked about the rounded query.
pub struct Inputs {
    pub name: &'static str,
    pub unit: &'static str,
    /// The size of the unit at an exact parameter.
    pub unit_at: fn(f64) -> f64,
    /// The query in this type's numbers, or `None` outside of its range.
    pub take: fn(&Query) -> Option<Query>,
    /// Whether the class of every line is promised, and not only that of robust rays.
    pub is_exact: bool,
    /// What the distance of a hit point from the surface is counted in: r, where the cylinder's middle
    /// is the scene's origin.
    pub point_unit: fn(&Query) -> f64,
}

/// Queries in `f32`; also for `f64` methods, so that errors compare.
pub static F32: Inputs = Inputs {
    name: "f32",
    unit: ULP,
    unit_at: ulp_at,
    take: |query| Some(query.map(rounded)),
    is_exact: false,
    // The coordinates of a point on a cylinder elsewhere are rounded as large numbers are.
    point_unit: |query| query.base.iter().fold(0.0, |m: f64, x| m.max(x.abs())) + query.radius,
};

/// The unit that errors in others are compared in.
pub const ULP: &str = "ulp";

/// Queries on the grid of multiples of 2⁻¹⁶, whose units are the same everywhere.
pub static GRID: Inputs = Inputs {
    name: "I16F16",
    unit: "LSB",
    unit_at: |_| UNIT,
    take: taken_on_grid,
    is_exact: true,
    point_unit: |_| UNIT,
};

/// What a ray or a cylinder of `I16F16` takes; NaN and infinities are no numbers of it. A direction
/// of zero stays one, which is an error when the ray is made.
fn taken_on_grid(query: &Query) -> Option<Query> {
    let rounded = query.map(on_grid);
    let largest = |v: [f64; 3]| v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let is_taken = rounded.is_finite()
        && largest(rounded.origin) <= MAX_COORDINATE
        && (query.direction == [0.0; 3] || LENGTHS.contains(&largest(rounded.direction)))
        && (UNIT..=MAX_COORDINATE).contains(&rounded.radius)
        && (UNIT..=MAX_COORDINATE).contains(&rounded.half_length);
    is_taken.then_some(rounded)
}

/// Of the largest coordinate of a direction.
const LENGTHS: RangeInclusive<f64> = 0.5..=4.0 * MAX_COORDINATE;

/// Which parameters a method answers with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gives {
    /// Both ends of the whole line's span; they may be negative.
    Span,
    /// The first crossing at t ≥ 0, twice: where the ray enters, or, from inside, where it exits.
    First,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Answer {
    /// The input is outside of what the method takes: an error before any solid is asked.
    Refused,
    Miss,
    Hit([f64; 2]),
}

/// A hit point and whether it is said to lie on the wall (or else on a cap).
pub type SurfacePoint = ([f64; 3], bool);

type PreparePass = dyn Fn(&[Query]) -> Pass;

pub struct Method {
    pub name: &'static str,
    /// The number type that it computes in.
    pub number: &'static str,
    pub inputs: &'static Inputs,
    pub gives: Gives,
    pub answer: Box<dyn Fn(&Query) -> Answer>,
    /// Gets ready to answer all of these queries.
    pub prepare_pass: Box<PreparePass>,
    /// The point that the ray sees, for methods that give one.
    pub point: Option<fn(&Query) -> Option<SurfacePoint>>,
}

impl Method {
    pub fn label(&self) -> String {
        format!("{} {}", self.name, self.number)
    }

    /// Asked about queries on the grid of fixed point.
    pub fn on_grid(self) -> Self {
        Self { inputs: &GRID, ..self }
    }

    /// Also says where the point is that is seen.
    pub fn with_point(self, point: fn(&Query) -> Option<SurfacePoint>) -> Self {
        Self { point: Some(point), ..self }
    }

    /// `prepare` is what a caller has ready before the clock starts; `solve` is measured.
    pub fn new<P: 'static, T: Copy + Into<f64> + 'static>(
        [name, number]: [&'static str; 2],
        prepare: fn(&Query) -> Option<P>,
        solve: impl Fn(&P) -> Option<[T; 2]> + Copy + 'static,
    ) -> Self {
        let answer = move |query: &Query| match prepare(query).map(|input| solve(&input)) {
            None => Answer::Refused,
            Some(None) => Answer::Miss,
            Some(Some(t)) => Answer::Hit(t.map(Into::into)),
        };
        let prepare_pass = move |queries: &[Query]| -> Pass {
            let inputs: Vec<P> = queries.iter().filter_map(prepare).collect();
            Box::new(move || {
                for input in &inputs {
                    black_box(solve(black_box(input)));
                }
            })
        };
        Self {
            name,
            number,
            inputs: &F32,
            gives: Gives::Span,
            answer: Box::new(answer),
            prepare_pass: Box::new(prepare_pass),
            point: None,
        }
    }
}

/// The methods whose answers are held against the targets.
pub const SHIPPED: [[&str; 2]; 2] = [["scancsg", "f32"], ["scancsg", "I16F16"]];

/// The first one is what every time is a multiple of.
pub fn methods() -> Vec<Method> {
    vec![
        Method::new(["textbook", "f32"], numbers_f32, formulas::f32::textbook),
        Method::new(["plain stable", "f32"], numbers_f32, formulas::f32::stable),
        Method::new(SHIPPED[0], ready_f32, trace_f32).with_point(point_f32),
        Method::new(["scancsg prepared", "f32"], prepared_f32, |(ray, cylinder)| {
            spans_f32(ray, cylinder)
        }),
        Method::new(["textbook", "f64"], numbers_f64, formulas::f64::textbook),
        Method::new(["plain stable", "f64"], numbers_f64, formulas::f64::stable),
        Method::new(["scancsg", "f64"], ready_f64, trace_f64),
        Method { gives: Gives::First, ..Method::new(["parry3d", "f32"], parry_input, parry) },
        // Nothing that takes time is prepared in fixed point.
        Method::new(SHIPPED[1], ready_i16f16, trace_i16f16).on_grid().with_point(point_i16f16),
    ]
}

macro_rules! numbers {
    ($Float:ident $numbers:ident) => {
        /// The origin less the middle of the axis in the type's own arithmetic, because the formulas
        /// know one place only. Of these methods, that isn't timed.
        pub fn $numbers(query: &Query) -> Option<formulas::$Float::Input> {
            let Query { origin, direction, base, .. } = query;
            let [ox, oy, oz] = [0, 1, 2].map(|i| origin[i] as $Float - base[i] as $Float);
            let [dx, dy, dz] = direction.map(|x| x as $Float);
            let [r, h] = [query.radius, query.half_length].map(|x| x as $Float);
            Some([ox, oy, oz, dx, dy, dz, r, h])
        }
    };
}

numbers!(f32 numbers_f32);
numbers!(f64 numbers_f64);

macro_rules! shipped {
    ($Scalar:ident $number:path, $ready:ident $trace:ident $prepared:ident $spans:ident $point:ident) => {
        fn $ready(query: &Query) -> Option<Ready<$Scalar>> {
            let [x, y, z] = query.base;
            let (r, h) = ($number(query.radius), query.half_length);
            let [low, high, first, second] = [x - h, x + h, y, z].map($number);
            let cylinder = match query.axis {
                0 => Cylinder::<$Scalar>::along_x(first, second, r, low, high),
                1 => Cylinder::<$Scalar>::along_y(second, first, r, low, high),
                _ => Cylinder::<$Scalar>::along_z(first, second, r, low, high),
            };
            let in_scene = |mut v: [f64; 3]| {
                v.rotate_right(query.axis);
                v.map($number)
            };
            Some((in_scene(query.origin), in_scene(query.direction), cylinder.ok()?))
        }

        /// A ray that can't be made is a miss here: all that is asked of it is not to hit.
        fn $trace(
            &([ox, oy, oz], [dx, dy, dz], ref cylinder): &Ready<$Scalar>,
        ) -> Option<[$Scalar; 2]> {
            $spans(&Ray::new(vec3(ox, oy, oz), vec3(dx, dy, dz)).ok()?, cylinder)
        }

        /// What a scene of many solids does once per ray is done before the clock starts.
        #[allow(dead_code)] // not of every type
        fn $prepared(query: &Query) -> Option<(Ray<$Scalar>, Cylinder<$Scalar>)> {
            let ([ox, oy, oz], [dx, dy, dz], cylinder) = $ready(query)?;
            Some((Ray::new(vec3(ox, oy, oz), vec3(dx, dy, dz)).ok()?, cylinder))
        }

        // Always, as `trace` itself: a ray that has just been made stays in registers.
        #[inline(always)]
        fn $spans(ray: &Ray<$Scalar>, cylinder: &Cylinder<$Scalar>) -> Option<[$Scalar; 2]> {
            let mut list = SpanList::<$Scalar, 1>::new();
            cylinder.trace(ray, &mut list).first().map(|span| [span.enter.t, span.exit.t])
        }

        #[allow(dead_code)] // not of every type
        fn $point(query: &Query) -> Option<SurfacePoint> {
            let (ray, cylinder) = $prepared(query)?;
            let hit = cylinder.hit(&ray, &mut SpanList::<$Scalar, 1>::new())?;
            let mut point = [hit.point.x, hit.point.y, hit.point.z].map(f64::from);
            point.rotate_left(query.axis);
            Some((point, hit.face == Face(2)))
        }
    };
}

/// Origin and direction of a ray, and a cylinder.
type Ready<S> = ([S; 3], [S; 3], Cylinder<S>);

pub fn narrowed(x: f64) -> f32 {
    x as f32
}

pub fn of_grid(x: f64) -> I16F16 {
    I16F16::from_bits((x / UNIT) as i32)
}

shipped!(f32 narrowed, ready_f32 trace_f32 prepared_f32 spans_f32 point_f32);
shipped!(f64 f64::from, ready_f64 trace_f64 prepared_f64 spans_f64 point_f64);
shipped!(I16F16 of_grid, ready_i16f16 trace_i16f16 prepared_i16f16 spans_i16f16 point_i16f16);

/// parry's cylinders stand along y, so x and y change places.
fn parry_input(query: &Query) -> Option<(parry3d::query::Ray, parry3d::shape::Cylinder)> {
    let [ox, oy, oz, dx, dy, dz, r, h] = numbers_f32(query)?;
    let ray = parry3d::query::Ray::new(Vector::new(oy, ox, oz), Vector::new(dy, dx, dz));
    Some((ray, parry3d::shape::Cylinder::new(h, r)))
}

/// Not as a "solid", for which parry answers t = 0 to every ray that starts inside: as a surface,
/// whose crossing it gives from inside, too.
fn parry((ray, cylinder): &(parry3d::query::Ray, parry3d::shape::Cylinder)) -> Option<[f32; 2]> {
    cylinder.cast_local_ray(ray, f32::MAX, false).map(|t| [t, t])
}
