//! A line and a torus, exactly: their quartic in whole numbers, the number of its roots by Sturm's
//! theorem, and its sign at any fraction.
//!
//! With u = o − c, the axis A of any length, P = u + t·d and n = |P|² + R² − r², a point of the line is
//! inside where `|A|²n² − 4R²(|A|²|P|² − (A·P)²)` is negative.

use crate::oracle::whole;
use crate::vector::V;
use dashu_int::IBig;

/// Coefficients, that of the highest power last.
type Polynomial = Vec<IBig>;

/// Radii are scaled by 1 + n/`SCALE`.
const SCALE: i64 = 1_000_000;

#[derive(Debug, Clone, Copy)]
pub struct Torus {
    pub center: V,
    /// Of any length.
    pub axis: V,
    pub ring: f64,
    pub tube: f64,
}

/// What a line's parameter is a root of, in units of a power of two.
pub struct Quartic {
    polynomial: Polynomial,
    /// Parameters are in units of 2^exponent.
    exponent: i32,
}

fn trimmed(mut p: Polynomial) -> Polynomial {
    while p.last().is_some_and(|last| *last == IBig::ZERO) {
        p.pop();
    }
    p
}

fn sum(p: &[IBig], q: &[IBig], times: &IBig) -> Polynomial {
    let at = |p: &[IBig], i: usize| p.get(i).cloned().unwrap_or(IBig::ZERO);
    trimmed((0..p.len().max(q.len())).map(|i| at(p, i) + at(q, i) * times).collect())
}

fn product(p: &[IBig], q: &[IBig]) -> Polynomial {
    let mut all = vec![IBig::ZERO; p.len() + q.len()];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            all[i + j] += a * b;
        }
    }
    trimmed(all)
}

/// The remainder of a division, times a positive number.
fn remainder(p: &[IBig], q: &[IBig]) -> Polynomial {
    let mut rest = p.to_vec();
    let lead = &q[q.len() - 1];
    while rest.len() >= q.len() {
        let (top, shift) = (rest[rest.len() - 1].clone(), rest.len() - q.len());
        // |lead|·rest − ±top·x^shift·q
        let sign = IBig::from(if *lead < IBig::ZERO { -1 } else { 1 });
        let scale = lead * &sign;
        for x in &mut rest {
            *x *= &scale;
        }
        for (i, x) in q.iter().enumerate() {
            rest[i + shift] -= x * &top * &sign;
        }
        rest = trimmed(rest);
    }
    rest
}

impl Quartic {
    /// Of the torus with its tube scaled by so many millionths more.
    pub fn new(torus: &Torus, origin: V, direction: V, millionths: i64) -> Self {
        let ([ox, oy, oz], [cx, cy, cz]) = (origin, torus.center);
        let ([ox, oy, oz, cx, cy, cz, ring, tube], unit) =
            whole([ox, oy, oz, cx, cy, cz, torus.ring, torus.tube]);
        let (d, direction_unit) = whole(direction);
        let (axis, _) = whole(torus.axis);
        let u = [ox - cx, oy - cy, oz - cz].map(|length| length * SCALE);
        let d = d.map(|length| length * SCALE);
        let (ring, tube) = (ring * SCALE, tube * (SCALE + millionths));
        let dot = |v: &[IBig; 3], w: &[IBig; 3]| &v[0] * &w[0] + &v[1] * &w[1] + &v[2] * &w[2];
        let square = vec![dot(&u, &u), dot(&u, &d) * 2, dot(&d, &d)];
        let height = [dot(&axis, &u), dot(&axis, &d)];
        let axis_squared = dot(&axis, &axis);
        let n = sum(&square, &[&ring * &ring - &tube * &tube], &IBig::ONE);
        let scaled = |p: &[IBig], by: &IBig| -> Polynomial { p.iter().map(|x| x * by).collect() };
        let across =
            sum(&scaled(&square, &axis_squared), &product(&height, &height), &IBig::from(-1));
        let polynomial =
            sum(&scaled(&product(&n, &n), &axis_squared), &across, &(&ring * &ring * -4));
        Self { polynomial, exponent: unit - direction_unit }
    }

