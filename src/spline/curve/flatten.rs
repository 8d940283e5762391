//! Curves as polylines, and their lengths.

use super::Curve;
use super::triangle::{on_span, polar};
use crate::scalar::{Number, Real, Scalar};
use crate::spline::error::FlattenError;
use crate::spline::point::{Inner, Point, combine, inner, outer};
use crate::spline::scalar::Arithmetic;

/// A point of a curve, and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vertex<P: Point> {
    /// The parameter.
    pub t: P::Scalar,
    /// The curve's point there.
    pub point: P,
}

/// The vertices of a polyline that approximates a curve: see [`Curve::flatten`].
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flatten<'a, P: Point, const K: usize> {
    vertices: Vertices<'a, P, K>,
}

/// The lengths of a curve from its beginning up to the vertices of a polyline: see
/// [`Curve::lengths`].
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lengths<'a, P: Point, const K: usize> {
    vertices: Vertices<'a, P, K>,
    last: Option<Inner<P>>,
    length: <P::Scalar as Arithmetic>::Inner,
    /// What its sums lost by rounding.
    rest: <P::Scalar as Arithmetic>::Inner,
}

/// From vertex to vertex.
#[derive(Debug, Clone)]
struct Vertices<'a, P: Point, const K: usize> {
    knots: &'a [P::Scalar],
    points: &'a [P],
    /// How far the curve may be from a chord.
    tolerance: <P::Scalar as Arithmetic>::Inner,
    /// Where the last vertex is, and the span behind it.
    t: P::Scalar,
    span: usize,
    /// The last vertex; none at the beginning, behind a jump and at the end.
    last: Option<Inner<P>>,
    /// The length of the last piece in the parameter; 0 before there is one.
    step: P::Scalar,
}

impl<P: Point, const K: usize, const C: usize, const N: usize> Curve<P, K, C, N> {
    /// A polyline, from the beginning of the curve to its end, that is nowhere farther from it than
    /// `tolerance`, nor the curve from it: for drawing, and for solids along a curve.
    ///
    /// A piece of the curve and its chord are near each other also in their order: the piece never goes
    /// back along the chord by more than the tolerance. Where a curve jumps, at a knot of multiplicity K,
    /// it is bridged by a segment. Other knots are no vertices of necessity, and a straight line is one
    /// segment.
    ///
    /// ```
    /// use scancsg::{constant, spline::{Curve, Knots}};
    ///
    /// const KNOTS: Knots<f32, 3, 6> = constant!(Knots::<f32, 3, 6>::clamped_uniform(3, 0.0, 1.0));
    /// const ARCH: Curve<[f32; 2], 3, 3, 6> = constant!(Curve::<[f32; 2], 3, 3, 6>::new(
    ///     KNOTS, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]],
    /// ));
    /// let polyline: Vec<_> = ARCH.flatten(0.5)?.map(|vertex| vertex.point).collect();
    /// assert_eq!(polyline.len(), 3);
    /// assert_eq!([polyline[0], polyline[2]], [[0.0, 0.0], [4.0, 0.0]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # How near
    ///
    /// The tolerance holds but for rounding: in fixed point a unit for the vertices, in floating point 5
    /// units in the last place of the largest coordinate of the control points, for orders up to 4. In
    /// floating point a tolerance below two units of that size counts as two. The promise is for all
    /// points at parameters that the number type has: a span without a parameter inside is one segment.
    ///
    /// # How it is found
    ///
    /// The next vertex is as far ahead as a bound of the distance allows. On each span of knots the piece is
    /// cut into up to four Bézier curves. Each lies in the convex hull of its control points (Piegl and
    /// Tiller, *The NURBS Book*, 1997, section 1.3), and the points near a segment are a convex set. So the
    /// piece is near if all control points are. The end is found by doubling or halving the length of the
    /// last piece, then by seven bisections. There are as many segments as a greedy walk takes, and about
    /// 1 % more.
    ///
    /// # Errors
    /// [`FlattenError::Tolerance`] unless the tolerance is positive and finite.
    pub fn flatten(&self, tolerance: P::Scalar) -> Result<Flatten<'_, P, K>, FlattenError> {
        Ok(Flatten { vertices: self.vertices(tolerance)? })
    }

    /// The length of the curve up to each vertex of [`flatten`](Self::flatten), measured along the
    /// polyline; the last one is that of the whole curve.
    ///
    /// With a tolerance τ and chords of a length c, it is short by about 8τ²/3c at each, and by up to 2τ
    /// where the curve turns back. Chords are added
    /// with what rounding left of the sums before (Kahan, *Further remarks on reducing truncation
    /// errors*, 1965), so that many don't lose more than few.
    ///
    /// # Errors
    /// [`FlattenError::Tolerance`] unless the tolerance is positive and finite.
    pub fn lengths(&self, tolerance: P::Scalar) -> Result<Lengths<'_, P, K>, FlattenError> {
        let (vertices, nothing) = (self.vertices(tolerance)?, P::Scalar::ZERO.inner());
        Ok(Lengths { vertices, last: None, length: nothing, rest: nothing })
    }

    fn vertices(&self, tolerance: P::Scalar) -> Result<Vertices<'_, P, K>, FlattenError> {
        if !(tolerance > P::Scalar::ZERO && tolerance.is_finite()) {
            return Err(FlattenError::Tolerance);
        }
        let (knots, points) = (self.knots.as_slice(), self.points());
        let coordinates = |point: &P| {
            point.coordinates().as_ref().iter().fold(P::Scalar::ZERO, |most, x| most.max(x.abs()))
        };
        let largest = points.iter().map(coordinates).fold(P::Scalar::ZERO, P::Scalar::max).wide();
        // Below this, points are as far apart as they are rounded.
        let least =
            P::Scalar::from_wide((largest + largest) * <P::Scalar as Scalar>::Wide::EPSILON);
        Ok(Vertices {
            knots,
            points,
            tolerance: tolerance.max(least).inner(),
            t: self.domain().from,
            span: K - 1,
            last: None,
            step: P::Scalar::ZERO,
        })
    }
}

