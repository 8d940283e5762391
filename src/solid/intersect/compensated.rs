//! Lines in floating point: error-free sums and products where something cancels.
//!
//! With u = p − base, m = d × axis and q = u × axis, a line's points at distance r from the axis
//! are the roots of `a t² + 2 b t + c = 0` with a = |m|², b = q·m and c = |q|² − r². The
//! discriminant b² − ac is computed as `r²a − k²`, k = u·m: no squares of large distances cancel.
//! With s = |b| + √D the roots are s/a and c/s, up to a sign: no roots of equal size cancel.
//! (W. Kahan, *On the cost of floating-point computation without extra-precise arithmetic*, 2004.)
//!
//! The axis is never normalised away, and `|d × axis|²` is never 1 − d²: a line along the axis
//! gives m = 0 exactly.

use super::{Intersect, Passage};
use crate::geom::{Axis, Direction, Line, Vec3};
use crate::scalar::{Double, Float, two_sum};
use crate::solid::cylinder::{Cylinder, Tube, WALL};
use crate::solid::slab::Slab;
use crate::span::{Crossing, Span};

/// Where a line is inside the wall: from the first parameter to the second one, which are the same
/// for a tangent. For a line beside the wall, the first one is larger.
type Inside<S> = (S, S);

impl<S: Float> Tube<S> {
    const NOWHERE: Inside<S> = (S::HIGHEST, S::LOWEST);
    const EVERYWHERE: Inside<S> = (S::LOWEST, S::HIGHEST);

    /// Along a coordinate axis: where the line is inside the wall, quickly if it is neither near a
    /// tangent nor starts near the wall or inside.
    ///
    /// There q and m are two coordinates of u and d, turned by 90°, and plain sums do. The error of k
    /// is that of |q||m|, and so is s, as long as the line starts outside: D > k²/8 holds down the
    /// k/√D times as much that reaches s. With c > r² little cancels in c and b, and b isn't zero.
    /// `None` is for all other lines.
    #[inline(always)]
    fn meet_clearly(&self, o: [S; 2], base: [S; 2], m: [S; 2]) -> Option<Inside<S>> {
        let q = [o[0] - base[0], o[1] - base[1]];
        let radius_squared = self.radius * self.radius;
        let a = m[0] * m[0] + m[1] * m[1];
        let k = q[0] * m[1] - q[1] * m[0];
        let (largest, square) = (radius_squared * a, k * k);
        let discriminant = largest - square;
        if discriminant * S::from_int(8) > square {
            let c = S::squares_less(q, radius_squared);
            if c > radius_squared {
                let b = q[0] * m[0] + q[1] * m[1];
                let s = discriminant.sqrt() + b.abs();
                let (near, far) = (c / s, s / a);
                return Some(if b > S::ZERO { (-far, -near) } else { (near, far) });
            }
        } else {
            // Several times what D can be wrong by, k's error included.
            let [q, m] = [q, m].map(|[x, y]| x.abs() + y.abs());
            let error = (largest + k.abs() * (q * m)) * S::from_int(4) * S::EPSILON;
            if discriminant < -error && a > S::EPSILON {
                return Some(Self::NOWHERE);
            }
        }
        None
    }

    /// Along a coordinate axis: where the line is inside the wall.
    ///
    /// Compensated are the two terms that cancel wherever the line starts: k, and c. The error of D
    /// is then a few units of r²a, and reaches s divided by 2√D: so √D·s ≥ r²a/2 holds it to a few
    /// units of s. What is nearer to a tangent, or to a parallel to the axis, goes on to
    /// `meet_across`.
    #[inline]
    fn meet_carefully(&self, o: [S; 2], base: [S; 2], m: [S; 2]) -> Inside<S> {
        let radius = self.radius;
        let q = [Double::sum(o[0], -base[0]), Double::sum(o[1], -base[1])];
        let a = m[0] * m[0] + m[1] * m[1];
        let k = S::product_difference(q[0].high, m[1], q[1].high, m[0])
            + (q[0].low * m[1] - q[1].low * m[0]);
        let largest = radius * radius * a;
        let discriminant = largest - k * k;
        let b = q[0].high * m[0] + q[1].high * m[1];
        // NaN where D is negative: then it isn't clear.
        let half = discriminant.sqrt();
        let s = half + b.abs();
        if half * s > largest * S::HALF {
            return ends(a, b, squared_less_square(q, radius), half);
        }
        // Several times what D can be wrong by, as long as no square has lost its digits.
        let error = largest * S::EPSILON * S::from_int(32);
        if discriminant < -error && a > S::EPSILON {
            return Self::NOWHERE;
        }
        Self::meet_across(q, m, radius)
    }

