//! What Arm's floating-point unit, and the cores that have one, do in fewer instructions, with the same bits.

use super::blend::horner;
use super::tree;
use crate::scalar::{FloatFrame, Polynomial, cubic, leaf};
use core::any::Any;

/// As [`tree::find`].
#[inline(always)]
pub(super) fn find<'a, T>(nodes: &[u32], elements: &'a [T], key: u32) -> Option<&'a T> {
    let first = tree::first(elements.len());
    let leaf = leaf(nodes, tree::levels(elements.len()), key);
    // The compiler doesn't take the difference before it is compared.
    if leaf < first { None } else { elements.get(leaf - first) }
}

/// As [`horner`]; a cubic in space is what moves through pictures.
#[inline]
pub(super) fn sums<Row, const K: usize>(
    polynomial: &Polynomial<FloatFrame<f32>, Row, K>,
    t: f32,
) -> Option<Row>
where
    Row: Copy + AsRef<[f32]> + AsMut<[f32]> + 'static,
{
    // The type is known while compiling.
    let Some(polynomial) = (polynomial as &dyn Any).downcast_ref() else {
        return horner(polynomial, t);
    };
    let point = cubic(polynomial, t);
    (&point as &dyn Any).downcast_ref().copied()
}
