//! Constructors that people can read make what the others make.
#![allow(clippy::unwrap_used)]

use scancsg::constant;
use scancsg::geom::{Axis, Pose, PoseError, Vec3, vec3};
use scancsg::scalar::{I16F16, Number};
use scancsg::solid::{Cone, Cuboid, Cylinder, CylinderError};

const RING: [Cylinder<I16F16>; 2] = constant![
    Cylinder::<I16F16>::spanning(Axis::Y, n(-10)..n(10), [n(3), n(4)], n(2)),
    Cylinder::<I16F16>::spanning(Axis::Z, n(-10)..n(10), [n(3), n(4)], n(2)),
];

const fn n(quarters: i32) -> I16F16 {
    I16F16::from_bits(quarters << 14)
}

macro_rules! spanning {
    ($name:ident, $S:ty) => {
        #[test]
        fn $name() {
            let n = |number: f64| <$S>::from_f64(number);
            let (at, radius, low, high) = ([n(0.3), n(-2.7)], n(0.6), n(-1.2), n(3.4));
            let along = [
                Cylinder::<$S>::along_x(at[0], at[1], radius, low, high),
                Cylinder::<$S>::along_y(at[0], at[1], radius, low, high),
                Cylinder::<$S>::along_z(at[0], at[1], radius, low, high),
            ];
            let spanning =
                Axis::ALL.map(|axis| Cylinder::<$S>::spanning(axis, low..high, at, radius));
            assert_eq!(spanning, along);
            assert!(along.iter().all(Result::is_ok));

            let radii = [n(0.1), n(0.7)];
            let along = [
                Cone::<$S>::along_x(at[0], at[1], radii, low, high),
                Cone::<$S>::along_y(at[0], at[1], radii, low, high),
                Cone::<$S>::along_z(at[0], at[1], radii, low, high),
            ];
            let spanning = Axis::ALL.map(|axis| Cone::<$S>::spanning(axis, low..high, at, radii));
            assert_eq!(spanning, along);
            assert!(along.iter().all(Result::is_ok));

            let wide = Cuboid::<$S>::spanning(low..high, n(0.0)..n(0.5), n(-3.0)..n(-2.0));
            let corners = [vec3(low, n(0.0), n(-3.0)), vec3(high, n(0.5), n(-2.0))];
            assert_eq!(wide, Cuboid::<$S>::new(corners[0], corners[1]));
            assert_eq!(wide.unwrap().corners(), corners);

            let backwards = Cylinder::<$S>::spanning(Axis::Y, high..low, at, radius);
            assert_eq!(backwards, Err(CylinderError::Empty));
        }

        /// Axes go to axes exactly, and where the turn by an angle takes them.
        mod $name {
            use super::*;

            #[test]
            fn turns() {
                let n = |number: i32| <$S>::from_int(number);
                let units =
                    [vec3(n(1), n(0), n(0)), vec3(n(0), n(1), n(0)), vec3(n(0), n(0), n(1))];
                for (axis, count) in Axis::ALL.into_iter().flat_map(|axis| {
                    [-5, -1, 0, 1, 2, 3, 4, 1_000_003, i32::MIN].map(|count| (axis, count))
                }) {
                    let turn = Pose::<$S>::quarter_turns(axis, count);
                    let angle = <$S>::from_f64(
                        core::f64::consts::FRAC_PI_2 * f64::from(count.rem_euclid(4)),
                    );
                    let by_angle = match axis {
                        Axis::X => Pose::<$S>::rotation_x(angle),
                        Axis::Y => Pose::<$S>::rotation_y(angle),
                        Axis::Z => Pose::<$S>::rotation_z(angle),
                    };
                    for unit in units {
                        let there = turn.point(unit);
                        assert!(units.iter().any(|&unit| unit == there || unit == -there));
                        let off = (by_angle.unwrap().point(unit) - there).max_abs();
                        assert!(off.to_f64() < 1e-4, "{axis:?} {count}: {off}");
                        assert_eq!(turn.point_back(there), unit);
                    }
                    assert_eq!(
                        turn.then(&turn),
                        Ok(Pose::<$S>::quarter_turns(axis, count.wrapping_mul(2)))
                    );
                }
                assert_eq!(Pose::<$S>::quarter_turns(Axis::Y, 0), Pose::IDENTITY);
                assert_eq!(Pose::<$S>::half_turn(Axis::X), Pose::<$S>::quarter_turns(Axis::X, -2));
            }

            #[test]
            fn shifts() {
                let (one, by) = (<$S>::from_int(1), vec3(1, -2, 3).map_to::<$S>());
                let turn = Pose::<$S>::quarter_turns(Axis::Z, 1);
                let shifted = turn.shifted(by);
                assert_eq!(shifted, turn.then(&Pose::translation(by).unwrap()));
                assert_eq!(
                    shifted.unwrap().shifted(by),
                    shifted.unwrap().then(&Pose::translation(by).unwrap())
                );
                let far = vec3(one, <$S>::MAX, one);
                assert_eq!(turn.shifted(far), Err(PoseError::TooFar));
            }
        }
    };
}

trait MapTo {
    fn map_to<S: Number>(self) -> Vec3<S>;
}

impl MapTo for Vec3<i32> {
    fn map_to<S: Number>(self) -> Vec3<S> {
        vec3(S::from_int(self.x), S::from_int(self.y), S::from_int(self.z))
    }
}

spanning!(single, f32);
spanning!(double, f64);
spanning!(fixed_point, I16F16);

#[test]
fn constants_in_a_row_are_an_array() {
    let [y, z] = RING;
    assert_eq!(Ok(y), Cylinder::<I16F16>::along_y(n(3), n(4), n(2), n(-10), n(10)));
    assert_eq!(Ok(z), Cylinder::<I16F16>::along_z(n(3), n(4), n(2), n(-10), n(10)));
    let not_finite = Pose::<f32>::half_turn(Axis::X).shifted(vec3(f32::NAN, 0.0, 0.0));
    assert_eq!(not_finite, Err(PoseError::NotFinite));
}
