//! The hash of the gallery's pictures, shared with the test of the examples.

/// FNV-1a of 32 bits.
pub fn fnv(bytes: impl IntoIterator<Item = u32>) -> u32 {
    bytes.into_iter().fold(0x811c_9dc5, |hash, byte| (hash ^ byte).wrapping_mul(0x0100_0193))
}
