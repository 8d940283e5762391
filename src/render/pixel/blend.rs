//! Means of pixels, for smooth edges.

use super::Pixel;

/// A pixel that can be the mean of others: what [`SmoothPicture`](crate::render::SmoothPicture) needs.
///
/// ```
/// use scancsg::render::pixel::{Blend, Pixel, mean, scale};
/// use scancsg::render::Rgb;
///
/// /// A pixel of 24 bits.
/// #[derive(Clone, Copy, PartialEq, Debug)]
/// struct Rgb888([u8; 3]);
///
/// impl Pixel for Rgb888 {
///     fn shaded(color: Rgb, level: u8) -> Self {
///         Self([color.r, color.g, color.b].map(|channel| scale(channel, level)))
///     }
/// }
///
/// impl Blend for Rgb888 {
///     type Sum = [u16; 3];
///     const EMPTY: [u16; 3] = [0; 3];
///
///     fn add_to(self, sum: &mut [u16; 3]) {
///         for (sum, channel) in sum.iter_mut().zip(self.0) {
///             *sum += u16::from(channel);
///         }
///     }
///
///     fn mean(sum: [u16; 3], count: u16) -> Self {
///         Self(sum.map(|sum| mean(sum, count) as u8))
///     }
/// }
///
/// let mut sum = Rgb888::EMPTY;
/// Rgb888([0, 100, 255]).add_to(&mut sum);
/// Rgb888([9, 100, 255]).add_to(&mut sum);
/// assert_eq!(Rgb888::mean(sum, 2), Rgb888([5, 100, 255]));
/// ```
pub trait Blend: Pixel {
    /// Up to 256 pixels, added up.
    type Sum: Copy;
    /// No pixels.
    const EMPTY: Self::Sum;

    /// One pixel more.
    fn add_to(self, sum: &mut Self::Sum);

    /// The mean of `count` pixels, of each channel for itself: rounded to the nearest level, and
    /// upwards half-way between two.
    fn mean(sum: Self::Sum, count: u16) -> Self;
}

/// `sum / count`, rounded to nearest and upwards half-way: the mean of up to 256 eight-bit channels, whose
/// sum fits. 0 if `count` is 0.
///
/// ```
/// assert_eq!(scancsg::render::pixel::mean(100 + 101, 2), 101);
/// ```
#[must_use]
pub const fn mean(sum: u16, count: u16) -> u16 {
    let (sum, count) = (sum as u32, count as u32);
    match (sum + count / 2).checked_div(count) {
        Some(mean) => mean as u16,
        None => 0,
    }
}
