//! What holds for all splines.

use super::curves::{Case, KNOTS, POINTS, Rounded, case, full_size, lane, largest, ratios, runner};
use super::exact::{self, Ratio};
use super::number::{Numeric, error};
use proptest::prelude::*;
use scancsg::scalar::I16F16;
use scancsg::spline::{Curve, CurveError, Knots, Outside, Vertex};
use std::cell::Cell;
use testkit::limits;

pub type Made<S, const K: usize> = Curve<[S; 2], K, POINTS, KNOTS>;

/// Random curves with a parameter in their domain.
pub fn curves<S: Numeric, const K: usize>(
    offset: f64,
    size: f64,
    holds: impl Fn(Made<S, K>, Rounded<S>) -> Result<(), TestCaseError>,
) {
    curves_of(case(K, offset, size), holds);
}

fn curves_of<S: Numeric, const K: usize>(
    cases: impl Strategy<Value = Case>,
    holds: impl Fn(Made<S, K>, Rounded<S>) -> Result<(), TestCaseError>,
) {
    runner()
        .run(&cases, |case| {
            let rounded = case.rounded::<S>(K);
            let made = S::knots::<K, KNOTS>(&rounded.knots)
                .ok()
                .and_then(|knots| S::curve::<K, POINTS, KNOTS>(knots, &rounded.points).ok());
            holds(made.ok_or(TestCaseError::reject("empty"))?, rounded)
        })
        .unwrap();
}

pub fn f64_of<S: Numeric>(x: S) -> f64 {
    x.ratio().to_f64()
}

/// The end of the domain, when there are knots behind it: basis functions are continuous from the
/// right there, and a curve from the left.
fn is_behind<S: Numeric, const K: usize>(curve: &Made<S, K>, t: S) -> bool {
    t == curve.domain().to && curve.knots().as_slice().last() != Some(&t)
}

fn basis<S: Numeric, const K: usize>() {
    curves::<S, K>(0.0, 10.0, |curve, Rounded { t, knots, .. }| {
        let all = curve.knots().non_zero(t).unwrap();
        let sum: f64 = all.values().iter().map(|&x| f64_of(x)).sum();
        let expected = if is_behind(&curve, t) {
            // Functions that begin there exist only in part.
            let (knots, t) = (ratios(&knots), t.ratio());
            let of = |i| exact::basis(&knots, exact::span(&knots, &t), K, i, &t, 0).0.to_f64();
            (0..curve.knots().points()).map(of).sum()
        } else {
            prop_assert_eq!(all.values().len(), K);
            1.0
        };
        prop_assert!((sum - expected).abs() <= K as f64 * 2.0 * S::ulp(1.0), "sum {}", sum);
        prop_assert!(all.values().iter().all(|&x| x >= S::ZERO), "{:?}", all);
        // Local support, and one function at a time is the same as all at once.
        for i in 0..curve.knots().points() {
            let value = curve.knots().basis(i, t);
            let inside = i.checked_sub(all.first).and_then(|i| all.values().get(i));
            prop_assert_eq!(value, inside.copied().unwrap_or(S::ZERO));
            if t < knots[i] || t > knots[i + K] {
                prop_assert_eq!(value, S::ZERO);
            }
        }
        Ok(())
    });
}

#[test]
fn basis_functions_add_up_to_one() {
    basis::<f32, 1>();
    basis::<f32, 3>();
    basis::<f32, 4>();
    basis::<f32, 6>();
    basis::<f64, 4>();
    basis::<I16F16, 2>();
    basis::<I16F16, 4>();
}

