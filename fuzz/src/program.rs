//! What must hold of programs whatever their bytes are.

use scancsg::geom::{OrthographicRays, PerspectiveRays, Ray, Rays, Vec3};
use scancsg::program::Program;
use scancsg::render::{Camera, Gray8, Lambert, Orthographic, Perspective, Picture, Size};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::{
    Cone, Cuboid, Cylinder, HalfSpace, Polyhedron, Pooled, RayCast, Scaled, Scan, Solid, Sphere,
    Torus,
};
use scancsg::span::SpanList;

scancsg::leaves! {
    /// All solids that have a form as bytes.
    enum Part<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Cone(Cone<S>),
        Torus(Torus<S>),
        Half(HalfSpace<S>),
        Convex(Polyhedron<S, 5>),
        Faces(Pooled<S, 9>),
        Drum(Scaled<Cylinder<S>>),
        Block(Scaled<Cuboid<S>>),
        Egg(Scaled<Sphere<S>>),
        Funnel(Scaled<Cone<S>>),
        Ring(Scaled<Torus<S>>),
        Lens(Scaled<Polyhedron<S, 8>>),
    }
}

const PARTS: usize = 6;
const POSES: usize = 3;
const SPANS: usize = 16;
const POOL: usize = 20;
const SIZE: [u16; 2] = [16, 12];

type Tree<S> = Program<Part<S>, PARTS, POSES, SPANS, POOL>;

/// Any bytes, and any behind a header of theirs, are an error or a program. That has bytes from which the same
/// one is read, keeps its capacities, and has pictures and hits.
pub fn program(bytes: &[u8]) {
    checked::<f32>(bytes, 32);
    checked::<I16F16>(bytes, 16);
}

fn checked<S: Scalar>(bytes: &[u8], number: u8) {
    is_program::<S>(bytes);
    let [poses, body @ ..] = bytes else { return };
    let length = (8 + body.len()) as u16;
    let [low, high] = length.to_le_bytes();
    let header = [b'S', b'P', 1, number, low, high, poses % (POSES as u8 + 2), 0];
    is_program::<S>(&[&header, body].concat());
}

fn is_program<S: Scalar>(bytes: &[u8]) {
    let mut other = Tree::<S>::new(Part::Sphere(ball()));
    let mut read = match Tree::<S>::from_bytes(bytes) {
        Ok(program) => program,
        Err(error) => {
            let was = other;
            assert_eq!(other.read_bytes(bytes), Err(error));
            assert!(other == was);
            return;
        }
    };
    assert!((1..=PARTS).contains(&read.part_count()));
    assert!((1..=read.part_count()).contains(&read.operand_count()));
    let (mut one, mut two) = (vec![0; bytes.len()], vec![0; bytes.len()]);
    // Only an axis that was written in full, but is a coordinate axis, is shorter.
    let written = read.to_bytes(&mut one).expect("what is read can be written");
    let again = Tree::<S>::from_bytes(written).expect("what is written can be read");
    assert_eq!(again.to_bytes(&mut two), Ok(written));
    assert_eq!(other.read_bytes(bytes), Ok(()));
    assert_eq!(other.to_bytes(&mut two), Ok(written));

    let shown = show(&read);
    assert_eq!(show(&other), shown);
    // Whatever is removed, what is left has a picture.
    let part = usize::from(bytes.last().copied().unwrap_or(0)) % PARTS;
    let count = read.part_count();
    if read.remove(part).is_ok() {
        assert_eq!(read.part_count(), count - 1);
        show(&read);
        let written = read.to_bytes(&mut one).expect("there is room for less than before");
        assert!(Tree::<S>::from_bytes(written).is_ok());
    }
}

fn ball<S: Scalar>() -> Sphere<S> {
    Sphere::around(Vec3::ZERO, S::ONE).expect("a ball")
}

fn point<S: Scalar>(at: [i32; 3]) -> Vec3<S> {
    Vec3::from(at.map(|tenths| S::from_ratio(tenths, 10)))
}

/// Both pictures, and what some rays meet.
fn show<S: Scalar>(program: &Tree<S>) -> [Vec<u8>; 2]
where
    Part<S>: Scan<OrthographicRays<S>, Scalar = S> + Scan<PerspectiveRays<S>, Scalar = S>,
{
    let (eye, up) = (point::<S>([30, 20, 60]), point([0, 10, 0]));
    let flat = Orthographic::look_at(eye, Vec3::ZERO, up, S::from_int(6)).expect("a camera");
    let deep = Perspective::look_at(eye, Vec3::ZERO, up, S::ONE).expect("a camera");
    let mut list = SpanList::<S, SPANS>::new();
    for (from, way) in
        [([30, 20, 60], [-30, -20, -60]), ([0, 0, -90], [0, 0, 10]), ([5, 3, 1], [1, 7, -3])]
    {
        let ray = Ray::new(point(from), point(way)).expect("a ray");
        let spans = program.trace(&ray, &mut list).map(<[_]>::len);
        assert!(
            spans.is_err() || RayCast::trace(program, &ray, &mut list).len() == spans.unwrap_or(0)
        );
        if let Ok(Some(hit)) = program.hit(&ray, &mut list) {
            let _ = (program.normal(hit.face, hit.point), program.color(hit.face));
        }
    }
    let _ = program.bounds();
    [pixels(program, &flat), pixels(program, &deep)]
}

fn pixels<S, C>(program: &Tree<S>, camera: &C) -> Vec<u8>
where
    S: Scalar,
    C: Camera<Rays: Rays<Scalar = S>>,
    Tree<S>: Scan<C::Rays, Scalar = S>,
{
    let [width, height] = SIZE;
    let size = Size::new(width, height).expect("a size");
    let light = Lambert::new(point([10, 20, 30]), S::from_ratio(1, 4)).expect("a light");
    let mut picture = Picture::new(program, camera, size, light, Gray8(0));
    let mut row = |y: u16| {
        let mut pixels = vec![Gray8(0); width.into()];
        let mut line = picture.scanline(y).expect("a row");
        line.render(&mut pixels).expect("its pixels");
        pixels
    };
    let rows: Vec<_> = (0..height).map(&mut row).collect();
    // Rows are the same in another order.
    assert!((0..height).rev().step_by(5).all(|y| rows.get(usize::from(y)) == Some(&row(y))));
    rows.into_iter().flatten().map(|pixel| pixel.0).collect()
}
