//! Insertion of knots.

use super::Curve;
use crate::scalar::Number;
use crate::spline::error::KnotError;
use crate::spline::point::{Point, combine, inner, outer};
use crate::spline::scalar::Arithmetic;

impl<P: Point, const K: usize, const C: usize, const N: usize> Curve<P, K, C, N> {
    /// Inserts a knot and with it a control point; the curve stays as it is, but for the rounding
    /// of at most K − 1 new control points.
    ///
    /// W. Boehm, *Inserting new knots into B-spline curves*, Computer-Aided Design 12 (1980); Piegl
    /// and Tiller, *The NURBS Book* (1997), section 5.2. Inserted until it is there `K − 1` times, a
    /// knot has a control point on the curve.
    ///
    /// ```
    /// use scancsg::spline::{Curve, Knots, Outside};
    ///
    /// // A parabola from (0, 0) to (4, 0), with room for a fourth control point.
    /// let knots = Knots::<f32, 3, 7>::new(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0])?;
    /// let mut curve = Curve::<[f32; 2], 3, 4, 7>::from_slice(knots, &[[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]])?;
    /// curve.insert(0.5)?;
    /// assert_eq!(curve.points(), [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// assert_eq!(curve.value(0.5, Outside::Error)?, [2.0, 2.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`KnotError::NotFinite`]; [`KnotError::Outside`] of the domain; [`KnotError::Multiplicity`] if the
    /// knot is there `K` times already; [`KnotError::TooMany`] without room for another knot and control
    /// point. The curve is as before then.
    pub fn insert(&mut self, knot: P::Scalar) -> Result<(), KnotError> {
        if !knot.is_finite() {
            return Err(KnotError::NotFinite);
        }
        if !self.domain().contains(knot) {
            return Err(KnotError::Outside);
        }
        let knots = self.knots.as_slice();
        let count = self.knots.points();
        if knots.len() >= N || count >= C {
            return Err(KnotError::TooMany);
        }
        if knots.iter().filter(|&&other| other == knot).count() >= K {
            return Err(KnotError::Multiplicity);
        }
        // From the last one on, so that the old point in front is still there.
        for i in (1..=count).rev() {
            let (Some(&low), Some(&high)) = (knots.get(i), knots.get(i + K - 1)) else { continue };
            if high <= knot {
                break;
            }
            let Some([before, own]) = self.points.get_mut(i - 1..=i) else { continue };
            let mut point = inner(*before);
            if low < knot {
                let ratio = P::Scalar::ratio(knot, low, high);
                combine::<P>(&mut point, inner(*own), |a, b| P::Scalar::blend(a, b, ratio));
            }
            *own = outer(point);
        }
        let place = knots.partition_point(|&other| other <= knot);
        let mut carried = knot;
        for other in self.knots.knots.iter_mut().skip(place) {
            core::mem::swap(other, &mut carried);
        }
        self.knots.length += 1;
        Ok(())
    }
}
