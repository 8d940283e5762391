//! The page: the crate as a module for browsers, and everything else, in one HTML file.

use crate::command::done;
use crate::paths::root;
use crate::toolchain::{self, WEB, has_program};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

#[derive(Debug, clap::Args)]
pub struct Web {
    /// Test the page too, in Chromium without a window
    #[arg(long)]
    pub test: bool,
}

/// Builds the page, and tests it if that is wanted.
pub fn run(chosen: &Web) -> Result<(), String> {
    let page = build()?;
    if chosen.test { test(&page) } else { Ok(()) }
}

/// Writes the page. Returns its path.
fn build() -> Result<PathBuf, String> {
    let toolchain = toolchain::find(WEB)?;
    eprintln!("building the page with {}", toolchain.version);
    let module = toolchain.build_web()?;
    let module = fs::read(&module).map_err(|error| format!("{}: {error}", module.display()))?;
    let part = |name: &str| {
        let path = root().join("web/page").join(name);
        fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
    };
    let page = part("page.html")?;
    let page = put(&page, "/* page.css */", &part("page.css")?)?;
    let page = put(&page, "/* line.js */", &part("line.js")?)?;
    let page = put(&page, "/* page.js */", &part("page.js")?)?;
    let page = put(&page, "module.wasm", &base64(&module))?;
    let path = root().join("target/web/scancsg.html");
    fs::write(&path, &page).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("{}: {} KB", path.display(), page.len() / 1000);
    Ok(path)
}

/// Puts a part in the one place that it has in the page.
fn put(page: &str, place: &str, part: &str) -> Result<String, String> {
    match page.matches(place).count() {
        1 => Ok(page.replacen(place, part, 1)),
        count => Err(format!("the page has {count} places for \"{place}\"")),
    }
}

/// RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let digit = |bits: u32, place: u32| {
        let index = (bits >> (18 - 6 * place) & 63) as usize;
        char::from(DIGITS.get(index).copied().unwrap_or_default())
    };
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |index: usize| u32::from(three.get(index).copied().unwrap_or_default());
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        let count = three.len() as u32 + 1;
        text.extend((0..4).map(|place| if place < count { digit(bits, place) } else { '=' }));
    }
    text
}

fn test(page: &Path) -> Result<(), String> {
    if !has_program("chromium") {
        return Err("the page is tested in Chromium, which isn't there. \
                    On Debian: `apt-get install --no-install-recommends chromium`"
            .to_owned());
    }
    let cargo = |words: &str| {
        let mut command = Command::new("cargo");
        command.args(words.split(' ')).current_dir(root());
        command
    };
    let target =
        env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let mut examples = cargo("build --package examples --example stream --example view");
    let mut test = cargo("test --package scancsg-web --test view --test page -- --include-ignored");
    test.env("SCANCSG_PAGE", page).env("SCANCSG_EXAMPLES", target.join("debug/examples"));
    done(&mut examples)?;
    done(&mut test)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_become_base64() {
        let pairs =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg==")];
        assert!(pairs.iter().all(|(bytes, text)| base64(bytes.as_bytes()) == *text));
        assert_eq!(base64(&[0xFB, 0xEF, 0xBE, 0xFF]), "++++/w==");
    }

    #[test]
    fn a_part_has_one_place() {
        assert_eq!(put("<p>here</p>", "here", "text").as_deref(), Ok("<p>text</p>"));
        assert!(put("here and here", "here", "text").is_err());
        assert!(put("nowhere", "there", "text").is_err());
    }
}
