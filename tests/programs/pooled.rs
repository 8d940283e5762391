//! Programs whose polyhedra have their faces in a pool: they are, bit for bit, programs and typed trees whose
//! polyhedra have them by themselves.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use scancsg::constant;
use scancsg::geom::{Axis, OrthographicRays, PerspectiveRays, Pose, Ray, Rays, Vec3, vec3};
use scancsg::program::{BytesError, Program, ProgramError};
use scancsg::render::{Camera, Lambert, Orthographic, Perspective, Picture, Rgb565, Size};
use scancsg::solid::{
    Cuboid, Cylinder, Difference, HalfSpace, Painted, Placed, Polyhedron, Pooled, RayCast, Rgb,
    Scaled, Scan, Solid, Union,
};
use scancsg::span::{Face, Shape, SpanList};
use testkit::number::{Tested, vector};
use testkit::random::Random;

for_every_number!(pools_are_arrays, typed_trees_are_pools);

/// The most faces of a polyhedron here.
const N: usize = 12;
const PARTS: usize = 10;
const POSES: usize = 2;
const SPANS: usize = 64;
/// Not all parts can have as many faces as there may be.
const POOL: usize = 40;

scancsg::leaves! {
    enum Own<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Faces(Polyhedron<S, N>),
    }
}

scancsg::leaves! {
    enum Part<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Faces(Pooled<S, N>),
    }
}

type Arrays<S> = Program<Own<S>, PARTS, POSES, SPANS>;
type Pools<S> = Program<Part<S>, PARTS, POSES, SPANS, POOL>;

fn halves<S: Tested>(random: &mut Random, low: i32, high: i32) -> S {
    S::near(f64::from(low + random.below((high - low + 1) as usize) as i32) / 2.0)
}

/// On a grid of halves, where faces of several parts coincide, and rays run along some of them.
fn polyhedron<S: Tested>(random: &mut Random) -> Polyhedron<S, N> {
    let at = |random: &mut Random| halves::<S>(random, -3, 2);
    let axis = Axis::ALL[random.below(3)];
    let (low, x, y) = (at(random), at(random), at(random));
    let size = halves::<S>(random, 2, 5);
    let (high, right, up) = (low.plus(size), x.plus(size), y.plus(halves(random, 2, 6)));
    match random.below(4) {
        0 => Polyhedron::extruded(axis, [[x, y], [right, y], [right, up], [x, up]], low, high),
        1 => Polyhedron::extruded(axis, [[x, y], [right, y], [x, up]], low, high),
        2 => {
            let round = |index: i32| {
                let angle = core::f64::consts::TAU * f64::from(index) / 10.0;
                [x.plus(S::near(angle.cos())), y.plus(S::near(angle.sin()))]
            };
            Polyhedron::extruded(
                axis,
                core::array::from_fn::<_, 10, _>(|i| round(i as i32)),
                low,
                high,
            )
        }
        _ => {
            // A box with a corner cut off.
            let cut = HalfSpace::facing(vector([1.0, 1.0, 1.0]), x.plus(y)).unwrap();
            let mut faces = Vec::new();
            for axis in Axis::ALL {
                faces.push(HalfSpace::below(axis, high).unwrap());
                faces.push(HalfSpace::above(axis, low).unwrap());
            }
            let cut = Polyhedron::<S, N, _>::bounded_by([&faces[..], &[cut]].concat());
            let whole = Polyhedron::<S, N, _>::bounded_by(faces);
            let faces = cut.or(whole).unwrap().faces().to_vec();
            of_faces(&faces)
        }
    }
    .unwrap()
}

/// The same as one of an array.
fn of_faces<S: Tested>(
    faces: &[HalfSpace<S>],
) -> Result<Polyhedron<S, N>, scancsg::solid::PolyhedronError> {
    // The last one again and again: a face that lies on another one changes nothing.
    let all = core::array::from_fn(|index| faces[index.min(faces.len() - 1)]);
    Polyhedron::bounded_by(all)
}

fn other<S: Tested>(random: &mut Random) -> (Own<S>, Part<S>) {
    let at = |random: &mut Random| halves::<S>(random, -3, 3);
    if random.chance(0.5) {
        let low = Vec3::new(at(random), at(random), at(random));
        let size = Vec3::new(halves(random, 1, 5), halves(random, 1, 5), halves(random, 1, 5));
        let cuboid = Cuboid::between(low, low + size).unwrap();
        (Own::Cuboid(cuboid), Part::Cuboid(cuboid))
    } else {
        let (axis, low) = (Axis::ALL[random.below(3)], at(random));
        let high = low.plus(halves(random, 1, 5));
        let middle = [at(random), at(random)];
        let cylinder = Cylinder::along(axis, middle, halves(random, 1, 4), low, high).unwrap();
        (Own::Cylinder(cylinder), Part::Cylinder(cylinder))
    }
}

