//! Where a line is inside a cone, exactly: in whole numbers, by the school's formula.
//!
//! A point is inside where it is between the caps, and not farther from the axis than the radius at its
//! height. No apex, no nappes: what the quadratic says between the caps is all.

use crate::surd::{Surd, square};
use crate::vector::V;
use dashu_int::ops::SquareRoot;
use dashu_int::{IBig, UBig};

/// A cone from `from` to `from + axis` and a line, by the numbers of the type under test.
#[derive(Debug, Clone, Copy)]
pub struct Query {
    pub from: V,
    pub axis: V,
    pub radii: [f64; 2],
    pub origin: V,
    pub direction: V,
}

/// Numbers are whole multiples of 2 to the minus this.
const FRACTION: usize = 220;

/// Growths are multiples of 2 to the minus this.
const GROWTH: usize = 40;

fn whole(x: f64) -> IBig {
    let bits = x.abs().to_bits();
    let exponent = (bits >> 52) as usize;
    if exponent == 0 {
        assert_eq!(bits, 0, "{x:e} is too small");
        return IBig::ZERO;
    }
    let mantissa = IBig::from((bits & ((1 << 52) - 1)) | (1 << 52));
    let shift = (exponent + FRACTION).checked_sub(1075).unwrap();
    if x < 0.0 { -(mantissa << shift) } else { mantissa << shift }
}

fn dot(v: &[IBig; 3], w: &[IBig; 3]) -> IBig {
    &v[0] * &w[0] + &v[1] * &w[1] + &v[2] * &w[2]
}

/// a t² + 2 b t + c
struct Wall {
    a: IBig,
    b: IBig,
    c: IBig,
}

impl Wall {
    /// The sign at a fraction, as a number.
    fn at(&self, Surd { p, d, .. }: &Surd) -> IBig {
        &self.a * square(p) + &self.b * p * d * 2 + &self.c * square(d)
    }

    fn roots(&self) -> Vec<Surd> {
        if self.a == IBig::ZERO {
            let twice = &self.b * 2;
            let has_one = twice != IBig::ZERO;
            return if has_one { vec![Surd::ratio(-&self.c, twice)] } else { Vec::new() };
        }
        let q = square(&self.b) - &self.a * &self.c;
        if q < IBig::ZERO {
            return Vec::new();
        }
        let is_negative = self.a < IBig::ZERO;
        let (p, d) =
            if is_negative { (self.b.clone(), -&self.a) } else { (-&self.b, self.a.clone()) };
        [-1, 1].map(|s| Surd { p: p.clone(), s, q: q.clone(), d: d.clone() }).into()
    }
}

