//! Volume, centroid, extent and second moments, by integration of spans.

use super::lattice;
use crate::geom::{Ray, Vec3};
use crate::scalar::{Number, Real, Scalar};
use crate::solid::{Bounds, RayCast, Solid};
use crate::span::SpanList;

/// What a part of even density weighs, how it balances and how it turns: volume, centroid, second moments,
/// and the box that it fills.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::inspect::MassProperties;
/// use scancsg::solid::{Bounds, Cylinder};
/// use scancsg::span::SpanList;
///
/// let tube = Cylinder::<f32>::along_x(0.0, 0.0, 1.0, -2.0, 2.0)?
///     - Cylinder::<f32>::along_x(0.0, 0.0, 0.5, -3.0, 3.0)?;
/// let within = Bounds::Box { low: vec3(-2.0, -1.0, -1.0), high: vec3(2.0, 1.0, 1.0) };
/// let mass = MassProperties::of(&tube, within, 64, &mut SpanList::<_, 4>::new())?;
///
/// let exact = std::f32::consts::PI * (1.0 - 0.25) * 4.0;
/// assert!((mass.volume - exact).abs() < 0.002 * exact);
/// assert!(mass.centroid.x.abs() < 0.01);
/// // Of a part that weighs 3 kg: its moment of inertia about x.
/// let inertia = 3.0 * (mass.moments.y + mass.moments.z);
/// assert!((inertia - 3.0 * (1.0 + 0.25) / 2.0).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # How it is computed
///
/// Rays along each of the three axes pass through the points of a lattice across the box: 3n² rays for n
/// rows. Lengths of their spans, and moments of these, are summed with what rounding left of the sums before
/// (Kahan, *Further remarks on reducing truncation errors*, 1965), and the three axes are averaged. Memory is
/// fixed. The volume's error falls about like n^−1.5, because of the rays that graze a face. Each axis has two
/// halves, every other ray: their six volumes say how far off the mean may be.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MassProperties<S: Scalar> {
    /// The volume, in cubes of the scene's unit of length. `S::from_wide` makes it a number of the scene's type, and
    /// `to_f64` (of [`Number`](crate::scalar::Number)) one of double precision.
    pub volume: S::Wide,
    /// How far off the volume may be: an estimate, the largest difference from that of six parts of the rays.
    pub volume_error: S::Wide,
    /// The centre of mass.
    pub centroid: Vec3<S>,
    /// The means of x², y² and z² over the volume, counted from the centroid. Times the mass, sums of two
    /// are moments of inertia: m(⟨y²⟩ + ⟨z²⟩) about an axis along x.
    pub moments: Vec3<S::Wide>,
    /// The means of yz, zx and xy over the volume, counted from the centroid. Times the mass and with a minus,
    /// they are the other elements of the matrix of inertia.
    pub products: Vec3<S::Wide>,
    /// The smallest coordinates that were found. Faces across an axis are found but for rounding; a tip
    /// that all rays miss is outside.
    pub low: Vec3<S>,
    /// The largest coordinates that were found.
    pub high: Vec3<S>,
}

crate::error_text! {
    /// Why there are no mass properties.
    pub enum MassError {
        /// There are no bounds to integrate in, or they are infinite or NaN.
        Unbounded => "the solid has no finite bounds to integrate in",
        /// The bounds have no volume, or no ray meets the solid inside of them.
        Empty => "nothing of the solid was found in the bounds",
        /// There are fewer than two rows.
        Rows => "there must be at least two rows",
        /// The bounds are beyond [`Scalar::MAX_COORDINATE`]; or their volume, or the square of a side, is beyond
        /// the range of [`Scalar::Wide`]: 2³¹ in fixed point.
        TooFar => "the bounds are too large for the number type",
    }
}

/// A sum, and what its rounding lost.
#[derive(Clone, Copy)]
struct Sum<T> {
    sum: T,
    lost: T,
}

impl<T: Real> Sum<T> {
    const ZERO: Self = Self { sum: T::ZERO, lost: T::ZERO };

    fn add(&mut self, term: T) {
        let term = term - self.lost;
        let sum = self.sum + term;
        self.lost = (sum - self.sum) - term;
        self.sum = sum;
    }
}

/// In how many parts the rays of an axis are, whose volumes are compared.
const PARTS: usize = 2;