    /// Along a coordinate axis: where the line is inside the wall, with everything that can cancel in
    /// twice the working precision.
    #[inline]
    fn meet_across(q: [Double<S>; 2], m: [S; 2], radius: S) -> Inside<S> {
        let radius_squared = Double::product(radius, radius);
        let a = Double::product(m[0], m[0]).plus_roughly(Double::product(m[1], m[1]));
        if a.high <= S::ZERO {
            return Self::parallel(squared_less_square(q, radius));
        }
        let k = Double::product(q[0].high, m[1]).minus_roughly(Double::product(q[1].high, m[0]));
        let k = Double { low: k.low + (q[0].low * m[1] - q[1].low * m[0]), ..k };
        let discriminant = Double::product_less_square(radius_squared, a, k);
        if discriminant < S::ZERO {
            return Self::NOWHERE;
        }
        let b = Double::product(q[0].high, m[0]).plus_roughly(Double::product(q[1].high, m[1]));
        let b = b.high + (b.low + (q[0].low * m[0] + q[1].low * m[1]));
        if discriminant == S::ZERO {
            // A tangent has one root, but c/s would round to another number, or be 0/0.
            let t = -b / a.high;
            return (t, t);
        }
        ends(a.high, b, squared_less_square(q, radius), discriminant.sqrt())
    }

    /// Where a line along the axis is inside the wall.
    fn parallel(c: S) -> Inside<S> {
        if c < S::ZERO { Self::EVERYWHERE } else { Self::NOWHERE }
    }

    /// Along any axis: where the line is inside the wall, quickly where little cancels.
    ///
    /// The error of D reaches s divided by 2√D, and is kept where that quotient is small. Plain
    /// sums are good enough for b if it isn't small beside |q||m| with s small as well, and for c
    /// from some way off the wall on.
    #[inline(never)]
    fn meet_obliquely(&self, axis: &Direction<S>, line: &Line<S>) -> Inside<S> {
        let u = line.origin - self.base;
        let d = line.direction;
        let radius_squared = Double::product(self.radius, self.radius);
        let (m, q) = (d.cross(axis.vector()), u.cross(axis.vector()));
        let (a, b, k) = (m.length_squared(), q.dot(m), u.dot_compensated(m));
        let largest = radius_squared.high * a;
        let discriminant = largest - k * k;
        let error = largest * S::EPSILON * S::from_int(8);
        let is_precise = if discriminant < S::ZERO {
            discriminant < -error
        } else {
            discriminant * (discriminant + b * b) > largest * largest
        };
        let distance_squared = q.length_squared();
        let c = distance_squared - radius_squared.high;
        if is_precise && discriminant < S::ZERO {
            return Self::NOWHERE;
        }
        let s = discriminant.max(S::ZERO).sqrt() + b.abs();
        let is_clear = c.abs() + c.abs() >= distance_squared + radius_squared.high
            && s * s * S::from_int(4) > distance_squared * a;
        if is_precise && is_clear {
            points(s / a, c / s, b, discriminant)
        } else {
            self.meet_closely(axis, line)
        }
    }

    /// Along any axis: where the line is inside the wall, in twice the working precision throughout.
    #[cold]
    #[inline(never)]
    fn meet_closely(&self, axis: &Direction<S>, line: &Line<S>) -> Inside<S> {
        let u = difference(line.origin, self.base);
        let (d, axis) = (widened(line.direction), widened(axis.vector()));
        let m = cross(d, axis);
        self.roots_closely(cross(u, axis), m, dot(u.to_array(), m))
    }

    fn roots_closely(&self, q: [Double<S>; 3], m: [Double<S>; 3], k: Double<S>) -> Inside<S> {
        let radius_squared = Double::product(self.radius, self.radius);
        let a = dot(m, m);
        let c = dot(q, q).minus(radius_squared).round();
        if a.high <= S::ZERO {
            return Self::parallel(c);
        }
        let discriminant = radius_squared.times(a).minus(k.times(k)).round();
        if discriminant < S::ZERO {
            return Self::NOWHERE;
        }
        let b = dot(q, m).round();
        let s = discriminant.sqrt() + b.abs();
        let far = s / a.round();
        points(far, c / s, b, discriminant)
    }
}

/// The roots s/a and c/s in ascending order, where `half` is √D and s has the sign of −b.
#[inline]
fn ends<S: Float>(a: S, b: S, c: S, half: S) -> Inside<S> {
    let s = if b > S::ZERO { -half - b } else { half - b };
    let far = s / a;
    // With b = 0 both are ±√D/a: from either end of the line the same.
    let near = if b == S::ZERO { -far } else { c / s };
    (near.min(far), near.max(far))
}

