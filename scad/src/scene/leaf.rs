//! The solids of a scene, along the axes of their frames.

use super::cone::Frustum;
use super::convex::HalfSpaces;
use crate::error::Error;
use crate::map::{Map, Vector};
use crate::place::{Body, Placed};
use crate::tree::Form;
use scancsg::geom::{AffineMap, Axis, Line};
use scancsg::render::Rgb;
use scancsg::solid::{Cone, Cuboid, Cylinder, Scaled, Solid, Sphere, Torus};
use scancsg::span::{Crossing, Face, Shape, Span, SpanList};

/// The place of a span that a line doesn't have.
pub(super) const NOWHERE: Span<f64> = {
    let never = Crossing { t: f64::INFINITY, face: Face(0) };
    Span { enter: never, exit: never }
};

/// A solid of a scene.
#[derive(Debug)]
pub(super) struct Leaf {
    kind: Kind,
    pub(super) frame: usize,
    pub(super) axes: [Vector; 3],
    pub(super) color: Option<Rgb>,
    /// The number of its first face.
    pub(super) first: u16,
    /// The box around it, in the scene.
    pub(super) corners: [Vector; 2],
    /// Whether it is cut out of something: then the part is where its normals point to.
    is_cut: bool,
}

#[derive(Debug)]
enum Kind {
    Cuboid(Cuboid<f64>),
    Cylinder(Cylinder<f64>),
    Cone(Frustum),
    Sphere(Sphere<f64>),
    Torus(Torus<f64>),
    HalfSpaces(HalfSpaces),
    ScaledCylinder(Box<Scaled<Cylinder<f64>>>),
    ScaledCone(Box<Scaled<Cone<f64>>>),
    ScaledSphere(Box<Scaled<Sphere<f64>>>),
    ScaledTorus(Box<Scaled<Torus<f64>>>),
}

/// A line in the coordinates of a frame.
pub(super) fn into_frame(axes: &[Vector; 3], line: &Line<f64>) -> Line<f64> {
    let into = |vector: Vector| Vector::from(axes.map(|axis| axis.dot(vector)));
    Line { origin: into(line.origin), direction: into(line.direction) }
}

impl Leaf {
    pub(super) fn of(
        placed: &Placed,
        axes: [Vector; 3],
        first: u16,
        is_cut: bool,
    ) -> Result<Self, Error> {
        let kind = kind(&placed.body).map_err(|error| Error::argument(placed.line, error))?;
        let [low, high] = placed.body.bounds();
        let corner = |i: usize| {
            let pick = |a: f64, b: f64, bit: usize| if i >> bit & 1 == 0 { a } else { b };
            axes[0] * pick(low.x, high.x, 0)
                + axes[1] * pick(low.y, high.y, 1)
                + axes[2] * pick(low.z, high.z, 2)
        };
        let all = |pick: fn(f64, f64) -> f64| {
            (1..8).map(corner).fold(corner(0), |sum, next| {
                Vector::new(pick(sum.x, next.x), pick(sum.y, next.y), pick(sum.z, next.z))
            })
        };
        let corners = if placed.frame == 0 { [low, high] } else { [all(f64::min), all(f64::max)] };
        Ok(Self { kind, frame: placed.frame, axes, color: placed.color, first, corners, is_cut })
    }

    /// The number of the face behind its last one, if there is one.
    pub(super) fn next_face(&self) -> Option<u16> {
        let faces = match &self.kind {
            Kind::HalfSpaces(solid) => solid.count(),
            Kind::Cuboid(_) => Cuboid::<f64>::FACES,
            Kind::Cylinder(_) | Kind::ScaledCylinder(_) => Cylinder::<f64>::FACES,
            Kind::Cone(_) => Frustum::FACES,
            Kind::ScaledCone(_) => Cone::<f64>::FACES,
            Kind::Sphere(_) | Kind::ScaledSphere(_) => Sphere::<f64>::FACES,
            Kind::Torus(_) | Kind::ScaledTorus(_) => Torus::<f64>::FACES,
        };
        self.first.checked_add(faces)
    }

