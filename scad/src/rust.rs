//! A part as a constant of Rust: typed solids of scancsg, checked while they are compiled.

use crate::error::Error;
use crate::map::{Map, Vector};
use crate::place::{Body, Model, Placed};
use crate::tree::{Form, Tree};
use std::fmt::Write;

/// The most faces of a polyhedron in a constant: its corners are found while it is compiled, in N⁴ steps.
const MOST_FACES: usize = 40;

/// The text of a module with the part as `pub const NAME`, in `f32`.
///
/// Solids of one kind that are united become an array. What is in a turned frame has oblique axes.
///
/// ```
/// use scancsg_scad::{Model, lower, parse, rust};
///
/// let part = lower(&parse("difference() { cube(size = [3, 2, 1]); cylinder(h = 9, r1 = 1, r2 = 1); }")?, false)?;
/// let text = rust(&Model::of(part.tree)?, "PART")?;
/// assert!(text.contains("pub const PART: Difference<Cuboid<f32>, Cylinder<f32>> = Difference::new("));
/// # Ok::<(), scancsg_scad::Error>(())
/// ```
///
/// # Errors
/// An [`Error`] for an empty part, and for a polyhedron of more than 40 faces.
pub fn rust(model: &Model, name: &str) -> Result<String, Error> {
    let part = expression(model, &model.tree)?.ok_or_else(|| Error::limit("the part is empty"))?;
    let mut text = String::from(
        "// Made by scancsg-scad.\n\n#[allow(unused_imports)]\nuse scancsg::{constant, geom::{AffineMap, vec3}, render::Rgb, solid::*};\n\n",
    );
    let _ = write!(
        text,
        "/// The part.\n#[allow(clippy::type_complexity)]\npub const {name}: {} = {};\n",
        part.kind, part.value
    );
    Ok(text)
}

/// A value and its type.
struct Expression {
    kind: String,
    value: String,
}

impl Expression {
    fn pair(operation: &str, left: Self, right: Self) -> Self {
        let kind = format!("{operation}<{}, {}>", left.kind, right.kind);
        Self { kind, value: format!("{operation}::new({}, {})", left.value, right.value) }
    }
}

fn expression(model: &Model, tree: &Tree<Placed>) -> Result<Option<Expression>, Error> {
    match tree {
        Tree::Empty => Ok(None),
        Tree::Solid(solid) => solid_expression(model, solid).map(Some),
        Tree::Union(members) => united(model, members.iter()),
        Tree::Intersection(members) => {
            let mut all = Vec::new();
            for member in members {
                let Some(member) = expression(model, member)? else { return Ok(None) };
                all.push(member);
            }
            Ok(all.into_iter().reduce(|left, right| Expression::pair("Intersection", left, right)))
        }
        Tree::Difference(first, others) => {
            let Some(first) = expression(model, first)? else { return Ok(None) };
            Ok(Some(match united(model, others.iter())? {
                Some(cutters) => Expression::pair("Difference", first, cutters),
                None => first,
            }))
        }
    }
}

/// Members of one type are an array; the arrays are united in pairs.
fn united<'a>(
    model: &Model,
    members: impl Iterator<Item = &'a Tree<Placed>>,
) -> Result<Option<Expression>, Error> {
    let mut kinds: Vec<(String, Vec<String>)> = Vec::new();
    for member in members {
        let Some(Expression { kind, value }) = expression(model, member)? else { continue };
        match kinds.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, values)) => values.push(value),
            None => kinds.push((kind, vec![value])),
        }
    }
    let array = |(kind, values): (String, Vec<String>)| match &values[..] {
        [value] => Expression { kind, value: value.clone() },
        _ => Expression {
            kind: format!("[{kind}; {}]", values.len()),
            value: format!("[{}]", values.join(", ")),
        },
    };
    Ok(kinds.into_iter().map(array).reduce(|left, right| Expression::pair("Union", left, right)))
}

