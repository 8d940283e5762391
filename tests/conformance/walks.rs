//! What a pixel sees is found by a walk that computes no list, and asks only for what can matter in a run
//! of columns. It must be what the list of all spans says, bit by bit, with the same faces: the merge of
//! what each leaf says, by the same tree, without silhouettes, so that none is left out of the list.

use crate::aim::{direction, from_middle, up};
use crate::number::{Tested, ball, between, vector};
use proptest::prelude::*;
use scancsg::geom::{AffineMap, Axis, Line, OrthographicRays, PerspectiveRays, Pose, Rays, Vec3};
use scancsg::render::{Camera, Orthographic, Perspective, Size};
use scancsg::scalar::Scalar;
use scancsg::scan::{ColumnRun, Empty, Leaf, Scan};
use scancsg::solid::{
    Cone, Cuboid, Cylinder, Difference, Intersection, Painted, Placed, Polyhedron, Rgb, Scaled,
    Slab, Solid, Sphere, Torus, Union,
};
use scancsg::span::walk::{Cold, Hot, Path, Step};
use scancsg::span::{Crossing, Face, Shape, Span, SpanList, SpanStack};
use std::any::Any;
use std::cell::{Cell, RefCell};
use std::ops::{BitAnd, BitOr, Sub};

for_every_number!(trees_of_whatever_touches, trees_of_whatever_lies_askew, many_in_a_row,);

thread_local! {
    /// The leaves of the tree that lists everything, in their order.
    static LEAVES: RefCell<Vec<ListedLeaf>> = const { RefCell::new(Vec::new()) };
    /// The pixel that is asked for: `x` and `y` in half pixels, and the number of columns.
    static PIXEL: Cell<(i32, i32, u32)> = const { Cell::new((0, 0, 0)) };
}

/// A leaf, asked for its spans in a pixel.
struct ListedLeaf {
    /// The first of its faces among all of the tree, and their number.
    first: u16,
    faces: u16,
    /// Sets a `Vec<Span<S>>` of the right number type.
    set: Ask,
}

type Ask = Box<dyn Fn(&mut dyn Any)>;

/// A primitive whose spans, along whatever line, are what it says as a [`Leaf`] of the pixel asked for:
/// so that a tree of such primitives merges lists. Without a silhouette: it is asked in all columns and
/// in all rows.
#[derive(Debug, Clone, Copy)]
struct Listed<T>(T);

impl<T: Shape> Shape for Listed<T> {
    type Scalar = T::Scalar;
    const SPANS: usize = T::SPANS;
    const STACK: usize = T::STACK;
    const FACES: u16 = T::FACES;
}

impl<T: Solid> Solid for Listed<T> {
    fn spans(&self, _: &Line<T::Scalar>, first: Face, stack: &mut SpanStack<'_, T::Scalar>) {
        let mut spans: Vec<Span<T::Scalar>> = Vec::new();
        LEAVES.with_borrow(|leaves| {
            let leaf = leaves.iter().find(|leaf| leaf.first == first.0).unwrap();
            (leaf.set)(&mut spans);
        });
        for Span { enter, exit } in spans {
            let at = |crossing: Crossing<_>| Crossing {
                face: Face(first.0 + crossing.face.0),
                ..crossing
            };
            stack.push(Span { enter: at(enter), exit: at(exit) }).unwrap();
        }
    }

    fn normal(&self, face: Face, at: Vec3<T::Scalar>) -> Vec3<T::Scalar> {
        self.0.normal(face, at)
    }
}

