//! The slab: what lies between two parallel planes. Three slabs make a box.

use super::row::{ConvexRow, Leaf, Project, View};
use super::{Shape, Solid};
use crate::geom::{Direction, Extent, Line, Parallel, Pencil, Vec3};
use crate::scalar::{Scalar, const_sqrt};
use crate::span::{Crossing, Face, Span, SpanStack};

/// The points p with `low ≤ normal · p ≤ high`.
///
/// The offsets are stored as they were given, so two slabs with a plane in common cross every
/// line at the same bits there.
///
/// Face 0 is the plane at `low`, face 1 the one at `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slab<S> {
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
}

crate::error_text!(SlabError {
    NotFinite => "a coordinate or an offset of the slab is infinite or not a number",
    ZeroNormal => "the normal of the slab is zero",
    Empty => "the low offset of the slab is not below the high one",
});

macro_rules! constructors {
    ($($Float:ident),+) => {$(
        impl Slab<$Float> {
            /// The points with `low ≤ x ≤ high`.
            ///
            /// # Errors
            /// [`SlabError::NotFinite`], [`SlabError::Empty`].
            pub const fn along_x(low: $Float, high: $Float) -> Result<Self, SlabError> {
                Self::between(Direction::<$Float>::X, low, high)
            }

            /// The points with `low ≤ y ≤ high`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_y(low: $Float, high: $Float) -> Result<Self, SlabError> {
                Self::between(Direction::<$Float>::Y, low, high)
            }

            /// The points with `low ≤ z ≤ high`.
            ///
            /// # Errors
            /// As [`along_x`](Self::along_x).
            pub const fn along_z(low: $Float, high: $Float) -> Result<Self, SlabError> {
                Self::between(Direction::<$Float>::Z, low, high)
            }

            /// The points with `low ≤ n·p ≤ high`, where n is `normal` brought to length 1.
            ///
            /// That is computed in `f64`: on a core without it, better in a constant.
            ///
            /// # Errors
            /// [`SlabError::NotFinite`], [`SlabError::ZeroNormal`], [`SlabError::Empty`].
            pub const fn new(
                normal: Vec3<$Float>,
                low: $Float,
                high: $Float,
            ) -> Result<Self, SlabError> {
                match unit([normal.x as f64, normal.y as f64, normal.z as f64]) {
                    Ok([x, y, z]) => {
                        let normal = Vec3::new(x as $Float, y as $Float, z as $Float);
                        Self::between(Direction::<$Float>::new(normal), low, high)
                    }
                    Err(error) => Err(error),
                }
            }

            /// The slab of a normal.
            pub(super) const fn between(
                normal: Direction<$Float>,
                low: $Float,
                high: $Float,
            ) -> Result<Self, SlabError> {
                if !(low.is_finite() && high.is_finite()) {
                    return Err(SlabError::NotFinite);
                }
                if low >= high {
                    return Err(SlabError::Empty);
                }
                Ok(Self { normal, low, high })
            }
        }
    )+};
}

constructors!(f32, f64);

/// The unit vector in a direction.
pub(super) const fn unit(v: [f64; 3]) -> Result<[f64; 3], SlabError> {
    let [x, y, z] = v;
    if !(x.is_finite() && y.is_finite() && z.is_finite()) {
        return Err(SlabError::NotFinite);
    }
    let largest = x.abs().max(y.abs()).max(z.abs());
    if largest == 0.0 {
        return Err(SlabError::ZeroNormal);
    }
    // Scaled by the largest coordinate, no square can overflow or vanish.
    let (x, y, z) = (x / largest, y / largest, z / largest);
    let length = const_sqrt(x * x + y * y + z * z);
    Ok([x / length, y / length, z / length])
}

impl<S: Scalar> Slab<S> {
    /// Where a line with `normal · p(t) = at_zero + t·speed` is inside.
    #[inline]
    pub(super) fn span(&self, at_zero: S, speed: S) -> Option<Span<S>> {
        if speed == S::ZERO {
            return self.holds(at_zero).then_some(Span::whole_line(Face(0)));
        }
        let low = Crossing { t: (self.low - at_zero) / speed, face: Face(0) };
        let high = Crossing { t: (self.high - at_zero) / speed, face: Face(1) };
        if speed > S::ZERO { Span::new(low, high) } else { Span::new(high, low) }
    }

    /// Whether a line along the planes, at height `normal · p`, is inside.
    ///
    /// One of the two planes belongs to the slab: the lower one as seen along the first
    /// coordinate axis that isn't parallel to them. So of two slabs on either side of a plane,
    /// exactly one has it, whichever way their normals point.
    fn holds(&self, height: S) -> bool {
        let is_forward = self
            .normal
            .vector()
            .to_array()
            .into_iter()
            .find(|coordinate| *coordinate != S::ZERO)
            .is_some_and(|coordinate| coordinate > S::ZERO);
        if is_forward {
            self.low <= height && height < self.high
        } else {
            self.low < height && height <= self.high
        }
    }

