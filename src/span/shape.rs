//! What the type of a solid alone decides.

use crate::scalar::Scalar;

/// The counts of a solid that its type alone decides: how much memory its spans need.
///
/// Implement it, together with [`Solid`](crate::solid::Solid), for a solid of your own.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a solid",
    label = "not a solid",
    note = "what is combined by `|`, `&` and `-` are solids of one number type; a constructor's `Result` \
            needs `?` first",
    note = "a solid of your own implements `Shape` and `Solid`, or `Wrap` if it is another one inside"
)]
pub trait Shape {
    /// The number type of the solid.
    type Scalar: Scalar;

    /// The most spans that any line can have with the solid: 1 for a convex one.
    const SPANS: usize;

    /// The most spans that are in memory while the spans of a line are merged: the capacity that a
    /// [`SpanList`](crate::span::SpanList) for this solid must have.
    const STACK: usize = Self::SPANS;

    /// The number of faces.
    const FACES: u16;
}
