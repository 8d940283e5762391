//! Programs: trees built at run time have the bits of the merge of their leaves' spans, and those of typed
//! trees of the same solids; they are built and changed as they say, and nothing else.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use scancsg::geom::{AffineMap, Axis, Line, Pose, Ray, Rays, Vec3, vec3};
use scancsg::program::{LineError, Program, ProgramError};
use scancsg::render::{Camera, Lambert, Orthographic, Perspective, Picture, Rgb565, Size};
use scancsg::scalar::Scalar;
use scancsg::solid::{
    Bounds, Cuboid, Cylinder, Difference, HalfSpace, Intersection, Painted, Placed, RayCast, Rgb,
    Scaled, Scan, Solid, Sphere, Torus, Union, first_seen,
};
use scancsg::span::{Crossing, Face, Operation, Shape, Span, SpanList, SpanStack, merge};
use testkit::number::{Tested, ball, vector};
use testkit::random::Random;

for_every_number!(
    random_programs_are_the_merge_of_their_leaves,
    typed_trees_are_programs,
    programs_are_operands,
    a_removed_part_was_never_there,
);

scancsg::leaves! {
    /// What these programs are made of: one leaf may have two spans, one may have no end.
    enum Part<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Torus(Torus<S>),
        Half(HalfSpace<S>),
    }
}

const PARTS: usize = 12;
const POSES: usize = 2;
const SPANS: usize = 64;
const FACES: u16 = 6;

type Tested12<S> = Program<Part<S>, PARTS, POSES, SPANS>;

/// A tree whose leaves are counted from left to right.
#[derive(Debug, Clone)]
enum Tree {
    Leaf(usize),
    Of(Operation, Vec<Tree>),
}

impl Tree {
    /// A tree of so many leaves, the first of which is `first`.
    fn random(random: &mut Random, first: usize, count: usize) -> Self {
        if count == 1 {
            return Self::Leaf(first);
        }
        let operation = [Operation::UNION, Operation::INTERSECTION, Operation::DIFFERENCE];
        let (mut operands, mut next) = (Vec::new(), first);
        while next < first + count {
            // No operand has all leaves.
            let left = first + count - next;
            let most = left.min(count - 1);
            let most = if random.chance(0.5) { most.min(2) } else { most };
            let take = 1 + random.below(most);
            operands.push(Self::random(random, next, take));
            next += take;
        }
        Self::Of(operation[random.below(3)], operands)
    }

    /// Pushes the tree's parts, and combines them by operators with as many operands as there are.
    fn build<S: Tested>(&self, scene: &Scene<S>, program: &mut Tested12<S>) {
        match self {
            Self::Leaf(0) => scene.dress(0, program), // is there already
            Self::Leaf(index) => {
                assert_eq!(program.push(scene.parts[*index].part), Ok(*index));
                scene.dress(*index, program);
            }
            Self::Of(operation, operands) => {
                for operand in operands {
                    operand.build(scene, program);
                }
                match *operation {
                    Operation::UNION => program.unite(operands.len()),
                    Operation::INTERSECTION => program.intersect(operands.len()),
                    _ => program.subtract(operands.len() - 1),
                }
                .unwrap();
            }
        }
    }

    /// The merge of the leaves' spans.
    fn merged<S: Scalar>(&self, of: &mut impl FnMut(usize) -> Vec<Span<S>>) -> Vec<Span<S>> {
        match self {
            Self::Leaf(index) => of(*index),
            Self::Of(operation, operands) => {
                let mut lists = operands.iter().map(|operand| operand.merged(of));
                let first = lists.next().unwrap();
                lists.fold(first, |left, right| {
                    let mut list = SpanList::<S, 128>::new();
                    let mut stack = list.stack();
                    left.iter().chain(&right).for_each(|span| stack.push(*span).unwrap());
                    merge(*operation, &mut stack, 0, left.len()).unwrap();
                    list.to_vec()
                })
            }
        }
    }
}

#[derive(Debug, Clone, Copy)]
struct Dressed<S: Scalar> {
    part: Part<S>,
    pose: Option<usize>,
    color: Option<Rgb>,
}

/// The parts of a program, and the frames they stand in.
struct Scene<S: Scalar> {
    parts: Vec<Dressed<S>>,
    poses: [Pose<S>; POSES],
}

