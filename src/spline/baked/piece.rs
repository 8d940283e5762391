//! A piece of a baked curve: polynomials of all coordinates, and Horner's rule.

use crate::spline::point::Point;
use crate::spline::scalar::Arithmetic;

/// The polynomials of a span, or of a part of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece<LocalMap, Row, Bases, const K: usize> {
    /// A row for each power, of the highest one first.
    pub(super) coefficients: [Row; K],
    pub(super) map: LocalMap,
    pub(super) base: Bases,
}

/// The piece of a curve of points of a kind.
pub(super) type PieceOf<P, const K: usize> = Piece<
    <<P as Point>::Scalar as Arithmetic>::LocalMap,
    <P as Point>::Array<<<P as Point>::Scalar as Arithmetic>::Coefficient>,
    <P as Point>::Array<<<P as Point>::Scalar as Arithmetic>::Base>,
    K,
>;

/// The lowest order whose rounding errors take more than Horner's rule to be small.
const HIGH: usize = 6;

/// The point at a parameter of the piece.
#[inline]
pub(super) fn value<P: Point, const K: usize>(piece: &PieceOf<P, K>, t: P::Scalar) -> P {
    // There is a coefficient for an order above 0.
    let Some((first, rest)) = piece.coefficients.split_first() else { return P::ORIGIN };
    let local = P::Scalar::local(t, &piece.map);
    let mut sums = *first;
    for (i, coefficients) in rest.iter().enumerate() {
        let step = if K >= HIGH && i + 2 == K { P::Scalar::last } else { P::Scalar::horner };
        for (sum, c) in sums.as_mut().iter_mut().zip(coefficients.as_ref()) {
            *sum = step(*sum, local, *c);
        }
    }
    let mut point = P::ORIGIN.coordinates();
    let values = sums.as_ref().iter().zip(piece.base.as_ref());
    for (x, (sum, base)) in point.as_mut().iter_mut().zip(values) {
        *x = P::Scalar::baked(*sum, *base, &piece.map);
    }
    P::from_coordinates(point)
}

/// A derivative at any parameter; `None` out of the type's range.
pub(super) fn derivative<P: Point, const K: usize>(
    piece: &PieceOf<P, K>,
    order: usize,
    t: P::Scalar,
) -> Option<P> {
    let mut point = P::ORIGIN.coordinates();
    for (d, (x, base)) in point.as_mut().iter_mut().zip(piece.base.as_ref()).enumerate() {
        let powers = piece.coefficients.iter().rev().enumerate().rev();
        let terms = powers
            .take_while(|(power, _)| *power >= order)
            .filter_map(|(power, of)| Some((power, *of.as_ref().get(d)?)));
        *x = P::Scalar::extended(terms, *base, order, t, &piece.map)?;
    }
    Some(P::from_coordinates(point))
}
