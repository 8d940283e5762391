//! De Boor's triangle over slices: control points are blended two by two.

use crate::spline::error::EvaluateError;
use crate::spline::point::{Inner, Point, combine, inner};
use crate::spline::scalar::SplineScalar;

/// The control points of a span, and the knots t_{j−k+1} … t_j and t_{j+1} … t_{j+k}.
#[inline]
#[allow(clippy::type_complexity)]
fn segment<'a, P: Point, const K: usize>(
    knots: &'a [P::Scalar],
    points: &'a [P],
    span: usize,
) -> Option<(&'a [P; K], &'a [P::Scalar; K], &'a [P::Scalar; K])> {
    let first = (span + 1).checked_sub(K)?;
    Some((
        points.get(first..)?.first_chunk()?,
        knots.get(first..)?.first_chunk()?,
        knots.get(span + 1..)?.first_chunk()?,
    ))
}

/// The highest order whose blends are few enough for quick ratios.
const QUICK: usize = 4;

/// De Boor's triangle on a span, for parameters on it.
#[inline]
pub(in crate::spline) fn on_span<P: Point, const K: usize>(
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
    let (points, low, high) = segment::<P, K>(knots, points, span)?;
    let mut blended = points.map(inner);
    for level in 1..K {
        // Loops over an index get unrolled, which chains of iterators don't.
        for i in 0..K - level {
            let (Some(&low), Some(&high)) = (low.get(i + level), high.get(i)) else { break };
            let Some(&b) = blended.get(i + 1) else { break };
            let Some(a) = blended.get_mut(i) else { break };
            let ratio = if K > QUICK { P::Scalar::fine_ratio } else { P::Scalar::ratio };
            let ratio = ratio(at(level), low, high);
            combine::<P>(a, b, |a, b| P::Scalar::blend(a, b, ratio));
        }
    }
    blended.first().copied()
}

/// A derivative on a span: `order` levels of differences, then blends.
#[inline(never)]
pub(in crate::spline) fn derivative<P: Point, const K: usize>(
    knots: &[P::Scalar],
    points: &[P],
    span: usize,
    order: usize,
    t: P::Scalar,
) -> Result<P, EvaluateError> {
    let segment = segment::<P, K>(knots, points, span);
    let Some((points, low, high)) = segment.filter(|_| order < K) else {
        return Ok(P::ORIGIN);
    };
    let mut blended = points.map(inner);
    for level in 1..K {
        let degree = (K - level) as u16;
        let intervals = low.iter().skip(level).zip(high);
        let mut rest = blended.as_mut_slice();
        for (&low, &high) in intervals {
            let [a, others @ ..] = rest else { break };
            let Some(&b) = others.first() else { break };
            if level <= order {
                combine::<P>(a, b, |a, b| P::Scalar::slope(a, b, degree, low, high));
            } else {
                let ratio = P::Scalar::ratio(t, low, high);
                combine::<P>(a, b, |a, b| P::Scalar::blend(a, b, ratio));
            }
            if !a.as_ref().iter().all(|x| P::Scalar::is_within(*x)) {
                return Err(EvaluateError::Overflow);
            }
            rest = others;
        }
    }
    let Some(&point) = blended.first() else { return Ok(P::ORIGIN) };
    let mut coordinates = P::ORIGIN.coordinates();
    for (x, inner) in coordinates.as_mut().iter_mut().zip(point.as_ref()) {
        *x = P::Scalar::checked(*inner).ok_or(EvaluateError::Overflow)?;
    }
    Ok(P::from_coordinates(coordinates))
}
