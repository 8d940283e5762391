//! The parts, each as a function that does it so many times.

use crate::benign;
use crate::frames::WIDTH;
use crate::points::{self, Editable, InFlash, Splines};
use crate::scene::Scene;
use core::hint::black_box;
use scancsg::geom::{Ray, Vec3};
use scancsg::render::Gray8;
use scancsg::scalar::I16F16;
use scancsg::solid::{RayCast, Solid};
use scancsg::span::{Crossing, Face, Operation, Span, SpanList, merge};
use scancsg::spline::{Knots, NonZero, Outside, Sweep};
use scancsg::stream::{Decoder, PixelFormat, encode_row, packet_capacity};

#[cfg(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16"))))]
pub type Number = f32;
#[cfg(not(any(number = "f32", all(target_abi = "eabihf", not(number = "i16f16")))))]
pub type Number = I16F16;

/// Something to be counted: `work` does it as often as its argument says, with so many `inputs` by
/// turns. What `idle` takes is not counted: the same loop around nothing, with the same arguments and
/// a place for the result.
pub struct Part {
    pub name: &'static str,
    pub inputs: u32,
    pub work: extern "C" fn(u32),
    pub idle: extern "C" fn(u32),
}

/// For parts that are counted with the loop around them.
extern "C" fn nothing(_: u32) {}

macro_rules! parts {
    ($($name:literal: $inputs:expr, $work:expr, $idle:expr;)+) => {
        pub const PARTS: &[Part] =
            &[$(Part { name: $name, inputs: $inputs, work: $work, idle: $idle },)+];
    };
}

parts! {
    "cylinder: ready ray": benign::COUNT as u32, benign::ready_ray, benign::idle_rays;
    "cylinder: ray and query": 16, cylinder_ray_and_query, nothing;
    "cylinder: query": 16, cylinder_query, nothing;
    "merge of 4 and 4 spans": 16, merge_spans, nothing;
    "encode a row": 16, encode, nothing;
    "decode a row": 16, decode, nothing;
    "spline: editable point": 16, editable_point, idle_points;
    "spline: baked point": 16, baked_point, idle_points;
    "spline: basis functions": 16, basis_functions, idle_points;
    "spline: step of a sweep": 16, sweep_step, idle_steps;
}

const PACKET: usize = packet_capacity(WIDTH, PixelFormat::Gray8);

fn vector(hundredths: [i32; 3]) -> Vec3<Number> {
    Vec3::from(hundredths.map(Number::hundredths))
}

/// Sixteen rays that hit the first cylinder of the part, from all sides.
fn rays() -> [[Vec3<Number>; 2]; 16] {
    let mut state = 12345u32;
    let mut random = |range: i32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as i32 % (2 * range) - range
    };
    core::array::from_fn(|_| {
        let from = [random(300), 300 + random(100), random(300)];
        let to = [random(150), random(50), random(50)];
        let way = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        [vector(from), vector(way)]
    })
}

#[inline(never)]
extern "C" fn cylinder_ray_and_query(times: u32) {
    let mut list = SpanList::<Number, 1>::new();
    let [cylinder, ..] = black_box(Number::BODY);
    for [origin, direction] in rays().into_iter().cycle().take(times as usize) {
        if let Ok(ray) = Ray::new(black_box(origin), black_box(direction)) {
            black_box(cylinder.trace(&ray, &mut list));
        }
    }
}

#[inline(never)]
extern "C" fn cylinder_query(times: u32) {
    let mut list = SpanList::<Number, 1>::new();
    let [cylinder, ..] = black_box(Number::BODY);
    for [origin, direction] in rays().into_iter().cycle().take(times as usize) {
        let line =
            scancsg::geom::Line { origin: black_box(origin), direction: black_box(direction) };
        cylinder.spans(&line, Face(0), &mut list.stack());
        black_box(&list);
    }
}

#[inline(never)]
extern "C" fn merge_spans(times: u32) {
    let mut list = SpanList::<Number, 16>::new();
    for _ in 0..times {
        let mut stack = list.stack();
        for shift in [0, 1] {
            for i in 0..4 {
                let at = |t| Crossing { t: Number::hundredths(t), face: Face(0) };
                let start = 4 * i + shift;
                let _ = stack.push(black_box(Span { enter: at(start), exit: at(start + 2) }));
            }
        }
        let _ = merge(Operation::UNION, &mut stack, 0, 4);
        black_box(&list);
    }
}

