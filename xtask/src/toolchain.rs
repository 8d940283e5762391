//! A compiler for a board or a browser: rustup's where it has the target, or else Debian's, whose core
//! library is built from its sources once and kept in the user's cache folder.

use crate::board::{Board, Number};
use crate::paths::root;
use std::env;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

pub struct Toolchain {
    /// The compiler's version: instruction counts are this compiler's.
    pub version: String,
    cargo: PathBuf,
    /// Where the compiler is, if it isn't cargo's own, and the libraries that were built for it.
    foreign: Option<(PathBuf, PathBuf)>,
}

/// What the compiler optimises for: Cargo's `opt-level`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    Three,
    S,
    Z,
}

impl Level {
    pub const ALL: [Self; 3] = [Self::Three, Self::S, Self::Z];

    pub fn name(self) -> &'static str {
        match self {
            Self::Three => "3",
            Self::S => "s",
            Self::Z => "z",
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What firmware is built with: fat LTO, one codegen unit.
const PROFILE: &str = "firmware";

/// The target of a page.
pub const WEB: &str = "wasm32-unknown-unknown";

/// Debian's compiler, and the sources of its core library.
pub const DEBIAN_PACKAGES: &str = "rustc-web cargo-web rust-web-src rust-web-llvm lld-22";

/// The compiler for a target.
pub fn find(target: &str) -> Result<Toolchain, String> {
    if has_target(target) {
        let version = version(own("rustc").arg("-vV"))?;
        return Ok(Toolchain { version, cargo: "cargo".into(), foreign: None });
    }
    let (rustc, cargo) = (PathBuf::from("/usr/bin/rustc"), PathBuf::from("/usr/bin/cargo"));
    if !has_debian() {
        return Err(format!(
            "there is no compiler for {target}. Install one with `rustup target add {target}`, or \
             on Debian with `apt-get install --no-install-recommends {DEBIAN_PACKAGES}`"
        ));
    }
    let version = version(Command::new(&rustc).arg("-vV"))?;
    let libraries = libraries(&rustc, &cargo, target, &version)?;
    Ok(Toolchain { version, cargo, foreign: Some((rustc, libraries)) })
}

/// Whether [`find`] has a compiler for a target.
pub fn is_there(target: &str) -> bool {
    has_target(target) || has_debian() && has_program("rust-lld")
}

/// Whether the user's own compiler has the target.
fn has_target(target: &str) -> bool {
    // Not the compiler that cargo has set for this program.
    let sysroot = output(own("rustc").args(["--print", "sysroot"])).unwrap_or_default();
    Path::new(sysroot.trim()).join("lib/rustlib").join(target).join("lib").is_dir()
}

fn has_debian() -> bool {
    let needed = ["/usr/bin/rustc", "/usr/bin/cargo", "/usr/lib/rustlib/src/rust/library/core"];
    needed.iter().all(|path| Path::new(path).exists())
}

pub fn has_program(name: &str) -> bool {
    let path = env::var_os("PATH").unwrap_or_default();
    env::split_paths(&path).any(|folder| folder.join(name).is_file())
}

/// A program of the toolchain that the user has, whatever cargo has set for its children.
fn own(program: &str) -> Command {
    let mut command = Command::new(program);
    ["RUSTC", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS"].iter().for_each(|name| {
        command.env_remove(name);
    });
    command
}

fn output(command: &mut Command) -> Result<String, String> {
    let result = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if result.status.success() {
        Ok(String::from_utf8_lossy(&result.stdout).into_owned())
    } else {
        Err(format!("{command:?} failed:\n{}", String::from_utf8_lossy(&result.stderr)))
    }
}

/// `rustc 1.95.0 (59807616e 2026-04-14)`, and who packed it if that isn't rustup.
fn version(command: &mut Command) -> Result<String, String> {
    let text = output(command)?;
    Ok(text.lines().next().unwrap_or("rustc of unknown version").to_owned())
}

fn cache() -> PathBuf {
    let home = || env::var_os("HOME").map(|home| PathBuf::from(home).join(".cache"));
    env::var_os("XDG_CACHE_HOME")
        .map(PathBuf::from)
        .or_else(home)
        .unwrap_or_else(|| root().join("target"))
        .join("scancsg")
}

/// The core library for a target, built from Debian's sources unless that was done before.
fn libraries(rustc: &Path, cargo: &Path, target: &str, version: &str) -> Result<PathBuf, String> {
    let name: String = version
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() || c == '.' { c } else { '-' })
        .collect();
    let sysroot = cache().join(name);
    let place = sysroot.join("lib/rustlib").join(target);
    let is_built = || place.join("lib").is_dir();
    if is_built() {
        return Ok(sysroot);
    }
    let text = |error: std::io::Error| format!("{}: {error}", sysroot.display());
    // One builds it. Whoever waits for that finds it built.
    fs::create_dir_all(&sysroot).map_err(text)?;
    let lock = fs::File::create(sysroot.join(format!("lock-{target}"))).map_err(text)?;
    lock.lock().map_err(text)?;
    if is_built() {
        return Ok(sysroot);
    }
    eprintln!("building the core library for {target}, once ...");
    // A page needs an allocator, and what else there is without a system.
    let crates = if target == WEB { "std,panic_abort" } else { "core,compiler_builtins" };
    let work = sysroot.join(format!("build-{target}-{}", std::process::id()));
    let source = work.join("src");
    fs::create_dir_all(&source).map_err(text)?;
    fs::write(
        work.join("Cargo.toml"),
        "[package]\nname = \"nothing\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\
         [profile.release]\ncodegen-units = 1\n[workspace]\n",
    )
    .map_err(text)?;
    fs::write(source.join("lib.rs"), "#![no_std]\n").map_err(text)?;
    let mut build = Command::new(cargo);
    build
        .current_dir(&work)
        .args(["build", "--quiet", "--release", "--target", target])
        .arg(format!("-Zbuild-std={crates}"))
        .arg("-Zbuild-std-features=compiler-builtins-mem")
        .env("RUSTC", rustc)
        .env("RUSTC_BOOTSTRAP", "1")
        // Link-time optimization needs it.
        .env("RUSTFLAGS", "-Cembed-bitcode=yes")
        .env("CARGO_TARGET_DIR", work.join("target"))
        .env_remove("RUSTUP_TOOLCHAIN")
        .env_remove("CARGO_ENCODED_RUSTFLAGS");
    output(&mut build)?;
    let built = work.join("target").join(target).join("release/deps");
    let ready = work.join("lib");
    fs::create_dir_all(&ready).map_err(text)?;
    for entry in fs::read_dir(built).map_err(text)? {
        let path = entry.map_err(text)?.path();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
        if let Some(name) = name.filter(|name| name.ends_with(".rlib") && !name.contains("nothing"))
        {
            fs::copy(&path, ready.join(name)).map_err(text)?;
        }
    }
    fs::create_dir_all(&place).map_err(text)?;
    // At once, so that nobody finds half of it.
    fs::rename(&ready, place.join("lib")).map_err(text)?;
    fs::remove_dir_all(&work).map_err(text)?;
    Ok(sysroot)
}

