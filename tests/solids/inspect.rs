//! Sections, and mass properties against formulas and against `tee` integrated in another way.

use crate::scene::Scene;
use scancsg::geom::Vec3;
use scancsg::inspect::{MassError, MassProperties};
use scancsg::scalar::{I16F16, Number, Real};
use scancsg::solid::{Bounds, Solid};
use scancsg::span::SpanList;
use std::f64::consts::PI;
use testkit::number::{Tested, ball, between, coordinates, vector};
use testkit::vector::{length, sub, unit};

/// Volume, centroid, and the means of squares and products about it: of yz, zx, xy.
#[derive(Debug, Clone, Copy)]
struct Exact {
    volume: f64,
    centroid: [f64; 3],
    moments: [f64; 3],
    products: [f64; 3],
}

/// A rectangle in a plane of equal z: from, to.
type Rectangle = [[f64; 2]; 2];

/// `tee` in slices of equal z. There every cylinder along x or y is a rectangle, so a slice is cells of a
/// grid through all their sides.
fn tee() -> Exact {
    let half = |radius: f64, off: f64| (radius * radius - off * off).max(0.0).sqrt();
    let sums = |z: f64| {
        let along_x = |y: f64, z0: f64, r: f64, x: [f64; 2]| -> Rectangle {
            let h = half(r, z - z0);
            [[x[0], y - h], [x[1], y + h]]
        };
        let along_y = |r: f64, y: [f64; 2]| -> Rectangle {
            let h = half(r, z);
            [[-h, y[0]], [h, y[1]]]
        };
        let body = [
            along_x(0.0, 0.0, 1.0, [-2.0, 2.0]),
            along_x(0.0, 0.0, 1.6, [-2.0, -1.7]),
            along_x(0.0, 0.0, 1.6, [1.7, 2.0]),
            along_y(0.8, [0.0, 2.0]),
        ];
        let through = [-3.0, 3.0];
        let bores = [
            along_x(0.0, 0.0, 0.7, through),
            along_y(0.5, [0.0, 3.0]),
            along_x(1.3, 0.0, 0.15, through),
            along_x(-1.3, 0.0, 0.15, through),
            along_x(0.0, 1.3, 0.15, through),
            along_x(0.0, -1.3, 0.15, through),
        ];
        let sides = |i: usize| {
            let all = body.iter().chain(&bores).flat_map(|r| [r[0][i], r[1][i]]);
            let mut all: Vec<f64> = all.collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let (xs, ys) = (sides(0), sides(1));
        let mut sums = [0.0; 6]; // of 1, x, y, x², y², xy
        for x in xs.windows(2) {
            for y in ys.windows(2) {
                let (mx, my) = ((x[0] + x[1]) / 2.0, (y[0] + y[1]) / 2.0);
                let within =
                    |r: &Rectangle| r[0][0] < mx && mx < r[1][0] && r[0][1] < my && my < r[1][1];
                if body.iter().any(within) && !bores.iter().any(within) {
                    let (dx, dy) = (x[1] - x[0], y[1] - y[0]);
                    let (xx, yy) = (mx * mx + dx * dx / 12.0, my * my + dy * dy / 12.0);
                    let terms = [1.0, mx, my, xx, yy, mx * my];
                    sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term * dx * dy);
                }
            }
        }
        sums
    };
    let steps = 4000;
    let dz = 3.2 / f64::from(steps);
    let (mut v, mut first, mut squares, mut products) = (0.0, [0.0; 3], [0.0; 3], [0.0; 3]);
    for i in 0..steps {
        let z = -1.6 + (f64::from(i) + 0.5) * dz;
        let [s, x, y, xx, yy, xy] = sums(z).map(|sum| sum * dz);
        v += s;
        for (sum, term) in first.iter_mut().zip([x, y, s * z]) {
            *sum += term;
        }
        for (sum, term) in squares.iter_mut().zip([xx, yy, s * z * z]) {
            *sum += term;
        }
        for (sum, term) in products.iter_mut().zip([y * z, x * z, xy]) {
            *sum += term;
        }
    }
    let [x, y, z] = first.map(|sum| sum / v);
    let squares = squares.map(|sum| sum / v);
    let products = products.map(|sum| sum / v);
    Exact {
        volume: v,
        centroid: [x, y, z],
        moments: [squares[0] - x * x, squares[1] - y * y, squares[2] - z * z],
        products: [products[0] - y * z, products[1] - z * x, products[2] - x * y],
    }
}

fn f64_of<S: Tested>(x: S::Wide) -> f64 {
    // In units of 2⁻¹⁶, and what is left of it.
    let unit = S::Wide::ONE / S::Wide::from_int(1 << 16);
    let whole = (x / unit).floor_to_i32();
    let rest = x - unit * S::Wide::from_int(whole);
    f64::from(whole) / 65536.0 + S::from_wide(rest).to_f64()
}

