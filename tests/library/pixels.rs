//! Pixel formats: the integer formulas against rounding in `f64`, for every colour and level.

#![allow(clippy::unwrap_used)]

use scancsg::geom::vec3;
use scancsg::render::pixel::{self, scale};
use scancsg::render::{
    Blend, Gray8, Lambert, Mono, Perspective, Picture, Pixel, Rgb, Rgb565, Rgb888, RowError,
    RowSource, Size, SmoothColumn, SmoothPicture, Smoothing,
};
use scancsg::solid::{Painted, Sphere};
use scancsg::stream::{PixelFormat, RowHash, WirePixel};
use testkit::link::{Bytes, crc32};

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

#[test]
fn rgb888_and_one_bit_round_to_nearest() {
    for (channel, level) in (0..=255u8).flat_map(|c| (0..=255u8).map(move |l| (c, l))) {
        let exact = lit(channel, level) as u8;
        let of = |r, g, b| Rgb888::shaded(Rgb::new(r, g, b), level).0;
        assert_eq!(of(channel, 0, 0), [exact, 0, 0], "red {channel} lit by {level}");
        assert_eq!(of(0, channel, 0), [0, exact, 0], "green {channel} lit by {level}");
        assert_eq!(of(0, 0, channel), [0, 0, exact], "blue {channel} lit by {level}");
        // Lit is what is nearer to white than to black.
        let is_lit = Mono::shaded(Rgb::new(channel, channel, channel), level).0;
        assert_eq!(is_lit, 2 * u16::from(exact) > 255, "grey {channel} lit by {level}");
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

/// A row's hash is that of its bytes, so it tells what they are.
fn is_sent_as<P: Bytes>(row: &[P], bytes: &[u8]) {
    assert_eq!(P::bytes(row), bytes);
    let numbered = [&[7, 0], bytes].concat();
    assert_eq!(RowHash::of(7, row), crc32(&numbered), "{row:?}");
}

/// The lower byte first: 0x1234 on the wire is 34 12. Red first, and the leftmost of eight bits highest.
#[test]
fn bytes_on_the_link_are_little_endian() {
    is_sent_as(&[Rgb565(0x1234)], &[0x34, 0x12]);
    // What is bytes already, as displays take it.
    assert_eq!(RowHash::of(7, &[[0x12, 0x34]]), RowHash::of(7, &[Rgb565(0x1234)]));
    assert_eq!(RowHash::of(7, &[[0x56]]), RowHash::of(7, &[Gray8(0x56)]));
    assert_eq!(RowHash::of(7, &[[1, 2, 3]]), RowHash::of(7, &[Rgb888([1, 2, 3])]));
    is_sent_as(&[Gray8(0x56)], &[0x56]);
    is_sent_as(&[Rgb888([1, 2, 3])], &[1, 2, 3]);
    is_sent_as(&[1, 0, 0, 0, 0, 0, 0, 1, 0, 1].map(|bit| Mono(bit == 1)), &[0x81, 0x40]);
}

#[test]
fn formats_have_codes_and_sizes() {
    let formats = [
        (PixelFormat::Gray8, 8),
        (PixelFormat::Rgb565, 16),
        (PixelFormat::Rgb888, 24),
        (PixelFormat::Mono, 1),
    ];
    for (code, (format, bits)) in (0..).zip(formats) {
        assert_eq!((format.code(), format.bits_per_pixel()), (code, bits));
        assert_eq!(PixelFormat::from_code(code), Some(format));
        for width in [0_u16, 1, 7, 8, 9, 320, u16::MAX] {
            let exact = (f64::from(width) * bits as f64 / 8.0).ceil();
            assert_eq!(format.row_bytes(width) as f64, exact, "{format:?} {width}");
        }
    }
    assert!((4..=255).all(|code| PixelFormat::from_code(code).is_none()));
}

/// A display's own pixel, which is one of the link's in another order of bytes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Panel([u8; 2]);

impl Pixel for Panel {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self(Rgb565::shaded(color, level).0.to_be_bytes())
    }
}

impl WirePixel for Panel {
    type Wire = Rgb565;

    fn to_wire(self) -> Rgb565 {
        Rgb565(u16::from_be_bytes(self.0))
    }
}

#[test]
fn a_pixel_of_ones_own_is_sent_as_one_of_the_links() {
    for value in 0..=u16::MAX {
        let (own, links) = ([Panel(value.to_be_bytes())], [Rgb565(value)]);
        assert_eq!(RowHash::of(3, &own), RowHash::of(3, &links));
    }
}

/// A pixel that the library doesn't know: 24 bits, as the library's own.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Own([u8; 3]);

impl Pixel for Own {
    fn shaded(color: Rgb, level: u8) -> Self {
        Self([color.r, color.g, color.b].map(|channel| scale(channel, level)))
    }
}

impl Blend for Own {
    type Sum = [u16; 3];
    const EMPTY: [u16; 3] = [0; 3];

    fn add_to(self, sum: &mut [u16; 3]) {
        sum.iter_mut().zip(self.0).for_each(|(sum, channel)| *sum += u16::from(channel));
    }

    fn mean(sum: [u16; 3], count: u16) -> Self {
        Self(sum.map(|sum| pixel::mean(sum, count) as u8))
    }
}

const WIDTH: u16 = 48;

/// All rows of a source, from the bottom up, and each one again.
fn rows<P: Pixel + PartialEq + std::fmt::Debug>(
    source: &mut dyn RowSource<Pixel = P>,
    empty: P,
) -> Vec<[P; WIDTH as usize]> {
    assert_eq!(source.size(), Size::new(WIDTH, 36).unwrap());
    let mut render = |y| {
        let mut row = [empty; WIDTH as usize];
        source.render(y, &mut row).unwrap();
        row
    };
    let mut rows: Vec<_> = (0..36).rev().map(&mut render).collect();
    rows.reverse();
    assert!((0..36).zip(&rows).all(|(y, row)| render(y) == *row));
    let mut row = [empty; WIDTH as usize];
    assert_eq!(source.render(36, &mut row), Err(RowError::Index));
    assert_eq!(source.render(0, &mut row[1..]), Err(RowError::Length));
    rows
}

/// The same scene by every kind of picture, in pixels of three kinds: a smooth picture of one sample is
/// the ordinary one, and a pixel of grey or 16 bits is what its formula makes of the one of 24 bits.
#[test]
fn every_source_gives_the_same_rows_in_every_pixel() {
    let colour = Rgb::new(250, 120, 30);
    let part = Painted::new(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0).unwrap(), colour);
    let (eye, target, up) = (vec3(3.0, 2.0, 4.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    let camera = Perspective::look_at(eye, target, up, 0.5).unwrap();
    let light = Lambert::new(vec3(0.2, 1.0, 0.5), 0.1).unwrap();
    let size = Size::new(WIDTH, 36).unwrap();

    fn both<P: Blend + PartialEq + std::fmt::Debug>(
        picture: &mut dyn RowSource<Pixel = P>,
        smooth: &mut dyn RowSource<Pixel = P>,
        empty: P,
    ) -> Vec<[P; WIDTH as usize]> {
        let plain = rows(picture, empty);
        assert_eq!(plain, rows(smooth, empty));
        plain
    }
    macro_rules! both {
        ($empty:expr) => {{
            let mut columns = [SmoothColumn::EMPTY; WIDTH as usize + 1];
            let smoothing = Smoothing::new(size, 1, &mut columns).unwrap();
            both(
                &mut Picture::new(&part, &camera, size, light, $empty),
                &mut SmoothPicture::new(&part, &camera, smoothing, light, $empty),
                $empty,
            )
        }};
    }
    let black = Own([0; 3]);
    let (colours, greys, bits) = (both!(black), both!(Gray8(0)), both!(Rgb565(0)));
    let the_librarys = both!(Rgb888([0; 3]));
    assert_eq!(
        the_librarys.concat(),
        colours.concat().iter().map(|own| Rgb888(own.0)).collect::<Vec<_>>()
    );

    let mut lit = 0;
    for ((colour888, grey), colour565) in colours.iter().zip(&greys).zip(&bits) {
        for ((colour888, grey), colour565) in colour888.iter().zip(grey).zip(colour565) {
            if *colour888 == black {
                continue;
            }
            lit += 1;
            let expected = |level| (Gray8::shaded(colour, level), Rgb565::shaded(colour, level));
            let is_one = |level: &u8| {
                Own::shaded(colour, *level) == *colour888 && expected(*level) == (*grey, *colour565)
            };
            assert!((0..=255).any(|level| is_one(&level)), "{colour888:?} {grey:?} {colour565:?}");
        }
    }
    assert!(lit > 400, "{lit}");
}
