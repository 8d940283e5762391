//! Sweeps against exact fractions: every point is the exact one, rounded.

use super::exact::{self, Ratio};
use proptest::prelude::*;
use scancsg::geom::Vec3;
use scancsg::scalar::I16F16;
use scancsg::spline::{Curve, Knots, Sweep, SweepError};

/// ⌊x + 1/2⌋ of a value in units.
fn rounded(x: &Ratio) -> i64 {
    let floor = (x.to_f64() + 0.5).floor() as i64;
    let half = Ratio::new(1, 2);
    let near = [floor - 1, floor, floor + 1];
    *near
        .iter()
        .find(|&&y| {
            let rest = &(x + &half) - &Ratio::whole(y);
            rest >= Ratio::zero() && rest < Ratio::whole(1)
        })
        .unwrap()
}

fn check<const K: usize>(bits: &[i32], ticks: u32) -> Result<(), TestCaseError> {
    let points: Vec<I16F16> = bits.iter().map(|&bits| I16F16::from_bits(bits)).collect();
    let exact_points: Vec<Ratio> = bits.iter().map(|&bits| Ratio::whole(bits.into())).collect();
    let knots: Vec<Ratio> = (0..bits.len() + K).map(|i| Ratio::whole(i as i64)).collect();
    let sweep: Vec<I16F16> = Sweep::<_, K>::new(&points, ticks).unwrap().collect();
    prop_assert_eq!(sweep.len(), (bits.len() + 1 - K) * ticks as usize + 1);
    for (i, got) in sweep.iter().enumerate() {
        let t = &Ratio::new(i as i64, i64::from(ticks)) + &Ratio::whole(K as i64 - 1);
        let exact = exact::curve(&knots, K, &exact_points, &t, 0);
        if K > 1 || i + 1 < sweep.len() {
            prop_assert_eq!(i64::from(got.to_bits()), rounded(&exact), "tick {}", i);
        }
    }
    Ok(())
}

/// Along a curve whose knots are so many ticks apart; `None` if these are no knots.
fn check_along<const K: usize>(
    gaps: &[u32],
    bits: &[i32],
    start: i32,
    step: i32,
) -> Result<Option<()>, TestCaseError> {
    let ticks: Vec<i64> = gaps
        .iter()
        .scan(0, |tick, gap| {
            *tick += i64::from(*gap);
            Some(*tick)
        })
        .collect();
    let knots: Vec<I16F16> =
        ticks.iter().map(|&tick| I16F16::from_bits(start + tick as i32 * step)).collect();
    let points: Vec<I16F16> =
        (0..ticks.len() - K).map(|i| I16F16::from_bits(bits[i % bits.len()])).collect();
    let Ok(made) = Knots::<I16F16, K, 14>::new(&knots) else { return Ok(None) };
    let Ok(curve) = Curve::<I16F16, K, 14, 14>::from_slice(made, &points) else { return Ok(None) };
    let sweep: Vec<I16F16> = Sweep::along(&curve, I16F16::from_bits(step)).unwrap().collect();

    let [from, to] = [ticks[K - 1], ticks[points.len()]];
    prop_assert_eq!(sweep.len() as i64, to - from + 1);
    let exact_knots: Vec<Ratio> = ticks.iter().map(|&tick| Ratio::whole(tick)).collect();
    let exact_points: Vec<Ratio> =
        points.iter().map(|point| Ratio::whole(point.to_bits().into())).collect();
    for (got, tick) in sweep.iter().zip(from..) {
        let exact = exact::curve(&exact_knots, K, &exact_points, &Ratio::whole(tick), 0);
        prop_assert_eq!(i64::from(got.to_bits()), rounded(&exact), "tick {}", tick);
    }
    Ok(Some(()))
}

