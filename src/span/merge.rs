//! The boolean merge of two lists of spans.
//!
//! Both lists are walked together in ascending order, while the state says whether the line is in
//! the left solid, in the right one, in both or in none. A crossing goes into the result when the
//! state enters or leaves the states that define the operation. (S. D. Roth, *Ray casting for
//! modeling solids*, Computer Graphics and Image Processing 18 (1982), section 4.)
//!
//! All crossings at one parameter are taken together before the state is looked at. That makes
//! the result regularised and independent of the order of the operands, without any tolerance.

use super::list::{SpanStack, StackFull};
use super::span::{Crossing, Span};
use crate::scalar::Scalar;

/// A boolean operation, as the set of states in which the line is inside the result.
///
/// Bit `left + 2·right` is set if the state belongs to the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Operation(u8);

impl Operation {
    /// In the left, in the right or in both.
    pub const UNION: Self = Self(0b1110);
    /// In both.
    pub const INTERSECTION: Self = Self(0b1000);
    /// In the left only.
    pub const DIFFERENCE: Self = Self(0b0010);

    /// Whether the result is inside in this state.
    #[must_use]
    pub const fn contains(self, in_left: bool, in_right: bool) -> bool {
        self.0 >> (in_left as u8 + 2 * in_right as u8) & 1 != 0
    }

    /// Whether a line can be inside the result, where it can be inside the operands or not.
    #[must_use]
    pub(crate) const fn may_contain(self, left: bool, right: bool) -> bool {
        left && self.contains(true, false)
            || right && self.contains(false, true)
            || left && right && self.contains(true, true)
    }

    /// Whether the result is empty wherever the left operand is.
    #[must_use]
    pub const fn needs_left(self) -> bool {
        !self.contains(false, true)
    }
}

/// Replaces the two lists on top of the stack, the left one from `left` on and the right one from
/// `right` on, by their merge.
///
/// Each list is sorted and regularised, and so is the result. Where both lists cross at the same
/// parameter, the face is that of the left. An index behind the end counts as the end, and a left one behind
/// the right one as that.
///
/// # Errors
/// [`StackFull`] if there is no room above both lists for the result, which has at most as many
/// spans as they have together. The lists are as they were.
///
/// ```
/// use scancsg::span::{Crossing, Face, Operation, Span, SpanList, merge};
///
/// let span = |enter, exit| {
///     let at = |t| Crossing { t, face: Face(0) };
///     Span { enter: at(enter), exit: at(exit) }
/// };
/// let mut list = SpanList::<f32, 5>::new();
/// let mut stack = list.stack();
/// stack.push(span(0.0, 4.0))?; // the left list
/// stack.push(span(1.0, 2.0))?; // the right list
/// merge(Operation::DIFFERENCE, &mut stack, 0, 1)?;
/// assert_eq!(*list, [span(0.0, 1.0), span(2.0, 4.0)]);
/// # Ok::<(), scancsg::span::StackFull>(())
/// ```
pub fn merge<S: Scalar>(
    operation: Operation,
    stack: &mut SpanStack<'_, S>,
    left: usize,
    right: usize,
) -> Result<(), StackFull> {
    let end = stack.len();
    let right = right.min(end);
    let left = left.min(right);
    let keeps_left = operation.contains(true, false);
    let keeps_right = operation.contains(false, true);
    if (end == right && keeps_left) || (left == right && keeps_right) {
        return Ok(());
    }
    // Most lists don't overlap. Then nothing need be walked, but for a union in the wrong order.
    let in_order = is_before(stack, right, right);
    if in_order && keeps_left && keeps_right {
        return Ok(());
    }
    if !keeps_right && (in_order || is_before(stack, end, left)) {
        stack.spans.truncate(if keeps_left { right } else { left });
        return Ok(());
    }
    let mut left_crossings = Crossings { next: left, end: right, inside: false };
    let mut right_crossings = Crossings { next: right, end, inside: false };
    let mut entered: Option<Crossing<S>> = None;

    loop {
        let from_left = left_crossings.peek(stack);
        let from_right = right_crossings.peek(stack);
        let crossing = match (from_left, from_right) {
            (None, None) => break,
            // Without the left operand, the rest of the right one is nothing.
            (None, Some(_)) if !keeps_right => break,
            (Some(crossing), None) => {
                left_crossings.pass();
                crossing
            }
            (None, Some(crossing)) => {
                right_crossings.pass();
                crossing
            }
            (Some(l), Some(r)) => {
                // Of two that can't be ordered, both pass: a NaN must not stop the walk.
                let (left_first, right_first) = (l.t < r.t, r.t < l.t);
                if !right_first {
                    left_crossings.pass();
                }
                if !left_first {
                    right_crossings.pass();
                }
                if right_first { r } else { l }
            }
        };
        let inside = operation.contains(left_crossings.inside, right_crossings.inside);
        match (entered, inside) {
            (None, true) => entered = Some(crossing),
            (Some(enter), false) => {
                if let Err(full) = stack.push(Span { enter, exit: crossing }) {
                    stack.spans.truncate(end);
                    return Err(full);
                }
                entered = None;
            }
            _ => {}
        }
    }

    // The result moves down to where the left list began.
    let mut to = left;
    let mut from = end;
    while let Some(&span) = stack.spans.get(from) {
        if let Some(place) = stack.spans.get_mut(to) {
            *place = span;
        }
        to += 1;
        from += 1;
    }
    stack.spans.truncate(to);
    Ok(())
}

impl<S: Scalar> SpanStack<'_, S> {
    /// [`merge`] for solids, which always have the room.
    pub(crate) fn merge(&mut self, operation: Operation, left: usize, right: usize) {
        let _ = merge(operation, self, left, right);
    }
}

/// Whether the span in front of `one` ends before the span at `other` begins.
#[inline]
fn is_before<S: Scalar>(stack: &SpanStack<'_, S>, one: usize, other: usize) -> bool {
    let last = one.checked_sub(1).and_then(|last| stack.spans.get(last));
    matches!((last, stack.spans.get(other)), (Some(last), Some(first)) if last.exit.t < first.enter.t)
}

/// A walk over the crossings of the spans from `next` to before `end`.
struct Crossings {
    next: usize,
    end: usize,
    /// Whether the span at `next` has been entered.
    inside: bool,
}

impl Crossings {
    #[inline]
    fn peek<S: Scalar>(&self, stack: &SpanStack<'_, S>) -> Option<Crossing<S>> {
        if self.next >= self.end {
            return None;
        }
        let span = stack.spans.get(self.next)?;
        Some(if self.inside { span.exit } else { span.enter })
    }

    #[inline]
    fn pass(&mut self) {
        self.next += usize::from(self.inside);
        self.inside = !self.inside;
    }
}
