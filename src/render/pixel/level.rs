//! The arithmetic of one channel.

/// `channel · level / 255`, rounded to nearest: a channel of a colour that is lit with `level`.
///
/// ```
/// assert_eq!(scancsg::render::pixel::scale(200, 128), 100);
/// ```
#[must_use]
#[inline]
pub const fn scale(channel: u8, level: u8) -> u8 {
    // Of white, which is what isn't painted: known while compiling.
    if channel == u8::MAX {
        return level;
    }
    // Exact division by 255 for every 16-bit product: (p + 128 + ((p + 128) >> 8)) >> 8.
    let p = channel as u32 * level as u32 + 128;
    ((p + (p >> 8)) >> 8) as u8
}

/// An eight-bit channel on the scale 0..=`max`, rounded to nearest: for pixels with fewer or more bits.
///
/// ```
/// assert_eq!(scancsg::render::pixel::narrow(255, 31), 31);
/// ```
#[must_use]
pub const fn narrow(channel: u8, max: u16) -> u16 {
    ((channel as u32 * max as u32 + 127) / 255) as u16
}
