//! Lines that start far away, counted from a point nearby.

use super::{Float, Scalar};

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

impl<S: Scalar> Rebased<S> {
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
#[inline]
pub(super) fn rebased<S: Float>(origin: [S; 3], direction: [S; 3]) -> Rebased<S> {
    let scale = max_abs(direction).normalizing_power();
    let direction = direction.map(|coordinate| coordinate * scale);
    let unmoved = Rebased { scale, ..Rebased::unchanged(origin, direction) };
    // 256: from nearer by, the crossings' own rounding errors outweigh those of the coordinates,
    // and what lies near the line's start would lose digits to the shift.
    let is_far = |near: [S; 3]| max_abs(origin) > max_abs(near) * S::from_int(256);
    let [ox, oy, oz] = origin;
    let [dx, dy, dz] = direction;
    let speed_squared = S::dot(direction, direction);
    let roughly = -(S::dot(origin, direction) / speed_squared);
    if !is_far([ox + dx * roughly, oy + dy * roughly, oz + dz * roughly]) {
        return unmoved;
    }
    let offset = -(S::dot3(origin, direction) / speed_squared);
    let moved = [
        S::add_product(ox, offset, dx),
        S::add_product(oy, offset, dy),
        S::add_product(oz, offset, dz),
    ];
    if is_far(moved) && moved.into_iter().all(S::is_finite) {
        Rebased { origin: moved, offset, ..unmoved }
    } else {
        unmoved
    }
}

#[inline]
fn max_abs<S: Float>([x, y, z]: [S; 3]) -> S {
    x.abs().max(y.abs()).max(z.abs())
}
