//! How much there is room for.

/// The most parts of a scene.
#[cfg(not(feature = "parts-64"))]
pub const PARTS: usize = 16;
/// The most parts of a scene.
#[cfg(feature = "parts-64")]
pub const PARTS: usize = 64;

/// The most poses of a scene.
#[cfg(not(feature = "parts-64"))]
pub const POSES: usize = 4;
/// The most poses of a scene.
#[cfg(feature = "parts-64")]
pub const POSES: usize = 16;

/// What a picture needs for a part, in words of eight bytes.
#[cfg(not(any(feature = "i16f16", feature = "torus")))]
pub const PART_WORDS: usize = 30;
/// What a picture needs for a part, in words of eight bytes.
#[cfg(all(feature = "i16f16", not(feature = "torus")))]
pub const PART_WORDS: usize = 55;
/// What a picture needs for a part, in words of eight bytes.
#[cfg(all(feature = "torus", not(feature = "i16f16")))]
pub const PART_WORDS: usize = 42;
/// What a picture needs for a part, in words of eight bytes.
#[cfg(all(feature = "i16f16", feature = "torus"))]
pub const PART_WORDS: usize = 64;
