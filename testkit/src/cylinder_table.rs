//! The rows of `tests/reference/cylinder.csv`, which other programs computed with 640 bits: rays at
//! a cylinder along the x axis.

use crate::oracle::Truth;
use crate::query::Query;

#[derive(Debug)]
pub struct Row {
    pub set: &'static str,
    /// ox oy oz dx dy dz r h.
    pub input: [f32; 8],
    pub valid: bool,
    /// Of the whole line.
    pub span: Option<[f64; 2]>,
    /// The first crossing of the open wall at t ≥ 0.
    pub tube_t: Option<f64>,
    pub starts_inside: bool,
    /// Whether the ray hits, where that does not hang by a hair.
    pub capped: Option<bool>,
    pub tube: Option<bool>,
}

impl Row {
    fn parse(line: &'static str) -> Option<Self> {
        let field: Vec<&str> = line.split(',').collect();
        let mut input = [0.0; 8];
        for (number, bits) in input.iter_mut().zip(field.get(1..9)?) {
            *number = f32::from_bits(u32::from_str_radix(bits, 16).ok()?);
        }
        let number = |i: usize| field.get(i)?.parse::<f64>().ok();
        let class = |i: usize| number(i).map(|class| class == 1.0);
        let (crosses, span) = (number(9)?, number(10).zip(number(11)));
        Some(Self {
            set: field.first()?,
            input,
            valid: crosses >= 0.0,
            span: span.map(|(t_in, t_out)| [t_in, t_out]),
            tube_t: number(12),
            starts_inside: class(13) == Some(true),
            capped: class(14),
            tube: class(15),
        })
        .filter(|row| row.span.is_some() == (crosses == 1.0))
    }

    pub fn query(&self) -> Query {
        let [ox, oy, oz, dx, dy, dz, radius, half_length] = self.input.map(f64::from);
        Query::new([[ox, oy, oz], [dx, dy, dz]], radius, half_length)
    }

    fn agrees(&self, truth: &Truth) -> bool {
        truth.valid == self.valid
            && truth.span == self.span
            && truth.robust_hit == self.capped
            && truth.starts_inside.is_none_or(|inside| inside == self.starts_inside)
    }
}

/// All rows.
///
/// # Errors
/// The first line that can't be read.
pub fn rows() -> Result<Vec<Row>, String> {
    let lines = include_str!("../../tests/reference/cylinder.csv").lines().skip(1);
    lines.map(|line| Row::parse(line).ok_or_else(|| format!("cannot read {line}"))).collect()
}

/// How many rays the oracle was compared on.
///
/// # Errors
/// The first row on which the oracle disagrees.
pub fn check_oracle() -> Result<usize, String> {
    let rows = rows()?;
    for row in &rows {
        let truth = Truth::of(&row.query());
        if !row.agrees(&truth) {
            return Err(format!("the oracle disagrees with the reference: {truth:?} for {row:?}"));
        }
    }
    Ok(rows.len())
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_oracle_agrees_with_all_rows() {
        assert_eq!(super::check_oracle(), Ok(2600));
    }
}
