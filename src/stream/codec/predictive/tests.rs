//! Rows there and back, in every format; and payloads that no encoder has written, which two decoders read
//! alike.

use proptest::prelude::*;
use std::vec;
use std::vec::Vec;

use super::alphabet::Levels;
use super::palette::Palette;
use super::reference::Reference;
use super::*;
use crate::render::{Gray8, Pixel, Rgb, Rgb565};
use core::marker::PhantomData;

/// A packet's payloads, each with its number of rows.
type Payloads = Vec<(usize, Vec<u8>)>;

const MOST: usize = 243;

/// All rows, in as few payloads as there can be. A row that fits in none is left out.
fn encode<A: Alphabet<Pixel: WirePixel<Wire = A::Pixel> + Wire>>(
    alphabet: &mut A,
    width: usize,
    pixels: &[A::Pixel],
) -> (Payloads, Vec<A::Pixel>) {
    let mut above = vec![A::kept(0); width];
    let (mut payloads, mut sent) = (Vec::new(), Vec::new());
    let mut encoder = RowsEncoder::new();
    let mut out = [0xA5; MOST];
    let mut rows = pixels.chunks_exact(width).peekable();
    while rows.peek().is_some() {
        encoder.begin();
        let mut count = 0;
        while let Some(row) = rows.peek() {
            if !encoder.push(alphabet, &mut above, row, &mut out) {
                break;
            }
            sent.extend_from_slice(row);
            count += 1;
            rows.next();
        }
        if count == 0 {
            rows.next();
        } else {
            let len = encoder.finish(&mut out);
            payloads.push((count, out[..len].to_vec()));
        }
    }
    (payloads, sent)
}

fn decode<A: Alphabet>(alphabet: &mut A, width: usize, payloads: &Payloads) -> (Vec<u8>, bool) {
    let bytes = A::bytes(alphabet.pixel(0)).as_ref().len();
    // Nothing is left of whatever was decoded before.
    let mut above = vec![A::kept(0x55); width];
    let mut model = Model::starting(&[77; SLOTS]);
    let mut pixels = Vec::new();
    let mut is_exact = true;
    for (count, payload) in payloads {
        let mut decoder = RowsDecoder::new(&mut model, payload);
        for _ in 0..*count {
            let mut row = vec![0; width * bytes];
            decoder.row(alphabet, &mut above, &mut row);
            pixels.extend(row);
        }
        is_exact &= decoder.is_exact();
    }
    (pixels, is_exact)
}

fn round_trip<A>(alphabet: &A, width: usize, pixels: &[A::Pixel])
where
    A: Alphabet<Pixel: WirePixel<Wire = A::Pixel> + Wire> + Clone,
{
    let (mut payloads, sent) = encode(&mut alphabet.clone(), width, pixels);
    let wanted: Vec<u8> = sent.iter().flat_map(|p| A::bytes(*p).as_ref().to_vec()).collect();
    let (decoded, is_exact) = decode(&mut alphabet.clone(), width, &payloads);
    assert!(decoded == wanted);
    assert!(is_exact);
    // Each is decoded alone, in any order.
    payloads.reverse();
    let mut rest = wanted.as_slice();
    for (count, payload) in &payloads {
        let one = vec![(*count, payload.clone())];
        let (decoded, is_exact) = decode(&mut alphabet.clone(), width, &one);
        assert!(rest.ends_with(&decoded));
        assert!(is_exact);
        rest = &rest[..rest.len() - decoded.len()];
        // A byte more is one too many, and one fewer is missing.
        let longer = vec![(*count, [payload.as_slice(), &[0]].concat())];
        assert!(!decode(&mut alphabet.clone(), width, &longer).1);
        if let Some((0, shorter)) = payload.split_last() {
            let shorter = vec![(*count, shorter.to_vec())];
            assert!(!decode(&mut alphabet.clone(), width, &shorter).1);
        }
    }
    assert!(rest.is_empty());
}

