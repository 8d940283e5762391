//! Solids on one axis: caps at the same position along it are the same plane, so no film shows where they are
//! flush.

use proptest::prelude::*;
use scancsg::constant;
use scancsg::geom::{AxisLine, AxisLineError, Line, RayRow, Rays, Vec3, vec3};
use scancsg::render::{Camera, Gray8, Orthographic, Perspective, Picture, Size, XRay};
use scancsg::scalar::I16F16;
use scancsg::solid::{Cone, Cylinder, CylinderError, Difference, RayCast, Scan};
use scancsg::span::{Face, SpanList};
use testkit::number::{Tested, coordinates, vector};
use testkit::random::Random;
use testkit::vector::{V, along, cross, dot, length, sub, times, unit};

const CUPS: u32 = 300;
/// The faces of the upper caps of the body and of the hollow.
const RIM: Face = Face(1);
const FILM: Face = Face(4);

type Cup<S> = Difference<Cylinder<S>, Cylinder<S>>;

struct Drawn<S: Tested> {
    cup: Cup<S>,
    /// The middle of the opening, the direction out of it, and a frame across.
    top: V,
    out: V,
    across: [V; 2],
    radius: f64,
}

impl<S: Tested> Drawn<S> {
    fn new(random: &mut Random) -> Self {
        let from = random.point(2.0);
        let (way, long) = (random.direction(), random.between(0.5, 3.0));
        let to = along(from, long, way);
        let radius = random.between(0.2, 1.2);
        let axis = AxisLine::from_to(vector::<S>(from), vector(to)).unwrap();
        let end = axis.length();
        let bottom = S::near(random.between(0.1, 0.9) * end.to_f64());
        let [outer, inner] = [radius, 0.8 * radius].map(S::near);
        let body = Cylinder::<S>::on_axis(&axis, outer, S::ZERO, end).unwrap();
        let hollow = Cylinder::<S>::on_axis(&axis, inner, bottom, end).unwrap();
        let helper = if way[0].abs() < 0.5 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let u = unit(cross(way, helper));
        let across = [u, cross(way, u)];
        Self { cup: body - hollow, top: to, out: way, across, radius }
    }

    /// Whether a ray that sees a face there sees a film over the opening.
    fn is_film(&self, face: Face, at: V) -> bool {
        let u = sub(at, self.top);
        let beside = length(sub(u, times(self.out, dot(u, self.out))));
        face == FILM || (face == RIM && beside < 0.8 * self.radius - 0.001)
    }

    /// A point of the opening.
    fn opening(&self, random: &mut Random) -> V {
        let (r, angle) = (random.between(0.0, 0.79) * self.radius, random.between(0.0, 6.3));
        let [u, v] = self.across;
        along(along(self.top, r * angle.cos(), u), r * angle.sin(), v)
    }

    fn films_of_rays(&self, random: &mut Random) -> u32 {
        let mut list = SpanList::<S, 8>::new();
        let mut films = 0;
        for _ in 0..1000 {
            let aim = self.opening(random);
            let from = along(random.direction(), random.between(1.0, 3.0), self.out);
            let far = random.between(1.0, 8.0);
            let way = times(from, -1.0 / length(from));
            let start = along(aim, -far, way);
            let ray = scancsg::geom::Ray::new(vector(start), vector::<S>(way)).unwrap();
            let Some(hit) = self.cup.hit(&ray, &mut list) else { continue };
            films += u32::from(self.is_film(hit.face, coordinates(hit.point)));
        }
        films
    }

    fn films_of_picture<C>(&self, camera: &C) -> [u32; 2]
    where
        C: Camera<Rays: Rays<Scalar = S>>,
        Cup<S>: Scan<C::Rays, Scalar = S>,
    {
        let size = Size::new(64, 64).unwrap();
        let shader = XRay::new(S::ONE).unwrap();
        let mut picture = Picture::new(&self.cup, camera, size, shader, Gray8(0));
        let rays = camera.rays(size);
        let (mut films, mut seen) = (0, 0);
        for y in 0..64 {
            let mut row = picture.scanline(y).unwrap();
            let lines = rays.row(2 * i32::from(y) - 63);
            for x in 0..64 {
                let Some(it) = row.seen(x) else { continue };
                let line: Line<S> = lines.line(2 * i32::from(x) - 63);
                seen += 1;
                films += u32::from(self.is_film(it.face, coordinates(line.at(it.t))));
            }
        }
        [films, seen]
    }
}

fn no_film_shows<S: Tested>() {
    let mut random = Random::named("cups");
    let mut pixels = 0;
    for number in 0..CUPS {
        let cup = Drawn::<S>::new(&mut random);
        assert_eq!(cup.films_of_rays(&mut random), 0, "cup {number}");
        let back = along(times(cup.out, -1.0), 0.6, random.direction());
        let [target, up] = [cup.top, cup.across[0]].map(vector::<S>);
        let height = S::near(2.5 * cup.radius);
        let camera = Orthographic::look_along(vector(back), target, up, height).unwrap();
        let eye = vector(along(cup.top, -3.0, back));
        let perspective = Perspective::look_at(eye, target, up, S::near(0.8)).unwrap();
        for [films, seen] in [cup.films_of_picture(&camera), cup.films_of_picture(&perspective)] {
            assert_eq!(films, 0, "cup {number}");
            pixels += seen;
        }
    }
    assert!(pixels > 500_000, "{pixels}");
}

#[test]
fn no_film_shows_in_f32() {
    no_film_shows::<f32>();
}

#[test]
fn no_film_shows_in_i16f16() {
    no_film_shows::<I16F16>();
}

