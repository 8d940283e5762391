//! Polylines against a greedy walk over close samples of the curve, in `f64`: another evaluation, another
//! search, another measure of distance.

use crate::numeric::Numeric;
use scancsg::scalar::I16F16;
use scancsg::spline::{Curve, Knots, Vertex};
use testkit::random::Random;

type P = [f64; 2];

/// A clamped cubic as numbers, made by the textbook's recurrence for basis functions.
struct Model {
    knots: Vec<f64>,
    points: Vec<P>,
}

impl Model {
    fn basis(&self, i: usize, order: usize, t: f64) -> f64 {
        let knot = |i: usize| self.knots[i];
        if order == 1 {
            return f64::from(u8::from(knot(i) <= t && t < knot(i + 1)));
        }
        let part = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
        part(t - knot(i), knot(i + order - 1) - knot(i)) * self.basis(i, order - 1, t)
            + part(knot(i + order) - t, knot(i + order) - knot(i + 1))
                * self.basis(i + 1, order - 1, t)
    }

    fn value(&self, t: f64) -> P {
        let weights = (0..self.points.len()).map(|i| self.basis(i, 4, t));
        weights.zip(&self.points).fold([0.0; 2], |sum, (weight, point)| {
            [sum[0] + weight * point[0], sum[1] + weight * point[1]]
        })
    }

    /// Close samples, from the beginning to just before the end.
    fn samples(&self, count: u32) -> Vec<P> {
        let end = self.knots[self.knots.len() - 1];
        let last = end * (1.0 - 1e-12);
        let at = |i: u32| (end * f64::from(i) / f64::from(count)).min(last);
        (0..=count).map(|i| self.value(at(i))).collect()
    }
}

