//! Lines that start far away, counted from a point nearby.

use super::number::{Number, Real};
use crate::numeric::{Native, add_product};

/// A line whose direction has a length of about 1, and whose parameter is counted from a point
/// near the scene, where that pays.
#[derive(Debug, Clone, Copy)]
pub struct Rebased<S> {
    /// The new origin.
    pub origin: [S; 3],
    /// The new direction.
    pub direction: [S; 3],
    /// The new parameter at the old origin is −`offset`.
    pub offset: S,
    /// Of the old parameter for one of the new.
    pub scale: S,
}

impl<S: Number> Rebased<S> {
    /// The line as it is.
    #[inline]
    pub(super) fn unchanged(origin: [S; 3], direction: [S; 3]) -> Self {
        Self { origin, direction, offset: S::ZERO, scale: S::ONE }
    }
}

/// Scales the direction by a power of two, and moves the origin to about the point of the line
/// nearest to (0, 0, 0), if that is much nearer.
///
/// The moved point's only error is the rounding of its coordinates, so moving pays when the old
/// coordinates are much larger.
// Always: written to memory in pieces, the line would be waited for when it's read as a whole.
#[inline(always)]
pub(super) fn rebased<S: Native>(origin: [S; 3], direction: [S; 3]) -> Rebased<S> {
    let [x, y, z] = direction;
    let scale = x.abs().max(y.abs()).max(z.abs()).normalizing_power();
    let direction = direction.map(|coordinate| coordinate * scale);
    let line = Rebased { scale, ..Rebased::unchanged(origin, direction) };
    if !is_far(origin, direction) {
        return line;
    }
    let ([ox, oy, oz], [dx, dy, dz]) = (origin, direction);
    let offset = -nearest(ox, oy, oz, dx, dy, dz);
    let origin = [shifted(ox, offset, dx), shifted(oy, offset, dy), shifted(oz, offset, dz)];
    if origin.into_iter().all(S::is_finite) { Rebased { origin, offset, ..line } } else { line }
}

/// Whether the line comes 256 times nearer to (0, 0, 0) than its origin is.
///
/// 256: from nearer by, the crossings' own rounding errors outweigh those of the coordinates, and
/// what lies near the line's start would lose digits to the shift.
///
/// With φ the angle between the line and the direction to (0, 0, 0), that is sin φ < 1/256, and
/// cos² φ = (o·d)²/(|o|²|d|²) > 1 − 2⁻¹⁶, which needs no division.
#[inline]
fn is_far<S: Native>(origin: [S; 3], direction: [S; 3]) -> bool {
    let part = S::ONE - S::ONE / S::from_int(65_536);
    let along = S::dot(origin, direction);
    along * along > S::dot(origin, origin) * S::dot(direction, direction) * part
}

/// The parameter of the point nearest to (0, 0, 0), as well as its neighbours are known.
#[inline(never)]
fn nearest<S: Native>(ox: S, oy: S, oz: S, dx: S, dy: S, dz: S) -> S {
    let (origin, direction) = ([ox, oy, oz], [dx, dy, dz]);
    S::dot3(origin, direction) / S::dot(direction, direction)
}

/// A coordinate after `offset`.
#[inline(never)]
fn shifted<S: Native>(origin: S, offset: S, direction: S) -> S {
    add_product(origin, offset, direction)
}