/// A funnel: a cone minus a cone, on one axis. Rays into its opening see no film.
fn no_film_shows_on_cones<S: Tested>() {
    let mut random = Random::named("funnels");
    let mut hits = 0;
    for number in 0..CUPS {
        let cup = Drawn::<S>::new(&mut random);
        let [from, to] = [along(cup.top, -1.5, cup.out), cup.top].map(vector::<S>);
        let axis = AxisLine::from_to(from, to).unwrap();
        let end = axis.length();
        let [half, most] = [0.5, 0.8].map(|part| S::near(part * cup.radius));
        let body = Cone::<S>::on_axis(&axis, [half, S::near(cup.radius)], S::ZERO, end).unwrap();
        let hollow = Cone::on_axis(&axis, [S::ZERO, most], S::near(0.25), end).unwrap();
        let funnel = body - hollow;
        let mut list = SpanList::<S, 8>::new();
        for _ in 0..300 {
            let aim = cup.opening(&mut random);
            let way = times(along(random.direction(), random.between(1.5, 3.0), cup.out), -1.0);
            let way = times(way, 1.0 / length(way));
            let start = vector::<S>(along(aim, -random.between(1.0, 8.0), way));
            let ray = scancsg::geom::Ray::new(start, vector(way)).unwrap();
            let Some(hit) = funnel.hit(&ray, &mut list) else { continue };
            hits += 1;
            assert!(!cup.is_film(hit.face, coordinates(hit.point)), "funnel {number}: {hit:?}");
        }
    }
    assert!(hits > 50 * CUPS, "{hits}");
}

#[test]
fn no_film_shows_on_cones_in_f32_and_i16f16() {
    no_film_shows_on_cones::<f32>();
    no_film_shows_on_cones::<I16F16>();
}

/// From the first point to the last, it is the cylinder between them; and what constants have, a type
/// parameter has, too.
macro_rules! same {
    ($S:ty, $numbers:expr) => {{
        let [a, b, c, d, e, f, r, s, t] = $numbers.map(<$S as Tested>::near);
        let (p, q) = (vec3(a, b, c), vec3(d, e, f));
        let axis = AxisLine::<$S>::between(p, q);
        prop_assert_eq!(AxisLine::<$S>::from_to(p, q), axis);
        if let Ok(axis) = axis {
            let whole = Cylinder::<$S>::on(&axis, r, <$S as Tested>::near(0.0), axis.length());
            prop_assert_eq!(whole, Cylinder::<$S>::between(p, q, r));
            let radii = [r, c];
            let whole = Cone::<$S>::on(&axis, radii, <$S as Tested>::near(0.0), axis.length());
            prop_assert_eq!(whole, Cone::<$S>::between(p, q, radii));
            for to in [t, axis.length()] {
                let part = Cone::<$S>::on(&axis, radii, s, to);
                prop_assert_eq!(Cone::<$S>::on_axis(&axis, radii, s, to), part);
                let part = Cylinder::<$S>::on(&axis, r, s, to);
                prop_assert_eq!(Cylinder::<$S>::on_axis(&axis, r, s, to), part);
            }
        }
    }};
}

proptest! {
    #[test]
    fn constants_and_generic_code_agree(numbers in prop::array::uniform9(-8.0..8.0)) {
        same!(f32, numbers);
        same!(f64, numbers);
        same!(I16F16, numbers);
    }
}

const SPINDLE: AxisLine<f32> =
    constant!(AxisLine::<f32>::between(vec3(0.0, 1.0, 2.0), vec3(3.0, 1.0, -2.0)));
static PIN: Cylinder<f32> = constant!(Cylinder::<f32>::on(&SPINDLE, 0.5, -1.0, SPINDLE.length()));

#[test]
fn an_axis_is_a_constant() {
    assert_eq!(SPINDLE.length(), 5.0);
    let from_below = vec3(-0.6, 1.0, 2.8);
    assert_eq!(PIN, Cylinder::<f32>::on_axis(&SPINDLE, 0.5, -1.0, 5.0).unwrap());
    let ray = scancsg::geom::Ray::new(from_below - vec3(3.0, 0.0, -4.0), vec3(3.0, 0.0, -4.0));
    let hit = PIN.hit(&ray.unwrap(), &mut SpanList::<f32, 1>::new()).unwrap();
    assert!((hit.t - 1.0).abs() < 1e-6, "{hit:?}");
}

#[test]
fn what_is_no_axis() {
    let (zero, x) = (Vec3::<f32>::ZERO, vec3(1.0f32, 0.0, 0.0));
    assert_eq!(AxisLine::<f32>::between(x, x), Err(AxisLineError::Empty));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for points in [[vec3(0.0, bad, 0.0), x], [x, vec3(0.0, 0.0, bad)]] {
            let [p, q] = points;
            assert_eq!(AxisLine::<f32>::between(p, q), Err(AxisLineError::NotFinite));
            assert_eq!(AxisLine::<f32>::from_to(p, q), Err(AxisLineError::NotFinite));
        }
        let axis = AxisLine::<f32>::between(zero, x).unwrap();
        for (from, to) in [(bad, 1.0), (0.0, bad)] {
            assert_eq!(Cylinder::<f32>::on(&axis, 1.0, from, to), Err(CylinderError::NotFinite));
        }
    }
    assert_eq!(AxisLine::<f32>::between(zero, vec3(0.0, 2e15, 0.0)), Err(AxisLineError::TooFar));
    let axis = AxisLine::<f32>::between(zero, x).unwrap();
    assert_eq!(Cylinder::<f32>::on(&axis, 1.0, 0.5, 0.5), Err(CylinderError::Empty));
}
