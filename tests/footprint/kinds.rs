//! What each kind of solid takes in RAM.

use scancsg::geom::{OrthographicRays, PerspectiveRays};
use scancsg::scalar::I16F16;
use scancsg::solid::{
    AxisCylinder, Cone, Cuboid, Cylinder, HalfSpace, Polyhedron, Scan, Slab, Sphere, Torus,
};

/// A kind of solid: the bytes of its numbers; of its view and its row in an orthographic picture; and in a
/// perspective one.
pub struct Kind {
    pub name: &'static str,
    pub number: &'static str,
    pub bytes: [usize; 3],
}

macro_rules! kinds {
    ($($Solid:ident $(, $count:literal)?;)+) => {
        [$(
            Kind { name: concat!(stringify!($Solid) $(, "<_, ", $count, ">")?), number: "f32", bytes: bytes!($Solid, f32 $(, $count)?) },
            Kind { name: concat!(stringify!($Solid) $(, "<_, ", $count, ">")?), number: "I16F16", bytes: bytes!($Solid, I16F16 $(, $count)?) },
        )+]
    };
}

macro_rules! bytes {
    ($Solid:ident, $S:ident $(, $count:literal)?) => {
        [
            size_of::<$Solid<$S $(, $count)?>>(),
            of_picture::<$Solid<$S $(, $count)?>, OrthographicRays<$S>>(),
            of_picture::<$Solid<$S $(, $count)?>, PerspectiveRays<$S>>(),
        ]
    };
}

/// A view and a row.
const fn of_picture<T: Scan<R>, R>() -> usize {
    size_of::<T::View>() + size_of::<T::Row>()
}

/// All kinds.
pub const KINDS: [Kind; 18] = kinds! {
    Cylinder;
    AxisCylinder;
    Cone;
    Cuboid;
    Sphere;
    Torus;
    Slab;
    HalfSpace;
    Polyhedron, 6;
};