fn solid_expression(model: &Model, solid: &Placed) -> Result<Expression, Error> {
    let axes = model.frames.get(solid.frame).copied().unwrap_or(Map::IDENTITY.columns);
    let frame = Map { columns: axes, shift: Vector::new(0.0, 0.0, 0.0) };
    let is_turned = solid.frame != 0;
    let (kind, value) = match &solid.body {
        Body::Cuboid([low, high]) if !is_turned => {
            ("Cuboid<f32>".into(), format!("Cuboid::<f32>::new({}, {})", point(*low), point(*high)))
        }
        Body::Cuboid([low, high]) => {
            let unit = |i: usize| Map::IDENTITY.columns[i];
            let planes = (0..3)
                .flat_map(|i| [(-unit(i), -unit(i).dot(*low)), (unit(i), unit(i).dot(*high))]);
            polyhedron(&planes.collect::<Vec<_>>(), &frame)
        }
        Body::Cylinder { axis, at, radius, ends } => (
            "Cylinder<f32>".into(),
            if is_turned {
                let [from, to] = ends.map(|end| point(frame.point(on_axis(*axis, *at, end))));
                format!("Cylinder::<f32>::between({from}, {to}, {})", number(*radius))
            } else {
                let [u, v] = at.map(number);
                let [low, high] = ends.map(number);
                format!(
                    "Cylinder::<f32>::along_{}({u}, {v}, {}, {low}, {high})",
                    letter(*axis),
                    number(*radius)
                )
            },
        ),
        Body::Cone { axis, at, radii, ends } => {
            let radii = format!("[{}, {}]", number(radii[0]), number(radii[1]));
            (
                "Cone<f32>".into(),
                if is_turned {
                    let [from, to] = ends.map(|end| point(frame.point(on_axis(*axis, *at, end))));
                    format!("Cone::<f32>::between({from}, {to}, {radii})")
                } else {
                    let [u, v] = at.map(number);
                    let [low, high] = ends.map(number);
                    format!(
                        "Cone::<f32>::along_{}({u}, {v}, {radii}, {low}, {high})",
                        letter(*axis)
                    )
                },
            )
        }
        Body::Sphere { center, radius } => (
            "Sphere<f32>".into(),
            format!("Sphere::<f32>::new({}, {})", point(frame.point(*center)), number(*radius)),
        ),
        Body::Torus { axis, center, ring, tube } => {
            let (center, axis) = (point(frame.point(*center)), point(axes[*axis]));
            (
                "Torus<f32>".into(),
                format!(
                    "Torus::<f32>::new({center}, {axis}, {}, {})",
                    number(*ring),
                    number(*tube)
                ),
            )
        }
        Body::Convex(convex) => {
            if convex.planes.len() > MOST_FACES {
                return Err(Error::not_modelled(
                    solid.line,
                    format!("a constant of {} faces", convex.planes.len()),
                ));
            }
            polyhedron(&convex.planes, &frame)
        }
        Body::Stretched(form, map) => stretched(form, map),
    };
    let mut found = Expression { kind, value };
    if !found.value.starts_with("Scaled") {
        found.value = format!("constant!({})", found.value);
    }
    if let Some(color) = solid.color {
        found.kind = format!("Painted<{}>", found.kind);
        found.value = format!(
            "Painted::new({}, Rgb::new({}, {}, {}))",
            found.value, color.r, color.g, color.b
        );
    }
    Ok(found)
}

fn polyhedron(planes: &[(Vector, f64)], frame: &Map) -> (String, String) {
    let face = |(normal, offset): &(Vector, f64)| {
        format!(
            "constant!(HalfSpace::<f32>::new({}, {}))",
            point(frame.direction(*normal)),
            number(*offset)
        )
    };
    let faces: Vec<String> = planes.iter().map(face).collect();
    let kind = format!("Polyhedron<f32, {}>", planes.len());
    (kind, format!("Polyhedron::<f32, {}>::new([{}])", planes.len(), faces.join(", ")))
}

fn stretched(form: &Form, map: &Map) -> (String, String) {
    let zero = number(0.0);
    let (kind, inner) = match form {
        Form::Cylinder { radius, heights } => {
            let [low, high] = heights.map(number);
            (
                "Cylinder",
                format!(
                    "Cylinder::<f32>::along_z({zero}, {zero}, {}, {low}, {high})",
                    number(*radius)
                ),
            )
        }
        Form::Cone { radii, heights } => {
            let ([lower, upper], [low, high]) = (radii.map(number), heights.map(number));
            (
                "Cone",
                format!("Cone::<f32>::along_z({zero}, {zero}, [{lower}, {upper}], {low}, {high})"),
            )
        }
        Form::Torus { ring, tube } => {
            let origin = point(Vector::new(0.0, 0.0, 0.0));
            (
                "Torus",
                format!("Torus::<f32>::along_z({origin}, {}, {})", number(*ring), number(*tube)),
            )
        }
        // Solids with flat faces are never stretched.
        Form::Sphere { .. } | Form::Cuboid(_) | Form::Convex(_) => {
            let radius = if let Form::Sphere { radius } = form { *radius } else { 1.0 };
            let origin = point(Vector::new(0.0, 0.0, 0.0));
            ("Sphere", format!("Sphere::<f32>::new({origin}, {})", number(radius)))
        }
    };
    let columns = map.columns.map(point).join(", ");
    let map = format!("constant!(AffineMap::<f32>::new([{columns}], {}))", point(map.shift));
    (format!("Scaled<{kind}<f32>>"), format!("Scaled::new(constant!({inner}), {map})"))
}

fn on_axis(axis: usize, [u, v]: [f64; 2], end: f64) -> Vector {
    match axis {
        0 => Vector::new(end, u, v),
        1 => Vector::new(u, end, v),
        _ => Vector::new(u, v, end),
    }
}

fn letter(axis: usize) -> char {
    ['x', 'y', 'z'][axis % 3]
}

fn point(point: Vector) -> String {
    let [x, y, z] = point.to_array().map(number);
    format!("vec3({x}, {y}, {z})")
}

/// As short as the bits of an `f32` allow.
fn number(number: f64) -> String {
    format!("{:?}", number as f32 + 0.0)
}
