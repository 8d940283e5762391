//! Curves that change: control points that move, knots that are inserted.

use super::curves::{KNOTS, POINTS, Rounded, lane, largest, ratios};
use super::exact;
use super::number::{Numeric, error};
use super::properties::{curves, f64_of};
use proptest::prelude::*;
use scancsg::scalar::I16F16;
use scancsg::spline::Outside;
use testkit::limits;

/// A control point that moves changes the curve where its basis function is, and nothing else by a
/// bit; and the curve is then the one that is made of these control points.
fn moving<S: Numeric, const K: usize>() {
    curves::<S, K>(0.0, 10.0, |before, Rounded { knots, points, t }| {
        for index in 0..points.len() {
            let mut moved = points.clone();
            moved[index] = [S::of(1000.0), S::of(-7.5)];
            let mut curve = before;
            prop_assert_eq!(curve.set_point(index, moved[index]), Ok(()));
            let value = curve.value(t, Outside::Error);
            let again = S::curve::<K, POINTS, KNOTS>(*before.knots(), &moved).unwrap();
            prop_assert_eq!(value, again.value(t, Outside::Error));
            if t < knots[index] || knots[index + K] < t {
                prop_assert_eq!(value, before.value(t, Outside::Error));
            }
        }
        Ok(())
    });
}

#[test]
fn control_points_move_what_is_near_them() {
    moving::<f32, 2>();
    moving::<f32, 4>();
    moving::<f64, 3>();
    moving::<I16F16, 4>();
}

/// Inserted knots don't change a curve by more than rounding.
fn insertion<S: Numeric, const K: usize>(units: f64) {
    curves::<S, K>(0.0, 10.0, |mut curve, Rounded { t, knots, points }| {
        if points.len() == POINTS {
            return Ok(());
        }
        let exact = exact::curve(&ratios(&knots), K, &lane(&points, 0), &t.ratio(), 0);
        let domain = curve.domain();
        let knot = S::of(0.3 * f64_of(domain.from) + 0.7 * f64_of(domain.to));
        let knots: Vec<S> = knots;
        let before = curve;
        if curve.insert(knot).is_err() {
            prop_assert_eq!(before.points(), curve.points());
            return Ok(());
        }
        prop_assert_eq!(curve.points().len(), points.len() + 1);
        let mut expected = knots;
        expected.push(knot);
        expected.sort_by(|a, b| a.partial_cmp(b).unwrap());
        prop_assert_eq!(curve.knots().as_slice(), &expected[..]);
        let [got, _] = curve.value(t, Outside::Error).unwrap();
        let error = error(got, &exact, largest(&points));
        prop_assert!(error <= units, "{} units", error);
        Ok(())
    });
}

#[test]
fn insertion_keeps_the_curve() {
    insertion::<f32, 2>(limits::INSERTION);
    insertion::<f32, 4>(limits::INSERTION);
    insertion::<f64, 4>(limits::INSERTION);
    insertion::<I16F16, 4>(limits::INSERTION_FIXED);
}
