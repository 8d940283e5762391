//! What a part is made of: booleans of solids, each with a map and a colour.

use crate::map::{Map, Vector};
use scancsg::render::Rgb;
use std::sync::Arc;

/// A part: a tree of booleans.
#[derive(Debug, Clone, Default)]
pub enum Tree<L = Solid> {
    /// Nothing.
    #[default]
    Empty,
    /// A solid.
    Solid(L),
    /// What is in any.
    Union(Vec<Tree<L>>),
    /// What is in all.
    Intersection(Vec<Tree<L>>),
    /// What is in the first, and in none of the others.
    Difference(Box<Tree<L>>, Vec<Tree<L>>),
}

/// A solid of a tree.
#[derive(Debug, Clone)]
pub struct Solid {
    /// What it is, in its own frame.
    pub form: Form,
    /// Where it is.
    pub map: Map,
    /// Its colour, if it has one.
    pub color: Option<Rgb>,
    /// The line that it comes from.
    pub line: usize,
}

/// Kinds of solids. Those with an axis have it along z.
#[derive(Debug, Clone)]
pub enum Form {
    /// A box, by its lowest and its highest corner.
    Cuboid([Vector; 2]),
    /// A cylinder from one height to another.
    Cylinder {
        /// Its radius.
        radius: f64,
        /// From where to where.
        heights: [f64; 2],
    },
    /// A cone that may be cut off.
    Cone {
        /// The radii at both heights.
        radii: [f64; 2],
        /// From where to where.
        heights: [f64; 2],
    },
    /// A ball around the origin.
    Sphere {
        /// Its radius.
        radius: f64,
    },
    /// A ring around the z axis, through the plane z = 0.
    Torus {
        /// The radius of its middle line.
        ring: f64,
        /// The radius of the tube.
        tube: f64,
    },
    /// A convex polyhedron.
    Convex(Arc<Convex>),
}

/// A convex polyhedron, by its planes and by its corners.
#[derive(Debug, Clone, PartialEq)]
pub struct Convex {
    /// Normals of length 1 that point outwards, and how far the planes are along them.
    pub planes: Vec<(Vector, f64)>,
    /// The corners.
    pub corners: Vec<Vector>,
}

impl Convex {
    /// The image under a map. The map isn't flat.
    #[must_use]
    pub fn mapped(&self, map: &Map) -> Self {
        let plane = |&(normal, offset): &(Vector, f64)| {
            // Of this length: its offset grows by the same.
            let image = map.normal(normal);
            let length = crate::map::length(image);
            let far = map.determinant().abs() * offset + image.dot(map.shift);
            (image * (1.0 / length), far / length)
        };
        Self {
            planes: self.planes.iter().map(plane).collect(),
            corners: self.corners.iter().map(|corner| map.point(*corner)).collect(),
        }
    }
}

impl Tree {
    /// A solid in its own place.
    #[must_use]
    pub fn solid(form: Form, line: usize) -> Self {
        Self::Solid(Solid { form, map: Map::IDENTITY, color: None, line })
    }

    /// Puts another map behind that of every solid.
    pub fn place(&mut self, map: &Map) {
        self.change_each(&mut |solid| solid.map = map.after(&solid.map));
    }
}

impl<L> Tree<L> {
    /// What is in any of the trees.
    #[must_use]
    pub fn union(trees: impl IntoIterator<Item = Self>) -> Self {
        let mut members = Vec::new();
        for tree in trees {
            match tree {
                Self::Empty => {}
                Self::Union(more) => members.extend(more),
                other => members.push(other),
            }
        }
        match members.len() {
            0 => Self::Empty,
            1 => members.pop().unwrap_or_default(),
            _ => Self::Union(members),
        }
    }

