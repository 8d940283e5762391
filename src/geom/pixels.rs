//! The rays of a picture, as affine functions of the pixel.
//!
//! A picture's *image plane* is the plane through the scene's centre at right angles to the
//! viewing direction. A pixel (X, Y), counted from the middle of the picture, sees the point
//! `P = centre + X·right + Y·down` of it, and the parameter t of its ray is zero there. So t stays
//! as small as the scene, however far away the camera is.
//!
//! X and Y are counted in half pixels, because the middle of a picture of even width lies between
//! two pixels. So they are whole numbers.

use super::{Line, Pose, Vec3};
use crate::scalar::{Number, Real, Scalar};

/// A pixel's column: its index, and its centre counted from the middle of the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// 0 at the left.
    pub index: u32,
    /// In half pixels from the middle of the picture, positive to the right.
    pub x: i32,
}

/// A number that changes by the same step from each half pixel to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine<T> {
    /// In the middle of the row.
    pub middle: T,
    /// What half a pixel to the right adds.
    pub step: T,
}

impl<T: Real> Affine<T> {
    /// The row, `y` half pixels below the middle, of what is given in the middle of the picture and
    /// by its steps to the right and down.
    #[inline]
    #[must_use]
    pub fn row([middle, right, down]: [T; 3], y: i32) -> Self {
        Self { middle: middle.after_steps(down, y), step: right }
    }

    /// The number `x` half pixels to the right of the middle.
    #[inline]
    #[must_use]
    pub fn at(&self, x: i32) -> T {
        self.middle.after_steps(self.step, x)
    }

    /// The same multiple of a number everywhere.
    #[inline]
    #[must_use]
    pub fn times(&self, factor: T) -> Self {
        Self { middle: self.middle * factor, step: self.step * factor }
    }
}

/// The columns, from `start` to before `end`, outside of which a solid can't be seen in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Extent {
    /// The first column.
    pub start: u32,
    /// Behind the last column.
    pub end: u32,
}

impl Extent {
    /// No column.
    pub const EMPTY: Self = Self { start: 0, end: 0 };

    /// All columns of a row.
    #[must_use]
    pub const fn all(columns: u32) -> Self {
        Self { start: 0, end: columns }
    }

    /// Whether no column is left.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.start >= self.end
    }

    /// Whether a column is inside.
    #[must_use]
    #[inline]
    pub const fn contains(self, index: u32) -> bool {
        self.start <= index && index < self.end
    }

    /// From the first column of either to the last of either.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        match (self.is_empty(), other.is_empty()) {
            (true, _) => other,
            (_, true) => self,
            _ => Self { start: self.start.min(other.start), end: self.end.max(other.end) },
        }
    }

    /// The columns of both.
    #[must_use]
    pub fn overlap(self, other: Self) -> Self {
        let (start, end) = (self.start.max(other.start), self.end.min(other.end));
        if start < end { Self { start, end } } else { Self::EMPTY }
    }
}

/// The rays of a picture, orthographic or perspective.
pub trait Rays: Copy {
    /// The number type.
    type Scalar: Scalar;

    /// The rays of one row.
    type Row: RayRow<Scalar = Self::Scalar>;

    /// The number of columns.
    fn columns(&self) -> u32;

    /// The rays of the row `y` half pixels below the middle of the picture.
    fn row(&self, y: i32) -> Self::Row;

    /// The smallest parameter that the camera sees.
    fn start(&self) -> Self::Scalar;

    /// Whether a picture of so many rows keeps inside the number type's range: in fixed point, the image
    /// plane may reach to half of that ([`Scalar::HIGHEST`]).
    fn fits(&self, rows: u16) -> bool;

    /// The same rays in the own frame of a solid that stands at `pose`.
    #[must_use]
    fn back_from(&self, pose: &Pose<Self::Scalar>) -> Self;
}

/// The rays of one row of a picture.
pub trait RayRow: Copy {
    /// The number type.
    type Scalar: Scalar;

    /// The ray `x` half pixels to the right of the middle.
    fn line(&self, x: i32) -> Line<Self::Scalar>;
}

/// The rays of an orthographic picture: all parallel to `forward`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrthographicRays<S: Scalar> {
    /// What the middle of the picture shows.
    pub center: Vec3<S::Wide>,
    /// The direction to the right in the image plane, of length 1.
    pub right: Vec3<S::Wide>,
    /// The direction downwards in the image plane, of length 1.
    pub down: Vec3<S::Wide>,
    /// The viewing direction, of length 1.
    pub forward: Vec3<S::Wide>,
    /// The size of half a pixel.
    pub half_pixel: S::Wide,
    /// The number of columns.
    pub columns: u32,
}

impl<S: Scalar> OrthographicRays<S> {
    /// The middle of the picture as seen from a point, and the steps of half a pixel to the right
    /// and down.
    pub(crate) fn steps(&self, from: Vec3<S::Wide>) -> [Vec3<S::Wide>; 3] {
        [self.center - from, self.right * self.half_pixel, self.down * self.half_pixel]
    }
}

/// A row of the image plane.
#[derive(Debug, Clone, Copy, PartialEq)]
struct PlaneRow<S: Scalar> {
    center: Vec3<S::Wide>,
    /// The way from the centre to the middle of the row.
    down: Vec3<S::Wide>,
    /// The step of half a pixel.
    right: Vec3<S::Wide>,
}

