//! What a pixel sees is found by a walk that computes no list, and asks only for what can matter in a run
//! of columns. It must be what the list of all spans says, bit by bit, with the same faces.

use crate::number::{Tested, ball, between, vector};
use crate::rows::{direction, from_middle, up};
use proptest::prelude::*;
use scancsg::geom::{Column, Pose, Rays, Vec3};
use scancsg::render::{Camera, Orthographic, Perspective, Size};
use scancsg::solid::{
    Blank, Cylinder, Difference, Intersection, Outlook, Painted, Placed, Project, Rgb, Slab, Solid,
    Sphere,
};
use scancsg::span::{Face, SpanList};
use std::cell::Cell;

for_every_number!(trees_of_whatever_touches, trees_of_whatever_lies_askew, many_in_a_row,);

/// A row of a solid, and the ways to enter it.
struct Walker<'a, T: Project<R>, R> {
    solid: &'a T,
    view: T::View,
    row: T::Row,
    columns: u32,
}

impl<S, T, R> Walker<'_, T, R>
where
    S: Tested,
    R: Rays<Scalar = S>,
    T: Solid<Scalar = S> + Project<R>,
{
    /// Enters each run once and asks in all of its columns; then each column on its own, from the last one
    /// to the first, and every third one. Returns the number of crossings.
    fn check_row(&mut self) -> Result<u32, TestCaseError> {
        let mut crossings = 0;
        let mut run = Outlook { is_there: false, until: 0 };
        for index in 0..self.columns {
            if index == run.until {
                run = T::enter(&mut self.row, index);
                prop_assert!(run.until > index, "a run without a column");
            }
            crossings += self.check(index, run)?;
        }
        let back = (0..self.columns).rev();
        for index in back.chain((0..self.columns).step_by(3)) {
            let run = T::enter(&mut self.row, index);
            crossings += self.check(index, run)?;
        }
        Ok(crossings)
    }

    /// Walks along the ray of a column that was entered, and wants the crossings of its list.
    fn check(&mut self, index: u32, run: Outlook) -> Result<u32, TestCaseError> {
        let Self { solid, view, row, .. } = self;
        let column = Column { index, x: from_middle(index, self.columns) };
        let mut list = SpanList::<S, 64>::new();
        solid.spans_at(view, row, column, Face(0), &mut list.stack());
        let mut wanted = list.iter().flat_map(|span| [span.enter, span.exit]);
        let mut inside = list.first().is_some_and(|span| span.enter.t == S::LOWEST);
        if inside {
            wanted.next();
        }
        let mut count = 0;
        if run.is_there {
            let mut t = S::LOWEST;
            loop {
                prop_assert_eq!(solid.holds(view, row, column.x, t), inside);
                let look = solid.look(view, row, column.x, t, Face(0));
                prop_assert_eq!(look.inside, inside);
                if look.next.t == S::HIGHEST {
                    break;
                }
                prop_assert_eq!(Some(look.next), wanted.next());
                (t, inside) = (look.next.t, !inside);
                count += 1;
            }
        }
        prop_assert!(wanted.all(|crossing| crossing.t == S::HIGHEST), "{:?}", column);
        Ok(count)
    }
}