    /// The number of different real roots, and whether all roots are simple, complex ones too.
    pub fn roots(&self) -> (usize, bool) {
        let derivative: Polynomial =
            self.polynomial.iter().enumerate().skip(1).map(|(i, x)| x * i).collect();
        let mut chain = vec![self.polynomial.clone(), derivative];
        loop {
            let [.., p, q] = &chain[..] else { unreachable!() };
            let rest: Polynomial = remainder(p, q).into_iter().map(|x| -x).collect();
            if rest.is_empty() {
                break;
            }
            chain.push(rest);
        }
        let is_square_free = chain[chain.len() - 1].len() == 1;
        let changes = |is_back: bool| {
            let signs = chain.iter().map(|p| {
                let is_negative = p[p.len() - 1] < IBig::ZERO;
                is_negative != (is_back && p.len() % 2 == 0)
            });
            let signs: Vec<bool> = signs.collect();
            signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
        };
        (changes(true) - changes(false), is_square_free)
    }

    /// −1 inside, 1 outside: the sign at the parameter `t + part·2^exponent`.
    pub fn sign(&self, t: f64, part: i64, exponent: i32) -> i32 {
        let ([t], unit) = whole([t]);
        // t·2^unit + part·2^exponent in units of 2^low, as a fraction p/q of this quartic's unit.
        let low = unit.min(exponent);
        let p = (t << (unit - low) as usize) + (IBig::from(part) << (exponent - low) as usize);
        let shift = low - self.exponent;
        let (p, q) = if shift >= 0 { (p << shift as usize, 0) } else { (p, -shift as usize) };
        // Horner's rule, times powers of q.
        let mut value = IBig::ZERO;
        for (i, x) in self.polynomial.iter().rev().enumerate() {
            value = value * &p + (x << (q * i));
        }
        match value {
            value if value < IBig::ZERO => -1,
            value if value > IBig::ZERO => 1,
            _ => 0,
        }
    }

    /// How far a parameter is from the root that it stands for, in units of 2^exponent, rounded up to a
    /// 16th; `None` if no root is within 2²⁰ units where the line goes `inwards` or outwards.
    pub fn error(&self, t: f64, exponent: i32, inwards: bool) -> Option<f64> {
        let side = if inwards { 1 } else { -1 };
        let sign = |sixteenths: i64| side * self.sign(t, sixteenths, exponent - 4);
        let at = sign(0);
        if at == 0 {
            return Some(0.0);
        }
        // Before the root the sign is positive: it is on the side on which the sign changes.
        let way = i64::from(at);
        let far = (0..24).map(|power| 1i64 << power).find(|step| sign(way * step) != at)?;
        let (mut near, mut far) = (far / 2, far);
        while far - near > 1 {
            let middle = (near + far) / 2;
            if sign(way * middle) == at { near = middle } else { far = middle }
        }
        Some(far as f64 / 16.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TORUS: Torus =
        Torus { center: [0.5, 0.0, 0.0], axis: [0.0, 0.0, 2.0], ring: 2.0, tube: 0.5 };

    #[test]
    fn roots_are_counted() {
        let count = |origin, direction| Quartic::new(&TORUS, origin, direction, 0).roots();
        assert_eq!(count([-4.0, 0.0, 0.0], [1.0, 0.0, 0.0]), (4, true));
        assert_eq!(count([2.5, 0.0, 3.0], [0.0, 0.0, 1.0]), (2, true));
        // Along the axis: (z² + R² − r²)².
        assert_eq!(count([0.5, 0.0, 3.0], [0.0, 0.0, 1.0]), (0, false));
        // Along the tops of the tube, and around its outside.
        assert_eq!(count([0.0, 0.0, 0.5], [1.0, 0.0, 0.0]), (2, false));
        assert_eq!(count([3.0, 0.0, 0.0], [0.0, 1.0, 0.0]), (1, false));
    }

    #[test]
    fn errors_are_measured() {
        let quartic = Quartic::new(&TORUS, [-4.0, 0.0, 0.0], [0.5, 0.0, 0.0], 0);
        // Roots at 4, 6, 12 and 14. The next one that leads outwards is far off.
        assert_eq!(quartic.error(4.0, -10, true), Some(0.0));
        assert_eq!(quartic.error(4.0 + 0.75 / 1024.0, -10, true), Some(0.75));
        assert_eq!(quartic.error(6.0 - 2.0 / 1024.0, -10, false), Some(2.0));
        assert_eq!(quartic.error(4.0 + 0.75 / 1024.0, -10, false), Some(2047.25));
    }
}