impl<R, T> Scan<R> for Listed<T>
where
    T: Leaf<R, Spans: AsMut<[Span<<T as Shape>::Scalar>]>> + Copy + 'static,
    R: 'static,
{
    type View = Option<()>;
    type Row = Option<()>;

    /// Views are set in the order of faces.
    fn view(&self, rays: &R, _: &mut Option<()>) {
        let leaf = self.0;
        let view = leaf.view(rays);
        let held = RefCell::new((i32::MIN, T::Row::EMPTY));
        let set = move |spans: &mut dyn Any| {
            let (x, y, columns) = PIXEL.get();
            let (of_row, row) = &mut *held.borrow_mut();
            if *of_row != y {
                (*of_row, *row) = (y, T::Row::EMPTY);
                let _ = leaf.row(&view, y, columns, row);
            }
            let mut kept = T::Spans::EMPTY;
            kept.as_mut().fill(Span::whole_line(Face(0)));
            leaf.spans(&view, row, x, &mut kept);
            leaf.close(&view, row, x, &mut kept);
            let with_length =
                kept.as_mut().iter().filter_map(|span| Span::new(span.enter, span.exit));
            *spans.downcast_mut::<Vec<Span<T::Scalar>>>().unwrap() = with_length.collect();
        };
        LEAVES.with_borrow_mut(|leaves| {
            let first = leaves.last().map_or(0, |leaf| leaf.first + leaf.faces);
            leaves.push(ListedLeaf { first, faces: T::FACES, set: Box::new(set) });
        });
    }

    fn row(&self, _: &Option<()>, _: i32, _: u32, _: &mut Option<()>) {}

    fn enter(_: &mut Option<()>, _: u32) -> ColumnRun {
        ColumnRun { is_visible: true, until: u32::MAX }
    }

    fn contains<P: Path>(&self, _: &Option<()>, _: &mut Option<()>, _: i32, _: T::Scalar) -> bool {
        unreachable!("only lists are asked for")
    }

    fn step<P: Path>(
        &self,
        _: &Option<()>,
        _: &mut Option<()>,
        _: i32,
        _: T::Scalar,
        _: Face,
    ) -> Step<T::Scalar> {
        unreachable!("only lists are asked for")
    }
}

/// As [`Listed`], of a solid that is no leaf but has at most one span: what it says in a walk of its own.
#[derive(Debug, Clone, Copy)]
struct Walked<T>(T);

impl<T: Shape> Shape for Walked<T> {
    type Scalar = T::Scalar;
    const SPANS: usize = T::SPANS;
    const STACK: usize = T::STACK;
    const FACES: u16 = T::FACES;
}

impl<T: Solid + Copy> Solid for Walked<T> {
    fn spans(&self, line: &Line<T::Scalar>, first: Face, stack: &mut SpanStack<'_, T::Scalar>) {
        Listed(self.0).spans(line, first, stack);
    }

    fn normal(&self, face: Face, at: Vec3<T::Scalar>) -> Vec3<T::Scalar> {
        self.0.normal(face, at)
    }
}

impl<R, T> Scan<R> for Walked<T>
where
    T: Scan<R, View: 'static, Row: 'static> + Copy + 'static,
    R: 'static,
{
    type View = Option<()>;
    type Row = Option<()>;

    fn view(&self, rays: &R, _: &mut Option<()>) {
        let solid = self.0;
        let mut view = T::View::EMPTY;
        solid.view(rays, &mut view);
        let set = move |spans: &mut dyn Any| {
            let (x, y, columns) = PIXEL.get();
            let mut row = T::Row::EMPTY;
            solid.row(&view, y, columns, &mut row);
            let column = (x + columns as i32 - 1) / 2;
            let spans = spans.downcast_mut::<Vec<Span<T::Scalar>>>().unwrap();
            spans.clear();
            if T::enter(&mut row, column as u32).is_visible {
                let mut behind = |t| solid.step::<Cold>(&view, &mut row, x, t, Face(0));
                let lowest = Crossing { t: T::Scalar::LOWEST, face: Face(0) };
                let Step { inside, next } = behind(lowest.t);
                let enter = if inside { lowest } else { next };
                let exit = if inside { next } else { behind(next.t).next };
                spans.extend(Span::new(enter, exit));
            }
        };
        LEAVES.with_borrow_mut(|leaves| {
            let first = leaves.last().map_or(0, |leaf| leaf.first + leaf.faces);
            leaves.push(ListedLeaf { first, faces: T::FACES, set: Box::new(set) });
        });
    }

    fn row(&self, _: &Option<()>, _: i32, _: u32, _: &mut Option<()>) {}

    fn enter(_: &mut Option<()>, _: u32) -> ColumnRun {
        ColumnRun { is_visible: true, until: u32::MAX }
    }

    fn contains<P: Path>(&self, _: &Option<()>, _: &mut Option<()>, _: i32, _: T::Scalar) -> bool {
        unreachable!("only lists are asked for")
    }

    fn step<P: Path>(
        &self,
        _: &Option<()>,
        _: &mut Option<()>,
        _: i32,
        _: T::Scalar,
        _: Face,
    ) -> Step<T::Scalar> {
        unreachable!("only lists are asked for")
    }
}

