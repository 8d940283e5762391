//! What a camera decides of a face in a pool.

use crate::scalar::{Number, Scalar};
use crate::scan::Empty;

/// A face as a camera sees it: the numbers of its view along parallel rays, or from an eye.
#[derive(Debug, Clone, Copy)]
pub struct FaceView<S: Scalar>(pub(super) [S::Wide; 4]);

impl<S: Scalar> Empty for FaceView<S> {
    const EMPTY: Self = Self([S::Wide::ZERO; 4]);
}
