//! Rows that are coded by prediction, there and back; and payloads that no encoder has written, which two decoders
//! read alike.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use proptest::prelude::*;
use reference::{Pixel as Channels, Reference};
use scancsg::render::{Gray8, Mono, Palette, Pixel, Rgb, Rgb565};
use scancsg::stream::{
    Assembler, FrameHeader, Memory, Packet, Predictive, PredictiveMono, ReceiveError, RowCoding,
    UnpackError, Wire,
};

mod reference;

/// A packet's payloads, each with its number of rows.
type Payloads = Vec<(u8, Vec<u8>)>;

/// The bytes of one payload.
const MOST: usize = 243;
/// The widest rows.
const WIDEST: usize = 700;

const DOCUMENTATION: &str = include_str!("../../docs/link_rows.md");

/// All rows, in as few payloads as there can be. A row that fits in none is left out.
fn encode<P: Wire>(
    mut coding: impl RowCoding<P>,
    palette: &Palette,
    width: usize,
    pixels: &[P],
) -> (Payloads, Vec<P>) {
    let (mut payloads, mut sent) = (Vec::new(), Vec::new());
    let mut out = [0xA5; MOST];
    coding.begin_frame(palette);
    let mut rows = pixels.chunks_exact(width).peekable();
    while rows.peek().is_some() {
        coding.begin();
        let mut count = 0;
        while let Some(row) = rows.peek().filter(|_| count < u8::MAX) {
            if !coding.push(row, &mut out) {
                break;
            }
            sent.extend_from_slice(row);
            count += 1;
            rows.next();
        }
        if count == 0 {
            rows.next();
        } else {
            let len = coding.finish(&mut out);
            payloads.push((count, out[..len].to_vec()));
        }
    }
    (payloads, sent)
}

/// The bytes of all rows, and whether all payloads were as long as these need.
fn decode<P: Wire>(palette: &Palette, width: usize, payloads: &Payloads) -> (Vec<u8>, bool) {
    let (mut decoded, mut is_exact) = (Vec::new(), true);
    for (count, payload) in payloads {
        let (frame, height, format) = (1, u16::from(*count), P::FORMAT);
        let header = FrameHeader { frame, width: width as u16, height, format, palette: *palette };
        // Nothing is left of whatever was decoded before.
        let mut pixels = vec![0x5A; header.frame_bytes().unwrap()];
        let (mut rows, mut above) = (vec![false; height.into()], vec![0x55; width]);
        let mut assembler =
            Assembler::new(Memory { pixels: &mut pixels, rows: &mut rows, above: &mut above });
        assembler.accept(&Packet::Header(header)).unwrap();
        match assembler.accept(&Packet::Rows { frame, y: 0, count: *count, payload }) {
            Ok(_) => {}
            Err(ReceiveError::Payload(UnpackError::TooLong)) => is_exact = false,
            Err(error) => panic!("{error}"),
        }
        decoded.extend(pixels);
    }
    (decoded, is_exact)
}

fn round_trip<P: Wire>(
    coding: impl RowCoding<P>,
    palette: &Palette,
    width: usize,
    pixels: &[P],
    bytes: impl Fn(&[P]) -> Vec<u8>,
) {
    let (mut payloads, sent) = encode(coding, palette, width, pixels);
    let wanted: Vec<u8> = sent.chunks_exact(width).flat_map(bytes).collect();
    let (decoded, is_exact) = decode::<P>(palette, width, &payloads);
    assert!(decoded == wanted);
    assert!(is_exact);
    // Each is decoded alone, in any order.
    payloads.reverse();
    let mut rest = wanted.as_slice();
    for (count, payload) in &payloads {
        let one = vec![(*count, payload.clone())];
        let (decoded, is_exact) = decode::<P>(palette, width, &one);
        assert!(rest.ends_with(&decoded));
        assert!(is_exact);
        rest = &rest[..rest.len() - decoded.len()];
        // A byte more is one too many, and one fewer is missing.
        let longer = vec![(*count, [payload.as_slice(), &[0]].concat())];
        assert!(!decode::<P>(palette, width, &longer).1);
        if let Some((0, shorter)) = payload.split_last() {
            let shorter = vec![(*count, shorter.to_vec())];
            assert!(!decode::<P>(palette, width, &shorter).1);
        }
    }
    assert!(rest.is_empty());
}