/// A number of a grid of halves.
fn halves<S: Tested>(random: &mut Random, low: i32, high: i32) -> S {
    S::near(f64::from(low + random.below((high - low + 1) as usize) as i32) / 2.0)
}

fn random_part<S: Tested>(random: &mut Random) -> Part<S> {
    let axis = Axis::ALL[random.below(3)];
    let at = |random: &mut Random| halves::<S>(random, -3, 3);
    let longer = |random: &mut Random, low: S| low.plus(halves(random, 1, 5));
    match random.below(9) {
        0 => {
            let offset = at(random);
            Part::Half(HalfSpace::below(axis, offset).unwrap())
        }
        1 => {
            let center = Vec3::new(at(random), at(random), at(random));
            let ring = halves(random, 2, 4);
            Part::Torus(Torus::along(axis, center, ring, S::near(0.25)).unwrap())
        }
        2 | 3 => {
            let center = Vec3::new(at(random), at(random), at(random));
            Part::Sphere(Sphere::around(center, halves(random, 1, 4)).unwrap())
        }
        4 | 5 => {
            let low = Vec3::new(at(random), at(random), at(random));
            let [x, y, z] = low.to_array().map(|low| longer(random, low));
            Part::Cuboid(Cuboid::between(low, Vec3::new(x, y, z)).unwrap())
        }
        _ => {
            let (middle, low) = ([at(random), at(random)], at(random));
            let (radius, high) = (halves(random, 1, 4), longer(random, low));
            Part::Cylinder(Cylinder::along(axis, middle, radius, low, high).unwrap())
        }
    }
}

impl<S: Tested> Scene<S> {
    fn random(random: &mut Random, count: usize) -> Self {
        let shift = Pose::translation(Vec3::new(
            halves(random, -2, 2),
            halves(random, -2, 2),
            halves(random, -2, 2),
        ));
        let turn = Pose::rotation_z(S::near(random.between(-2.0, 2.0)));
        let parts = (0..count)
            .map(|index| Dressed {
                part: random_part(random),
                pose: random.chance(0.2).then(|| random.below(POSES)),
                color: random.chance(0.3).then_some(Rgb::new(index as u8, 7, 200)),
            })
            .collect();
        Self { parts, poses: [shift.unwrap(), turn.unwrap()] }
    }

    fn dress(&self, index: usize, program: &mut Tested12<S>) {
        let Dressed { pose, color, .. } = self.parts[index];
        program.place(index, pose).unwrap();
        program.paint(index, color).unwrap();
    }

    fn program(&self, tree: &Tree) -> Tested12<S> {
        let mut program = Program::new(self.parts[0].part);
        for pose in self.poses {
            program.add_pose(pose).unwrap();
        }
        tree.build(self, &mut program);
        program
    }

    /// A part alone, where it stands.
    fn placed(&self, index: usize) -> Placed<Part<S>> {
        let Dressed { part, pose, .. } = self.parts[index];
        Placed::new(part, pose.map_or(Pose::IDENTITY, |pose| self.poses[pose]))
    }

