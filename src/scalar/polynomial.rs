//! Polynomials as a baked curve has them, laid out so that all numbers can be loaded at once.

/// A polynomial of each coordinate, and where it is.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Polynomial<Frame, Row, const K: usize> {
    /// A row for each power, of the highest one first.
    pub(crate) coefficients: [Row; K],
    pub(crate) frame: Frame,
}

/// The local parameter is `t·scale + shift`.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct FloatFrame<S> {
    /// A power of two, so that the product is exact.
    pub(crate) scale: S,
    pub(crate) shift: S,
}
