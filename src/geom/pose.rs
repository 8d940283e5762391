//! Rigid motions.

use super::direction::{Axis, Direction, is_rounded};
use super::ray::Line;
use super::vec3::{Vec3, vec3};
use crate::scalar::{ConstOps, Number, Real, Scalar, per_scalar};

/// A rotation followed by a translation: where a solid's own frame lies in the scene.
///
/// ```
/// use scancsg::geom::{Pose, vec3};
///
/// let quarter = Pose::<f32>::rotation_z(core::f32::consts::FRAC_PI_2)?;
/// let pose = quarter.then(&Pose::<f32>::translation(vec3(0.0, 0.0, 3.0))?)?;
/// assert!((pose.point(vec3(2.0, 0.0, 0.0)) - vec3(0.0, 2.0, 3.0)).max_abs() < 1e-6);
/// # Ok::<(), scancsg::geom::PoseError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        try_from = "Parts<S>",
        into = "Parts<S>",
        bound(
            serialize = "S: serde::Serialize, S::Unit: serde::Serialize",
            deserialize = "S: serde::Deserialize<'de>, S::Unit: serde::Deserialize<'de>"
        )
    )
)]
pub struct Pose<S: Scalar> {
    /// The images of the three axes: an orthonormal, right-handed frame.
    axes: [Vec3<S::Unit>; 3],
    translation: Vec3<S>,
}

crate::error_text! {
    /// Why a pose can't be.
    pub enum PoseError {
        /// The angle or a coordinate is infinite or NaN.
        NotFinite => "an angle or a coordinate of the pose is infinite or not a number",
        /// A coordinate of the translation is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the pose shifts too far for its number type",
        /// The axis of a turn, or one of a frame, is zero.
        ZeroAxis => "the axis of the turn is zero",
        /// The axes of a pose, given or deserialised, are no right-handed frame of unit vectors.
        NotRigid => "the axes of the pose are no right-handed frame of unit vectors",
    }
}

impl<S: Scalar> Pose<S> {
    /// The pose that moves nothing.
    pub const IDENTITY: Self = {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        Self {
            axes: [vec3(one, zero, zero), vec3(zero, one, zero), vec3(zero, zero, one)],
            translation: Vec3::ZERO,
        }
    };

    /// A shift by `by`.
    ///
    /// # Errors
    /// [`PoseError`].
    pub fn translation(by: Vec3<S>) -> Result<Self, PoseError> {
        if !by.is_finite() {
            return Err(PoseError::NotFinite);
        }
        Self { translation: by, ..Self::IDENTITY }.checked()
    }

    /// A turn about the x axis, in radians, that takes y towards z.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`].
    pub fn rotation_x(angle: S) -> Result<Self, PoseError> {
        let (sin, cos, [x, _, _]) = turn(angle)?;
        let y = Vec3::new(S::Unit::ZERO, cos, sin);
        let z = Vec3::new(S::Unit::ZERO, sin.negated(), cos);
        Ok(Self { axes: [x, y, z], translation: Vec3::ZERO })
    }

    /// A turn about the y axis, in radians, that takes z towards x.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`].
    pub fn rotation_y(angle: S) -> Result<Self, PoseError> {
        let (sin, cos, [_, y, _]) = turn(angle)?;
        let z = Vec3::new(sin, S::Unit::ZERO, cos);
        let x = Vec3::new(cos, S::Unit::ZERO, sin.negated());
        Ok(Self { axes: [x, y, z], translation: Vec3::ZERO })
    }

    /// A turn about the z axis, in radians, that takes x towards y.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`].
    pub fn rotation_z(angle: S) -> Result<Self, PoseError> {
        let (sin, cos, [_, _, z]) = turn(angle)?;
        let x = Vec3::new(cos, sin, S::Unit::ZERO);
        let y = Vec3::new(sin.negated(), cos, S::Unit::ZERO);
        Ok(Self { axes: [x, y, z], translation: Vec3::ZERO })
    }

