//! How long the parts take on this host: `cargo bench --package bench --bench parts`, or with a name behind `--`
//! only those. Instructions on microcontrollers are another matter.

#![allow(clippy::unwrap_used)]

#[path = "../examples/scene/mod.rs"]
mod scene;

use divan::{Bencher, black_box, counter::ItemsCount};
use scancsg::constant;
use scancsg::geom::{Line, OrthographicRays, PerspectiveRays, Ray, Vec3};
use scancsg::render::{Camera, Gray8, Lambert, Picture, Size};
use scancsg::scalar::I16F16;
use scancsg::scan::Empty;
use scancsg::solid::{RayCast, Scan, Shape, Solid};
use scancsg::span::{Crossing, Face, Operation, Span, SpanList, merge};
use scancsg::spline::{Baked, Curve, Knots, Outside};
use scancsg::stream::{Decoder, PixelFormat, encode_row, packet_capacity};

use scene::{Scene, Tee};

const SPANS: usize = <Tee<f32> as Shape>::STACK;
const SIZE: (u16, u16) = (160, 120);
const PACKET: usize = packet_capacity(SIZE.0, PixelFormat::Gray8);

fn main() {
    divan::main();
}

fn vector<S: Scene>(hundredths: [i32; 3]) -> Vec3<S> {
    Vec3::from(hundredths.map(S::hundredths))
}

/// A ray at a cylinder, as it is: ray and query.
#[divan::bench(types = [f32, f64, I16F16])]
fn cylinder_ray_and_query<S: Scene>(bencher: Bencher<'_, '_>) {
    let [cylinder, ..] = S::BODY;
    let (origin, direction) = (vector::<S>([300, 400, 500]), vector::<S>([-50, -70, -90]));
    let mut list = SpanList::<S, 1>::new();
    bencher.bench_local(|| {
        let ray = Ray::new(black_box(origin), black_box(direction));
        ray.map(|ray| cylinder.trace(&ray, &mut list).len())
    });
}

/// A ray made ready at a cylinder: the query alone.
#[divan::bench(types = [f32, f64, I16F16])]
fn cylinder_query<S: Scene>(bencher: Bencher<'_, '_>) {
    let [cylinder, ..] = S::BODY;
    let ray = Ray::new(vector::<S>([300, 400, 500]), vector([-50, -70, -90])).unwrap();
    let mut list = SpanList::<S, 1>::new();
    bencher.bench_local(|| cylinder.trace(black_box(&ray), &mut list).len());
}

/// A prepared line at the whole part: ten cylinders and their merge.
#[divan::bench(types = [f32, f64, I16F16])]
fn tee_line<S: Scene>(bencher: Bencher<'_, '_>) {
    let line = Line { origin: vector([300, 250, 400]), direction: vector([-50, -40, -70]) };
    let tee: Tee<S> = S::TEE;
    let mut list = SpanList::<S, SPANS>::new();
    bencher.bench_local(|| {
        tee.spans(black_box(&line), Face(0), &mut list.stack());
        list.len()
    });
}

/// Two lists of so many spans each that all overlap.
#[divan::bench(consts = [1, 4, 16])]
fn merge_spans<const N: usize>(bencher: Bencher<'_, '_>) {
    let at = |t: usize| Crossing { t: t as f32, face: Face(0) };
    let mut list = SpanList::<f32, 64>::new();
    bencher.counter(ItemsCount::new(2 * N)).bench_local(|| {
        let mut stack = list.stack();
        for shift in [0, 1] {
            for i in 0..N {
                let start = 4 * i + shift;
                let span = Span { enter: at(start), exit: at(start + 2) };
                let _ = stack.push(black_box(span));
            }
        }
        let _ = merge(Operation::UNION, &mut stack, 0, N);
        list.len()
    });
}

/// Getting ready for a picture: once per frame.
#[divan::bench(types = [f32, I16F16])]
fn tee_view<S: Scene>(bencher: Bencher<'_, '_>)
where
    Tee<S>: Scan<OrthographicRays<S>>,
{
    let rays = S::orthographic().unwrap().rays(Size::new(SIZE.0, SIZE.1).unwrap());
    let tee = S::TEE;
    bencher.bench_local(|| {
        let mut view = <Tee<S> as Scan<OrthographicRays<S>>>::View::EMPTY;
        tee.view(black_box(&rays), &mut view);
        black_box(view);
    });
}

fn light<S: Scene>() -> Lambert<S> {
    Lambert::new(S::TO_LIGHT, S::hundredths(15)).unwrap()
}

