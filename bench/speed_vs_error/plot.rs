//! The Pareto plot: time across, error up; the lower left is best.

use crate::methods::ULP;
use crate::rays::Group;
use crate::results::{Results, Row};
use crate::solids::{self, Kind};
use crate::splines;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;
use testkit::ulp::percentiles;

/// Some rays at cylinders of a kind that tells methods apart.
struct OfCylinders {
    title: &'static str,
    shows: fn(&Row) -> bool,
    target_ulps: f64,
}

const CYLINDERS: [OfCylinders; 4] = [
    OfCylinders {
        title: "ordinary rays",
        shows: |row| row.set.group == Group::Benign,
        target_ulps: 2.0,
    },
    OfCylinders {
        title: "from 10³ to 10⁶ radii away",
        shows: |row| row.set.group == Group::Far,
        target_ulps: 2.0,
    },
    OfCylinders {
        title: "grazing by 10⁻⁵ radii",
        shows: |row| row.set.name == "graze_1e-5",
        target_ulps: 2.0,
    },
    OfCylinders {
        title: "10⁻² to 10⁻⁶ rad off the axis",
        shows: |row| row.set.group == Group::NearParallel,
        target_ulps: 2.5,
    },
];

/// Distinguishable by colour-blind readers too (Okabe, Ito 2008); with the shape of the mark, which
/// says what the error was counted in before it was converted.
const COLORS: [RGBColor; 8] = [
    RGBColor(0, 0, 0),
    RGBColor(230, 159, 0),
    RGBColor(0, 114, 178),
    RGBColor(86, 180, 233),
    RGBColor(130, 130, 130),
    RGBColor(204, 121, 167),
    RGBColor(0, 158, 115),
    RGBColor(213, 94, 0),
];

/// What lies below is drawn at the edge.
const LEAST_ERROR: f64 = 0.1;
const TARGET_RATIO: f64 = 1.5;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// What is drawn in a panel.
struct Panel {
    title: String,
    marks: Vec<Mark>,
    /// Time and error; no time is a target of other solids than cylinders.
    target: [f64; 2],
}

/// Where a method is in a panel.
struct Mark {
    method: usize,
    ratio: f64,
    error: f64,
    /// Whether it gives every ray its class that was judged.
    reliable: bool,
}

pub fn write(
    results: &Results,
    solids: &[solids::Part],
    splines: &splines::Results,
    path: &Path,
) -> Result<(), Box<dyn Error>> {
    let cylinders = CYLINDERS.map(|OfCylinders { title, shows, target_ulps }| Panel {
        title: title.into(),
        marks: marks(results, shows),
        target: [TARGET_RATIO, target_ulps],
    });
    let mut others: Vec<Panel> =
        solids.iter().map(|part| of_solid(part, Kind::Ordinary, results)).collect();
    others.extend(solids.last().map(|part| of_solid(part, Kind::Grazing, results)));
    let all = || cylinders.iter().chain(&others).flat_map(|panel| &panel.marks);
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(10.0, f64::max);
    let ratio_limit = 1.6 * largest(&mut all().map(|mark| mark.ratio));
    let error_limit = 4.0 * largest(&mut all().map(|mark| mark.error).filter(|e| e.is_finite()));

    let root = SVGBackend::new(path, (900, 1800)).into_drawing_area();
    root.fill(&WHITE)?;
    let (rays, splines_area) = root.split_vertically(1440);
    let (plots, legend) = rays.split_vertically(1280);
    let (above, below) = plots.split_vertically(720);
    let areas = [above.split_evenly((2, 2)), below.split_evenly((2, 3))].concat();
    for (area, panel) in areas.iter().zip(cylinders.iter().chain(&others)) {
        draw_panel(area, panel, results, [ratio_limit, error_limit])?;
    }
    draw_legend(&legend, results)?;
    splines::draw(&splines_area, splines)?;
    root.present()?;
    Ok(())
}

fn marks(results: &Results, shows: fn(&Row) -> bool) -> Vec<Mark> {
    (0..results.methods.len())
        .filter_map(|method| {
            let rows: Vec<&Row> =
                results.rows.iter().filter(|row| row.method == method && shows(row)).collect();
            let p99 = |end: usize| {
                let errors: Vec<f64> =
                    rows.iter().flat_map(|row| row.accuracy.in_ulps(end)).copied().collect();
                percentiles(&errors).map(|[_, p99, _]| p99)
            };
            let error = [p99(0), p99(1)].into_iter().flatten().reduce(f64::max)?;
            let logs: Vec<f64> = rows.iter().filter_map(|row| Some(row.cost?.ratio.ln())).collect();
            let ratio = (logs.iter().sum::<f64>() / logs.len() as f64).exp();
            let reliable =
                rows.iter().all(|row| row.accuracy.false_hits + row.accuracy.false_misses == 0);
            Some(Mark { method, ratio, error: error.max(LEAST_ERROR), reliable })
        })
        .collect()
}