    /// A turn about an axis through the origin, in radians: clockwise for whoever looks along the axis,
    /// which may have any length. About a coordinate axis it is that axis's own turn.
    ///
    /// ```
    /// use scancsg::geom::{Pose, vec3};
    ///
    /// let third = core::f32::consts::TAU / 3.0;
    /// let turn = Pose::<f32>::about(vec3(1.0, 1.0, 1.0), third)?;
    /// assert!((turn.point(vec3(5.0, 0.0, 0.0)) - vec3(0.0, 5.0, 0.0)).max_abs() < 1e-5);
    /// // A joint turns about a point of its own.
    /// let elbow = turn.around(vec3(2.0, 0.0, 0.0))?;
    /// assert!((elbow.point(vec3(7.0, 0.0, 0.0)) - vec3(2.0, 5.0, 0.0)).max_abs() < 1e-5);
    /// # Ok::<(), scancsg::geom::PoseError>(())
    /// ```
    ///
    /// The formula is that of Rodrigues (1840): `p cos φ + (k × p) sin φ + k (k·p)(1 − cos φ)`.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`], [`PoseError::ZeroAxis`].
    pub fn about(axis: Vec3<S>, angle: S) -> Result<Self, PoseError> {
        if !axis.is_finite() {
            return Err(PoseError::NotFinite);
        }
        let axis = Direction::normalized(axis).ok_or(PoseError::ZeroAxis)?;
        let Vec3 { x, y, z } = axis.vector();
        let signed = |sign: S::Unit| if sign < S::Unit::ZERO { angle.negated() } else { angle };
        match axis.along() {
            Some(Axis::X) => return Self::rotation_x(signed(x)),
            Some(Axis::Y) => return Self::rotation_y(signed(y)),
            Some(Axis::Z) => return Self::rotation_z(signed(z)),
            None => {}
        }
        if !angle.is_finite() {
            return Err(PoseError::NotFinite);
        }
        let (k, (sin, cos)) = (axis.wide(), angle.wide().sin_cos());
        let axes = Self::IDENTITY.axes.map(|axis| {
            let own = axis.map(S::wide_unit);
            own * cos + k.cross(own) * sin + k * (k.dot(own) * (S::Wide::ONE - cos))
        });
        Ok(Self { axes: orthonormal(axes).map(|axis| axis.map(S::unit)), translation: Vec3::ZERO })
    }

    /// The motion that takes the coordinate axes x, y and z along three directions, and the origin to a point:
    /// from the columns of a matrix, or from what was measured.
    ///
    /// ```
    /// use scancsg::geom::{Pose, vec3};
    ///
    /// // The columns of a matrix with six digits: 30 degrees about x.
    /// let axes = [vec3(1.0, 0.0, 0.0), vec3(0.0, 0.866025, 0.5), vec3(0.0, -0.5, 0.866025)];
    /// let pose = Pose::<f32>::with_axes(axes, vec3(0.0, 0.0, 7.0))?;
    /// assert!((pose.point(vec3(0.0, 2.0, 0.0)) - vec3(0.0, 1.732051, 8.0)).max_abs() < 1e-5);
    /// # Ok::<(), scancsg::geom::PoseError>(())
    /// ```
    ///
    /// Only their directions count, which are made orthonormal: they must be right-handed, and the cosine between
    /// any two at most 2⁻¹⁰. In fixed point, long vectors have more digits. What scales is an
    /// [`AffineMap`](super::AffineMap).
    ///
    /// # Errors
    /// [`PoseError::NotFinite`], [`PoseError::ZeroAxis`], [`PoseError::NotRigid`], [`PoseError::TooFar`].
    pub fn with_axes(axes: [Vec3<S>; 3], origin: Vec3<S>) -> Result<Self, PoseError> {
        if !(origin.is_finite() && axes.iter().all(|axis| axis.is_finite())) {
            return Err(PoseError::NotFinite);
        }
        let mut frame = [Vec3::<S::Wide>::ZERO; 3];
        for (unit, axis) in frame.iter_mut().zip(axes) {
            *unit = Direction::normalized(axis).ok_or(PoseError::ZeroAxis)?.wide();
        }
        let [x, y, z] = frame;
        let is_right = |one: Vec3<S::Wide>, other| {
            one.dot(other).abs() * S::Wide::from_int(1 << 10) <= S::Wide::ONE
        };
        let is_frame = is_right(x, y) && is_right(y, z) && is_right(z, x);
        if !(is_frame && x.cross(y).dot(z) > S::Wide::ZERO) {
            return Err(PoseError::NotRigid);
        }
        // Deviations become 2⁻²⁰, 2⁻⁴⁰, 2⁻⁸⁰.
        let frame = (0..3).fold(frame, |frame, _| orthonormal(frame));
        Self { axes: frame.map(|axis| axis.map(S::unit)), translation: origin }.checked()
    }