/// Values of basis functions, and derivatives in units of the sum of their terms.
fn basis_errors<S: Numeric, const K: usize>(limits: [f64; 2]) {
    let most = std::cell::Cell::new([0f64; 2]);
    curves::<S, K>(0.0, 10.0, |curve, Rounded { t, knots, .. }| {
        let (knots, exact_t) = (ratios(&knots), t.ratio());
        let at = exact::span(&knots, &exact_t);
        for derivative in 0..K.min(3) {
            for i in 0..curve.knots().points() {
                let (value, size) = exact::basis(&knots, at, K, i, &exact_t, derivative);
                let got = curve.knots().basis_derivative(i, derivative, t);
                if size > Ratio::whole(30_000) && S::ulp(1e30) < 1.0 {
                    continue; // out of range in fixed point
                }
                let error = error(got, &value, size.to_f64());
                let kind = usize::from(derivative > 0);
                let mut worst = most.get();
                worst[kind] = worst[kind].max(error);
                most.set(worst);
                prop_assert!(
                    error <= limits[kind],
                    "{derivative}: {error}, {got:?} {}",
                    value.to_f64()
                );
            }
        }
        Ok(())
    });
    println!("{} order {K} basis: {:?}", std::any::type_name::<S>(), most.get());
}

#[test]
fn basis_functions_are_accurate() {
    basis_errors::<f32, 2>(limits::BASIS);
    basis_errors::<f32, 3>(limits::BASIS);
    basis_errors::<f32, 4>(limits::BASIS);
    basis_errors::<f32, 6>(limits::BASIS);
    basis_errors::<f64, 4>(limits::BASIS);
    basis_errors::<I16F16, 3>(limits::BASIS_FIXED);
    basis_errors::<I16F16, 4>(limits::BASIS_FIXED);
}

/// A value lies among the control points that it depends on, but for its rounding.
fn hull<S: Numeric, const K: usize>() {
    curves::<S, K>(3.0, 10.0, |curve, Rounded { t, points, .. }| {
        let got = curve.value(t, Outside::Error).unwrap();
        let first = if is_behind(&curve, t) {
            points.len() - K
        } else {
            curve.knots().non_zero(t).unwrap().first
        };
        let unit = 1.5 * S::ulp(largest(&points));
        for (i, got) in got.into_iter().enumerate() {
            let near = points[first..first + K].iter().map(|point| f64_of(point[i]));
            let (low, high) =
                (near.clone().fold(f64::MAX, f64::min), near.fold(f64::MIN, f64::max));
            prop_assert!(low - unit <= f64_of(got) && f64_of(got) <= high + unit);
        }
        Ok(())
    });
}

#[test]
fn curves_stay_in_the_hull_of_their_control_points() {
    hull::<f32, 3>();
    hull::<f32, 4>();
    hull::<f64, 4>();
    hull::<I16F16, 4>();
}

/// Points mapped by `x·scale + shift` give the mapped curve.
fn affine<S: Numeric>() {
    curves::<S, 4>(0.0, 10.0, |curve, Rounded { t, points, .. }| {
        let [scale, shift] = [2.0, 17.25].map(S::of);
        let mapped: Vec<_> =
            points.iter().map(|point| point.map(|x| x.times(scale).plus(shift))).collect();
        let other = S::curve::<4, POINTS, KNOTS>(*curve.knots(), &mapped).unwrap();
        let expected = curve.value(t, Outside::Error).unwrap().map(|x| x.times(scale).plus(shift));
        let got = other.value(t, Outside::Error).unwrap();
        for (got, expected) in got.into_iter().zip(expected) {
            let units = (f64_of(got) - f64_of(expected)).abs() / S::ulp(37.0);
            prop_assert!(units <= 4.0, "{} units", units);
        }
        Ok(())
    });
}

#[test]
fn curves_follow_affine_maps() {
    affine::<f32>();
    affine::<f64>();
    affine::<I16F16>();
}

fn ends<S: Numeric, const K: usize>() {
    curves::<S, K>(7.0, 1000.0, |curve, Rounded { knots, points, .. }| {
        let domain = curve.domain();
        if knots[0] == knots[K - 1] {
            prop_assert_eq!(curve.value(domain.from, Outside::Error).unwrap(), points[0]);
        }
        let n = points.len();
        if knots[n] == knots[n + K - 1] {
            prop_assert_eq!(curve.value(domain.to, Outside::Error).unwrap(), points[n - 1]);
        }
        Ok(())
    });
}

#[test]
fn clamped_ends_are_exact() {
    ends::<f32, 3>();
    ends::<f32, 4>();
    ends::<f64, 6>();
    ends::<I16F16, 4>();
}