fn levels_of(row: &[Gray8]) -> Vec<u8> {
    row.iter().map(|pixel| pixel.0).collect()
}

fn words_of(row: &[Rgb565]) -> Vec<u8> {
    row.iter().flat_map(|pixel| pixel.0.to_le_bytes()).collect()
}

fn bits_of(row: &[Mono]) -> Vec<u8> {
    let byte =
        |bits: &[Mono]| bits.iter().zip((0..8).rev()).map(|(bit, at)| u8::from(bit.0) << at).sum();
    row.chunks(8).map(byte).collect()
}

/// Rows of runs, slopes and noise.
fn levels() -> impl Strategy<Value = (usize, Vec<u8>)> {
    let piece = (0..3, any::<u8>(), -3..4_i32, 1..60_usize);
    let pieces = proptest::collection::vec(piece, 1..60);
    (1..=WIDEST, pieces, any::<bool>()).prop_map(|(width, pieces, is_steady)| {
        let mut levels = Vec::new();
        for (kind, level, slope, count) in pieces {
            for i in 0..count as i32 {
                let value = match kind {
                    0 => level.into(),
                    1 => i32::from(level) + slope * i,
                    _ => i32::from(level).wrapping_mul(i * i * 7 + slope) >> 3,
                };
                levels.push(value as u8);
            }
        }
        let height = levels.len().div_ceil(width).max(3);
        if is_steady {
            // Each row is nearly the one before.
            let row: Vec<u8> = levels.iter().copied().cycle().take(width).collect();
            levels = (0..height)
                .flat_map(|y| row.iter().map(move |level| level.wrapping_add((y / 2) as u8)))
                .collect();
        } else {
            let all = levels.iter().copied().cycle().take(width * height).collect();
            levels = all;
        }
        (width, levels)
    })
}

fn palette() -> impl Strategy<Value = Palette> {
    proptest::collection::vec(any::<[u8; 3]>(), 0..6)
        .prop_map(|all| all.into_iter().map(|[r, g, b]| Rgb::new(r, g, b)).collect())
}

