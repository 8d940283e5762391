//! De Boor's triangle over slices: control points are blended two by two.

use crate::spline::error::EvaluateError;
use crate::spline::point::{Inner, Point, combine, inner, outer};
use crate::spline::scalar::Arithmetic;

/// The highest order whose blends are few enough for quick ratios.
const QUICK: usize = 4;

/// The control points of a span, the K knots from its beginning backwards, and those from its end on.
type Around<'a, P, const K: usize> = (&'a [P; K], [&'a [<P as Point>::Scalar; K]; 2]);

#[inline(always)]
fn around<'a, P: Point, const K: usize>(
    knots: &'a [P::Scalar],
    points: &'a [P],
    span: usize,
) -> Option<Around<'a, P, K>> {
    let first = (span + 1).checked_sub(K)?;
    let points = points.get(first..)?.first_chunk()?;
    Some((points, [knots.get(first..)?.first_chunk()?, knots.get(span + 1..)?.first_chunk()?]))
}

/// Levels 1 to K − 1 of a triangle over the control points of a span: a step changes a point with its
/// right neighbour, given the level and the ends of their knot interval.
#[inline(always)]
fn triangle<P: Point, const K: usize>(
    knots: &[P::Scalar],
    points: &[P],
    span: usize,
    step: impl Fn(usize, &mut Inner<P>, Inner<P>, [P::Scalar; 2]) -> Option<()>,
) -> Option<[Inner<P>; K]> {
    let (points, [low, high]) = around::<P, K>(knots, points, span)?;
    let mut row = points.map(inner);
    for level in 1..K {
        // Loops over an index get unrolled, which chains of iterators don't.
        for i in 0..K - level {
            let (Some(&low), Some(&high)) = (low.get(i + level), high.get(i)) else { break };
            let Some(&b) = row.get(i + 1) else { break };
            step(level, row.get_mut(i)?, b, [low, high])?;
        }
    }
    Some(row)
}

/// The point at a parameter on the span, or at one of its ends.
#[inline]
pub(super) fn point<P: Point, const K: usize>(
    knots: &[P::Scalar],
    points: &[P],
    span: usize,
    t: P::Scalar,
) -> Option<P> {
    let (own, around) = around::<P, K>(knots, points, span)?;
    match P::Scalar::summed(|| own.map(P::coordinates), around, t) {
        Some(coordinates) => Some(P::from_coordinates(coordinates)),
        None => on_span::<P, K>(knots, points, span, t).map(outer),
    }
}

/// The point at a parameter on the span, with its guard bits.
#[inline]
pub(super) fn on_span<P: Point, const K: usize>(
    knots: &[P::Scalar],
    points: &[P],
    span: usize,
    t: P::Scalar,
) -> Option<Inner<P>> {
    polar::<P, K>(knots, points, span, |_| t)
}

/// The polar form of a span's polynomial: the triangle with a parameter for each of its levels, 1 to
/// K − 1. (L. Ramshaw, *Blossoms are polar forms*, Computer Aided Geometric Design 6, 1989.)
#[inline]
pub(super) fn polar<P: Point, const K: usize>(
    knots: &[P::Scalar],
    points: &[P],
    span: usize,
    at: impl Fn(usize) -> P::Scalar,
) -> Option<Inner<P>> {
    let row = triangle::<P, K>(knots, points, span, |level, a, b, [low, high]| {
        let ratio = if K > QUICK { P::Scalar::fine_ratio } else { P::Scalar::ratio };
        let ratio = ratio(at(level), low, high);
        combine::<P>(a, b, |a, b| P::Scalar::blend(a, b, ratio));
        Some(())
    });
    row?.first().copied()
}

/// A derivative at any parameter: `order` levels of differences, then blends.
#[inline(never)]
pub(super) fn derivative<P: Point, const K: usize>(
    knots: &[P::Scalar],
    points: &[P],
    span: usize,
    order: usize,
    t: P::Scalar,
) -> Result<P, EvaluateError> {
    if order >= K {
        return Ok(P::ORIGIN);
    }
    let row = triangle::<P, K>(knots, points, span, |level, a, b, [low, high]| {
        if level <= order {
            let degree = (K - level) as u16;
            combine::<P>(a, b, |a, b| P::Scalar::slope(a, b, degree, low, high));
        } else {
            let ratio = P::Scalar::ratio(t, low, high);
            combine::<P>(a, b, |a, b| P::Scalar::blend(a, b, ratio));
        }
        a.as_ref().iter().all(|x| P::Scalar::is_within(*x)).then_some(())
    });
    let point = row.and_then(|row| row.first().copied()).ok_or(EvaluateError::Overflow)?;
    let mut coordinates = P::ORIGIN.coordinates();
    for (x, inner) in coordinates.as_mut().iter_mut().zip(point.as_ref()) {
        *x = P::Scalar::checked(*inner).ok_or(EvaluateError::Overflow)?;
    }
    Ok(P::from_coordinates(coordinates))
}
