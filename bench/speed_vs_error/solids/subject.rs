//! What a solid says of itself to be measured, and the rays that are drawn at it.

use super::method::Method;
use scancsg::solid::Solid;
use testkit::limits::SolidLimits;
use testkit::number::Tested;
use testkit::random::Random;
use testkit::vector::{V, add, along, cross, unit};

/// Where a line is inside a solid, in order.
pub type Spans<T> = [Option<[T; 2]>; 2];

/// A kind of solids: its numbers in `f64`, which holds those of every type.
pub trait Subject: Copy + 'static {
    const NAME: &'static str;
    const LIMITS: SolidLimits;
    /// The relative ε by which a solid in fixed point is grown and shrunk to find robust rays.
    const FIXED_GROWTH: f64 = GROWTH;
    type Solid<S: Tested>: Solid<Scalar = S>;

    fn drawn(random: &mut Random) -> Self;

    /// By the numbers that a type holds.
    fn rounded<S: Tested>(&self) -> Self;

    fn solid<S: Tested>(&self) -> Option<Self::Solid<S>>;

    /// Where a line is inside the solid, grown at all sides by this part of its size: in `f64`, counted
    /// from the point nearest to the solid's middle.
    fn spans(&self, ray: [V; 2], growth: f64) -> Spans<f64>;

    /// The methods that the crate's are compared with. The first one is what every time is a multiple of.
    fn peers() -> Vec<Method<Self>>;

    fn size(&self) -> f64;

    /// A point of the surface, and the normal.
    fn on_surface(&self, random: &mut Random) -> [V; 2];

    /// A point inside that sees this point of the surface.
    fn core(&self, surface: [V; 2]) -> V;

    /// A point at which a line can touch the solid, the way out from there, and that of the line.
    fn touch(&self, random: &mut Random) -> [V; 3] {
        let [point, normal] = self.on_surface(random);
        [point, normal, unit(cross(normal, random.direction()))]
    }

    /// A point of the surface, and a way along which the solid's formulas have a term that vanishes.
    fn special(&self, random: &mut Random) -> [V; 2];
}

/// By which part of its size a solid is grown and shrunk to find robust rays.
pub const GROWTH: f64 = 1e-6;

/// A kind of rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Ordinary,
    /// From 10³ to 10⁶ sizes away.
    Far,
    /// Past the surface, or an edge, by 10⁻¹ to 10⁻⁶ of the size, inside or outside.
    Grazing,
    /// 10⁻² to 10⁻⁶ rad off a face, a side, an axis or a plane of symmetry.
    Parallel,
    Inside,
    Surface,
}

impl Kind {
    pub const ALL: [(Self, &str); 6] = [
        (Self::Ordinary, "ordinary"),
        (Self::Far, "far"),
        (Self::Grazing, "grazing"),
        (Self::Parallel, "parallel"),
        (Self::Inside, "inside"),
        (Self::Surface, "surface"),
    ];

    pub fn name(self) -> &'static str {
        Self::ALL.into_iter().find(|(kind, _)| *kind == self).map_or("", |(_, name)| name)
    }

    pub fn ray<Q: Subject>(self, solid: &Q, random: &mut Random) -> [V; 2] {
        let power = |random: &mut Random, low, high| 10f64.powf(random.between(low, high));
        let inside = |random: &mut Random| {
            let surface = solid.on_surface(random);
            let core = solid.core(surface);
            let part = random.between(0.001, 1.0);
            std::array::from_fn(|i| surface[0][i] + part * (core[i] - surface[0][i]))
        };
        let back = |point: V, way: V, sizes: f64| [along(point, -sizes * solid.size(), way), way];
        let way = random.direction();
        match self {
            Self::Ordinary => {
                let target = along(inside(random), 0.3 * solid.size(), random.point(1.0));
                back(target, way, random.between(3.0, 10.0))
            }
            Self::Far => {
                let target = along(inside(random), 0.3 * solid.size(), random.point(1.0));
                back(target, way, power(random, 3.0, 6.0))
            }
            Self::Grazing => {
                let [point, outwards, way] = solid.touch(random);
                let past = power(random, -6.0, -1.0) * random.sign() * solid.size();
                back(along(point, past, outwards), way, random.between(2.0, 10.0))
            }
            Self::Parallel => {
                let [point, straight] = solid.special(random);
                let off = power(random, -6.0, -1.0) * solid.size();
                let beside = along(point, off, random.direction());
                let tilt = power(random, -6.0, -2.0);
                let way = unit(add(straight, random.direction().map(|x| tilt * x)));
                back(beside, way, random.between(2.0, 10.0))
            }
            Self::Inside => [inside(random), way],
            Self::Surface => [solid.on_surface(random)[0], way],
        }
    }
}
