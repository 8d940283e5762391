//! The slab: what lies between two parallel planes. Three slabs make a box.

use super::intersect::{Intersect, Passage};
use super::row::{Blank, Leaf, leaf};
use super::strip::columns_between;
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
        let [middle, right, down] = rays.steps(Vec3::ZERO).map(|step| self.normal.dot_fine(step));
        let is_edge_on = inverse == S::Fine::ZERO;
        let step = if is_edge_on { right } else { -right * inverse };
        ParallelView { height: [middle, down], inverse, step }
    }

    fn in_row(&self, view: &ParallelView<S>, y: i32, columns: u32) -> (ParallelRow<S>, Extent) {
        let row = self.parallel_row(view, y, columns);
        let extent = match &row {
            ParallelRow::EdgeOn(row) => self.columns(row, columns),
            _ => Extent::all(columns),
        };
        (row, extent)
    }

    #[inline]
    fn span(&self, view: &ParallelView<S>, row: &ParallelRow<S>, x: i32) -> Option<Span<S>> {
        match row {
            ParallelRow::Nowhere => None,
            ParallelRow::Across(ends) => ends.span(view, x),
            ParallelRow::EdgeOn(row) => self.edge_on_span(row, x),
        }
    }
}

impl<S: Scalar> Slab<S> {
    pub(super) fn parallel_row(
        &self,
        view: &ParallelView<S>,
        y: i32,
        columns: u32,
    ) -> ParallelRow<S> {
        let ParallelView { height: [middle, down], inverse, step } = *view;
        let height = middle.after_steps(down, y);
        if inverse == S::Fine::ZERO {
            return ParallelRow::EdgeOn(EdgeOn { height, step, speed: S::Fine::ZERO });
        }
        let [low, high] = [self.low, self.high].map(|offset| (offset.fine() - height) * inverse);
        if [low, high].iter().all(|at| at.holds_steps(step, columns as i32)) {
            let (near, far) = if view.high_first() { (high, low) } else { (low, high) };
            return ParallelRow::Across(Ends { near, far });
        }
        let speed = S::Fine::ONE / inverse;
        ParallelRow::EdgeOn(EdgeOn { height, step: -(step * speed), speed })
    }

    #[inline]
    pub(super) fn edge_on_span(&self, row: &EdgeOn<S>, x: i32) -> Option<Span<S>> {
        self.passage(row.height.after_steps(row.step, x), row.speed).span()
    }

    /// The columns in which rays along the planes, or almost, can be between them.
    pub(super) fn columns(&self, row: &EdgeOn<S>, columns: u32) -> Extent {
        if row.speed != S::Fine::ZERO {
            return Extent::all(columns);
        }
        let (low, high) = (self.low.fine(), self.high.fine());
        let height = Affine { middle: row.height, step: row.step };
        let size = low.abs() + high.abs() + row.height.abs();
        columns_between::<S>(height, [low, high], size, columns)
    }
}

impl<S: Scalar> Ends<S> {
    /// Where the planes are crossed.
    #[inline(always)]
    pub(super) fn at(&self, view: &ParallelView<S>, x: i32) -> [S; 2] {
        [self.near, self.far].map(|end| S::from_fine(end.after_steps(view.step, x)))
    }

    #[inline]
    pub(super) fn span(&self, view: &ParallelView<S>, x: i32) -> Option<Span<S>> {
        let [enter, exit] = self.at(view, x);
        let [near, far] = faces(view.high_first());
        Span::new(Crossing { t: enter, face: near }, Crossing { t: exit, face: far })
    }

    /// The columns in which rays can be between the planes no farther than `reach` from `middle`.
    pub(super) fn columns(
        &self,
        view: &ParallelView<S>,
        middle: Affine<S::Fine>,
        reach: S::Fine,
        columns: u32,
    ) -> Extent {
        let (near, far) = (self.near - reach, self.far + reach);
        // The ends move as well: what counts is how the middle moves along them.
        let along = Affine { step: middle.step - view.step, ..middle };
        let way = S::Fine::ZERO.after_steps(middle.step, columns as i32);
        let size = near.abs().max(far.abs()) + middle.middle.abs() + way.abs() + reach;
        columns_between::<S>(along, [near, far], size, columns)
    }
}

/// A slab, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct ParallelView<S: Scalar> {
    /// normal·p in the middle of the image plane, and its step down.
    height: [S::Fine; 2],
    /// 1/(normal·d), or 0 if the rays run along the planes.
    inverse: S::Fine,
    /// What half a column adds to where the planes are crossed; or to the height, for rays along
    /// the planes.
    step: S::Fine,
}

impl<S: Scalar> ParallelView<S> {
    /// Whether rays meet the high plane before the low one.
    #[inline]
    pub(super) fn high_first(&self) -> bool {
        self.inverse < S::Fine::ZERO
    }
}

/// The planes in the order in which rays meet them.
#[inline]
pub(super) fn faces(high_first: bool) -> [Face; 2] {
    let near = u16::from(high_first);
    [Face(near), Face(1 - near)]
}

impl<S: Scalar> Blank for ParallelView<S> {
    const BLANK: Self =
        Self { height: [S::Fine::ZERO; 2], inverse: S::Fine::ZERO, step: S::Fine::ZERO };
}

/// A row of a slab, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub enum ParallelRow<S: Scalar> {
    /// Not set yet.
    Nowhere,
    /// Both planes are crossed, at parameters that are affine in the column.
    Across(Ends<S>),
    /// The rays run along the planes, or almost.
    EdgeOn(EdgeOn<S>),
}

impl<S: Scalar> Blank for ParallelRow<S> {
    const BLANK: Self = Self::Nowhere;
}

/// Where the middle of a row crosses the planes: first the one, then the other.
#[derive(Debug, Clone, Copy)]
pub struct Ends<S: Scalar> {
    near: S::Fine,
    far: S::Fine,
}

/// A row of rays along the planes, or almost.
#[derive(Debug, Clone, Copy)]
pub struct EdgeOn<S: Scalar> {
    /// normal·p in the middle, and what half a column adds to it.
    height: S::Fine,
    step: S::Fine,
    /// normal·d.
    speed: S::Fine,
}

impl<S: Scalar> Leaf<Pencil<S>> for Slab<S> {
    type View = Option<PencilView<S>>;
    type Row = Option<PencilRow<S>>;

    fn seen_along(&self, rays: &Pencil<S>) -> Self::View {
        Some(PencilView::new(&self.normal, rays))
    }

    fn in_row(&self, view: &Self::View, y: i32, columns: u32) -> (Self::Row, Extent) {
        (view.as_ref().map(|view| PencilRow::new(view, y)), Extent::all(columns))
    }

    #[inline]
    fn span(&self, _: &Self::View, row: &Self::Row, x: i32) -> Option<Span<S>> {
        self.pencil_passage(row.as_ref()?, x).span()
    }
}

impl<S: Scalar> Slab<S> {
    #[inline]
    pub(super) fn pencil_passage(&self, row: &PencilRow<S>, x: i32) -> Passage<S> {
        self.passage(row.height.at(x), row.speed.at(x))
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
}

impl<S: Scalar> PencilView<S> {
    pub(super) fn new(normal: &Direction<S>, rays: &Pencil<S>) -> Self {
        Self {
            height: rays.plane.steps(Vec3::ZERO).map(|step| normal.dot_fine(step)),
            speed: normal.dot_fine(rays.plane.forward),
            convergence: rays.convergence,
        }
    }
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
