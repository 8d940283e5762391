//! What the lidar measures, against lines and cylinders of the test's own, in `f64`.

#[path = "../../lidar/world.rs"]
mod world;

use scancsg::geom::Axis;
use scancsg::scalar::{I16F16, Number, Scalar};
use world::{BEAMS, FRAMES, Thing};

/// Where a beam from the origin enters a cylinder, and its normal there: by the textbook's formulas.
fn entry<S: Scalar>(thing: &Thing, beam: [f64; 3]) -> Option<(f64, [f64; 3])> {
    // The numbers that the library gets, which have few digits.
    let n = |hundredths| S::from_ratio(hundredths, 100).to_f64();
    let (place, u, v) = match thing.axis {
        Axis::X => (0, 1, 2),
        Axis::Y => (1, 0, 2),
        Axis::Z => (2, 0, 1),
    };
    let (at, radius, ends) = (thing.at.map(n), n(thing.radius), thing.ends.map(n));
    let (a, b) = (beam[u] * beam[u] + beam[v] * beam[v], -(beam[u] * at[0] + beam[v] * at[1]));
    let c = at[0] * at[0] + at[1] * at[1] - radius * radius;
    let (mut first, mut last) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut is_cap = false;
    if a > 0.0 {
        let root = (b * b - a * c).sqrt(); // NaN for a miss
        (first, last) = ((-b - root) / a, (-b + root) / a);
    } else if c >= 0.0 {
        return None;
    }
    let [mut near, mut far] = ends.map(|end| end / beam[place]);
    if beam[place] < 0.0 {
        (near, far) = (far, near);
    }
    if near > first {
        (first, is_cap) = (near, true);
    }
    let is_hit = first < last.min(far) && first >= 0.0;
    let mut normal = [0.0; 3];
    if is_cap {
        normal[place] = -beam[place].signum();
    } else {
        normal[u] = (first * beam[u] - at[0]) / radius;
        normal[v] = (first * beam[v] - at[1]) / radius;
    }
    is_hit.then_some((first, normal))
}

/// Compares all beams of all frames; the numbers' step at the distances that there are is `unit`, and so many
/// of them are allowed.
fn check<S: Scalar>(unit: f64, allowed: f64) {
    let (mut echoes, mut misses) = (0, 0);
    for frame in 0..FRAMES {
        let (things, moved) = (world::things::<S>(frame).unwrap(), world::moved(frame));
        for index in 0..BEAMS {
            let ray = world::beam::<S>(index);
            let beam = ray.to_array().map(Number::to_f64);
            let entries = moved.iter().filter_map(|thing| entry::<S>(thing, beam));
            let want = entries.min_by(|one, other| one.0.total_cmp(&other.0));
            let got = world::measured(&things, ray).unwrap();
            assert_eq!(got.is_some(), want.is_some(), "frame {frame}, beam {index}");
            let (Some(echo), Some((distance, normal))) = (got, want) else {
                misses += 1;
                continue;
            };
            let off = (echo.distance.to_f64() - distance).abs();
            assert!(off <= allowed * unit + 1e-12, "frame {frame}, beam {index}: off by {off}");
            let strength: f64 = -(0..3).map(|i| normal[i] * beam[i]).sum::<f64>();
            let off = (echo.strength.to_f64() - strength).abs();
            assert!(off <= 16.0 * unit, "frame {frame}, beam {index}: strength off by {off}");
            echoes += 1;
        }
    }
    // Neither is rare, so that both are tested.
    assert!(echoes > 100 && misses > 100, "{echoes} echoes, {misses} misses");
}

#[test]
fn fixed_point_is_right_to_half_a_unit() {
    check::<I16F16>(2f64.powi(-16), 0.5);
}

#[test]
fn single_precision_is_right_to_two_units() {
    // Distances are below 8.
    check::<f32>(2f64.powi(-21), 2.0);
}
