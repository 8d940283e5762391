//! Vectors and points of `mint`, through which crates of mathematics understand each other.
//!
//! ```
//! use scancsg::geom::{Vec3, vec3};
//!
//! let corner = mint::Point3 { x: 1.0, y: 2.0, z: 3.0 };
//! assert_eq!(Vec3::from(corner), vec3(1.0, 2.0, 3.0));
//! assert_eq!(mint::Vector3::from(vec3(1.0, 2.0, 3.0)), [1.0, 2.0, 3.0].into());
//! ```

use crate::geom::Vec3;
use mint::{IntoMint, Point3, Vector3};

macro_rules! conversions {
    ($($Mint:ident)+) => {$(
        impl<S> From<$Mint<S>> for Vec3<S> {
            fn from($Mint { x, y, z }: $Mint<S>) -> Self {
                Self { x, y, z }
            }
        }

        impl<S> From<Vec3<S>> for $Mint<S> {
            fn from(Vec3 { x, y, z }: Vec3<S>) -> Self {
                Self { x, y, z }
            }
        }
    )+};
}

conversions! { Point3 Vector3 }

impl<S> IntoMint for Vec3<S> {
    type MintType = Vector3<S>;
}