    /// The spans of a line in the frame's coordinates.
    pub(super) fn spans(&self, line: &Line<f64>) -> [Span<f64>; 2] {
        let mut list = SpanList::<f64, 2>::new();
        let (first, mut stack) = (Face(self.first), list.stack());
        match &self.kind {
            Kind::HalfSpaces(solid) => {
                return [solid.span(line, first).unwrap_or(NOWHERE), NOWHERE];
            }
            Kind::Cuboid(solid) => solid.spans(line, first, &mut stack),
            Kind::Cylinder(solid) => solid.spans(line, first, &mut stack),
            Kind::Cone(solid) => return [solid.span(line, first).unwrap_or(NOWHERE), NOWHERE],
            Kind::Sphere(solid) => solid.spans(line, first, &mut stack),
            Kind::Torus(solid) => solid.spans(line, first, &mut stack),
            Kind::ScaledCylinder(solid) => solid.spans(line, first, &mut stack),
            Kind::ScaledCone(solid) => solid.spans(line, first, &mut stack),
            Kind::ScaledSphere(solid) => solid.spans(line, first, &mut stack),
            Kind::ScaledTorus(solid) => solid.spans(line, first, &mut stack),
        }
        let at = |index: usize| list.get(index).copied().unwrap_or(NOWHERE);
        [at(0), at(1)]
    }

    /// The normal of a face of the scene.
    pub(super) fn normal(&self, face: Face, at: Vector) -> Vector {
        let face = Face(face.0 - self.first);
        let own = Vector::from(self.axes.map(|axis| axis.dot(at)));
        let normal = match &self.kind {
            Kind::HalfSpaces(solid) => solid.normal(face, own),
            Kind::Cuboid(solid) => solid.normal(face, own),
            Kind::Cylinder(solid) => solid.normal(face, own),
            Kind::Cone(solid) => solid.normal(face, own),
            Kind::Sphere(solid) => solid.normal(face, own),
            Kind::Torus(solid) => solid.normal(face, own),
            Kind::ScaledCylinder(solid) => solid.normal(face, own),
            Kind::ScaledCone(solid) => solid.normal(face, own),
            Kind::ScaledSphere(solid) => solid.normal(face, own),
            Kind::ScaledTorus(solid) => solid.normal(face, own),
        };
        let normal = if self.is_cut { -normal } else { normal };
        self.axes[0] * normal.x + self.axes[1] * normal.y + self.axes[2] * normal.z
    }
}

fn axis(index: usize) -> Axis {
    [Axis::X, Axis::Y, Axis::Z][index % 3]
}

fn kind(body: &Body) -> Result<Kind, String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    match body {
        Body::Cuboid([low, high]) => {
            Cuboid::between(*low, *high).map(Kind::Cuboid).map_err(|e| text(&e))
        }
        Body::Cylinder { axis: along, at, radius, ends } => {
            let solid = Cylinder::along(axis(*along), *at, *radius, ends[0], ends[1]);
            solid.map(Kind::Cylinder).map_err(|e| text(&e))
        }
        Body::Cone { axis: along, at, radii, ends } => {
            // What the exact one wouldn't be is an error here, too.
            let exact = Cone::along(axis(*along), *at, *radii, ends[0], ends[1]);
            exact.map_err(|e| text(&e))?;
            Ok(Kind::Cone(Frustum::of(*along, *at, *radii, *ends)))
        }
        Body::Sphere { center, radius } => {
            Sphere::around(*center, *radius).map(Kind::Sphere).map_err(|e| text(&e))
        }
        Body::Torus { axis: along, center, ring, tube } => {
            let solid = Torus::along(axis(*along), *center, *ring, *tube);
            solid.map(Kind::Torus).map_err(|e| text(&e))
        }
        Body::Convex(convex) => Ok(Kind::HalfSpaces(HalfSpaces::of(convex))),
        Body::Stretched(form, map) => stretched(form, map),
    }
}

fn stretched(form: &Form, map: &Map) -> Result<Kind, String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let map = AffineMap::with_columns(map.columns, map.shift).map_err(|e| text(&e))?;
    match form {
        Form::Cylinder { radius, heights: [low, high] } => {
            let solid =
                Cylinder::along(Axis::Z, [0.0; 2], *radius, *low, *high).map_err(|e| text(&e))?;
            Ok(Kind::ScaledCylinder(Box::new(Scaled::new(solid, map))))
        }
        Form::Cone { radii, heights: [low, high] } => {
            let solid =
                Cone::along(Axis::Z, [0.0; 2], *radii, *low, *high).map_err(|e| text(&e))?;
            Ok(Kind::ScaledCone(Box::new(Scaled::new(solid, map))))
        }
        Form::Sphere { radius } => {
            let solid =
                Sphere::around(Vector::new(0.0, 0.0, 0.0), *radius).map_err(|e| text(&e))?;
            Ok(Kind::ScaledSphere(Box::new(Scaled::new(solid, map))))
        }
        Form::Torus { ring, tube } => {
            let solid = Torus::along(Axis::Z, Vector::new(0.0, 0.0, 0.0), *ring, *tube);
            Ok(Kind::ScaledTorus(Box::new(Scaled::new(solid.map_err(|e| text(&e))?, map))))
        }
        Form::Cuboid(_) | Form::Convex(_) => {
            Err("a solid with flat faces is never stretched".into())
        }
    }
}
