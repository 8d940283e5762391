//! The columns in which rays from an eye can meet a solid, from where a quadratic in X is not
//! negative.

use super::strip::{Rows, Steps};
use crate::geom::{Affine, Extent, PerspectiveRays, Vec3};
use crate::scalar::{Number, Real, Scalar};

/// The columns of a row in which `Σ plus² ≥ Σ minus²` may hold, for lengths that are affine in X.
///
/// With X from −1 to 1 over the row, and lengths scaled so that the largest is between 1 and 2, the
/// rounding errors of coefficients and discriminant are at most some 16 units of the terms that
/// they were summed from; 64 are allowed for, and a column on either side for the roots' own
/// rounding. What fixed point lost when the lengths were rounded is added. Where the quadratic
/// isn't clearly concave, or the errors' bound itself vanishes, all columns are returned.
#[inline(never)] // once a row is seldom, and the code is long
pub(super) fn extent<T: Real>(plus: &[Affine<T>], minus: &[Affine<T>], columns: u32) -> Extent {
    let all = Extent::all(columns);
    let reach = T::from_int(columns as i32);
    let lengths = || plus.iter().chain(minus);
    let largest = lengths()
        .map(|length| length.middle.abs() + length.step.abs() * reach)
        .fold(T::ZERO, T::max);
    if largest <= T::ZERO || !largest.is_finite() {
        return all;
    }
    let scale = largest.normalizing_power();

    let mut sum = [T::ZERO; 3];
    let mut size = [T::ZERO; 3];
    for (i, length) in lengths().enumerate() {
        let (middle, way) = (length.middle * scale, length.step * reach * scale);
        let cross = middle * way;
        let terms = [middle * middle, cross + cross, way * way];
        for ((sum, size), term) in sum.iter_mut().zip(&mut size).zip(terms) {
            *sum = if i < plus.len() { *sum + term } else { *sum - term };
            *size = *size + term.abs();
        }
    }
    let unit = T::EPSILON * T::from_int(64);
    // Middle and step are off by 2 quanta; their squares, by 4 times as much for each of 4 lengths.
    let blur = T::QUANTUM * scale * (reach + T::ONE) * T::from_int(32);
    let [c0, c1, c2] = sum;
    let [s0, s1, s2] = size;

    let most = c0 + c1.abs() + c2.max(T::ZERO);
    let error = (s0 + s1 + s2) * unit + blur;
    if most + error < T::ZERO && error > T::ZERO {
        return Extent::EMPTY;
    }
    // Quotients by c2 must be good to a fraction of a column.
    if c2 + s2 * unit + (blur + T::QUANTUM * T::from_int(256)) * T::from_int(4096) >= T::ZERO {
        return all;
    }
    let half_c1 = c1 * T::HALF;
    let quarter = half_c1 * half_c1 - c0 * c2;
    let rounding = (s1 * s1 + s0 * s2) * unit;
    let quarter_error = rounding + (s0 + s1 + s2) * blur + T::QUANTUM * T::from_int(8);
    if (rounding * T::EPSILON + T::QUANTUM).positive().is_none() {
        return all;
    }
    if quarter + quarter_error < T::ZERO {
        return Extent::EMPTY;
    }
    let root = (quarter + quarter_error).sqrt();
    let column = |x: T| (x + T::ONE) * reach * T::HALF - T::HALF;
    let left = column((half_c1 - root) / -c2);
    let right = column((half_c1 + root) / -c2);
    if !left.is_finite() || !right.is_finite() {
        return all;
    }
    let start = left.floor_to_i32().saturating_sub(1).max(0) as u32;
    let end = right.floor_to_i32().saturating_add(2).max(0) as u32;
    all.overlap(Extent { start, end })
}

/// A length that is the same in all columns.
pub(super) fn constant<T: Real>(length: T) -> Affine<T> {
    Affine { middle: length, step: T::ZERO }
}