/// A method has the mark of that of cylinders with the same name.
fn of_solid(part: &solids::Part, kind: Kind, results: &Results) -> Panel {
    let mark = |row: &solids::Row| {
        let label = part.methods[row.method].label();
        let accuracy = &row.accuracy;
        Some(Mark {
            method: results.methods.iter().position(|method| method.label() == label)?,
            ratio: row.cost?.ratio,
            error: accuracy.p99_ulps()?.max(LEAST_ERROR),
            reliable: accuracy.false_hits + accuracy.false_misses == 0,
        })
    };
    Panel {
        title: format!("{}, {}", part.name, kind.name()),
        marks: part.rows.iter().filter(|row| row.kind == kind).filter_map(mark).collect(),
        target: [f64::INFINITY, part.limits.p99.float],
    }
}

fn draw_panel(
    area: &Area<'_>,
    panel: &Panel,
    results: &Results,
    [ratio_limit, error_limit]: [f64; 2],
) -> Result<(), Box<dyn Error>> {
    let mut chart = ChartBuilder::on(area)
        .caption(&panel.title, ("sans-serif", 17))
        .margin(10)
        .margin_right(22)
        .x_label_area_size(44)
        .y_label_area_size(62)
        .build_cartesian_2d(
            (0.5..ratio_limit).log_scale(),
            (0.7 * LEAST_ERROR..error_limit).log_scale(),
        )?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .x_desc("time, multiple of the textbook formula's")
        .y_desc("error, p99 in ulps of an f32")
        .x_label_formatter(&|ratio| format!("{ratio}"))
        .y_label_formatter(&|error| match *error {
            error if error >= 1e3 => format!("{error:.0e}"),
            error => format!("{error}"),
        })
        .draw()?;
    let [ratio, error] = panel.target;
    let target = [(0.5, 0.7 * LEAST_ERROR), (ratio.min(ratio_limit), error)];
    chart.draw_series([Rectangle::new(target, GREEN.mix(0.12).filled())])?;
    for mark in &panel.marks {
        let at = (mark.ratio, mark.error.min(error_limit));
        let style = style(results, mark.method, mark.reliable);
        if is_fixed(results, mark.method) {
            chart.draw_series([TriangleMarker::new(at, 8, style)])?;
        } else {
            chart.draw_series([Circle::new(at, 6, style)])?;
        }
    }
    Ok(())
}

fn is_fixed(results: &Results, method: usize) -> bool {
    results.methods[method].inputs.unit != ULP
}

/// The colour is that of the method with the same name in the first number type, for fixed point.
fn style(results: &Results, method: usize, reliable: bool) -> ShapeStyle {
    let name = results.methods[method].name;
    let first = results.methods.iter().position(|method| method.name == name).unwrap_or(method);
    let color = COLORS[if is_fixed(results, method) { first } else { method } % COLORS.len()];
    let style = ShapeStyle::from(color).stroke_width(2);
    if reliable { style.filled() } else { style }
}

fn draw_legend(area: &Area<'_>, results: &Results) -> Result<(), Box<dyn Error>> {
    let font = ("sans-serif", 14).into_font();
    let cell = |i: usize| (72 + 210 * (i as i32 % 4), 14 + 26 * (i as i32 / 4));
    for (i, method) in results.methods.iter().enumerate() {
        let (x, y) = cell(i);
        let style = style(results, i, true);
        if is_fixed(results, i) {
            area.draw(&TriangleMarker::new((x, y + 1), 8, style))?;
        } else {
            area.draw(&Circle::new((x, y), 6, style))?;
        }
        area.draw(&Text::new(method.label(), (x + 13, y - 7), font.clone()))?;
    }
    let notes = [
        "filled: no ray gets a wrong class that 10⁻⁶ of the size doesn't change; \
         open: some do",
        "above: cylinders; green: the target of f32 (for ordinary rays at other solids, of the error alone); at \
         the lower edge: below 0.1 ulp",
        "triangles: fixed point, right within half a unit of 2⁻¹⁶ (spans of a unit: 1.5); that is many ulps of an f32 \
         near by and few far away,",
        "where it was asked about the rays that it can hold: of those from afar, the ones from 10³ radii",
    ];
    for (i, note) in notes.into_iter().enumerate() {
        area.draw(&Text::new(note, (66, 86 + 19 * i as i32), font.clone()))?;
    }
    Ok(())
}
