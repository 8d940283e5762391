//! Pixel formats: the integer formulas against rounding in `f64`, for every colour and level.

use scancsg::render::{Gray8, Pixel, PixelFormat, Rgb, Rgb565};

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
        assert!(off <= 502, "luma of {r} {g} {b} is off by {off} thousandths");
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
