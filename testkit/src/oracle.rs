//! The exact answers, in whole numbers.
//!
//! Every finite binary floating- or fixed-point number is a whole number of some power of two. In
//! such units, a = |m|² and the discriminant r²a − k² = b² − ac are whole numbers too, so whether
//! a line meets the wall is decided exactly. The square root alone is cut off, at more than 256
//! bits below the numbers that it is added to; parameters are then quotients of whole numbers.

use crate::query::Query;
use dashu_int::ops::{BitTest, SquareRoot};
use dashu_int::{IBig, UBig};
use std::cmp::Ordering;

/// What is true about a query.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Truth {
    pub valid: bool,
    /// Where the whole line is inside the closed solid, rounded to nearest.
    pub span: Option<[f64; 2]>,
    /// Whether the whole line is inside the open solid for some length. Of the planes of the caps,
    /// which a line may run in, the lower one counts as inside.
    pub is_inside_somewhere: bool,
    /// Whether the ray, t ≥ 0, hits: if that is the same for r and h scaled by 1 ± 10⁻⁶.
    pub robust_hit: Option<bool>,
    /// Whether the ray starts inside: if that is the same for r and h scaled so.
    pub starts_inside: Option<bool>,
}

impl Truth {
    pub fn of(query: &Query) -> Self {
        if !query.is_valid() {
            let (robust_hit, starts_inside) = (Some(false), None);
            let is_inside_somewhere = false;
            return Self {
                valid: false,
                span: None,
                is_inside_somewhere,
                robust_hit,
                starts_inside,
            };
        }
        let line = Line::new(query);
        let [smaller, exact, larger] = [-1, 0, 1].map(|millionths| line.span(millionths));
        let both = |ask: fn(&Option<[Bound; 2]>) -> bool| {
            let answers = [&smaller, &larger].map(ask);
            (answers[0] == answers[1]).then_some(answers[0])
        };
        Self {
            valid: true,
            robust_hit: both(|span| span.as_ref().is_some_and(|[_, exit]| !exit.is_negative())),
            starts_inside: both(|span| {
                let within = |[enter, exit]: &[Bound; 2]| enter.is_negative() && exit.is_positive();
                span.as_ref().is_some_and(within)
            }),
            is_inside_somewhere: line.is_inside_somewhere(),
            span: exact.map(|ends| ends.map(|end| end.to_f64(line.exponent))),
        }
    }
}

/// Scales are 1 + n/`SCALE`.
const SCALE: i64 = 1_000_000;

/// Bits of the square root below the numbers that it is added to.
const GUARD: usize = 256;

/// What a query's numbers give for any scale of the solid. All lengths but those of the direction
/// are in units of 1/[`SCALE`] of their power of two, so that scaled solids are whole numbers.
struct Line {
    x: IBig,
    dx: IBig,
    /// The products d·d, −u·d and u·u of the parts across the axis, or for a ball of all.
    a: IBig,
    b: IBig,
    distance_squared: IBig,
    radius: IBig,
    half_length: IBig,
    /// Parameters are in units of 2^exponent/[`SCALE`].
    exponent: i32,
}

impl Line {
    fn new(query: &Query) -> Self {
        let [ox, oy, oz] = query.origin;
        let [base_x, base_y, base_z] = query.base;
        let ([ox, oy, oz, base_x, base_y, base_z, radius, half_length], unit) =
            whole([ox, oy, oz, base_x, base_y, base_z, query.radius, query.half_length]);
        let (d, direction_unit) = whole(query.direction);
        let u = [ox - base_x, oy - base_y, oz - base_z].map(|length| length * SCALE);
        let product = |v: &[IBig; 3], w: &[IBig; 3]| {
            let first = if query.is_ball { &v[0] * &w[0] } else { IBig::ZERO };
            first + &v[1] * &w[1] + &v[2] * &w[2]
        };
        let (a, b, distance_squared) = (product(&d, &d), -product(&u, &d), product(&u, &u));
        // A ball lies between its caps wherever the line is.
        let [[x, ..], [dx, ..]] = if query.is_ball { Default::default() } else { [u, d] };
        Self { a, b, distance_squared, x, dx, radius, half_length, exponent: unit - direction_unit }
    }

    fn span(&self, millionths: i64) -> Option<[Bound; 2]> {
        let [radius, half_length] =
            [&self.radius, &self.half_length].map(|length| length * (SCALE + millionths));
        let [wall_enter, wall_exit] = self.wall(&radius)?;
        let [caps_enter, caps_exit] = self.caps(&half_length)?;
        let enter = wall_enter.max(caps_enter);
        let exit = wall_exit.min(caps_exit);
        (enter.compare(&exit) != Ordering::Greater).then_some([enter, exit])
    }

