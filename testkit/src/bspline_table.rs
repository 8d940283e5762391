//! The rows of `tests/reference/bspline_basis.csv`: basis functions and their derivatives, exactly.

use crate::bspline::Ratio;

pub struct Row {
    pub group: &'static str,
    pub order: usize,
    pub knots: Vec<Ratio>,
    pub index: usize,
    pub t: Ratio,
    /// Of which order; 0 is the function itself.
    pub derivative: usize,
    pub value: Ratio,
}

impl Row {
    fn parse(line: &'static str) -> Option<Self> {
        let field: Vec<&str> = line.split(',').collect();
        Some(Self {
            group: field.get(1)?,
            order: field.get(2)?.parse().ok()?,
            knots: field.get(3)?.split(' ').map(Ratio::parse).collect(),
            index: field.get(4)?.parse().ok()?,
            t: Ratio::parse(field.get(5)?),
            derivative: field.get(6)?.parse().ok()?,
            value: Ratio::parse(field.get(7)?),
        })
    }
}

/// All rows.
///
/// # Errors
/// The first line that can't be read.
pub fn rows() -> Result<Vec<Row>, String> {
    let lines = include_str!("../../tests/reference/bspline_basis.csv").lines().skip(1);
    lines.map(|line| Row::parse(line).ok_or_else(|| format!("cannot read {line}"))).collect()
}
