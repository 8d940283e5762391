//! The slab: what lies between two parallel planes. Three slabs make a box.

use super::intersect::{Intersect, Passage};
use super::row::{Leaf, leaf};
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

impl<S: Scalar> Leaf<Parallel<S>> for Slab<S> {
    type View = ParallelView<S>;
    type Row = ParallelRow<S>;

    fn seen_along(&self, rays: &Parallel<S>) -> ParallelView<S> {
        let speed = self.normal.dot_fine(rays.forward);
        let inverse = if speed.is_divisor() { S::Fine::ONE / speed } else { S::Fine::ZERO };
        let height = rays.steps(Vec3::ZERO).map(|step| self.normal.dot_fine(step));
        ParallelView { height, speed, inverse, step: -height[1] * inverse, columns: rays.columns }
    }

    fn in_row(&self, view: &ParallelView<S>, y: i32) -> (ParallelRow<S>, Extent) {
        (self.parallel_row(view, y), Extent::all(view.columns))
    }

    #[inline]
    fn span(&self, view: &ParallelView<S>, row: &ParallelRow<S>, x: i32) -> Option<Span<S>> {
        match *row {
            ParallelRow::Across { low, high } => {
                let step = view.step;
                let at = [low, high].map(|middle| S::from_fine(Affine { middle, step }.at(x)));
                Passage::Across { at, upwards: view.speed > S::Fine::ZERO }.span()
            }
            ParallelRow::EdgeOn { height, speed } => self.passage(height.at(x), speed).span(),
        }
    }
}

impl<S: Scalar> Slab<S> {
    pub(super) fn parallel_row(&self, view: &ParallelView<S>, y: i32) -> ParallelRow<S> {
        let height = Affine::row(view.height, y);
        if view.inverse == S::Fine::ZERO {
            return ParallelRow::EdgeOn { height, speed: S::Fine::ZERO };
        }
        let [low, high] =
            [self.low, self.high].map(|offset| (offset.fine() - height.middle) * view.inverse);
        if [low, high].iter().all(|at| at.holds_steps(view.step, view.columns as i32)) {
            ParallelRow::Across { low, high }
        } else {
            ParallelRow::EdgeOn { height, speed: view.speed }
        }
    }
}

/// A slab, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S: Scalar> {
    /// normal·p in the middle of the image plane, and its steps.
    height: [S::Fine; 3],
    /// normal·d.
    speed: S::Fine,
    /// 1/speed, or 0 if the rays run along the planes.
    inverse: S::Fine,
    /// What half a column adds to where the planes are crossed.
    pub(super) step: S::Fine,
    pub(super) columns: u32,
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
    },
    /// The rays run along the planes, or almost.
    EdgeOn {
        /// normal·p.
        height: Affine<S::Fine>,
        /// normal·d.
        speed: S::Fine,
    },
}

impl<S: Scalar> Leaf<Pencil<S>> for Slab<S> {
    type View = PencilView<S>;
    type Row = PencilRow<S>;

    fn seen_along(&self, rays: &Pencil<S>) -> PencilView<S> {
        PencilView {
            height: rays.plane.steps(Vec3::ZERO).map(|step| self.normal.dot_fine(step)),
            speed: self.normal.dot_fine(rays.plane.forward),
            convergence: rays.convergence,
            columns: rays.plane.columns,
        }
    }

    fn in_row(&self, view: &PencilView<S>, y: i32) -> (PencilRow<S>, Extent) {
        (PencilRow::new(view, y), Extent::all(view.columns))
    }

    #[inline]
    fn span(&self, _: &PencilView<S>, row: &PencilRow<S>, x: i32) -> Option<Span<S>> {
        self.passage(row.height.at(x), row.speed.at(x)).span()
    }
}

/// A slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilView<S: Scalar> {
    /// normal·p in the image plane, where the rays have t = 0, and its steps.
    height: [S::Fine; 3],
    /// normal·d in the middle.
    speed: S::Fine,
    pub(super) convergence: S::Fine,
    pub(super) columns: u32,
}

/// A row of a slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilRow<S: Scalar> {
    height: Affine<S::Fine>,
    speed: Affine<S::Fine>,
}

impl<S: Scalar> PencilRow<S> {
    pub(super) fn new(view: &PencilView<S>, y: i32) -> Self {
        let [height, right, down] = view.height;
        let offset = Affine::row([S::Fine::ZERO, right, down], y);
        let turn = offset.times(view.convergence);
        let plus = |middle: S::Fine, offset: Affine<S::Fine>| Affine {
            middle: middle + offset.middle,
            ..offset
        };
        Self { height: plus(height, offset), speed: plus(view.speed, turn) }
    }
}

leaf!([S: Scalar] Slab<S>);
