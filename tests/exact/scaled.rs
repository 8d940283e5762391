//! Ellipsoids against exact arithmetic: which rays hit, and where.
//!
//! All numbers are whole multiples of powers of two. With the matrix's adjugate in place of its inverse, so
//! are the coefficients of the quadratic; the root alone is cut off, hundreds of bits below what counts.

use dashu_int::ops::{BitTest, SquareRoot};
use dashu_int::{IBig, UBig};
use scancsg::geom::{AffineMap, Ray};
use scancsg::scalar::I16F16;
use scancsg::solid::{RayCast, Scaled, Sphere};
use scancsg::span::SpanList;
use std::ops::{Add, Mul, Sub};
use testkit::number::{Tested, coordinates, vector};
use testkit::random::Random;
use testkit::ulp::{percentiles, ulps};
use testkit::vector::{V, add, along, cross, dot, length, sub, times, unit};

/// A whole multiple of a power of two.
#[derive(Debug, Clone)]
struct Dyadic(IBig, i32);

impl Dyadic {
    fn of(x: f64) -> Self {
        assert!(x.is_finite());
        let bits = x.to_bits();
        let field = (bits >> 52 & 0x7ff) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let mantissa = if field == 0 { fraction } else { fraction | 1 << 52 };
        Self(IBig::from(if x < 0.0 { -mantissa } else { mantissa }), field.max(1) - 1075)
    }

    /// Both in the smaller one's unit.
    fn aligned(&self, other: &Self) -> (IBig, IBig, i32) {
        let unit = self.1.min(other.1);
        let raised = |x: &Self| &x.0 << (x.1 - unit) as usize;
        (raised(self), raised(other), unit)
    }

    fn is_negative(&self) -> bool {
        self.0 < IBig::ZERO
    }

    /// The root, cut off 600 bits below the number.
    fn sqrt(&self) -> Self {
        let shift = 1200 + (self.1 & 1).unsigned_abs() as usize;
        let square = UBig::try_from(&self.0 << shift).unwrap();
        Self(IBig::from(square.sqrt()), (self.1 - shift as i32) / 2)
    }

    fn over(&self, divisor: &Self) -> f64 {
        let quotient = (&self.0 << (200 + divisor.0.bit_len())) / &divisor.0;
        let exponent = self.1 - divisor.1 - 200 - divisor.0.bit_len() as i32;
        // In two steps: neither power of two may vanish.
        let cut = quotient.bit_len().saturating_sub(120);
        (quotient >> cut).to_f64().value() * 2f64.powi(exponent + cut as i32)
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: Self) -> Dyadic {
        let (a, b, unit) = self.aligned(other);
        Dyadic(a + b, unit)
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: Self) -> Dyadic {
        let (a, b, unit) = self.aligned(other);
        Dyadic(a - b, unit)
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: Self) -> Dyadic {
        Dyadic(&self.0 * &other.0, self.1 + other.1)
    }
}

type D3 = [Dyadic; 3];

fn exact(v: V) -> D3 {
    v.map(Dyadic::of)
}

fn product(u: &D3, v: &D3) -> Dyadic {
    &(&(&u[0] * &v[0]) + &(&u[1] * &v[1])) + &(&u[2] * &v[2])
}

fn vector_product(u: &D3, v: &D3) -> D3 {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &(&u[i] * &v[j]) - &(&u[j] * &v[i]))
}

/// The ball of a radius around a point, taken by a matrix (by its columns) and a shift.
#[derive(Debug, Clone, Copy)]
struct Ellipsoid {
    columns: [V; 3],
    shift: V,
    center: V,
    radius: f64,
}

/// What is true about a ray.
struct Truth {
    /// Of the whole line.
    span: Option<[f64; 2]>,
    /// Whether the ray hits, if the ellipsoid grown and shrunk agree.
    robust: Option<bool>,
}