impl<S: Scalar> PlaneRow<S> {
    fn new(plane: &OrthographicRays<S>, y: i32) -> Self {
        let [center, right, down] = plane.steps(Vec3::ZERO);
        Self { center, down: down.map(|step| S::Wide::ZERO.after_steps(step, y)), right }
    }

    /// The way from the centre to a pixel.
    #[inline]
    fn offset(&self, x: i32) -> Vec3<S::Wide> {
        let Self { down, right, .. } = self;
        Vec3::new(
            down.x.after_steps(right.x, x),
            down.y.after_steps(right.y, x),
            down.z.after_steps(right.z, x),
        )
    }
}

/// A row of parallel rays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrthographicRow<S: Scalar> {
    plane: PlaneRow<S>,
    direction: Vec3<S>,
}

impl<S: Scalar> RayRow for OrthographicRow<S> {
    type Scalar = S;

    #[inline]
    fn line(&self, x: i32) -> Line<S> {
        let Self { plane, direction } = self;
        Line { origin: (plane.center + plane.offset(x)).map(S::from_wide), direction: *direction }
    }
}

impl<S: Scalar> Rays for OrthographicRays<S> {
    type Scalar = S;
    type Row = OrthographicRow<S>;

    fn fits(&self, rows: u16) -> bool {
        // More than from the middle to a corner.
        let half_pixels = S::Wide::from_int(self.columns as i32 + i32::from(rows));
        self.half_pixel * half_pixels < S::HIGHEST.wide() * S::Wide::HALF
    }

    fn columns(&self) -> u32 {
        self.columns
    }

    fn row(&self, y: i32) -> OrthographicRow<S> {
        OrthographicRow { plane: PlaneRow::new(self, y), direction: self.forward.map(S::from_wide) }
    }

    fn start(&self) -> S {
        S::LOWEST
    }

    fn back_from(&self, pose: &Pose<S>) -> Self {
        Self {
            center: pose.point_back_wide(self.center),
            right: pose.turned_back(self.right),
            down: pose.turned_back(self.down),
            forward: pose.turned_back(self.forward),
            ..*self
        }
    }
}

/// The rays of a perspective picture: a pencil through the eye.
///
/// The ray of a pixel has the direction `forward + (X·right + Y·down)/distance`, so t is counted
/// along the viewing direction and the eye lies at t = −`distance`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PerspectiveRays<S: Scalar> {
    /// The steps of the image plane, as for parallel rays.
    pub plane: OrthographicRays<S>,
    /// From the eye to the centre.
    pub distance: S::Wide,
    /// 1/`distance`.
    pub inverse_distance: S::Wide,
    /// How often directions must be halved to have coordinates that [`Scalar::Unit`] can hold: 0 in
    /// floating point, and for all but very wide pictures.
    pub halvings: u8,
}

impl<S: Scalar> PerspectiveRays<S> {
    /// The parameter along a direction that was halved so often, as one along the direction itself.
    #[inline]
    pub(crate) fn along_whole(t: S, halvings: u8) -> S {
        // Known without looking in floating point, which never halves.
        let is_whole = S::SHORTEST <= S::ZERO || halvings == 0;
        if is_whole || t <= S::LOWEST || t >= S::HIGHEST {
            return t;
        }
        S::from_wide(t.wide() * shortening(halvings))
    }
}

/// The factor of directions that are halved so often.
fn shortening<T: Real>(halvings: u8) -> T {
    (0..halvings).fold(T::ONE, |factor, _| factor * T::HALF)
}

/// Coordinates that are halved as often as directions are.
pub(crate) fn shortened<T: Real, const N: usize>(
    parts: [Affine<T>; N],
    halvings: u8,
) -> [Affine<T>; N] {
    match halvings {
        0 => parts,
        _ => parts.map(|part| part.times(shortening(halvings))),
    }
}

/// A row of a pencil of rays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PerspectiveRow<S: Scalar> {
    plane: PlaneRow<S>,
    forward: Vec3<S::Wide>,
    inverse_distance: S::Wide,
}

impl<S: Scalar> RayRow for PerspectiveRow<S> {
    type Scalar = S;

    #[inline]
    fn line(&self, x: i32) -> Line<S> {
        let offset = self.plane.offset(x);
        Line {
            origin: (self.plane.center + offset).map(S::from_wide),
            direction: (self.forward + offset * self.inverse_distance).map(S::from_wide),
        }
    }
}

impl<S: Scalar> Rays for PerspectiveRays<S> {
    type Scalar = S;
    type Row = PerspectiveRow<S>;

    fn fits(&self, rows: u16) -> bool {
        // What half a pixel adds to a moment about a solid as far from the target as may be, which is less
        // than four times the reach, must be below 2³¹. Floating point has no such range.
        let most = S::Wide::from_int(1 << 29) / S::MAX_COORDINATE.wide();
        self.plane.fits(rows) && (S::SHORTEST <= S::ZERO || self.plane.half_pixel < most)
    }

    fn columns(&self) -> u32 {
        self.plane.columns
    }

    fn row(&self, y: i32) -> PerspectiveRow<S> {
        PerspectiveRow {
            plane: PlaneRow::new(&self.plane, y),
            forward: self.plane.forward,
            inverse_distance: self.inverse_distance,
        }
    }

    fn start(&self) -> S {
        S::from_wide(-self.distance)
    }

    fn back_from(&self, pose: &Pose<S>) -> Self {
        Self { plane: self.plane.back_from(pose), ..*self }
    }
}
