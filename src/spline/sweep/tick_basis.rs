//! Basis functions at the ticks of a clock, in integers.

/// A span that begins and ends at a tick, like all others that its basis functions cover.
pub(super) struct TickBasis<const K: usize> {
    /// How many ticks the knots are behind the beginning, t_{j−k+1} first and t_j last.
    behind: [u32; K],
    /// How many ticks the knots are ahead of it, from t_{j+1} on.
    ahead: [u32; K],
    /// By level of the recurrence: 1/(t_{i+r} − t_i) is this over the level's common divisor.
    factors: [[u32; K]; K],
    /// The product of all levels' divisors.
    pub(super) divisor: u32,
}

impl<const K: usize> TickBasis<K> {
    /// `None` for a span without a length, or if the divisor exceeds 2³¹.
    pub(super) fn new(behind: [u32; K], ahead: [u32; K]) -> Option<Self> {
        let mut factors = [[0; K]; K];
        let mut divisor = 1u32;
        for (level, factors) in factors.iter_mut().enumerate().skip(1) {
            // The functions of the level before are on the knots from t_{j−r+1} to t_{j+r}.
            let widths = || behind.iter().skip(K - level).zip(&ahead);
            let mut common = 1u32;
            for (behind, ahead) in widths() {
                let width = behind.checked_add(*ahead)?;
                common = common.checked_mul(width.checked_div(common_divisor(width, common))?)?;
            }
            for (factor, (behind, ahead)) in factors.iter_mut().skip(K - level).zip(widths()) {
                *factor = common.checked_div(behind.wrapping_add(*ahead))?;
            }
            divisor = divisor.checked_mul(common)?;
        }
        let is_good = ahead.first() > Some(&0) && divisor <= 1 << 31;
        is_good.then_some(Self { behind, ahead, factors, divisor })
    }

    /// How many ticks the span has.
    pub(super) fn count(&self) -> u32 {
        self.ahead.first().copied().unwrap_or(0)
    }

    /// The basis functions at a tick of the span, times the divisor, which is their sum.
    pub(super) fn weights(&self, at: u32) -> [i64; K] {
        let mut weights = [0i64; K];
        if let Some(last) = weights.last_mut() {
            *last = 1;
        }
        for (level, factors) in self.factors.iter().enumerate().skip(1) {
            // What falls of the function that begins a knot later.
            let mut fall = 0;
            let functions = weights.iter_mut().zip(&self.behind).zip(factors).enumerate().rev();
            for (i, ((weight, behind), factor)) in functions.take(level + 1) {
                let share = weight.wrapping_mul(i64::from(*factor));
                let rise = share.wrapping_mul(i64::from(*behind) + i64::from(at));
                *weight = rise.wrapping_add(fall);
                let end = (i + level).checked_sub(K).and_then(|end| self.ahead.get(end));
                fall = end.map_or(0, |end| share.wrapping_mul(i64::from(*end) - i64::from(at)));
            }
        }
        weights
    }
}

/// The greatest number that divides both.
fn common_divisor(mut a: u32, mut b: u32) -> u32 {
    while let Some(rest) = a.checked_rem(b) {
        (a, b) = (b, rest);
    }
    a
}
