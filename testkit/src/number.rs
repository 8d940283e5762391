//! The number types that tests are written for once: what a test needs to know of them, and the
//! constructors, which traits can't have as `const fn`.

use crate::limits;
use fixed::types::{I8F24, I20F12, I24F8};
use scancsg::geom::{Pose, PoseError, Ray, Vec3, vec3};
use scancsg::scalar::{FixedPoint, I16F16, Scalar};
use scancsg::solid::{
    Cone, ConeError, Cylinder, CylinderError, RayCast, Slab, SlabError, Solid, Sphere, SphereError,
    Torus, TorusError,
};
use scancsg::span::SpanList;

/// Makes tests of functions with a number type as their parameter. Of the other formats of fixed point,
/// `I20F12` has all coordinates of the tests in its range: to 65,536, and a unit is 1/4096.
#[macro_export]
macro_rules! for_every_number {
    ($($test:ident),+ $(,)?) => {
        mod f32 {
            $(#[test] fn $test() { super::$test::<f32>(); })+
        }
        mod f64 {
            $(#[test] fn $test() { super::$test::<f64>(); })+
        }
        mod i16f16 {
            $(#[test] fn $test() { super::$test::<scancsg::scalar::I16F16>(); })+
        }
        mod i20f12 {
            $(#[test] fn $test() { super::$test::<fixed::types::I20F12>(); })+
        }
    };
}

/// A number type under test.
pub trait Tested: Scalar {
    /// What the type has that is no number: NaN and both infinities, or nothing.
    const NO_NUMBERS: &'static [Self];

    /// Whether all numbers are as far apart, and parameters known to half of that.
    const IS_FIXED: bool;

    /// The distance from 1 to the next larger number.
    const UNIT: f64;

    /// The nearest number.
    fn near(x: f64) -> Self;

    /// The next larger number.
    fn up(self) -> Self;

    /// The next smaller number.
    fn down(self) -> Self;

    /// A cylinder along coordinate axis 0, 1 or 2; `middle` are the other coordinates in order.
    fn along(
        axis: usize,
        middle: [Self; 2],
        radius: Self,
        low: Self,
        high: Self,
    ) -> Result<Cylinder<Self>, CylinderError>;

    fn between(
        from: Vec3<Self>,
        to: Vec3<Self>,
        radius: Self,
    ) -> Result<Cylinder<Self>, CylinderError>;

    /// A cone as [`along`](Self::along) makes cylinders.
    fn cone_along(
        axis: usize,
        middle: [Self; 2],
        radii: [Self; 2],
        low: Self,
        high: Self,
    ) -> Result<Cone<Self>, ConeError>;

    fn cone_between(
        from: Vec3<Self>,
        to: Vec3<Self>,
        radii: [Self; 2],
    ) -> Result<Cone<Self>, ConeError>;

    fn slab_along(axis: usize, low: Self, high: Self) -> Result<Slab<Self>, SlabError>;

    fn slab(normal: Vec3<Self>, low: Self, high: Self) -> Result<Slab<Self>, SlabError>;

    fn sphere(center: Vec3<Self>, radius: Self) -> Result<Sphere<Self>, SphereError>;

    /// A torus with its axis along coordinate axis 0, 1 or 2; `radii` are those of ring and tube.
    fn torus_along(
        axis: usize,
        center: Vec3<Self>,
        radii: [Self; 2],
    ) -> Result<Torus<Self>, TorusError>;

    fn torus(
        center: Vec3<Self>,
        axis: Vec3<Self>,
        radii: [Self; 2],
    ) -> Result<Torus<Self>, TorusError>;

    fn translation(by: Vec3<Self>) -> Result<Pose<Self>, PoseError>;

    /// A direction as solids hold it, exactly.
    fn rounded_axis(axis: Vec3<Self>) -> [f64; 3];
}

/// The constructors of a type, for the inside of `impl Tested`.
macro_rules! constructors {
    ($S:ty) => {
        fn along(
            axis: usize,
            [a, b]: [Self; 2],
            radius: Self,
            low: Self,
            high: Self,
        ) -> Result<Cylinder<Self>, CylinderError> {
            match axis {
                0 => Cylinder::<$S>::along_x(a, b, radius, low, high),
                1 => Cylinder::<$S>::along_y(a, b, radius, low, high),
                _ => Cylinder::<$S>::along_z(a, b, radius, low, high),
            }
        }

        fn between(
            from: Vec3<Self>,
            to: Vec3<Self>,
            radius: Self,
        ) -> Result<Cylinder<Self>, CylinderError> {
            Cylinder::<$S>::between(from, to, radius)
        }

        fn cone_along(
            axis: usize,
            [a, b]: [Self; 2],
            radii: [Self; 2],
            low: Self,
            high: Self,
        ) -> Result<Cone<Self>, ConeError> {
            match axis {
                0 => Cone::<$S>::along_x(a, b, radii, low, high),
                1 => Cone::<$S>::along_y(a, b, radii, low, high),
                _ => Cone::<$S>::along_z(a, b, radii, low, high),
            }
        }

        fn cone_between(
            from: Vec3<Self>,
            to: Vec3<Self>,
            radii: [Self; 2],
        ) -> Result<Cone<Self>, ConeError> {
            Cone::<$S>::between(from, to, radii)
        }

        fn slab_along(axis: usize, low: Self, high: Self) -> Result<Slab<Self>, SlabError> {
            match axis {
                0 => Slab::<$S>::along_x(low, high),
                1 => Slab::<$S>::along_y(low, high),
                _ => Slab::<$S>::along_z(low, high),
            }
        }

        fn slab(normal: Vec3<Self>, low: Self, high: Self) -> Result<Slab<Self>, SlabError> {
            Slab::<$S>::new(normal, low, high)
        }

        fn sphere(center: Vec3<Self>, radius: Self) -> Result<Sphere<Self>, SphereError> {
            Sphere::<$S>::new(center, radius)
        }

        fn torus_along(
            axis: usize,
            center: Vec3<Self>,
            [ring, tube]: [Self; 2],
        ) -> Result<Torus<Self>, TorusError> {
            match axis {
                0 => Torus::<$S>::along_x(center, ring, tube),
                1 => Torus::<$S>::along_y(center, ring, tube),
                _ => Torus::<$S>::along_z(center, ring, tube),
            }
        }

        fn torus(
            center: Vec3<Self>,
            axis: Vec3<Self>,
            [ring, tube]: [Self; 2],
        ) -> Result<Torus<Self>, TorusError> {
            Torus::<$S>::new(center, axis, ring, tube)
        }

        fn translation(by: Vec3<Self>) -> Result<Pose<Self>, PoseError> {
            Pose::<$S>::translation(by)
        }
    };
}

macro_rules! float {
    ($S:ident) => {
        impl Tested for $S {
            const NO_NUMBERS: &'static [Self] = &[$S::NAN, $S::INFINITY, $S::NEG_INFINITY];
            const IS_FIXED: bool = false;
            const UNIT: f64 = $S::EPSILON as f64;

            fn near(x: f64) -> Self {
                x as $S
            }

            fn up(self) -> Self {
                self.next_up()
            }

            fn down(self) -> Self {
                self.next_down()
            }

            fn rounded_axis(axis: Vec3<Self>) -> [f64; 3] {
                Self::normalized(axis.to_array()).unwrap().map(f64::from)
            }

            constructors!($S);
        }
    };
}

float!(f32);
float!(f64);

macro_rules! fixed {
    ($($S:ty),+) => {$(
        impl Tested for $S {
            const NO_NUMBERS: &'static [Self] = &[];
            const IS_FIXED: bool = true;
            const UNIT: f64 = 1.0 / (1u64 << Self::FRAC_NBITS) as f64;

            fn near(x: f64) -> Self {
                // The cast saturates, so nothing wraps.
                Self::from_bits((x * 2f64.powi(Self::FRAC_NBITS as i32)).round() as i32)
            }

            fn up(self) -> Self {
                Self::from_bits(self.to_bits() + 1)
            }

            fn down(self) -> Self {
                Self::from_bits(self.to_bits() - 1)
            }

            fn rounded_axis(axis: Vec3<Self>) -> [f64; 3] {
                let units = Self::normalized(axis.to_array()).unwrap();
                units.map(|unit| f64::from(Self::unit_bits(unit)) / f64::from(1 << 28))
            }

            constructors!($S);
        }
    )+};
}

fixed!(I8F24, I16F16, I20F12, I24F8);

/// A point or a vector; the coordinates are rounded.
pub fn vector<S: Tested>([x, y, z]: [f64; 3]) -> Vec3<S> {
    vec3(S::near(x), S::near(y), S::near(z))
}

/// The coordinates, exactly.
pub fn coordinates<S: Tested>(v: Vec3<S>) -> [f64; 3] {
    v.to_array().map(S::to_f64)
}

/// A ray that must be valid; the coordinates are rounded.
pub fn ray<S: Tested>(origin: [f64; 3], direction: [f64; 3]) -> Ray<S> {
    Ray::new(vector(origin), vector(direction)).unwrap()
}

/// A cylinder along x around (0, 0) that must be valid.
pub fn rod<S: Tested>(radius: f64, low: f64, high: f64) -> Cylinder<S> {
    S::along(0, [S::ZERO; 2], S::near(radius), S::near(low), S::near(high)).unwrap()
}

/// A cylinder between two points that must be valid.
pub fn between<S: Tested>(from: [f64; 3], to: [f64; 3], radius: f64) -> Cylinder<S> {
    S::between(vector(from), vector(to), S::near(radius)).unwrap()
}

/// A ball that must be valid.
pub fn ball<S: Tested>(center: [f64; 3], radius: f64) -> Sphere<S> {
    S::sphere(vector(center), S::near(radius)).unwrap()
}

/// The parameters of all spans of a line, exactly.
pub fn spans<S: Tested, T: Solid<Scalar = S>>(solid: &T, ray: &Ray<S>) -> Vec<(f64, f64)> {
    let mut list = SpanList::<S, 64>::new();
    let spans = solid.trace(ray, &mut list).iter();
    // + 0.0 makes −0 into 0, which is the same parameter.
    spans.map(|span| (span.enter.t.to_f64() + 0.0, span.exit.t.to_f64() + 0.0)).collect()
}

/// The spans of a line have to be these: in fixed point at the nearest numbers, in floating point within
/// 4 ε of the parameter.
#[track_caller]
pub fn assert_spans<S: Tested, T: Solid<Scalar = S>>(solid: &T, ray: &Ray<S>, want: &[(f64, f64)]) {
    let got = spans(solid, ray);
    let units = limits::SPANS.of::<S>();
    let allowed = |t: f64| if S::IS_FIXED { units + limits::WANTED } else { units * t.abs() };
    let is_near = |got: f64, want: f64| (got - want).abs() <= allowed(want);
    let all_near =
        got.iter().zip(want).all(|(got, want)| is_near(got.0, want.0) && is_near(got.1, want.1));
    assert!(got.len() == want.len() && all_near, "{got:?} is not {want:?}");
}