    /// Compares all pixels of a picture with the merge of the parts' own.
    fn compare<C>(&self, tree: &Tree, program: &Tested12<S>, camera: &C, size: Size) -> usize
    where
        C: Camera<Rays: Rays<Scalar = S>>,
        Part<S>: Scan<C::Rays, Scalar = S>,
    {
        let light = Lambert::new(vector::<S>([1.0, 2.0, 3.0]), S::near(0.25)).unwrap();
        let parts: Vec<_> = (0..self.parts.len()).map(|index| self.placed(index)).collect();
        // A part that isn't moved is the part as it is, not one that is moved by nothing.
        let mut moved: Vec<_> = parts
            .iter()
            .map(|part| Picture::new(part, camera, size, light, Rgb565::default()))
            .collect();
        let mut still: Vec<_> = self
            .parts
            .iter()
            .map(|part| Picture::new(&part.part, camera, size, light, Rgb565::default()))
            .collect();
        let mut picture = Picture::new(program, camera, size, light, Rgb565::default());
        let mut crossings = 0;
        let height = size.height();
        for y in (0..height).chain((0..height).rev().step_by(3)) {
            let Ok(mut row) = picture.scanline(y) else { return 0 };
            for x in (0..size.width()).chain((0..size.width()).rev().step_by(3)) {
                let wanted = tree.merged(&mut |index| {
                    let mut list = SpanList::<S, 2>::new();
                    let spans = match self.parts[index].pose {
                        Some(_) => moved[index].scanline(y).unwrap().spans(x, &mut list).to_vec(),
                        None => still[index].scanline(y).unwrap().spans(x, &mut list).to_vec(),
                    };
                    numbered(&spans, index)
                });
                let mut list = SpanList::<S, SPANS>::new();
                let got = row.spans(x, &mut list).to_vec();
                assert_eq!(ends(&got), ends(&wanted), "pixel {x}, {y} of {tree:?}");
                let seen = row.seen(x).map(|seen| (seen.t, seen.face, seen.inside));
                let first = first_seen(&wanted, camera.rays(size).start());
                assert_eq!(seen, first.map(|seen| (seen.t, seen.face, seen.inside)));
                crossings += got.len();
            }
        }
        crossings
    }
}

/// Whether a point is within bounds, up to a thousandth.
fn is_within<S: Tested>(bounds: &Bounds<S>, point: Vec3<S>) -> bool {
    let slack = S::near(1e-3);
    match *bounds {
        Bounds::Box { low, high } => {
            [(low, point), (point, high)].into_iter().all(|(less, more)| {
                let pairs = less.to_array().into_iter().zip(more.to_array());
                pairs.into_iter().all(|(less, more)| less <= more.plus(slack))
            })
        }
        Bounds::Ball { center, radius } => {
            let way = point - center;
            S::length(way.to_array()) <= radius.plus(slack)
        }
        _ => true,
    }
}

fn numbered<S: Scalar>(spans: &[Span<S>], index: usize) -> Vec<Span<S>> {
    let at = |crossing: Crossing<S>| Crossing {
        face: Face(crossing.face.0 + FACES * index as u16),
        ..crossing
    };
    spans.iter().map(|span| Span { enter: at(span.enter), exit: at(span.exit) }).collect()
}

/// The crossings; of those at infinity no face.
fn ends<S: Scalar>(spans: &[Span<S>]) -> Vec<Crossing<S>> {
    let finite = |crossing: &Crossing<S>| crossing.t > S::LOWEST && crossing.t < S::HIGHEST;
    let known = |crossing| {
        if finite(&crossing) { crossing } else { Crossing { face: Face(0), ..crossing } }
    };
    spans.iter().flat_map(|span| [span.enter, span.exit]).map(known).collect()
}

fn cameras<S: Tested>(random: &mut Random) -> (Orthographic<S>, Perspective<S>) {
    let along = if random.chance(0.5) {
        [0.0, 0.0, -1.0]
    } else {
        [random.between(-1.0, 1.0), random.between(-0.5, 0.5), -1.0]
    };
    let up = vector([0.0, 1.0, 0.0]);
    let eye = vector(along.map(|way| -way * if random.chance(0.3) { 0.5 } else { 7.0 }));
    (
        Orthographic::look_along(vector(along), Vec3::ZERO, up, S::near(6.0)).unwrap(),
        Perspective::look_at(eye, Vec3::ZERO, up, S::ONE).unwrap(),
    )
}