/// The largest control coordinate of each derivative up to an order.
fn slopes(knots: &[Ratio], order: usize, points: &[Ratio], derivatives: usize) -> Vec<f64> {
    let mut points = points.to_vec();
    let mut largest = vec![];
    for level in 1..=derivatives.min(order - 1) {
        let slope = |i: usize| {
            let width = &knots[i + order] - &knots[i + level];
            let rise = &(&points[i + 1] - &points[i]) * &Ratio::whole((order - level) as i64);
            if width.is_zero() { Ratio::zero() } else { &rise / &width }
        };
        points = (0..points.len() - 1).map(slope).collect();
        largest.push(points.iter().fold(0f64, |most, x| most.max(x.abs().to_f64())));
    }
    largest
}

/// Derivatives of both forms against exact ones: in units of the sum of their terms, and baked ones
/// in units of the largest control coordinate of the derivative.
fn derivatives<S: Numeric, const K: usize>(limits: [f64; 2]) {
    let is_fixed = S::ulp(1e30) < 1.0;
    let tested = std::cell::Cell::new([0, 0]);
    curves::<S, K>(0.0, 10.0, |curve, Rounded { t, knots, points }| {
        let widths = knots.windows(2).map(|pair| f64_of(pair[1]) - f64_of(pair[0]));
        let shortest = widths.filter(|&width| width > 0.0).fold(1.0, f64::min);
        let knots = ratios(&knots);
        let at = exact::span_of_domain(&knots, K, &t.ratio());
        let own = &knots[at.unwrap()..at.unwrap() + 2];
        let width = (&own[1] - &own[0]).to_f64();
        for order in 1..=K {
            let lanes = [0, 1].map(|i| lane(&points, i));
            let exact = lanes
                .each_ref()
                .map(|lane| exact::curve(&knots, K, lane, &t.ratio(), order.min(K)));
            let sizes = lanes.each_ref().map(|lane| {
                let terms = (0..points.len()).fold(Ratio::zero(), |sum, j| {
                    let (_, size) = exact::basis(&knots, at, K, j, &t.ratio(), order);
                    &sum + &(&size * &lane[j].abs())
                });
                terms.to_f64()
            });
            let slopes = lanes.each_ref().map(|lane| slopes(&knots, K, lane, order));
            let steepest = slopes.iter().flatten().fold(0f64, |most, x| most.max(*x));
            let of_lanes = slopes.iter().filter_map(|slopes| slopes.last().copied());
            let of_lanes = of_lanes.fold(0.0, f64::max);
            let of_points = [of_lanes; 2];
            let editable = curve.derivative(order, t, Outside::Error);
            let baked = S::at_baked(&curve, 1, order, t, Outside::Error);
            // What coefficients are off, times the derivatives of powers at 1/2.
            let rounding = (order..K).fold(0.0, |sum, i| {
                let factor: f64 = (0..order).map(|j| (i - j) as f64).product();
                sum + factor / 2f64.powi((i - order) as i32)
            });
            // At least four guard bits.
            let of_width = rounding / width.powi(order as i32) / 16.0;
            let of_width = if is_fixed { of_width } else { 0.0 };
            let of_shortest = 2f64.powi(-26) / (shortest * shortest);
            let of_editable = if is_fixed && order > 2 { of_shortest } else { 0.0 };
            for (got, sizes, limit, more) in [
                (Ok(editable), sizes, limits[0], of_editable),
                (baked, of_points, limits[1], of_width),
            ] {
                let Ok(got) = got else { continue }; // no room for guard bits
                let Ok(got) = got else {
                    // Beyond the range, in the end or on the way.
                    prop_assert!(is_fixed && steepest > 32_000.0, "order {order}: {steepest}");
                    tested.set([tested.get()[0], tested.get()[1] + 1]);
                    continue;
                };
                tested.set([tested.get()[0] + 1, tested.get()[1]]);
                for (i, got) in got.into_iter().enumerate() {
                    if order >= K {
                        prop_assert_eq!(got, S::ZERO);
                        continue;
                    }
                    let error = error(got, &exact[i], sizes[i]);
                    let limit = limit + more;
                    prop_assert!(error <= limit, "order {order}: {error} {limit}");
                }
            }
        }
        Ok(())
    });
    println!("{} order {K}: {:?}", std::any::type_name::<S>(), tested.get());
}