proptest! {
    #![proptest_config(super::curves::config())]

    #[test]
    fn every_tick_is_exact(
        bits in prop::collection::vec(prop_oneof![any::<i32>(), -70_000..70_000], 6..9),
        ticks in 5..20u32,
    ) {
        check::<1>(&bits, ticks)?;
        check::<2>(&bits, ticks)?;
        check::<3>(&bits, ticks)?;
        check::<4>(&bits, ticks)?;
        check::<5>(&bits, ticks)?;
        check::<6>(&bits, ticks)?;
    }

    #[test]
    fn every_tick_along_a_curve_is_exact(
        bits in prop::collection::vec(prop_oneof![any::<i32>(), -70_000..70_000], 8),
        gaps in prop::collection::vec(prop_oneof![Just(0u32), Just(6), 5..9u32], 12),
        ends in any::<[bool; 2]>(),
        start in -1_000_000..1_000_000,
        step in 1..10_000,
    ) {
        /// The curve may be clamped at each end.
        fn clamped<const K: usize>(gaps: &[u32], ends: [bool; 2]) -> Vec<u32> {
            let mut gaps = gaps.to_vec();
            let last = gaps.len();
            if ends[0] {
                gaps[1..K].fill(0);
            }
            if ends[1] {
                gaps[last + 1 - K..].fill(0);
            }
            gaps
        }
        check_along::<1>(&clamped::<1>(&gaps, ends), &bits, start, step)?;
        check_along::<2>(&clamped::<2>(&gaps, ends), &bits, start, step)?;
        check_along::<3>(&clamped::<3>(&gaps, ends), &bits, start, step)?;
        check_along::<4>(&clamped::<4>(&gaps, ends), &bits, start, step)?;
        // Over uneven knots, the divisor is too large for these orders.
        let gaps: Vec<u32> = gaps.iter().map(|&gap| if gap > 0 { 6 } else { 0 }).collect();
        check_along::<5>(&clamped::<5>(&gaps, ends), &bits, start, step)?;
        check_along::<6>(&clamped::<6>(&gaps, ends), &bits, start, step)?;
    }
}

/// A curve of three spans, with its ends at its control points.
fn clamped_cubic(span: i32) -> Curve<I16F16, 4, 6, 10> {
    let end = I16F16::from_bits(3 * span);
    let knots = Knots::<I16F16, 4, 10>::clamped_uniform(6, I16F16::ZERO, end);
    let points = [3, -1, 4, 1, -5, 9].map(I16F16::from_num);
    Curve::<I16F16, 4, 6, 10>::new(knots.unwrap(), points).unwrap()
}

#[test]
fn clamped_curves_with_many_ticks() {
    let gaps = [0, 0, 0, 0, 563, 563, 563, 0, 0, 0];
    assert_eq!(check_along::<4>(&gaps, &[i32::MAX, i32::MIN], -7, 100).unwrap(), Some(()));
    let (step, curve) = (I16F16::from_bits(100), clamped_cubic(56_300));
    let path: Vec<_> = Sweep::along(&curve, step).unwrap().collect();
    assert_eq!([path[0], path[3 * 563]], [3, 9].map(I16F16::from_num));
    assert_eq!(Sweep::along(&clamped_cubic(56_400), step).err(), Some(SweepError::Ticks));
}

#[test]
fn steps_that_do_not_fit() {
    let curve = clamped_cubic(65_536);
    let error = |bits| Sweep::along(&curve, I16F16::from_bits(bits)).err();
    assert_eq!(error(0), Some(SweepError::Step));
    assert_eq!(error(-512), Some(SweepError::Step));
    assert_eq!(error(511), Some(SweepError::Step));
    // One tick, two, and 1024 to a span.
    assert_eq!(error(65_536), Some(SweepError::Ticks));
    assert_eq!(error(32_768), Some(SweepError::Ticks));
    assert_eq!(error(64), Some(SweepError::Ticks));
    assert_eq!(error(16_384), None);
}

#[test]
fn as_many_ticks_as_there_may_be() {
    let points = [I16F16::MAX, I16F16::MIN, I16F16::MAX, I16F16::MIN, I16F16::MAX];
    assert_eq!(Sweep::<_, 4>::new(&points, 711).unwrap_err(), SweepError::Ticks);
    assert_eq!(Sweep::<_, 4>::new(&points, 2).unwrap_err(), SweepError::Ticks);
    assert_eq!(Sweep::<_, 4>::new(&points, u32::MAX).unwrap_err(), SweepError::Ticks);
    assert_eq!(Sweep::<_, 3>::new(&points, 0).unwrap_err(), SweepError::Ticks);
    assert_eq!(Sweep::<_, 4>::new(&points[2..], 7).unwrap_err(), SweepError::TooFew);
    let bits = points.map(I16F16::to_bits);
    check::<4>(&bits, 710).unwrap();
}

#[test]
fn closed_sweeps_go_round() {
    let point = |x: i32, y: i32| Vec3::from([x, y, x - y].map(I16F16::from_num));
    let points = [point(0, 0), point(2, 0), point(3, 2), point(1, 3), point(-1, 1)];
    let round: Vec<_> = Sweep::<_, 4>::closed(&points, 8).unwrap().take(120).collect();
    assert_eq!(round[..40], round[40..80]);
    assert_eq!(round[..40], round[80..]);
    // The same as the open sweep as far as that goes.
    let open: Vec<_> = Sweep::<_, 4>::new(&points, 8).unwrap().collect();
    assert_eq!(open[..], round[..17]);
}
