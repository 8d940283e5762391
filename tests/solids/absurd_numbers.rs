//! Indices, counts and faces that no picture has: public functions take any integer and panic at none.
//! Tests have checks of overflow on.

use crate::scene::Scene;
use scancsg::geom::{Extent, OrthographicRays, PerspectiveRays, RayRow, Rays, Vec3, vec3};
use scancsg::render::{Camera, Size};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::scan::bounds::{Bounds, Outline, Silhouette};
use scancsg::scan::{ColumnRun, Empty};
use scancsg::solid::{Cylinder, Many, Painted, Pipe, Rgb, Scan, Slab, Solid, Sphere, Union};
use scancsg::span::walk::{Cold, Hot};
use scancsg::span::{Crossing, Face, Operation, Span, SpanList, merge};

const COUNTS: [u32; 12] = [
    0,
    1,
    2,
    0xffff,
    0x1_0000,
    (1 << 30) - 1,
    1 << 30,
    (1 << 31) - 2,
    (1 << 31) - 1,
    1 << 31,
    u32::MAX - 1,
    u32::MAX,
];
const STEPS: [i32; 11] = [
    i32::MIN,
    i32::MIN + 1,
    -(1 << 30),
    -0x1_0000,
    -1,
    0,
    1,
    0x1_0000,
    1 << 30,
    i32::MAX - 1,
    i32::MAX,
];
const FACES: [u16; 5] = [0, 1, 1000, u16::MAX - 1, u16::MAX];

/// Everything that a picture asks of a solid.
fn scan<S: Scalar, R: Outline<Scalar = S>, T: Solid<Scalar = S> + Scan<R>>(solid: &T, rays: &R) {
    let (mut view, mut row) = (T::View::EMPTY, T::Row::EMPTY);
    solid.view(rays, &mut view);
    for y in STEPS {
        for other in STEPS {
            solid.is_in_rows(&view, [y, other]);
            rays.row(y).line(other);
        }
        for columns in COUNTS {
            solid.row(&view, y, columns, &mut row);
            for column in COUNTS {
                let ColumnRun { is_visible, until } = T::enter(&mut row, column);
                assert!(until > column || column == u32::MAX, "{until} {column} of {columns}");
                for x in STEPS.into_iter().filter(|_| is_visible) {
                    solid.contains::<Cold>(&view, &mut row, x, S::ZERO);
                    let face = Face(u16::MAX);
                    solid.step::<Hot>(&view, &mut row, x, S::LOWEST, face);
                }
            }
        }
    }
    for bounds in [solid.bounds(), Bounds::Unbounded] {
        let outline = rays.outline(&bounds);
        for y in STEPS {
            outline.is_in_rows([y, y]);
            for columns in COUNTS {
                let Extent { start, end } = outline.extent(y, columns);
                assert!(start <= end && end <= columns, "{start}..{end} of {columns}");
            }
        }
    }
    for face in FACES.map(Face) {
        solid.color(face);
        solid.normal(face, Vec3::ZERO);
        solid.onto(face, Vec3::ZERO);
    }
}

trait Parts: Scene {
    fn along_all<R: Outline<Scalar = Self>>(rays: &R)
    where
        Cylinder<Self>: Scan<R>,
        Sphere<Self>: Scan<R>,
        Slab<Self>: Scan<R>;
}