/// The part of a line inside a cone that is grown at all sides by this many 2⁻⁴⁰ of its size; `None` if it
/// has no length.
pub fn span(query: &Query, growth: i64) -> Option<[Surd; 2]> {
    // A cone with its caps moved out, and wider by twice as much, is larger everywhere; a tip moves with
    // its cap.
    let one = IBig::ONE << GROWTH;
    let [low, high] = [IBig::from(-growth), &one + growth];
    let radii = query.radii.map(whole);
    let widest = (&radii[0]).max(&radii[1]).clone();
    let [r0, r1] = radii.map(|radius| {
        let moved: IBig = radius * &one + &widest * growth * 2;
        moved.max(IBig::ZERO)
    });

    let axis = query.axis.map(whole);
    let d = query.direction.map(whole);
    let (origin, from) = (query.origin.map(whole), query.from.map(whole));
    let u: [IBig; 3] = std::array::from_fn(|i| &origin[i] - &from[i]);
    let square_length = dot(&axis, &axis);
    let (height, speed) = (dot(&u, &axis), dot(&d, &axis));
    // Heights are parts of |A|², and `low` and `high` are such parts in units of `one`.
    let [to_low, to_high] = [&low, &high].map(|at| at * &square_length - &height * &one);
    let caps = if speed == IBig::ZERO {
        if to_low > IBig::ZERO || to_high <= IBig::ZERO {
            return None;
        }
        None
    } else {
        let ends = [to_low, to_high].map(|way| Surd::ratio(way, &speed * &one));
        let [low, high] = ends;
        Some(if speed > IBig::ZERO { [low, high] } else { [high, low] })
    };

    // The distance from the axis is |v − A (v·A)/|A|²|, and the radius
    // r₀ + (r₁ − r₀)(h − low)/(high − low) with h = v·A/|A|²: both times |A|²(high − low).
    let length = &high - &low;
    let across = |v: &[IBig; 3], along: &IBig| -> [IBig; 3] {
        std::array::from_fn(|i| (&v[i] * &square_length - &axis[i] * along) * &length * &one)
    };
    let (q, m) = (across(&u, &height), across(&d, &speed));
    let rise = &r1 - &r0;
    // Both sides times `one`, which the radii are in.
    let radius = &r0 * &square_length * &length + &rise * (&height * &one - &low * &square_length);
    let growth = &rise * &speed * &one;
    let wall = Wall {
        a: dot(&m, &m) - square(&growth),
        b: dot(&q, &m) - &radius * &growth,
        c: dot(&q, &q) - square(&radius),
    };
    let roots = wall.roots();
    let Some([first, last]) = caps else {
        let [enter, exit] = <[Surd; 2]>::try_from(roots).ok()?;
        return (enter.q > IBig::ZERO).then_some([enter, exit]);
    };
    let is_inside = [&first, &last].map(|at| wall.at(at) < IBig::ZERO);
    let between: Vec<Surd> = roots
        .into_iter()
        .filter(|root| root.order(&first).is_gt() && root.order(&last).is_lt())
        .collect();
    let enter = if is_inside[0] { Some(first) } else { between.first().cloned() };
    let exit = if is_inside[1] { Some(last) } else { between.last().cloned() };
    let (enter, exit) = (enter?, exit?);
    // Of a tangent, or of a line through the tip, both are the same.
    let is_one = enter.s != 0 && exit.s != 0 && (enter.s == exit.s || enter.q == IBig::ZERO);
    (!is_one).then_some([enter, exit])
}

/// The nearest number.
pub fn to_f64(Surd { p, s, q, d }: &Surd) -> f64 {
    const GUARD: usize = 400;
    let root = UBig::try_from(q << (2 * GUARD)).unwrap().sqrt();
    let numerator = (p << GUARD) + IBig::from(*s) * IBig::from(root);
    let quotient: IBig = (numerator << 200) / (d << GUARD);
    quotient.to_f64().value() * 2f64.powi(-200)
}

/// Whether the parameter is at or above zero.
pub fn is_ahead(t: &Surd) -> bool {
    t.order(&Surd::ratio(IBig::ZERO, IBig::ONE)).is_ge()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends(query: &Query, growth: i64) -> Option<[f64; 2]> {
        span(query, growth).map(|ends| ends.map(|t| to_f64(&t)))
    }

    #[test]
    fn lines_by_hand() {
        let from = [1.0, 2.0, 3.0];
        let across = Query {
            from,
            axis: [0.0, 0.0, 4.0],
            radii: [2.0, 0.0],
            origin: [-5.0, 2.0, 5.0],
            direction: [1.0, 0.0, 0.0],
        };
        assert_eq!(ends(&across, 0), Some([5.0, 7.0]));
        let [enter, exit] = ends(&across, 1 << 20).unwrap();
        assert!(4.99999 < enter && enter < 5.0 && 7.0 < exit && exit < 7.00001);
        // Along the axis through the cap, and out at the side: steeper than that.
        let down = Query { origin: [2.0, 2.0, 9.0], direction: [0.0, 0.0, -2.0], ..across };
        assert_eq!(ends(&down, 0), Some([2.0, 3.0]));
        // Along the side, half a unit inside.
        let side = Query { origin: [-0.5, 2.0, 3.0], direction: [0.5, 0.0, 1.0], ..across };
        assert_eq!(ends(&side, 0), Some([0.0, 3.5]));
        // Past the tip, where the other nappe would be.
        let beyond = Query { origin: [-5.0, 2.0, 8.0], ..across };
        assert_eq!(ends(&beyond, 0), None);
    }
}
