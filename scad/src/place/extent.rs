//! The box around a solid, in its frame.

use super::Body;
use crate::map::{Map, Vector};
use crate::tree::Form;
use scancsg::geom::vec3;

impl Body {
    /// Whether it is too thin for its coordinates.
    pub(super) fn is_flat(&self) -> bool {
        match self {
            Self::Cylinder { ends: [low, high], .. } | Self::Cone { ends: [low, high], .. } => {
                low >= high
            }
            Self::Cuboid([low, high]) => low.x >= high.x || low.y >= high.y || low.z >= high.z,
            Self::Sphere { .. } | Self::Torus { .. } | Self::Convex(_) | Self::Stretched(..) => {
                false
            }
        }
    }

    /// The lowest and the highest coordinates, in its frame.
    #[must_use]
    pub fn bounds(&self) -> [Vector; 2] {
        match self {
            Self::Cuboid(corners) => *corners,
            Self::Cylinder { axis, at, radius, ends } => round(*axis, *at, *radius, *ends),
            Self::Cone { axis, at, radii, ends } => {
                round(*axis, *at, radii[0].max(radii[1]), *ends)
            }
            Self::Sphere { center, radius } => {
                let reach = vec3(*radius, *radius, *radius);
                [*center - reach, *center + reach]
            }
            Self::Torus { axis, center, ring, tube } => {
                let mut reach = [ring + tube; 3];
                reach[*axis] = *tube;
                [*center - Vector::from(reach), *center + Vector::from(reach)]
            }
            Self::Convex(convex) => around(convex.corners.iter().copied()),
            Self::Stretched(form, map) => stretched(form, map),
        }
    }
}

fn round(axis: usize, [u, v]: [f64; 2], radius: f64, [low, high]: [f64; 2]) -> [Vector; 2] {
    let corner = |radius: f64, end: f64| match axis {
        0 => vec3(end, u + radius, v + radius),
        1 => vec3(u + radius, end, v + radius),
        _ => vec3(u + radius, v + radius, end),
    };
    [corner(-radius, low), corner(radius, high)]
}

fn around(points: impl Iterator<Item = Vector>) -> [Vector; 2] {
    let ends = points.map(|point| [point, point]).reduce(|[low, high], [l, h]| {
        let low = vec3(low.x.min(l.x), low.y.min(l.y), low.z.min(l.z));
        [low, vec3(high.x.max(h.x), high.y.max(h.y), high.z.max(h.z))]
    });
    ends.unwrap_or([vec3(0.0, 0.0, 0.0); 2])
}

fn stretched(form: &Form, map: &Map) -> [Vector; 2] {
    let (reach, low, high) = match form {
        Form::Cylinder { radius, heights } => (*radius, heights[0], heights[1]),
        Form::Cone { radii, heights } => (radii[0].max(radii[1]), heights[0], heights[1]),
        Form::Sphere { radius } => (*radius, -radius, *radius),
        Form::Torus { ring, tube } => (ring + tube, -tube, *tube),
        Form::Cuboid([low, high]) => {
            return around([map.point(*low), map.point(*high)].into_iter());
        }
        Form::Convex(convex) => {
            return around(convex.corners.iter().map(|corner| map.point(*corner)));
        }
    };
    let corner = |i: usize| {
        let side = |bit: usize| if i >> bit & 1 == 0 { -reach } else { reach };
        map.point(vec3(side(0), side(1), if i >> 2 & 1 == 0 { low } else { high }))
    };
    around((0..8).map(corner))
}
