//! Affine maps: scale, mirror, shear, with a shift.

use super::pose::Pose;
use super::ray::{Line, nearest};
use super::rays::OrthographicRays;
use super::vec3::Vec3;
use crate::scalar::{
    ConstOps, Double, FixedPoint, Float, Formula, Inverse, Matrix, Number, Real, Scalar, per_scalar,
};

/// A matrix that can be inverted, and a shift: `p ↦ M p + s`. Scales, mirrors and shears, of which
/// [`Scaled`](crate::solid::Scaled) solids are made.
///
/// ```
/// use scancsg::geom::{AffineMap, Pose, vec3};
///
/// // Twice as long along x, and mirrored in z; then turned and moved.
/// let stretch = AffineMap::<f32>::scaling([2.0, 1.0, -1.0])?;
/// let quarter = Pose::<f32>::rotation_z(core::f32::consts::FRAC_PI_2)?;
/// let map = stretch.then(&AffineMap::of_pose(&quarter)?)?;
/// assert!((map.point(vec3(1.0, 0.0, 3.0)) - vec3(0.0, 2.0, -3.0)).max_abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AffineMap<S: Scalar> {
    rows: Matrix<S::Wide>,
    inverse: Inverse<S::Wide>,
    shift: Vec3<S>,
}

crate::error_text! {
    /// Why an affine map can't be.
    pub enum AffineError {
        /// A number is infinite or NaN.
        NotFinite => "a number of the affine map is infinite or not a number",
        /// A coordinate of the shift is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the affine map shifts too far for its number type",
        /// The matrix has no inverse; or an entry of either is larger than [`Scalar::MAX_COORDINATE`] in
        /// floating point, 4096 in fixed point. With less than 16 bits of fraction, an inverse's are less: 1/16
        /// for 8 bits, and twice as much for each bit more.
        Singular => "the matrix of the affine map has no inverse in its number type's range",
    }
}

per_scalar! { $S: impl[] AffineMap<$S> {
    /// The map that takes the coordinate axes to `columns`, and the origin to `shift`.
    ///
    /// # Errors
    /// [`AffineError`].
    pub const fn new(columns: [Vec3<$S>; 3], shift: Vec3<$S>) -> Result<Self, AffineError> {
        let [x, y, z] = columns;
        if !(x.has_finite_coordinates() && y.has_finite_coordinates())
            || !(z.has_finite_coordinates() && shift.has_finite_coordinates())
        {
            return Err(AffineError::NotFinite);
        }
        if !shift.is_within_reach() {
            return Err(AffineError::TooFar);
        }
        let rows =
            [Self::row(x.x, y.x, z.x), Self::row(x.y, y.y, z.y), Self::row(x.z, y.z, z.z)];
        match ConstOps::<$S>::inverted(rows) {
            Some(inverse) => Ok(Self { rows, inverse, shift }),
            None => Err(AffineError::Singular),
        }
    }

    const fn row(x: $S, y: $S, z: $S) -> [<$S as Scalar>::Wide; 3] {
        [ConstOps::<$S>::wide(x), ConstOps::<$S>::wide(y), ConstOps::<$S>::wide(z)]
    }

    /// A scale along each coordinate axis, about the origin; a factor below zero mirrors.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn scale(factors: [$S; 3]) -> Result<Self, AffineError> {
        let ([x, y, z], zero) = (factors, ConstOps::<$S>::ZERO);
        let columns = [Vec3::new(x, zero, zero), Vec3::new(zero, y, zero), Vec3::new(zero, zero, z)];
        Self::new(columns, Vec3::new(zero, zero, zero))
    }
} }

/// For any number type: what a type parameter can call. In constants, use [`new`](Self::new) and
/// [`scale`](Self::scale).
impl<S: Scalar> AffineMap<S> {
    /// The map that takes the coordinate axes to `columns`, and the origin to `shift`.
    ///
    /// # Errors
    /// [`AffineError`].
    pub fn with_columns(columns: [Vec3<S>; 3], shift: Vec3<S>) -> Result<Self, AffineError> {
        Self::checked(transposed(columns.map(Vec3::wide)), shift)
    }

    /// A scale along each coordinate axis, about the origin; a factor below zero mirrors.
    ///
    /// # Errors
    /// [`AffineError`].
    pub fn scaling(factors: [S; 3]) -> Result<Self, AffineError> {
        let ([x, y, z], zero) = (factors, S::ZERO);
        let columns =
            [Vec3::new(x, zero, zero), Vec3::new(zero, y, zero), Vec3::new(zero, zero, z)];
        Self::with_columns(columns, Vec3::ZERO)
    }

    /// A rigid motion as an affine map.
    ///
    /// # Errors
    /// [`AffineError`].
    pub fn of_pose(pose: &Pose<S>) -> Result<Self, AffineError> {
        let (axes, shift) = pose.axes_and_translation();
        Self::checked(transposed(axes), shift)
    }