/// `|q|² − r²` with the errors of squares and sums added back.
#[inline]
fn squared_less_square<S: Float>(q: [Double<S>; 2], radius: S) -> S {
    let [q0, q1] = q;
    let (p0, e0) = S::two_product(q0.high, q0.high);
    let (p1, e1) = S::two_product(q1.high, q1.high);
    let (p2, e2) = S::two_product(radius, radius);
    let (sum, f0) = two_sum(p0, p1);
    let (sum, f1) = two_sum(sum, -p2);
    let cross = q0.high * q0.low + q1.high * q1.low;
    sum + (((e0 + e1) - e2) + (f0 + f1) + (cross + cross))
}

/// The points from the roots' sizes: `far` = (|b| + √D)/a, and `near` = c/(|b| + √D).
fn points<S: Float>(far: S, near: S, b: S, discriminant: S) -> Inside<S> {
    // A tangent has one root, but c/s would round to another number, or be 0/0.
    let near = if discriminant > S::ZERO { near } else { far };
    // With b = 0 both are ±√D/a: from either end of the line the same.
    let (one, other) = if b == S::ZERO {
        (-far, far)
    } else if b > S::ZERO {
        (-far, -near)
    } else {
        (near, far)
    };
    // Almost tangent, they may come out in the wrong order by a rounding error.
    if one < other { (one, other) } else { (other, one) }
}

fn dot<S: Float, const N: usize>(x: [Double<S>; N], y: [Double<S>; N]) -> Double<S> {
    let zero = Double::from(S::ZERO);
    x.into_iter().zip(y).fold(zero, |sum, (x, y)| sum.plus(x.times(y)))
}

/// The scalar product of one vector with another turned by 90°.
fn turned<S: Float>([x0, x1]: [Double<S>; 2], [y0, y1]: [Double<S>; 2]) -> Double<S> {
    x0.times(y1).minus(x1.times(y0))
}

fn cross<S: Float>(x: Vec3<Double<S>>, y: Vec3<Double<S>>) -> [Double<S>; 3] {
    [Axis::X, Axis::Y, Axis::Z].map(|axis| turned(axis.across(x), axis.across(y)))
}

/// `p − q`, exactly.
fn difference<S: Float>(p: Vec3<S>, q: Vec3<S>) -> Vec3<Double<S>> {
    Vec3::new(Double::sum(p.x, -q.x), Double::sum(p.y, -q.y), Double::sum(p.z, -q.z))
}

fn widened<S: Float>(v: Vec3<S>) -> Vec3<Double<S>> {
    Vec3::new(Double::from(v.x), Double::from(v.y), Double::from(v.z))
}

/// What the line has in the cylinder.
// Always: the answer is handed on in registers. Written to memory in pieces and read as a whole,
// it would wait for the writes.
#[inline(always)]
fn cut<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>) -> Option<Span<S>> {
    let Cylinder { tube, caps } = cylinder;
    let ((at_zero, speed), inside) = if let Some(along) = caps.normal.along() {
        let [o, d, base, n] =
            [line.origin, line.direction, tube.base, caps.normal.vector()].map(|v| along.turned(v));
        let inside = tube.meet_clearly([o[1], o[2]], [base[1], base[2]], [d[1], d[2]]);
        ((n[0] * o[0], n[0] * d[0]), inside)
    } else {
        (heights(cylinder, &{ *line }), None)
    };
    // Copies, so that the caller's line can stay in registers.
    let inside = inside.unwrap_or_else(|| meet(cylinder, &{ *line }));
    caps.passage(at_zero, speed).ends()?.overlap(wall(inside))
}

/// How high a line is above the plane through the scene's origin at t = 0, and how it rises.
#[inline(never)]
fn heights<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>) -> (S, S) {
    let normal = &cylinder.caps.normal;
    (normal.dot(line.origin), normal.dot(line.direction))
}

/// Where a line is inside the wall, wherever it starts and however near to a tangent it is.
#[inline(never)]
fn meet<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>) -> Inside<S> {
    let Cylinder { tube, caps } = cylinder;
    let Some(along) = caps.normal.along() else { return tube.meet_obliquely(&caps.normal, line) };
    let [[_, o @ ..], [_, base @ ..], [_, m @ ..]] =
        [line.origin, tube.base, line.direction].map(|v| along.turned(v));
    tube.meet_carefully(o, base, m)
}

