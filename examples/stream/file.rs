//! A part from a file: a program in bytes, as `docs/program.md` describes it.

use crate::args::Number;
use crate::host::send::number_name;
use scancsg::program::{BytesError, Program};
use scancsg::scalar::Scalar;
use scancsg::solid::{Cone, Cuboid, Cylinder, HalfSpace, Polyhedron, Scaled, Sphere, Torus};
use std::fs;
use std::path::Path;

scancsg::leaves! {
    /// All solids that have a form as bytes. What is round may be scaled; flat faces need no scale, they are others then.
    pub enum Leaf<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
        Cone(Cone<S>),
        Torus(Torus<S>),
        HalfSpace(HalfSpace<S>),
        Polyhedron(Polyhedron<S, 32>),
        ScaledCylinder(Scaled<Cylinder<S>>),
        ScaledSphere(Scaled<Sphere<S>>),
        ScaledCone(Scaled<Cone<S>>),
        ScaledTorus(Scaled<Torus<S>>),
    }
}

/// A part of up to 512 solids.
pub type Part<S> = Program<Leaf<S>, 512, 254>;

/// The bytes of a part, and the number type that they are in.
pub fn read(path: &Path) -> Result<(Vec<u8>, Number), String> {
    let bytes =
        fs::read(path).map_err(|error| format!("can't read {}: {error}", path.display()))?;
    let code = match bytes.get(..4) {
        Some([b'S', b'P', _, code]) => *code,
        _ => {
            return Err(format!(
                "{}: {}; `scancsg-scad --program` makes one of an OpenSCAD part",
                path.display(),
                BytesError::Magic
            ));
        }
    };
    let number = match code {
        32 => Number::F32,
        64 => Number::F64,
        16 => Number::I16f16,
        _ => {
            return Err(format!(
                "{}: it is in {}; only f32, f64 and I16F16 are rendered here",
                path.display(),
                number_name(code)
            ));
        }
    };
    Ok((bytes, number))
}

/// Makes the part.
pub fn part<S: Scalar>(path: &Path, bytes: &[u8]) -> Result<Box<Part<S>>, String> {
    let part = Part::from_bytes(bytes);
    part.map(Box::new).map_err(|error| format!("{}: {error}", path.display()))
}
