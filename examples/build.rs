//! A board's memory map and linker scripts, and which board a target stands for: one target, one emulated
//! board. `--cfg board="yours"` among the compiler's flags is a board of your own.

use std::env;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=../memory.x");
    println!("cargo:rerun-if-changed=../memory");
    println!(
        "cargo:rustc-check-cfg=cfg(board, values(\"microbit\", \"lm3s6965\", \"an386\", \"an505\", \"virt\", \"yours\"))"
    );
    // The part of the example `part`: a file of `scancsg-scad --firmware`.
    println!("cargo:rerun-if-env-changed=SCANCSG_PART");
    let own = concat!(env!("CARGO_MANIFEST_DIR"), "/part/clip.rs");
    let part = env::var("SCANCSG_PART");
    println!("cargo:rustc-env=SCANCSG_PART={}", part.as_deref().unwrap_or(own));
    let is_given = part.is_ok();
    let target = env::var("TARGET").unwrap_or_default();
    let (board, scripts): (&str, &[&str]) = match target.as_str() {
        "thumbv6m-none-eabi" => ("microbit", &[]),
        "thumbv7m-none-eabi" => ("lm3s6965", &["--defsym=_ram_size=0x10000"]),
        // The board has 4 MB: large parts may take some.
        "thumbv7em-none-eabihf" if is_given => ("an386", &["--defsym=_ram_size=0x100000"]),
        "thumbv7em-none-eabihf" => ("an386", &["--defsym=_ram_size=0x10000"]),
        "thumbv8m.main-none-eabihf" => (
            "an505",
            &[
                "--defsym=_flash=0x10000000",
                "--defsym=_ram=0x38000000",
                "--defsym=_ram_size=0x10000",
            ],
        ),
        "riscv32imac-unknown-none-elf" => ("virt", &["-Tmemory/virt.x"]),
        _ => return,
    };
    println!("cargo:rustc-cfg=board=\"{board}\"");
    // defmt.x is of no effect unless the feature `defmt` is on.
    for argument in scripts.iter().chain(&["-Tlink.x", "-Tdefmt.x"]) {
        println!("cargo:rustc-link-arg-examples={argument}");
    }
}