/// How many bisections look for the end of a piece that is at least half as long as it may be.
const BISECTIONS: u32 = 7;

/// In how many parts a piece is cut where its control points are too far from the chord. It makes the
/// bound 16 times as tight.
const PARTS: u8 = 4;

impl<P: Point, const K: usize> Vertices<'_, P, K> {
    /// The next vertex and its parameter.
    fn step(&mut self) -> Option<(P::Scalar, Inner<P>)> {
        let end = *self.knots.get(self.points.len())?;
        if self.t >= end && self.last.is_none() {
            return None;
        }
        let Some(last) = self.last else {
            self.span = self.span_at(self.t, end);
            self.last = on_span::<P, K>(self.knots, self.points, self.span, self.t);
            return Some((self.t, self.last?));
        };
        // The curve may jump at a knot of multiplicity K.
        let mut repeated = self.knots.iter().zip(self.knots.iter().skip(K - 1));
        let jump = repeated.find(|(low, high)| low == high && **low > self.t);
        let limit = jump.map_or(end, |(knot, _)| knot.min(end));
        let (t, point) = self.longest(last, limit)?;
        self.span = self.span_at(t, limit);
        self.step = t.minus(self.t);
        self.t = t;
        self.last = (t < limit).then_some(point);
        Some((t, point))
    }

    /// The span that begins before or at t, or that ends at `limit`.
    fn span_at(&self, t: P::Scalar, limit: P::Scalar) -> usize {
        self.knots.partition_point(|knot| *knot < limit && *knot <= t).saturating_sub(1)
    }

    /// The end of the longest piece that is found to be near its chord.
    fn longest(&self, from: Inner<P>, limit: P::Scalar) -> Option<(P::Scalar, Inner<P>)> {
        let next = self.t.plus(self.step).min(limit);
        let mut to = if next > self.t { next } else { limit };
        let (mut good, mut bad) = (None, None);
        let mut bisections = 0;
        loop {
            let point = on_span::<P, K>(self.knots, self.points, self.span_at(to, limit), to)?;
            let between = if self.is_near(&mut Chord::new(from, point, self.tolerance), to)? {
                good = Some((to, point));
                match bad {
                    Some(bad) => P::Scalar::between(to, bad, 1, 2),
                    None => to.plus(to.minus(self.t)).min(limit),
                }
            } else {
                bad = Some(to);
                let low = good.map_or(self.t, |(good, _)| good);
                let middle = P::Scalar::between(low, to, 1, 2);
                // No parameter is between two neighbours.
                if good.is_none() && !(low < middle && middle < to) {
                    return Some((to, point));
                }
                middle
            };
            if let Some((t, _)) = good {
                bisections += u32::from(bad.is_some());
                if bisections > BISECTIONS || between <= t || bad.is_some_and(|bad| bad <= between)
                {
                    return good;
                }
            }
            to = between;
        }
    }

    /// Whether the curve from here to a parameter is near a chord.
    fn is_near(&self, chord: &mut Chord<P>, to: P::Scalar) -> Option<bool> {
        let (mut low, mut span) = (self.t, self.span);
        while low < to {
            let high = self.knots.get(span + 1)?.min(to);
            if low < high {
                let mut rest = self.control_points(span, low, high)?;
                if !chord.takes(&rest) {
                    for parts in (1..=PARTS).rev() {
                        if !chord.takes(&cut::<P, K>(&mut rest, parts)) {
                            return Some(false);
                        }
                    }
                }
            }
            (low, span) = (high, span + 1);
        }
        Some(true)
    }

    /// The Bézier control points of a part of a span.
    fn control_points(
        &self,
        span: usize,
        low: P::Scalar,
        high: P::Scalar,
    ) -> Option<[Inner<P>; K]> {
        let mut points = [inner(P::ORIGIN); K];
        for (i, point) in points.iter_mut().enumerate() {
            let at = |level: usize| if level > i { low } else { high };
            *point = polar::<P, K>(self.knots, self.points, span, at)?;
        }
        Some(points)
    }
}

