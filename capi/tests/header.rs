//! The header that is checked in is that of these sources.

#![allow(clippy::unwrap_used)]

use std::path::Path;

#[test]
fn the_header_is_current() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(package.join("cbindgen.toml")).unwrap();
    // In the order of the header.
    let files =
        ["status", "number", "table", "capacity", "scene", "pixels", "picture", "ray", "packet"];
    let builder = files.iter().fold(cbindgen::Builder::new(), |builder, file| {
        builder.with_src(package.join("src").join(file).with_extension("rs"))
    });
    let bindings = builder.with_config(config).generate();
    let mut header = Vec::new();
    bindings.unwrap().write(&mut header);
    let header = String::from_utf8(header).unwrap();
    let path = package.join("include/scancsg.h");
    if std::env::var_os("SCANCSG_BLESS").is_some_and(|value| value == "1") {
        std::fs::write(&path, &header).unwrap();
        return;
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    let differing = kept.lines().zip(header.lines()).position(|(kept, new)| kept != new);
    assert!(
        kept == header,
        "include/scancsg.h isn't current, from line {differing:?} on; SCANCSG_BLESS=1 writes it anew"
    );
}
