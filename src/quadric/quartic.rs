//! Where a line is inside a torus: in `f64` for all number types.
//!
//! With R and r the radii of ring and tube, z along the axis and ρ across it, a point is inside where
//! `g = z² + (ρ − R)² − r²` is negative. Along a line that is counted from its point p nearest to the
//! centre, by its length s, `F = g·(z² + (ρ + R)² − r²)` is a polynomial with the signs of g:
//!
//! ```text
//! F  = (s² + |p|² + R² − r²)² − 4R²ρ²
//! F' = 4(s³ + a·s + b),  a = |p|² + R² − r² − 2R²|m|²,  b = −2R² q·m
//! ```
//!
//! q and m are p and the direction across the axis. F has one lowest point where s < 0 and one where
//! s > 0, at most. They are roots of a cubic that is convex on either side, so Newton's steps from the
//! end of the bounding ball can't pass them. Whether the line is inside there, and outside at the highest
//! point between them, decides how many spans it has: that is the sign of g, in which no large terms
//! cancel. Between a lowest point inside and a point outside is one root. F is expanded about the lowest
//! point, with g there, so that the root of a grazing line keeps its digits. All loops are bounded.

use crate::numeric::Native;
use crate::scalar::{Double, Real, two_sum};
use core::marker::PhantomData;

/// Newton's steps to a lowest or highest point at most. Five are usual; where two of them nearly
/// coincide, each step leaves half of the way.
const STEPS: u32 = 48;

/// Newton's steps from a lowest point to a crossing at most. Four are usual.
const FEW_STEPS: u32 = 8;

/// Of a bracket, where these are not enough.
const HALVES: u32 = 60;

type Vector = [f64; 3];

fn dot([x0, x1, x2]: Vector, [y0, y1, y2]: Vector) -> f64 {
    x0 * y0 + x1 * y1 + x2 * y2
}

/// A torus in `f64`, for lines in numbers of type `S`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ReadyTorus<S> {
    center: Vector,
    /// The axis, and two directions across it.
    frame: [Vector; 3],
    ring: f64,
    tube: f64,
    of: PhantomData<S>,
}

/// A value of g, at a distance from the axis.
struct Value {
    g: f64,
    rho: f64,
}

/// A line as a torus sees it: counted by its length, from its point nearest to the centre.
struct Path<'a, S> {
    torus: &'a ReadyTorus<S>,
    /// The point's coordinates, in the order of the torus's frame, and the direction's.
    p: Vector,
    d: Vector,
    /// The cubic's coefficients.
    a: f64,
    b: f64,
}

impl<S> ReadyTorus<S> {
    /// The basis around the axis is that of Duff et al., *Building an Orthonormal Basis, Revisited*
    /// (2017). Along coordinate axes it is exact.
    pub(super) fn new(center: Vector, axis: Vector, ring: f64, tube: f64) -> Self {
        let length = dot(axis, axis).root();
        let [x, y, z] = axis.map(|coordinate| coordinate / length);
        let sign = 1f64.copysign(z);
        let a = -1.0 / (sign + z);
        let b = x * y * a;
        let first = [1.0 + sign * x * x * a, sign * b, -sign * x];
        let second = [b, sign + y * y * a, -y];
        Self { center, frame: [[x, y, z], first, second], ring, tube, of: PhantomData }
    }

    /// The parts of a line inside, in order.
    pub(super) fn chords(&self, origin: Vector, direction: Vector) -> [Option<[f64; 2]>; 2] {
        let reach = self.ring + self.tube;
        let square = dot(direction, direction);
        let from_center = [0, 1, 2].map(|i| origin[i] - self.center[i]);
        let is_far = dot(from_center, from_center) > 65_536.0 * reach * reach;
        let (near, t) = if is_far {
            self.foot_from_afar(origin, direction, square)
        } else {
            foot(from_center, direction, square)
        };
        let distance_squared = dot(near, near);
        // Not for NaN either.
        let Some(half_squared) = (reach * reach - distance_squared).positive() else {
            return [None; 2];
        };
        let half = half_squared.root();
        let per_length = 1.0 / square.root();
        let p = self.frame.map(|side| dot(side, near));
        let d = self.frame.map(|side| dot(side, direction) * per_length);
        let ([z, x, y], [dz, dx, dy]) = (p, d);
        // Between the planes that touch the tube: infinity or NaN for lines along them.
        let planes = [-self.tube - z, self.tube - z].map(|height| height / dz);
        let low = planes[0].min(planes[1]).max(-half);
        let high = planes[0].max(planes[1]).min(half);
        let (across_squared, slope) = (dx * dx + dy * dy, x * dx + y * dy);
        let rho_squared = |s: f64| x * x + y * y + s * (slope + slope + s * across_squared);
        let hole = self.ring - self.tube;
        if low >= high || rho_squared(low).max(rho_squared(high)) < hole * hole {
            return [None; 2];
        }
        let ring_squared = self.ring * self.ring;
        let a = distance_squared + hole * reach - 2.0 * ring_squared * across_squared;
        let b = -2.0 * ring_squared * slope;
        let path = Path { torus: self, p, d, a, b };
        path.chords([low, high]).map(|chord| chord.map(|ends| ends.map(|s| t + s * per_length)))
    }

