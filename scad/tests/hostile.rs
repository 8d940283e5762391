//! Parts with one thing or another wrong: an error or a part, and never a panic or a loop.

mod support;

use scancsg_scad::scene::Scene;
use scancsg_scad::{Model, lower, parse};
use std::error::Error;
use std::{env, fs};
use support::reference::folder;

/// A xorshift generator.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 33) as usize % count.max(1)
    }
}

/// What stands in for numbers, and for anything.
const NUMBERS: [&str; 10] = ["0", "-1", "1e30", "1e-30", "nan", "inf", "-inf", "3", "1e11", "0.3"];
const WORDS: [&str; 11] = [
    "true",
    "undef",
    "\"a\"",
    "[]",
    "[1, 2]",
    "-2",
    "cube",
    "hull",
    "minkowski",
    "difference",
    "linear_extrude",
];

fn word_at(text: &str, from: usize) -> Option<(usize, usize)> {
    let is_part = |byte: u8| byte.is_ascii_alphanumeric() || b"._-".contains(&byte);
    let bytes = text.as_bytes();
    let start = (from..bytes.len()).find(|at| is_part(bytes[*at]))?;
    let end = (start..bytes.len()).find(|at| !is_part(bytes[*at])).unwrap_or(bytes.len());
    Some((start, end))
}

#[test]
fn wrong_parts_are_errors() -> Result<(), Box<dyn Error>> {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    // More, if somebody has the time: `HOSTILE=10000`.
    let count = env::var("HOSTILE").ok().and_then(|count| count.parse().ok()).unwrap_or(60);
    let (mut parts, mut errors) = (0, 0);
    for name in ["bracket", "funnel", "skewed", "vase", "hinge", "case"] {
        let text = fs::read_to_string(folder().join(name).with_extension("csg"))?;
        for _ in 0..count {
            let mut wrong = text.clone();
            for _ in 0..=random.below(2) {
                let from = random.below(wrong.len());
                let Some((start, end)) = word_at(&wrong, from) else { continue };
                let is_number = wrong[start..end].parse::<f64>().is_ok();
                match random.below(8) {
                    0 => wrong.replace_range(start..end, ""),
                    _ if is_number => {
                        wrong.replace_range(start..end, NUMBERS[random.below(NUMBERS.len())]);
                    }
                    _ => wrong.replace_range(start..end, WORDS[random.below(WORDS.len())]),
                }
            }
            let made = parse(&wrong)
                .and_then(|nodes| lower(&nodes, false))
                .and_then(|part| Model::of(part.tree))
                .and_then(|model| Scene::of(&model));
            match made {
                Ok(_) => parts += 1,
                Err(_) => errors += 1,
            }
        }
    }
    assert!(parts > 50 && errors > 50, "{parts} parts, {errors} errors");
    Ok(())
}