    /// The same motion with `point` in the origin's place: a turn about the origin becomes one about the
    /// point.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`], [`PoseError::TooFar`].
    pub fn around(&self, point: Vec3<S>) -> Result<Self, PoseError> {
        let there = Self::translation(point)?.translation;
        Self { translation: self.point(-there) + there, ..*self }.checked()
    }

    /// This pose first, then `next`.
    ///
    /// The result is made orthonormal again, so poses may be composed without end: after a million
    /// turns the axes still have length 1 and are at right angles, up to rounding.
    ///
    /// # Errors
    /// [`PoseError::TooFar`].
    pub fn then(&self, next: &Self) -> Result<Self, PoseError> {
        let axes = orthonormal(self.axes.map(|axis| next.turned(axis.map(S::wide_unit))));
        let axes = axes.map(|axis| axis.map(S::unit));
        Self { axes, translation: next.point(self.translation) }.checked()
    }

    /// The pose that moves everything back.
    ///
    /// ```
    /// use scancsg::geom::{Pose, vec3};
    ///
    /// let shift = Pose::<f32>::translation(vec3(3.0, -2.0, 1.0))?;
    /// assert_eq!(shift.then(&shift.inverse()?)?, Pose::IDENTITY);
    /// # Ok::<(), scancsg::geom::PoseError>(())
    /// ```
    ///
    /// # Errors
    /// [`PoseError::TooFar`]: turned back, a translation may have a larger coordinate than before.
    pub fn inverse(&self) -> Result<Self, PoseError> {
        let [x, y, z] = self.axes;
        let axes = [Vec3::new(x.x, y.x, z.x), Vec3::new(x.y, y.y, z.y), Vec3::new(x.z, y.z, z.z)];
        Self { axes, translation: self.direction_back(-self.translation) }.checked()
    }

    /// The images of the axes, and of the origin.
    pub(crate) fn frame(&self) -> ([Vec3<S::Unit>; 3], Vec3<S>) {
        (self.axes, self.translation)
    }

    /// The motion that takes the axes and the origin there, if it is a rigid one up to rounding.
    pub(crate) fn of_frame(axes: [Vec3<S::Unit>; 3], translation: Vec3<S>) -> Option<Self> {
        Self::rigid(axes, translation).ok()
    }

    fn rigid(axes: [Vec3<S::Unit>; 3], translation: Vec3<S>) -> Result<Self, PoseError> {
        if !(translation.is_finite() && axes.iter().all(|axis| axis.is_finite())) {
            return Err(PoseError::NotFinite);
        }
        let [x, y, z] = axes.map(|axis| axis.map(S::wide_unit));
        let is_frame = [(x, y), (y, z), (z, x)].into_iter().all(|(one, other)| {
            is_rounded(one.dot_compensated(one), S::Wide::ONE)
                && is_rounded(one.dot_compensated(other), S::Wide::ZERO)
        });
        if !(is_frame && x.cross(y).dot(z) > S::Wide::ZERO) {
            return Err(PoseError::NotRigid);
        }
        Self { axes, translation }.checked()
    }

    fn checked(self) -> Result<Self, PoseError> {
        if self.translation.is_within_range() { Ok(self) } else { Err(PoseError::TooFar) }
    }

    /// A point of the own frame, in the scene's.
    #[must_use]
    pub fn point(&self, own: Vec3<S>) -> Vec3<S> {
        self.direction(own) + self.translation
    }