/// Cuts off the first of so many equal parts of a Bézier curve (de Casteljau's algorithm).
fn cut<P: Point, const K: usize>(rest: &mut [Inner<P>; K], parts: u8) -> [Inner<P>; K] {
    let parts = P::Scalar::from_int(parts.into());
    let ratio = P::Scalar::ratio(P::Scalar::ONE, P::Scalar::ZERO, parts);
    let mut first = *rest;
    for (level, cut) in first.iter_mut().enumerate().skip(1) {
        for i in 0..K - level {
            let Some(&b) = rest.get(i + 1) else { break };
            let Some(a) = rest.get_mut(i) else { break };
            combine::<P>(a, b, |a, b| P::Scalar::blend(a, b, ratio));
        }
        if let Some(&point) = rest.first() {
            *cut = point;
        }
    }
    first
}

/// A segment that may stand for a piece of a curve.
struct Chord<P: Point> {
    from: Inner<P>,
    way: Inner<P>,
    length: <P::Scalar as Arithmetic>::Inner,
    tolerance: <P::Scalar as Arithmetic>::Inner,
    /// How far the curve has gone backwards so far.
    backwards: <P::Scalar as Arithmetic>::Inner,
}

impl<P: Point> Chord<P> {
    fn new(from: Inner<P>, to: Inner<P>, tolerance: <P::Scalar as Arithmetic>::Inner) -> Self {
        let mut way = to;
        combine::<P>(&mut way, from, P::Scalar::subtract);
        let length = P::Scalar::norm(way.as_ref());
        Self { from, way, length, tolerance, backwards: P::Scalar::ZERO.inner() }
    }

    /// Whether all control points of a piece are within the tolerance of the segment, and with them the
    /// piece; and whether the pieces so far together go no farther backwards than the tolerance.
    fn takes(&mut self, points: &[Inner<P>]) -> bool {
        let (mut backwards, mut before) = (self.backwards, None);
        let nothing = P::Scalar::ZERO.inner();
        for point in points {
            let mut rest = *point;
            combine::<P>(&mut rest, self.from, P::Scalar::subtract);
            let along = P::Scalar::project(rest.as_ref(), self.way.as_ref(), self.length);
            let nearest = if along < nothing {
                nothing
            } else if along > self.length {
                self.length
            } else {
                along
            };
            combine::<P>(&mut rest, self.way, |rest, way| {
                P::Scalar::subtract(rest, P::Scalar::share(way, nearest, self.length))
            });
            if P::Scalar::norm(rest.as_ref()) > self.tolerance {
                return false;
            }
            if let Some(before) = before
                && along < before
            {
                backwards = P::Scalar::add(backwards, P::Scalar::subtract(before, along));
            }
            before = Some(along);
        }
        let is_onwards = backwards <= self.tolerance;
        if is_onwards {
            self.backwards = backwards;
        }
        is_onwards
    }
}

impl<P: Point, const K: usize> Iterator for Flatten<'_, P, K> {
    type Item = Vertex<P>;

    fn next(&mut self) -> Option<Vertex<P>> {
        let (t, point) = self.vertices.step()?;
        Some(Vertex { t, point: outer(point) })
    }
}

impl<P: Point, const K: usize> Iterator for Lengths<'_, P, K> {
    /// A parameter, and the length of the curve from its beginning to there.
    type Item = (P::Scalar, P::Scalar);

    fn next(&mut self) -> Option<Self::Item> {
        let (t, point) = self.vertices.step()?;
        if let Some(mut chord) = self.last {
            combine::<P>(&mut chord, point, |from, to| P::Scalar::subtract(to, from));
            let chord = P::Scalar::add(P::Scalar::norm(chord.as_ref()), self.rest);
            let length = P::Scalar::add(self.length, chord);
            self.rest = P::Scalar::subtract(chord, P::Scalar::subtract(length, self.length));
            self.length = length;
        }
        self.last = Some(point);
        Some((t, P::Scalar::outer(self.length)))
    }
}
