//! The tables of splines, and what falls short of a target.

use super::methods::METHODS;
use super::{Results, Row};
use std::fmt::Write;
use testkit::ulp::percentiles;

/// Curves of the orders that are measured.
pub fn curves(order: usize) -> &'static str {
    if order == 3 { "quadratics" } else { "cubics" }
}

/// Median, 99th percentile and maximum.
fn figures(errors: &[f64]) -> [String; 3] {
    let figure = |x: f64| format!("{x:.2}");
    percentiles(errors).map_or_else(|| ["-", "-", "-"].map(Into::into), |errors| errors.map(figure))
}

/// A method or a number type in a table.
struct Line {
    label: String,
    points: usize,
    time: String,
    errors: [String; 3],
    unit: &'static str,
    /// Curves not taken, and points without an answer.
    missing: usize,
}

/// All tables, with their titles: set by set, and then the basis functions.
fn tables(results: &Results) -> Vec<(String, Vec<Line>)> {
    let of_set = |rows: &[Row]| {
        let asked = rows.iter().filter(|row| row.accuracy.asked > 0);
        let lines = asked.map(|row| Line {
            label: METHODS[row.method].label(),
            points: row.accuracy.errors.len(),
            time: row.cost.map_or_else(|| "-".into(), |cost| format!("{:.2}", cost.ratio)),
            errors: figures(&row.accuracy.errors),
            unit: METHODS[row.method].kind.unit,
            missing: row.accuracy.not_taken + row.accuracy.not_answered,
        });
        (format!("{}, {}", curves(rows[0].order), rows[0].set.name), lines.collect())
    };
    let of_basis = results.basis.iter().map(|row| Line {
        label: format!("{} {}", row.what, row.number),
        points: row.errors.len(),
        time: "-".into(),
        errors: figures(&row.errors),
        unit: row.kind.unit,
        missing: 0,
    });
    let sets = results.rows.chunks(METHODS.len()).map(of_set);
    sets.chain([("basis functions".into(), of_basis.collect())]).collect()
}

pub fn table(results: &Results) -> String {
    let mut text = String::new();
    for (title, lines) in tables(results) {
        let _ = writeln!(
            text,
            "\n{title}\n{:20}{:>8}{:>6}{:>5}{:>8}{:>8}{:>8}{:>9}",
            "", "points", "time", "", "p50", "p99", "max", "missing"
        );
        for Line { label, points, time, errors: [p50, p99, max], unit, missing } in lines {
            let _ = writeln!(
                text,
                "  {label:18}{points:>8}{time:>6}{unit:>5}{p50:>8}{p99:>8}{max:>8}{missing:>9}"
            );
        }
    }
    text
}

pub fn csv(results: &Results) -> String {
    let mut text = String::from(
        "set,order,method,number,unit,points,ns_per_point,time_ratio,p50,p99,max,\
         curves_not_taken,points_not_answered\n",
    );
    for row in results.rows.iter().filter(|row| row.accuracy.asked > 0) {
        let method = &METHODS[row.method];
        let cost = row.cost.map_or_else(
            || ",".to_string(),
            |cost| format!("{:.2},{:.3}", cost.nanoseconds, cost.ratio),
        );
        let _ = write!(
            text,
            "\"{}\",{},{},{},{},{},{cost},",
            row.set.name,
            row.order,
            method.name,
            method.number,
            method.kind.unit,
            row.accuracy.errors.len()
        );
        let _ = writeln!(
            text,
            "{},{},{}",
            scientific(&row.accuracy.errors),
            row.accuracy.not_taken,
            row.accuracy.not_answered
        );
    }
    for row in &results.basis {
        let _ = writeln!(
            text,
            "reference table,1 to 6,{},{},{},{},,,{},,",
            row.what,
            row.number,
            row.kind.unit,
            row.errors.len(),
            scientific(&row.errors)
        );
    }
    text
}

fn scientific(errors: &[f64]) -> String {
    percentiles(errors).map_or_else(
        || ",,".to_string(),
        |[p50, p99, max]| format!("{p50:.3e},{p99:.3e},{max:.3e}"),
    )
}

/// The part of the report that is about splines.
pub fn markdown(results: &Results) -> String {
    let mut text = format!(
        "\n# Splines\n\n\
         At least {} points in space of each kind of curves with eight control points, in \
         `speed_vs_error_splines.csv` with more figures. Time is a multiple of enterpolation's \
         (version 0.3, `f32`) in the same run. Errors are median / 99th percentile / largest, of a \
         point's worst coordinate, against exact fractions: in **ulps** of the largest coordinate of \
         the curve's control points, or in **LSB**, units of 2⁻¹⁶. \"Missing\" is points that are NaN \
         or infinite, and curves not taken. `I16F16` is asked about curves that it can hold, and \
         sweeps about uniform knots.\n\n\
         Basis functions are all rows of `tests/reference/bspline_basis.csv` that the number type can \
         hold, orders 1 to 6: values in ulps of the value, derivatives in ulps of the sum of their \
         terms' sizes.\n",
        results.points,
    );
    for (title, lines) in tables(results) {
        let _ = write!(
            text,
            "\n## {title}\n\n\
             | method | points | time | error | unit | missing |\n\
             |---|---:|---:|---:|---|---:|\n",
        );
        for Line { label, points, time, errors, unit, missing } in lines {
            let errors = errors.join(" / ");
            let _ =
                writeln!(text, "| {label} | {points} | {time} | {errors} | {unit} | {missing} |");
        }
    }
    text
}

/// The targets of accuracy that are missed, in words.
pub fn shortfalls(results: &Results) -> Vec<String> {
    let largest = |errors: &[f64]| percentiles(errors).map_or(f64::INFINITY, |[.., max]| max);
    let mut shortfalls = Vec::new();
    for row in results.rows.iter().filter(|row| row.accuracy.asked > 0) {
        let method = &METHODS[row.method];
        let Some(limit) = method.limit else { continue };
        let what = format!("{}, {}, {}", method.label(), curves(row.order), row.set.name);
        let max = largest(&row.accuracy.errors);
        if max > limit {
            shortfalls.push(format!("{what}: {max:.2} > {limit} {}", method.kind.unit));
        }
        let missing = row.accuracy.not_taken + row.accuracy.not_answered;
        if missing > 0 {
            shortfalls.push(format!("{what}: {missing} curves or points missing"));
        }
    }
    for row in &results.basis {
        let max = largest(&row.errors);
        if max > row.limit {
            let unit = row.kind.unit;
            let what = format!("basis functions, {} {}", row.what, row.number);
            shortfalls.push(format!("{what}: {max:.2} > {} {unit}", row.limit));
        }
    }
    shortfalls
}