impl Ellipsoid {
    /// `margin` is by how much the ellipsoid is grown and shrunk, in 10⁻⁹ of its size.
    fn truth(&self, origin: V, direction: V, margin: i64) -> Truth {
        let columns = self.columns.map(exact);
        // The rows of the adjugate.
        let adjugate =
            [(1, 2), (2, 0), (0, 1)].map(|(i, j)| vector_product(&columns[i], &columns[j]));
        let determinant = product(&columns[0], &adjugate[0]);
        let from_shift: D3 =
            std::array::from_fn(|i| &Dyadic::of(origin[i]) - &Dyadic::of(self.shift[i]));
        let way = exact(direction);
        let u: D3 = std::array::from_fn(|i| {
            &product(&adjugate[i], &from_shift) - &(&determinant * &Dyadic::of(self.center[i]))
        });
        let d: D3 = std::array::from_fn(|i| product(&adjugate[i], &way));
        let (a, b, distance) = (product(&d, &d), product(&u, &d), product(&u, &u));
        let reach = &determinant * &Dyadic::of(self.radius);
        let roots = |parts: i64| {
            let billion = Dyadic(IBig::from(1_000_000_000), 0);
            let scaled = &reach * &Dyadic(IBig::from(1_000_000_000 + parts), 0);
            let (b, square) = (&b * &billion, &(&distance * &billion) * &billion);
            let c = &square - &(&scaled * &scaled);
            let discriminant = &(&b * &b) - &(&a * &c);
            if discriminant.is_negative() {
                return None;
            }
            let (root, minus) = (discriminant.sqrt(), Dyadic(IBig::ZERO, 0));
            let minus_b = &minus - &b;
            Some(([&minus_b - &root, &minus_b + &root], &a * &billion))
        };
        let hits = [-margin, margin]
            .map(|parts| roots(parts).is_some_and(|(ends, _)| !ends[1].is_negative()));
        Truth {
            span: roots(0).map(|(ends, by)| ends.map(|end| end.over(&by))),
            robust: (hits[0] == hits[1]).then_some(hits[0]),
        }
    }

    fn solid<S: Tested>(&self) -> Scaled<Sphere<S>> {
        let ball = Sphere::<S>::around(vector(self.center), S::near(self.radius)).unwrap();
        Scaled::new(
            ball,
            AffineMap::with_columns(self.columns.map(vector), vector(self.shift)).unwrap(),
        )
    }

    /// With every number rounded to the type's.
    fn rounded<S: Tested>(self) -> Self {
        let round = |v: V| coordinates(vector::<S>(v));
        Self {
            columns: self.columns.map(round),
            shift: round(self.shift),
            center: round(self.center),
            radius: S::near(self.radius).to_f64(),
        }
    }

    /// The normal of the point nearest by: the cofactors take normals, as far as their length goes.
    fn normal(&self, at: V) -> V {
        let [x, y, z] = self.columns;
        let cofactors = [cross(y, z), cross(z, x), cross(x, y)];
        let volume = dot(x, cofactors[0]);
        let own: V = std::array::from_fn(|i| {
            dot(cofactors[i], sub(at, self.shift)) / volume - self.center[i]
        });
        let normal = (0..3).fold([0.0; 3], |sum, i| along(sum, own[i] / volume, cofactors[i]));
        unit(normal)
    }

    /// A point or a vector of the own frame, with the ball as the unit ball, in the scene.
    fn way(&self, own: V) -> V {
        let [x, y, z] = self.columns.map(|column| times(column, self.radius));
        add(add(times(x, own[0]), times(y, own[1])), times(z, own[2]))
    }

    fn point(&self, own: V) -> V {
        let [x, y, z] = self.columns;
        let middle =
            add(add(times(x, self.center[0]), times(y, self.center[1])), times(z, self.center[2]));
        add(add(self.way(own), middle), self.shift)
    }