/// A row as renders make them: background, a shaded part, a gap, and background.
fn pixels() -> [Gray8; WIDTH as usize] {
    core::array::from_fn(|x| match x {
        40..70 => Gray8((x * 3) as u8),
        70..80 => Gray8(90),
        90..120 => Gray8((255 - x) as u8),
        _ => Gray8(0),
    })
}

#[inline(never)]
extern "C" fn encode(times: u32) {
    let pixels = pixels();
    let mut packet = [0; PACKET];
    for _ in 0..times {
        let _ = black_box(encode_row(0, 60, black_box(&pixels), &mut packet));
    }
}

#[inline(never)]
extern "C" fn decode(times: u32) {
    let mut packet = [0; PACKET];
    let length = encode_row(0, 60, &pixels(), &mut packet).unwrap_or(0);
    let mut decoder = Decoder::<PACKET>::new();
    for _ in 0..times {
        let mut bytes = packet.get(..length).unwrap_or_default();
        black_box(decoder.feed(black_box(&mut bytes)).is_some());
    }
}

const KNOTS: Knots<Number, 4, 12> = Number::KNOTS;
static PATH: Editable<Number> = Number::EDITABLE;
static BAKED: InFlash<Number> = Number::BAKED;

/// Sixteen parameters in all spans, in no order.
fn parameters() -> [Number; 16] {
    core::array::from_fn(|i| Number::hundredths((i as i32 * 7 % 16) * 31 + 5))
}

// Each is a function of its own, so that its call, its return, and what it does for its arguments and
// its result are counted, and the loop is not.
macro_rules! splines {
    ($($name:ident: $Spline:ty = $spline:expr, $Result:ty = |$part:ident, $t:ident| $value:expr;)+) => {$(
        mod $name {
            use super::*;

            #[inline(never)]
            pub fn value($part: $Spline, $t: Number) -> $Result {
                $value
            }
        }

        #[inline(never)]
        extern "C" fn $name(times: u32) {
            let (part, parameters) = (black_box($spline), black_box(parameters()));
            for i in 0..times {
                let t = parameters[i as usize % 16];
                black_box(&$name::value(part, black_box(t)));
            }
        }
    )+};
}

splines! {
    editable_point: &Editable<Number> = &PATH, Vec3<Number> =
        |curve, t| curve.value(t, Outside::Clamp).unwrap_or(Vec3::ZERO);
    baked_point: &InFlash<Number> = &BAKED, Vec3<Number> =
        |curve, t| curve.value(t, Outside::Clamp).unwrap_or(Vec3::ZERO);
    basis_functions: &Knots<Number, 4, 12> = &KNOTS, Option<NonZero<Number, 4>> =
        |knots, t| knots.non_zero(t);
}

/// All bits of points of these curves, by the functions that are counted.
pub fn digest() -> u32 {
    points::digest(|t| [editable_point::value(&PATH, t), baked_point::value(&BAKED, t)])
}

#[inline(never)]
extern "C" fn idle_points(times: u32) {
    let (parameters, point) = (black_box(parameters()), Vec3::<Number>::ZERO);
    for i in 0..times {
        black_box(parameters[i as usize % 16]);
        black_box(&point);
    }
}

/// Control points of a sweep, in fixed point on every board: sweeps know nothing else.
fn sweep_points() -> [Vec3<I16F16>; 4] {
    let points = [[0, 0, 0], [4, 8, -4], [12, 4, 2], [16, -8, 4]];
    black_box(points.map(|point| Vec3::from(point.map(I16F16::from_num))))
}

#[inline(never)]
extern "C" fn sweep_step(times: u32) {
    #[inline(never)]
    fn step(sweep: &mut Sweep<'_, Vec3<I16F16>, 4>) -> Option<Vec3<I16F16>> {
        sweep.next()
    }
    let points = sweep_points();
    let Ok(mut sweep) = Sweep::<_, 4>::new(&points, 64) else { return };
    for _ in 0..times {
        black_box(&step(&mut sweep));
    }
}

#[inline(never)]
extern "C" fn idle_steps(times: u32) {
    let point = Some(Vec3::<I16F16>::ZERO);
    for _ in 0..times {
        black_box(&point);
    }
}