    fn is_inside_somewhere(&self) -> bool {
        let [radius, half_length] = [&self.radius, &self.half_length].map(|length| length * SCALE);
        let is_within_wall = if self.a == IBig::ZERO {
            self.distance_squared < &radius * &radius
        } else {
            self.discriminant(&radius) > IBig::ZERO
        };
        let is_between_caps =
            self.dx != IBig::ZERO || (-&half_length <= self.x && self.x < half_length);
        let has_length = |[enter, exit]: &[Bound; 2]| enter.compare(exit) == Ordering::Less;
        is_within_wall && is_between_caps && self.span(0).as_ref().is_some_and(has_length)
    }

    fn discriminant(&self, radius: &IBig) -> IBig {
        &self.b * &self.b - &self.a * (&self.distance_squared - radius * radius)
    }

    fn wall(&self, radius: &IBig) -> Option<[Bound; 2]> {
        if self.a == IBig::ZERO {
            return (self.distance_squared <= radius * radius).then_some(Bound::WHOLE_LINE);
        }
        let discriminant = UBig::try_from(self.discriminant(radius)).ok()?;
        // |b| − √D may cancel down to 1/|b|.
        let bits = GUARD + self.b.bit_len();
        let root = IBig::from((discriminant << (2 * bits)).sqrt());
        let b = &self.b << bits;
        let ratio = |numerator| Bound::Ratio(numerator, &self.a << bits);
        Some([ratio(&b - &root), ratio(b + root)])
    }

    fn caps(&self, half_length: &IBig) -> Option<[Bound; 2]> {
        let [low, high] = [-half_length - &self.x, half_length - &self.x];
        match self.dx.cmp(&IBig::ZERO) {
            Ordering::Equal => {
                (low <= IBig::ZERO && IBig::ZERO <= high).then_some(Bound::WHOLE_LINE)
            }
            Ordering::Greater => Some([low, high].map(|x| Bound::Ratio(x, self.dx.clone()))),
            Ordering::Less => Some([-high, -low].map(|x| Bound::Ratio(x, -&self.dx))),
        }
    }
}

/// An end of a span.
enum Bound {
    Lowest,
    /// Numerator and a denominator above zero.
    Ratio(IBig, IBig),
    Highest,
}

impl Bound {
    const WHOLE_LINE: [Self; 2] = [Self::Lowest, Self::Highest];

    fn compare(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Ratio(p, q), Self::Ratio(r, s)) => (p * s).cmp(&(r * q)),
            _ => self.rank().cmp(&other.rank()),
        }
    }

    fn rank(&self) -> u8 {
        match self {
            Self::Lowest => 0,
            Self::Ratio(..) => 1,
            Self::Highest => 2,
        }
    }

    fn max(self, other: Self) -> Self {
        if self.compare(&other) == Ordering::Less { other } else { self }
    }

    fn min(self, other: Self) -> Self {
        if self.compare(&other) == Ordering::Greater { other } else { self }
    }

    fn is_negative(&self) -> bool {
        self.compare(&Self::Ratio(IBig::ZERO, IBig::ONE)) == Ordering::Less
    }

    fn is_positive(&self) -> bool {
        self.compare(&Self::Ratio(IBig::ZERO, IBig::ONE)) == Ordering::Greater
    }

    fn to_f64(&self, exponent: i32) -> f64 {
        match self {
            Self::Lowest => f64::NEG_INFINITY,
            Self::Ratio(p, q) => {
                // A quotient of 128 bits or more is rounded to 53 as the exact one would be, but
                // for ties within 2⁻⁷⁵.
                let denominator = q * SCALE;
                let shift = (128 + denominator.bit_len()).saturating_sub(p.bit_len());
                let quotient = (p << shift) / denominator;
                quotient.to_f64().value() * 2f64.powi(exponent - shift as i32)
            }
            Self::Highest => f64::INFINITY,
        }
    }
}

/// Finite numbers as whole numbers of one power of two, and its exponent.
pub(crate) fn whole<const N: usize>(numbers: [f64; N]) -> ([IBig; N], i32) {
    let parts = numbers.map(|x| {
        let bits = x.to_bits();
        let (field, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
        let mantissa = if field == 0 { fraction } else { fraction | 1 << 52 } as i64;
        let zeros = mantissa.trailing_zeros().min(52);
        let mantissa = if x < 0.0 { -mantissa } else { mantissa } >> zeros;
        (mantissa, field.max(1) - 1075 + zeros as i32)
    });
    let used = parts.iter().filter(|(mantissa, _)| *mantissa != 0);
    let unit = used.map(|&(_, exponent)| exponent).min().unwrap_or(0);
    let scaled = parts.map(|(mantissa, exponent)| match mantissa {
        0 => IBig::ZERO,
        mantissa => IBig::from(mantissa) << (exponent - unit) as usize,
    });
    (scaled, unit)
}
