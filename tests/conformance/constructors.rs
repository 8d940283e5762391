//! Constructors that a type parameter can call, against those for constants: the same solids, and the same
//! errors.

use proptest::prelude::*;
use scancsg::geom::{Axis, Vec3};
use scancsg::solid::{Cone, Cylinder, Slab, Sphere, Torus};
use testkit::number::Tested;

for_every_number!(constructors_of_any_number_are_those_of_constants,);

/// Ordinary numbers, and all that a constructor may refuse.
fn number<S: Tested>() -> impl Strategy<Value = S> {
    let odd = [S::ZERO, S::MIN_RADIUS, S::MAX_COORDINATE, S::LOWEST, S::HIGHEST, S::ONE];
    let odd = [&odd, S::NO_NUMBERS].concat();
    prop_oneof![3 => (-8f64..8.0).prop_map(S::near), 1 => prop::sample::select(odd)]
}

fn constructors_of_any_number_are_those_of_constants<S: Tested>() {
    let axis = prop::sample::select(vec![Axis::X, Axis::Y, Axis::Z]);
    let numbers = prop::array::uniform6(number::<S>());
    proptest!(ProptestConfig::with_cases(500), |(axis in axis, [a, b, c, d, e, f] in numbers)| {
        let (p, q) = (Vec3::new(a, b, c), Vec3::new(d, e, f));
        let cylinder = Cylinder::<S>::along(axis, [a, b], c, d, e);
        prop_assert_eq!(cylinder, S::along(axis as usize, [a, b], c, d, e));
        prop_assert_eq!(Cylinder::<S>::from_to(p, q, a), S::between(p, q, a));
        let cone = Cone::<S>::along(axis, [a, b], [c, f], d, e);
        prop_assert_eq!(cone, S::cone_along(axis as usize, [a, b], [c, f], d, e));
        prop_assert_eq!(Cone::<S>::from_to(p, q, [a, b]), S::cone_between(p, q, [a, b]));
        prop_assert_eq!(Sphere::<S>::around(p, d), S::sphere(p, d));
        prop_assert_eq!(Slab::<S>::across(axis, a, b), S::slab_along(axis as usize, a, b));
        prop_assert_eq!(Slab::<S>::facing(p, d, e), S::slab(p, d, e));
        prop_assert_eq!(Torus::<S>::along(axis, p, d, e), S::torus_along(axis as usize, p, [d, e]));
        prop_assert_eq!(Torus::<S>::around(p, q, a, b), S::torus(p, q, [a, b]));
    });
    assert!(Cylinder::<S>::along(Axis::Y, [S::ZERO; 2], S::ONE, S::ZERO, S::ONE).is_ok());
}
