//! The oracle against `tests/reference/cylinder.csv`, which other programs computed.

use crate::oracle::Truth;
use crate::query::Query;

/// How many rays were compared.
///
/// # Errors
/// The first row on which the oracle disagrees.
pub fn check_oracle() -> Result<usize, String> {
    let table = include_str!("../../tests/reference/cylinder.csv");
    let mut rows = 0;
    for line in table.lines().skip(1) {
        let row = Row::parse(line).ok_or_else(|| format!("cannot read {line}"))?;
        let truth = Truth::of(&row.query);
        if !row.agrees(&truth) {
            return Err(format!("the oracle disagrees with the reference: {truth:?} for {line}"));
        }
        rows += 1;
    }
    Ok(rows)
}

struct Row {
    query: Query,
    /// 1, 0, or −1 for invalid input.
    line: f64,
    span: Option<[f64; 2]>,
    inside: bool,
    robust_hit: Option<bool>,
}

impl Row {
    fn parse(line: &str) -> Option<Self> {
        let field: Vec<&str> = line.split(',').collect();
        let input = |i: usize| {
            let bits = u32::from_str_radix(field.get(1 + i)?, 16).ok()?;
            Some(f64::from(f32::from_bits(bits)))
        };
        let mut numbers = [0.0; 8];
        for (i, number) in numbers.iter_mut().enumerate() {
            *number = input(i)?;
        }
        let [ox, oy, oz, dx, dy, dz, radius, half_length] = numbers;
        let number = |i: usize| field.get(i)?.parse::<f64>().ok();
        Some(Self {
            query: Query::new([[ox, oy, oz], [dx, dy, dz]], radius, half_length),
            line: number(9)?,
            span: number(10).zip(number(11)).map(|(t_in, t_out)| [t_in, t_out]),
            inside: number(13) == Some(1.0),
            robust_hit: number(14).map(|class| class == 1.0),
        })
    }

    fn agrees(&self, truth: &Truth) -> bool {
        let parameters = match (self.span, truth.span) {
            (Some(want), Some(got)) => want == got,
            (want, got) => want.is_none() && got.is_none(),
        };
        truth.valid == (self.line >= 0.0)
            && truth.span.is_some() == (self.line == 1.0)
            && parameters
            && truth.robust_hit == self.robust_hit
            && truth.starts_inside.is_none_or(|inside| inside == self.inside)
    }
}
