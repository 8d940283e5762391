//! What number types make of the rows of `tests/reference/bspline_basis.csv`.

use super::exact::{self, Ratio};
use super::kind::{F32, GRID, Kind};
use super::table::{self, Row as Known};
use scancsg::scalar::I16F16;
use scancsg::spline::Knots;

/// A number type on all values of the table, or on all derivatives.
pub struct Row {
    pub number: &'static str,
    pub what: &'static str,
    pub kind: Kind,
    /// Of values in units of the value, of derivatives in units of the sum of their terms' sizes.
    pub errors: Vec<f64>,
    pub limit: f64,
}

/// All rows in both number types.
///
/// # Errors
/// The first row that can't be read, or on which the oracle disagrees.
pub fn measure() -> Result<Vec<Row>, String> {
    let mut rows: Vec<Row> = [("f32", F32, 3.0), ("I16F16", GRID, 0.6)]
        .into_iter()
        .flat_map(|(number, kind, limit)| {
            ["values", "derivatives"].map(|what| Row {
                number,
                what,
                kind,
                errors: Vec::new(),
                limit,
            })
        })
        .collect();
    for known in table::rows()? {
        let Known { knots, order, index, t, derivative, .. } = &known;
        let at = exact::span(knots, t);
        let (value, size) = exact::basis(knots, at, *order, *index, t, *derivative);
        let place = || format!("N_{index}, order {order}, derivative {derivative}, at {t:?}");
        if value != known.value {
            return Err(format!("the oracle disagrees with the reference: {}", place()));
        }
        let what = if *derivative == 0 { "values" } else { "derivatives" };
        for row in rows.iter_mut().filter(|row| row.what == what) {
            let got = match row.number {
                "f32" => single(&known),
                _ if known.group == "f32only" => continue,
                _ => fixed(&known),
            };
            let got = got.ok_or_else(|| format!("{}: no knots for {}", row.number, place()))?;
            let off = (&Ratio::of(got) - &value).abs().to_f64();
            // Where the exact value is 0, so must be the answer.
            let error = if off == 0.0 { 0.0 } else { off / (row.kind.unit_of)(size.to_f64()) };
            row.errors.push(error);
        }
    }
    Ok(rows)
}

macro_rules! basis {
    ($function:ident, $Scalar:ty, $nearest:expr) => {
        fn $function(known: &Known) -> Option<f64> {
            let number = |x: &Ratio| -> $Scalar { $nearest(x.to_f64()) };
            let knots: Vec<$Scalar> = known.knots.iter().map(number).collect();
            let t = number(&known.t);
            macro_rules! of_order {
                ($K:literal) => {{
                    let knots = Knots::<$Scalar, $K, 12>::new(&knots).ok()?;
                    f64::from(knots.basis_derivative(known.index, known.derivative, t))
                }};
            }
            Some(match known.order {
                1 => of_order!(1),
                2 => of_order!(2),
                3 => of_order!(3),
                4 => of_order!(4),
                5 => of_order!(5),
                6 => of_order!(6),
                _ => return None,
            })
        }
    };
}

basis!(single, f32, |x| x as f32);
basis!(fixed, I16F16, |x: f64| I16F16::from_bits((x * 65536.0) as i32));