    /// What is in all of the trees.
    #[must_use]
    pub fn intersection(trees: impl IntoIterator<Item = Self>) -> Self {
        let mut members = Vec::new();
        for tree in trees {
            match tree {
                Self::Empty => return Self::Empty,
                Self::Intersection(more) => members.extend(more),
                other => members.push(other),
            }
        }
        match members.len() {
            0 => Self::Empty,
            1 => members.pop().unwrap_or_default(),
            _ => Self::Intersection(members),
        }
    }

    /// What is in the first tree and in none of the others.
    #[must_use]
    pub fn difference(first: Self, others: impl IntoIterator<Item = Self>) -> Self {
        let mut cutters = Vec::new();
        for tree in others {
            match tree {
                Self::Empty => {}
                Self::Union(more) => cutters.extend(more),
                other => cutters.push(other),
            }
        }
        match first {
            Self::Empty => Self::Empty,
            first if cutters.is_empty() => first,
            Self::Difference(first, mut before) => {
                before.extend(cutters);
                Self::Difference(first, before)
            }
            first => Self::Difference(Box::new(first), cutters),
        }
    }

    /// Calls `each` for every solid.
    pub fn for_each<'a>(&'a self, each: &mut impl FnMut(&'a L)) {
        match self {
            Self::Empty => {}
            Self::Solid(solid) => each(solid),
            Self::Union(members) | Self::Intersection(members) => {
                members.iter().for_each(|member| member.for_each(each));
            }
            Self::Difference(first, others) => {
                first.for_each(each);
                others.iter().for_each(|other| other.for_each(each));
            }
        }
    }

    /// Calls `change` for every solid.
    pub fn change_each(&mut self, change: &mut impl FnMut(&mut L)) {
        match self {
            Self::Empty => {}
            Self::Solid(solid) => change(solid),
            Self::Union(members) | Self::Intersection(members) => {
                members.iter_mut().for_each(|member| member.change_each(change));
            }
            Self::Difference(first, others) => {
                first.change_each(change);
                others.iter_mut().for_each(|other| other.change_each(change));
            }
        }
    }

    /// The same tree of other leaves. A leaf that becomes none is empty.
    pub fn try_map<M, E>(
        self,
        each: &mut impl FnMut(L) -> Result<Option<M>, E>,
    ) -> Result<Tree<M>, E> {
        let mut all = |trees: Vec<Self>| -> Result<Vec<_>, E> {
            trees.into_iter().map(|tree| tree.try_map(&mut *each)).collect()
        };
        Ok(match self {
            Self::Empty => Tree::Empty,
            Self::Union(members) => Tree::union(all(members)?),
            Self::Intersection(members) => Tree::intersection(all(members)?),
            Self::Difference(first, others) => {
                let others = all(others)?;
                Tree::difference(first.try_map(each)?, others)
            }
            Self::Solid(leaf) => each(leaf)?.map_or(Tree::Empty, Tree::Solid),
        })
    }

    /// How many solids, operators and levels of operators there are. A union of five counts as four operators.
    #[must_use]
    pub fn counts(&self) -> Counts {
        let of_many = |members: &mut dyn Iterator<Item = &Self>| {
            members.map(Self::counts).reduce(|sum, more| Counts {
                solids: sum.solids + more.solids,
                operators: sum.operators + more.operators + 1,
                levels: sum.levels.max(more.levels),
            })
        };
        let counts = match self {
            Self::Empty => None,
            Self::Solid(_) => Some(Counts { solids: 1, operators: 0, levels: 0 }),
            Self::Union(members) | Self::Intersection(members) => of_many(&mut members.iter()),
            Self::Difference(first, others) => {
                of_many(&mut std::iter::once(&**first).chain(others))
            }
        };
        let counts = counts.unwrap_or_default();
        let deeper = usize::from(!matches!(self, Self::Empty | Self::Solid(_)));
        Counts { levels: counts.levels + deeper, ..counts }
    }
}

/// How large a tree is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Solids.
    pub solids: usize,
    /// Booleans of two operands that it takes.
    pub operators: usize,
    /// Levels of booleans.
    pub levels: usize,
}