    /// This map first, then `next`.
    ///
    /// # Errors
    /// [`AffineError::TooFar`], [`AffineError::Singular`].
    pub fn then(&self, next: &Self) -> Result<Self, AffineError> {
        let columns = transposed(self.rows.map(Vec3::from));
        let columns = columns.map(|column| product(&next.rows, Vec3::from(column)));
        Self::checked(transposed(columns), next.point(self.shift))
    }

    /// The map of a matrix, by its rows.
    pub(crate) fn of_rows(rows: [Vec3<S>; 3], shift: Vec3<S>) -> Result<Self, AffineError> {
        Self::checked(rows.map(|row| row.wide().to_array()), shift)
    }

    /// The rows of the matrix, if they are exact in the number type, and the shift.
    pub(crate) fn rows(&self) -> Option<([Vec3<S>; 3], Vec3<S>)> {
        let rows = self.rows.map(|row| Vec3::from(row.map(S::from_wide)));
        (rows.map(|row| row.wide().to_array()) == self.rows).then_some((rows, self.shift))
    }

    fn checked(rows: Matrix<S::Wide>, shift: Vec3<S>) -> Result<Self, AffineError> {
        if !(rows.iter().flatten().all(|entry| entry.is_finite()) && shift.is_finite()) {
            return Err(AffineError::NotFinite);
        }
        if !shift.is_within_range() {
            return Err(AffineError::TooFar);
        }
        let inverse = S::inverted(rows).ok_or(AffineError::Singular)?;
        Ok(Self { rows, inverse, shift })
    }

    /// A point of the own frame, in the scene's.
    #[must_use]
    pub fn point(&self, own: Vec3<S>) -> Vec3<S> {
        self.point_wide(own.wide()).map(S::from_wide)
    }

    pub(crate) fn point_wide(&self, own: Vec3<S::Wide>) -> Vec3<S::Wide> {
        product(&self.rows, own) + self.shift.wide()
    }

    /// A point of the scene, in the own frame.
    #[must_use]
    pub fn point_back(&self, scene: Vec3<S>) -> Vec3<S> {
        S::compute(Back { map: self, from: scene, t: S::ZERO, direction: scene }).map(S::from_wide)
    }

    /// The lengths along each axis of the scene that a box with these half lengths, or a ball, reaches to.
    pub(crate) fn reach(&self, half: Vec3<S::Wide>, is_ball: bool) -> Vec3<S::Wide> {
        let along = |[x, y, z]: [S::Wide; 3]| {
            let part = Vec3::new(x * half.x, y * half.y, z * half.z);
            let sum = part.x.abs() + part.y.abs() + part.z.abs();
            if is_ball { part.length().min(sum) } else { sum }
        };
        Vec3::from(self.rows.map(along))
    }

    /// The normal, of length 1, at a point of the scene; `of` is the normal at a point, in the own frame. It
    /// goes by the transposed inverse.
    #[inline]
    pub(crate) fn normal(&self, at: Vec3<S>, of: impl FnOnce(Vec3<S>) -> Vec3<S>) -> Vec3<S> {
        let [back, _] = &self.inverse;
        let own = of(quick_product(back, at.wide() - self.shift.wide()).map(S::from_wide));
        let scene = quick_product(&transposed(back.map(Vec3::from)), own.wide());
        scene.normalized().map_or(own, |unit| unit.map(S::from_wide))
    }

    /// A line of the scene in the own frame, counted from about the point nearest to `near`, a point of the
    /// own frame: there its coordinates, and what rounding them loses, are small.
    pub(crate) fn line_back(&self, line: &Line<S>, near: Vec3<S>) -> LineBack<S> {
        let &Line { origin, direction } = line;
        let back = |from, t| S::compute(Back { map: self, from, t, direction });
        let own = back(self.shift, S::ONE);
        let way = near.wide() - back(origin, S::ZERO);
        let from = nearest(way, own);
        let from = if from.is_finite() { S::from_wide(from) } else { S::ZERO };
        let largest = own.max_abs();
        // In fixed point, a long direction keeps parameters on their grid.
        let is_good = S::SHORTEST > S::ZERO
            && S::Wide::ONE <= largest
            && largest + largest <= S::LONGEST.wide();
        let power = if is_good { S::Wide::ONE } else { largest.normalizing_power() };
        let start = back(origin, from).map(S::from_wide);
        LineBack {
            line: Line { origin: start, direction: (own * power).map(S::from_wide) },
            parameters: Parameters {
                inverse: S::scale(power),
                power: S::Wide::ONE,
                shift: from.wide(),
            },
        }
    }