/// Rows of runs, slopes and noise.
fn levels() -> impl Strategy<Value = (usize, Vec<u8>)> {
    let piece = (0..3, any::<u8>(), -3..4_i32, 1..60_usize);
    let pieces = proptest::collection::vec(piece, 1..60);
    (1..=700_usize, pieces, any::<bool>()).prop_map(|(width, pieces, is_steady)| {
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

fn colors() -> impl Strategy<Value = Vec<Rgb>> {
    proptest::collection::vec(any::<[u8; 3]>(), 0..6)
        .prop_map(|all| all.into_iter().map(|[r, g, b]| Rgb::new(r, g, b)).collect())
}

/// The table and the example of the documentation are what the coder has and writes.
#[test]
fn the_documentation_is_right() {
    let words = include_str!("../../../../docs/link_rows.md").split_whitespace();
    let all: std::string::String = words.collect();
    let hex = |bytes: &[u8]| -> std::string::String {
        bytes.iter().map(|byte| std::format!("{byte:02x}")).collect()
    };
    assert!(all.contains(&hex(&START)));
    let rows =
        [[0, 0, 0, 50, 60, 70, 80, 0], [0, 0, 0, 51, 61, 71, 81, 0], [0, 0, 0, 52, 64, 90, 90, 0]];
    let (payloads, _) =
        encode(&mut Levels::<u8>(PhantomData), 8, rows.map(|row| row.map(Gray8)).as_flattened());
    assert_eq!(payloads.len(), 1);
    assert!(all.contains(&std::format!("Thepayload`{}`holds", hex(&payloads[0].1))));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, ..ProptestConfig::default() })]

    #[test]
    fn gray((width, levels) in levels()) {
        let pixels: Vec<Gray8> = levels.into_iter().map(Gray8).collect();
        round_trip(&Levels::<u8>(PhantomData), width, &pixels);
    }

    #[test]
    fn colors_of_a_scene((width, levels) in levels(), colors in colors()) {
        let palette = Palette::<Rgb565, 6>::new(&colors);
        let shade = |(i, level): (usize, &u8)| {
            let color = colors.get(i / 7 % colors.len().max(1)).copied();
            // Some pixels are of another colour.
            let color = color.filter(|_| i % 50 > 0).unwrap_or(Rgb::new(90, 250, 10));
            Rgb565::shaded(color, *level)
        };
        let pixels: Vec<Rgb565> = levels.iter().enumerate().map(shade).collect();
        round_trip(&palette, width, &pixels);
    }

    #[test]
    fn any_colors((width, levels) in levels(), colors in colors(), salt in any::<u16>()) {
        let palette = Palette::<Rgb565, 3>::new(&colors);
        let any = |level: &u8| Rgb565(u16::from(*level).wrapping_mul(0x3_41).wrapping_add(salt));
        let pixels: Vec<Rgb565> = levels.iter().map(any).collect();
        round_trip(&palette, width, &pixels);
    }

    #[test]
    fn bits((width, levels) in levels(), mask in 1..=255_u8) {
        let pixels: Vec<bool> = levels.iter().map(|level| level & mask == mask).collect();
        let size = width.div_ceil(8);
        let mut above = vec![0xFF; size];
        let mut encoder = BilevelEncoder::new();
        let (mut out, mut model) = ([0xA5; MOST], Model::starting(&[1; bilevel::CONTEXTS]));
        let mut rows = pixels.chunks_exact(width).peekable();
        while rows.peek().is_some() {
            encoder.begin(&mut above);
            let mut sent = Vec::new();
            while let Some(row) = rows.peek() {
                if !encoder.push(&mut above, width, |x| row[x], &mut out) {
                    break;
                }
                sent.push(*row);
                rows.next();
            }
            // A row of 700 pixels of noise is 88 bytes.
            prop_assert!(!sent.is_empty());
            let len = encoder.finish(&mut out);
            let mut above = vec![0x55; size];
            let mut decoder = BilevelDecoder::new(&mut model, &mut above, &out[..len]);
            for row in sent {
                decoder.row(&mut above, width);
                let byte = |bits: &[bool]| {
                    bits.iter().zip((0..8).rev()).map(|(bit, at)| u16::from(*bit) << at).sum()
                };
                let wanted: Vec<u16> = row.chunks(8).map(byte).collect();
                prop_assert_eq!(&above, &wanted);
            }
            prop_assert!(decoder.is_exact());
        }
    }

    #[test]
    fn any_payload_is_some_rows_of_bits(
        payload in proptest::collection::vec(any::<u8>(), 0..300),
        width in 1..400_usize,
    ) {
        let size = width.div_ceil(8);
        let mut above = vec![0; size];
        let mut model = Model::starting(&bilevel::START);
        let mut decoder = BilevelDecoder::new(&mut model, &mut above, &payload);
        for _ in 0..5 {
            decoder.row(&mut above, width);
            // Nothing is behind the last pixel.
            let unused = 0xFF_u16 >> ((width - 1) % 8) >> 1;
            prop_assert_eq!(above[size - 1] & unused, 0);
        }
    }

    #[test]
    fn any_payload_is_what_the_reference_reads(
        payload in payloads(),
        width in 1..400_usize,
        colors in colors(),
    ) {
        const COUNT: usize = 5;
        let levels: Vec<Vec<i64>> = (0..=255).map(|level| vec![level]).collect();
        let mut reference = Reference::new(&payload, &levels, &[255]);
        let rows = (0..COUNT).flat_map(|_| reference.row(width));
        let wanted: Vec<u8> = rows.map(|pixel| pixel[0] as u8).collect();
        let payloads = vec![(COUNT, payload)];
        prop_assert!(decode(&mut Levels::<u8>(PhantomData), width, &payloads).0 == wanted);

        let mut palette = Palette::<Rgb565, 6>::new(&colors);
        let chains: Vec<Vec<i64>> = chains(&colors).into_iter().map(channels).collect();
        let mut reference = Reference::new(&payloads[0].1, &chains, &[31, 63, 31]);
        let rows = (0..COUNT).flat_map(|_| reference.row(width));
        let pixel = |p: Vec<i64>| Rgb565((p[0] << 11 | p[1] << 5 | p[2]) as u16);
        let wanted: Vec<u8> = rows.flat_map(|p| pixel(p).0.to_le_bytes()).collect();
        prop_assert!(decode(&mut palette, width, &payloads).0 == wanted);
    }

    #[test]
    fn symbols_are_places_in_the_chains(colors in colors()) {
        let mut palette = Palette::<Rgb565, 6>::new(&colors);
        let chains = chains(&colors);
        prop_assert_eq!(palette.top(), chains.len() as i32 - 1);
        for (symbol, pixel) in (0..).zip(&chains) {
            prop_assert_eq!(palette.pixel(symbol), *pixel);
            let first = chains.iter().position(|other| other == pixel).unwrap() as i32;
            prop_assert_eq!(palette.symbol(*pixel), (first, true));
        }
        for pixel in (0..=u16::MAX).step_by(257).map(Rgb565) {
            let (symbol, is_exact) = palette.symbol(pixel);
            prop_assert_eq!(is_exact, chains.contains(&pixel));
            prop_assert!((0..=palette.top()).contains(&symbol));
        }
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
    let white = [Rgb::new(255, 255, 255)];
    let colors = if colors.is_empty() { &white } else { colors };
    let chain = |color: &Rgb| {
        let mut chain: Vec<_> = (0..=255).map(|level| Rgb565::shaded(*color, level)).collect();
        chain.dedup();
        chain
    };
    colors.iter().flat_map(chain).collect()
}

fn channels(pixel: Rgb565) -> Vec<i64> {
    [pixel.0 >> 11, pixel.0 >> 5 & 63, pixel.0 & 31].map(i64::from).to_vec()
}