    /// A direction of the own frame, in the scene's.
    #[must_use]
    pub fn direction(&self, own: Vec3<S>) -> Vec3<S> {
        self.turned(own.wide()).map(S::from_wide)
    }

    fn turned(&self, own: Vec3<S::Wide>) -> Vec3<S::Wide> {
        let [x, y, z] = self.axes.map(|axis| axis.map(S::wide_unit));
        x * own.x + y * own.y + z * own.z
    }

    /// A point of the scene, in the own frame.
    #[must_use]
    pub fn point_back(&self, scene: Vec3<S>) -> Vec3<S> {
        self.direction_back(scene - self.translation)
    }

    /// A direction of the scene, in the own frame.
    #[must_use]
    pub fn direction_back(&self, scene: Vec3<S>) -> Vec3<S> {
        self.turned_back(scene.wide()).map(S::from_wide)
    }

    pub(super) fn axes_and_translation(&self) -> ([Vec3<S::Wide>; 3], Vec3<S>) {
        (self.axes.map(|axis| axis.map(S::wide_unit)), self.translation)
    }

    pub(super) fn point_back_wide(&self, scene: Vec3<S::Wide>) -> Vec3<S::Wide> {
        self.turned_back(scene - self.translation.wide())
    }

    pub(super) fn turned_back(&self, scene: Vec3<S::Wide>) -> Vec3<S::Wide> {
        let [x, y, z] = self.axes.map(|axis| axis.map(S::wide_unit).dot(scene));
        Vec3::new(x, y, z)
    }

    /// A line of the scene, in the own frame; the parameter stays. In fixed point, its direction is
    /// rounded to the number type, so it is best a long one.
    #[must_use]
    pub fn line_back(&self, line: &Line<S>) -> Line<S> {
        Line {
            origin: self.point_back(line.origin),
            direction: self.direction_back(line.direction),
        }
    }
}

per_scalar! { $S: impl[] Pose<$S> {
    /// Quarter turns about a coordinate axis, as many as `count`, in the direction of
    /// [`rotation_x`](Self::rotation_x) and its like. It is exact, and there are no angles to be typed.
    ///
    /// ```
    /// use scancsg::constant;
    /// use scancsg::geom::{Axis, Pose, vec3};
    ///
    /// const UPRIGHT: Pose<f32> =
    ///     constant!(Pose::<f32>::quarter_turns(Axis::Z, 1).shifted(vec3(0.0, 0.0, 3.0)));
    /// assert_eq!(UPRIGHT.point(vec3(2.0, 0.0, 0.0)), vec3(0.0, 2.0, 3.0));
    /// ```
    #[must_use]
    pub const fn quarter_turns(axis: Axis, count: i32) -> Self {
        type Ops<S> = ConstOps<<S as Scalar>::Unit>;
        let (zero, one) = (Ops::<$S>::ZERO, Ops::<$S>::ONE);
        let minus = Ops::<$S>::difference(zero, one);
        let (sin, cos) = match count.rem_euclid(4) {
            0 => (zero, one),
            1 => (one, zero),
            2 => (zero, minus),
            _ => (minus, zero),
        };
        let back = Ops::<$S>::difference(zero, sin);
        let axes = match axis {
            Axis::X => [[one, zero, zero], [zero, cos, sin], [zero, back, cos]],
            Axis::Y => [[cos, zero, back], [zero, one, zero], [sin, zero, cos]],
            Axis::Z => [[cos, sin, zero], [back, cos, zero], [zero, zero, one]],
        };
        let [[a, b, c], [d, e, f], [g, h, i]] = axes;
        let axes = [vec3(a, b, c), vec3(d, e, f), vec3(g, h, i)];
        Self { axes, translation: Vec3::ZERO }
    }

    /// Half a turn about a coordinate axis: exact.
    #[must_use]
    pub const fn half_turn(axis: Axis) -> Self {
        Self::quarter_turns(axis, 2)
    }

    /// This pose first, then a shift: what [`then`](Self::then) does with a translation, for constants.
    ///
    /// # Errors
    /// [`PoseError::NotFinite`], [`PoseError::TooFar`].
    pub const fn shifted(self, by: Vec3<$S>) -> Result<Self, PoseError> {
        type Ops<S> = ConstOps<S>;
        let Vec3 { x, y, z } = self.translation;
        let translation =
            vec3(Ops::<$S>::sum(x, by.x), Ops::<$S>::sum(y, by.y), Ops::<$S>::sum(z, by.z));
        match () {
            () if !by.has_finite_coordinates() => Err(PoseError::NotFinite),
            () if !translation.is_within_reach() => Err(PoseError::TooFar),
            () => Ok(Self { axes: self.axes, translation }),
        }
    }
} }

