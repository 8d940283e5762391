//! Insertion of knots.

use super::Curve;
use crate::spline::domain::Outside;
use crate::spline::error::{EvaluateError, InsertError};
use crate::spline::knots::Knots;
use crate::spline::point::{Point, combine, inner, outer};
use crate::spline::scalar::SplineScalar;

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
    /// An [`InsertError`]; the curve is as before then.
    pub fn insert(&mut self, knot: P::Scalar) -> Result<(), InsertError> {
        match self.domain().place(knot, Outside::Error) {
            Ok(_) => {}
            Err(EvaluateError::NotFinite) => return Err(InsertError::NotFinite),
            Err(_) => return Err(InsertError::Outside),
        }
        let (knots, points) = (self.knots.as_slice(), self.points());
        let count = points.len();
        if knots.len() >= N || count >= C {
            return Err(InsertError::Full);
        }
        if knots.iter().filter(|&&other| other == knot).count() >= K {
            return Err(InsertError::Multiplicity);
        }
        let place = knots.partition_point(|&other| other <= knot);

        let mut new_points = self.points;
        for (i, new) in new_points.iter_mut().enumerate().take(count + 1) {
            let before = i.checked_sub(1).and_then(|i| points.get(i));
            // t_i and t_{i+k−1}: left of them the old points, right of them those before.
            let low = knots.get(i).copied();
            let high = (i + K).checked_sub(1).and_then(|i| knots.get(i)).copied();
            *new = match (before, points.get(i)) {
                (None, Some(own)) => *own,
                (Some(before), None) => *before,
                (Some(before), Some(own)) => match (low, high) {
                    (Some(low), _) if knot <= low => *before,
                    (_, Some(high)) if high <= knot => *own,
                    (Some(low), Some(high)) => {
                        let ratio = P::Scalar::ratio(knot, low, high);
                        let mut point = inner(*before);
                        combine::<P>(&mut point, inner(*own), |a, b| P::Scalar::blend(a, b, ratio));
                        outer(point)
                    }
                    _ => *own,
                },
                (None, None) => P::ORIGIN,
            };
        }
        let mut new_knots = self.knots.knots;
        for (i, new) in new_knots.iter_mut().enumerate().skip(place) {
            // What is behind the last knot repeats it, and goes on doing so.
            let before = i.checked_sub(1).filter(|_| i > place);
            *new = before.and_then(|i| self.knots.knots.get(i)).copied().unwrap_or(knot);
        }
        let length = self.knots.length + 1;
        self.knots = Knots { knots: new_knots, length };
        self.points = new_points;
        Ok(())
    }
}