/// On a grid, where ties are the rule.
fn random_programs_are_the_merge_of_their_leaves<S: Tested>() {
    let mut crossings = 0;
    for seed in 0..100 {
        let random = &mut Random::seeded(seed);
        let count = 1 + random.below(PARTS);
        let tree = Tree::random(random, 0, count);
        let scene = Scene::<S>::random(random, count);
        let program = scene.program(&tree);
        let size = Size::new(1 + random.below(24) as u16, 1 + random.below(20) as u16).unwrap();
        let (orthographic, perspective) = cameras::<S>(random);
        crossings += scene.compare(&tree, &program, &orthographic, size);
        crossings += scene.compare(&tree, &program, &perspective, size);
        for _ in 0..20 {
            let [from, to] = [(); 2].map(|()| {
                Vec3::new(halves(random, -9, 9), halves(random, -9, 9), halves(random, -9, 9))
            });
            let Ok(ray) = Ray::new(from, to - from) else { continue };
            let wanted = tree.merged(&mut |index| {
                let mut list = SpanList::<S, 2>::new();
                let Dressed { part, pose, .. } = scene.parts[index];
                let spans = match pose {
                    Some(_) => scene.placed(index).trace(&ray, &mut list).to_vec(),
                    None => part.trace(&ray, &mut list).to_vec(),
                };
                numbered(&spans, index)
            });
            let mut list = SpanList::<S, SPANS>::new();
            let hit = program.hit(&ray, &mut list).unwrap();
            assert!(hit.is_none_or(|hit| is_within(&program.bounds(), hit.point)), "{tree:?}");
            let got = program.trace(&ray, &mut list).unwrap();
            assert_eq!(ends(got), ends(&wanted), "{tree:?}");
            crossings += got.len();
        }
    }
    assert!(crossings > 10_000, "{crossings}");
}