    /// Semi-axes from 1/`ratio` to `ratio`, in any direction; a third of them mirrored. The own ball has
    /// about the radius `size`.
    fn drawn(random: &mut Random, size: f64, ratio: f64) -> Self {
        let mut frame = || {
            let x = random.direction();
            let y = unit(cross(x, random.direction()));
            [x, y, cross(x, y)]
        };
        let (outer, inner) = (frame(), frame());
        let radius = size * random.between(0.7, 1.4);
        let mut scale = [(); 3].map(|()| ratio.powf(random.between(-1.0, 1.0)) / radius);
        if random.chance(0.3) {
            scale[0] = -scale[0];
        }
        let columns = std::array::from_fn(|j| {
            (0..3).fold([0.0; 3], |sum, k| along(sum, scale[k] * inner[k][j], outer[k]))
        });
        let shift = if random.chance(0.5) { [0.0; 3] } else { random.point(3.0) };
        let center = if random.chance(0.7) { [0.0; 3] } else { random.point(radius) };
        Self { columns, shift, center, radius }
    }
}

const KINDS: [&str; 5] = ["ordinary", "far", "grazing", "inside", "surface"];

/// A ray of a kind at an ellipsoid.
fn ray(random: &mut Random, kind: &str, it: &Ellipsoid, farthest: f64) -> [V; 2] {
    let middle = it.point([0.0; 3]);
    let within = |random: &mut Random| times(random.direction(), random.between(0.0, 1.0).cbrt());
    match kind {
        "grazing" => {
            let n = random.direction();
            let tangent = unit(cross(n, random.direction()));
            let by = 10f64.powf(random.between(-6.0, -1.0)) * random.sign();
            let start = along(times(n, 1.0 + by), -random.between(1.5, 5.0), tangent);
            let way = it.way(tangent);
            [it.point(start), times(way, random.between(0.6, 1.9) / length(way))]
        }
        "inside" => [it.point(times(within(random), 0.9)), random.direction()],
        "surface" => [it.point(random.direction()), random.direction()],
        _ => {
            let far = if kind == "far" {
                10f64.powf(random.between(3.0, farthest))
            } else {
                random.between(3.0, 9.0)
            };
            let start = along(middle, far, random.direction());
            // Half of them beside it.
            let aim = it.point(times(within(random), 1.5));
            let way = sub(aim, start);
            [start, times(way, random.between(0.6, 1.9) / length(way))]
        }
    }
}

/// What was seen of many rays.
struct Outcome {
    robust: u32,
    wrong: u32,
    /// Errors of both ends, in ulps of `f32` or in LSB.
    errors: Vec<f64>,
    /// Largest angle between a normal and the right one, in radians.
    angle: f64,
}

/// What is asked: ellipsoids of own balls of a size, with semi-axes from 1/`ratio` to `ratio`; how far the
/// farthest rays start, as a power of ten; and what counts as robust.
struct Asked {
    count: u32,
    size: f64,
    ratio: f64,
    farthest: f64,
    margin: i64,
}

impl Asked {
    fn cast<S: Tested>(&self, kind: &str) -> Outcome {
        let mut random = Random::named(kind);
        let mut outcome = Outcome { robust: 0, wrong: 0, errors: Vec::new(), angle: 0.0 };
        let drawn = |random: &mut Random| {
            let it = Ellipsoid::drawn(random, self.size, self.ratio).rounded::<S>();
            (it, it.solid::<S>())
        };
        let (mut it, mut solid) = drawn(&mut random);
        for number in 0..self.count {
            if number % 20 == 0 {
                (it, solid) = drawn(&mut random);
            }
            let [origin, direction] = ray(&mut random, kind, &it, self.farthest).map(vector::<S>);
            let Ok(ray) = Ray::new(origin, direction) else { continue };
            let [origin, direction] = [origin, direction].map(coordinates);
            let truth = it.truth(origin, direction, self.margin);
            let mut list = SpanList::<S, 1>::new();
            let hit = solid.hit(&ray, &mut list);
            let Some(hits) = truth.robust else { continue };
            outcome.robust += 1;
            outcome.wrong += u32::from(hit.is_some() != hits);
            let (Some(span), true, Some(hit)) = (truth.span, hits, hit) else { continue };
            let end = span[usize::from(hit.inside)];
            let normal = times(
                it.normal(along(origin, end, direction)),
                if hit.inside { -1.0 } else { 1.0 },
            );
            outcome.angle = outcome.angle.max(length(cross(normal, coordinates(hit.normal))));
            if let [got] = solid.trace(&ray, &mut list) {
                for (got, want) in [got.enter.t, got.exit.t].into_iter().zip(span) {
                    let off = (got.to_f64() - want).abs();
                    let error = if S::IS_FIXED { off / S::UNIT } else { ulps(got.to_f64(), want) };
                    outcome.errors.push(error);
                }
            }
        }
        outcome
    }

