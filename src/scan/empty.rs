//! Memory of stages.

/// Memory of a stage that is yet to be reached.
pub trait Empty {
    /// Nothing is decided.
    const EMPTY: Self;
}

impl<T: Empty, const N: usize> Empty for [T; N] {
    const EMPTY: Self = [T::EMPTY; N];
}

impl<T> Empty for Option<T> {
    const EMPTY: Self = None;
}

impl<A: Empty, B: Empty> Empty for (A, B) {
    const EMPTY: Self = (A::EMPTY, B::EMPTY);
}