#[test]
fn derivatives_are_those_of_the_exact_curve() {
    derivatives::<f32, 3>(limits::DERIVATIVES);
    derivatives::<f32, 4>(limits::DERIVATIVES);
    derivatives::<f64, 5>(limits::DERIVATIVES);
    derivatives::<I16F16, 3>(limits::DERIVATIVES_FIXED);
    derivatives::<I16F16, 4>(limits::DERIVATIVES_FIXED);
}

/// Anywhere, with every policy: no NaN, and no panic.
fn everywhere<S: Numeric, const K: usize>(parameters: &[f64]) {
    curves::<S, K>(0.0, 1000.0, |mut curve, Rounded { t, .. }| {
        for t in parameters.iter().map(|&t| S::of(t)).chain([t]) {
            for outside in [Outside::Error, Outside::Clamp, Outside::Extrapolate, Outside::Wrap] {
                for order in 0..3 {
                    if let Ok(point) = curve.derivative(order, t, outside) {
                        prop_assert!(point.iter().all(|x| x.is_finite()), "{t:?} {outside:?}");
                    }
                }
                if let Ok(Ok(point)) = S::at_baked(&curve, 1, 0, t, outside) {
                    prop_assert!(point.iter().all(|x| x.is_finite()), "{t:?} {outside:?}");
                    if matches!(outside, Outside::Clamp | Outside::Wrap) {
                        let other = curve.value(t, outside).unwrap();
                        for (x, y) in point.into_iter().zip(other) {
                            let units = (f64_of(x) - f64_of(y)).abs() / S::ulp(1000.0);
                            prop_assert!(units <= limits::FORMS, "{units}");
                        }
                    }
                }
            }
            let _ = curve.insert(t);
        }
        Ok(())
    });
}

#[test]
fn no_parameter_is_too_strange() {
    let parameters =
        [0.0, -0.0, 1.0, -1e30, 1e30, f64::MAX, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-40];
    everywhere::<f32, 3>(&parameters);
    everywhere::<f32, 4>(&parameters);
    everywhere::<f64, 4>(&parameters);
    everywhere::<I16F16, 4>(&parameters);
}

/// Every point of the curve is near the polyline.
fn flat<S: Numeric, const K: usize>(tolerance: f64) {
    flat_at::<S, K>(0.0, 10.0, tolerance, 2.0);
}

/// The same, with so many units in the last place of the largest coordinate for rounding.
fn flat_at<S: Numeric, const K: usize>(offset: f64, size: f64, tolerance: f64, units: f64) {
    curves::<S, K>(offset, size, |curve, Rounded { t, .. }| {
        let vertices: Vec<_> = curve.flatten(S::of(tolerance)).unwrap().take(100_000).collect();
        let domain = curve.domain();
        prop_assert_eq!(vertices.first().unwrap().t, domain.from);
        prop_assert_eq!(vertices.last().unwrap().t, domain.to);
        prop_assert!(vertices.windows(2).all(|pair| pair[0].t <= pair[1].t));
        let [x, y] = curve.value(t, Outside::Error).unwrap().map(f64_of);
        let nearest =
            vertices.windows(2).filter(|pair| pair[0].t <= t && t <= pair[1].t).map(|pair| {
                let [[ax, ay], [bx, by]] = [pair[0].point.map(f64_of), pair[1].point.map(f64_of)];
                let (dx, dy) = (bx - ax, by - ay);
                let along = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy).max(1e-300);
                let along = along.clamp(0.0, 1.0);
                (x - ax - along * dx).hypot(y - ay - along * dy)
            });
        let distance = nearest.fold(f64::MAX, f64::min);
        prop_assert!(
            distance <= tolerance * 1.0001 + units * S::ulp(offset + size),
            "{}",
            distance
        );
        let lengths: Vec<_> = curve.lengths(S::of(tolerance)).unwrap().take(100_000).collect();
        prop_assert_eq!(lengths.len(), vertices.len());
        prop_assert!(lengths.windows(2).all(|pair| pair[0].1 <= pair[1].1));
        Ok(())
    });
}