/// Where the wall is crossed; a tangent too, which has no span, and whose part between the caps has
/// none either.
#[inline]
fn wall<S: Float>((enter, exit): Inside<S>) -> Span<S> {
    let [enter, exit] = [enter, exit].map(|t| Crossing { t, face: WALL });
    Span { enter, exit }
}

/// Where the line is within `radius` of `center`, from `|u + t·d|² = r²` with the discriminant
/// `r²|d|² − |u × d|²`: no large squares cancel.
fn meet_ball<S: Float>(center: Vec3<S>, radius: S, line: &Line<S>) -> Option<[S; 2]> {
    let u = line.origin - center;
    let inverse = S::ONE / line.direction.length_squared();
    let middle = -(u.dot_compensated(line.direction)) * inverse;
    let moment = u.cross(line.direction).length_squared();
    let discriminant = radius * radius * line.direction.length_squared() - moment;
    let half = discriminant.positive()?.sqrt() * inverse;
    Some([middle - half, middle + half])
}

/// Where the line crosses the cylinder's wall between the caps.
fn meet_wall<S: Float>(cylinder: &Cylinder<S>, line: &Line<S>) -> [Option<S>; 2] {
    let caps = &cylinder.caps;
    let (enter, exit) = meet(cylinder, line);
    let (at_zero, speed) = (caps.normal.dot(line.origin), caps.normal.dot(line.direction));
    [enter, exit].map(|t| {
        let height = S::add_product(at_zero, t, speed);
        (caps.low <= height && height <= caps.high).then_some(t)
    })
}

macro_rules! intersect {
    ($($Float:ident),+) => {$(
        impl Intersect for $Float {
            #[inline(always)]
            fn cut(cylinder: &Cylinder<Self>, line: &Line<Self>) -> Option<Span<Self>> {
                cut(cylinder, line)
            }

            #[inline]
            fn meet_wall(cylinder: &Cylinder<Self>, line: &Line<Self>) -> [Option<Self>; 2] {
                meet_wall(cylinder, line)
            }

            #[inline]
            fn meet_ball(center: Vec3<Self>, radius: Self, line: &Line<Self>) -> Option<[Self; 2]> {
                meet_ball(center, radius, line)
            }

            #[inline]
            fn pass(slab: &Slab<Self>, line: &Line<Self>) -> Passage<Self> {
                let (at_zero, speed) = (slab.normal.dot(line.origin), slab.normal.dot(line.direction));
                slab.passage(at_zero, speed)
            }
        }
    )+};
}

intersect!(f32, f64);

#[cfg(test)]
mod tests {
    use crate::geom::{Ray, vec3};
    use crate::solid::{Cylinder, Solid};
    use crate::span::SpanList;
    use proptest::prelude::*;
    use std::vec::Vec;

    macro_rules! spans {
        ($Float:ident, $o:expr, $d:expr, $at:expr) => {{
            let ([ox, oy, oz], [dx, dy, dz], [y, z, r]) =
                ($o.map($Float::from), $d.map($Float::from), $at.map($Float::from));
            let solid = Cylinder::<$Float>::along_x(y, z, r, -9.0, 9.0).ok();
            let ray = Ray::<$Float>::new(vec3(ox, oy, oz), vec3(dx, dy, dz)).ok();
            let mut list = SpanList::<$Float, 1>::new();
            let spans = solid.zip(ray).map(|(solid, ray)| {
                solid.trace(&ray, &mut list).iter().map(|s| [s.enter.t, s.exit.t]).collect()
            });
            spans.unwrap_or_else(Vec::<[$Float; 2]>::new)
        }};
    }

    proptest! {
        /// The distance from the axis isn't a number of the type then: its rounding would show.
        #[test]
        fn beside_the_origin_as_well(
            [y, z] in [-3f32..3.0, -3f32..3.0], r in 0.5f32..1.5, gap in -1.5f32..-0.001,
            back in -8f32..8.0, angle in 0f32..6.3, tilt in -0.5f32..0.5,
        ) {
            let (sin, cos) = (angle.sin(), angle.cos());
            let distance = r * (1.0 + gap);
            let o = [0.0, y + distance * cos - back * sin, z + distance * sin + back * cos];
            let d = [tilt, -sin, cos];
            let got = spans!(f32, o, d, [y, z, r]);
            let want = spans!(f64, o, d, [y, z, r]);
            prop_assert_eq!(got.len(), want.len());
            for (got, want) in got.iter().flatten().zip(want.iter().flatten()) {
                let ulp = f64::from((*want as f32).abs().next_up()) - f64::from((*want as f32).abs());
                prop_assert!((f64::from(*got) - want).abs() < 6.0 * ulp, "{got} not {want}");
            }
        }
    }
}
