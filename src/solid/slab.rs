//! The slab: what lies between two parallel planes. Three slabs make a box.

use super::intersect::{Intersect, Passage};
use super::row::{ConvexRow, Leaf, Project, View};
use super::{Shape, Solid};
use crate::geom::{Affine, Direction, Extent, Line, Parallel, Pencil, Vec3};
use crate::scalar::{Check, FixedI32, Fraction, Number, Real, Scalar};
use crate::span::{Crossing, Face, Span, SpanStack};

/// The points p with `low ≤ normal · p ≤ high`.
///
/// The offsets are stored as they were given, so two slabs with a plane in common cross every
/// line at the same bits there.
///
/// Face 0 is the plane at `low`, face 1 the one at `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slab<S: Scalar> {
    pub(super) normal: Direction<S>,
    pub(super) low: S,
    pub(super) high: S,
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
    /// An offset is larger than [`Scalar::REACH`].
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
                Self::between(Direction::<$Scalar>::X, low, high)
            }

            /// The points with `low ≤ y ≤ high`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_y(low: $Scalar, high: $Scalar) -> Result<Self, SlabError> {
                Self::between(Direction::<$Scalar>::Y, low, high)
            }

            /// The points with `low ≤ z ≤ high`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_z(low: $Scalar, high: $Scalar) -> Result<Self, SlabError> {
                Self::between(Direction::<$Scalar>::Z, low, high)
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
                match Check::<$Scalar>::normalized([normal.x, normal.y, normal.z]) {
                    Some(normal) => Self::between(Direction::<$Scalar>::new(normal), low, high),
                    None => Err(SlabError::ZeroNormal),
                }
            }

            /// The slab of a normal.
            pub(super) const fn between(
                normal: Direction<$Scalar>,
                low: $Scalar,
                high: $Scalar,
            ) -> Result<Self, SlabError> {
                if !(Check::<$Scalar>::is_finite(low) && Check::<$Scalar>::is_finite(high)) {
                    return Err(SlabError::NotFinite);
                }
                if !Check::<$Scalar>::is_below(low, high) {
                    return Err(SlabError::Empty);
                }
                if !(Check::<$Scalar>::is_within_reach(low) && Check::<$Scalar>::is_within_reach(high)) {
                    return Err(SlabError::TooFar);
                }
                Ok(Self { normal, low, high })
            }
        }
    )+};
}

constructors!([] f32, [] f64, [F: Fraction] FixedI32<F>);

impl<S: Scalar> Slab<S> {
    /// Where a line with `normal · p(t) = at_zero + t·speed` passes the planes.
    #[inline]
    pub(super) fn passage(&self, at_zero: S::Fine, speed: S::Fine) -> Passage<S> {
        if speed == S::Fine::ZERO {
            return Passage::Along { inside: self.holds(at_zero) };
        }
        let heights = [self.low, self.high].map(|offset| offset.fine() - at_zero);
        Passage::Across { at: S::quotients(heights, speed), upwards: speed > S::Fine::ZERO }
    }

    /// Whether a line along the planes, at height `normal · p`, is inside.
    ///
    /// One of the two planes belongs to the slab: the lower one as seen along the first
    /// coordinate axis that isn't parallel to them. So of two slabs on either side of a plane,
    /// exactly one has it, whichever way their normals point.
    fn holds(&self, height: S::Fine) -> bool {
        self.has(self.low.fine() <= height, self.low.fine() < height)
            && self.has(height < self.high.fine(), height <= self.high.fine())
    }

    /// What counts for a plane: the first answer if the lower one belongs to the slab, or else
    /// the second.
    pub(super) fn has<T>(&self, lower: T, upper: T) -> T {
        let is_forward = self
            .normal
            .vector()
            .to_array()
            .into_iter()
            .find(|coordinate| *coordinate != S::Unit::ZERO)
            .is_some_and(|coordinate| coordinate > S::Unit::ZERO);
        if is_forward { lower } else { upper }
    }

    /// The point of a face nearest to a point beside it.
    pub(super) fn onto_face(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        let offset = if face.0 == 0 { self.low } else { self.high };
        near + self.normal.times(offset.minus(self.normal.dot(near)))
    }

    pub(super) fn face_normal(&self, face: Face) -> Vec3<S> {
        let normal = self.normal.times(S::ONE);
        if face.0 == 0 { -normal } else { normal }
    }
}

impl<S: Scalar> Passage<S> {
    /// The part of the line between the planes.
    #[inline]
    pub(super) fn span(self) -> Option<Span<S>> {
        self.ends()?.checked()
    }

    /// Where the line is between the planes, also if rounding leaves that no length.
    #[inline]
    pub(super) fn ends(self) -> Option<Span<S>> {
        match self {
            Self::Along { inside } => inside.then_some(Span::whole_line(Face(0))),
            Self::Across { at: [low, high], upwards } => {
                let (near, far) = if upwards { (low, high) } else { (high, low) };
                let enter = Crossing { t: near, face: Face(u16::from(!upwards)) };
                let exit = Crossing { t: far, face: Face(u16::from(upwards)) };
                Some(Span { enter, exit })
            }
        }
    }
}

impl<S: Scalar> Shape for Slab<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const STACK: usize = 1;
    const FACES: u16 = 2;
}

