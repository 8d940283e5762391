//! Conversions of pixels, written once.

/// Conversions between a pixel and what has the same bits, there and back.
macro_rules! same_bits {
    ($($Pixel:ident = $Other:ty, $to:expr, $from:expr;)+) => {$(
        impl From<$Pixel> for $Other {
            fn from(pixel: $Pixel) -> Self {
                $to(pixel.0)
            }
        }

        impl From<$Other> for $Pixel {
            fn from(other: $Other) -> Self {
                Self($from(other))
            }
        }
    )+};
}
pub(crate) use same_bits;
