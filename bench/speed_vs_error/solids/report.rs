//! The solids' share of the tables and files, and their targets.

use super::measure::{Part, Row};
use super::subject::Kind;
use crate::methods::ULP;
use crate::report;

/// The figures, method by method, in 80 columns.
pub fn table(parts: &[Part]) -> String {
    let blocks = parts.iter().flat_map(|part| {
        part.methods.iter().enumerate().map(move |(method, label)| {
            let rows = part.rows.iter().filter(move |row| row.method == method);
            let title = format!("{}, {}", part.name, label.label());
            report::block(&title, label.unit, rows.map(|row| (row.kind.name(), row.summary())))
        })
    });
    blocks.collect()
}

/// Every method on every set.
pub fn csv(parts: &[Part]) -> String {
    let row = |part: &Part, row: &Row| {
        let label = &part.methods[row.method];
        let set = format!("{}_{}", part.name, row.kind.name());
        report::csv_row([&set, label.name, label.number, label.unit], &row.accuracy, row.cost)
    };
    parts.iter().flat_map(|part| part.rows.iter().map(move |of| row(part, of))).collect()
}

/// Method against method.
pub fn markdown(parts: &[Part], rays: usize) -> String {
    let mut text = format!(
        "\n# Other solids\n\n\
         {rays} rays of each kind at each kind of solids, which stand up to 3 units from the scene's origin: \
         boxes; polyhedra of eight faces, half of these across coordinate axes or sums of two; cones along \
         coordinate axes, half of them with a tip; ellipsoids with semi-axes from 1/2 to 2 in any direction; \
         tori of which half lie across coordinate axes, with tubes of 0.1 to 0.9 of the ring. Rays come from 3 \
         to 10 sizes away (\"ordinary\") or from 10³ to 10⁶; pass the surface, or an edge of a box or a \
         polyhedron, by 10⁻¹ to 10⁻⁶ of the size (\"grazing\"); run 10⁻² to 10⁻⁶ rad off a face, a cone's side \
         or axis, a torus's axis or plane (\"parallel\"); start inside or on the surface, where parameters near \
         zero make large ulps of small errors.\n\n\
         Textbook methods are Kay and Kajiya's slabs, Cyrus and Beck's clipping, quadratics with b² − 4ac, \
         and for the torus Ferrari's solution as in *Graphics Gems*. parry3d is asked about cones that have a \
         tip. References are computed in `f64` from the point of the line nearest to the solid's middle; those \
         of cones and tori were compared with exact arithmetic. A class is how many spans of the ray lie \
         ahead; of `I16F16`, how many the line has. It is judged where it doesn't change if the solid is 10⁻⁶ \
         larger or smaller; for ellipsoids in `I16F16`, whose rays are rounded to their own frame's grid, 10⁻⁴. \
         In `I16F16`, an ellipsoid is made of a sphere of radius 16.\n"
    );
    for part in parts {
        for (kind, name) in Kind::ALL {
            let rows = part.rows.iter().filter(|row| row.kind == kind).map(|row| {
                let label = &part.methods[row.method];
                (label.label(), label.unit, row.summary())
            });
            text += &report::section(&format!("{} {name}", part.name), rows);
        }
    }
    text
}

/// The targets that the crate's methods fall short of, in words.
pub fn shortfalls(part: &Part) -> Vec<String> {
    let shipped = part.rows.iter().filter(|row| part.methods[row.method].is_shipped);
    shipped.flat_map(|row| shortfalls_of(part, row)).collect()
}

fn shortfalls_of(part: &Part, row: &Row) -> Vec<String> {
    let (label, accuracy) = (&part.methods[row.method], &row.accuracy);
    let is_fixed = label.unit != ULP;
    let wrong = accuracy.false_hits + accuracy.false_misses;
    let mut figures = vec![
        ("wrong classes, as a part", wrong as f64 / accuracy.judged as f64, part.limits.wrong),
        ("rays not answered", accuracy.other() as f64, 0.0),
    ];
    if row.kind == Kind::Ordinary {
        let limit = part.limits.p99.of_kind(is_fixed);
        for (what, errors) in
            [("t_in, p99", &accuracy.errors[0]), ("t_out, p99", &accuracy.errors[1])]
        {
            let p99 = testkit::ulp::percentiles(errors).map_or(f64::INFINITY, |[_, p99, _]| p99);
            figures.push((what, p99, limit));
        }
    }
    // Of no rays, the part that is wrong isn't a number, and reaches no limit.
    let missed = figures.into_iter().filter(|(_, figure, limit)| figure > limit || figure.is_nan());
    let text = |(what, figure, limit)| {
        let set = format!("{} {}", part.name, row.kind.name());
        format!("{set:20} {} {what}: {figure:.3e} > {limit}", label.number)
    };
    missed.map(text).collect()
}