/// What the rays along one axis found, in a box that counts as a unit cube around 0: sums over the rays.
/// The axis is the first of three.
struct Found<S: Scalar> {
    volumes: [Sum<S::Wide>; PARTS],
    first: [Sum<S::Wide>; 3],
    squares: [Sum<S::Wide>; 3],
    /// Of the other two coordinates.
    products: [Sum<S::Wide>; 3],
    /// The smallest and the largest coordinates of points on a ray and inside of the solid.
    low: [S; 3],
    high: [S; 3],
}

impl<S: Scalar> MassProperties<S> {
    /// The mass properties of what of a solid is within bounds, such as the solid's own
    /// ([`Solid::bounds`]), from as many rays along each axis as a square picture of so many rows has.
    ///
    /// The tighter the bounds, the better is the result. A list has room for the spans of a ray, as for
    /// [`RayCast::hit`].
    ///
    /// # Errors
    /// A [`MassError`].
    pub fn of<T: Solid<Scalar = S>, const N: usize>(
        solid: &T,
        within: Bounds<S>,
        rows: u16,
        list: &mut SpanList<S, N>,
    ) -> Result<Self, MassError> {
        let [low, high] = corners(within)?;
        let size = high - low;
        if rows < 2 {
            return Err(MassError::Rows);
        }
        let volume = size.x * size.y * size.z;
        let most = volume.max(size.max_abs() * size.max_abs());
        let is_fixed = S::SHORTEST > S::ZERO;
        if !most.is_finite() || is_fixed && most >= S::Wide::from_int(i32::MAX) {
            return Err(MassError::TooFar);
        }
        let middle = low + size * S::Wide::HALF;
        let mut along = |axis: u8| {
            let mut found = Found::NOTHING;
            let count = u32::from(rows) * u32::from(rows);
            let place = [middle, size].map(|vector| turned(vector.to_array(), axis));
            for index in 0..count {
                let at = lattice::point(index, count, axis);
                found.add(solid, axis, place, at, index as usize % PARTS, list);
            }
            found
        };
        let found = [along(0), along(1), along(2)];
        let rows = S::Wide::from_int(rows.into());
        Self::mean(&found, rows, middle, size, volume).ok_or(MassError::Empty)
    }

    /// The mean of what three axes found.
    fn mean(
        found: &[Found<S>; 3],
        rows: S::Wide,
        middle: Vec3<S::Wide>,
        size: Vec3<S::Wide>,
        box_volume: S::Wide,
    ) -> Option<Self> {
        let of_one = |sum: &Sum<S::Wide>| sum.sum / rows / rows;
        let mean = |sums: fn(&Found<S>) -> &[Sum<S::Wide>; 3]| {
            let sum = in_order(
                found.each_ref().map(|found| sums(found).each_ref().map(of_one)),
                S::Wide::plus,
            );
            sum.map(|x| x / S::Wide::from_int(3))
        };
        let all_axes = |ends: fn(&Found<S>) -> [S; 3], of| in_order(found.each_ref().map(ends), of);
        let parts = S::Wide::from_int(PARTS as i32);
        let parts = found
            .each_ref()
            .map(|found| found.volumes.each_ref().map(|volume| of_one(volume) * parts));
        let all = parts.as_flattened().iter().fold(S::Wide::ZERO, |sum, part| sum + *part);
        let volume = all / S::Wide::from_int(3 * PARTS as i32);
        if volume <= S::Wide::ZERO {
            return None;
        }
        let differ = |most: S::Wide, part: &S::Wide| most.max((*part - volume).abs());
        let error = parts.as_flattened().iter().fold(S::Wide::ZERO, differ);

        let by_volume = |v: Vec3<S::Wide>| v.map(|x| x / volume);
        let [first, squares, products] = [
            by_volume(mean(|found| &found.first)),
            by_volume(mean(|found| &found.squares)),
            by_volume(mean(|found| &found.products)),
        ];
        let times = |a: Vec3<S::Wide>, b: Vec3<S::Wide>| Vec3::new(a.x * b.x, a.y * b.y, a.z * b.z);
        let others = |v: Vec3<S::Wide>| times(Vec3::new(v.y, v.z, v.x), Vec3::new(v.z, v.x, v.y));
        Some(Self {
            volume: box_volume * volume,
            volume_error: box_volume * error,
            centroid: (middle + times(size, first)).map(S::from_wide),
            moments: times(times(size, size), squares - times(first, first)),
            products: times(others(size), products - others(first)),
            low: all_axes(|found| found.low, S::min),
            high: all_axes(|found| found.high, S::max),
        })
    }
}