    /// The same as [`foot`] for a line from afar: the differences' and products' errors are kept.
    #[cold]
    fn foot_from_afar(&self, origin: Vector, direction: Vector, square: f64) -> (Vector, f64) {
        let differences = [0, 1, 2].map(|i| two_sum(origin[i], -self.center[i]));
        let (_, t) = foot(differences.map(|(high, _)| high), direction, square);
        let near = [0, 1, 2].map(|i| {
            let (high, low) = differences[i];
            let way = Double::product(t, direction[i]);
            let (sum, lost) = two_sum(high, way.high);
            sum + (lost + (low + way.low))
        });
        // Of the distance's last digits, the rest is as far from the foot as the distance was.
        let (near, rest) = foot(near, direction, square);
        (near, t + rest)
    }
}

/// The line's point nearest to the centre, as seen from there, and its parameter.
fn foot(from_center: Vector, direction: Vector, square: f64) -> (Vector, f64) {
    let t = -dot(from_center, direction) / square;
    ([0, 1, 2].map(|i| from_center[i] + t * direction[i]), t)
}

impl<S> Path<'_, S> {
    fn value(&self, s: f64) -> Value {
        let [z, x, y] = [0, 1, 2].map(|i| self.p[i] + s * self.d[i]);
        let rho = (x * x + y * y).root();
        let off = rho - self.torus.ring;
        Value { g: z * z + (off - self.torus.tube) * (off + self.torus.tube), rho }
    }

    fn chords(&self, [low, high]: [f64; 2]) -> [Option<[f64; 2]>; 2] {
        let first = self.lowest(-self.b, -low).map(|s| -s);
        let last = self.lowest(self.b, high);
        let inside = |s: Option<f64>| {
            s.filter(|&s| low < s && s < high).and_then(|s| {
                let value = self.value(s);
                (value.g < 0.0).then_some((s, value))
            })
        };
        match (inside(first), inside(last)) {
            (None, None) => [None; 2],
            (Some(deep), None) => [Some(self.around(&deep, low, last.unwrap_or(high))), None],
            (None, Some(deep)) => [Some(self.around(&deep, first.unwrap_or(low), high)), None],
            (Some(one), Some(other)) => {
                let between = self.highest();
                if self.value(between).g > 0.0 {
                    let [one, other] = [(&one, low, between), (&other, between, high)];
                    return [one, other]
                        .map(|(deep, low, high)| Some(self.around(deep, low, high)));
                }
                [Some([self.crossing(&one, low), self.crossing(&other, high)]), None]
            }
        }
    }

    /// The largest root of s³ + a·s + b, if it is where the cubic is convex and before `end`.
    fn lowest(&self, b: f64, end: f64) -> Option<f64> {
        let Self { a, .. } = *self;
        let value = |s: f64| (s * s + a) * s + b;
        let start = if a < 0.0 { (-a / 3.0).root() } else { 0.0 };
        if start >= end || value(start) > 0.0 || value(end) <= 0.0 {
            return None;
        }
        // The next step's error is about the square of this one, and that of g its square again.
        let close = self.torus.tube * (1.0 / 16_384.0);
        let mut s = end;
        for _ in 0..STEPS {
            let Some(step) = (value(s) / (3.0 * s * s + a)).positive() else { break };
            s -= step;
            if step < close {
                break;
            }
        }
        Some(s.max(start))
    }

    /// The root of s³ + a·s + b between two others: the cubic falls there, and is convex on the root's side
    /// of 0.
    fn highest(&self) -> f64 {
        let Self { a, b, .. } = *self;
        let mut s = 0.0;
        for _ in 0..STEPS {
            let next = s - ((s * s + a) * s + b) / (3.0 * s * s + a);
            if next == s || next.abs() < s.abs() || next.is_nan() {
                break;
            }
            s = next;
        }
        s
    }

    /// Where the line enters before a point inside, and where it exits behind it.
    fn around(&self, deep: &(f64, Value), low: f64, high: f64) -> [f64; 2] {
        [low, high].map(|end| self.crossing(deep, end))
    }

    /// The root of g between a lowest point of F inside, and a point that isn't inside.
    fn crossing(&self, (inside, value): &(f64, Value), outside: f64) -> f64 {
        let (inside, g) = (*inside, value.g);
        // F = δ⁴ + skew·δ³ + bend·δ² + slope·δ − depth, for s = inside + δ: by Newton's steps.
        let depth = -g * (g + 4.0 * self.torus.ring * value.rho);
        let slope = 4.0 * ((inside * inside + self.a) * inside + self.b);
        let (skew, bend) = (4.0 * inside, 2.0 * (3.0 * inside * inside + self.a));
        let mut way = (depth / bend).root().copysign(outside - inside);
        let is_between = |s: f64, [one, other]: [f64; 2]| one.min(other) < s && s < one.max(other);
        for _ in 0..FEW_STEPS {
            let value = (((way + skew) * way + bend) * way + slope) * way - depth;
            let ascent = ((4.0 * way + 3.0 * skew) * way + 2.0 * bend) * way + slope;
            let step = value / ascent;
            way -= step;
            // Newton's step leaves about the square of this one.
            if step.abs() <= way.abs() * (1.0 / (1u64 << 27) as f64) {
                if is_between(inside + way, [inside, outside]) {
                    return inside + way;
                }
                break;
            }
        }
        // By halves: where F is flat, and where it is so short of digits that steps lead elsewhere.
        let [mut near, mut far] = [inside, outside];
        for _ in 0..HALVES {
            let middle = 0.5 * (near + far);
            if self.value(middle).g < 0.0 { near = middle } else { far = middle }
        }
        far
    }
}
