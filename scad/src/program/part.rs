//! Solids as parts of a program: those of scancsg, in the program's number type.

use super::leaf::{FACES, Leaf};
use crate::map::{Map, Vector};
use crate::place::Body;
use crate::tree::{Convex, Form};
use scancsg::geom::{AffineMap, Axis, Line, Vec3};
use scancsg::program::{BytesError, Coded, Program, Reader, Writer};
use scancsg::scalar::Scalar;
use scancsg::solid::{Bounds, Cone, Cuboid, Cylinder, Scaled, Solid, Sphere, Torus};
use scancsg::span::{Face, Shape, SpanStack};

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

fn number<S: Scalar>(number: f64) -> S {
    // No zero has a sign.
    S::from_f64(number + 0.0)
}

fn vector<S: Scalar>(vector: Vector) -> Vec3<S> {
    vector.map(number)
}

/// A solid, if the number type has room for it. Of a polyhedron, these faces.
pub(super) fn part<S: Scalar<Unit: Scalar>>(
    body: &Body,
    faces: &[(Vector, f64)],
) -> Option<Leaf<S>> {
    match body {
        Body::Cuboid([low, high]) => {
            Cuboid::between(vector(*low), vector(*high)).ok().map(Leaf::Cuboid)
        }
        Body::Cylinder { axis, at, radius, ends } => {
            cylinder(*axis, *at, *radius, *ends).map(Leaf::Cylinder)
        }
        Body::Cone { axis, at, radii, ends } => cone(*axis, *at, *radii, *ends).map(Leaf::Cone),
        Body::Sphere { center, radius } => sphere(*center, *radius).map(Leaf::Sphere),
        Body::Torus { axis, center, ring, tube } => {
            torus(*axis, *center, *ring, *tube).map(Leaf::Torus)
        }
        Body::Convex(convex) => polyhedron(convex, faces),
        Body::Stretched(form, map) => stretched(form, map),
    }
}

fn cylinder<S: Scalar>(
    axis: usize,
    at: [f64; 2],
    radius: f64,
    [low, high]: [f64; 2],
) -> Option<Cylinder<S>> {
    let axis = *AXES.get(axis)?;
    Cylinder::along(axis, at.map(number), number(radius), number(low), number(high)).ok()
}

fn cone<S: Scalar>(
    axis: usize,
    at: [f64; 2],
    radii: [f64; 2],
    [low, high]: [f64; 2],
) -> Option<Cone<S>> {
    let axis = *AXES.get(axis)?;
    Cone::along(axis, at.map(number), radii.map(number), number(low), number(high)).ok()
}

fn sphere<S: Scalar>(center: Vector, radius: f64) -> Option<Sphere<S>> {
    Sphere::around(vector(center), number(radius)).ok()
}

fn torus<S: Scalar>(axis: usize, center: Vector, ring: f64, tube: f64) -> Option<Torus<S>> {
    Torus::along(*AXES.get(axis)?, vector(center), number(ring), number(tube)).ok()
}

fn stretched<S: Scalar>(form: &Form, map: &Map) -> Option<Leaf<S>> {
    const Z: usize = 2;
    let origin = Vector::new(0.0, 0.0, 0.0);
    let map = AffineMap::with_columns(map.columns.map(vector), vector(map.shift)).ok()?;
    Some(match form {
        Form::Cylinder { radius, heights } => {
            Leaf::ScaledCylinder(Scaled::new(cylinder(Z, [0.0; 2], *radius, *heights)?, map))
        }
        Form::Cone { radii, heights } => {
            Leaf::ScaledCone(Scaled::new(cone(Z, [0.0; 2], *radii, *heights)?, map))
        }
        Form::Torus { ring, tube } => {
            Leaf::ScaledTorus(Scaled::new(torus(Z, origin, *ring, *tube)?, map))
        }
        Form::Sphere { radius } => Leaf::ScaledSphere(Scaled::new(sphere(origin, *radius)?, map)),
        // Solids with flat faces are never stretched.
        Form::Cuboid(_) | Form::Convex(_) => return None,
    })
}