fn distance(point: P, [a, b]: [P; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let (x, y) = (point[0] - a[0], point[1] - a[1]);
    let along = ((x * dx + y * dy) / (dx * dx + dy * dy).max(1e-300)).clamp(0.0, 1.0);
    (x - along * dx).hypot(y - along * dy)
}

/// How many segments a walk takes that goes on as long as all samples are within the tolerance.
fn greedy(samples: &[P], tolerance: f64) -> usize {
    let (mut from, mut segments) = (0, 0);
    while from + 1 < samples.len() {
        let fits = |to: usize| {
            let chord = [samples[from], samples[to]];
            samples[from..to].iter().all(|&point| distance(point, chord) <= tolerance)
        };
        from = (from + 1..samples.len()).take_while(|&to| fits(to)).last().unwrap();
        segments += 1;
    }
    segments
}

fn cubic<S: Numeric>(model: &Model) -> Curve<[S; 2], 4, 8, 12> {
    let knots: Vec<S> = model.knots.iter().map(|&t| S::of(t)).collect();
    let points: Vec<[S; 2]> = model.points.iter().map(|point| point.map(S::of)).collect();
    S::curve(S::knots(&knots).unwrap(), &points).unwrap()
}

/// A cubic whose numbers have few digits, so that every type has them.
fn random_cubic(random: &mut Random, is_even: bool) -> Model {
    let digits = |x: f64| (x * 1024.0).round() / 1024.0;
    let mut inner: Vec<f64> = (0..4).map(|_| digits(random.between(0.1, 4.9))).collect();
    inner.sort_by(f64::total_cmp);
    if is_even {
        inner = vec![1.0, 2.0, 3.0, 4.0];
    }
    let knots = [vec![0.0; 4], inner, vec![5.0; 4]].concat();
    let points = (0..8).map(|_| [(); 2].map(|()| digits(random.between(-10.0, 10.0)))).collect();
    Model { knots, points }
}

fn points<S: Numeric>(vertices: &[Vertex<[S; 2]>]) -> Vec<P> {
    vertices.iter().map(|vertex| vertex.point.map(|x| x.ratio().to_f64())).collect()
}

/// Each piece is near its chord, and each chord near its piece. How far they are at most.
fn farthest<S: Numeric>(model: &Model, vertices: &[Vertex<[S; 2]>], limit: f64) -> f64 {
    let ends = points(vertices);
    let mut farthest = 0f64;
    for (chord, times) in ends.windows(2).zip(vertices.windows(2)) {
        let [a, b] = [chord[0], chord[1]];
        let [from, to] = [&times[0], &times[1]].map(|vertex| vertex.t.ratio().to_f64());
        let at = |i: u32| (from + (to - from) * f64::from(i) / 64.0).min(5.0 - 1e-11);
        let piece: Vec<P> = (0..=64).map(|i| model.value(at(i))).collect();
        let far = piece.iter().map(|&point| distance(point, [a, b])).fold(0.0, f64::max);
        let gap = (0..=16).map(|i| f64::from(i) / 16.0).map(|s| {
            let point = [a[0] + (b[0] - a[0]) * s, a[1] + (b[1] - a[1]) * s];
            let near = |p: &[P]| distance(point, [p[0], p[1]]);
            piece.windows(2).map(near).fold(f64::MAX, f64::min)
        });
        assert!(far.max(gap.fold(0.0, f64::max)) <= limit, "{far} > {limit}");
        farthest = farthest.max(far);
    }
    farthest
}

/// Within 1.1 times the segments of the greedy walk, and near the curve.
#[test]
fn as_few_segments_as_a_greedy_walk() {
    let mut random = Random::named("polylines");
    let (mut taken, mut needed, mut farthest_of_all) = ([0; 3], 0, 0f64);
    for i in 0..200 {
        let model = random_cubic(&mut random, i % 2 == 0);
        let tolerance = [0.5, 0.05, 0.01][i % 3];
        let samples = model.samples(if cfg!(debug_assertions) { 3000 } else { 8000 });
        needed += greedy(&samples, tolerance);
        fn of<S: Numeric>(model: &Model, tolerance: f64) -> (usize, f64) {
            let curve = cubic::<S>(model);
            let vertices: Vec<_> = curve.flatten(S::of(tolerance)).unwrap().collect();
            // A unit for each end of a chord, and one for the tolerance.
            let limit = tolerance * (1.0 + 1e-3) + 3.0 * S::ulp(10.0);
            (vertices.len() - 1, farthest(model, &vertices, limit))
        }
        let of = [of::<f32>, of::<f64>, of::<I16F16>].map(|of| of(&model, tolerance));
        for (taken, (segments, far)) in taken.iter_mut().zip(of) {
            *taken += segments;
            farthest_of_all = farthest_of_all.max(far / tolerance);
        }
    }
    println!("{taken:?} segments, {needed} needed");
    assert!(taken.iter().all(|taken| taken * 10 <= needed * 11), "{taken:?}, {needed} needed");
    assert!(farthest_of_all > 0.95, "{farthest_of_all}");
}

/// Control points on a line, unevenly spaced, over uneven knots.
fn a_straight_line_is_one_segment<S: Numeric, const K: usize>() {
    let inner = [0.25, 1.0, 1.5, 4.0];
    let knots = [vec![0.0; K], inner[..8 - K.max(4)].to_vec(), vec![5.0; K]].concat();
    let knots: Vec<S> = knots.into_iter().map(S::of).collect();
    let points: Vec<[S; 2]> = [0.0, 0.5, 0.75, 4.0, 4.25, 30.0, 31.0, 90.0]
        .map(|x| [S::of(3.0 * x - 100.0), S::of(50.0 - x)])
        .into_iter()
        .take(knots.len() - K)
        .collect();
    let curve = S::curve::<K, 8, 14>(S::knots(&knots).unwrap(), &points).unwrap();
    let vertices: Vec<_> = curve.flatten(S::of(0.001)).unwrap().collect();
    assert_eq!(vertices.len(), 2, "order {K}");
    assert_eq!([vertices[0].point, vertices[1].point], [points[0], points[points.len() - 1]]);
    let lengths: Vec<_> = curve.lengths(S::of(0.001)).unwrap().map(|(t, _)| t).collect();
    assert_eq!(lengths, [S::of(0.0), S::of(5.0)]);
}

#[test]
fn straight_lines_are_one_segment() {
    fn of<S: Numeric>() {
        a_straight_line_is_one_segment::<S, 2>();
        a_straight_line_is_one_segment::<S, 3>();
        a_straight_line_is_one_segment::<S, 4>();
        a_straight_line_is_one_segment::<S, 5>();
        a_straight_line_is_one_segment::<S, 6>();
    }
    of::<f32>();
    of::<f64>();
    of::<I16F16>();
}

/// A parabola on a line: t(2 − t)/2·40 + t²/4·4 = 40·t − 19·t², from 0 by way of 400/19 to 4.
fn folded<S: Numeric>() {
    let knots = [0.0, 0.0, 0.0, 2.0, 2.0, 2.0].map(S::of);
    let controls = [0.0, 40.0, 4.0].map(|x| [S::of(x), S::of(1.0)]);
    let curve = S::curve::<3, 3, 6>(S::knots(&knots).unwrap(), &controls).unwrap();
    let farthest = 400.0 / 19.0;
    let tolerance = 0.01;
    let vertices: Vec<_> = curve.flatten(S::of(tolerance)).unwrap().collect();
    let most = points(&vertices).iter().map(|point| point[0]).fold(0.0, f64::max);
    assert!((farthest - most).abs() <= tolerance * 1.01, "{most}");
    assert!(vertices.len() <= 4, "{}", vertices.len());
    let (_, length) = curve.lengths(S::of(tolerance)).unwrap().last().unwrap();
    let exact = 2.0 * farthest - 4.0;
    assert!((length.ratio().to_f64() - exact).abs() <= 4.0 * tolerance, "{length:?} {exact}");
}

#[test]
fn a_line_that_turns_back_has_a_vertex_there() {
    folded::<f32>();
    folded::<f64>();
    folded::<I16F16>();
}

/// A curve of two pieces that don't meet, and one whose pieces meet in a corner.
fn jumps<S: Numeric>() {
    let knots =
        S::knots::<3, 9>(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0].map(S::of)).unwrap();
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 5.0], [3.0, 5.0], [4.0, 5.0]];
    let points = points.map(|point| point.map(S::of));
    let curve = S::curve::<3, 6, 9>(knots, &points).unwrap();
    let vertices: Vec<_> = curve.flatten(S::of(0.1)).unwrap().collect();
    let expected = [(0.0, points[0]), (1.0, points[2]), (1.0, points[3]), (2.0, points[5])];
    assert_eq!(vertices, expected.map(|(t, point)| Vertex { t: S::of(t), point }));

    let knots = S::knots::<3, 8>(&[0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0].map(S::of)).unwrap();
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0]];
    let points = points.map(|point| point.map(S::of));
    let curve = S::curve::<3, 5, 8>(knots, &points).unwrap();
    let vertices: Vec<_> = curve.flatten(S::of(0.0625)).unwrap().collect();
    let near = |vertex: &Vertex<[S; 2]>| {
        let [x, y] = vertex.point.map(|x| x.ratio().to_f64());
        (x - 2.0).hypot(y) <= 0.0626
    };
    assert!(vertices.len() <= 4 && vertices.iter().any(near), "{vertices:?}");

    // Order 1: constant from knot to knot.
    let knots = S::knots::<1, 4>(&[0.0, 1.0, 2.0, 3.0].map(S::of)).unwrap();
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]].map(|point| point.map(S::of));
    let curve = S::curve::<1, 3, 4>(knots, &points).unwrap();
    let vertices = curve.flatten(S::of(0.0625)).unwrap().map(|vertex| vertex.point);
    let twice = points.into_iter().flat_map(|point| [point; 2]);
    assert_eq!(vertices.collect::<Vec<_>>(), twice.collect::<Vec<_>>());
}