fn cameras<S: Tested>(random: &mut Random) -> (Orthographic<S>, Perspective<S>) {
    let along = match random.below(3) {
        0 => [0.0, 0.0, -1.0],
        // Rays run along some faces, but not along the picture's axes.
        1 => [0.6, 0.0, -0.8],
        _ => [random.between(-1.0, 1.0), random.between(-0.5, 0.5), -1.0],
    };
    let up = vector([0.0, 1.0, 0.0]);
    let eye = vector(along.map(|way| -way * if random.chance(0.3) { 0.5 } else { 7.0 }));
    (
        Orthographic::look_along(vector(along), Vec3::ZERO, up, S::near(6.0)).unwrap(),
        Perspective::look_at(eye, Vec3::ZERO, up, S::ONE).unwrap(),
    )
}

/// Both pictures have the same spans, the same seen faces and the same pixels. Returns how many crossings there are.
fn same_pictures<S, A, B, C>(one: &A, other: &B, camera: &C) -> usize
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    A: Solid<Scalar = S> + Scan<C::Rays>,
    B: Solid<Scalar = S> + Scan<C::Rays>,
{
    let size = Size::new(28, 20).unwrap();
    let light = Lambert::new(vector::<S>([1.0, 2.0, 3.0]), S::near(0.25)).unwrap();
    let mut pictures = (
        Picture::new(one, camera, size, light, Rgb565::default()),
        Picture::new(other, camera, size, light, Rgb565::default()),
    );
    let mut rows = [[Rgb565::default(); 28]; 2];
    let mut crossings = 0;
    for y in (0..20).chain((0..20).rev().step_by(3)) {
        let (Ok(mut one), Ok(mut other)) = (pictures.0.scanline(y), pictures.1.scanline(y)) else {
            assert!(pictures.0.scanline(y).is_err() && pictures.1.scanline(y).is_err());
            return crossings;
        };
        for x in (0..28).chain((0..28).rev().step_by(3)) {
            let mut lists = (SpanList::<S, SPANS>::new(), SpanList::<S, SPANS>::new());
            let spans = one.spans(x, &mut lists.0);
            assert_eq!(spans, other.spans(x, &mut lists.1), "pixel {x}, {y}");
            assert_eq!(one.seen(x), other.seen(x), "pixel {x}, {y}");
            crossings += spans.len();
        }
        assert_eq!(one.render(&mut rows[0]), other.render(&mut rows[1]));
        assert_eq!(rows[0], rows[1], "row {y}");
    }
    crossings
}

fn compare<S: Tested>(arrays: &Arrays<S>, pools: &Pools<S>, random: &mut Random) -> usize
where
    Arrays<S>: Scan<OrthographicRays<S>, Scalar = S> + Scan<PerspectiveRays<S>>,
{
    let (orthographic, perspective) = cameras::<S>(random);
    let mut crossings = same_pictures(arrays, pools, &orthographic);
    crossings += same_pictures(arrays, pools, &perspective);
    assert_eq!(arrays.bounds(), pools.bounds());
    for _ in 0..30 {
        let [from, to] = [(); 2].map(|()| {
            Vec3::new(halves(random, -9, 9), halves(random, -9, 9), halves(random, -9, 9))
        });
        let Ok(ray) = Ray::new(from, to - from) else { continue };
        let mut lists = (SpanList::<S, SPANS>::new(), SpanList::<S, SPANS>::new());
        let spans = arrays.trace(&ray, &mut lists.0).unwrap();
        assert_eq!(spans, pools.trace(&ray, &mut lists.1).unwrap());
        crossings += spans.len();
        let hit = arrays.hit(&ray, &mut lists.0).unwrap();
        assert_eq!(hit, pools.hit(&ray, &mut lists.1).unwrap());
        if let Some(hit) = hit {
            assert_eq!(arrays.color(hit.face), pools.color(hit.face));
        }
    }
    // The bytes don't say where faces lie.
    let (mut one, mut other) = ([0; 4000], [0; 4000]);
    let bytes = arrays.to_bytes(&mut one).unwrap();
    assert_eq!(pools.to_bytes(&mut other).unwrap(), bytes);
    let read = Pools::<S>::from_bytes(bytes).unwrap();
    assert_eq!(read.to_bytes(&mut other).unwrap(), bytes);
    for part in 0..read.part_count() {
        assert_eq!(read.part(part), pools.part(part));
        match read.part(part).unwrap() {
            Part::Faces(_) => assert_eq!(read.faces(part), pools.faces(part)),
            _ => assert_eq!(read.faces(part).unwrap(), []),
        }
    }
    crossings
}

