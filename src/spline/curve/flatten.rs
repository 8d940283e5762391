//! Curves as polylines, and their lengths.

use super::Curve;
use super::triangle::{on_span, triangle};
use crate::scalar::Number;
use crate::spline::error::FlattenError;
use crate::spline::point::{Inner, Point, combine, outer};
use crate::spline::scalar::Arithmetic;

/// A point of a curve, and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vertex<P: Point> {
    /// The parameter.
    pub t: P::Scalar,
    /// The curve's point there.
    pub point: P,
}

/// The vertices of a polyline that approximates a curve: see [`Curve::flatten`].
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flatten<'a, P: Point, const K: usize> {
    knots: &'a [P::Scalar],
    points: &'a [P],
    tolerance: P::Scalar,
    span: usize,
    /// Of this span; 0 before it is known.
    segments: u32,
    /// The next vertex of this span.
    next: u32,
}

/// The lengths of a curve from its beginning up to the vertices of a polyline: see
/// [`Curve::lengths`].
#[derive(Debug, Clone)]
pub struct Lengths<'a, P: Point, const K: usize> {
    polyline: Flatten<'a, P, K>,
    last: Option<Inner<P>>,
    length: <P::Scalar as Arithmetic>::Inner,
    /// What its sums lost by rounding.
    rest: <P::Scalar as Arithmetic>::Inner,
}

impl<P: Point, const K: usize, const C: usize, const N: usize> Curve<P, K, C, N> {
    /// A polyline, from the beginning of the curve to its end, that is nowhere farther from it
    /// than `tolerance` and what its vertices are rounded by: in fixed point a unit, in floating point, by
    /// de Boor's algorithm, up to 5 units in the last place of the largest coordinate of the control
    /// points for orders up to 4.
    ///
    /// Each span is divided evenly, in as many parts as it needs: with a second derivative of no
    /// more than M over a length h in the parameter, a chord is within M h²/8 of the curve (Piegl
    /// and Tiller, *The NURBS Book*, 1997, give the bound for surfaces), and M is at a control
    /// point of the second derivative. Vertices at all knots of the domain are among them; where
    /// a curve jumps at a knot of multiplicity K, it is bridged by a segment.
    ///
    /// ```
    /// use scancsg::{constant, spline::{Curve, Knots}};
    ///
    /// const KNOTS: Knots<f32, 3, 6> = constant!(Knots::<f32, 3, 6>::clamped_uniform(3, 0.0, 1.0));
    /// const ARCH: Curve<[f32; 2], 3, 3, 6> = constant!(Curve::<[f32; 2], 3, 3, 6>::new(
    ///     KNOTS, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]],
    /// ));
    /// let polyline: Vec<_> = ARCH.flatten(0.5)?.map(|vertex| vertex.point).collect();
    /// assert_eq!(polyline, [[0.0, 0.0], [2.0, 2.0], [4.0, 0.0]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`FlattenError::Tolerance`] unless the tolerance is positive and finite.
    pub fn flatten(&self, tolerance: P::Scalar) -> Result<Flatten<'_, P, K>, FlattenError> {
        if !(tolerance > P::Scalar::ZERO && tolerance.is_finite()) {
            return Err(FlattenError::Tolerance);
        }
        let (knots, points) = (self.knots.as_slice(), self.points());
        Ok(Flatten { knots, points, tolerance, span: K - 1, segments: 0, next: 0 })
    }

    /// The length of the curve up to each vertex of [`flatten`](Self::flatten), measured along the
    /// polyline; the last one is that of the whole curve.
    ///
    /// With a tolerance τ and chords of a length c, it is short by about 8τ²/3c at each. Chords are added
    /// with what rounding left of the sums before (Kahan, *Further remarks on reducing truncation
    /// errors*, 1965), so that many don't lose more than few.
    ///
    /// # Errors
    /// [`FlattenError::Tolerance`] unless the tolerance is positive and finite.
    pub fn lengths(&self, tolerance: P::Scalar) -> Result<Lengths<'_, P, K>, FlattenError> {
        let (polyline, nothing) = (self.flatten(tolerance)?, P::Scalar::ZERO.inner());
        Ok(Lengths { polyline, last: None, length: nothing, rest: nothing })
    }
}

impl<P: Point, const K: usize> Flatten<'_, P, K> {
    /// The next vertex and its parameter.
    fn step(&mut self) -> Option<(P::Scalar, Inner<P>)> {
        while self.span < self.points.len() {
            let (low, high) = (*self.knots.get(self.span)?, *self.knots.get(self.span + 1)?);
            if self.segments == 0 && low < high {
                self.segments = self.needed(low, high);
            }
            // The last vertex of a span is the first of the next one, except for the very last
            // and where the curve may jump.
            let is_last = high >= *self.knots.get(self.points.len())?;
            let may_jump = self.knots.iter().filter(|&&knot| knot == high).count() >= K;
            let has_end = low < high && (is_last || may_jump);
            let index = self.next;
            if index < self.segments.saturating_add(u32::from(has_end)) {
                self.next += 1;
                let t = if index >= self.segments {
                    high
                } else {
                    P::Scalar::between(low, high, index, self.segments)
                };
                return Some((t, on_span::<P, K>(self.knots, self.points, self.span, t)?));
            }
            (self.span, self.segments, self.next) = (self.span + 1, 0, 0);
        }
        None
    }

    /// In how many parts a span has to be divided.
    fn needed(&self, low: P::Scalar, high: P::Scalar) -> u32 {
        // Two levels of differences, as if the span had a length of 1: so nothing overflows,
        // however short it is.
        let row = triangle::<P, K>(self.knots, self.points, self.span, 2, |_, a, b, outside| {
            combine::<P>(a, b, |a, b| {
                P::Scalar::share(P::Scalar::subtract(b, a), [low, high], outside)
            });
            Some(())
        });
        let mut largest = P::Scalar::ZERO.inner();
        for difference in row.iter().flatten().take(K.saturating_sub(2)) {
            let norm = P::Scalar::norm(difference.as_ref());
            if norm > largest {
                largest = norm;
            }
        }
        let factor = ((K - 1) * K.saturating_sub(2)) as u16;
        P::Scalar::segments(largest, factor, self.tolerance)
    }
}

impl<P: Point, const K: usize> Iterator for Flatten<'_, P, K> {
    type Item = Vertex<P>;

    fn next(&mut self) -> Option<Vertex<P>> {
        let (t, point) = self.step()?;
        Some(Vertex { t, point: outer(point) })
    }
}

impl<P: Point, const K: usize> Iterator for Lengths<'_, P, K> {
    /// A parameter, and the length of the curve from its beginning to there.
    type Item = (P::Scalar, P::Scalar);

    fn next(&mut self) -> Option<Self::Item> {
        let (t, point) = self.polyline.step()?;
        if let Some(mut chord) = self.last {
            combine::<P>(&mut chord, point, |from, to| P::Scalar::subtract(to, from));
            let chord = P::Scalar::add(P::Scalar::norm(chord.as_ref()), self.rest);
            let length = P::Scalar::add(self.length, chord);
            self.rest = P::Scalar::subtract(chord, P::Scalar::subtract(length, self.length));
            self.length = length;
        }
        self.last = Some(point);
        Some((t, P::Scalar::outer(self.length)))
    }
}
