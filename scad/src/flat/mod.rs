//! Shapes of the plane: what `linear_extrude` and `rotate_extrude` are given.

mod hull;
mod offset;
mod polygon;
mod text;

pub use hull::{Disc, hull_of_discs};
pub use offset::{Join, offset};
pub use polygon::Polygon;
pub use text::{Text, text};

use crate::map::{FlatMap, Point, SIX_DIGITS};
use i_overlay::core::overlay_rule::OverlayRule;

/// How many sides a circle has where it must be a polygon.
pub const SIDES: usize = 128;

/// A shape of the plane: a tree of booleans, as a [`Tree`](crate::Tree) is one of solids.
#[derive(Debug, Clone, Default)]
pub enum Flat {
    /// Nothing.
    #[default]
    Empty,
    /// A disc.
    Disc(Disc),
    /// The unit disc under a map that isn't a similarity.
    Ellipse(FlatMap),
    /// A polygon.
    Polygon(Polygon),
    /// What is in any.
    Union(Vec<Flat>),
    /// What is in all.
    Intersection(Vec<Flat>),
    /// What is in the first, and in none of the others.
    Difference(Box<Flat>, Vec<Flat>),
}

impl Flat {
    /// What is in any of the shapes.
    #[must_use]
    pub fn union(shapes: impl IntoIterator<Item = Flat>) -> Self {
        let mut members: Vec<_> = shapes.into_iter().filter(|shape| !shape.is_empty()).collect();
        match members.len() {
            0 | 1 => members.pop().unwrap_or_default(),
            _ => Self::Union(members),
        }
    }

    /// What is in all of the shapes.
    #[must_use]
    pub fn intersection(shapes: impl IntoIterator<Item = Flat>) -> Self {
        let mut members: Vec<_> = shapes.into_iter().collect();
        if members.iter().any(Flat::is_empty) {
            return Self::Empty;
        }
        match members.len() {
            0 | 1 => members.pop().unwrap_or_default(),
            _ => Self::Intersection(members),
        }
    }

    /// What is in the first shape and in none of the others.
    #[must_use]
    pub fn difference(first: Flat, others: impl IntoIterator<Item = Flat>) -> Self {
        let cutters: Vec<_> = others.into_iter().filter(|shape| !shape.is_empty()).collect();
        match first {
            Self::Empty => Self::Empty,
            first if cutters.is_empty() => first,
            first => Self::Difference(Box::new(first), cutters),
        }
    }

    /// Whether nothing is in it, as far as that is plain.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        matches!(self, Self::Empty)
    }

    /// Its image under a map.
    #[must_use]
    pub fn mapped(self, map: &FlatMap) -> Self {
        let each = |shapes: Vec<Flat>| shapes.into_iter().map(|shape| shape.mapped(map)).collect();
        match self {
            Self::Empty => Self::Empty,
            Self::Disc(disc) => {
                let center = map.point(disc.center);
                match map.uniform_scale(SIX_DIGITS) {
                    Some(scale) => Self::Disc(Disc { center, radius: disc.radius * scale }),
                    None => {
                        let columns =
                            map.columns.map(|column| column.map(|part| part * disc.radius));
                        Self::Ellipse(FlatMap { columns, shift: center })
                    }
                }
            }
            Self::Ellipse(inner) => {
                let both = map.after(&inner);
                match both.uniform_scale(SIX_DIGITS) {
                    Some(radius) => Self::Disc(Disc { center: both.shift, radius }),
                    None => Self::Ellipse(both),
                }
            }
            Self::Polygon(polygon) => Self::Polygon(polygon.mapped(map)),
            Self::Union(shapes) => Self::Union(each(shapes)),
            Self::Intersection(shapes) => Self::Intersection(each(shapes)),
            Self::Difference(first, others) => {
                Self::Difference(Box::new(first.mapped(map)), each(others))
            }
        }
    }

    /// The shape as one polygon. Circles get [`SIDES`] sides.
    #[must_use]
    pub fn resolved(&self) -> Polygon {
        let all = |shapes: &[Flat], rule| {
            let mut polygons = shapes.iter().map(Flat::resolved);
            let first = polygons.next().unwrap_or_default();
            polygons.fold(first, |sum, next| sum.combined(&next, rule))
        };
        match self {
            Self::Empty => Polygon::default(),
            Self::Disc(disc) => Polygon::of_outline(disc.outline(SIDES)),
            Self::Ellipse(map) => {
                let unit = Disc { center: [0.0; 2], radius: 1.0 };
                Polygon::of_outline(unit.outline(SIDES)).mapped(map)
            }
            Self::Polygon(polygon) => polygon.clone(),
            Self::Union(shapes) => all(shapes, OverlayRule::Union),
            Self::Intersection(shapes) => all(shapes, OverlayRule::Intersect),
            Self::Difference(first, others) => {
                let cut = |sum: Polygon, next: &Flat| {
                    sum.combined(&next.resolved(), OverlayRule::Difference)
                };
                others.iter().fold(first.resolved(), cut)
            }
        }
    }

    /// Discs, with points among them, that have the same convex hull.
    #[must_use]
    pub fn discs(&self) -> Vec<Disc> {
        match self {
            Self::Empty => Vec::new(),
            Self::Disc(disc) => vec![*disc],
            Self::Union(shapes) => shapes.iter().flat_map(Flat::discs).collect(),
            Self::Ellipse(_) | Self::Polygon(_) | Self::Intersection(_) | Self::Difference(..) => {
                self.resolved().points().map(Disc::point).collect()
            }
        }
    }

    /// The lowest and the highest coordinates. May be too far apart for intersections and differences.
    #[must_use]
    pub fn bounds(&self) -> Option<[Point; 2]> {
        let join = |[low, high]: [Point; 2], [l, h]: [Point; 2]| {
            [[low[0].min(l[0]), low[1].min(l[1])], [high[0].max(h[0]), high[1].max(h[1])]]
        };
        match self {
            Self::Empty => None,
            Self::Difference(first, _) => first.bounds(),
            Self::Intersection(shapes) => shapes.first()?.bounds(),
            Self::Union(shapes) => shapes.iter().filter_map(Flat::bounds).reduce(join),
            _ => {
                let around = |disc: Disc| {
                    let [x, y] = disc.center;
                    [[x - disc.radius, y - disc.radius], [x + disc.radius, y + disc.radius]]
                };
                self.discs().into_iter().map(around).reduce(join)
            }
        }
    }
}