macro_rules! parts {
    ($($S:ty: $n:expr;)+) => {$(
        impl Parts for $S {
            fn along_all<R: Outline<Scalar = Self>>(rays: &R)
            where
                Cylinder<Self>: Scan<R>,
                Sphere<Self>: Scan<R>,
                Slab<Self>: Scan<R>,
            {
                let n = $n;
                let center = vec3(n(1), n(2), n(3));
                let rod = Cylinder::<$S>::along_x(n(0), n(0), n(2), n(-3), n(3)).unwrap();
                let oblique = Cylinder::<$S>::between(center, Vec3::ZERO, n(1)).unwrap();
                let ball = Sphere::<$S>::new(center, n(2)).unwrap();
                let slab = Slab::<$S>::new(center, n(-1), n(1)).unwrap();
                let points = [vec3(n(-3), n(0), n(0)), vec3(n(0), n(2), n(0)), vec3(n(4), n(0), n(0))];
                let pipe = Pipe::<$S, 4>::through(&points, n(1)).unwrap();
                scan(&rod, rays);
                scan(&oblique, rays);
                scan(&ball, rays);
                scan(&slab, rays);
                scan(&pipe, rays);
                scan(&((rod | oblique) & slab), rays);
                let mut many = Many::<_, 4>::new(Painted::new(ball, Rgb::WHITE));
                many.push(Painted::new(ball, Rgb::WHITE)).unwrap();
                scan(&Union::new(many, [slab; 3]), rays);
            }
        }
    )+};
}

parts! {
    f32: |n: i8| f32::from(n);
    I16F16: |n: i8| I16F16::from_num(n);
}

fn pictures<S: Parts>()
where
    Cylinder<S>: Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
    Sphere<S>: Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
    Slab<S>: Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
{
    let size = Size::new(64, 48).unwrap();
    let (parallel, pencil) = (S::orthographic().unwrap(), S::perspective().unwrap());
    S::along_all(&parallel.rays(size));
    S::along_all(&pencil.rays(size));
}

#[test]
fn of_a_picture_f32() {
    pictures::<f32>();
}

#[test]
fn of_a_picture_fixed() {
    pictures::<I16F16>();
}

/// More columns never fit where fewer don't.
fn more_columns_fit_less<S: Scene>() {
    let size = Size::new(64, 48).unwrap();
    let (parallel, pencil) = (S::orthographic().unwrap(), S::perspective().unwrap());
    for rows in [0, 1, 48, u16::MAX] {
        let parallel =
            COUNTS.map(|columns| OrthographicRays { columns, ..parallel.rays(size) }.fits(rows));
        let pencil = COUNTS.map(|columns| {
            let rays = pencil.rays(size);
            PerspectiveRays { plane: OrthographicRays { columns, ..rays.plane }, ..rays }.fits(rows)
        });
        for fits in [parallel, pencil] {
            assert!(fits.is_sorted_by(|fewer, more| fewer >= more), "{fits:?}");
            assert!(fits[0] || rows == u16::MAX);
        }
    }
}

#[test]
fn more_columns_fit_less_f32() {
    more_columns_fit_less::<f32>();
}

#[test]
fn more_columns_fit_less_fixed() {
    more_columns_fit_less::<I16F16>();
    let rays = I16F16::orthographic().unwrap().rays(Size::new(64, 48).unwrap());
    for columns in [i32::MAX as u32, 1 << 31, u32::MAX] {
        assert!(!OrthographicRays { columns, ..rays }.fits(1));
    }
}

/// Any two indices are those of two lists: the lower ones of those that exist.
#[test]
fn indices_of_a_merge() {
    let span = |enter, exit| {
        let at = |t| Crossing { t, face: Face(0) };
        Span { enter: at(enter), exit: at(exit) }
    };
    let spans = [span(0.0, 4.0), span(1.0, 2.0), span(3.0, 5.0)];
    for operation in [Operation::UNION, Operation::INTERSECTION, Operation::DIFFERENCE] {
        let merged = |left: usize, right: usize| {
            let mut list = SpanList::<f32, 8>::new();
            let mut stack = list.stack();
            spans.iter().for_each(|&span| stack.push(span).unwrap());
            merge(operation, &mut stack, left, right).unwrap();
            list.to_vec()
        };
        for left in [0, 1, 2, 3, 4, usize::MAX - 1, usize::MAX] {
            for right in [0, 1, 2, 3, 4, usize::MAX - 1, usize::MAX] {
                let right_in_list = right.min(3);
                let as_if = merged(left.min(right_in_list), right_in_list);
                assert_eq!(merged(left, right), as_if, "{left} {right}");
            }
        }
    }
}
