//! The rows of `reference/bspline_basis.csv`.

use super::exact::{self, Ratio};
use super::number::{Numeric, error};
use super::table::{Row, rows};
use scancsg::scalar::I16F16;
use testkit::limits;

/// The basis functions of any order that the table has.
fn basis<S: Numeric>(row: &Row) -> S {
    let number = |x: &Ratio| {
        let rounded = S::of(x.to_f64());
        assert_eq!(rounded.ratio(), *x, "not exact");
        rounded
    };
    let knots: Vec<S> = row.knots.iter().map(number).collect();
    let t = number(&row.t);
    macro_rules! of_order {
        ($($K:literal),+) => {
            match row.order {
                $($K => {
                    let knots = S::knots::<$K, 12>(&knots).unwrap();
                    knots.basis_derivative(row.index, row.derivative, t)
                })+
                _ => panic!("order {}", row.order),
            }
        };
    }
    of_order!(1, 2, 3, 4, 5, 6)
}

/// Errors of values in units of the value, of derivatives in units of the sum of their terms.
fn worst<S: Numeric>(name: &str, is_in: impl Fn(&Row) -> bool, limits: [f64; 2]) {
    let mut worst = [0f64; 2];
    let mut count = 0;
    let rows = rows().unwrap();
    assert_eq!(rows.len(), 577);
    for row in rows.iter().filter(|row| is_in(row)) {
        let at = exact::span(&row.knots, &row.t);
        let (value, size) =
            exact::basis(&row.knots, at, row.order, row.index, &row.t, row.derivative);
        assert_eq!(value, row.value, "the oracle disagrees with the table");
        let got = basis::<S>(row);
        if row.value.is_zero() && row.derivative == 0 {
            assert_eq!(got, S::ZERO, "{}: {:?} N_{}({:?})", row.group, row.knots, row.index, row.t);
        }
        let error = error(got, &row.value, size.to_f64());
        let kind = usize::from(row.derivative > 0);
        worst[kind] = worst[kind].max(error);
        assert!(error <= limits[kind], "{} N_{}({:?}): {error}", row.group, row.index, row.t);
        count += 1;
    }
    println!("{name}: {count} rows, values {:.2}, derivatives {:.2} units", worst[0], worst[1]);
}

#[test]
fn basis_functions_of_the_table() {
    worst::<f32>("f32", |_| true, limits::BASIS_TABLE);
    worst::<f64>("f64", |_| true, limits::BASIS_TABLE);
    worst::<I16F16>("I16F16", |row| row.group != "f32only", limits::BASIS_FIXED);
}