impl<T, Right> BitOr<Right> for Listed<T> {
    type Output = Union<Self, Right>;
    fn bitor(self, right: Right) -> Self::Output {
        Union::new(self, right)
    }
}

impl<T, Right> BitAnd<Right> for Listed<T> {
    type Output = Intersection<Self, Right>;
    fn bitand(self, right: Right) -> Self::Output {
        Intersection::new(self, right)
    }
}

impl<T, Right> Sub<Right> for Listed<T> {
    type Output = Difference<Self, Right>;
    fn sub(self, right: Right) -> Self::Output {
        Difference::new(self, right)
    }
}

/// A solid, and the row of it that is set.
struct Staged<'a, T: Scan<R>, R> {
    solid: &'a T,
    view: T::View,
    row: T::Row,
}

impl<'a, R, T: Scan<R>> Staged<'a, T, R> {
    fn new(solid: &'a T, rays: &R) -> Self {
        let mut staged = Self { solid, view: T::View::EMPTY, row: T::Row::EMPTY };
        solid.view(rays, &mut staged.view);
        staged
    }
}

/// What a walk asks. The walk is compiled once for all solids of a number type.
trait Asked<S> {
    fn set_row(&mut self, y: i32, columns: u32);
    fn enter(&mut self, column: u32) -> ColumnRun;
    fn contains(&mut self, x: i32, t: S) -> bool;
    /// On the hot path, and on the cold one.
    fn steps(&mut self, x: i32, t: S) -> [Step<S>; 2];
}

impl<S, R, T: Scan<R, Scalar = S>> Asked<S> for Staged<'_, T, R>
where
    S: Scalar,
{
    fn set_row(&mut self, y: i32, columns: u32) {
        self.solid.row(&self.view, y, columns, &mut self.row);
    }

    fn enter(&mut self, column: u32) -> ColumnRun {
        T::enter(&mut self.row, column)
    }

    fn contains(&mut self, x: i32, t: S) -> bool {
        self.solid.contains::<Hot>(&self.view, &mut self.row, x, t)
    }

    fn steps(&mut self, x: i32, t: S) -> [Step<S>; 2] {
        let Self { solid, view, row } = self;
        let hot = solid.step::<Hot>(view, row, x, t, Face(0));
        [hot, solid.step::<Cold>(view, row, x, t, Face(0))]
    }
}

/// A row of a solid, the ways to enter it, and the spans of the same solid that lists everything.
struct Walker<'a, S: Scalar> {
    walked: &'a mut dyn Asked<S>,
    listed: &'a dyn Fn(&mut SpanStack<'_, S>),
    columns: u32,
    y: i32,
}

impl<S: Tested> Walker<'_, S> {
    /// Enters each run once and asks in all of its columns; then each column on its own, from the last one
    /// to the first, and every third one. Returns the number of crossings.
    fn check_row(&mut self) -> Result<u32, TestCaseError> {
        let lists: Vec<_> = (0..self.columns).map(|index| self.list(index)).collect();
        let mut crossings = 0;
        let mut run = ColumnRun { is_visible: false, until: 0 };
        for index in 0..self.columns {
            if index == run.until {
                run = self.walked.enter(index);
                prop_assert!(run.until > index, "a run without a column");
            }
            crossings += self.check(index, run, &lists)?;
        }
        let back = (0..self.columns).rev();
        for index in back.chain((0..self.columns).step_by(3)) {
            let run = self.walked.enter(index);
            crossings += self.check(index, run, &lists)?;
        }
        Ok(crossings)
    }

    /// The spans of a column's ray.
    fn list(&self, index: u32) -> Vec<Span<S>> {
        PIXEL.set((from_middle(index, self.columns), self.y, self.columns));
        let mut list = SpanList::<S, 64>::new();
        (self.listed)(&mut list.stack());
        list.to_vec()
    }

    /// Walks along the ray of a column that was entered, and wants the crossings of its list.
    fn check(
        &mut self,
        index: u32,
        run: ColumnRun,
        lists: &[Vec<Span<S>>],
    ) -> Result<u32, TestCaseError> {
        let x = from_middle(index, self.columns);
        let list = &lists[index as usize];
        let mut wanted = list.iter().flat_map(|span| [span.enter, span.exit]);
        let mut inside = list.first().is_some_and(|span| span.enter.t == S::LOWEST);
        if inside {
            wanted.next();
        }
        let mut count = 0;
        if run.is_visible {
            let mut t = S::LOWEST;
            loop {
                prop_assert_eq!(self.walked.contains(x, t), inside);
                let [step, cold] = self.walked.steps(x, t);
                prop_assert_eq!(step, cold);
                prop_assert_eq!(step.inside, inside);
                if step.next.t == S::HIGHEST {
                    break;
                }
                prop_assert_eq!(Some(step.next), wanted.next());
                (t, inside) = (step.next.t, !inside);
                count += 1;
            }
        }
        prop_assert!(wanted.all(|crossing| crossing.t == S::HIGHEST), "{x}, {}", self.y);
        Ok(count)
    }
}

