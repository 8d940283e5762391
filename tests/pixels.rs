//! Pixel formats: the integer formulas against rounding in `f64`, for every colour and level.

use scancsg::render::{Blend, Gray8, Pixel, PixelFormat, Rgb, Rgb565};

/// `channel · level / 255` on the scale 0..=255: never halfway between two whole numbers,
/// because 2·channel·level is even and 255 odd.
fn lit(channel: u8, level: u8) -> f64 {
    (f64::from(channel) * f64::from(level) / 255.0).round()
}

#[test]
fn grey_is_luma_times_level() {
    for grey in 0..=255 {
        // All three weights add up to one, so the luma of a grey is that grey.
        assert_eq!(Rgb::new(grey, grey, grey).luma(), grey);
        for level in 0..=255 {
            let Gray8(got) = Gray8::shaded(Rgb::new(grey, grey, grey), level);
            assert_eq!(f64::from(got), lit(grey, level), "{grey} lit by {level}");
        }
    }
}

#[test]
fn luma_is_that_of_bt_601() {
    let channel = || (0..=255u8).step_by(5);
    let colors =
        channel().flat_map(|r| channel().flat_map(move |g| channel().map(move |b| [r, g, b])));
    for [r, g, b] in colors {
        // In thousandths, exactly.
        let exact = 299 * u32::from(r) + 587 * u32::from(g) + 114 * u32::from(b);
        let off = (1000 * i64::from(Rgb::new(r, g, b).luma()) - i64::from(exact)).abs();
        // Nearest, but where the exact value is within 2 thousandths of halfway.
        assert!(off <= testkit::limits::LUMA, "luma of {r} {g} {b} is off by {off} thousandths");
    }
}

#[test]
fn rgb565_rounds_every_channel_to_nearest() {
    for (channel, level) in (0..=255u8).flat_map(|c| (0..=255u8).map(move |l| (c, l))) {
        let narrow = |max: f64| (lit(channel, level) * max / 255.0).round() as u16;
        let of = |r, g, b| Rgb565::shaded(Rgb::new(r, g, b), level).0;
        assert_eq!(of(channel, 0, 0), narrow(31.0) << 11, "red {channel} lit by {level}");
        assert_eq!(of(0, channel, 0), narrow(63.0) << 5, "green {channel} lit by {level}");
        assert_eq!(of(0, 0, channel), narrow(31.0), "blue {channel} lit by {level}");
    }
}

fn mean<P: Blend>(pixels: &[P]) -> P {
    let mut sum = P::EMPTY;
    pixels.iter().for_each(|pixel| pixel.add_to(&mut sum));
    P::mean(sum, pixels.len() as u16)
}

/// All means of two levels, and those of 256 pixels, which are the most that are added up.
#[test]
fn a_mean_rounds_every_channel_to_nearest() {
    for (a, b) in (0..=255u8).flat_map(|a| (0..=255u8).map(move |b| (a, b))) {
        let half = |a: u16, b: u16| (f64::from(a + b) / 2.0).round() as u16;
        assert_eq!(u16::from(mean(&[Gray8(a), Gray8(b)]).0), half(a.into(), b.into()));
        let [r, g, b, other] = [a >> 3, a >> 2, b >> 3, b >> 2].map(u16::from);
        let of = |r, g, b| Rgb565((r << 11) | (g << 5) | b);
        let expected = of(half(r, b), half(g, other), half(b, r));
        assert_eq!(mean(&[of(r, g, b), of(b, other, r)]), expected);
    }
    for lit in 0..=256_usize {
        let exact = |max: f64| (max * lit as f64 / 256.0).round() as u16;
        let greys: [_; 256] = std::array::from_fn(|i| Gray8(if i < lit { 255 } else { 0 }));
        assert_eq!(u16::from(mean(&greys).0), exact(255.0));
        let colors: [_; 256] = std::array::from_fn(|i| Rgb565(if i < lit { 0xFFFF } else { 0 }));
        assert_eq!(mean(&colors).0, (exact(31.0) << 11) | (exact(63.0) << 5) | exact(31.0));
    }
    assert_eq!(Gray8::mean(Gray8::EMPTY, 0), Gray8(0));
}

/// The lower byte first: 0x1234 on the wire is 34 12.
#[test]
fn bytes_on_the_link_are_little_endian() {
    assert_eq!(Rgb565(0x1234).to_le_bytes(), [0x34, 0x12]);
    assert_eq!(Gray8(0x56).to_le_bytes(), [0x56]);
}

#[test]
fn formats_have_codes_and_sizes() {
    for (format, code, bytes) in [(Gray8::FORMAT, 0, 1), (Rgb565::FORMAT, 1, 2)] {
        assert_eq!((format.code(), format.bytes_per_pixel()), (code, bytes));
        assert_eq!(PixelFormat::from_code(code), Some(format));
    }
    assert!((2..=255).all(|code| PixelFormat::from_code(code).is_none()));
}
