//! The walk along a ray through a tree that is built at run time.
//!
//! The tree is a chain of questions to its leaves. Each answer says which leaf is asked next, or what
//! the whole comes to. So nothing recurses, no stack is needed, and a leaf is asked only where the
//! leaves before it don't decide. The answers are those of [`merge`](super::merge()), bit for bit.
//!
//! As long as no leaf that was asked is crossed, the answer stays. So the next parameter to look at is
//! the first crossing of those leaves. Each turn passes a crossing, so a walk ends after at most as
//! many turns as all leaves have crossings, with at most one question for each leaf in a turn.

use super::span::{Crossing, Face};
use super::walk::Step;
use crate::scalar::Scalar;

/// Where a chain goes on behind a leaf: to a leaf of a higher index, or to an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Link {
    /// If the ray is inside the leaf.
    pub inside: u16,
    /// If it is outside.
    pub outside: u16,
}

impl Link {
    /// The end of a chain: the ray is inside the whole.
    pub const IN: u16 = u16::MAX - 1;
    /// The end of a chain: the ray is outside.
    pub const OUT: u16 = u16::MAX;

    /// Where a chain goes on.
    #[inline(always)]
    fn after(self, is_inside: bool) -> u16 {
        if is_inside { self.inside } else { self.outside }
    }
}

/// The leaves of a chain, on one ray.
pub trait Chained<S: Scalar> {
    /// Where the chain goes on behind a leaf; `None` for the ends, which are no leaves.
    fn link(&self, leaf: u16) -> Option<Link>;

    /// Whether the ray is inside a leaf just behind `t`.
    fn contains(&mut self, leaf: u16, t: S) -> bool;

    /// What lies behind `t` in a leaf.
    fn step(&mut self, leaf: u16, t: S) -> Step<S>;

    /// The face that is crossed at `t`, where several leaves are: that of the left operand of
    /// each operation, where that one is crossed.
    fn tied(&mut self, t: S) -> Face;
}

/// Whether the ray is inside the whole just behind `t`, from the question at `entry` on.
#[inline(always)]
pub fn contains<S: Scalar>(of: &mut impl Chained<S>, entry: u16, t: S) -> bool {
    let mut leaf = entry;
    while let Some(link) = of.link(leaf) {
        leaf = link.after(of.contains(leaf, t));
    }
    leaf == Link::IN
}

/// What lies behind `t` in the whole.
#[inline(always)]
pub fn step<S: Scalar>(of: &mut impl Chained<S>, entry: u16, mut t: S) -> Step<S> {
    loop {
        let (mut leaf, mut next, mut turn, mut is_tie) = (entry, Crossing::NEVER, entry, false);
        while let Some(link) = of.link(leaf) {
            let step = of.step(leaf, t);
            if step.next.t < next.t {
                (next, turn, is_tie) = (step.next, link.after(!step.inside), false);
            } else if step.next.t == next.t {
                // Where both lead to the same place, as in a union, the first one counts.
                is_tie |= link.after(!step.inside) != turn;
            }
            leaf = link.after(step.inside);
        }
        let inside = leaf == Link::IN;
        if next.t >= S::HIGHEST {
            return Step { inside, next: Crossing::NEVER };
        }
        // Up to the first leaf that is crossed there, all answers stay.
        t = next.t;
        if contains(of, turn, t) != inside {
            if is_tie {
                next.face = of.tied(t);
            }
            return Step { inside, next };
        }
    }
}
