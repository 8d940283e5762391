//! What is in a firmware, and what must not be.

use crate::board::Number;
use object::elf::{SHF_ALLOC, SHF_WRITE, SHT_NOBITS};
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags};
use std::path::Path;

pub struct Contents {
    /// Code, constants, and initial values of variables, in bytes.
    pub flash: u64,
    /// Variables, in bytes.
    pub ram: u64,
    symbols: Vec<String>,
}

impl Contents {
    pub fn read(elf: &Path) -> Result<Self, String> {
        let text = |error: &dyn std::fmt::Display| format!("{}: {error}", elf.display());
        let bytes = std::fs::read(elf).map_err(|error| text(&error))?;
        let file = object::File::parse(bytes.as_slice()).map_err(|error| text(&error))?;
        let (mut flash, mut ram) = (0, 0);
        for section in file.sections() {
            let SectionFlags::Elf { sh_type, sh_flags } = section.flags() else { continue };
            // What riscv-rt leaves to the stack and the heap is not variables.
            if !sh_flags.contains(SHF_ALLOC) || matches!(section.name(), Ok(".stack" | ".heap")) {
                continue;
            }
            // Initial values of variables are in both.
            flash += if sh_type == SHT_NOBITS { 0 } else { section.size() };
            ram += if sh_flags.contains(SHF_WRITE) { section.size() } else { 0 };
        }
        let demangled = |name: &str| format!("{:#}", rustc_demangle::demangle(name));
        Ok(Self {
            flash,
            ram,
            symbols: file
                .symbols()
                .filter(ObjectSymbol::is_definition)
                .filter_map(|symbol| symbol.name().ok().map(demangled))
                .collect(),
        })
    }

    /// What is in there that must not be.
    pub fn problems(&self, number: Number) -> impl Iterator<Item = String> {
        type Rule = (&'static str, fn(&str) -> bool, bool);
        let rules: [Rule; 5] = [
            ("an allocator", is_allocator, true),
            ("a panic", is_panic, true),
            ("formatting", is_formatting, true),
            ("arithmetic in f64", is_double, true),
            ("floating point", is_single, number == Number::I16f16),
        ];
        rules
            .into_iter()
            .filter(|(_, _, applies)| *applies)
            .filter_map(|(what, is_unwanted, _)| {
                let found: Vec<&str> = self
                    .symbols
                    .iter()
                    .map(String::as_str)
                    .filter(|name| is_unwanted(name))
                    .take(4)
                    .collect();
                (!found.is_empty()).then(|| format!("{what} is linked: {}", found.join(", ")))
            })
            .collect::<Vec<_>>()
            .into_iter()
    }
}

fn is_allocator(name: &str) -> bool {
    name.contains("__rust_alloc") || name.contains("alloc::")
}

fn is_panic(name: &str) -> bool {
    ["panicking", "panic_", "rust_begin_unwind"].iter().any(|part| name.contains(part))
        || name.ends_with("_failed")
        || name.ends_with("_fail")
}

fn is_formatting(name: &str) -> bool {
    name.contains("core::fmt") || name.ends_with("::fmt")
}

/// The run-time library's names, by the run-time ABI of Arm and by GCC's.
fn is_double(name: &str) -> bool {
    name.starts_with("__aeabi_d") || has_word(name, "f64") || is_gcc_name(name, "df")
}

fn is_single(name: &str) -> bool {
    ["__aeabi_f", "__aeabi_i2f", "__aeabi_ui2f", "__aeabi_l2f", "__aeabi_ul2f"]
        .iter()
        .any(|start| name.starts_with(start))
        || has_word(name, "f32")
        || has_word(name, "libm")
        || is_gcc_name(name, "sf")
}

/// Whether a path has this name in it, and not only a hash that happens to contain it.
fn has_word(name: &str, word: &str) -> bool {
    name.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').any(|part| part == word)
}

/// `__adddf3`, `__floatsidf` and the like.
fn is_gcc_name(name: &str, kind: &str) -> bool {
    name.strip_prefix("__").is_some_and(|rest| {
        let rest = rest.trim_end_matches(|c: char| c.is_ascii_digit());
        rest.chars().all(|c| c.is_ascii_lowercase())
            && (rest.ends_with(kind)
                || ["si", "di"].iter().any(|integer| rest.ends_with(&format!("{kind}{integer}"))))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unwanted_symbols_are_known_by_their_names() {
        assert!(is_panic("core::panicking::panic_fmt"));
        assert!(is_formatting("core::fmt::write"));
        assert!(is_formatting("<u32 as core::fmt::Display>::fmt"));
        assert!(is_double("__fixdfsi") && is_single("__fixunssfdi") && !is_single("__floatsidf"));
        assert!(is_panic("core::slice::index::slice_index_fail") && is_panic("rust_begin_unwind"));
        assert!(is_double("__aeabi_dadd") && is_double("__adddf3") && is_double("__floatsidf"));
        assert!(is_single("__aeabi_fmul") && is_single("__mulsf3") && is_single("libm::sqrtf"));
        assert!(!is_double("__aeabi_uldivmod") && !is_single("__aeabi_lmul"));
        assert!(is_single("<f32 as scancsg::scalar::Real>::sqrt") && !is_single(".Lanon.2f32.7"));
        assert!(!is_single("scancsg::span::merge::merge") && !is_panic("board::paint"));
        assert!(is_allocator("__rust_alloc") && !is_allocator("scancsg::solid::Shape"));
    }
}
