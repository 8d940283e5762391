//! The solids that have a form as bytes.

use super::{BytesError, Reader, Writer};
use crate::geom::{AffineMap, Direction, Vec3};
use crate::quadric::{HalfSpace, Planes, Ring, Taper, Wall};
use crate::scalar::Scalar;
use crate::solid::{
    Bounds, Cone, Cuboid, Cylinder, Polyhedron, Pooled, Scaled, Solid, Sphere, Torus,
};
use crate::span::Shape;

/// A solid that has a form as bytes, or an enum of several.
///
/// The crate's primitives have kinds below 128. A solid of yours takes one from 128 to 239.
pub trait Coded: Solid + Sized {
    /// Whether a solid of a kind may be one.
    fn has_kind(kind: u8) -> bool;

    /// The kind of this one.
    fn kind(&self) -> u8;

    /// Writes all numbers of it.
    ///
    /// # Errors
    /// [`BytesError::Length`]; [`BytesError::Solid`] for numbers that the format has no room for.
    fn write(&self, to: &mut Writer<'_>) -> Result<(), BytesError>;

    /// Reads one of a kind. For [`BytesError::Kind`], an enum asks the next of its solids that have the kind.
    ///
    /// # Errors
    /// [`BytesError::Kind`] for a kind that it doesn't [have](Self::has_kind), [`BytesError::Solid`],
    /// [`BytesError::Length`].
    fn read(kind: u8, from: &mut Reader<'_>) -> Result<Self, BytesError>;
}

macro_rules! coded {
    ($($Solid:ident = $kind:literal: |$solid:ident, $to:ident| $write:expr, |$from:ident| $read:expr;)+) => {$(
        impl<S: Scalar> Coded for $Solid<S> {
            fn has_kind(kind: u8) -> bool {
                kind == $kind
            }

            fn kind(&self) -> u8 {
                $kind
            }

            fn write(&self, $to: &mut Writer<'_>) -> Result<(), BytesError> {
                let $solid = self;
                $write
            }

            fn read(kind: u8, $from: &mut Reader<'_>) -> Result<Self, BytesError> {
                if kind != $kind {
                    return Err(BytesError::Kind);
                }
                $read.map_err(|_| BytesError::Solid)
            }
        }
    )+};
}

coded! {
    Cylinder = 1: |solid, to| {
        let Wall { base, radius, .. } = solid.wall;
        to.vector(base)?;
        to.number(radius)?;
        planes(&solid.caps, to)
    }, |from| Cylinder::checked(from.vector()?, from.number()?, caps(from)?);

    Cuboid = 2: |solid, to| {
        solid.corners().into_iter().try_for_each(|corner| to.vector(corner))
    }, |from| Cuboid::between(from.vector()?, from.vector()?);

    Sphere = 3: |solid, to| match solid.bounds() {
        Bounds::Ball { center, radius } => {
            to.vector(center)?;
            to.number(radius)
        }
        _ => Err(BytesError::Solid),
    }, |from| Sphere::around(from.vector()?, from.number()?);

    Cone = 4: |solid, to| {
        let Taper { base, radii, .. } = solid.taper;
        to.vector(base)?;
        radii.into_iter().try_for_each(|radius| to.number(radius))?;
        planes(&solid.caps, to)
    }, |from| {
        let (base, low, high) = (from.vector()?, from.number::<S>()?, from.number::<S>()?);
        Cone::checked(Cylinder::checked(base, low.max(high), caps(from)?), [low, high])
    };

    Torus = 5: |solid, to| {
        let Ring { center, axis, radius, tube } = &solid.ring;
        to.vector(*center)?;
        to.direction(axis)?;
        to.number(*radius)?;
        to.number(*tube)
    }, |from| {
        Torus::checked(from.vector()?, from.direction()?, from.number()?, from.number()?)
    };

    HalfSpace = 6: |solid, to| {
        to.direction(&solid.normal)?;
        to.number(solid.offset)
    }, |from| half_space::<S>(from);
}

/// As many faces as there are, and the corners of a box around them, which isn't computed again.
impl<S: Scalar, const N: usize> Coded for Polyhedron<S, N> {
    fn has_kind(kind: u8) -> bool {
        kind == POLYHEDRON
    }

    fn kind(&self) -> u8 {
        POLYHEDRON
    }

    fn write(&self, to: &mut Writer<'_>) -> Result<(), BytesError> {
        write_polyhedron(self.faces(), [self.low, self.high], to)
    }

    fn read(kind: u8, from: &mut Reader<'_>) -> Result<Self, BytesError> {
        if kind != POLYHEDRON {
            return Err(BytesError::Kind);
        }
        let [count] = from.array()?;
        let mut faces = [HalfSpace { normal: Direction::Z, offset: S::ZERO }; N];
        let used = faces.get_mut(..has_room::<Self>(count)?).unwrap_or_default();
        for face in used {
            *face = half_space(from)?;
        }
        let [low, high] = corners(from)?;
        Ok(Self { faces, count: count.into(), low, high })
    }
}

/// The same bytes as a polyhedron's. The program reads the faces again, and writes them.
impl<S: Scalar, const N: usize> Coded for Pooled<S, N> {
    fn has_kind(kind: u8) -> bool {
        kind == POLYHEDRON
    }

    fn kind(&self) -> u8 {
        POLYHEDRON
    }

    /// It has no faces: of a scaled one, say, they aren't in a pool.
    fn write(&self, _: &mut Writer<'_>) -> Result<(), BytesError> {
        Err(BytesError::Solid)
    }

    fn read(kind: u8, from: &mut Reader<'_>) -> Result<Self, BytesError> {
        if kind != POLYHEDRON {
            return Err(BytesError::Kind);
        }
        let [count] = from.array()?;
        for _ in 0..has_room::<Self>(count)? {
            half_space::<S>(from)?;
        }
        let [low, high] = corners(from)?;
        Ok(Self { low, high })
    }
}

/// So many faces, at least one, if a solid has room for them. Another one may have more.
fn has_room<L: Shape>(count: u8) -> Result<usize, BytesError> {
    match u16::from(count) {
        0 => Err(BytesError::Solid),
        count if count > L::FACES => Err(BytesError::Kind),
        count => Ok(count.into()),
    }
}

pub(super) fn write_polyhedron<S: Scalar>(
    faces: &[HalfSpace<S>],
    corners: [Vec3<S>; 2],
    to: &mut Writer<'_>,
) -> Result<(), BytesError> {
    if faces.is_empty() {
        return Err(BytesError::Solid);
    }
    let count = u8::try_from(faces.len()).map_err(|_| BytesError::Length)?;
    to.bytes(&[count])?;
    faces.iter().try_for_each(|face| face.write(to))?;
    corners.into_iter().try_for_each(|corner| to.vector(corner))
}

fn corners<S: Scalar>(from: &mut Reader<'_>) -> Result<[Vec3<S>; 2], BytesError> {
    let [low, high] = [from.vector()?, from.vector()?];
    Cuboid::between(low, high).map_err(|_| BytesError::Solid)?;
    Ok([low, high])
}

const POLYHEDRON: u8 = 7;

/// The map, then the solid inside, whose kind decides which type of scaled solid it is.
impl<T: Coded> Coded for Scaled<T> {
    fn has_kind(kind: u8) -> bool {
        kind == SCALED
    }

    fn kind(&self) -> u8 {
        SCALED
    }

    fn write(&self, to: &mut Writer<'_>) -> Result<(), BytesError> {
        let (rows, shift) = self.map.rows().ok_or(BytesError::Solid)?;
        rows.into_iter().try_for_each(|row| to.vector(row))?;
        to.vector(shift)?;
        to.bytes(&[self.solid.kind()])?;
        self.solid.write(to)
    }

    fn read(kind: u8, from: &mut Reader<'_>) -> Result<Self, BytesError> {
        if kind != SCALED {
            return Err(BytesError::Kind);
        }
        let (rows, shift) = ([from.vector()?, from.vector()?, from.vector()?], from.vector()?);
        let [inner] = from.array()?;
        let solid = T::read(inner, from)?;
        if solid.pooled().is_some() {
            return Err(BytesError::Kind);
        }
        let map = AffineMap::of_rows(rows, shift).map_err(|_| BytesError::Solid)?;
        Ok(Self::new(solid, map))
    }
}

const SCALED: u8 = 8;

pub(super) fn half_space<S: Scalar>(from: &mut Reader<'_>) -> Result<HalfSpace<S>, BytesError> {
    let (normal, offset) = (from.direction()?, from.number::<S>()?);
    if offset.is_within_range() { Ok(HalfSpace { normal, offset }) } else { Err(BytesError::Solid) }
}

fn planes<S: Scalar>(planes: &Planes<S>, to: &mut Writer<'_>) -> Result<(), BytesError> {
    to.direction(&planes.normal)?;
    to.number(planes.low)?;
    to.number(planes.high)
}

fn caps<S: Scalar>(from: &mut Reader<'_>) -> Result<Planes<S>, BytesError> {
    Ok(Planes { normal: from.direction()?, low: from.number()?, high: from.number()? })
}