#[test]
fn polylines_keep_to_their_tolerance_in_f32() {
    flat::<f32, 2>(0.01);
    flat::<f32, 3>(0.1);
    flat::<f32, 4>(0.001);
}

#[test]
fn polylines_keep_to_their_tolerance_in_other_numbers() {
    flat::<f64, 4>(0.01);
    flat::<I16F16, 4>(0.01);
}

/// Of less than a unit: 5 of the vertices, and 1 of the curve.
#[test]
fn polylines_keep_to_a_tiny_tolerance() {
    flat_at::<f32, 3>(1e6, 1.0, 0.01, 6.0);
    flat_at::<f32, 4>(1e6, 1.0, 0.01, 6.0);
}

/// The chords of a long polyline add up to the last digit.
#[test]
fn lengths_do_not_drift() {
    let knots = Knots::<f32, 4, 68>::clamped_uniform(64, 0.0, 7.0).unwrap();
    let eight = [0.0, 31.0, -40.0, 57.0, 3.0, -61.0, 14.0, 9.0].map(|x| [x, 33.0 - 0.7 * x * x]);
    let points = [eight; 8].concat();
    let curve = Curve::<[f32; 2], 4, 64, 68>::from_slice(knots, &points).unwrap();
    let vertices: Vec<_> = curve.flatten(1e-4).unwrap().collect();
    assert!(vertices.len() > 5000, "{}", vertices.len());
    let chord = |pair: &[Vertex<[f32; 2]>]| {
        let [[ax, ay], [bx, by]] = [pair[0].point.map(f64::from), pair[1].point.map(f64::from)];
        (bx - ax).hypot(by - ay)
    };
    let exact: f64 = vertices.windows(2).map(chord).sum();
    let (t, length) = curve.lengths(1e-4).unwrap().last().unwrap();
    let units = (f64::from(length) - exact).abs() / f32::ulp(exact);
    assert!(t == 7.0 && units <= limits::LENGTH, "{units} units of {exact}");
}

/// Curves agree with their baked form in so many units of the largest control coordinate: those that
/// the one may be off, and the other.
fn forms<S: Numeric, const K: usize>(size: f64, limit: f64) {
    let most = Cell::new(0f64);
    let agree = |curve: Made<S, K>, Rounded { knots, points, t }: Rounded<S>| {
        let ends = [knots[K - 1], knots[points.len()]];
        for t in knots.into_iter().filter(|t| (ends[0]..=ends[1]).contains(t)).chain([t]) {
            let Ok(baked) = S::at_baked(&curve, 1, 0, t, Outside::Error) else {
                return Err(TestCaseError::reject("too far"));
            };
            let editable = curve.value(t, Outside::Error).unwrap();
            for (a, b) in baked.unwrap().into_iter().zip(editable) {
                let units = (f64_of(a) - f64_of(b)).abs() / S::ulp(largest(&points));
                most.set(most.get().max(units));
                prop_assert!(units <= limit, "{units} units at {t:?}");
            }
        }
        Ok(())
    };
    curves::<S, K>(0.0, size, agree);
    curves_of::<S, K>(full_size(K, size), agree);
    println!("{} {K}: {:.2} units", std::any::type_name::<S>(), most.get());
}

