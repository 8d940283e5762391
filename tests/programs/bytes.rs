//! Programs as bytes: what is written is read again, bit for bit; the document's example is read; and whatever
//! else is read is an error or a program, never a panic.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use scancsg::constant;
use scancsg::geom::{AffineMap, Axis, Pose, Ray, Vec3, vec3};
use scancsg::program::{BytesError, Program};
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
use scancsg::solid::{
    Cone, Cuboid, Cylinder, HalfSpace, Polyhedron, Pooled, Rgb, Scaled, Sphere, Torus,
};
use scancsg::span::SpanList;
use testkit::number::{Tested, vector};
use testkit::random::Random;

for_every_number!(what_is_written_is_read, hostile_bytes_are_errors_or_programs);

scancsg::leaves! {
    /// All solids that have a form as bytes.
    enum Part<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Cone(Cone<S>),
        Torus(Torus<S>),
        Half(HalfSpace<S>),
        Convex(Polyhedron<S, 6>),
        Faces(Pooled<S, 16>),
        Drum(Scaled<Cylinder<S>>),
        Egg(Scaled<Sphere<S>>),
        Wedge(Scaled<Polyhedron<S, 6>>),
    }
}

type Small<S> = Program<Part<S>, 10, 3, 32, 40>;

fn part<S: Tested>(random: &mut Random) -> Part<S> {
    let mut number = |low, high| S::near(random.between(low, high));
    let (low, size) = (number(-2.0, 1.0), number(0.1, 2.0));
    let ends = [low, low.plus(size)];
    let center = Vec3::new(number(-2.0, 2.0), number(-2.0, 2.0), number(-2.0, 2.0));
    let way = Vec3::new(number(-2.0, 2.0), number(-2.0, 2.0), number(0.5, 2.0));
    let radius = number(0.5, 2.0);
    let axis = Axis::ALL[random.below(3)];
    let middle = [center.x, center.y];
    let triangle = || {
        let [x, y, z] = [S::ZERO, size, radius];
        Polyhedron::extruded(axis, [[x, x], [y, x], [x, z]], ends[0], ends[1]).unwrap()
    };
    let (zero, slant) = (S::ZERO, radius.negated());
    let columns = [[size, zero, slant], [zero, radius, zero], [size, zero, size]].map(Vec3::from);
    let map = AffineMap::with_columns(columns, center).unwrap();
    match random.below(13) {
        0 => Part::Cylinder(Cylinder::along(axis, middle, radius, ends[0], ends[1]).unwrap()),
        1 => Part::Cylinder(Cylinder::from_to(center, center + way, radius).unwrap()),
        2 => Part::Cuboid(Cuboid::around(center, Vec3::new(size, radius, size)).unwrap()),
        3 => Part::Sphere(Sphere::around(center, radius).unwrap()),
        4 => {
            let radii = if random.chance(0.5) { [S::ZERO, radius] } else { [radius, size] };
            Part::Cone(Cone::along(axis, middle, radii, ends[0], ends[1]).unwrap())
        }
        5 => Part::Cone(Cone::from_to(center, center + way, [radius, size]).unwrap()),
        6 => Part::Torus(Torus::around(center, way, radius, S::near(0.25)).unwrap()),
        7 => Part::Half(HalfSpace::facing(way, low).unwrap()),
        8 => Part::Convex(triangle()),
        9 => {
            let drum = Cylinder::along(axis, middle, radius, ends[0], ends[1]).unwrap();
            Part::Drum(Scaled::new(drum, map))
        }
        10 => Part::Egg(Scaled::new(Sphere::around(center, radius).unwrap(), map)),
        11 => Part::Wedge(Scaled::new(triangle(), map)),
        _ => Part::Half(HalfSpace::above(axis, low).unwrap()),
    }
}

/// With more faces than a leaf has room for.
fn drum<S: Tested>(random: &mut Random) -> Polyhedron<S, 16> {
    fn round<S: Tested, const M: usize>(size: f64) -> [[S; 2]; M] {
        core::array::from_fn(|index| {
            let angle = core::f64::consts::TAU * index as f64 / M as f64;
            [size * angle.cos(), size * angle.sin()].map(S::near)
        })
    }
    let (size, axis) = (random.between(0.5, 2.0), Axis::ALL[random.below(3)]);
    let (low, high) = (S::ZERO, S::near(size));
    match random.chance(0.5) {
        true => Polyhedron::extruded(axis, round::<S, 6>(size), low, high),
        false => Polyhedron::extruded(axis, round::<S, 14>(size), low, high),
    }
    .unwrap()
}