/// The example of the documentation is what the coder writes.
#[test]
fn the_documentation_is_right() {
    let all: String = DOCUMENTATION.split_whitespace().collect();
    let rows =
        [[0, 0, 0, 50, 60, 70, 80, 0], [0, 0, 0, 51, 61, 71, 81, 0], [0, 0, 0, 52, 64, 90, 90, 0]];
    let pixels = rows.map(|row| row.map(Gray8));
    let coding = Predictive::<_, 8>::new();
    let (payloads, _) = encode(coding, &Palette::EMPTY, 8, pixels.as_flattened());
    assert_eq!(payloads.len(), 1);
    let hex: String = payloads[0].1.iter().map(|byte| format!("{byte:02x}")).collect();
    assert!(all.contains(&format!("Thepayload`{hex}`holds")));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, ..ProptestConfig::default() })]

    #[test]
    fn gray((width, levels) in levels()) {
        let pixels: Vec<Gray8> = levels.into_iter().map(Gray8).collect();
        round_trip(Predictive::<_, WIDEST>::new(), &Palette::EMPTY, width, &pixels, levels_of);
    }

    #[test]
    fn colors_of_a_scene((width, levels) in levels(), palette in palette()) {
        let shade = |(i, level): (usize, &u8)| {
            let color = palette.get(i / 7 % palette.len().max(1)).copied();
            // Some pixels are of another colour.
            let color = color.filter(|_| i % 50 > 0).unwrap_or(Rgb::new(90, 250, 10));
            Rgb565::shaded(color, *level)
        };
        let pixels: Vec<Rgb565> = levels.iter().enumerate().map(shade).collect();
        round_trip(Predictive::<_, WIDEST>::new(), &palette, width, &pixels, words_of);
    }

    #[test]
    fn any_colors((width, levels) in levels(), palette in palette(), salt in any::<u16>()) {
        let any = |level: &u8| Rgb565(u16::from(*level).wrapping_mul(0x3_41).wrapping_add(salt));
        let pixels: Vec<Rgb565> = levels.iter().map(any).collect();
        round_trip(Predictive::<_, WIDEST>::new(), &palette, width, &pixels, words_of);
    }

    #[test]
    fn bits((width, levels) in levels(), mask in 1..=255_u8) {
        let pixels: Vec<Mono> = levels.iter().map(|level| Mono(level & mask == mask)).collect();
        let coding = PredictiveMono::<{ WIDEST.div_ceil(8) }>::new;
        // A row of 700 pixels of noise is 88 bytes.
        prop_assert_eq!(encode(coding(), &Palette::EMPTY, width, &pixels).1, pixels.clone());
        round_trip(coding(), &Palette::EMPTY, width, &pixels, bits_of);
    }

    #[test]
    fn any_payload_is_some_rows_of_bits(
        payload in proptest::collection::vec(any::<u8>(), 0..300),
        width in 1..400_usize,
    ) {
        let (decoded, _) = decode::<Mono>(&Palette::EMPTY, width, &vec![(5, payload)]);
        for row in decoded.chunks_exact(width.div_ceil(8)) {
            // Nothing is behind the last pixel.
            let unused = 0xFF_u8.checked_shr((width as u32 - 1) % 8 + 1).unwrap_or(0);
            prop_assert_eq!(row.last().unwrap() & unused, 0);
        }
    }

    #[test]
    fn any_payload_is_what_the_reference_reads(
        payload in payloads(),
        width in 1..400_usize,
        palette in palette(),
    ) {
        const COUNT: u8 = 5;
        let levels: Vec<Channels> = (0..=255).map(|level| vec![level]).collect();
        let mut reference = Reference::new(&payload, &levels, &[255]);
        let rows = (0..COUNT).flat_map(|_| reference.row(width));
        let wanted: Vec<u8> = rows.map(|pixel| pixel[0] as u8).collect();
        let payloads = vec![(COUNT, payload)];
        prop_assert!(decode::<Gray8>(&Palette::EMPTY, width, &payloads).0 == wanted);

        let chains: Vec<Channels> = chains(&palette).into_iter().map(channels).collect();
        let mut reference = Reference::new(&payloads[0].1, &chains, &[31, 63, 31]);
        let rows = (0..COUNT).flat_map(|_| reference.row(width));
        let pixel = |p: Channels| Rgb565((p[0] << 11 | p[1] << 5 | p[2]) as u16);
        let wanted: Vec<u8> = rows.flat_map(|p| pixel(p).0.to_le_bytes()).collect();
        prop_assert!(decode::<Rgb565>(&palette, width, &payloads).0 == wanted);
    }
}

/// Any bytes, and bytes that are mostly alike, which make long runs of likely decisions.
fn payloads() -> impl Strategy<Value = Vec<u8>> {
    let even = (any::<u8>(), proptest::collection::vec((any::<u8>(), 0..80_usize), 0..5)).prop_map(
        |(byte, others)| {
            let mut bytes = vec![byte; 300];
            others.into_iter().for_each(|(other, place)| bytes[place] = other);
            bytes
        },
    );
    prop_oneof![proptest::collection::vec(any::<u8>(), 0..300), even]
}

/// The different pixels of each base colour, one colour after the other.
fn chains(colors: &[Rgb]) -> Vec<Rgb565> {
    let white = [Rgb::WHITE];
    let colors = if colors.is_empty() { &white } else { colors };
    let chain = |color: &Rgb| {
        let mut chain: Vec<_> = (0..=255).map(|level| Rgb565::shaded(*color, level)).collect();
        chain.dedup();
        chain
    };
    colors.iter().flat_map(chain).collect()
}

fn channels(pixel: Rgb565) -> Channels {
    [pixel.0 >> 11, pixel.0 >> 5 & 63, pixel.0 & 31].map(i64::from).to_vec()
}