    /// Parallel rays of the scene in the own frame: a row of them, in which they are at right angles to the
    /// row. Their direction may have any length.
    pub(crate) fn rays_back(&self, rays: &OrthographicRays<S>) -> Option<RaysBack<S>> {
        let [back, _] = &self.inverse;
        let direction = quick_product(back, rays.forward);
        let forward = direction.normalized()?;
        let (length, along_row) = (direction.dot(forward), quick_product(back, rays.right));
        // What a step to the right moves along the rays is a shift of their parameters.
        let slant = along_row.dot(forward);
        let across = along_row - forward * slant;
        let right = across.normalized()?;
        // A quotient near 1 has all of its digits.
        let power = length.normalizing_power();
        let inverse = S::Wide::ONE / (length * power);
        Some(RaysBack {
            rays: OrthographicRays {
                center: quick_product(back, rays.center - self.shift.wide()),
                right,
                down: forward.cross(right),
                forward,
                half_pixel: rays.half_pixel * across.dot(right),
                columns: rays.columns,
            },
            down: quick_product(back, rays.down) * rays.half_pixel,
            inverse: S::scale(inverse),
            power,
            step: -(rays.half_pixel * slant * inverse * power),
        })
    }
}

/// A line in a solid's own frame, and what its parameters are in the scene.
pub(crate) struct LineBack<S: Scalar> {
    pub(crate) line: Line<S>,
    pub(crate) parameters: Parameters<S>,
}

/// Parameters of a line of the scene for those of the same line in a solid's own frame: these times a
/// positive factor, and a shift.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parameters<S: Scalar> {
    /// The factor is `inverse · power`.
    inverse: S::Scale,
    power: S::Wide,
    shift: S::Wide,
}

impl<S: Scalar> Parameters<S> {
    /// The scene's parameter. Infinite ones stay.
    #[inline]
    pub(crate) fn of(&self, own: S) -> S {
        if own > S::LOWEST && own < S::HIGHEST {
            S::from_wide(own.stretched(self.inverse) * self.power + self.shift)
        } else {
            own
        }
    }
}

/// Parallel rays in a solid's own frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RaysBack<S: Scalar> {
    /// Those of the row through the middle of the picture.
    rays: OrthographicRays<S>,
    /// The way to the row half a pixel below.
    down: Vec3<S::Wide>,
    inverse: S::Scale,
    power: S::Wide,
    /// What half a pixel to the right adds to the scene's parameter.
    step: S::Wide,
}

impl<S: Scalar> RaysBack<S> {
    /// The rays whose middle row is the row `y` half pixels below the middle.
    pub(crate) fn row(&self, y: i32) -> OrthographicRays<S> {
        let down = self.down.map(|step| S::Wide::ZERO.after_steps(step, y));
        OrthographicRays { center: self.rays.center + down, ..self.rays }
    }

    /// What parameters of the ray `x` half pixels to the right of the middle are in the scene.
    #[inline]
    pub(crate) fn parameters(&self, x: i32) -> Parameters<S> {
        let shift = S::Wide::ZERO.after_steps(self.step, x);
        Parameters { inverse: self.inverse, power: self.power, shift }
    }
}

fn transposed<T: Number>([x, y, z]: [Vec3<T>; 3]) -> Matrix<T> {
    [[x.x, y.x, z.x], [x.y, y.y, z.y], [x.z, y.z, z.z]]
}

fn product<T: Real>(rows: &Matrix<T>, v: Vec3<T>) -> Vec3<T> {
    Vec3::from(rows.map(|row| Vec3::from(row).dot_compensated(v)))
}

/// As [`product`], in plain arithmetic: what a pixel or a row has time for.
#[inline]
fn quick_product<T: Real>(rows: &Matrix<T>, v: Vec3<T>) -> Vec3<T> {
    Vec3::from(rows.map(|row| Vec3::from(row).dot(v)))
}

/// The point `from + t·direction` of the scene in a map's own frame, rounded once.
struct Back<'a, S: Scalar> {
    map: &'a AffineMap<S>,
    from: Vec3<S>,
    t: S,
    direction: Vec3<S>,
}

impl<S: Scalar> Formula<S> for Back<'_, S> {
    type Output = Vec3<S::Wide>;

    fn float(self) -> Vec3<S::Wide>
    where
        S: Float,
    {
        let Self { map, from, t, direction } = self;
        let way =
            |from: S, shift: S, step: S| Double::sum(from, -shift).plus(Double::product(t, step));
        let [from, shift, step] = [from, map.shift, direction].map(Vec3::to_array);
        let v = [0, 1, 2].map(|i| way(from[i], shift[i], step[i]));
        let [high, low] = &map.inverse;
        Vec3::from([0, 1, 2].map(|i| {
            let part = |j: usize| Double { high: high[i][j], low: low[i][j] }.times(v[j]);
            part(0).plus(part(1)).plus(part(2)).round()
        }))
    }

    fn fixed(self) -> Vec3<S::Wide>
    where
        S: FixedPoint,
    {
        let Self { map, from, t, direction } = self;
        let way = from.wide() - map.shift.wide() + direction.wide() * t.wide();
        product(&map.inverse[0], way)
    }
}
