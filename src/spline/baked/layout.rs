//! Where the pieces of a baked curve begin.

use crate::scalar::{ConstOps, per_scalar};
use crate::spline::error::CurveError;
use crate::spline::knots::Knots;
use crate::spline::scalar::Arithmetic;

/// Where a piece is: on which span, from where to where.
pub(super) type Place<S> = (usize, [S; 2]);

per_scalar! { $S: impl[const K: usize, const N: usize] Knots<$S, K, N> {
    /// The pieces of all spans that aren't empty, each in as many parts as there is room for.
    pub(in crate::spline) const fn places<const SPANS: usize>(
        &self,
    ) -> Result<<$S as Arithmetic>::Pieces<Place<$S>, SPANS>, CurveError> {
        const { assert!(SPANS > 0) };
        let mut places = [[(0, [ConstOps::<$S>::ZERO; 2]); _]; SPANS];
        // What the pieces of a part begin with, and where they end, in quarters of it.
        let cuts: &[usize] = if places[0].len() == 3 { &[0, 1, 3, 4] } else { &[0, 4] };
        let spans = self.spans();
        if spans == 0 || !SPANS.is_multiple_of(spans) {
            return Err(CurveError::SpanCount);
        }
        let parts = SPANS / spans;
        let (mut span, mut at) = (K - 1, 0);
        while at < SPANS {
            while !ConstOps::<$S>::is_below(self.knots[span], self.knots[span + 1]) {
                span += 1;
            }
            let ends = [self.knots[span], self.knots[span + 1]];
            let mut i = 0;
            while i + 1 < cuts.len() {
                let [start, stop] = [at % parts * 4 + cuts[i], at % parts * 4 + cuts[i + 1]];
                let start = ConstOps::<$S>::divided(ends, start, 4 * parts);
                places[at][i] = (span, [start, ConstOps::<$S>::divided(ends, stop, 4 * parts)]);
                i += 1;
            }
            at += 1;
            span += at.is_multiple_of(parts) as usize;
        }
        Ok(places)
    }
} }