fn program<S: Tested>(random: &mut Random) -> Small<S> {
    let mut program = Small::new(part(random));
    let shift = vector([random.between(-9.0, 9.0), 1.0, 2.0]);
    let shift = Pose::translation(shift).unwrap();
    let turn = Pose::about(vector(random.direction()), S::near(random.between(-3.0, 3.0)));
    for pose in [shift, turn.unwrap().then(&shift).unwrap()] {
        if random.chance(0.7) {
            program.add_pose(pose).unwrap();
        }
    }
    for _ in 0..random.below(10) {
        let drum = drum::<S>(random);
        // The pool has room for some.
        if random.chance(0.7)
            || program.push_polyhedron(Part::Faces(Pooled::of(&drum)), &drum).is_err()
        {
            program.push(part(random)).unwrap();
        }
        if random.chance(0.6) {
            match random.below(3) {
                0 => program.unite(2),
                1 => program.intersect(2),
                _ => program.subtract(1),
            }
            .unwrap();
        }
    }
    for index in 0..program.part_count() {
        if random.chance(0.4) {
            program.paint(index, Some(Rgb::new(index as u8, 0xf0, 0xff))).unwrap();
        }
        if random.chance(0.4) {
            // Not every program has a pose.
            let _ = program.place(index, Some(0));
        }
    }
    program
}

/// Every program is the same again, and has the same bytes again.
fn what_is_written_is_read<S: Tested>() {
    for seed in 0..300 {
        let random = &mut Random::seeded(seed);
        let program = program::<S>(random);
        let (mut buffer, mut again) = ([0; 4000], [0; 4000]);
        let bytes = program.to_bytes(&mut buffer).unwrap();
        let read = Small::<S>::from_bytes(bytes).unwrap();
        assert_eq!(read.to_bytes(&mut again).unwrap(), bytes);
        // Behind the last part, an array may have what was there before.
        let parts = |of: &Small<S>| -> Vec<Part<S>> {
            (0..of.part_count()).map(|index| *of.part(index).unwrap()).collect()
        };
        assert_eq!(parts(&read), parts(&program));
        for part in 0..program.part_count() {
            assert_eq!(read.faces(part), program.faces(part));
            let is_pooled = matches!(read.part(part).unwrap(), Part::Faces(_));
            assert_eq!(read.faces(part).unwrap().len() > 6, is_pooled);
        }
        assert_eq!(read.operand_count(), program.operand_count());
        for length in 0..bytes.len() {
            assert!(Small::<S>::from_bytes(&bytes[..length]).is_err());
            assert_eq!(program.to_bytes(&mut again[..length]), Err(BytesError::Length));
        }
    }
}

/// A byte or two of a program are changed: what is read then, if anything is, can be pictured and traced.
fn hostile_bytes_are_errors_or_programs<S: Tested>() {
    let mut counts = [0; 2];
    for seed in 0..1500 {
        let random = &mut Random::seeded(seed);
        let mut buffer = [0; 4000];
        let length = program::<S>(random).to_bytes(&mut buffer).unwrap().len();
        let bytes = &mut buffer[..length];
        for _ in 0..1 + random.below(3) {
            let at = random.below(length);
            bytes[at] = match random.below(4) {
                0 => bytes[at] ^ (1 << random.below(8)),
                1 => 0xf0 + random.below(3) as u8,
                2 => 0xff,
                _ => random.below(256) as u8,
            };
        }
        let Ok(read) = Small::<S>::from_bytes(bytes) else {
            counts[0] += 1;
            continue;
        };
        counts[1] += 1;
        let mut again = [0; 4000];
        // An axis that was written in full may be a coordinate axis now, which is shorter.
        let written = read.to_bytes(&mut again).unwrap();
        assert!(written.len() <= length);
        let same = Small::<S>::from_bytes(written).unwrap();
        let mut twice = [0; 4000];
        assert_eq!(same.to_bytes(&mut twice).unwrap(), written);
        let (along, up) = (vector([0.3, -0.2, -1.0]), vector([0.0, 1.0, 0.0]));
        let camera = Orthographic::look_along(along, Vec3::ZERO, up, S::near(6.0)).unwrap();
        let light = Lambert::new(vector::<S>([1.0, 2.0, 3.0]), S::near(0.25)).unwrap();
        let size = Size::new(8, 6).unwrap();
        let mut picture = Picture::new(&read, &camera, size, light, Gray8(0));
        for y in 0..6 {
            picture.scanline(y).unwrap().render(&mut [Gray8(0); 8]).unwrap();
        }
        let ray = Ray::new(vector(random.point(8.0)), along).unwrap();
        let _ = read.hit(&ray, &mut SpanList::<S, 32>::new());
    }
    assert!(counts.iter().all(|count| *count > 100), "{counts:?}");
}