fn of<S: Tested, T: Solid<Scalar = S>>(
    solid: &T,
    low: [f64; 3],
    high: [f64; 3],
    rows: u16,
) -> MassProperties<S> {
    const { assert!(T::STACK <= 64) };
    let within = Bounds::Box { low: vector(low), high: vector(high) };
    MassProperties::of(solid, within, rows, &mut SpanList::<S, 64>::new()).unwrap()
}

/// The volume is as far off as the estimate says at most, and by no more than a part of it; all else by no
/// more than that part of the largest length.
fn agrees<S: Tested>(got: &MassProperties<S>, exact: &Exact, part: f64, size: f64) {
    let volume = f64_of::<S>(got.volume);
    let (error, estimate) = ((volume - exact.volume).abs(), f64_of::<S>(got.volume_error));
    assert!(error <= part * exact.volume, "{volume} {exact:?}");
    assert!(error <= estimate, "{error} > {estimate}");
    assert!(estimate <= 20.0 * part * exact.volume, "{estimate}");
    let wide = |v: Vec3<S::Wide>| v.to_array().map(f64_of::<S>);
    let all = [
        (coordinates(got.centroid), exact.centroid, size),
        (wide(got.moments), exact.moments, size * size),
        (wide(got.products), exact.products, size * size),
    ];
    for (got, exact, size) in all {
        let far = got.iter().zip(exact).map(|(got, exact)| (got - exact).abs());
        assert!(far.fold(0.0, f64::max) <= part * size, "{got:?} {exact:?}");
    }
}

const ROWS: &[u16] = if cfg!(debug_assertions) { &[256] } else { &[256, 255, 257, 300] };

/// Within 0.1 % at 256 rows.
fn tee_weighs_what_it_should<S: Scene + Tested>() {
    let exact = tee();
    assert!((exact.volume - 10.2663).abs() < 1e-4, "{exact:?}");
    for &rows in ROWS {
        let got = of(&S::TEE, [-2.0, -1.6, -1.6], [2.0, 2.0, 1.6], rows);
        agrees(&got, &exact, 1e-3, 2.0);
        // Flat faces across an axis are exact, and a wall is met between two rays.
        let (low, high) = (coordinates(got.low), coordinates(got.high));
        for (got, exact) in low.into_iter().chain(high).zip([-2.0, -1.6, -1.6, 2.0, 2.0, 1.6]) {
            let allowed = if exact.abs() == 2.0 { 1e-4 } else { 1e-3 };
            assert!((got - exact).abs() <= allowed, "{low:?} {high:?}");
        }
        println!("{:?} of {exact:?}", got);
    }
}

#[test]
fn tee_f32() {
    tee_weighs_what_it_should::<f32>();
}

#[test]
fn tee_f64() {
    tee_weighs_what_it_should::<f64>();
}

#[test]
fn tee_fixed() {
    tee_weighs_what_it_should::<I16F16>();
}

/// A cylinder between two points, from a formula: m(r²/4 + l²/12) across its axis, m r²/2 about it.
fn rod(from: [f64; 3], to: [f64; 3], radius: f64) -> Exact {
    let way = sub(to, from);
    let long = length(way);
    let [x, y, z] = unit(way);
    let (across, along) = (radius * radius / 4.0, long * long / 12.0);
    let product = |a: f64, b: f64| (along - across) * a * b;
    Exact {
        volume: PI * radius * radius * long,
        centroid: [0, 1, 2].map(|i| (from[i] + to[i]) / 2.0),
        moments: [x, y, z].map(|a| across + product(a, a)),
        products: [product(y, z), product(z, x), product(x, y)],
    }
}

fn formulas_hold<S: Tested>() {
    let rows = 192;
    let ball_of = |center: [f64; 3], radius: f64| Exact {
        volume: 4.0 / 3.0 * PI * radius.powi(3),
        centroid: center,
        moments: [radius * radius / 5.0; 3],
        products: [0.0; 3],
    };
    let center = [0.5, -1.0, 2.0];
    let got = of(&ball::<S>(center, 1.5), [-1.0, -2.5, 0.5], [2.0, 0.5, 3.5], rows);
    agrees(&got, &ball_of(center, 1.5), 1e-3, 1.5);

    let (from, to) = ([-1.0, 0.5, 0.25], [1.0, 2.0, 3.0]);
    let got = of(&between::<S>(from, to, 0.5), [-1.5, 0.0, -0.25], [1.5, 2.5, 3.5], rows);
    agrees(&got, &rod(from, to, 0.5), 1e-3, 4.0);

    // Long and thin: the box has as many rays across as along.
    let (from, to) = ([-40.0, 0.0, 0.0], [40.0, 0.0, 0.0]);
    let got = of(&between::<S>(from, to, 0.5), [-40.0, -0.5, -0.5], [40.0, 0.5, 0.5], rows);
    agrees(&got, &rod(from, to, 0.5), 1e-3, 40.0);

    // Cut by planes, one of them that of the box: half of a cylinder has its centroid 4r/3π away.
    let half = between::<S>([0.0, 0.0, -1.0], [0.0, 0.0, 2.0], 1.0)
        & S::slab_along(1, S::near(0.0), S::near(9.0)).unwrap();
    let got = of(&half, [-1.0, -1.0, -1.0], [1.0, 1.0, 1.0], rows);
    let away = 4.0 / (3.0 * PI);
    let exact = Exact {
        volume: PI,
        centroid: [0.0, away, 0.0],
        moments: [0.25, 0.25 - away * away, 1.0 / 3.0],
        products: [0.0; 3],
    };
    agrees(&got, &exact, 2e-3, 1.0);

    // Parts of a solid without an end count as far as the box goes.
    let slab = S::slab_along(0, S::near(-0.3), S::near(0.45)).unwrap();
    let got = of(&slab, [-1.0, -2.0, -1.0], [1.0, 2.0, 3.0], rows);
    let exact = Exact {
        volume: 12.0,
        centroid: [0.075, 0.0, 1.0],
        moments: [0.75 * 0.75 / 12.0, 16.0 / 12.0, 16.0 / 12.0],
        products: [0.0; 3],
    };
    agrees(&got, &exact, 2e-3, 4.0);
    let (low, high) = (coordinates(got.low), coordinates(got.high));
    let far = low.iter().chain(&high).zip([-0.3, -2.0, -1.0, 0.45, 2.0, 3.0]);
    assert!(far.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-3, "{low:?} {high:?}");
}

