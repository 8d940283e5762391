//! The columns in which a row can meet a solid, from where a quadratic in X is not negative.

use crate::geom::{Extent, Parallel, Pencil, Vec3};
use crate::scalar::Scalar;

/// A quadratic `c0 + c1·X + c2·X²` in the column, with the sizes of the terms that it was summed
/// from: they bound the rounding errors, so that extents can be conservative.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quadratic<S> {
    coefficients: [S; 3],
    sizes: [S; 3],
    /// Lengths are multiplied by this power of two, so that squares neither overflow nor vanish.
    scale: S,
}

impl<S: Scalar> Quadratic<S> {
    /// Zero, for lengths of about the size of `radius`.
    pub(super) fn zero(radius: S) -> Self {
        let scale = radius.normalizing_power();
        Self { coefficients: [S::ZERO; 3], sizes: [S::ZERO; 3], scale }
    }

    /// Adds `sign · (at_zero + step·X)²`, of lengths.
    #[must_use]
    pub(super) fn plus_square(self, sign: S, at_zero: S, step: S) -> Self {
        let (at_zero, step) = (at_zero * self.scale, step * self.scale);
        let cross = at_zero * step;
        let terms = [at_zero * at_zero, cross + cross, step * step];
        let mut sum = self;
        for ((c, size), term) in sum.coefficients.iter_mut().zip(&mut sum.sizes).zip(terms) {
            *c = *c + sign * term;
            *size = *size + term.abs();
        }
        sum
    }

    /// Adds `sign · |at_zero + step·X|²`, of lengths.
    #[must_use]
    pub(super) fn plus_length(self, sign: S, at_zero: Vec3<S>, step: Vec3<S>) -> Self {
        self.plus_square(sign, at_zero.x, step.x)
            .plus_square(sign, at_zero.y, step.y)
            .plus_square(sign, at_zero.z, step.z)
    }

    /// All columns of a row of `columns` in which the quadratic may be ≥ 0.
    ///
    /// The rounding errors of coefficients and discriminant are at most some 16 units of the terms
    /// that they were summed from; 64 are allowed for, and a column on either side for the
    /// roots' own rounding. Where the quadratic isn't clearly concave, or the errors' bound itself
    /// vanishes, all columns are returned.
    pub(super) fn extent(&self, columns: u32) -> Extent {
        let all = Extent::all(columns);
        let unit = S::EPSILON * S::from_halves(2 * 64);
        let [c0, c1, c2] = self.coefficients;
        let [s0, s1, s2] = self.sizes;
        let half = S::from_halves(1);
        let reach = S::from_halves(columns as i32);

        let most = c0 + c1.abs() * reach + c2.max(S::ZERO) * reach * reach;
        let error = (s0 + s1 * reach + s2 * reach * reach) * unit;
        if most + error < S::ZERO && error > S::ZERO {
            return Extent::EMPTY;
        }
        if c2 + s2 * unit >= S::ZERO {
            return all;
        }
        let half_c1 = c1 * half;
        let quarter = half_c1 * half_c1 - c0 * c2;
        let quarter_error = (s1 * s1 + s0 * s2) * unit;
        if (quarter_error * S::EPSILON).positive().is_none() {
            return all;
        }
        if quarter + quarter_error < S::ZERO {
            return Extent::EMPTY;
        }
        let root = (quarter + quarter_error).sqrt();
        let first_column = S::from_halves(1 - columns as i32);
        let left = (half_c1 - root) / -c2 - first_column;
        let right = (half_c1 + root) / -c2 - first_column;
        if !left.is_finite() || !right.is_finite() {
            return all;
        }
        let start = left.floor_to_i32().saturating_sub(1).max(0) as u32;
        let end = right.floor_to_i32().saturating_add(2).max(0) as u32;
        all.overlap(Extent { start, end })
    }
}

/// A ball around a bounded solid, seen along parallel rays.
///
/// In the image plane the ball is a disc, and a row cuts a chord out of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct ParallelBall<S> {
    /// The picture's middle, seen from the ball's centre, along the row and across it.
    pub(super) along: S,
    pub(super) across: S,
    /// The size of a pixel, along the row and across it.
    pub(super) pitch: [S; 2],
    pub(super) radius: S,
    columns: u32,
}

impl<S: Scalar> ParallelBall<S> {
    pub(super) fn new(center: Vec3<S>, radius: S, rays: &Parallel<S>) -> Self {
        let from_center = rays.center - center;
        let pitch = [rays.right, rays.down].map(|step| step.length_squared().sqrt());
        Self {
            along: from_center.dot_compensated(rays.right) / pitch[0],
            across: from_center.dot_compensated(rays.down) / pitch[1],
            pitch,
            radius,
            columns: rays.columns,
        }
    }

    /// The distance of the row from the ball's centre.
    pub(super) fn row_distance(&self, y: S) -> S {
        self.across + self.pitch[1] * y
    }

    pub(super) fn extent(&self, y: S) -> Extent {
        Quadratic::zero(self.radius)
            .plus_square(S::ONE, self.radius, S::ZERO)
            .plus_square(-S::ONE, self.row_distance(y), S::ZERO)
            .plus_square(-S::ONE, self.along, self.pitch[0])
            .extent(self.columns)
    }
}

/// A ball around a bounded solid, seen from an eye.
///
/// The ray `p + t·d` meets the ball where `r²|d|² − |(p − c) × d|² ≥ 0`; both d and the vector
/// product are affine in the column, because all rays run through the eye.
#[derive(Debug, Clone, Copy)]
pub(super) struct PencilBall<S> {
    /// (p − c) × d in the middle of the picture, and its steps.
    moment: [Vec3<S>; 3],
    direction: [Vec3<S>; 3],
    pub(super) radius: S,
    columns: u32,
}

impl<S: Scalar> PencilBall<S> {
    pub(super) fn new(center: Vec3<S>, radius: S, rays: &Pencil<S>) -> Self {
        let plane = &rays.plane;
        let from_center = plane.center - center;
        let lever = plane.forward - from_center * rays.convergence;
        Self {
            moment: [
                from_center.cross(plane.forward),
                plane.right.cross(lever),
                plane.down.cross(lever),
            ],
            direction: [
                plane.forward,
                plane.right * rays.convergence,
                plane.down * rays.convergence,
            ],
            radius,
            columns: plane.columns,
        }
    }

    /// The moment and the direction in a row: in its middle, and by column.
    pub(super) fn row(&self, y: S) -> [[Vec3<S>; 2]; 2] {
        [self.moment, self.direction].map(|[middle, right, down]| [middle + down * y, right])
    }

    pub(super) fn extent(&self, y: S) -> Extent {
        let [moment, direction] = self.row(y);
        let [direction, step] = direction.map(|part| part * self.radius);
        Quadratic::zero(self.radius)
            .plus_length(S::ONE, direction, step)
            .plus_length(-S::ONE, moment[0], moment[1])
            .extent(self.columns)
    }
}