/// Bytes that are no program from the beginning.
#[test]
fn noise_is_an_error() {
    let random = &mut Random::seeded(7);
    for _ in 0..20_000 {
        let length = random.below(60);
        let mut bytes: Vec<u8> = (0..length).map(|_| random.below(256) as u8).collect();
        if random.chance(0.9) && length >= 8 {
            bytes[..8].copy_from_slice(&[b'S', b'P', 1, 32, length as u8, 0, 0, 0]);
        }
        assert!(Small::<f32>::from_bytes(&bytes).is_err());
    }
}

/// The bytes in the document are what it says.
#[test]
fn the_documents_example_is_read() {
    let text = include_str!("../../docs/program.md");
    let (_, example) = text.split_once("```text\n").unwrap();
    let (example, _) = example.split_once("```").unwrap();
    let is_byte = |word: &&str| word.len() == 2 && u8::from_str_radix(word, 16).is_ok();
    let bytes: Vec<u8> = example
        .lines()
        .flat_map(|line| line.split_whitespace().take_while(is_byte))
        .map(|byte| u8::from_str_radix(byte, 16).unwrap())
        .collect();
    let plate = Cuboid::<f32>::new(vec3(-2.0, -1.0, 0.0), vec3(2.0, 1.0, 0.5)).unwrap();
    let mut wanted = Small::new(Part::Cuboid(plate));
    let hole = Cylinder::<f32>::along_z(0.0, 0.0, 0.5, -1.0, 1.0).unwrap();
    let hole = wanted.push(Part::Cylinder(hole)).unwrap();
    wanted.paint(hole, Some(Rgb::new(255, 0, 0))).unwrap();
    wanted.subtract(1).unwrap();
    let mut buffer = [0; 100];
    assert_eq!(wanted.to_bytes(&mut buffer).unwrap(), bytes);
    let read = Small::<f32>::from_bytes(&bytes).unwrap();
    assert_eq!(read.part_count(), 2);
}

/// A scaled solid's bytes, one by one; what is inside decides which one it is.
#[test]
fn scaled_solids_have_a_map_and_a_solid() {
    let columns = [vec3(1.0, 0.0, 0.0), vec3(0.5, 2.0, 0.0), vec3(0.0, 0.0, -1.0)];
    let map = AffineMap::<f32>::new(columns, vec3(3.0, 4.0, 5.0)).unwrap();
    let ball = Sphere::<f32>::new(vec3(0.0, 1.0, 0.0), 2.0).unwrap();
    let egg = Program::<Part<f32>, 2>::new(Part::Egg(Scaled::new(ball, map)));
    let mut buffer = [0; 100];
    let bytes = egg.to_bytes(&mut buffer).unwrap();
    let mut wanted = vec![b'S', b'P', 1, 32, 75, 0, 0, 0, 8, 0];
    let rows = [[1.0, 0.5, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, -1.0], [3.0, 4.0, 5.0]];
    wanted.extend(rows.as_flattened().iter().copied().flat_map(f32::to_le_bytes));
    wanted.push(3);
    wanted.extend([0.0, 1.0, 0.0, 2.0].into_iter().flat_map(f32::to_le_bytes));
    assert_eq!(bytes, wanted);
    assert_eq!(Program::from_bytes(bytes), Ok(egg));
    let read = |changes: &[(usize, u8)]| {
        let mut bytes = wanted.clone();
        changes.iter().for_each(|&(at, byte)| bytes[at] = byte);
        Program::<Part<f32>, 2>::from_bytes(&bytes).map(|_| ())
    };
    let (matrix, inner) = (10, 10 + 12 * 4);
    assert_eq!(read(&[(inner, 2)]), Err(BytesError::Kind), "no scaled box is named");
    assert_eq!(read(&[(inner, 8)]), Err(BytesError::Kind));
    assert_eq!(read(&[(inner, 0xf0)]), Err(BytesError::Kind));
    assert_eq!(read(&[(inner, 1)]), Err(BytesError::Length), "a cylinder has more numbers");
    assert_eq!(read(&[(matrix + 2, 0), (matrix + 3, 0)]), Err(BytesError::Solid), "a flat map");
    assert_eq!(read(&[(matrix + 3, 0xff)]), Err(BytesError::Solid), "an infinite one");
    assert_eq!(read(&[(inner - 1, 0x7f)]), Err(BytesError::Solid), "one that shifts too far");
}

