//! Solids as parts of a program: the byte of their kind, and their numbers.

use super::kind::Kind;
use super::leaf::Leaf;
use super::numbers::{NumberType, Writer};
use crate::map::{Map, Vector};
use crate::place::Body;
use crate::tree::{Convex, Form};
use scancsg::program::{BytesError, Program};
use scancsg::scalar::{I16F16, Scalar};

/// The kind of a solid, and its numbers. Of a polyhedron, these faces.
pub(super) fn write(body: &Body, faces: &[(Vector, f64)], to: &mut Writer) -> Kind {
    match body {
        Body::Cuboid(corners) => {
            corners.iter().for_each(|corner| to.vector(*corner));
            Kind::Cuboid
        }
        Body::Cylinder { axis, at, radius, ends } => {
            round(to, Kind::Cylinder, *axis, *at, &[*radius], *ends)
        }
        Body::Cone { axis, at, radii, ends } => round(to, Kind::Cone, *axis, *at, radii, *ends),
        Body::Sphere { center, radius } => {
            to.vector(*center);
            to.number(*radius);
            Kind::Sphere
        }
        Body::Torus { axis, center, ring, tube } => {
            to.vector(*center);
            to.bytes.push(*axis as u8);
            to.number(*ring);
            to.number(*tube);
            Kind::Torus
        }
        Body::Convex(convex) => {
            polyhedron(convex, faces, to);
            Kind::Polyhedron
        }
        Body::Stretched(form, map) => stretched(form, map, to),
    }
}

/// A point of the axis, the radii, the axis, and where it ends.
fn round(
    to: &mut Writer,
    kind: Kind,
    axis: usize,
    [u, v]: [f64; 2],
    radii: &[f64],
    ends: [f64; 2],
) -> Kind {
    to.vector(match axis {
        0 => Vector::new(0.0, u, v),
        1 => Vector::new(u, 0.0, v),
        _ => Vector::new(u, v, 0.0),
    });
    radii.iter().for_each(|radius| to.number(*radius));
    to.bytes.push(axis as u8);
    ends.into_iter().for_each(|end| to.number(end));
    kind
}

fn polyhedron(convex: &Convex, faces: &[(Vector, f64)], to: &mut Writer) {
    to.bytes.push(faces.len() as u8);
    for (normal, offset) in faces {
        to.direction(*normal);
        to.number(*offset);
    }
    let all = |pick: fn(f64, f64) -> f64| {
        let pick =
            |a: Vector, b: Vector| Vector::new(pick(a.x, b.x), pick(a.y, b.y), pick(a.z, b.z));
        convex.corners.iter().copied().reduce(pick).unwrap_or(Vector::new(0.0, 0.0, 0.0))
    };
    let [low, high] = [all(f64::min), all(f64::max)];
    // Rounded planes meet a little beside the corners.
    let room = to.number_type.room(low.max_abs().max(high.max_abs()));
    to.vector(low.map(|part| part - room));
    to.vector(high.map(|part| part + room));
}

fn stretched(form: &Form, map: &Map, to: &mut Writer) -> Kind {
    let [x, y, z] = map.columns.map(|column| column.to_array());
    for row in 0..3 {
        [x, y, z].into_iter().for_each(|column| to.number(column[row]));
    }
    to.vector(map.shift);
    let place = to.bytes.len();
    to.bytes.push(0);
    let origin = Vector::new(0.0, 0.0, 0.0);
    let inner = match form {
        Form::Cylinder { radius, heights } => {
            round(to, Kind::Cylinder, 2, [0.0; 2], &[*radius], *heights)
        }
        Form::Cone { radii, heights } => round(to, Kind::Cone, 2, [0.0; 2], radii, *heights),
        Form::Torus { ring, tube } => {
            let body = Body::Torus { axis: 2, center: origin, ring: *ring, tube: *tube };
            write(&body, &[], to)
        }
        // Solids with flat faces are never stretched.
        Form::Sphere { .. } | Form::Cuboid(_) | Form::Convex(_) => {
            let radius = if let Form::Sphere { radius } = form { *radius } else { 0.0 };
            write(&Body::Sphere { center: origin, radius }, &[], to)
        }
    };
    to.bytes[place] = inner.tag();
    inner.scaled()
}

/// Whether a device takes a part: it alone as a program, read as devices read.
pub(super) fn check(number: NumberType, kind: Kind, numbers: &[u8]) -> Result<(), BytesError> {
    let length = (super::HEADER + 2 + numbers.len()) as u16;
    let mut bytes = super::header(number, length, 0);
    bytes.extend([kind.tag(), 0]);
    bytes.extend(numbers);
    match number {
        NumberType::F32 => read::<f32>(&bytes),
        NumberType::I16F16 => read::<I16F16>(&bytes),
    }
}

fn read<S: Scalar>(bytes: &[u8]) -> Result<(), BytesError> {
    Program::<Leaf<S>, 1>::from_bytes(bytes).map(|_| ())
}
