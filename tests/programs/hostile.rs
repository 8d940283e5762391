//! Bytes that nobody sends: what `fuzz/` looks for without end, with a fixed share of such bytes.

#![allow(clippy::expect_used)]

#[path = "../../fuzz/src/lib.rs"]
mod targets;

use testkit::random::Random;

/// Bytes of many kinds: even ones, few different ones, mostly zeros, runs, and small numbers.
fn bytes(random: &mut Random, longest: usize) -> Vec<u8> {
    let len = random.below(longest);
    let kind = random.below(5);
    let mut last = 0;
    (0..len)
        .map(|_| {
            let any = random.below(256) as u8;
            last = match kind {
                0 => any,
                1 => any % 4,
                2 if random.chance(0.8) => 0,
                3 if random.chance(0.8) => last,
                4 => any % 16,
                _ => any,
            };
            last
        })
        .collect()
}

fn hold(name: &str, count: usize, longest: usize, check: fn(&[u8])) {
    let mut random = Random::named(name);
    for _ in 0..count {
        let bytes = bytes(&mut random, longest);
        // The bytes are shown by a test that fails.
        let result = std::panic::catch_unwind(|| check(&bytes));
        assert!(result.is_ok(), "{name}: {bytes:?}");
    }
}

#[test]
fn decoder() {
    hold("decoder", 2_000, 700, targets::decoder);
}

#[test]
fn rows() {
    hold("rows", 2_000, 900, targets::rows);
}

#[test]
fn receiver() {
    hold("receiver", 1_000, 900, targets::receiver);
}

#[test]
fn sender() {
    hold("sender", 1_000, 500, targets::sender);
}

/// Bytes of this kind are seldom a program: `tests/programs/bytes.rs` changes those of one.
#[test]
fn program() {
    hold("program", 2_000, 200, targets::program);
}

#[test]
fn inbox() {
    hold("inbox", 1_000, 900, targets::inbox);
}

#[test]
fn upload() {
    hold("upload", 1_000, 500, targets::upload);
}