/// A map has more digits than numbers of fixed point have: what would be another map isn't written.
#[test]
fn a_map_between_two_numbers_is_not_written() {
    use scancsg::scalar::{I16F16, Scalar as _};
    let number = I16F16::from_ratio;
    let third = AffineMap::scaling([(); 3].map(|()| number(1, 3))).unwrap();
    let ball = Sphere::around(Vec3::ZERO, number(1, 1)).unwrap();
    let mut program = Program::<Part<I16F16>, 1>::new(Part::Egg(Scaled::new(ball, third)));
    let mut buffer = [0; 100];
    assert!(program.to_bytes(&mut buffer).is_ok());
    let ninth = third.then(&third).unwrap();
    *program.part_mut(0).unwrap() = Part::Egg(Scaled::new(ball, ninth));
    assert_eq!(program.to_bytes(&mut buffer), Err(BytesError::Solid));
}

/// A program that is larger than the stack is read where it is. One that can't be read stays as it was.
#[test]
fn large_programs_are_read_in_place() {
    scancsg::leaves! {
        enum Many<S> {
            Ball(Sphere<S>),
            Faces(Polyhedron<S, 64>),
        }
    }
    type Large = Program<Many<f32>, 256, 64, 64>;
    const BALL: Sphere<f32> = constant!(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0));
    const STACK: usize = 128 << 10;
    assert!(size_of::<Large>() > 2 * STACK);
    let thread = |stack| std::thread::Builder::new().stack_size(stack);

    /// A program with room for one part, and bytes of as many as those of the large one.
    fn bytes(count: usize) -> Vec<u8> {
        let round = |index: i32| {
            let angle = core::f64::consts::TAU * f64::from(index) / 62.0;
            [angle.cos() as f32, angle.sin() as f32]
        };
        let rod = core::array::from_fn::<_, 62, _>(|index| round(index as i32));
        let rod = Polyhedron::extruded(Axis::Z, rod, -1.0, 1.0).unwrap();
        let mut buffer = vec![0; 4000];
        let one = Program::<Many<f32>, 1>::new(Many::Faces(rod));
        let one = one.to_bytes(&mut buffer).unwrap();
        let (head, part) = one.split_at(8);
        let mut bytes = head.to_vec();
        (0..count).for_each(|_| bytes.extend_from_slice(part));
        let length = bytes.len() as u16;
        bytes[4..6].copy_from_slice(&length.to_le_bytes());
        bytes
    }

    let parts = 50;
    let bytes = bytes(parts);
    let make = || Box::new(Large::new(Many::Ball(BALL)));
    let mut boxed = thread(64 << 20).spawn(make).unwrap().join().unwrap();
    let read = move || {
        boxed.read_bytes(&bytes).unwrap();
        assert_eq!(boxed.part_count(), parts);
        // A ray meets the end of all rods at once.
        let ray = Ray::new(vec3(0.25, 0.125, 9.0), vec3(0.0, 0.0, -1.0)).unwrap();
        let hit = boxed.hit(&ray, &mut SpanList::<f32, 64>::new()).unwrap().unwrap();
        assert_eq!((hit.t, hit.normal), (8.0, vec3(0.0, 0.0, 1.0)));
        // Bytes that are wrong at their end.
        let mut wrong = bytes.clone();
        let last = wrong.len() - 1;
        wrong[last] = 0xff;
        let mut buffer = vec![0; bytes.len()];
        assert_eq!(boxed.read_bytes(&wrong), Err(BytesError::Solid));
        assert_eq!(boxed.to_bytes(&mut buffer).unwrap(), bytes);
        boxed
    };
    let boxed = thread(STACK).spawn(read).unwrap().join().unwrap();
    // All rods are one: the picture is that of the first.
    let show = move || {
        let one = *boxed.part(0).unwrap();
        let along = vector([0.3, -0.2, -1.0]);
        let up = vector([0.0, 1.0, 0.0]);
        let camera = Orthographic::look_along(along, Vec3::ZERO, up, 3.0).unwrap();
        let light = Lambert::new(vector::<f32>([1.0, 2.0, 3.0]), 0.25).unwrap();
        let size = Size::new(40, 30).unwrap();
        let mut many = Picture::new(&*boxed, &camera, size, light, Gray8(0));
        let mut single = Picture::new(&one, &camera, size, light, Gray8(0));
        let (mut rows, mut lit) = ([[Gray8(0); 40]; 2], 0);
        for y in 0..30 {
            many.scanline(y).unwrap().render(&mut rows[0]).unwrap();
            single.scanline(y).unwrap().render(&mut rows[1]).unwrap();
            assert_eq!(rows[0], rows[1], "row {y}");
            lit += rows[0].iter().filter(|pixel| pixel.0 > 0).count();
        }
        assert!((300..600).contains(&lit), "{lit}");
        println!("{} bytes, and {} in a picture", size_of::<Large>(), size_of_val(&many));
    };
    thread(64 << 20).spawn(show).unwrap().join().unwrap();
}

