//! What is compared: methods, and the numbers that they work with.

use crate::formulas;
use crate::rays::Query;
use parry3d::math::Vector;
use parry3d::query::RayCast;
use scancsg::geom::{Ray, vec3};
use scancsg::solid::{Cylinder, Solid};
use scancsg::span::{Face, SpanList};
use std::hint::black_box;

/// The exact numbers that a method is asked with, and the unit of its error.
///
/// Another number type, such as fixed point, is another constant of this type: `take` rounds to
/// its grid, and the oracle is asked about the rounded query.
pub struct Inputs {
    pub name: &'static str,
    pub unit: &'static str,
    /// The size of the unit at an exact parameter.
    pub unit_at: fn(f64) -> f64,
    /// The query in this type's numbers, or `None` outside of its range.
    pub take: fn(&Query) -> Option<Query>,
}

/// Queries as they were drawn, in `f32`; also for `f64` methods, so that errors compare.
static F32: Inputs = Inputs {
    name: "f32",
    unit: "ulp",
    unit_at: |t| {
        let near = (t as f32).abs();
        f64::from(near.next_up() - near)
    },
    take: |query| Some(*query),
};

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

/// Answers some queries once, for a clock around the call.
pub type Pass = Box<dyn Fn()>;

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

    /// `prepare` is what a caller has ready before the clock starts; `solve` is measured.
    fn new<P: 'static, T: Copy + Into<f64> + 'static>(
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

/// The method that every time is a multiple of: the first one.
pub const BASELINE: usize = 0;

/// The method whose answers are held against the targets.
pub const SHIPPED: [&str; 2] = ["scancsg", "f32"];

pub fn methods() -> Vec<Method> {
    vec![
        Method::new(["textbook", "f32"], numbers_f32, formulas::f32::textbook),
        Method::new(["plain stable", "f32"], numbers_f32, formulas::f32::stable),
        Method { point: Some(point_f32), ..Method::new(SHIPPED, ready_f32, trace_f32) },
        Method::new(["scancsg prepared", "f32"], prepared_f32, |(ray, cylinder)| {
            spans_f32(ray, cylinder)
        }),
        Method::new(["textbook", "f64"], numbers_f64, formulas::f64::textbook),
        Method::new(["plain stable", "f64"], numbers_f64, formulas::f64::stable),
        Method::new(["scancsg", "f64"], ready_f64, trace_f64),
        Method { gives: Gives::First, ..Method::new(["parry3d", "f32"], parry_input, parry) },
    ]
}

fn numbers_f32(query: &Query) -> Option<formulas::f32::Input> {
    Some(query.numbers().map(|x| x as f32))
}

fn numbers_f64(query: &Query) -> Option<formulas::f64::Input> {
    Some(query.numbers())
}

macro_rules! shipped {
    ($Float:ident $Ready:ident $ready:ident $trace:ident $spans:ident) => {
        /// A cylinder, and origin and direction of a ray.
        type $Ready = ([$Float; 3], [$Float; 3], Cylinder<$Float>);

        fn $ready(query: &Query) -> Option<$Ready> {
            let [ox, oy, oz, dx, dy, dz, r, h] = query.numbers().map(|x| x as $Float);
            let cylinder = Cylinder::<$Float>::along_x(0.0, 0.0, r, -h, h).ok()?;
            Some(([ox, oy, oz], [dx, dy, dz], cylinder))
        }

        /// A ray that can't be made is a miss here: all that is asked of it is not to hit.
        fn $trace(&([ox, oy, oz], [dx, dy, dz], ref cylinder): &$Ready) -> Option<[$Float; 2]> {
            $spans(&Ray::new(vec3(ox, oy, oz), vec3(dx, dy, dz)).ok()?, cylinder)
        }

        fn $spans(ray: &Ray<$Float>, cylinder: &Cylinder<$Float>) -> Option<[$Float; 2]> {
            let mut list = SpanList::<$Float, 1>::new();
            cylinder.trace(ray, &mut list).first().map(|span| [span.enter.t, span.exit.t])
        }
    };
}

shipped!(f32 ReadyF32 ready_f32 trace_f32 spans_f32);
shipped!(f64 ReadyF64 ready_f64 trace_f64 spans_f64);

/// What a scene of many solids does once per ray is done before the clock starts.
fn prepared_f32(query: &Query) -> Option<(Ray<f32>, Cylinder<f32>)> {
    let ([ox, oy, oz], [dx, dy, dz], cylinder) = ready_f32(query)?;
    Some((Ray::new(vec3(ox, oy, oz), vec3(dx, dy, dz)).ok()?, cylinder))
}

fn point_f32(query: &Query) -> Option<SurfacePoint> {
    let (ray, cylinder) = prepared_f32(query)?;
    let hit = cylinder.hit(&ray, &mut SpanList::<f32, 1>::new())?;
    let point = [hit.point.x, hit.point.y, hit.point.z].map(f64::from);
    Some((point, hit.face == Face(2)))
}

/// parry's cylinders stand along y, so x and y change places.
fn parry_input(query: &Query) -> Option<(parry3d::query::Ray, parry3d::shape::Cylinder)> {
    let [ox, oy, oz, dx, dy, dz, r, h] = query.numbers().map(|x| x as f32);
    let ray = parry3d::query::Ray::new(Vector::new(oy, ox, oz), Vector::new(dy, dx, dz));
    Some((ray, parry3d::shape::Cylinder::new(h, r)))
}

/// Not as a "solid", for which parry answers t = 0 to every ray that starts inside: as a surface,
/// whose crossing it gives from inside, too.
fn parry((ray, cylinder): &(parry3d::query::Ray, parry3d::shape::Cylinder)) -> Option<[f32; 2]> {
    cylinder.cast_local_ray(ray, f32::MAX, false).map(|t| [t, t])
}