/// The row through the middle of the part.
#[divan::bench(types = [f32, I16F16])]
fn tee_row<S: Scene>(bencher: Bencher<'_, '_>)
where
    Tee<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let camera = S::orthographic().unwrap();
    let size = Size::new(SIZE.0, SIZE.1).unwrap();
    let tee = S::TEE;
    let mut picture = Picture::new(&tee, &camera, size, light::<S>(), Gray8(0));
    let mut pixels = [Gray8(0); SIZE.0 as usize];
    bencher.counter(ItemsCount::new(SIZE.0)).bench_local(|| {
        picture.scanline(black_box(60)).and_then(|mut row| row.render(&mut pixels))
    });
}

/// A whole frame, by camera.
#[divan::bench(types = [f32, I16F16], args = ["orthographic", "perspective"])]
fn tee_frame<S: Scene>(bencher: Bencher<'_, '_>, camera: &str)
where
    Tee<S>: Scan<OrthographicRays<S>, Scalar = S> + Scan<PerspectiveRays<S>, Scalar = S>,
{
    let size = Size::new(SIZE.0, SIZE.1).unwrap();
    let tee = S::TEE;
    let mut pixels = [Gray8(0); SIZE.0 as usize];
    let bencher = bencher.counter(ItemsCount::new(u32::from(SIZE.0) * u32::from(SIZE.1)));
    macro_rules! frames {
        ($camera:expr) => {
            bencher.bench_local(|| {
                let mut picture =
                    Picture::new(&tee, black_box(&$camera), size, light::<S>(), Gray8(0));
                (0..SIZE.1).try_for_each(|y| picture.scanline(y)?.render(&mut pixels))
            })
        };
    }
    match camera {
        "orthographic" => frames!(S::orthographic().unwrap()),
        _ => frames!(S::perspective().unwrap()),
    }
}

/// A row as it goes onto the line, and back.
#[divan::bench(args = ["encode", "decode"])]
fn packet(bencher: Bencher<'_, '_>, which: &str) {
    let camera = scene::f32::orthographic().unwrap();
    let light = Lambert::new(scene::f32::TO_LIGHT, 0.15).unwrap();
    let size = Size::new(SIZE.0, SIZE.1).unwrap();
    let mut picture = Picture::new(&scene::f32::TEE, &camera, size, light, Gray8(0));
    let mut pixels = [Gray8(0); SIZE.0 as usize];
    picture.scanline(60).unwrap().render(&mut pixels).unwrap();
    let mut packet = [0; PACKET];
    let length = encode_row(0, 60, &pixels, &mut packet).unwrap();
    let bencher = bencher.counter(ItemsCount::new(SIZE.0));
    if which == "encode" {
        bencher.bench_local(|| encode_row(0, 60, black_box(&pixels), &mut packet));
    } else {
        let mut decoder = Decoder::<PACKET>::new();
        bencher.bench_local(|| {
            let mut bytes = packet.get(..length).unwrap_or_default();
            decoder.feed(black_box(&mut bytes)).is_some()
        });
    }
}

const KNOTS: Knots<f32, 4, 12> = constant!(Knots::<f32, 4, 12>::clamped_uniform(8, 0.0, 5.0));
static PATH: Curve<Vec3<f32>, 4, 8, 12> = constant!(Curve::<Vec3<f32>, 4, 8, 12>::new(
    KNOTS,
    [
        Vec3::new(0.0, 0.0, 0.0),
        Vec3::new(1.0, 2.0, -1.0),
        Vec3::new(3.0, 1.0, 0.5),
        Vec3::new(4.0, -2.0, 1.0),
        Vec3::new(2.0, -3.0, 2.0),
        Vec3::new(0.0, -1.0, 3.0),
        Vec3::new(-1.0, 1.0, 2.0),
        Vec3::new(0.5, 2.0, 1.0),
    ]
));
static BAKED: Baked<Vec3<f32>, 4, { KNOTS.spans() }> = constant!(PATH.bake());

/// A hundred points along a cubic curve in space with eight control points.
#[divan::bench(args = ["editable", "baked"])]
fn spline_points(bencher: Bencher<'_, '_>, form: &str) {
    let bencher = bencher.counter(ItemsCount::new(100u32));
    let parameters: [f32; 100] = core::array::from_fn(|i| ((i * 37) % 100) as f32 / 20.0);
    let clamp = Outside::Clamp;
    // Not copies, whose parts a compiler addresses one by one.
    let (editable, baked) = (black_box(&PATH), black_box(&BAKED));
    match form {
        "editable" => bencher.bench_local(|| {
            for t in black_box(&parameters) {
                black_box(editable.value(*t, clamp)).ok();
            }
        }),
        _ => bencher.bench_local(|| {
            for t in black_box(&parameters) {
                black_box(baked.value(*t, clamp)).ok();
            }
        }),
    }
}
