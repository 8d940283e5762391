//! Sweeps against exact fractions: every point is the exact one, rounded.

use super::exact::{self, Ratio};
use proptest::prelude::*;
use scancsg::geom::Vec3;
use scancsg::scalar::I16F16;
use scancsg::spline::{Sweep, SweepError};

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