/// A ball around a bounded solid, seen from an eye.
///
/// In the camera's own frame, with axes to the right, down and forward, the ray of a pixel is along
/// d = (x, y, 1). It meets the ball around c where `r²|d|² − |c × d|² ≥ 0`, with c as seen from the
/// eye. Both vectors are affine in the column, and the eye's distance cancels out of the second.
#[derive(Debug, Clone, Copy)]
pub struct PerspectiveBall<S: Scalar> {
    /// As seen from the middle of the picture, in the camera's frame.
    center: Vec3<S::Wide>,
    radius: S::Wide,
    /// The size of half a pixel in the image plane.
    half_pixel: S::Wide,
    /// What half a pixel adds to x or y: the pitch over the eye's distance.
    slope: S::Wide,
    rows: Rows,
}

impl<S: Scalar> PerspectiveBall<S> {
    pub(super) fn new(center: Vec3<S::Wide>, radius: S::Wide, rays: &PerspectiveRays<S>) -> Self {
        let plane = &rays.plane;
        let from_middle = center - plane.center;
        let along = |direction: Vec3<S::Wide>| from_middle.dot_compensated(direction);
        let center = Vec3::new(along(plane.right), along(plane.down), along(plane.forward));
        let (half_pixel, slope) = (plane.half_pixel, plane.half_pixel * rays.inverse_distance);
        let rows = Self::rows(center, radius, rays.distance, slope);
        Self { center, radius, half_pixel, slope, rows }
    }

    /// The rows that can meet the ball.
    ///
    /// Row s·z = y meets it where |y − s·z| ≤ r√(1 + s²), with its centre at (x, y, z) from the eye.
    /// The root is at most 1 + |s|, so s lies between (y − r)/(z ± r) and (y + r)/(z ± r), with
    /// the sign that makes that farther away.
    fn rows(center: Vec3<S::Wide>, radius: S::Wide, distance: S::Wide, slope: S::Wide) -> Rows {
        let far = center.z + distance;
        let size = center.max_abs() + distance + radius;
        // Three coordinates, each of which is as large as that.
        let radius = radius + S::uncertainty(size + size + size);
        let (nearest, farthest) = (far - radius, far + radius);
        if !nearest.is_divisor() || nearest <= S::Wide::ZERO || !farthest.is_finite() {
            return Rows::ALL;
        }
        let (low, high) = (center.y - radius, center.y + radius);
        let low = low / if low < S::Wide::ZERO { nearest } else { farthest };
        let high = high / if high < S::Wide::ZERO { farthest } else { nearest };
        let at = Affine { middle: S::Wide::ZERO, step: slope };
        Rows::of(Steps::between::<S>(at, low, high, low.abs() + high.abs()))
    }

    /// d in a row.
    pub(super) fn direction(&self, y: i32) -> [Affine<S::Wide>; 3] {
        let x = Affine { middle: S::Wide::ZERO, step: self.slope };
        [x, constant(S::Wide::ZERO.after_steps(self.slope, y)), constant(S::Wide::ONE)]
    }

    /// p − c in a row, p being where the rays have t = 0.
    pub(super) fn position(&self, y: i32) -> [Affine<S::Wide>; 3] {
        let Vec3 { x, y: across, z } = self.center;
        let along = Affine { middle: -x, step: self.half_pixel };
        [along, constant((-across).after_steps(self.half_pixel, y)), constant(-z)]
    }

    /// c × d in a row, with c as seen from the eye.
    pub(super) fn moment(&self, y: i32) -> [Affine<S::Wide>; 3] {
        let Vec3 { x: cx, y: cy, z: cz } = self.center;
        // What half a pixel is at the ball's distance.
        let lever = self.half_pixel + cz * self.slope;
        [
            constant(cy.after_steps(-lever, y)),
            Affine { middle: -cx, step: lever },
            Affine {
                middle: S::Wide::ZERO.after_steps(cx * self.slope, y),
                step: -(cy * self.slope),
            },
        ]
    }

    /// Whether any of these rows can meet the ball.
    pub(super) fn is_in_rows(&self, rows: [i32; 2]) -> bool {
        self.rows.meet(rows)
    }

    pub(super) fn extent(&self, y: i32, columns: u32) -> Extent {
        let reach = self.direction(y).map(|part| part.times(self.radius + S::ROUNDING.wide()));
        extent(&reach, &self.moment(y), columns)
    }
}
