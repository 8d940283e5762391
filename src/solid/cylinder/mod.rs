//! The solid cylinder with caps.

mod parallel;
mod pencil;
mod tube;

pub(super) use tube::{Meeting, Tube};

use super::slab::{Slab, SlabError, unit};
use super::{Shape, Solid};
use crate::geom::{Direction, Line, Vec3};
use crate::scalar::Scalar;
use crate::span::{Crossing, Face, Span, SpanStack};

/// A solid cylinder with flat caps: the infinite cylinder, cut by a slab.
///
/// Face 0 is the cap at the lower end of the axis, face 1 the one at the upper end, face 2 the
/// wall. For cylinders along coordinate axes, the caps lie exactly at the given coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cylinder<S> {
    pub(super) tube: Tube<S>,
    /// Between the caps; its normal is the axis.
    pub(super) caps: Slab<S>,
}

/// Why a cylinder can't be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CylinderError {
    /// A coordinate or the radius is infinite or NaN.
    NotFinite,
    /// The radius is zero, negative, or not between [`Scalar::FINEST`] and [`Scalar::REACH`].
    Radius,
    /// A coordinate is larger than [`Scalar::REACH`].
    TooFar,
    /// The lower end is not below the upper end, or the end points coincide.
    Empty,
}

crate::error_text!(CylinderError {
    NotFinite => "a coordinate or the radius of the cylinder is infinite or not a number",
    Radius => "the radius of the cylinder is not positive, or out of its number type's range",
    TooFar => "the cylinder is too far away for its number type",
    Empty => "the cylinder has no length: its ends coincide or are the wrong way round",
});

const WALL: Face = Face(2);

macro_rules! constructors {
    ($($Float:ident),+) => {$(
        impl Cylinder<$Float> {
            /// A cylinder along the x axis, around the line at (`y`, `z`), from `x_min` to
            /// `x_max`.
            ///
            /// # Errors
            /// [`CylinderError::NotFinite`], [`CylinderError::Radius`], [`CylinderError::TooFar`], or
            /// [`CylinderError::Empty`] where `x_min ≥ x_max`.
            pub const fn along_x(
                y: $Float,
                z: $Float,
                radius: $Float,
                x_min: $Float,
                x_max: $Float,
            ) -> Result<Self, CylinderError> {
                let axis = Direction::<$Float>::X;
                Self::around(Vec3::new(0.0, y, z), axis, radius, x_min, x_max)
            }

            /// A cylinder along the y axis, around the line at (`x`, `z`), from `y_min` to
            /// `y_max`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_y(
                x: $Float,
                z: $Float,
                radius: $Float,
                y_min: $Float,
                y_max: $Float,
            ) -> Result<Self, CylinderError> {
                let axis = Direction::<$Float>::Y;
                Self::around(Vec3::new(x, 0.0, z), axis, radius, y_min, y_max)
            }

            /// A cylinder along the z axis, around the line at (`x`, `y`), from `z_min` to
            /// `z_max`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_z(
                x: $Float,
                y: $Float,
                radius: $Float,
                z_min: $Float,
                z_max: $Float,
            ) -> Result<Self, CylinderError> {
                let axis = Direction::<$Float>::Z;
                Self::around(Vec3::new(x, y, 0.0), axis, radius, z_min, z_max)
            }

            /// A cylinder from the middle of one cap to the middle of the other.
            ///
            /// The axis is rounded to the number type once, so a cap may lie off its end point by
            /// the rounding error of that point's coordinates. The axis is computed in `f64`: on a
            /// core without that, better in a constant.
            ///
            /// # Errors
            /// [`CylinderError::NotFinite`], [`CylinderError::Radius`], [`CylinderError::TooFar`], or
            /// [`CylinderError::Empty`] where the points coincide.
            pub const fn between(
                from: Vec3<$Float>,
                to: Vec3<$Float>,
                radius: $Float,
            ) -> Result<Self, CylinderError> {
                if !(from.has_finite_coordinates() && to.has_finite_coordinates()) {
                    return Err(CylinderError::NotFinite);
                }
                if !(from.is_within_reach() && to.is_within_reach()) {
                    return Err(CylinderError::TooFar);
                }
                let start = [from.x as f64, from.y as f64, from.z as f64];
                let end = [to.x as f64, to.y as f64, to.z as f64];
                let way = [end[0] - start[0], end[1] - start[1], end[2] - start[2]];
                let Ok(axis) = unit(way) else { return Err(CylinderError::Empty) };
                let axis = Vec3::new(axis[0] as $Float, axis[1] as $Float, axis[2] as $Float);
                // Offsets along the axis as it was rounded, which is what lines will be held
                // against.
                let [x, y, z] = [axis.x as f64, axis.y as f64, axis.z as f64];
                let low = x * start[0] + y * start[1] + z * start[2];
                let high = x * end[0] + y * end[1] + z * end[2];
                let axis = Direction::<$Float>::new(axis);
                Self::around(from, axis, radius, low as $Float, high as $Float)
            }

            const fn around(
                base: Vec3<$Float>,
                axis: Direction<$Float>,
                radius: $Float,
                low: $Float,
                high: $Float,
            ) -> Result<Self, CylinderError> {
                if !base.has_finite_coordinates() {
                    return Err(CylinderError::NotFinite);
                }
                if !radius.is_finite() {
                    return Err(CylinderError::NotFinite);
                }
                if !(<$Float>::FINEST <= radius && radius <= <$Float>::REACH) {
                    return Err(CylinderError::Radius);
                }
                if !base.is_within_reach() {
                    return Err(CylinderError::TooFar);
                }
                match Slab::<$Float>::between(axis, low, high) {
                    Ok(caps) => Ok(Self { tube: Tube { base, radius }, caps }),
                    Err(SlabError::NotFinite) => Err(CylinderError::NotFinite),
                    Err(_) => Err(CylinderError::Empty),
                }
            }
        }
    )+};
}