/// The program of the same parts and operators, as it is built and changed.
fn pools_are_arrays<S: Tested>() {
    let (mut crossings, mut refused) = (0, 0);
    for seed in 0..60 {
        let random = &mut Random::seeded(seed);
        let first = polyhedron(random);
        let (mut arrays, mut pools) =
            (Arrays::new(Own::Faces(first)), Pools::new(Part::Faces(Pooled::of(&first))));
        pools.set_faces(0, &first).unwrap();
        let turn = Pose::rotation_z(S::near(random.between(-2.0, 2.0))).unwrap();
        let shift = Pose::translation(vector([0.5, -0.5, 1.0])).unwrap();
        for pose in [turn, shift] {
            assert_eq!(arrays.add_pose(pose), pools.add_pose(pose));
        }
        for index in 1..1 + random.below(PARTS) {
            if random.chance(0.6) {
                let one = polyhedron(random);
                let was = pools;
                match pools.push_polyhedron(Part::Faces(Pooled::of(&one)), &one) {
                    Ok(_) => arrays.push(Own::Faces(one)).map(|_| ()).unwrap(),
                    Err(error) => {
                        assert_eq!((error, pools), (ProgramError::Faces, was));
                        refused += 1;
                        break;
                    }
                }
            } else {
                let (own, part) = other(random);
                assert_eq!(arrays.push(own), pools.push(part));
            }
            let pose = random.chance(0.4).then(|| random.below(POSES));
            assert_eq!(arrays.place(index, pose), pools.place(index, pose));
            let color = random.chance(0.5).then_some(Rgb::new(index as u8, 99, 200));
            assert_eq!(arrays.paint(index, color), pools.paint(index, color));
            if random.chance(0.6) {
                let same = match random.below(3) {
                    0 => arrays.unite(2) == pools.unite(2),
                    1 => arrays.intersect(2) == pools.intersect(2),
                    _ => arrays.subtract(1) == pools.subtract(1),
                };
                assert!(same);
            }
        }
        crossings += compare(&arrays, &pools, random);
        // One is removed: its faces are free again. Others are changed: to another polyhedron, to none, to one.
        let part = random.below(arrays.part_count());
        assert_eq!(arrays.remove(part), pools.remove(part));
        for part in 0..arrays.part_count() {
            let one = polyhedron(random);
            let (own, leaf) = match random.below(3) {
                0 => other(random),
                1 if pools.set_faces(part, &one).is_ok() => {
                    (Own::Faces(one), Part::Faces(Pooled::of(&one)))
                }
                _ => continue,
            };
            (*arrays.part_mut(part).unwrap(), *pools.part_mut(part).unwrap()) = (own, leaf);
        }
        let pose = Pose::rotation_x(S::near(0.5)).unwrap();
        assert_eq!(arrays.set_pose(0, pose), pools.set_pose(0, pose));
        crossings += compare(&arrays, &pools, random);
    }
    assert!(crossings > 10_000 && refused > 3, "{crossings}, {refused}");
}

/// The same polyhedra in a typed tree, painted and moved.
fn typed_trees_are_pools<S: Tested>() {
    for seed in 0..25 {
        let random = &mut Random::seeded(seed);
        let [a, b, c, d] = [(); 4].map(|()| polyhedron::<S>(random));
        let (red, pose) = (Rgb::new(200, 0, 0), Pose::rotation_y(S::near(0.75)).unwrap());
        let white = |solid| Painted::new(solid, Rgb::WHITE);
        let tree = Difference::new(
            Union::new(Painted::new(a, red), Placed::new(white(b), pose)),
            Union::new(white(c), Placed::new(white(d), pose)),
        );
        let mut program = Program::<Pooled<S, N>, 4, 1, SPANS, 48>::new(Pooled::of(&a));
        program.set_faces(0, &a).unwrap();
        program.add_pose(pose).unwrap();
        for (index, one) in [(1, b), (2, c), (3, d)] {
            assert_eq!(program.push_polyhedron(Pooled::of(&one), &one), Ok(index));
            if index != 2 {
                program.unite(2).unwrap();
            }
        }
        program.subtract(1).unwrap();
        for part in 0..4 {
            program.paint(part, Some(if part == 0 { red } else { Rgb::WHITE })).unwrap();
            program.place(part, (part % 2 == 1).then_some(0)).unwrap();
        }
        let (orthographic, perspective) = cameras::<S>(random);
        same_pictures(&tree, &program, &orthographic);
        same_pictures(&tree, &program, &perspective);
        for _ in 0..50 {
            let far = if random.chance(0.2) { 900.0 } else { 4.0 };
            let from = [(); 3].map(|()| random.between(-far, far));
            let way = from.map(|from| random.between(-2.0, 2.0) - from);
            let Ok(ray) = Ray::new(vector(from), vector(way)) else { continue };
            let mut lists = (SpanList::<S, SPANS>::new(), SpanList::<S, SPANS>::new());
            assert_eq!(program.trace(&ray, &mut lists.0), Ok(tree.trace(&ray, &mut lists.1)));
            assert_eq!(program.hit(&ray, &mut lists.0), Ok(tree.hit(&ray, &mut lists.1)));
        }
    }
}