/// Some faces of a polyhedron, and corners of a box around all of it.
#[derive(Clone, Copy)]
struct Facets<'a, S> {
    faces: &'a [(Vector, f64)],
    corners: [Vec3<S>; 2],
}

impl<S: Scalar> Shape for Facets<'_, S> {
    type Scalar = S;
    const SPANS: usize = 1;
    const FACES: u16 = FACES as u16;
}

/// Only its bytes count: what is read of them is a polyhedron. Constructors of polyhedra compute a box, which some of
/// the faces may not have.
impl<S: Scalar> Solid for Facets<'_, S> {
    fn spans(&self, _: &Line<S>, _: Face, _: &mut SpanStack<'_, S>) {}

    fn normal(&self, _: Face, _: Vec3<S>) -> Vec3<S> {
        Vec3::ZERO
    }

    fn bounds(&self) -> Bounds<S> {
        let [low, high] = self.corners;
        Bounds::Box { low, high }
    }
}

impl<S: Scalar<Unit: Scalar>> Coded for Facets<'_, S> {
    fn has_kind(_: u8) -> bool {
        false
    }

    fn kind(&self) -> u8 {
        7
    }

    fn write(&self, to: &mut Writer<'_>) -> Result<(), BytesError> {
        to.bytes(&[self.faces.len() as u8])?;
        for (normal, offset) in self.faces {
            match normal.to_array().into_iter().position(|part| part == 1.0) {
                Some(axis) => to.bytes(&[axis as u8])?,
                None => {
                    to.bytes(&[3])?;
                    to.vector::<S::Unit>(vector(*normal))?;
                }
            }
            to.number::<S>(number(*offset))?;
        }
        self.corners.into_iter().try_for_each(|corner| to.vector(corner))
    }

    fn read(_: u8, _: &mut Reader<'_>) -> Result<Self, BytesError> {
        Err(BytesError::Kind)
    }
}

fn polyhedron<S: Scalar<Unit: Scalar>>(
    convex: &Convex,
    faces: &[(Vector, f64)],
) -> Option<Leaf<S>> {
    let all = |pick: fn(f64, f64) -> f64| {
        let pick =
            |a: Vector, b: Vector| Vector::new(pick(a.x, b.x), pick(a.y, b.y), pick(a.z, b.z));
        convex.corners.iter().copied().reduce(pick)
    };
    let (low, high) = (all(f64::min)?, all(f64::max)?);
    // Rounded planes meet a little beside the corners.
    let size = low.max_abs().max(high.max_abs());
    let room = size * f64::from(f32::EPSILON) * 16.0 + 2.0 * S::ROUNDING.to_f64();
    let corners = [low.map(|part| part - room), high.map(|part| part + room)].map(vector::<S>);
    let mut buffer = [0; 512];
    let bytes = Program::<_, 1>::new(Facets { faces, corners }).to_bytes(&mut buffer).ok()?;
    let read = Program::<Leaf<S>, 1>::from_bytes(bytes).ok()?;
    read.part(0).ok().copied()
}

/// The largest number of a solid.
pub(super) fn largest(body: &Body) -> f64 {
    let numbers = match body {
        Body::Cuboid(corners) => corners.map(Vector::to_array).concat(),
        Body::Cylinder { at, radius, ends, .. } => [&at[..], ends, &[*radius]].concat(),
        Body::Cone { at, radii, ends, .. } => [at, ends, radii].map(|pair| *pair).concat(),
        Body::Sphere { center, radius } => vec![center.max_abs(), *radius],
        Body::Torus { center, ring, tube, .. } => vec![center.max_abs(), *ring, *tube],
        Body::Convex(convex) => convex.corners.iter().map(|corner| corner.max_abs()).collect(),
        Body::Stretched(_, map) => {
            map.columns.iter().chain([&map.shift]).map(|column| column.max_abs()).collect()
        }
    };
    numbers.into_iter().map(f64::abs).fold(0.0, f64::max)
}