impl<S: Intersect> Solid for Slab<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        if let Some(span) = S::pass(self, line).span() {
            stack.put(span.with_faces_from(first));
        }
    }

    fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        self.onto_face(face, near)
    }

    fn normal(&self, face: Face, _: Vec3<S>) -> Vec3<S> {
        self.face_normal(face)
    }
}

impl<S: Scalar> Project<Parallel<S>> for Slab<S> {
    type View<'a> = ParallelView<S>;

    fn view(&self, rays: &Parallel<S>) -> ParallelView<S> {
        ParallelView {
            slab: *self,
            height: rays.steps(Vec3::ZERO).map(|step| self.normal.dot_fine(step)),
            speed: self.normal.dot_fine(rays.forward),
            columns: rays.columns,
        }
    }
}

/// A slab, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S: Scalar> {
    slab: Slab<S>,
    /// normal·p in the middle of the image plane, and its steps.
    height: [S::Fine; 3],
    /// normal·d.
    speed: S::Fine,
    columns: u32,
}

impl<S: Scalar> ParallelView<S> {
    pub(super) fn slab_row(&self, y: i32) -> ParallelRow<S> {
        let height = Affine::row(self.height, y);
        let edge_on = |speed| ParallelRow::EdgeOn { slab: self.slab, height, speed };
        if !self.speed.is_divisor() {
            return edge_on(S::Fine::ZERO);
        }
        let inverse = S::Fine::ONE / self.speed;
        let at = |offset: S| (offset.fine() - height.middle) * inverse;
        let (low, high) = (at(self.slab.low), at(self.slab.high));
        let step = -height.step * inverse;
        let reach = self.columns as i32;
        if !(low.holds_steps(step, reach) && high.holds_steps(step, reach)) {
            return edge_on(self.speed);
        }
        ParallelRow::Across { low, high, step, upwards: self.speed > S::Fine::ZERO }
    }
}

impl<S: Scalar> View for ParallelView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<ParallelRow<S>>;

    fn row(&self, y: i32) -> Self::Row<'_> {
        Leaf { row: self.slab_row(y), extent: Extent::all(self.columns) }
    }
}

/// A row of a slab, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub enum ParallelRow<S: Scalar> {
    /// Both planes are crossed, at parameters that are affine in the column.
    Across {
        /// Where the middle of the row crosses the low plane.
        low: S::Fine,
        /// Where it crosses the high plane.
        high: S::Fine,
        /// What half a column adds to both.
        step: S::Fine,
        /// Whether the low plane comes first.
        upwards: bool,
    },
    /// The rays run along the planes, or almost.
    EdgeOn {
        /// The slab.
        slab: Slab<S>,
        /// normal·p.
        height: Affine<S::Fine>,
        /// normal·d.
        speed: S::Fine,
    },
}

impl<S: Scalar> ParallelRow<S> {
    #[inline]
    pub(super) fn span(&self, x: i32) -> Option<Span<S>> {
        match *self {
            Self::Across { low, high, step, upwards } => {
                let at = [low, high].map(|middle| S::from_fine(Affine { middle, step }.at(x)));
                Passage::Across { at, upwards }.span()
            }
            Self::EdgeOn { slab, height, speed } => slab.passage(height.at(x), speed).span(),
        }
    }
}

impl<S: Scalar> Project<Pencil<S>> for Slab<S> {
    type View<'a> = PencilView<S>;

    fn view(&self, rays: &Pencil<S>) -> PencilView<S> {
        PencilView { plane: self.view_parallel(&rays.plane), convergence: rays.convergence }
    }
}

impl<S: Scalar> Slab<S> {
    fn view_parallel(&self, rays: &Parallel<S>) -> ParallelView<S> {
        <Self as Project<Parallel<S>>>::view(self, rays)
    }
}

/// A slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilView<S: Scalar> {
    /// The image plane: where the rays have t = 0.
    plane: ParallelView<S>,
    convergence: S::Fine,
}

impl<S: Scalar> PencilView<S> {
    pub(super) fn slab_row(&self, y: i32) -> PencilRow<S> {
        let [_, right, down] = self.plane.height;
        let offset = Affine::row([S::Fine::ZERO, right, down], y);
        let turn = offset.times(self.convergence);
        let plus = |middle: S::Fine, offset: Affine<S::Fine>| Affine {
            middle: middle + offset.middle,
            ..offset
        };
        PencilRow {
            slab: self.plane.slab,
            height: plus(self.plane.height[0], offset),
            speed: plus(self.plane.speed, turn),
        }
    }
}

impl<S: Scalar> View for PencilView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<PencilRow<S>>;

    fn row(&self, y: i32) -> Self::Row<'_> {
        Leaf { row: self.slab_row(y), extent: Extent::all(self.plane.columns) }
    }
}

/// A row of a slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilRow<S: Scalar> {
    slab: Slab<S>,
    height: Affine<S::Fine>,
    speed: Affine<S::Fine>,
}

impl<S: Scalar> PencilRow<S> {
    #[inline]
    pub(super) fn span(&self, x: i32) -> Option<Span<S>> {
        self.slab.passage(self.height.at(x), self.speed.at(x)).span()
    }
}

macro_rules! convex_rows {
    ($($Row:ident),+) => {$(
        impl<S: Scalar> ConvexRow for $Row<S> {
            type Scalar = S;
            const FACES: u16 = 2;

            #[inline]
            fn span(&self, x: i32) -> Option<Span<S>> {
                $Row::span(self, x)
            }
        }
    )+};
}

convex_rows!(ParallelRow, PencilRow);
