//! Rows by prediction: several rows in one payload, of a fourth or less of what PackBits takes.
//!
//! A pixel becomes a symbol (`alphabet.rs`, `palette.rs`), a symbol decisions about how far it is from its
//! prediction (`rows.rs`), and a decision with its adaptive probability (`model.rs`, `start.rs`) a part of
//! the payload (`range.rs`). Pixels of one bit have decisions of their own (`bilevel.rs`). Every payload is
//! decoded alone. The repository's `docs/link.md` says all of it byte by byte.

mod alphabet;
mod bilevel;
mod coding;
mod model;
mod palette;
mod range;
mod rows;
mod start;
mod unpack;

pub use coding::{Predictable, Predictive, PredictiveMono};
pub(in crate::stream) use unpack::unpack;

#[cfg(test)]
mod tests {
    use super::alphabet::Alphabet;
    use super::palette::Palette;
    use super::start::START;
    use crate::render::{Pixel, Rgb, Rgb565};
    use proptest::prelude::*;
    use std::string::String;
    use std::vec::Vec;

    #[test]
    fn the_start_table_is_that_of_the_documentation() {
        let words = include_str!("../../../../docs/link_rows.md").split_whitespace();
        let all: String = words.collect();
        let table: String = START.iter().map(|start| std::format!("{start:02x}")).collect();
        assert!(all.contains(&table));
    }

    proptest! {
        /// For fewer colours than there is room for, and for more.
        #[test]
        fn symbols_are_places_in_the_chains(colors: [[u8; 3]; 6], count in 0..=6_usize) {
            let colors = colors.map(|[r, g, b]| Rgb::new(r, g, b));
            let colors = colors.get(..count).unwrap_or_default();
            check::<6>(colors)?;
            check::<3>(colors)?;
        }
    }

    fn check<const N: usize>(colors: &[Rgb]) -> Result<(), TestCaseError> {
        let mut palette = Palette::<Rgb565, N>::new(colors);
        let white = [Rgb::WHITE];
        let colors = if colors.is_empty() { &white } else { colors };
        let chain = |color: &Rgb| {
            let mut chain: Vec<_> = (0..=255).map(|level| Rgb565::shaded(*color, level)).collect();
            chain.dedup();
            chain
        };
        let chains: Vec<Rgb565> = colors.iter().take(N).flat_map(chain).collect();
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
        Ok(())
    }
}
