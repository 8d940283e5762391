//! The slab: what lies between two parallel planes. Three slabs make a box.

mod orthographic;
mod perspective;

use crate::geom::{Direction, Line, Vec3};
use crate::quadric::{Planes, meet};
use crate::scalar::{ConstOps, FixedI32, Fraction, Scalar};
use crate::scan::leaf;
use crate::solid::Solid;
use crate::span::{Face, Shape, SpanStack};

/// The points p with `low ≤ normal · p ≤ high`.
///
/// The offsets are stored as they were given, so two slabs with a plane in common cross every
/// line at the same bits there.
///
/// Face 0 is the plane at `low`, face 1 the one at `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slab<S: Scalar> {
    planes: Planes<S>,
}

/// Why a slab can't be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SlabError {
    /// A coordinate or an offset is infinite or NaN.
    NotFinite,
    /// The normal is zero.
    ZeroNormal,
    /// The low offset is not below the high one.
    Empty,
    /// An offset is larger than [`Scalar::MAX_COORDINATE`].
    TooFar,
}

crate::error_text!(SlabError {
    NotFinite => "a coordinate or an offset of the slab is infinite or not a number",
    ZeroNormal => "the normal of the slab is zero",
    Empty => "the low offset of the slab is not below the high one",
    TooFar => "the slab is too far away for its number type",
});

macro_rules! constructors {
    ($([$($generics:tt)*] $Scalar:ty),+) => {$(
        impl<$($generics)*> Slab<$Scalar> {
            /// The points with `low ≤ x ≤ high`.
            ///
            /// # Errors
            /// [`SlabError::NotFinite`], [`SlabError::Empty`], [`SlabError::TooFar`].
            pub const fn along_x(low: $Scalar, high: $Scalar) -> Result<Self, SlabError> {
                Self::with_normal(Direction::<$Scalar>::X, low, high)
            }

            /// The points with `low ≤ y ≤ high`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_y(low: $Scalar, high: $Scalar) -> Result<Self, SlabError> {
                Self::with_normal(Direction::<$Scalar>::Y, low, high)
            }

            /// The points with `low ≤ z ≤ high`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_z(low: $Scalar, high: $Scalar) -> Result<Self, SlabError> {
                Self::with_normal(Direction::<$Scalar>::Z, low, high)
            }

            /// The points with `low ≤ n·p ≤ high`, where n is `normal` brought to length 1.
            ///
            /// That is computed in `f64` or in integers of 128 bits: better in a constant.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x), and [`SlabError::ZeroNormal`].
            pub const fn new(
                normal: Vec3<$Scalar>,
                low: $Scalar,
                high: $Scalar,
            ) -> Result<Self, SlabError> {
                if !normal.has_finite_coordinates() {
                    return Err(SlabError::NotFinite);
                }
                match ConstOps::<$Scalar>::normalized([normal.x, normal.y, normal.z]) {
                    Some(normal) => Self::with_normal(Direction::<$Scalar>::new(normal), low, high),
                    None => Err(SlabError::ZeroNormal),
                }
            }

            /// The slab of a normal.
            pub(in crate::solid) const fn with_normal(
                normal: Direction<$Scalar>,
                low: $Scalar,
                high: $Scalar,
            ) -> Result<Self, SlabError> {
                if !(ConstOps::<$Scalar>::is_finite(low) && ConstOps::<$Scalar>::is_finite(high)) {
                    return Err(SlabError::NotFinite);
                }
                if !ConstOps::<$Scalar>::is_below(low, high) {
                    return Err(SlabError::Empty);
                }
                if !(ConstOps::<$Scalar>::is_within_reach(low) && ConstOps::<$Scalar>::is_within_reach(high)) {
                    return Err(SlabError::TooFar);
                }
                Ok(Self { planes: Planes { normal, low, high } })
            }
        }
    )+};
}

constructors!([] f32, [] f64, [F: Fraction] FixedI32<F>);

impl<S: Scalar> Shape for Slab<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = 2;
}

impl<S: Scalar> Solid for Slab<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        if let Some(span) = meet::planes(&self.planes, line).span() {
            stack.put(span.with_faces_from(first));
        }
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        self.planes.onto_face(face, near)
    }

    fn normal(&self, face: Face, _: Vec3<S>) -> Vec3<S> {
        self.planes.face_normal(face)
    }

    fn cosine(&self, face: Face, _: impl FnOnce() -> Vec3<S>, to: Vec3<S>) -> S {
        self.planes.face_cosine(face, to)
    }
}

leaf!([S: Scalar] Slab<S>);