/// Each thing that can be wrong, by its name.
#[test]
fn every_error_has_its_cause() {
    let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0).unwrap();
    let mut program = Small::new(Part::Sphere(ball));
    program.add_pose(Pose::<f32>::rotation_x(0.5).unwrap()).unwrap();
    program.place(0, Some(0)).unwrap();
    let mut buffer = [0; 100];
    let good = program.to_bytes(&mut buffer).unwrap().to_vec();
    let part = 8 + 1 + 12 * 4;
    let read = |changes: &[(usize, u8)]| {
        let mut bytes = good.clone();
        changes.iter().for_each(|&(at, byte)| bytes[at] = byte);
        Small::<f32>::from_bytes(&bytes).map(|_| ())
    };
    assert_eq!(read(&[]), Ok(()));
    assert_eq!(read(&[(0, 0)]), Err(BytesError::Magic));
    assert_eq!(read(&[(2, 2)]), Err(BytesError::Version));
    assert_eq!(read(&[(3, 16)]), Err(BytesError::Number));
    assert_eq!(read(&[(4, 1)]), Err(BytesError::Length));
    assert_eq!(read(&[(6, 4)]), Err(BytesError::Tree));
    assert_eq!(read(&[(7, 1)]), Err(BytesError::Tag));
    assert_eq!(read(&[(8, 2)]), Err(BytesError::Tag));
    assert_eq!(read(&[(9 + 3, 0x40)]), Err(BytesError::Pose), "an axis of length 2");
    assert_eq!(read(&[(part, 0xf0)]), Err(BytesError::Tag), "nothing is there to unite");
    assert_eq!(read(&[(part, 99)]), Err(BytesError::Kind));
    assert_eq!(read(&[(part + 1, 4)]), Err(BytesError::Tag));
    assert_eq!(read(&[(part + 2, 1)]), Err(BytesError::Pose), "there is one pose");
    let radius = good.len() - 4;
    assert_eq!(read(&[(radius + 3, 0xbf)]), Err(BytesError::Solid), "a radius of -1");
    assert_eq!(read(&[(radius + 3, 0x7f), (radius + 2, 0xc0)]), Err(BytesError::Solid));
    let mut long = good.clone();
    long.push(0xf0);
    long[4] += 1;
    assert_eq!(Small::<f32>::from_bytes(&long).map(|_| ()), Err(BytesError::Tree));
    let one = Program::<Part<f32>, 1>::from_bytes(&good);
    assert_eq!(one.map(|_| ()), Err(BytesError::Tree), "it has room for no pose");
}