impl<S: Scalar> Pose<S> {
    /// As [`line_back`](Self::line_back), with its parameter counted from about the point nearest to `near`,
    /// a point of the own frame; and the parameter there.
    ///
    /// So what rounding a direction in fixed point loses doesn't grow with the way from the line's start.
    /// Floating point, and directions that stay exact, need none of this.
    #[inline]
    pub(crate) fn line_back_near(
        &self,
        line: &Line<S>,
        near: impl FnOnce() -> Vec3<S>,
    ) -> (Line<S>, S) {
        let exact = self.turned_back(line.direction.wide());
        let direction = exact.map(S::from_wide);
        if S::SHORTEST <= S::ZERO || direction.wide() == exact {
            return (Line { origin: self.point_back(line.origin), direction }, S::ZERO);
        }
        let from = line.parameter_near(self.point(near()));
        let start = line.origin.wide() + line.direction.wide() * from.wide();
        (Line { origin: self.point_back_wide(start).map(S::from_wide), direction }, from)
    }
}

/// The frame itself where it is orthonormal, else one much nearer to that: deviations become as large as
/// their squares. It is a step of Newton's method for the polar decomposition,
/// `M − M (MᵀM − 1)/2` (Higham, *Computing the polar decomposition*, SIAM J. Sci. Stat. Comput. 7, 1986).
fn orthonormal<T: Real>([x, y, z]: [Vec3<T>; 3]) -> [Vec3<T>; 3] {
    let half = |a: Vec3<T>, b: Vec3<T>, want: T| (a.dot_compensated(b) - want) * T::HALF;
    let [xx, yy, zz] = [x, y, z].map(|axis| half(axis, axis, T::ONE));
    let [xy, yz, zx] = [(x, y), (y, z), (z, x)].map(|(a, b)| half(a, b, T::ZERO));
    [x - (x * xx + y * xy + z * zx), y - (x * xy + y * yy + z * yz), z - (x * zx + y * yz + z * zz)]
}

/// A sine and a cosine, and the axes that a turn starts from.
type Turn<S> = (<S as Scalar>::Unit, <S as Scalar>::Unit, [Vec3<<S as Scalar>::Unit>; 3]);

fn turn<S: Scalar>(angle: S) -> Result<Turn<S>, PoseError> {
    if !angle.is_finite() {
        return Err(PoseError::NotFinite);
    }
    let (sin, cos) = angle.wide().sin_cos();
    Ok((S::unit(sin), S::unit(cos), Pose::<S>::IDENTITY.axes))
}

/// A pose as it is serialised: with all its bits.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(bound(
    serialize = "S: serde::Serialize, S::Unit: serde::Serialize",
    deserialize = "S: serde::Deserialize<'de>, S::Unit: serde::Deserialize<'de>"
))]
struct Parts<S: Scalar> {
    axes: [Vec3<S::Unit>; 3],
    translation: Vec3<S>,
}

#[cfg(feature = "serde")]
impl<S: Scalar> From<Pose<S>> for Parts<S> {
    fn from(Pose { axes, translation }: Pose<S>) -> Self {
        Self { axes, translation }
    }
}

#[cfg(feature = "serde")]
impl<S: Scalar> TryFrom<Parts<S>> for Pose<S> {
    type Error = PoseError;

    fn try_from(Parts { axes, translation }: Parts<S>) -> Result<Self, PoseError> {
        Self::rigid(axes, translation)
    }
}