constructors!(f32, f64);

impl<S: Scalar> Shape for Cylinder<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const STACK: usize = 1;
    const FACES: u16 = 3;
}

impl<S: Scalar> Solid for Cylinder<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        let within_wall = match self.tube.meet(&self.caps.normal, line) {
            Meeting::Beside | Meeting::Along => None,
            Meeting::Within => Some(Span::whole_line(WALL)),
            Meeting::Points(enter, exit) => {
                let at = |t| Crossing { t, face: WALL };
                Span::new(at(enter), at(exit))
            }
        };
        let Some(span) = within_wall else { return };
        let between_caps = self.caps.line_span(line);
        if let Some(span) = between_caps.and_then(|caps| caps.overlap(span)) {
            stack.put(span.with_faces_from(first));
        }
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        if face == WALL {
            self.tube.onto(&self.caps.normal, near)
        } else {
            self.caps.onto_face(face, near)
        }
    }

    fn normal(&self, face: Face, at: Vec3<S>) -> Vec3<S> {
        if face == WALL {
            self.tube.normal(&self.caps.normal, at)
        } else {
            self.caps.face_normal(face)
        }
    }
}

#[inline]
fn wall_span<S: Scalar>(middle: S, half: S) -> Option<Span<S>> {
    let at = |t| Crossing { t, face: WALL };
    Span::new(at(middle - half), at(middle + half))
}

impl<S: Scalar> Cylinder<S> {
    /// A ball that holds the whole cylinder.
    fn bounding_ball(&self) -> (Vec3<S>, S) {
        let half = S::from_halves(1);
        let middle = (self.caps.low + self.caps.high) * half;
        let Tube { base, radius } = self.tube;
        let axis = &self.caps.normal;
        let center = base + axis.vector() * (middle - axis.dot(base));
        let half_length = (self.caps.high - self.caps.low) * half;
        (center, (radius * radius + half_length * half_length).sqrt())
    }
}
