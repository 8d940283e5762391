//! The gallery: one scene for each kind of solid, and three parts made of them.
//!
//! All scenes are of one type, so that a program has one renderer for all of them: a list of parts minus
//! another one. A part is an `enum` of solids, and is asked line by line.

use scancsg::geom::{Axis, Line, Pose, Vec3};
use scancsg::scalar::Scalar;
use scancsg::solid::{
    Bounds, ByLine, Cone, Cuboid, Cylinder, Difference, HalfSpace, Many, Painted, Placed,
    Polyhedron, Rgb, Scaled, Solid, Sphere, Torus, Wrap,
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
    Box(Placed<Cuboid<S>>),
    Cone(Placed<Cone<S>>),
    Cylinder(Placed<Cylinder<S>>),
    Drum(Scaled<Cylinder<S>>),
    Egg(Scaled<Sphere<S>>),
    HalfSpace(HalfSpace<S>),
    Polyhedron(Placed<Polyhedron<S, 8>>),
    Sphere(Placed<Sphere<S>>),
    Torus(Placed<Torus<S>>),
}

const STEEL: Rgb = Rgb::new(150, 175, 200);
const BRASS: Rgb = Rgb::new(235, 175, 70);
const RED: Rgb = Rgb::new(205, 80, 65);
const GREEN: Rgb = Rgb::new(95, 165, 105);

type Built = Result<(), Box<dyn Error>>;

/// A scene in the making. Lengths are in hundredths.
struct Builder<S: Scalar> {
    color: Rgb,
    /// Where parts are put that a pose can move.
    pose: Pose<S>,
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
    /// Adds a part of the body.
    fn put(&mut self, part: impl Into<Part<S>>) -> Built {
        push(&mut self.body, Painted::new(ByLine::new(part.into()), self.color))
    }

    /// Adds what is cut out of the body.
    fn cut(&mut self, part: impl Into<Part<S>>) -> Built {
        push(&mut self.cuts, Painted::new(ByLine::new(part.into()), self.color))
    }

    fn at<T: Solid<Scalar = S>>(&self, solid: T) -> Placed<T> {
        Placed::new(solid, self.pose)
    }

    fn cuboid(&self, low: [i32; 3], high: [i32; 3]) -> Result<Part<S>, Box<dyn Error>> {
        Ok(self.at(Cuboid::between(v(low), v(high))?).into())
    }

    /// A cylinder of a radius, from one offset along the axis to another.
    fn rod(&self, axis: Axis, at: [i32; 2], size: [i32; 3]) -> Result<Part<S>, Box<dyn Error>> {
        let [radius, low, high] = size.map(n);
        Ok(self.at(Cylinder::along(axis, at.map(n), radius, low, high)?).into())
    }

    /// A cone of two radii, from one offset along the axis to another.
    fn cone(&self, axis: Axis, at: [i32; 2], size: [i32; 4]) -> Result<Part<S>, Box<dyn Error>> {
        let [first, second, low, high] = size.map(n);
        Ok(self.at(Cone::along(axis, at.map(n), [first, second], low, high)?).into())
    }

    fn ball(&self, center: [i32; 3], radius: i32) -> Result<Part<S>, Box<dyn Error>> {
        Ok(self.at(Sphere::around(v(center), n(radius))?).into())
    }

    fn ring(
        &self,
        axis: Axis,
        center: [i32; 3],
        size: [i32; 2],
    ) -> Result<Part<S>, Box<dyn Error>> {
        let [ring, tube] = size.map(n);
        Ok(self.at(Torus::along(axis, v(center), ring, tube)?).into())
    }
}

fn push<S: Scalar>(list: &mut Option<Parts<S>>, part: Painted<ByLine<Part<S>, SPANS>>) -> Built {
    match list {
        Some(list) => list.push(part)?,
        None => *list = Some(Many::new(part)),
    }
    Ok(())
}