/// Checks all rows of a picture.
fn check_walks<S, T, W, R>(
    (solid, all): (&T, &W),
    rays: &R,
    size: Size,
) -> Result<u32, TestCaseError>
where
    S: Tested,
    R: Rays<Scalar = S>,
    T: Scan<R, Scalar = S>,
    W: Solid<Scalar = S> + Scan<R>,
{
    let (columns, height) = (size.width().into(), size.height());
    // No picture is made of rays beyond the number type's range.
    if !rays.fits(height) {
        return Ok(0);
    }
    LEAVES.with_borrow_mut(Vec::clear);
    let mut view = W::View::EMPTY;
    all.view(rays, &mut view);
    let line = Line { origin: Vec3::ZERO, direction: Vec3::ZERO };
    let listed = |stack: &mut SpanStack<'_, S>| all.spans(&line, Face(0), stack);
    let walked = &mut Staged::new(solid, rays);
    let mut walker = Walker { walked, listed: &listed, columns, y: 0 };
    let mut crossings = 0;
    // In order, and in another one.
    for y in (0..height).chain((0..height).rev().step_by(3)) {
        let y = from_middle(y.into(), height.into());
        walker.y = y;
        walker.walked.set_row(y, columns);
        crossings += walker.check_row()?;
    }
    Ok(crossings)
}

/// What looks at a solid: both kinds of cameras.
#[derive(Debug, Clone)]
struct Views {
    along: [f64; 3],
    /// How far away the eye is.
    far: f64,
    size: Size,
}

impl Views {
    /// A solid against the same one of primitives that are listed.
    fn check<S, T, W>(&self, solid: &T, all: &W) -> Result<u32, TestCaseError>
    where
        S: Tested,
        T: Scan<OrthographicRays<S>, Scalar = S> + Scan<PerspectiveRays<S>, Scalar = S>,
        W: Solid<Scalar = S> + Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
    {
        let mut crossings = 0;
        let frame = S::near(5.0);
        let camera = Orthographic::look_along(vector(self.along), Vec3::ZERO, up(), frame);
        if let Ok(camera) = camera {
            crossings += check_walks((solid, all), &camera.rays(self.size), self.size)?;
        }
        let eye = vector(self.along.map(|way| -way * self.far));
        if let Ok(camera) = Perspective::look_at(eye, Vec3::ZERO, up(), S::ONE) {
            let rays = camera.rays(self.size);
            // Pictures refuse directions that a grid has no room for.
            if rays.fits(self.size.height()) {
                crossings += check_walks((solid, all), &rays, self.size)?;
            }
        }
        Ok(crossings)
    }
}

fn views() -> impl Strategy<Value = Views> {
    let along = prop_oneof![direction(), Just([0.0, 0.0, -1.0]), Just([-1.0, 0.0, -1.0])];
    let far = prop_oneof![Just(0.5), Just(6.0)];
    // Some have more rows than a block of a group has.
    let height = prop_oneof![3 => 1..12u16, 1 => 12..24u16];
    (along, far, 1..24u16, height).prop_map(|(along, far, columns, height)| Views {
        along,
        far,
        size: Size::new(columns, height).unwrap(),
    })
}

