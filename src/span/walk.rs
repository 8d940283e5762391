//! The walk along a ray through a boolean operation: crossing by crossing, without lists.
//!
//! The answers are those of [`merge`](super::merge), bit for bit, but each operand is asked only as
//! far as the result depends on it. There is one evaluator for two operands and one for any number
//! of united members. Whoever holds the operands implements [`Operands`] or [`Members`]: a typed
//! tree, an array, or a tree that is built at run time.

use super::merge::Operation;
use super::span::Crossing;
use crate::scalar::Scalar;

/// What lies behind some parameter of a ray.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Step<S> {
    /// Whether the ray is inside just behind the parameter.
    pub inside: bool,
    /// The first crossing behind it: none, if its parameter is [`Scalar::HIGHEST`].
    pub next: Crossing<S>,
}

impl<S: Scalar> Step<S> {
    /// Nothing is there.
    pub const OUTSIDE: Self = Self { inside: false, next: Crossing::NEVER };

    /// Adds another solid: inside of either, up to the first crossing. At equal parameters the
    /// earlier solid's crossing stays.
    #[inline(always)]
    pub fn unite(&mut self, other: Self) {
        self.inside |= other.inside;
        if other.next.t < self.next.t {
            self.next = other.next;
        }
    }
}

/// How a question is compiled: [`Hot`] is inlined, [`Cold`] is outlined. The answers are the same.
pub trait Path: sealed::Sealed {
    #[doc(hidden)]
    const IS_COLD: bool;
}

/// The path of most pixels: inlined.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Hot {}

/// The path of few pixels: a call.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cold {}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Hot {}
    impl Sealed for super::Cold {}
}

impl Path for Hot {
    const IS_COLD: bool = false;
}

impl Path for Cold {
    const IS_COLD: bool = true;
}

/// One of two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Side {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

/// The two operands of a boolean operation, on one ray.
pub trait Operands<S: Scalar>: Sized {
    /// What is done with them.
    fn operation(&self) -> Operation;

    /// Whether an operand may be seen here. One that can't is empty.
    fn has(&self, side: Side) -> bool;

    /// Whether the ray is inside an operand just behind `t`.
    fn contains<P: Path>(&mut self, side: Side, t: S) -> bool;

    /// What lies behind `t` in an operand.
    fn step<P: Path>(&mut self, side: Side, t: S) -> Step<S>;

    /// Asks out of line. Implement it to hand over the operands in registers, not in memory.
    #[inline(never)]
    fn outlined<A, B>(self, with: A, ask: impl FnOnce(Self, A) -> B) -> B {
        ask(self, with)
    }
}

/// Any number of united solids, on one ray.
pub trait Members<S: Scalar>: Sized {
    /// Whether there is only one.
    fn is_single(&self) -> bool;

    /// What lies behind `t` in all members, [united](Step::unite) in their order.
    fn unite<P: Path>(&mut self, t: S) -> Step<S>;

    /// Asks out of line. Implement it to hand over the members in registers, not in memory.
    #[inline(never)]
    fn outlined<A, B>(self, with: A, ask: impl FnOnce(Self, A) -> B) -> B {
        ask(self, with)
    }
}

/// Whether the ray is inside the result just behind `t`.
#[inline(always)]
pub fn contains<P: Path, S: Scalar>(of: impl Operands<S>, t: S) -> bool {
    if P::IS_COLD { of.outlined(t, contains_inlined) } else { contains_inlined(of, t) }
}

#[inline(always)]
fn contains_inlined<S: Scalar>(mut of: impl Operands<S>, t: S) -> bool {
    let operation = of.operation();
    let in_left = of.has(Side::Left) && of.contains::<Hot>(Side::Left, t);
    if operation.contains(in_left, false) == operation.contains(in_left, true) {
        return operation.contains(in_left, false);
    }
    let in_right = of.has(Side::Right) && of.contains::<Hot>(Side::Right, t);
    operation.contains(in_left, in_right)
}

/// What lies behind `t` in the result. At equal parameters the left operand's crossing counts.
///
/// ```
/// use scancsg::span::walk::{Hot, Operands, Path, Side, Step, step};
/// use scancsg::span::{Crossing, Face, Operation};
///
/// /// Two intervals.
/// struct Two([[f32; 2]; 2]);
///
/// impl Operands<f32> for Two {
///     fn operation(&self) -> Operation {
///         Operation::DIFFERENCE
///     }
///
///     fn has(&self, _: Side) -> bool {
///         true
///     }
///
///     fn contains<P: Path>(&mut self, side: Side, t: f32) -> bool {
///         self.step::<P>(side, t).inside
///     }
///
///     fn step<P: Path>(&mut self, side: Side, t: f32) -> Step<f32> {
///         let [enter, exit] = self.0[side as usize];
///         let at = |t| Crossing { t, face: Face(side as u16) };
///         match () {
///             () if t < enter => Step { inside: false, next: at(enter) },
///             () if t < exit => Step { inside: true, next: at(exit) },
///             () => Step::OUTSIDE,
///         }
///     }
/// }
///
/// // From 0 to 4, less what is from 1 to 2.
/// let first = step::<Hot, _>(Two([[0.0, 4.0], [1.0, 2.0]]), 0.0);
/// assert!(first.inside);
/// assert_eq!(first.next, Crossing { t: 1.0, face: Face(1) });
/// ```
#[inline(always)]
pub fn step<P: Path, S: Scalar>(of: impl Operands<S>, t: S) -> Step<S> {
    if P::IS_COLD { of.outlined(t, step_inlined) } else { step_inlined(of, t) }
}