    pub(super) fn line_span(&self, line: &Line<S>) -> Option<Span<S>> {
        self.span(self.normal.dot(line.origin), self.normal.dot(line.direction))
    }

    /// The point of a face nearest to a point beside it.
    pub(super) fn onto_face(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
        let offset = if face.0 == 0 { self.low } else { self.high };
        near + self.normal.vector() * (offset - self.normal.dot(near))
    }

    pub(super) fn face_normal(&self, face: Face) -> Vec3<S> {
        let normal = self.normal.vector();
        if face.0 == 0 { -normal } else { normal }
    }
}

impl<S: Scalar> Shape for Slab<S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const STACK: usize = 1;
    const FACES: u16 = 2;
}

impl<S: Scalar> Solid for Slab<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        if let Some(span) = self.line_span(line) {
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
            height: [rays.center, rays.right, rays.down].map(|step| self.normal.dot(step)),
            speed: self.normal.dot(rays.forward),
            columns: rays.columns,
        }
    }
}

/// A slab, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S> {
    slab: Slab<S>,
    /// normal·p in the middle of the image plane, and its steps.
    height: [S; 3],
    /// normal·d.
    speed: S,
    columns: u32,
}

impl<S: Scalar> ParallelView<S> {
    pub(super) fn slab_row(&self, y: S) -> ParallelRow<S> {
        let [middle, right, down] = self.height;
        let height = middle + down * y;
        if !self.speed.is_normal() {
            return ParallelRow::EdgeOn { slab: self.slab, height: [height, right] };
        }
        let inverse = S::ONE / self.speed;
        let at = |offset: S, face| Crossing { t: (offset - height) * inverse, face: Face(face) };
        let (low, high) = (at(self.slab.low, 0), at(self.slab.high, 1));
        let (enter, exit) = if self.speed > S::ZERO { (low, high) } else { (high, low) };
        ParallelRow::Across { enter, exit, step: -right * inverse }
    }
}

impl<S: Scalar> View for ParallelView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<ParallelRow<S>>;

    fn row(&self, y: S) -> Self::Row<'_> {
        Leaf { row: self.slab_row(y), extent: Extent::all(self.columns) }
    }
}

/// A row of a slab, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub enum ParallelRow<S> {
    /// Both planes are crossed, at parameters that are affine in the column.
    Across {
        /// Where the middle of the row enters.
        enter: Crossing<S>,
        /// Where it exits.
        exit: Crossing<S>,
        /// What one column adds to both.
        step: S,
    },
    /// The rays run along the planes.
    EdgeOn {
        /// The slab.
        slab: Slab<S>,
        /// normal·p in the middle of the row, and its step.
        height: [S; 2],
    },
}

impl<S: Scalar> ParallelRow<S> {
    #[inline]
    pub(super) fn span(&self, x: S) -> Option<Span<S>> {
        match self {
            Self::Across { enter, exit, step } => {
                let shift = *step * x;
                Span::new(
                    Crossing { t: enter.t + shift, ..*enter },
                    Crossing { t: exit.t + shift, ..*exit },
                )
            }
            Self::EdgeOn { slab, height } => slab.span(height[0] + height[1] * x, S::ZERO),
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
pub struct PencilView<S> {
    /// The image plane: where the rays have t = 0.
    plane: ParallelView<S>,
    convergence: S,
}

impl<S: Scalar> PencilView<S> {
    pub(super) fn slab_row(&self, y: S) -> PencilRow<S> {
        let [middle, right, down] = self.plane.height;
        let offset = down * y;
        PencilRow {
            slab: self.plane.slab,
            height: [middle + offset, right],
            speed: [self.plane.speed + self.convergence * offset, self.convergence * right],
        }
    }
}

impl<S: Scalar> View for PencilView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<PencilRow<S>>;

    fn row(&self, y: S) -> Self::Row<'_> {
        Leaf { row: self.slab_row(y), extent: Extent::all(self.plane.columns) }
    }
}

/// A row of a slab, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilRow<S> {
    slab: Slab<S>,
    height: [S; 2],
    speed: [S; 2],
}

impl<S: Scalar> PencilRow<S> {
    #[inline]
    pub(super) fn span(&self, x: S) -> Option<Span<S>> {
        self.slab.span(self.height[0] + self.height[1] * x, self.speed[0] + self.speed[1] * x)
    }
}

macro_rules! convex_rows {
    ($($Row:ident),+) => {$(
        impl<S: Scalar> ConvexRow for $Row<S> {
            type Scalar = S;
            const FACES: u16 = 2;

            #[inline]
            fn span(&self, x: S) -> Option<Span<S>> {
                $Row::span(self, x)
            }
        }
    )+};
}

convex_rows!(ParallelRow, PencilRow);