impl Toolchain {
    /// Builds an example as firmware, with features of the crate.
    pub fn build(
        &self,
        board: Board,
        number: Number,
        example: &str,
        features: &[&str],
    ) -> Result<PathBuf, String> {
        self.build_with(board, number, example, features, &[])
    }

    /// The same at a level of optimisation.
    pub fn build_at(
        &self,
        level: Level,
        board: Board,
        number: Number,
        example: &str,
        features: &[&str],
    ) -> Result<PathBuf, String> {
        let level = ("CARGO_PROFILE_FIRMWARE_OPT_LEVEL", Path::new(level.name()));
        self.build_with(board, number, example, features, &[level])
    }

    /// The same, with variables of the environment.
    pub fn build_with(
        &self,
        board: Board,
        number: Number,
        example: &str,
        features: &[&str],
        environment: &[(&str, &Path)],
    ) -> Result<PathBuf, String> {
        let target = board.target();
        let folder = root().join("target/boards").join(number.name());
        let mut command = self.cargo(target, &format!("--cfg number=\"{number}\""));
        command
            .args(["build", "--quiet", "--profile", PROFILE])
            .args(["--package", "examples", "--example", example])
            .args(["--features", &features.join(",")])
            .envs(environment.iter().copied())
            .env("CARGO_TARGET_DIR", &folder);
        output(&mut command)?;
        Ok(folder.join(target).join(PROFILE).join("examples").join(example))
    }

    /// Builds the page's module.
    pub fn build_web(&self) -> Result<PathBuf, String> {
        let folder = root().join("target/web");
        let mut command = self.cargo(WEB, "-Cstrip=symbols");
        command
            .args(["rustc", "--quiet", "--profile", PROFILE, "--package", "scancsg-web"])
            .args(["--lib", "--crate-type", "cdylib"])
            .env("CARGO_TARGET_DIR", &folder);
        output(&mut command)?;
        Ok(folder.join(WEB).join(PROFILE).join("scancsg_web.wasm"))
    }

    /// Builds the library for programs in C, with features of its package.
    pub fn build_library(&self, target: &str, features: &str) -> Result<PathBuf, String> {
        let folder = root().join("target/c");
        let mut command = self.cargo(target, "");
        command
            .args(["rustc", "--quiet", "--profile", PROFILE, "--package", "scancsg-capi"])
            .args(["--lib", "--crate-type", "staticlib", "--features", features])
            .env("CARGO_TARGET_DIR", &folder);
        output(&mut command)?;
        Ok(folder.join(target).join(PROFILE).join("libscancsg_capi.a"))
    }

    /// Builds the firmware of a package that is a workspace of its own. The folder that it is in.
    pub fn build_package(
        &self,
        package: &Path,
        target: &str,
        arguments: &[&str],
    ) -> Result<PathBuf, String> {
        // One folder for all: crates that several of them need are compiled once.
        let folder = root().join("target/boards/hals");
        let mut command = self.cargo(target, "");
        command
            .current_dir(package)
            .args(["build", "--quiet", "--release"])
            .args(arguments)
            .env("CARGO_TARGET_DIR", &folder);
        output(&mut command)?;
        Ok(folder.join(target).join("release"))
    }

    /// A command of cargo's that uses this compiler, with flags besides.
    fn cargo(&self, target: &str, flags: &str) -> Command {
        let mut flags = flags.to_owned();
        let mut command = own(&self.cargo.to_string_lossy());
        if let Some((rustc, sysroot)) = &self.foreign {
            flags.push_str(&format!(" --sysroot={}", sysroot.display()));
            command.env("RUSTC", rustc).env_remove("RUSTUP_TOOLCHAIN");
        }
        let variable = target.to_ascii_uppercase().replace(['-', '.'], "_");
        command
            .current_dir(root())
            .env(format!("CARGO_TARGET_{variable}_RUSTFLAGS"), flags)
            .env("CARGO_BUILD_TARGET", target)
            // Its pieces would be other programs, of other sizes and counts.
            .env("CARGO_INCREMENTAL", "0");
        command
    }
}
