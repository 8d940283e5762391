//! The memory of a program on a device: sizes of types, which are the same there as here.

use super::kind::Kind;
use super::{Bytes, NumberType};
use scancsg::geom::OrthographicRays;
use scancsg::program::{Program, ProgramRow};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::scan::Scan;
use scancsg::solid::{Cone, Cuboid, Cylinder, Polyhedron, Scaled, Sphere, Torus};
use scancsg::span::Shape;

/// Bytes of RAM.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Memory {
    /// The program.
    pub program: usize,
    /// View and row of its picture, with a camera without perspective.
    pub picture: usize,
}

impl Bytes {
    /// The memory of a program that has room for this one, with leaves of the kinds that it has.
    #[must_use]
    pub fn memory(&self) -> Memory {
        match self.number {
            NumberType::F32 => self.memory_in::<f32>(),
            NumberType::I16F16 => self.memory_in::<I16F16>(),
        }
    }

    fn memory_in<S: Scalar>(&self) -> Memory {
        let [solid, view, row] = self.kinds().fold([0; 3], |most, kind| {
            let sizes = sizes::<S>(kind, self.faces);
            [0, 1, 2].map(|i| most[i].max(sizes[i]))
        });
        type Small<S, const PARTS: usize, const POSES: usize> = Program<Sphere<S>, PARTS, POSES>;
        type SmallRow<const PARTS: usize> = ProgramRow<(), PARTS>;
        let one = size_of::<Small<S, 1, 0>>();
        // A place, its share of the tree, its links, and the tags of the leaf and of both stages.
        let place = size_of::<Small<S, 2, 0>>() - one - size_of::<Sphere<S>>() + TAG;
        let links = size_of::<SmallRow<2>>() - size_of::<SmallRow<1>>() + 2 * TAG;
        let pose = size_of::<Small<S, 1, 1>>() - one;
        Memory {
            program: self.parts * (solid + place) + self.poses * pose,
            picture: self.parts * (view + row + links),
        }
    }
}

/// The tag of an enum.
const TAG: usize = 4;

/// The sizes of a solid, of its view and of its row.
fn sizes<S: Scalar>(kind: Kind, faces: usize) -> [usize; 3] {
    match kind {
        Kind::Cylinder => of::<S, Cylinder<S>>(),
        Kind::Cuboid => of::<S, Cuboid<S>>(),
        Kind::Sphere => of::<S, Sphere<S>>(),
        Kind::Cone => of::<S, Cone<S>>(),
        Kind::Torus => of::<S, Torus<S>>(),
        Kind::Polyhedron => {
            let [few, more] = [of::<S, Polyhedron<S, 4>>(), of::<S, Polyhedron<S, 12>>()];
            [0, 1, 2].map(|i| few[i] + (more[i] - few[i]) / 8 * faces.saturating_sub(4))
        }
        Kind::ScaledCylinder => of::<S, Scaled<Cylinder<S>>>(),
        Kind::ScaledSphere => of::<S, Scaled<Sphere<S>>>(),
        Kind::ScaledCone => of::<S, Scaled<Cone<S>>>(),
        Kind::ScaledTorus => of::<S, Scaled<Torus<S>>>(),
    }
}

fn of<S: Scalar, T: Scan<OrthographicRays<S>> + Shape<Scalar = S>>() -> [usize; 3] {
    [size_of::<T>(), size_of::<T::View>(), size_of::<T::Row>()]
}

#[cfg(test)]
mod tests {
    use super::super::{FACES, Kind, NumberType, program};
    use crate::{Model, lower, parse};
    use scancsg::geom::OrthographicRays;
    use scancsg::program::Program;
    use scancsg::scan::Scan;
    use scancsg::solid::{Cone, Cuboid, Cylinder, Polyhedron};
    use std::error::Error;

    scancsg::leaves! {
        enum Few<S> {
            Cylinder(Cylinder<S>),
            Cuboid(Cuboid<S>),
            Cone(Cone<S>),
        }
    }

    scancsg::leaves! {
        enum Many<S> {
            Cuboid(Cuboid<S>),
            Polyhedron(Polyhedron<S, 8>),
        }
    }

    fn real<T: Scan<OrthographicRays<f32>>>() -> [usize; 2] {
        [size_of::<T>(), size_of::<T::View>() + size_of::<T::Row>()]
    }

    /// What the types themselves have, within a twentieth.
    #[test]
    fn memory_is_that_of_the_types() -> Result<(), Box<dyn Error>> {
        let few = "cylinder(h = 2, r1 = 1, r2 = 1); cube(size = [2, 2, 2]); cylinder(h = 4, r1 = 1, r2 = 0);";
        let many = "cube(size = [2, 2, 2]); cylinder($fn = 6, h = 2, r1 = 1, r2 = 1); cube(size = [1, 1, 9]);";
        let cases =
            [(few, real::<Program<Few<f32>, 3>>()), (many, real::<Program<Many<f32>, 3>>())];
        for (text, real) in cases {
            let made =
                program(&Model::of(lower(&parse(text)?, false)?.tree)?, NumberType::F32, FACES)?;
            let memory = made.memory();
            for (got, want) in [memory.program, memory.picture].into_iter().zip(real) {
                assert!(got.abs_diff(want) * 20 <= want, "{got} {want} {:?}", Kind::ALL);
            }
        }
        Ok(())
    }
}
