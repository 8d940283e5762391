//! The part of the plot that is about splines.

use super::methods::METHODS;
use super::report::curves;
use super::{Results, Row};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use testkit::limits;

/// Distinguishable by colour-blind readers too (Okabe, Ito 2008).
const COLORS: [RGBColor; 6] = [
    RGBColor(0, 0, 0),
    RGBColor(230, 159, 0),
    RGBColor(0, 114, 178),
    RGBColor(230, 159, 0),
    RGBColor(0, 114, 178),
    RGBColor(0, 158, 115),
];

/// Of `f32`: the time and the error of the editable form and of the baked one.
const TARGETS: [(f64, f64); 2] = [(0.5, limits::EDITABLE_BENCH), (0.2, limits::BAKED)];

/// The left edge: a multiple of enterpolation's time.
const FASTEST: f64 = 0.09;

const ERRORS: std::ops::Range<f64> = 0.2..10.0;

/// Quadratics and cubics: every method's time, and its largest error on all sets.
pub fn draw(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    results: &Results,
) -> Result<(), Box<dyn Error>> {
    let rows = |method: usize, order: usize| -> Vec<&Row> {
        results.rows.iter().filter(|row| row.method == method && row.order == order).collect()
    };
    let mean = |rows: &[&Row]| {
        let logs: Vec<f64> = rows.iter().filter_map(|row| Some(row.cost?.ratio.ln())).collect();
        (!logs.is_empty()).then(|| (logs.iter().sum::<f64>() / logs.len() as f64).exp())
    };
    let all = (0..METHODS.len()).flat_map(|method| [3, 4].map(|order| rows(method, order)));
    let slowest = all.filter_map(|rows| mean(&rows)).fold(1.0, f64::max);
    for (area, order) in area.split_evenly((1, 2)).iter().zip([3, 4]) {
        let mut chart = ChartBuilder::on(area)
            .caption(format!("splines: {} in space", curves(order)), ("sans-serif", 17))
            .margin(10)
            .margin_right(22)
            .x_label_area_size(44)
            .y_label_area_size(62)
            .build_cartesian_2d((FASTEST..2.5 * slowest).log_scale(), ERRORS.log_scale())?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_desc("time, multiple of enterpolation's")
            .y_desc("largest error, ulps or LSB")
            .x_labels(5)
            .y_labels(5)
            .x_label_formatter(&|ratio| format!("{ratio}"))
            .y_label_formatter(&|error| format!("{error}"))
            .draw()?;
        for target in TARGETS {
            let target =
                Rectangle::new([(FASTEST, ERRORS.start), target], GREEN.mix(0.12).filled());
            chart.draw_series([target])?;
        }
        for (i, method) in METHODS.iter().enumerate() {
            let rows = rows(i, order);
            let errors = rows.iter().flat_map(|row| &row.accuracy.errors);
            let (Some(ratio), Some(error)) = (mean(&rows), errors.copied().reduce(f64::max)) else {
                continue;
            };
            let at = (ratio, error.clamp(ERRORS.start, ERRORS.end));
            let style = ShapeStyle::from(COLORS[i % COLORS.len()]).filled();
            if method.number == "f32" {
                chart.draw_series([Circle::new(at, 6, style)])?;
            } else {
                chart.draw_series([TriangleMarker::new(at, 8, style)])?;
            }
            let (x, y) = chart.backend_coord(&at);
            let (left, top) = area.get_base_pixel();
            // All of fixed point's errors are about the same.
            let below = [-22, -22, -22, 9, 9, 24];
            let place = (x - left - 20, y - top + below[i % below.len()]);
            area.draw(&Text::new(method.label(), place, ("sans-serif", 13).into_font()))?;
        }
    }
    Ok(())
}