/// More rows are better: the error of the volume is measured over several numbers of rows.
#[test]
fn the_error_falls_with_the_rows() {
    let exact = tee().volume;
    let error = |rows: u16| {
        let errors = (0..4).map(|i| {
            let got = of(&f64::TEE, [-2.1, -1.7, -1.7], [2.1, 2.1, 1.7], rows + i);
            assert!((got.volume - exact).abs() <= got.volume_error);
            ((got.volume - exact) / exact).abs()
        });
        errors.sum::<f64>() / 4.0
    };
    let [few, more, most] = [16, 48, 144].map(error);
    println!("{few:.1e} {more:.1e} {most:.1e}");
    // Three times as many rows: like n^−1.5, five times as good.
    assert!(more < few / 2.5 && most < more / 2.5, "{few} {more} {most}");
}

/// Rays along a thin plate miss it, and its extent is known from those across.
fn thin_plates_have_an_extent<S: Tested>() {
    let plate = S::slab_along(1, S::near(0.3), S::near(0.302)).unwrap();
    let got = of(&plate, [-1.0; 3], [1.0; 3], 12);
    let (low, high) = (coordinates(got.low), coordinates(got.high));
    for (got, exact) in low.into_iter().chain(high).zip([-1.0, 0.3, -1.0, 1.0, 0.302, 1.0]) {
        assert!((got - exact).abs() < 0.1 && got.abs() <= 1.001, "{low:?} {high:?}");
    }
    assert!((low[1] - 0.3).abs() < 1e-3 && (high[1] - 0.302).abs() < 1e-3, "{low:?} {high:?}");
}

fn what_has_no_mass_is_an_error<S: Tested>() {
    let part = ball::<S>([0.0; 3], 1.0);
    let weigh = |within: Bounds<S>, rows: u16| {
        MassProperties::of(&part, within, rows, &mut SpanList::<S, 4>::new()).map(|_| ())
    };
    let cube = |low: f64, high: f64| Bounds::Box { low: vector([low; 3]), high: vector([high; 3]) };
    assert_eq!(weigh(cube(-1.0, 1.0), 8), Ok(()));
    assert_eq!(weigh(part.bounds(), 8), Ok(()));
    assert_eq!(weigh(Bounds::Unbounded, 8), Err(MassError::Unbounded));
    assert_eq!(weigh(Bounds::Ball { center: vector([0.0; 3]), radius: S::near(1.0) }, 8), Ok(()));
    for rows in [0, 1] {
        assert_eq!(weigh(cube(-1.0, 1.0), rows), Err(MassError::Rows));
    }
    for (low, high) in [(1.0, -1.0), (0.5, 0.5), (2.0, 3.0)] {
        assert_eq!(weigh(cube(low, high), 8), Err(MassError::Empty));
    }
    let all = S::MAX_COORDINATE.to_f64();
    let beyond = Bounds::Ball { center: vector([0.0; 3]), radius: S::MAX_COORDINATE.up() };
    assert_eq!(weigh(beyond, 2), Err(MassError::TooFar));
    if S::IS_FIXED {
        assert_eq!(weigh(cube(-all, all), 2), Err(MassError::TooFar));
    }
    // A side whose square is beyond 2³¹.
    let long = Bounds::Box { low: vector([-all, 0.0, 0.0]), high: vector([all, 1.0, 1.0]) };
    let is_too_long = S::IS_FIXED && all > 23_000.0;
    assert_eq!(weigh(long, 2) == Err(MassError::TooFar), is_too_long);
    for &wrong in S::NO_NUMBERS {
        let high = Vec3::new(S::ONE, wrong, S::ONE);
        let within = Bounds::Box { low: Vec3::ZERO, high };
        assert_eq!(weigh(within, 8), Err(MassError::Unbounded));
    }
}

for_every_number!(formulas_hold, thin_plates_have_an_extent, what_has_no_mass_is_an_error);