/// The same parts in a typed tree: pictures with colours and light, hits with points and normals.
fn typed_trees_are_programs<S: Tested>() {
    for seed in 0..60 {
        let random = &mut Random::seeded(seed);
        let scene = Scene::<S>::random(random, 8);
        let of = |index: usize| {
            let color = scene.parts[index].color.unwrap_or(Rgb::WHITE);
            Painted::new(scene.parts[index].part, color)
        };
        let pose = scene.poses[seed as usize % 2];
        let moved = |index| Placed::new(of(index), pose);
        let mut program = Tested12::<S>::new(scene.parts[0].part);
        program.add_pose(pose).unwrap();
        let (white, zero) = (Rgb::WHITE, Some(0));
        for (index, dressed) in scene.parts.iter().enumerate() {
            if index > 0 {
                program.push(dressed.part).unwrap();
            }
            program.paint(index, Some(dressed.color.unwrap_or(white))).unwrap();
            match index {
                1 => program.unite(2),
                3 => program.unite(2).and_then(|()| program.subtract(1)),
                4 | 7 => program.place(index, zero),
                5 => program.subtract(1),
                _ => Ok(()),
            }
            .unwrap();
        }
        program.subtract(1).unwrap(); // 6 less 7
        program.subtract(1).unwrap(); // what 4 keeps of 5, less that
        let tree = Union::new(
            Difference::new([of(0), of(1)], [of(2), of(3)]),
            Difference::new(Difference::new(moved(4), of(5)), Difference::new(of(6), moved(7))),
        );
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

fn same_pictures<S, A, B, C>(one: &A, other: &B, camera: &C)
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    A: Solid<Scalar = S> + Scan<C::Rays>,
    B: Solid<Scalar = S> + Scan<C::Rays>,
{
    let size = Size::new(40, 30).unwrap();
    let light = Lambert::new(vector::<S>([1.0, 2.0, 3.0]), S::near(0.25)).unwrap();
    let mut pictures = (
        Picture::new(one, camera, size, light, Rgb565::default()),
        Picture::new(other, camera, size, light, Rgb565::default()),
    );
    let mut rows = [[Rgb565::default(); 40]; 2];
    for y in 0..30 {
        let one = pictures.0.scanline(y).and_then(|mut row| row.render(&mut rows[0]));
        assert_eq!(one, pictures.1.scanline(y).and_then(|mut row| row.render(&mut rows[1])));
        assert_eq!(rows[0], rows[1], "row {y}");
    }
}

/// As an operand of a typed tree, moved, and scaled.
fn programs_are_operands<S: Tested>() {
    for seed in 0..20 {
        let random = &mut Random::seeded(seed);
        let scene = Scene::<S>::random(random, 3);
        let [one, two, three] = [0, 1, 2].map(|index| scene.parts[index].part);
        let mut program = Program::<Part<S>, 3>::new(one);
        for part in [two, three] {
            program.push(part).unwrap();
        }
        program.subtract(1).unwrap();
        let tree = Union::new(one, Difference::new(two, three));
        let (part, pose) = (random_part::<S>(random), scene.poses[1]);
        let (orthographic, perspective) = cameras::<S>(random);
        let one = Placed::new(Difference::new(program, part), pose);
        let other = Placed::new(Difference::new(tree, part), pose);
        same_pictures(&one, &other, &orthographic);
        same_pictures(&one, &other, &perspective);
        same_pictures(&(program & part), &Intersection::new(tree, part), &orthographic);
        let map = AffineMap::scaling([1.0, 0.5, 1.5].map(S::near)).unwrap();
        let (one, other) = (Scaled::new(program, map), Scaled::new(tree, map));
        same_pictures(&one, &other, &orthographic);
        same_pictures(&one, &other, &perspective);
        // Each row of a scaled solid has a camera of its own: what a group keeps of the last one is no use.
        let [one, two, three] = [0, 1, 2].map(|index| scene.parts[index].part);
        let group = Scaled::new([one, two, three], map);
        let union = Scaled::new(Union::new(one, Union::new(two, three)), map);
        same_pictures(&group, &union, &orthographic);
        same_pictures(&group, &union, &perspective);
    }
}

/// Removing any part that nothing is cut out of: the tree is that without it.
fn a_removed_part_was_never_there<S: Tested>() {
    /// The tree without a leaf; `None` if nothing is left, `Err` if something would be cut out of nothing.
    fn without(tree: &Tree, leaf: usize) -> Result<Option<Tree>, ()> {
        match tree {
            Tree::Leaf(index) if *index == leaf => Ok(None),
            Tree::Leaf(index) => Ok(Some(Tree::Leaf(index - usize::from(*index > leaf)))),
            Tree::Of(operation, operands) => {
                let mut left = Vec::new();
                for (place, operand) in operands.iter().enumerate() {
                    match without(operand, leaf)? {
                        Some(operand) => left.push(operand),
                        None if place == 0 && *operation == Operation::DIFFERENCE => return Err(()),
                        None => {}
                    }
                }
                let only = if left.len() == 1 { left.pop() } else { None };
                Ok(Some(only.unwrap_or(Tree::Of(*operation, left))))
            }
        }
    }
    let mut removed = 0;
    for seed in 0..100 {
        let random = &mut Random::seeded(seed);
        let count = 2 + random.below(PARTS - 1);
        let tree = Tree::random(random, 0, count);
        let mut scene = Scene::<S>::random(random, count);
        let mut program = scene.program(&tree);
        let part = random.below(count);
        let Ok(Some(rest)) = without(&tree, part) else {
            let as_it_was = program;
            assert_eq!(program.remove(part), Err(ProgramError::CutInto));
            assert_eq!(program, as_it_was);
            continue;
        };
        program.remove(part).unwrap();
        scene.parts.remove(part);
        assert_eq!(program.part_count(), count - 1);
        let size = Size::new(16, 12).unwrap();
        let (orthographic, _) = cameras::<S>(random);
        scene.compare(&rest, &program, &orthographic, size);
        removed += 1;
    }
    assert!(removed > 30, "{removed}");
}

#[test]
fn what_can_not_be_is_an_error_and_changes_nothing() {
    let part = |x| Part::Sphere(ball::<f32>([x, 0.0, 0.0], 1.0));
    let mut program = Program::<Part<f32>, 3, 1>::new(part(0.0));
    let same = |program: &Program<Part<f32>, 3, 1>, was: &Program<Part<f32>, 3, 1>| {
        assert_eq!(program, was);
    };
    let was = program;
    assert_eq!(program.unite(2), Err(ProgramError::Operands));
    assert_eq!(program.unite(0), Err(ProgramError::Operands));
    assert_eq!(program.intersect(2), Err(ProgramError::Operands));
    assert_eq!(program.subtract(1), Err(ProgramError::Operands));
    assert_eq!(program.subtract(0), Err(ProgramError::Operands));
    assert_eq!(program.subtract(usize::MAX), Err(ProgramError::Operands));
    assert_eq!(program.remove(0), Err(ProgramError::LastPart));
    assert_eq!(program.remove(1), Err(ProgramError::NoPart));
    assert_eq!(program.part_mut(1), Err(ProgramError::NoPart));
    assert_eq!(program.part(usize::MAX), Err(ProgramError::NoPart));
    assert_eq!(program.paint(1, Some(Rgb::WHITE)), Err(ProgramError::NoPart));
    assert_eq!(program.place(1, None), Err(ProgramError::NoPart));
    assert_eq!(program.place(0, Some(0)), Err(ProgramError::NoPose));
    assert_eq!(program.set_pose(0, Pose::IDENTITY), Err(ProgramError::NoPose));
    same(&program, &was);
    assert_eq!(program.add_pose(Pose::IDENTITY), Ok(0));
    assert_eq!(program.add_pose(Pose::IDENTITY), Err(ProgramError::Poses));
    assert_eq!((program.push(part(1.0)), program.push(part(2.0))), (Ok(1), Ok(2)));
    let was = program;
    assert_eq!(program.push(part(3.0)), Err(ProgramError::Parts));
    assert_eq!(program.unite(4), Err(ProgramError::Operands));
    same(&program, &was);
    assert_eq!((program.operand_count(), program.part_count()), (3, 3));
    program.subtract(1).unwrap();
    assert_eq!(program.remove(1), Err(ProgramError::CutInto));
    assert_eq!(program.operand_count(), 2);
}

/// A line with more spans than there is room for has no answer, and the picture of the same part has all.
#[test]
fn too_many_spans_of_a_ray_are_an_error() {
    let part = |x| ball::<f32>([x, 0.0, 0.0], 0.25);
    let mut beads = Program::<Sphere<f32>, 8, 0, 4>::new(part(-3.0));
    for x in [-2.0, -1.0, 0.0] {
        beads.push(part(x)).unwrap();
    }
    let along = Ray::new(vector([-9.0, 0.0, 0.0]), vector([1.0, 0.0, 0.0])).unwrap();
    let mut list = SpanList::<f32, 4>::new();
    assert_eq!(beads.trace(&along, &mut list).unwrap().len(), 4);
    beads.push(part(1.0)).unwrap();
    assert_eq!(beads.trace(&along, &mut list), Err(LineError::Spans));
    assert_eq!(beads.hit(&along, &mut list), Err(LineError::Spans));
    assert!(RayCast::trace(&beads, &along, &mut list).is_empty());
    let across = Ray::new(vector([0.0, 9.0, 0.0]), vector([0.0, -1.0, 0.0])).unwrap();
    assert_eq!(beads.hit(&across, &mut list).unwrap().unwrap().t, 8.75);
    let camera = Orthographic::look_along(
        vector::<f32>([1.0, 0.0, 0.0]),
        Vec3::ZERO,
        vector([0.0, 1.0, 0.0]),
        1.0,
    );
    let light = Lambert::new(vector::<f32>([1.0, 2.0, 3.0]), 0.25).unwrap();
    let size = Size::new(1, 1).unwrap();
    let mut picture =
        Picture::new(&beads, camera.as_ref().unwrap(), size, light, Rgb565::default());
    assert_eq!(picture.scanline(0).unwrap().seen(0).unwrap().t, -3.25);
}

/// What is cut out of a part that a ray misses isn't asked for.
#[test]
fn a_missed_part_needs_no_holes() {
    use std::cell::Cell;
    thread_local!(static ASKED: Cell<usize> = const { Cell::new(0) });

    #[derive(Debug, Clone, Copy)]
    struct Counted(Sphere<f32>);

    impl Shape for Counted {
        type Scalar = f32;
        const SPANS: usize = 1;
        const FACES: u16 = 1;
    }

    impl Solid for Counted {
        fn spans(&self, line: &Line<f32>, first: Face, stack: &mut SpanStack<'_, f32>) {
            ASKED.set(ASKED.get() + 1);
            self.0.spans(line, first, stack);
        }

        fn normal(&self, face: Face, at: Vec3<f32>) -> Vec3<f32> {
            self.0.normal(face, at)
        }
    }

    let part = |x, r| Counted(ball([x, 0.0, 0.0], r));
    let mut program = Program::<Counted, 8>::new(part(0.0, 1.0));
    for x in [-0.5, 0.0, 0.5] {
        program.push(part(x, 0.125)).unwrap();
    }
    program.subtract(3).unwrap();
    program.push(part(5.0, 1.0)).unwrap();
    let mut list = SpanList::<f32, 32>::new();
    for (x, asked, spans) in [(0.75, 5, 1), (0.0, 5, 2), (5.0, 2, 1), (9.0, 2, 0)] {
        ASKED.set(0);
        let ray = Ray::new(vector([x, 0.0, 9.0]), vector([0.0, 0.0, -1.0])).unwrap();
        assert_eq!(program.trace(&ray, &mut list).unwrap().len(), spans);
        assert_eq!(ASKED.get(), asked, "at {x}");
    }
}

/// A part in flash.
#[test]
fn programs_are_made_in_constants() {
    use scancsg::constant;
    use scancsg::geom::vec3;
    const DRILLED: Program<Part<f32>, 4> = {
        let plate = constant!(Cuboid::<f32>::new(vec3(-3.0, -1.0, 0.0), vec3(3.0, 1.0, 0.5)));
        let hole = constant!(Cylinder::<f32>::along_z(0.0, 0.0, 0.5, -1.0, 1.0));
        let mut program = Program::new(Part::Cuboid(plate));
        let index = match program.push(Part::Cylinder(hole)) {
            Ok(index) => index,
            Err(error) => panic!("{}", error.as_str()),
        };
        constant_result(program.subtract(1));
        constant_result(program.paint(index, Some(Rgb::new(1, 2, 3))));
        program
    };
    const fn constant_result(result: Result<(), ProgramError>) {
        if let Err(error) = result {
            panic!("{}", error.as_str());
        }
    }
    assert_eq!(<Program<Part<f32>, 4> as Shape>::FACES, 24);
    let ray = Ray::new(vector([0.2, 0.0, 5.0]), vector([0.3, 0.0, -4.75])).unwrap();
    let mut list = SpanList::<f32, 32>::new();
    let hit = DRILLED.hit(&ray, &mut list).unwrap().unwrap();
    assert_eq!((hit.face, DRILLED.color(hit.face)), (Face(6 + 2), Some(Rgb::new(1, 2, 3))));
    assert!(hit.normal.x < -0.9, "{hit:?}: the wall of a hole is seen from within");
}

/// Programs are equal that have the same parts, whatever there was in their memory before.
#[test]
fn equal_programs_have_equal_parts() {
    let ball = |x| Sphere::<f32>::new(vec3(x, 0.0, 0.0), 1.0).unwrap();
    let mut built = Program::<_, 4>::new(ball(0.0));
    built.push(ball(2.0)).unwrap();
    built.unite(2).unwrap();

    let mut changed = Program::<_, 4>::new(ball(5.0));
    changed.push(ball(1.0)).unwrap();
    changed.push(ball(2.0)).unwrap();
    changed.unite(3).unwrap();
    changed.remove(1).unwrap();
    *changed.part_mut(0).unwrap() = ball(0.0);
    changed.paint(1, Some(Rgb::WHITE)).unwrap();
    assert_ne!(built, changed);
    changed.paint(1, None).unwrap();
    assert_eq!(built, changed);
    let mut buffer = [0; 100];
    assert_eq!(Program::from_bytes(changed.to_bytes(&mut buffer).unwrap()), Ok(changed));

    let mut cut = Program::<_, 4>::new(ball(0.0));
    cut.push(ball(2.0)).unwrap();
    assert_ne!(built, cut);
    cut.subtract(1).unwrap();
    assert_ne!(built, cut);
}

/// Leaves, their solids and their number type may have names that the library has, too.
mod names {
    use scancsg::solid::{Cuboid, Cylinder, Difference, Sphere};

    type Step<S> = Difference<Cuboid<S>, Cuboid<S>>;

    scancsg::leaves! {
        pub enum Shape<R> {
            Empty(Cylinder<R>),
            Face(Sphere<R>),
        }
    }

    scancsg::leaves! {
        pub enum Solid<P> {
            Step(Step<P>),
            Shape(super::names::Shape<P>),
        }
    }

    #[test]
    fn leaves_have_any_names() {
        let ball = Sphere::<f32>::new(super::vec3(0.0, 0.0, 0.0), 1.0).unwrap();
        let leaf = Solid::Shape(Shape::Face(ball));
        let program = super::Program::<_, 1>::new(leaf);
        assert_eq!(super::Solid::bounds(&program), super::Solid::bounds(&ball));
    }
}
