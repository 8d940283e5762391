//! What a log says about splines.

use super::baked::Baked;
use super::curve::Curve;
use super::curve::flatten::Vertex;
use super::point::Point;
use defmt::{Format, Formatter, write};

impl<P: Point + Format, const K: usize, const C: usize, const N: usize> Format for Curve<P, K, C, N>
where
    P::Scalar: Format,
{
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Curve {{ knots: {}, points: {} }}", self.knots, self.points());
    }
}

impl<P: Point, const K: usize, const SPANS: usize> Format for Baked<P, K, SPANS>
where
    P::Scalar: Format,
{
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Baked of {} spans, order {}, {}", SPANS, K, self.domain());
    }
}

impl<P: Point + Format> Format for Vertex<P>
where
    P::Scalar: Format,
{
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Vertex {{ t: {}, point: {} }}", self.t, self.point);
    }
}
