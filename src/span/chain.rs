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

/// What lies behind `t` in the whole, from the question at `entry` on.
///
/// ```
/// use scancsg::span::chain::{Chained, Link, step};
/// use scancsg::span::walk::Step;
/// use scancsg::span::{Crossing, Face};
///
/// /// Two intervals, the first less the second: a ray inside the first one isn't inside the second.
/// struct Less([[f32; 2]; 2]);
///
/// impl Chained<f32> for Less {
///     fn link(&self, leaf: u16) -> Option<Link> {
///         match leaf {
///             0 => Some(Link { inside: 1, outside: Link::OUT }),
///             1 => Some(Link { inside: Link::OUT, outside: Link::IN }),
///             _ => None,
///         }
///     }
///
///     fn contains(&mut self, leaf: u16, t: f32) -> bool {
///         self.step(leaf, t).inside
///     }
///
///     fn step(&mut self, leaf: u16, t: f32) -> Step<f32> {
///         let [enter, exit] = self.0[usize::from(leaf)];
///         let at = |t| Crossing { t, face: Face(leaf) };
///         match () {
///             () if t < enter => Step { inside: false, next: at(enter) },
///             () if t < exit => Step { inside: true, next: at(exit) },
///             () => Step::OUTSIDE,
///         }
///     }
///
///     fn tied(&mut self, _: f32) -> Face {
///         Face(0) // the left operand, where it is crossed
///     }
/// }
///
/// // From 0 to 4, less what is from 1 to 2.
/// let first = step(&mut Less([[0.0, 4.0], [1.0, 2.0]]), 0, 0.0);
/// assert!(first.inside);
/// assert_eq!(first.next, Crossing { t: 1.0, face: Face(1) });
/// ```
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Nested intervals: leaf i reaches from i to 2n − i. Each is less the next one, which is less the
    /// next one.
    struct Nested {
        count: u16,
        asked: usize,
    }

    impl Chained<f32> for Nested {
        fn link(&self, leaf: u16) -> Option<Link> {
            let [even, odd] = [Link::IN, Link::OUT];
            let (own, other) = if leaf.is_multiple_of(2) { (even, odd) } else { (odd, even) };
            let next = leaf.saturating_add(1);
            let inside = if next < self.count { next } else { own };
            (leaf < self.count).then_some(Link { inside, outside: other })
        }

        fn contains(&mut self, leaf: u16, t: f32) -> bool {
            self.step(leaf, t).inside
        }

        fn step(&mut self, leaf: u16, t: f32) -> Step<f32> {
            self.asked += 1;
            let (enter, exit) = (f32::from(leaf), f32::from(2 * self.count - leaf));
            let at = |t| Crossing { t, face: Face(leaf) };
            match () {
                () if t < enter => Step { inside: false, next: at(enter) },
                () if t < exit => Step { inside: true, next: at(exit) },
                () => Step::OUTSIDE,
            }
        }

        fn tied(&mut self, _: f32) -> Face {
            Face(u16::MAX)
        }
    }

    /// However deep a tree is, each of its crossings costs at most two questions to each leaf.
    #[test]
    fn the_work_is_bounded() {
        for count in [1, 2, 7, 64, 255] {
            let mut nested = Nested { count, asked: 0 };
            let (mut t, mut inside, mut crossings) = (-1.0, false, 0);
            loop {
                let next = step(&mut nested, 0, t);
                assert_eq!(next.inside, inside);
                if next.next.t == f32::INFINITY {
                    break;
                }
                (t, inside, crossings) = (next.next.t, !inside, crossings + 1);
            }
            // All of them: each one turns the whole.
            assert_eq!(crossings, 2 * usize::from(count));
            assert!(nested.asked <= 2 * (crossings + 1) * usize::from(count), "{}", nested.asked);
        }
    }
}