#[test]
fn baked_curves_are_the_editable_ones() {
    forms::<f32, 1>(1e6, 0.0);
    forms::<f32, 2>(1e6, limits::BAKED_SEARCH[2] + limits::EDITABLE[2]);
    forms::<f32, 3>(1e6, limits::BAKED_SEARCH[3] + limits::EDITABLE[3]);
    forms::<f32, 4>(1e6, limits::BAKED_SEARCH[4] + limits::EDITABLE[4]);
    forms::<f32, 5>(1e6, limits::BAKED_SEARCH[5] + limits::EDITABLE[5]);
    forms::<f32, 6>(1e6, limits::BAKED_SEARCH[6] + limits::EDITABLE[6]);
    forms::<f64, 3>(1e6, limits::FORMS);
    forms::<f64, 4>(1e6, limits::FORMS_F64);
    // Whole units of the type's last place.
    forms::<I16F16, 1>(75.0, 0.0);
    forms::<I16F16, 2>(75.0, limits::FORMS_FIXED);
    forms::<I16F16, 3>(75.0, limits::FORMS_FIXED);
    forms::<I16F16, 4>(75.0, limits::FORMS_FIXED);
}

/// Control points that near never are too far apart.
#[test]
fn cubics_that_can_always_be_baked() {
    curves_of::<I16F16, 4>(full_size(4, 25.0), |curve, Rounded { t, .. }| {
        prop_assert!(I16F16::at_baked(&curve, 1, 0, t, Outside::Error).is_ok());
        Ok(())
    });
    // The farthest of all, over one span of a power of two; and in halves.
    let cubic = |size: i16| {
        let knots = [0i16, 0, 0, 0, 4, 4, 4, 4].map(I16F16::from);
        let points = [size, -size, size, -size].map(|x| [I16F16::from(x); 2]);
        let curve = I16F16::curve::<4, 4, 8>(I16F16::knots::<4, 8>(&knots).unwrap(), &points);
        let curve = curve.unwrap();
        [curve.bake::<1>().err(), curve.bake::<2>().err()]
    };
    assert_eq!(cubic(25), [None; 2]);
    assert_eq!(cubic(200), [Some(CurveError::TooFar), None]);
}

/// Of knots 2⁻¹²⁰ and 2⁻¹⁰⁰ times as far apart, down to the smallest numbers that there are.
#[test]
fn tiny_knots_are_like_any_others() {
    fn tiny<const K: usize>() {
        curves::<f32, K>(0.0, 1e6, |curve, Rounded { knots, points, t }| {
            for scale in [-120.0, -100.0, -80.0].map(f32::exp2) {
                let knots: Vec<f32> = knots.iter().map(|x| x * scale).collect();
                let small = Knots::<f32, K, KNOTS>::new(&knots).unwrap();
                let small = Made::<f32, K>::from_slice(small, &points).unwrap();
                // What of t is too small to be a number is not asked for.
                if t * scale / scale == t {
                    let [small, large] = [(small, t * scale), (curve, t)]
                        .map(|(curve, t)| curve.value(t, Outside::Error).unwrap());
                    prop_assert_eq!(small, large, "{}", t * scale);
                }
            }
            Ok(())
        });
    }
    tiny::<2>();
    tiny::<3>();
    tiny::<4>();
    tiny::<5>();
    tiny::<6>();
}

/// Periodic knots repeat, so the derivatives of a closed curve agree at its ends.
#[test]
fn closed_curves_close() {
    let knots = Knots::<f32, 4, 12>::periodic(&[0.0, 1.0, 3.0, 3.5, 5.0, 6.0]).unwrap();
    let expected = [-3.0, -2.5, -1.0, 0.0, 1.0, 3.0, 3.5, 5.0, 6.0, 7.0, 9.0, 9.5];
    assert_eq!(knots.as_slice(), expected);
    let points = [[0.0, 0.0], [2.0, 0.0], [3.0, 2.0], [1.0, 3.0], [-1.0, 1.0]];
    let curve = Curve::<[f32; 2], 4, 8, 12>::closed(knots, &points).unwrap();
    for order in 0..3 {
        let [a, b] = [0.0, 6.0].map(|t| curve.derivative(order, t, Outside::Error).unwrap());
        assert!((a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5, "{a:?} {b:?}");
    }
    let wrapped = curve.value(13.25, Outside::Wrap).unwrap();
    assert_eq!(wrapped, curve.value(1.25, Outside::Error).unwrap());
    assert_eq!(curve.value(-4.75, Outside::Wrap).unwrap(), wrapped);
}
