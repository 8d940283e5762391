//! Editable curves in fixed point where numbers are as hard as they get, against exact fractions.

use super::curves::{KNOTS, POINTS, lane, ratios, runner};
use super::exact;
use super::number::{Numeric, error};
use proptest::prelude::*;
use scancsg::scalar::I16F16;
use scancsg::spline::Outside;
use std::cell::Cell;
use testkit::limits;

/// Steps between knots, in units: none, the smallest ones, ordinary ones, and such as take
/// the sequence through the whole range of the type.
fn step() -> impl Strategy<Value = u32> {
    prop_oneof![
        3 => Just(0),
        2 => 1..4u32,
        2 => 1..1u32 << 20,
        1 => (16..29u32).prop_map(|shift| 1 << shift),
        1 => 1u32 << 28..1 << 31,
    ]
}

/// Coordinates at an end of the range, next to one, and anywhere.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        2 => Just(i32::MIN),
        2 => Just(i32::MAX),
        1 => i32::MAX - 3..=i32::MAX,
        1 => any::<i32>(),
    ]
}

/// The largest error of points at all knots, next to them, and between.
fn worst<const K: usize>() {
    let (most, widest) = (Cell::new(0f64), Cell::new(0u32));
    let cases = (
        prop::collection::vec([coordinate(), coordinate()], K..=POINTS),
        prop::collection::vec(step(), KNOTS),
        prop::collection::vec(any::<u32>(), 4),
        any::<bool>(),
    );
    let check = |(points, steps, parts, from_low): (Vec<[i32; 2]>, Vec<u32>, Vec<u32>, bool)| {
        let steps = &steps[..points.len() + K - 1];
        let length: i64 = steps.iter().map(|&step| i64::from(step)).sum();
        if length >= 1 << 32 {
            return Err(TestCaseError::reject("too long"));
        }
        let mut at = i64::from(i32::MIN);
        at += if from_low { 0 } else { i64::from(u32::MAX) - length };
        let mut knots = vec![I16F16::from_bits(at as i32)];
        for step in steps {
            at += i64::from(*step);
            knots.push(I16F16::from_bits(at as i32));
        }
        let points: Vec<_> = points.iter().map(|point| point.map(I16F16::from_bits)).collect();
        let curve = I16F16::knots::<K, KNOTS>(&knots)
            .ok()
            .and_then(|knots| I16F16::curve::<K, POINTS, KNOTS>(knots, &points).ok())
            .ok_or(TestCaseError::reject("no curve"))?;
        let domain = curve.domain();
        let [from, to] = [domain.from, domain.to].map(I16F16::to_bits);
        widest.set(widest.get().max(to.abs_diff(from)));
        let exact_knots = ratios(&knots);
        let lanes = [lane(&points, 0), lane(&points, 1)];
        let between = parts.iter().map(|&part| {
            let offset = (u64::from(part) * u64::from(to.abs_diff(from))) >> 32;
            (i64::from(from) + offset as i64) as i32
        });
        let near = knots.iter().flat_map(|knot| (-1..=1).map(|i| knot.to_bits().saturating_add(i)));
        for t in near.chain(between).filter(|t| (from..=to).contains(t)) {
            let t = I16F16::from_bits(t);
            let got = curve.value(t, Outside::Error).unwrap();
            for (got, lane) in got.into_iter().zip(&lanes) {
                let exact = exact::curve(&exact_knots, K, lane, &t.ratio(), 0);
                let error = error(got, &exact, 1.0);
                most.set(most.get().max(error));
                prop_assert!(error <= limits::EDITABLE_FIXED, "{error} LSB at {t}");
            }
        }
        Ok(())
    };
    runner().run(&cases, check).unwrap();
    println!("order {K}: {:.4} LSB, domains up to {:#x} units", most.get(), widest.get());
    assert!(widest.get() > 1 << 31, "no wide domain was tried");
}

#[test]
fn editable_curves_at_the_ends_of_the_range() {
    worst::<2>();
    worst::<3>();
    worst::<4>();
    worst::<6>();
}

/// Knots half of the range apart and more: their widths don't fit a signed word.
#[test]
fn one_span_over_the_whole_range() {
    let [low, high] = [I16F16::MIN, I16F16::MAX];
    let knots = [low, low, low, low, high, high, high, high];
    let points = [low, high, low, high].map(|x| [x, I16F16::ONE]);
    let curve =
        I16F16::curve::<4, POINTS, KNOTS>(I16F16::knots::<4, KNOTS>(&knots).unwrap(), &points);
    let curve = curve.unwrap();
    for t in [i32::MIN, i32::MIN + 1, -12_345_678, -1, 0, 1, 1 << 30, i32::MAX - 1, i32::MAX] {
        let t = I16F16::from_bits(t);
        let [x, one] = curve.value(t, Outside::Error).unwrap();
        let exact = exact::curve(&ratios(&knots), 4, &lane(&points, 0), &t.ratio(), 0);
        assert!(error(x, &exact, 1.0) <= limits::EDITABLE_FIXED, "{x} at {t}");
        assert_eq!(one, I16F16::ONE);
    }
}