/// The corners of a box around bounds, which has a volume.
fn corners<S: Scalar>(within: Bounds<S>) -> Result<[Vec3<S::Wide>; 2], MassError> {
    let [low, high] = match within {
        Bounds::Unbounded => return Err(MassError::Unbounded),
        Bounds::Ball { center, radius } => {
            let half = Vec3::new(radius, radius, radius);
            [center - half, center + half]
        }
        Bounds::Box { low, high } => [low, high],
    };
    if !(low.is_finite() && high.is_finite()) {
        return Err(MassError::Unbounded);
    }
    if !(low.is_within_range() && high.is_within_range()) {
        return Err(MassError::TooFar);
    }
    if !(low.x < high.x && low.y < high.y && low.z < high.z) {
        return Err(MassError::Empty);
    }
    Ok([low.wide(), high.wide()])
}

/// Coordinate by coordinate.
fn zipped<T>([a, b, c]: [T; 3], [x, y, z]: [T; 3], of: fn(T, T) -> T) -> [T; 3] {
    [of(a, x), of(b, y), of(c, z)]
}

/// What three axes found together, each with its coordinates in an order of its own.
fn in_order<T>([x, y, z]: [[T; 3]; 3], of: fn(T, T) -> T) -> Vec3<T> {
    Vec3::from(zipped(zipped(x, turned(y, 2), of), turned(z, 1), of))
}

/// Three coordinates, `by` of them moved from the front to the back.
fn turned<T>([a, b, c]: [T; 3], by: u8) -> [T; 3] {
    match by {
        1 => [b, c, a],
        2 => [c, a, b],
        _ => [a, b, c],
    }
}

impl<S: Scalar> Found<S> {
    const NOTHING: Self = Self {
        volumes: [Sum::ZERO; PARTS],
        first: [Sum::ZERO; 3],
        squares: [Sum::ZERO; 3],
        products: [Sum::ZERO; 3],
        low: [S::HIGHEST; 3],
        high: [S::LOWEST; 3],
    };

    /// Adds the spans of a ray.
    fn add<T: Solid<Scalar = S>, const N: usize>(
        &mut self,
        solid: &T,
        axis: u8,
        [middle, size]: [[S::Wide; 3]; 2],
        [b, c]: [S::Wide; 2],
        part: usize,
        list: &mut SpanList<S, N>,
    ) {
        let [along, width, height] = size;
        let [from, left, low] = middle;
        let origin = [from, left + width * b, low + height * c].map(S::from_wide);
        let direction = [S::ONE, S::ZERO, S::ZERO];
        let [start, direction] =
            [origin, direction].map(|vector| Vec3::from(turned(vector, (3 - axis) % 3)));
        // In range, as the box is.
        let Ok(ray) = Ray::new(start, direction) else { return };
        let half = S::from_wide(along * S::Wide::HALF);
        let [mut volume, mut first, mut square] = [S::Wide::ZERO; 3];
        for span in solid.trace(&ray, list) {
            let (enter, exit) = (span.enter.t.max(half.negated()), span.exit.t.min(half));
            if enter < exit {
                let [a, b, c] = origin;
                self.low = zipped(self.low, [a.plus(enter), b, c], S::min);
                self.high = zipped(self.high, [a.plus(exit), b, c], S::max);
                let (enter, exit) = (enter.wide() / along, exit.wide() / along);
                let (length, middle) = (exit - enter, (enter + exit) * S::Wide::HALF);
                volume = volume + length;
                first = first + length * middle;
                let twelfth = length * length / S::Wide::from_int(12);
                square = square + length * (middle * middle + twelfth);
            }
        }
        if let Some(sum) = self.volumes.get_mut(part) {
            sum.add(volume);
        }
        let moments = [first, volume * b, volume * c];
        let squares = [square, volume * b * b, volume * c * c];
        let products = [volume * b * c, first * c, first * b];
        let sums = [&mut self.first, &mut self.squares, &mut self.products];
        for (sums, terms) in sums.into_iter().zip([moments, squares, products]) {
            for (sum, term) in sums.iter_mut().zip(terms) {
                sum.add(term);
            }
        }
    }
}