fn square<const M: usize>(size: f32) -> Polyhedron<f32, M> {
    let square = [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]];
    Polyhedron::extruded(Axis::Z, square, 0.0, 1.0).unwrap()
}

/// In a constant, faces lie in flash with the parts.
#[test]
fn pools_are_made_in_constants() {
    const WEDGE: Polyhedron<f32, 5> = constant!(Polyhedron::<f32, 5>::prism(
        Axis::Z,
        [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]],
        0.0,
        1.0
    ));
    static PAIR: Program<Part<f32>, 2, 0, 8, 10> = {
        let mut pair = Program::new(Part::Faces(Pooled::of(&WEDGE)));
        assert!(pair.set_faces(0, &WEDGE).is_ok());
        assert!(pair.push_polyhedron(Part::Faces(Pooled::of(&WEDGE)), &WEDGE).is_ok());
        pair
    };
    assert_eq!(<Program<Part<f32>, 2, 0, 8, 10> as Shape>::FACES, 24);
    assert_eq!(PAIR.faces(1), Ok(WEDGE.faces()));
    let ray = Ray::new(vec3(0.5, 0.25, 5.0), vec3(0.0, 0.0, -1.0)).unwrap();
    let hit = PAIR.hit(&ray, &mut SpanList::<f32, 8>::new()).unwrap().unwrap();
    assert_eq!((hit.t, hit.face, hit.normal), (4.0, Face(4), vec3(0.0, 0.0, 1.0)));
}

/// What has no room is an error, and changes nothing.
#[test]
fn faces_without_room_are_an_error() {
    let six = square::<6>(1.0);
    let many = of_faces::<f32>(six.faces()).unwrap();
    let leaf = Part::Faces(Pooled::of(&six));
    let mut program = Program::<Part<f32>, 3, 0, 8, 20>::new(leaf);
    let mut small = Program::<Pooled<f32, 6>, 3, 0, 8, 20>::new(Pooled::of(&six));
    assert_eq!(small.set_faces(0, &many), Err(ProgramError::Faces), "a leaf has 6");
    assert_eq!(small.push_polyhedron(Pooled::of(&many), &many), Err(ProgramError::Faces));
    assert_eq!(program.set_faces(0, &many), Ok(()));
    assert_eq!(program.push_polyhedron(leaf, &six), Ok(1));
    let was = program;
    assert_eq!(program.push_polyhedron(leaf, &six), Err(ProgramError::Faces), "18 of 20");
    assert_eq!(program.set_faces(1, &many), Err(ProgramError::Faces), "24 of 20");
    assert_eq!(program.set_faces(2, &six), Err(ProgramError::NoPart));
    assert_eq!(program.faces(2), Err(ProgramError::NoPart));
    assert_eq!(program, was);
    // Fewer faces of one leave room for another's.
    assert_eq!(program.set_faces(0, &six), Ok(()));
    assert_eq!(program.push_polyhedron(leaf, &six), Ok(2));
    assert!((0..3).all(|part| program.faces(part) == Ok(six.faces())));
    let mut full = Program::<Part<f32>, 1, 0, 8, 20>::new(leaf);
    assert_eq!(full.push_polyhedron(leaf, &six), Err(ProgramError::Parts));
    let mut without = Program::<Part<f32>, 2>::new(leaf);
    assert_eq!(without.push_polyhedron(leaf, &six), Err(ProgramError::Faces));
}

