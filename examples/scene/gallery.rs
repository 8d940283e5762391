//! The gallery: one scene for each kind of solid, and three parts made of them.
//!
//! All scenes are of one type, so that a program has one renderer for all of them: a list of parts minus
//! another one. A part is an `enum` of solids, and is asked line by line.

use scancsg::geom::{Axis, Line, Vec3};
use scancsg::scalar::Scalar;
use scancsg::solid::{
    Bounds, ByLine, Cuboid, Cylinder, Difference, HalfSpace, Many, Painted, Polyhedron, Rgb, Solid,
    Sphere,
};
use scancsg::span::{Face, Shape, SpanStack};
use std::error::Error;

/// A scene of the gallery: parts, minus others.
pub type Assembly<S> = Difference<Parts<S>, Parts<S>>;

/// Parts, each in its colour.
pub type Parts<S> = Many<Painted<ByLine<Part<S>, SPANS>>, CAPACITY>;

/// More than any scene here has of parts.
const CAPACITY: usize = 40;

/// The most spans that a line has with a part.
const SPANS: usize = 2;

/// Declares a solid that is one of several.
macro_rules! part {
    ($($Kind:ident($Solid:ty),)+) => {
        /// One of the crate's solids.
        #[derive(Debug, Clone, Copy)]
        pub enum Part<S: Scalar> {
            $($Kind($Solid),)+
        }

        impl<S: Scalar> Shape for Part<S> {
            type Scalar = S;
            const SPANS: usize = SPANS;
            const STACK: usize = SPANS;
            const FACES: u16 = 8;
        }

        impl<S: Scalar> Solid for Part<S> {
            fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
                match self {
                    $(Self::$Kind(solid) => solid.spans(line, first, stack),)+
                }
            }

            fn normal(&self, face: Face, at: Vec3<S>) -> Vec3<S> {
                match self {
                    $(Self::$Kind(solid) => solid.normal(face, at),)+
                }
            }

            fn bounds(&self) -> Bounds<S> {
                match self {
                    $(Self::$Kind(solid) => solid.bounds(),)+
                }
            }

            fn onto(&self, face: Face, near: Vec3<S>) -> Vec3<S> {
                match self {
                    $(Self::$Kind(solid) => solid.onto(face, near),)+
                }
            }
        }

        $(impl<S: Scalar> From<$Solid> for Part<S> {
            fn from(solid: $Solid) -> Self {
                Self::$Kind(solid)
            }
        })+
    };
}

part! {
    Cuboid(Cuboid<S>),
    Cylinder(Cylinder<S>),
    HalfSpace(HalfSpace<S>),
    Polyhedron(Polyhedron<S, 8>),
    Sphere(Sphere<S>),
}

const STEEL: Rgb = Rgb::new(150, 175, 200);
const BRASS: Rgb = Rgb::new(235, 175, 70);
const RED: Rgb = Rgb::new(205, 80, 65);
const GREEN: Rgb = Rgb::new(95, 165, 105);

type Built = Result<(), Box<dyn Error>>;

/// A scene in the making. Lengths are in hundredths.
struct Builder<S: Scalar> {
    color: Rgb,
    body: Option<Parts<S>>,
    cuts: Option<Parts<S>>,
}

/// So many hundredths.
fn n<S: Scalar>(hundredths: i32) -> S {
    S::from_ratio(hundredths, 100)
}

fn v<S: Scalar>(hundredths: [i32; 3]) -> Vec3<S> {
    Vec3::from(hundredths.map(n))
}

impl<S: Scalar> Builder<S> {
    fn part(&self, solid: impl Into<Part<S>>) -> Painted<ByLine<Part<S>, SPANS>> {
        Painted::new(ByLine::new(solid.into()), self.color)
    }

    fn put(&mut self, solid: impl Into<Part<S>>) -> Built {
        let part = self.part(solid);
        push(&mut self.body, part)
    }

    fn cut(&mut self, solid: impl Into<Part<S>>) -> Built {
        let part = self.part(solid);
        push(&mut self.cuts, part)
    }

    fn cuboid(low: [i32; 3], high: [i32; 3]) -> Result<Cuboid<S>, Box<dyn Error>> {
        Ok(Cuboid::between(v(low), v(high))?)
    }

    fn rod(
        axis: Axis,
        at: [i32; 2],
        [radius, low, high]: [i32; 3],
    ) -> Result<Cylinder<S>, Box<dyn Error>> {
        Ok(Cylinder::along(axis, at.map(n), n(radius), n(low), n(high))?)
    }
}

fn push<S: Scalar>(
    list: &mut Option<Parts<S>>,
    part: Painted<ByLine<Part<S>, SPANS>>,
) -> Built {
    match list {
        Some(list) => list.push(part)?,
        None => *list = Some(Many::new(part)),
    }
    Ok(())
}

macro_rules! scenes {
    ($($(#[$docs:meta])* $Name:ident: $build:ident,)+) => {
        /// A scene of the gallery.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        #[cfg_attr(not(target_os = "none"), derive(clap::ValueEnum))]
        pub enum Scene {
            $($(#[$docs])* $Name,)+
        }

        impl Scene {
            /// Makes the scene.
            pub fn build<S: Scalar>(self) -> Result<Assembly<S>, Box<dyn Error>> {
                let mut of = Builder::<S> { color: STEEL, body: None, cuts: None };
                match self {
                    $(Self::$Name => $build(&mut of)?,)+
                }
                // Nothing is cut off by a ball that is far from everything.
                let nothing = of.part(Sphere::around(v([0, 0, -2000]), n(1))?);
                let body = of.body.ok_or("the scene is empty")?;
                Ok(Difference::new(body, of.cuts.unwrap_or(Many::new(nothing))))
            }
        }
    };
}
