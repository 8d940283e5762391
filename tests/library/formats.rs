//! Every public type that holds data can be logged by firmware: with the feature `defmt` it has a `Format`.
//!
//! The library's text is read, so no type can be forgotten: what a public module hands on with `pub use`, or
//! declares, is public.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Not values, but memory of something under way: it borrows other memory, or holds a solid's stages.
const STATE: [&str; 26] = [
    "Assembler",
    "Decoder",
    "Dithered",
    "FaceRows",
    "FaceView",
    "GroupRow",
    "Inbox",
    "LeafRow",
    "Line",
    "Member",
    "Memory",
    "OfFixed",
    "OfFloat",
    "Picture",
    "PoolRow",
    "Predictive",
    "PredictiveMono",
    "Receiver",
    "RowHash",
    "Sample",
    "Scanline",
    "Sender",
    "SmoothColumn",
    "SmoothPicture",
    "Smoothing",
    "Upload",
];

/// Files whose own declarations are public, besides every `mod.rs` of a public module.
const PUBLIC: [&str; 12] = [
    "geom/mod.rs",
    "inspect/mod.rs",
    "interop/mod.rs",
    "interop/embedded_graphics.rs",
    "render/mod.rs",
    "render/pixel/mod.rs",
    "scalar/mod.rs",
    "scan/mod.rs",
    "scan/bounds/mod.rs",
    "solid/mod.rs",
    "span/walk.rs",
    "spline/mod.rs",
];

fn read(folder: &Path, texts: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        // A primitive's views and rows are its own, with names of the public ones of pictures.
        let is_stage =
            ["orthographic.rs", "perspective.rs"].iter().any(|name| path.ends_with(name));
        if path.is_dir() {
            read(&path, texts);
        } else if !is_stage || path.starts_with(Path::new(ROOT).join("src/geom")) {
            texts.push(fs::read_to_string(path).unwrap());
        }
    }
}

fn names(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|name| !name.is_empty())
}

/// The declared types of a text, with the attributes before each.
fn types(text: &str) -> Vec<(&str, String)> {
    let (mut found, mut attributes) = (Vec::new(), String::new());
    for line in text.lines().map(str::trim) {
        let name = ["pub struct ", "pub enum "].iter().find_map(|start| line.strip_prefix(start));
        if let Some(name) = name.and_then(|rest| names(rest).next()) {
            found.push((name, std::mem::take(&mut attributes)));
        } else if line.starts_with("#[") {
            attributes += line;
        } else if line.is_empty() || line.ends_with(['}', ';']) {
            attributes.clear();
        }
    }
    found
}

#[test]
fn every_public_type_has_a_format() {
    let source = Path::new(ROOT).join("src");
    let file = |path: &str| fs::read_to_string(source.join(path)).unwrap();
    let mut public = BTreeSet::new();
    for text in PUBLIC.iter().chain(&["span/mod.rs", "stream/mod.rs", "lib.rs"]).map(|p| file(p)) {
        let handed_on = text.split("\npub use ").skip(1);
        let handed_on = handed_on.flat_map(|rest| names(rest.split(';').next().unwrap()));
        let declared = types(&text).into_iter().map(|(name, _)| name);
        public.extend(handed_on.chain(declared).map(str::to_owned));
    }
    let mut texts = Vec::new();
    read(&source, &mut texts);
    let all = texts.concat();
    let (mut seen, mut without) = (BTreeSet::new(), BTreeSet::new());
    for (name, attributes) in texts.iter().flat_map(|text| types(text)) {
        if !public.contains(name) || STATE.contains(&name) {
            continue;
        }
        seen.insert(name);
        // The texts of an error enum come with a `Format`, and so do the variants of the error of all.
        let is_derived = attributes.contains("derive(defmt::Format)");
        let is_written = all.contains(&format!("defmt::Format for {name}"));
        if !is_derived && !is_written && !is_error(name, &all) {
            without.insert(name);
        }
    }
    assert!(seen.len() > 100, "{seen:?}");
    assert_eq!(without, BTreeSet::new());
}

/// Whether `error_text!` declares it, which derives a `Format` for all.
fn is_error(name: &str, all: &str) -> bool {
    let declared = all.split("error_text! {").skip(1);
    declared.into_iter().any(|rest| {
        let start = rest.split("pub enum ").nth(1).unwrap_or_default();
        names(start).next() == Some(name)
    })
}