#[test]
fn jumps_are_bridged() {
    jumps::<f32>();
    jumps::<f64>();
    jumps::<I16F16>();
}

/// Neighbouring numbers have none between them, and points are no nearer than they are rounded. So work is
/// bounded, whatever the tolerance is.
#[test]
fn no_tolerance_is_too_small() {
    let next = 1f32.next_up();
    let knots = Knots::<f32, 3, 6>::new(&[1.0, 1.0, 1.0, next, next, next]).unwrap();
    let points = [[0.0, 0.0], [1000.0, 1000.0], [0.0, 0.0]];
    let curve = Curve::<[f32; 2], 3, 3, 6>::new(knots, points).unwrap();
    let vertices: Vec<_> = curve.flatten(1e-14).unwrap().collect();
    assert_eq!(vertices, [1.0, next].map(|t| Vertex { t, point: [0.0, 0.0] }));

    let mut random = Random::named("small tolerances");
    for i in 0..if cfg!(debug_assertions) { 4 } else { 100 } {
        let model = random_cubic(&mut random, i % 2 == 0);
        let count = cubic::<f32>(&model).flatten(f32::from_bits(1)).unwrap().count();
        assert!((100..8000).contains(&count), "{count}");
        let count = cubic::<I16F16>(&model).flatten(I16F16::from_bits(1)).unwrap().count();
        assert!((100..8000).contains(&count), "{count}");
    }
}
