//! Where pictures look.

use crate::number::{Tested, vector};
use proptest::prelude::*;
use scancsg::geom::Vec3;

pub fn up<S: Tested>() -> Vec3<S> {
    vector([0.0, 1.0, 0.0])
}

/// The centre of a pixel, in half pixels.
pub fn from_middle(index: u32, count: u32) -> i32 {
    2 * index as i32 + 1 - count as i32
}

pub fn direction() -> impl Strategy<Value = [f64; 3]> {
    [-1f64..1.0, -1f64..1.0, -1f64..1.0]
        .prop_filter("a direction", |v| v.iter().map(|x| x * x).sum::<f64>() > 0.01)
}