/// What a tree is built of: rods, balls and slabs, scaled rods and balls, and a group of rods drilled by
/// another one.
#[derive(Debug, Clone)]
struct Leaves<R, B, L, C, O, X, P, D, E> {
    r: [R; 8],
    b: [B; 4],
    s: [L; 3],
    c: [C; 3],
    o: [O; 2],
    x: [X; 2],
    p: P,
    drum: D,
    egg: E,
    bored: Difference<[R; 2], [R; 2]>,
}

type Round<R, B, L, C, O> = ([R; 8], [B; 4], [L; 3], [C; 3], [O; 2]);

impl<R: Copy, B, L, C, O, X, P, D, E> Leaves<R, B, L, C, O, X, P, D, E> {
    fn new((r, b, s, c, o): Round<R, B, L, C, O>, (x, p, drum, egg): ([X; 2], P, D, E)) -> Self {
        let bored = Difference::new([r[0], r[1]], [r[2], r[3]]);
        Self { r, b, s, c, o, x, p, drum, egg, bored }
    }
}

type Drawn<S> = Leaves<
    Cylinder<S>,
    Sphere<S>,
    Slab<S>,
    Cone<S>,
    Torus<S>,
    Cuboid<S>,
    Polyhedron<S, 6>,
    Scaled<Cylinder<S>>,
    Scaled<Sphere<S>>,
>;

impl<S: Tested> Drawn<S> {
    fn drawn(
        rod: impl Strategy<Value = Cylinder<S>>,
        ball: impl Strategy<Value = Sphere<S>>,
        slab: impl Strategy<Value = Slab<S>>,
        cone: impl Strategy<Value = Cone<S>>,
        ring: impl Strategy<Value = Torus<S>>,
        corner: impl Strategy<Value = f64>,
    ) -> impl Strategy<Value = Self> {
        use proptest::array::{uniform2, uniform3, uniform4, uniform8};
        let cuboids = uniform2((uniform3(corner), uniform3(1..4i32)));
        let round = (uniform8(rod), uniform4(ball), uniform3(slab), uniform3(cone), uniform2(ring));
        (round, cuboids).prop_map(|(round, cuboids)| {
            let scale = |factors: [f64; 3]| AffineMap::scaling(factors.map(S::near)).unwrap();
            let columns = [[0.5, 0.25, 0.0], [0.0, 1.0, 0.5], [0.25, 0.0, -1.5]].map(vector);
            let shear = AffineMap::with_columns(columns, vector([0.5, 0.0, -0.25])).unwrap();
            let egg = Scaled::new(round.1[3], scale([1.5, -0.5, 1.0]));
            let drum = Scaled::new(round.0[7], shear);
            let x = cuboids.map(|(low, halves)| {
                let high: [f64; 3] = std::array::from_fn(|i| low[i] + f64::from(halves[i]) / 2.0);
                Cuboid::between(vector(low), vector(high)).unwrap()
            });
            // A wedge on the first box's floor.
            let [low, high] = x[0].corners();
            let polygon = [[low.x, low.y], [high.x, low.y], [low.x, high.y]];
            let wedge = Polyhedron::extruded(Axis::Z, polygon, low.z, high.z).unwrap();
            Self::new(round, (x, wedge, drum, egg))
        })
    }

