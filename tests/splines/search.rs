//! A search for the curve in `f32`, of both forms, that is farthest off: random ones, and then small changes to the
//! worst. It is held against `f64`, whose own errors are 10⁻⁸ of these.

use scancsg::spline::{Curve, Knots, Outside};

/// One span: all knots and control points that it depends on.
#[derive(Debug, Clone, Copy)]
struct Case<const K: usize, const N: usize> {
    knots: [f32; N],
    points: [f32; K],
    t: f32,
}

/// A linear congruential generator: the same numbers every time.
struct Source(u64);

impl Source {
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 32) as u32
    }

    fn below(&mut self, count: u32) -> u32 {
        self.next() % count
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.next()) / f64::from(u32::MAX)
    }
}

impl<const K: usize, const N: usize> Case<K, N> {
    fn random(random: &mut Source) -> Self {
        let (steps, ends) = (random.below(3), random.below(4));
        let mut knot = [0.0, random.between(-3.0, 3.0), random.between(-100.0, 100.0)]
            [random.below(3) as usize];
        let knots = std::array::from_fn(|i| {
            let is_end = i > 0 && (ends & 1 > 0 && i < K || ends & 2 > 0 && i > K);
            let step = match (steps, random.below(3)) {
                (0, _) => random.between(0.5, 1.5),
                (1, 0) | (2, 0) if i != K => 0.0,
                (1, _) => random.between(-12.0, 0.0).exp2(),
                _ => f64::from(1 + random.below(40)) / 4.0,
            };
            knot += if is_end { 0.0 } else { step };
            knot as f32
        });
        // Just below a power of two, where a unit is smallest.
        let points = std::array::from_fn(|_| {
            let sign = if random.below(2) > 0 { 2.0 } else { -2.0 };
            (sign * random.between(0.97, 0.99999)) as f32
        });
        let part = [random.between(0.0, 0.1), random.between(0.9, 1.0), random.between(0.0, 1.0)]
            [random.below(3) as usize];
        let mut made = Self { knots, points, t: 0.0 };
        let [from, to] = made.span().map(f64::from);
        made.t = ((from + (to - from) * part) as f32).clamp(from as f32, to as f32);
        made
    }

    fn span(&self) -> [f32; 2] {
        [self.knots[K - 1], self.knots[K]]
    }

    /// One or two of its numbers a little larger or smaller.
    fn changed(mut self, random: &mut Source) -> Self {
        for _ in 0..1 + random.below(2) {
            let place = random.below((N + K + 1) as u32) as usize;
            let Self { knots, points, t } = &mut self;
            let mut numbers = knots.iter_mut().chain(points).chain([t]);
            let number = numbers.nth(place).unwrap();
            let most = 1 << random.below(16);
            let units = random.below(2 * most + 1).wrapping_sub(most);
            let changed = f32::from_bits(number.to_bits().wrapping_add(units));
            if changed.abs() < 200.0 && (place < N || place == N + K || changed.abs() < 2.0) {
                *number = changed;
            }
        }
        self
    }

    /// How many units each form is off, if it is a curve.
    fn errors(&self) -> Option<[f64; 2]> {
        let knots = Knots::<f32, K, N>::new(&self.knots).ok()?;
        let curve = Curve::<f32, K, K, N>::new(knots, self.points).ok()?;
        let baked = curve.bake::<1>().ok()?.value(self.t, Outside::Error).ok()?;
        let got = [curve.value(self.t, Outside::Error).ok()?, baked];
        let mut blended = self.points.map(f64::from);
        let t = f64::from(self.t);
        for level in 1..K {
            for i in 0..K - level {
                let [low, high] = [self.knots[i + level], self.knots[K + i]].map(f64::from);
                let ratio = (t - low) / (high - low);
                blended[i] = blended[i] * (1.0 - ratio) + blended[i + 1] * ratio;
            }
        }
        let size = self.points.iter().fold(0f32, |most, x| most.max(x.abs()));
        let unit = f64::from(size).log2().floor().exp2() * f64::from(f32::EPSILON);
        Some(got.map(|got| (f64::from(got) - blended[0]).abs() / unit))
    }
}

fn search<const K: usize, const N: usize>(limits: [f64; 2]) {
    for (form, limit) in limits.into_iter().enumerate() {
        let mut random = Source(1);
        let (mut worst, mut most) = (None, 0.0);
        for i in 0..30_000 {
            let case = match worst {
                Some(worst) if i >= 10_000 => Case::changed(worst, &mut random),
                _ => Case::<K, N>::random(&mut random),
            };
            let Some(error) = case.errors().map(|errors| errors[form]) else { continue };
            assert!(error <= limit, "{error} units: {case:?}");
            if error >= most {
                (worst, most) = (Some(case), error);
            }
        }
        println!("order {K}, form {form}: {most:.2} units, {worst:?}");
    }
}

#[test]
fn no_search_finds_a_curve_beyond_the_limits() {
    // Editable and baked.
    search::<2, 4>([1.0, 2.0]);
    search::<3, 6>([1.0, 3.1]);
    search::<4, 8>([1.0, 3.7]);
    search::<5, 10>([1.5, 6.0]);
    search::<6, 12>([2.5, 6.0]);
}
