//! `pipe`: a hollow tube along a B-spline, about as large as `tee`.

use super::{BRASS, STEEL, Scene};
use scancsg::constant;
use scancsg::geom::{Vec3, vec3};
use scancsg::scalar::I16F16;
use scancsg::solid::{Difference, Painted, Pipe, PipeError};
use scancsg::spline::{Curve, Knots, SplineScalar};

/// How many segments there is room for: in a picture of 480 rows they follow the curve to a quarter
/// of a pixel.
pub const ROOM: usize = 128;

/// The outside, minus the bore along the same curve.
pub type HollowPipe<S> = Difference<Pipe<S, ROOM>, Pipe<S, ROOM>>;

/// The same in two colours.
pub type PaintedPipe<S> = Difference<Painted<Pipe<S, ROOM>>, Painted<Pipe<S, ROOM>>>;

const POINTS: usize = 10;
const KNOTS: usize = POINTS + 4;

/// The pipe in a number type.
pub trait PipeScene: Scene + SplineScalar {
    /// Its middle line.
    const PATH: Curve<Vec3<Self>, 4, POINTS, KNOTS>;

    /// The outside and the bore, nowhere farther than `tolerance` from the tubes that they stand for.
    fn tubes(tolerance: Self) -> Result<[Pipe<Self, ROOM>; 2], PipeError>;

    /// The pipe.
    fn pipe(tolerance: Self) -> Result<HollowPipe<Self>, PipeError> {
        let [outside, bore] = Self::tubes(tolerance)?;
        Ok(outside - bore)
    }

    /// The pipe, steel outside and brass inside.
    fn painted_pipe(tolerance: Self) -> Result<PaintedPipe<Self>, PipeError> {
        let [outside, bore] = Self::tubes(tolerance)?;
        Ok(Painted::new(outside, STEEL) - Painted::new(bore, BRASS))
    }
}

macro_rules! pipe {
    ($module:ident, $Scalar:ty) => {
        mod $module {
            use super::super::$module::n;
            use super::*;

            pub(super) const MIDDLE: Curve<Vec3<$Scalar>, 4, POINTS, KNOTS> =
                constant!(Curve::<Vec3<$Scalar>, 4, POINTS, KNOTS>::new(
                    CLAMPED,
                    [
                        vec3(n(170), n(-85), n(112)),
                        vec3(n(133), n(-90), n(10)),
                        vec3(n(58), n(-94), n(-148)),
                        vec3(n(-165), n(-85), n(-139)),
                        vec3(n(-174), n(-57), n(112)),
                        vec3(n(40), n(-11), n(186)),
                        vec3(n(198), n(36), n(28)),
                        vec3(n(96), n(82), n(-158)),
                        vec3(n(-109), n(129), n(-139)),
                        vec3(n(-128), n(148), n(84)),
                    ]
                ));
            const CLAMPED: Knots<$Scalar, 4, KNOTS> =
                constant!(Knots::<$Scalar, 4, KNOTS>::clamped_uniform(POINTS, n(0), n(700)));

            pub(super) const RADII: [$Scalar; 2] = [n(35), n(25)];
        }

        impl PipeScene for $Scalar {
            const PATH: Curve<Vec3<Self>, 4, POINTS, KNOTS> = $module::MIDDLE;

            fn tubes(tolerance: Self) -> Result<[Pipe<Self, ROOM>; 2], PipeError> {
                let [outside, bore] = $module::RADII;
                Ok([
                    Pipe::<Self, ROOM>::along(&Self::PATH, outside, tolerance)?,
                    Pipe::<Self, ROOM>::along(&Self::PATH, bore, tolerance)?,
                ])
            }
        }
    };
}

pipe!(f32, f32);
pipe!(f64, f64);
pipe!(i16f16, I16F16);