    /// Trees of all operations; operands of each kind on either side; groups of primitives and of trees,
    /// inside of each other; what is painted and what is placed.
    fn check(&self, views: &Views) -> Result<u32, TestCaseError> {
        let shift = S::translation(vector([0.5, -1.0, 0.5])).unwrap();
        let pose = Pose::rotation_z(S::near(0.5)).and_then(|turn| turn.then(&shift)).unwrap();
        let all = Leaves::new(
            (
                self.r.map(Listed),
                self.b.map(Listed),
                self.s.map(Listed),
                self.c.map(Listed),
                self.o.map(Listed),
            ),
            (self.x.map(Listed), Listed(self.p), Walked(self.drum), Walked(self.egg)),
        );
        // A tree of these, and the same of those that are listed.
        macro_rules! check {
            (|$of:ident| $($tree:expr;)+) => {
                [$({
                    let $of = self;
                    let solid = $tree;
                    let $of = &all;
                    let told = |error| TestCaseError::fail(format!("{error} in {}", stringify!($tree)));
                    views.check(&solid, &$tree).map_err(told)?
                }),+]
            };
        }
        let counts = check! { |of|
            Difference::new(
                [of.r[0], of.r[1], of.r[2], of.r[3]],
                [of.r[4], of.r[5], of.r[6], of.r[7]],
            );
            ((of.r[0] | of.b[0]) & of.s[0]) - (of.b[1] - (of.r[1] | of.s[1]));
            (of.s[0] & (of.b[0] | of.b[1] | of.b[2] | of.b[3]))
                | (of.r[0] - of.s[1])
                | ((of.r[1] & of.s[2]) - of.r[2]);
            (of.r[0] - (of.r[1] - (of.r[2] - (of.r[3] - (of.b[0] & of.s[0])))))
                | (of.s[1] - of.s[2]);
            [of.r[0] - of.b[0], of.r[1] - of.b[1], of.r[2] - of.b[2], of.r[3] - of.b[3]];
            Difference::new(
                [[of.r[0], of.r[1]], [of.r[2], of.r[3]]],
                [of.r[4] & of.s[0], of.r[5] & of.s[1], of.r[6] & of.s[2]],
            );
            Intersection::new(of.b, [of.r[0] | of.r[1], of.r[2] | of.r[3]]);
            painted(of.r[0]) | (painted(of.r[1]) - Placed::new(&of.bored, pose));
            Difference::new([of.c[0], of.c[1]], [of.r[0], of.r[1]]) | (of.c[2] & of.s[0]);
            Difference::new([of.x[0], of.x[1]], [of.r[0], of.r[1]]) | (of.p - of.s[0]);
            (of.r[0] - of.x[0]) | (of.b[0] - (of.p | Placed::new(&of.x[1], pose)));
            (of.r[0] - of.c[0]) | (of.b[0] - (of.c[1] | Placed::new(&of.c[2], pose)));
            Difference::new(Union::new(of.egg, of.r[0]), Intersection::new(of.drum, of.s[0]));
            Difference::new(of.b[0], [Difference::new(of.egg, of.r[1]), Difference::new(of.egg, of.r[2])]);
            Union::new(painted(of.drum), Placed::new(Difference::new(of.egg, of.b[1]), pose));
            Placed::new(&of.r[0], pose) & (of.b[0] | (Placed::new(&of.b[1], pose) - of.s[0]));
            (of.o[0] - of.r[0]) | (of.b[0] - (of.o[1] & of.s[0]));
            Difference::new(of.o, [of.r[0], of.r[1]]) | (painted(of.o[0]) & Placed::new(&of.o[1], pose));
        };
        Ok(counts.into_iter().sum())
    }
}

fn painted<T: Shape>(solid: T) -> Painted<T> {
    Painted::new(solid, Rgb::new(1, 2, 3))
}

/// Numbers of a coarse grid, so that faces coincide and touch.
fn grid(range: i32) -> impl Strategy<Value = f64> {
    (-range..=range).prop_map(|halves| f64::from(halves) / 2.0)
}

/// Along axes, on a grid: faces in one place, tangents, and rays along faces.
fn trees_of_whatever_touches<S: Tested>() {
    let rod = (0..3usize, grid(2), grid(2), 1..4i32, grid(3), 1..5i32).prop_map(
        |(axis, u, v, r, low, long)| {
            let (r, high) = (f64::from(r) / 2.0, low + f64::from(long) / 2.0);
            let [u, v, r, low, high] = [u, v, r, low, high].map(S::near);
            S::along(axis, [u, v], r, low, high).unwrap()
        },
    );
    let round = ([grid(3), grid(3), grid(3)], 1..4i32)
        .prop_map(|(center, r)| ball::<S>(center, f64::from(r) / 2.0));
    let slab = (0..3usize, grid(3), 1..5i32).prop_map(|(axis, low, wide)| {
        let [low, high] = [low, low + f64::from(wide) / 2.0].map(S::near);
        S::slab_along(axis, low, high).unwrap()
    });
    let radii = (0..4i32, 1..4i32, any::<bool>())
        .prop_map(|(a, b, turn)| if turn { [a, b] } else { [b, a] });
    let cone = (0..3usize, [grid(2), grid(2)], radii, grid(3), 1..5i32).prop_map(
        |(axis, middle, radii, low, long)| {
            let radii = radii.map(|halves| S::near(f64::from(halves) / 2.0));
            let [low, high] = [low, low + f64::from(long) / 2.0].map(S::near);
            S::cone_along(axis, middle.map(S::near), radii, low, high).unwrap()
        },
    );
    let ring = (0..3usize, [grid(3), grid(3), grid(3)], 2..5i32, 1..5i32).prop_map(
        |(axis, center, ring, thin)| {
            let radii = [ring, (ring - thin).max(1)].map(|halves| S::near(f64::from(halves) / 2.0));
            S::torus_along(axis, vector(center), radii).unwrap()
        },
    );
    check_trees(Drawn::drawn(rod, round, slab, cone, ring, grid(3)));
}