/// Checks all rows of a picture.
fn check_walks<S, T, R>(solid: &T, rays: &R, height: u16) -> Result<u32, TestCaseError>
where
    S: Tested,
    R: Rays<Scalar = S>,
    T: Solid<Scalar = S> + Project<R>,
{
    let columns = rays.columns();
    let mut walker = Walker { solid, view: T::View::BLANK, row: T::Row::BLANK, columns };
    solid.view(rays, &mut walker.view);
    let mut crossings = 0;
    // In order, and in another one.
    for y in (0..height).chain((0..height).rev().step_by(3)) {
        let y = from_middle(y.into(), height.into());
        solid.row(&walker.view, y, columns, &mut walker.row);
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
    fn check<S, T>(&self, solid: &T) -> Result<u32, TestCaseError>
    where
        S: Tested,
        T: Solid<Scalar = S>
            + Project<scancsg::geom::Parallel<S>>
            + Project<scancsg::geom::Pencil<S>>,
    {
        let height = self.size.height();
        let mut crossings = 0;
        let frame = S::near(5.0);
        let camera = Orthographic::look_along(vector(self.along), Vec3::ZERO, up(), frame);
        if let Ok(camera) = camera {
            crossings += check_walks(solid, &camera.rays(self.size), height)?;
        }
        let eye = vector(self.along.map(|way| -way * self.far));
        if let Ok(camera) = Perspective::look_at(eye, Vec3::ZERO, up(), S::ONE) {
            crossings += check_walks(solid, &camera.rays(self.size), height)?;
        }
        Ok(crossings)
    }
}

fn views() -> impl Strategy<Value = Views> {
    let along = prop_oneof![direction(), Just([0.0, 0.0, -1.0]), Just([-1.0, 0.0, -1.0])];
    let far = prop_oneof![Just(0.5), Just(6.0)];
    (along, far, 1..24u16, 1..12u16).prop_map(|(along, far, columns, height)| Views {
        along,
        far,
        size: Size::new(columns, height).unwrap(),
    })
}

/// Primitives that a tree is built of.
#[derive(Debug, Clone)]
struct Leaves<S: Tested> {
    rods: [Cylinder<S>; 8],
    balls: [Sphere<S>; 4],
    slabs: [Slab<S>; 3],
}

impl<S: Tested> Leaves<S> {
    fn drawn(
        rod: impl Strategy<Value = Cylinder<S>>,
        ball: impl Strategy<Value = Sphere<S>>,
        slab: impl Strategy<Value = Slab<S>>,
    ) -> impl Strategy<Value = Self> {
        use proptest::array::{uniform3, uniform4, uniform8};
        (uniform8(rod), uniform4(ball), uniform3(slab)).prop_map(|(rods, balls, slabs)| Self {
            rods,
            balls,
            slabs,
        })
    }

    /// Trees of all operations; operands of each kind on either side; groups of primitives and of trees,
    /// inside of each other; what is painted and what is placed.
    fn check(self, views: &Views) -> Result<u32, TestCaseError> {
        let [r0, r1, r2, r3, r4, r5, r6, r7] = self.rods;
        let [b0, b1, b2, b3] = self.balls;
        let [s0, s1, s2] = self.slabs;
        let pose =
            Pose::rotation_z(S::near(0.5)).then(&Pose::translation(vector([0.5, -1.0, 0.5])));
        let bored = Difference::new([r0, r1], [r2, r3]);
        let painted = |solid| Painted::new(solid, Rgb::new(1, 2, 3));
        let counts = [
            views.check(&Difference::new([r0, r1, r2, r3], [r4, r5, r6, r7]))?,
            views.check(&(((r0 | b0) & s0) - (b1 - (r1 | s1))))?,
            views.check(&((s0 & (b0 | b1 | b2 | b3)) | (r0 - s1) | ((r1 & s2) - r2)))?,
            views.check(&((r0 - (r1 - (r2 - (r3 - (b0 & s0))))) | (s1 - s2)))?,
            views.check(&[r0 - b0, r1 - b1, r2 - b2, r3 - b3])?,
            views.check(&Difference::new([[r0, r1], [r2, r3]], [r4 & s0, r5 & s1, r6 & s2]))?,
            views.check(&Intersection::new([b0, b1, b2, b3], [r0 | r1, r2 | r3]))?,
            views.check(&(painted(r0) | (painted(r1) - Placed::new(&bored, pose))))?,
            views.check(&(Placed::new(&r0, pose) & (b0 | (Placed::new(&b1, pose) - s0))))?,
        ];
        Ok(counts.into_iter().sum())
    }
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
    check_trees(Leaves::drawn(rod, round, slab));
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
    check_trees(Leaves::drawn(rod, round, slab));
}

fn check_trees<S: Tested>(leaves: impl Strategy<Value = Leaves<S>>) {
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
        let slabs = balls.map(|ball| ball - slit);
        let plate = S::slab_along(2, S::near(-0.5), S::near(0.5)).unwrap();
        let views = Views { size: Size::new(96, 3).unwrap(), ..views };
        let count = views.check(&balls)? + views.check(&slabs)? + views.check(&(plate - slit))?;
        crossings.set(crossings.get() + count + views.check(&Difference::new(plate, balls))?);
    });
    assert!(crossings.get() > 10_000, "{crossings:?}");
}