    /// No robust ray is given a wrong hit or miss. Of ordinary rays, returns the 99th percentile of errors
    /// and the largest angle between a normal and the right one.
    fn check<S: Tested>(&self) -> [f64; 2] {
        let [mut ordinary, mut angle] = [0.0; 2];
        for kind in KINDS {
            let outcome = self.cast::<S>(kind);
            let [median, p99, most] = percentiles(&outcome.errors).unwrap();
            let Outcome { robust, wrong, .. } = outcome;
            println!(
                "{kind:9} {robust:6} robust, {wrong} wrong; t {median:.2} {p99:.2} {most:.1}; \
                 normals {:.1e}",
                outcome.angle
            );
            assert_eq!(wrong, 0, "{kind}");
            assert!(robust > self.count / 3, "{kind}: {robust}");
            if kind == "ordinary" {
                (ordinary, angle) = (p99, outcome.angle);
            }
        }
        [ordinary, angle]
    }
}

/// All of a table's rays take a minute where nothing is optimised.
const COUNT: u32 = if cfg!(debug_assertions) { 10_000 } else { 100_000 };

#[test]
fn ellipsoids_in_f32() {
    let asked = Asked { count: COUNT, size: 1.0, ratio: 2.0, farthest: 6.0, margin: 1000 };
    let [p99, angle] = asked.check::<f32>();
    assert!(p99 <= 3.0, "{p99}");
    assert!(angle <= 1e-5, "{angle}");
}

#[test]
fn flat_and_long_ellipsoids_in_f32() {
    let asked = Asked { count: COUNT / 5, size: 1.0, ratio: 30.0, farthest: 6.0, margin: 1000 };
    asked.check::<f32>();
}

#[test]
fn ellipsoids_in_f64() {
    let asked = Asked { count: COUNT / 5, size: 1.0, ratio: 10.0, farthest: 6.0, margin: 1000 };
    let [p99, angle] = asked.check::<f64>();
    assert!(p99 <= 0.001 && angle <= 1e-9, "{p99} {angle}");
}

/// Made 16 times as large as it is in the scene, an ellipsoid is as exact as a sphere.
#[test]
fn ellipsoids_in_fixed_point() {
    let asked = Asked { count: COUNT / 5, size: 16.0, ratio: 2.0, farthest: 3.3, margin: 100_000 };
    let [p99, angle] = asked.check::<I16F16>();
    assert!(p99 <= 1.0, "{p99}");
    assert!(angle <= 0.002, "{angle}");
    // Made as large as it is, its own frame's units are those of the scene.
    for (size, most) in [(8.0, 0.8), (4.0, 1.1), (2.0, 2.0), (1.0, 4.0)] {
        println!("own radius {size}");
        let asked = Asked { size, ..asked };
        let [p99, angle] = asked.check::<I16F16>();
        assert!(p99 <= most, "{size}: {p99}");
        assert!(angle <= 0.005, "{size}: {angle}");
    }
}