/// Along any direction, anywhere.
fn trees_of_whatever_lies_askew<S: Tested>() {
    let place = || [-1.5f64..1.5, -1.5f64..1.5, -1.5f64..1.5];
    let rod = (place(), direction(), 0.1..1.2f64, 0.3..2.0f64).prop_map(|(from, way, r, long)| {
        let to = std::array::from_fn(|i| from[i] + way[i] * long);
        between::<S>(from, to, r)
    });
    let round = (place(), 0.2..1.4f64).prop_map(|(center, r)| ball::<S>(center, r));
    let slab = (direction(), -1.0..0.5f64, 0.2..1.5f64).prop_map(|(normal, low, wide)| {
        S::slab(vector(normal), S::near(low), S::near(low + wide)).unwrap()
    });
    let cone = (place(), direction(), 0.1..1.2f64, -0.5..1.2f64, 0.3..2.0f64).prop_map(
        |(from, way, r, other, long)| {
            let to = std::array::from_fn(|i| from[i] + way[i] * long);
            let radii = [r, other.max(0.0)].map(S::near);
            S::cone_between(vector(from), vector(to), radii).unwrap()
        },
    );
    let ring = (place(), direction(), 0.3..1.4f64, 0.05..0.95f64).prop_map(
        |(center, axis, ring, part)| {
            S::torus(vector(center), vector(axis), [ring, ring * part].map(S::near)).unwrap()
        },
    );
    check_trees(Drawn::drawn(rod, round, slab, cone, ring, -1.5f64..1.0));
}

fn check_trees<S: Tested>(leaves: impl Strategy<Value = Drawn<S>>) {
    let crossings = Cell::new(0);
    proptest!(ProptestConfig::with_cases(60), |(leaves in leaves, views in views())| {
        crossings.set(crossings.get() + leaves.check(&views)?);
    });
    assert!(crossings.get() > 10_000, "{crossings:?}");
}

/// More elements than a run has, in any order, some of them behind each other and some with gaps.
fn many_in_a_row<S: Tested>() {
    let crossings = Cell::new(0);
    let place = || (-20..=20i32, -2..=2i32, 1..=4i32);
    proptest!(ProptestConfig::with_cases(60), |(
        places in proptest::collection::vec(place(), 16), views in views(),
    )| {
        let balls: [Sphere<S>; 16] = std::array::from_fn(|i| {
            let (x, z, r) = places[i];
            ball([f64::from(x) / 8.0, 0.0, f64::from(z) / 2.0], f64::from(r) / 16.0)
        });
        let slit = S::slab_along(2, S::near(-0.125), S::near(0.125)).unwrap();
        let plate = S::slab_along(2, S::near(-0.5), S::near(0.5)).unwrap();
        let (all, all_slit, all_plate) =
            (balls.map(Listed), Listed(slit), Listed(plate));
        let views = Views { size: Size::new(96, 3).unwrap(), ..views };
        let count = views.check(&balls, &all)?
            + views.check(&balls.map(|ball| ball - slit), &all.map(|ball| ball - all_slit))?
            + views.check(&(plate - slit), &(all_plate - all_slit))?
            + views.check(&Difference::new(plate, balls), &Difference::new(all_plate, all))?;
        crossings.set(crossings.get() + count);
    });
    assert!(crossings.get() > 10_000, "{crossings:?}");
}
