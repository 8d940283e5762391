//! Data of one type for floating point and of another one for fixed point.

use core::fmt::Debug;
use core::marker::PhantomData;

/// What a computation keeps, where its bodies for floating and for fixed point keep different things.
///
/// [`Scalar::OfKind`](super::Scalar::OfKind) has the type for a number type. Each body knows which one it is.
pub trait ByKind<A, B>: Copy + Debug {
    /// For floating point.
    fn of_float(_: A) -> Option<Self> {
        None
    }

    /// For fixed point.
    fn of_fixed(_: B) -> Option<Self> {
        None
    }

    /// What floating point keeps.
    fn float(&self) -> Option<&A> {
        None
    }

    /// What fixed point keeps.
    fn fixed(&self) -> Option<&B> {
        None
    }
}

/// What floating point keeps.
#[derive(Debug, Clone, Copy)]
pub struct OfFloat<A, B>(A, PhantomData<B>);

/// What fixed point keeps.
#[derive(Debug, Clone, Copy)]
pub struct OfFixed<A, B>(B, PhantomData<A>);

impl<A: Copy + Debug, B: Copy + Debug> ByKind<A, B> for OfFloat<A, B> {
    #[inline(always)]
    fn of_float(kept: A) -> Option<Self> {
        Some(Self(kept, PhantomData))
    }

    #[inline(always)]
    fn float(&self) -> Option<&A> {
        Some(&self.0)
    }
}

impl<A: Copy + Debug, B: Copy + Debug> ByKind<A, B> for OfFixed<A, B> {
    #[inline(always)]
    fn of_fixed(kept: B) -> Option<Self> {
        Some(Self(kept, PhantomData))
    }

    #[inline(always)]
    fn fixed(&self) -> Option<&B> {
        Some(&self.0)
    }
}