#[inline(always)]
fn step_inlined<S: Scalar>(mut of: impl Operands<S>, t: S) -> Step<S> {
    let operation = of.operation();
    let left = if of.has(Side::Left) { of.step::<Hot>(Side::Left, t) } else { Step::OUTSIDE };
    if !operation.needs_left() {
        return step_of_either(of, t, left);
    }
    if left.inside {
        return of.outlined(left, move |of, left| step_from_left(of, t, left));
    }
    // From outside of the left operand, its first crossing decides in most cases.
    let t = left.next.t;
    if t >= S::HIGHEST {
        return Step::OUTSIDE;
    }
    let in_right = of.has(Side::Right) && of.contains::<Hot>(Side::Right, t);
    if operation.contains(true, in_right) {
        return Step { inside: false, next: left.next };
    }
    Step { inside: false, next: of.outlined(t, next_of_right) }
}

/// What lies behind `t` in a union, where that is known of the left operand.
#[inline(always)]
fn step_of_either<S: Scalar>(mut of: impl Operands<S>, t: S, left: Step<S>) -> Step<S> {
    if !of.has(Side::Right) {
        return left;
    }
    let right = of.step::<Hot>(Side::Right, t);
    if of.has(Side::Left) {
        if left.inside || right.inside {
            return of.outlined(left, move |of, left| step_from_left(of, t, left));
        }
        // From outside of both, what is entered first decides.
        let mut all = left;
        all.unite(right);
        return all;
    }
    right
}

/// The first crossing behind `t`, where the ray is inside the left operand and the right one keeps it
/// out of the result. Only for operations that need the left operand.
#[inline(always)]
fn next_of_right<S: Scalar>(mut of: impl Operands<S>, mut t: S) -> Crossing<S> {
    let operation = of.operation();
    if !of.has(Side::Right) {
        return Crossing::NEVER;
    }
    loop {
        let right = of.step::<Cold>(Side::Right, t).next;
        t = right.t;
        if t >= S::HIGHEST {
            return right;
        }
        if of.contains::<Cold>(Side::Left, t) {
            let before = t.next_below();
            if of.contains::<Cold>(Side::Left, before) {
                return right;
            }
            return of.step::<Cold>(Side::Left, before).next;
        }
        let left = of.step::<Cold>(Side::Left, t).next;
        t = left.t;
        let ends = t >= S::HIGHEST;
        let in_right = !ends && of.contains::<Cold>(Side::Right, t);
        if ends || operation.contains(true, in_right) {
            return left;
        }
    }
}

/// What lies behind `t`, where that is known of the left operand.
#[inline(always)]
fn step_from_left<S: Scalar>(mut of: impl Operands<S>, mut t: S, mut left: Step<S>) -> Step<S> {
    let operation = of.operation();
    let counts = |left: &Step<S>| left.inside || !operation.needs_left();
    let has_right = of.has(Side::Right);
    let mut right = Step::OUTSIDE;
    if has_right && counts(&left) {
        right = of.step::<Cold>(Side::Right, t);
    }
    let inside = operation.contains(left.inside, right.inside);
    loop {
        let next = if right.next.t < left.next.t { right.next } else { left.next };
        if next.t >= S::HIGHEST {
            return Step { inside, next };
        }
        t = next.t;
        let (passes_left, mut passes_right) = (left.next.t <= t, right.next.t <= t);
        left.inside ^= passes_left;
        right.inside ^= passes_right;
        if passes_left && operation.needs_left() {
            passes_right = has_right;
            right.inside = left.inside && has_right && of.contains::<Cold>(Side::Right, t);
        }
        if operation.contains(left.inside, right.inside) != inside {
            return Step { inside, next };
        }
        if passes_left {
            left = of.step::<Cold>(Side::Left, t);
        }
        if !counts(&left) {
            right = Step::OUTSIDE;
        } else if passes_right {
            right = of.step::<Cold>(Side::Right, t);
        }
    }
}

/// What lies behind `t` in the union of all members.
#[inline(always)]
pub fn step_of_union<P: Path, S: Scalar>(mut of: impl Members<S>, t: S) -> Step<S> {
    let all = of.unite::<P>(t);
    // From outside of all members, the first that is entered decides.
    if all.inside { Step { next: exit_of_union(of, all.next), ..all } } else { all }
}

/// The first crossing from `next` on behind which the ray is outside of all members.
#[inline(always)]
pub fn exit_of_union<S: Scalar>(of: impl Members<S>, next: Crossing<S>) -> Crossing<S> {
    of.outlined(next, |mut of, mut next| {
        if of.is_single() {
            return next;
        }
        while next.t < S::HIGHEST {
            let all = of.unite::<Cold>(next.t);
            if !all.inside {
                break;
            }
            next = all.next;
        }
        next
    })
}