macro_rules! scenes {
    ($($(#[$docs:meta])* $Name:ident: $build:ident,)+) => {
        /// A scene of the gallery.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
        pub enum Scene {
            $($(#[$docs])* $Name,)+
        }

        impl Scene {
            /// Makes the scene.
            pub fn build<S: Scalar>(self) -> Result<Assembly<S>, Box<dyn Error>> {
                let mut of = Builder::<S> {
                    color: STEEL,
                    pose: Pose::translation(Vec3::ZERO)?,
                    body: None,
                    cuts: None,
                };
                match self {
                    $(Self::$Name => $build(&mut of)?,)+
                }
                // Nothing is cut off by a ball that is far from everything.
                if of.cuts.is_none() {
                    of.cut(of.ball([0, 0, -2000], 1)?)?;
                }
                let (body, cuts) = of.body.zip(of.cuts).ok_or("the scene is empty")?;
                Ok(Difference::new(body, cuts))
            }
        }
    };
}

scenes! {
    /// A box with a slot
    Box: slotted_box,
    /// A ball that a plane cuts
    HalfSpace: half_ball,
    /// A polyhedron: a hexagonal nut, and a wedge
    Polyhedron: nut,
    /// Cones: a funnel
    Cone: funnel,
    /// Tori: two links of a chain
    Torus: chain,
    /// Ellipsoids and an elliptic cylinder
    Ellipsoid: eggs,
    /// Capsules
    Capsule: capsules,
    /// A box with round edges and corners
    Rounded: rounded,
    /// A flange with a ring of holes
    Ring: flange,
    /// A bearing housing of a box, cylinders and spheres
    Housing: housing,
    /// A knob with a knurl and a pointer
    Knob: knob,
    /// A robot's arm of three links
    Arm: arm,
}

fn slotted_box<S: Scalar>(of: &mut Builder<S>) -> Built {
    of.put(of.cuboid([-160, -90, -110], [160, 90, 110])?)?;
    of.color = BRASS;
    of.cut(of.cuboid([-170, 10, -40], [60, 100, 40])?)?;
    of.cut(of.cuboid([90, -40, -120], [130, 40, 120])?)
}

fn half_ball<S: Scalar>(of: &mut Builder<S>) -> Built {
    of.put(of.ball([0, 0, 0], 170)?)?;
    of.color = BRASS;
    of.cut(HalfSpace::facing(v([-40, -100, -70]), n(-30))?)?;
    of.color = RED;
    of.cut(of.ball([0, 0, 0], 80)?)
}

fn nut<S: Scalar>(of: &mut Builder<S>) -> Built {
    let corners = [[150, 0], [75, 130], [-75, 130], [-150, 0], [-75, -130], [75, -130]];
    of.put(of.at(Polyhedron::extruded(Axis::Y, corners.map(|c| c.map(n)), n(-60), n(60))?))?;
    of.color = GREEN;
    let wedge = [[-170, -110], [-60, -110], [-170, 0]];
    of.put(of.at(Polyhedron::extruded(Axis::Z, wedge.map(|c| c.map(n)), n(100), n(200))?))?;
    of.color = BRASS;
    of.cut(of.rod(Axis::Y, [0, 0], [75, -100, 100])?)?;
    of.cut(of.cone(Axis::Y, [0, 0], [75, 100, 40, 65])?)
}

fn funnel<S: Scalar>(of: &mut Builder<S>) -> Built {
    of.put(of.cone(Axis::Y, [0, 0], [30, 150, -60, 100])?)?;
    of.put(of.rod(Axis::Y, [0, 0], [30, -170, -60])?)?;
    of.put(of.rod(Axis::Y, [0, 0], [165, 100, 115])?)?;
    of.color = BRASS;
    of.put(of.cone(Axis::Y, [0, 0], [60, 0, 20, 190])?)?;
    of.cut(of.cone(Axis::Y, [0, 0], [20, 145, -65, 118])?)?;
    of.cut(of.rod(Axis::Y, [0, 0], [20, -200, -60])?)
}

fn chain<S: Scalar>(of: &mut Builder<S>) -> Built {
    of.put(of.ring(Axis::Y, [-60, 0, 0], [110, 30])?)?;
    of.color = BRASS;
    of.put(of.ring(Axis::Z, [70, 0, 0], [110, 30])?)
}

fn eggs<S: Scalar>(of: &mut Builder<S>) -> Built {
    let unit = Sphere::around(Vec3::ZERO, S::ONE)?;
    of.put(Scaled::by(unit, [n(190), n(70), n(110)])?)?;
    of.color = BRASS;
    let rod = Cylinder::along(Axis::Y, [S::ZERO; 2], S::ONE, n(-150), n(150))?;
    of.put(Scaled::by(rod, [n(70), n(100), n(30)])?)?;
    of.color = RED;
    of.cut(Scaled::by(unit, [n(40), n(200), n(15)])?)
}

/// A rod with round ends.
fn capsule<S: Scalar>(of: &mut Builder<S>, from: [i32; 3], to: [i32; 3], radius: i32) -> Built {
    let capsule = Cylinder::capsule(v(from), v(to), n(radius))?;
    let parts = capsule.inner();
    of.put(of.at(*parts.left()))?;
    parts.right().iter().try_for_each(|ball| of.put(of.at(*ball)))
}

fn capsules<S: Scalar>(of: &mut Builder<S>) -> Built {
    capsule(of, [-130, -90, 0], [130, 90, 40], 50)?;
    of.color = BRASS;
    capsule(of, [-90, 110, 60], [110, -120, -60], 35)
}

fn rounded<S: Scalar>(of: &mut Builder<S>) -> Built {
    let rounded = Cuboid::rounded(v([-170, -80, -110]), v([170, 80, 110]), n(45))?;
    let parts = rounded.inner();
    parts.left().iter().try_for_each(|plate| of.put(of.at(*plate)))?;
    let (edges, corners) = (parts.right().left(), parts.right().right());
    edges.iter().try_for_each(|edge| of.put(of.at(*edge)))?;
    corners.iter().try_for_each(|corner| of.put(of.at(*corner)))?;
    of.color = BRASS;
    of.cut(of.ring(Axis::Y, [0, 80, 0], [70, 18])?)
}

fn flange<S: Scalar>(of: &mut Builder<S>) -> Built {
    of.put(of.rod(Axis::Y, [0, 0], [180, -40, 0])?)?;
    of.put(of.cone(Axis::Y, [0, 0], [110, 80, 0, 60])?)?;
    of.put(of.rod(Axis::Y, [0, 0], [80, 60, 130])?)?;
    of.color = BRASS;
    of.cut(of.rod(Axis::Y, [0, 0], [60, -200, 200])?)?;
    let holes = Cylinder::ring::<8>(Axis::Y, [S::ZERO; 2], n(145), n(18), n(-100), n(100))?;
    holes.iter().try_for_each(|hole| of.cut(of.at(*hole)))
}

fn housing<S: Scalar>(of: &mut Builder<S>) -> Built {
    of.put(of.cuboid([-210, -150, -80], [210, -110, 80])?)?;
    of.put(of.rod(Axis::Z, [0, 10], [130, -70, 70])?)?;
    of.put(of.rod(Axis::Z, [0, 10], [145, -15, 15])?)?;
    of.put(of.rod(Axis::Y, [0, 0], [35, 100, 175])?)?;
    of.color = BRASS;
    of.cut(of.rod(Axis::Z, [0, 10], [75, -100, 100])?)?;
    of.cut(of.rod(Axis::Z, [0, 10], [95, -45, 100])?)?;
    of.cut(of.rod(Axis::Y, [0, 0], [12, 50, 200])?)?;
    for [x, z] in [[165, 45], [165, -45], [-165, 45], [-165, -45]] {
        of.cut(of.rod(Axis::Y, [x, z], [15, -200, -50])?)?;
        of.cut(of.ball([x, -102, z], 28)?)?;
    }
    Ok(())
}

fn knob<S: Scalar>(of: &mut Builder<S>) -> Built {
    of.put(of.rod(Axis::Y, [0, 0], [175, -120, -90])?)?;
    of.put(of.cone(Axis::Y, [0, 0], [150, 125, -90, 80])?)?;
    of.put(of.ring(Axis::Y, [0, 80, 0], [100, 25])?)?;
    of.put(of.rod(Axis::Y, [0, 0], [100, 80, 105])?)?;
    of.color = RED;
    of.put(of.cuboid([-10, 60, 0], [10, 112, 120])?)?;
    of.color = BRASS;
    // The knurl: a ring of grooves.
    let grooves = Cylinder::ring::<18>(Axis::Y, [S::ZERO; 2], n(152), n(14), n(-70), n(120))?;
    grooves.iter().try_for_each(|groove| of.cut(of.at(*groove)))?;
    of.cut(of.rod(Axis::Y, [0, 0], [35, -200, 0])?)
}

/// A link of the arm: a rod with round ends and a pin through each.
fn link<S: Scalar>(of: &mut Builder<S>, length: i32, radius: i32) -> Built {
    of.color = STEEL;
    capsule(of, [0, 0, 0], [length, 0, 0], radius)?;
    of.color = BRASS;
    of.put(of.rod(Axis::Z, [0, 0], [radius - 8, -radius - 12, radius + 12])?)
}

fn arm<S: Scalar>(of: &mut Builder<S>) -> Built {
    of.put(of.cone(Axis::Y, [-120, 0], [90, 45, -190, -130])?)?;
    of.color = GREEN;
    of.put(of.cuboid([-220, -205, -90], [-20, -190, 90])?)?;
    // Each joint turns about z, at the end of the link before it.
    let joint = |angle, length| {
        let turn = Pose::rotation_z(n::<S>(angle))?;
        turn.then(&Pose::translation(v([length, 0, 0]))?)
    };
    let base = Pose::rotation_z(n::<S>(110))?.then(&Pose::translation(v([-120, -130, 0]))?)?;
    of.pose = base;
    link(of, 170, 32)?;
    of.pose = joint(-130, 170)?.then(&base)?;
    link(of, 150, 26)?;
    let elbow = of.pose;
    of.pose = joint(-70, 150)?.then(&elbow)?;
    link(of, 70, 20)?;
    of.color = RED;
    of.put(of.cuboid([85, -30, -20], [95, 30, 20])?)?;
    of.put(of.cuboid([95, 18, -12], [140, 30, 12])?)?;
    of.put(of.cuboid([95, -30, -12], [140, -18, 12])?)
}