/// A leaf that no faces were given to is empty, as is one that isn't a part of a program.
#[test]
fn without_faces_there_is_nothing() {
    let six = square::<6>(1.0);
    let leaf = Part::Faces(Pooled::of(&six));
    let cylinder = Cylinder::<f32>::along_z(0.5, 0.5, 0.25, 0.0, 2.0).unwrap();
    let mut program = Program::<Part<f32>, 2, 0, 8, 20>::new(Part::Cylinder(cylinder));
    program.push(leaf).unwrap();
    let camera = Orthographic::look_along(
        vec3(0.1, 0.2, -1.0),
        vec3(0.5, 0.5, 0.5),
        vec3(0.0, 1.0, 0.0),
        3.0,
    );
    let eye = Perspective::look_at(vec3(3.0, 1.0, 4.0), Vec3::ZERO, vec3(0.0, 1.0, 0.0), 1.0);
    let alone = Part::Cylinder(cylinder);
    assert!(same_pictures(&program, &alone, camera.as_ref().unwrap()) > 10);
    assert!(same_pictures(&program, &alone, eye.as_ref().unwrap()) > 10);
    let typed = Union::new(cylinder, Painted::new(Pooled::<f32, 6>::of(&six), Rgb::WHITE));
    assert!(same_pictures(&typed, &alone, camera.as_ref().unwrap()) > 10);
    let ray = Ray::new(vec3(0.9, 0.9, 5.0), vec3(0.0, 0.0, -1.0)).unwrap();
    let mut list = SpanList::<f32, 8>::new();
    assert_eq!(program.hit(&ray, &mut list), Ok(None));
    assert_eq!(program.to_bytes(&mut [0; 200]), Err(BytesError::Solid));
    // Faces of a part that is no polyhedron wait until it is one.
    program.set_faces(1, &six).unwrap();
    assert!(program.hit(&ray, &mut list).unwrap().is_some());
    *program.part_mut(1).unwrap() = alone;
    assert_eq!(program.hit(&ray, &mut list), Ok(None));
    assert!(same_pictures(&program, &alone, camera.as_ref().unwrap()) > 10);
}

/// Which leaf a polyhedron of bytes becomes, and what is refused.
#[test]
fn bytes_go_to_the_pool_where_a_leaf_has_no_room() {
    scancsg::leaves! {
        enum Both<S> {
            Few(Polyhedron<S, 6>),
            Many(Pooled<S, 20>),
            Wide(Scaled<Pooled<S, 20>>),
        }
    }
    type Read<const POOL: usize> = Program<Both<f32>, 3, 0, 8, POOL>;
    let six = square::<6>(1.0);
    let many = of_faces::<f32>(six.faces()).unwrap();
    let mut given = Program::<Polyhedron<f32, 12>, 3>::new(many);
    given.push(square(2.0)).unwrap();
    given.push(many).unwrap();
    let (mut buffer, mut again) = ([0; 2000], [0; 2000]);
    let bytes = given.to_bytes(&mut buffer).unwrap();
    let read = Read::<24>::from_bytes(bytes).unwrap();
    let of_part = |part| (read.part(part).unwrap(), read.faces(part).unwrap().len());
    assert!(matches!(of_part(0), (Both::Many(_), 12)));
    assert!(matches!(of_part(1), (Both::Few(_), 0)));
    assert!(matches!(of_part(2), (Both::Many(_), 12)));
    assert_eq!(read.to_bytes(&mut again), Ok(bytes));
    // A face too many for the pool: what was read before stays.
    let mut small = Read::<23>::new(Both::Few(six));
    let was = small;
    assert_eq!(small.read_bytes(bytes), Err(BytesError::Tree));
    assert_eq!(small, was);
    assert_eq!(Read::<0>::from_bytes(bytes).map(|_| ()), Err(BytesError::Tree));
    let few = Program::<Polyhedron<f32, 6>, 3>::from_bytes(bytes).map(|_| ());
    assert_eq!(few, Err(BytesError::Kind), "no leaf has so many");
    // What was read first leaves no faces behind.
    let mut read = read;
    let one = Program::<Polyhedron<f32, 12>, 1>::new(many);
    let bytes = one.to_bytes(&mut buffer).unwrap();
    read.read_bytes(bytes).unwrap();
    assert_eq!(read.faces(0), Ok(many.faces()));
    assert_eq!(read.push_polyhedron(Both::Many(Pooled::of(&many)), &many), Ok(1));
    // A scaled one has no pool.
    let map = scancsg::geom::AffineMap::scaling([2.0, 1.0, 1.0]).unwrap();
    let wide = Program::<_, 1>::new(Scaled::new(many, map));
    let bytes = wide.to_bytes(&mut buffer).unwrap();
    assert_eq!(Read::<24>::from_bytes(bytes).map(|_| ()), Err(BytesError::Kind));
    let wide = Both::Wide(Scaled::new(Pooled::of(&many), map));
    assert_eq!(Read::<24>::new(wide).to_bytes(&mut again), Err(BytesError::Solid));
}
