//! What steps need besides Rust: packages of Debian's, installed where they are missing.

use super::{command, output};
use crate::board::Board;
use crate::c;
use crate::command::done;
use crate::toolchain::{self, has_program};

/// What a tool is for.
#[derive(Debug, Clone, Copy)]
pub enum Purpose {
    Scad,
    Python,
    Browser,
    /// Emulators, and compilers for the boards.
    Boards,
    /// The emulator of the Pico.
    Node,
    C,
}

impl Purpose {
    const ALL: [Self; 6] =
        [Self::Scad, Self::Python, Self::Browser, Self::Boards, Self::Node, Self::C];

    /// Programs, and the packages that they are in.
    fn programs(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::Scad => &[("openscad", "openscad")],
            Self::Python => &[],
            Self::Browser => &[("chromium", "chromium")],
            Self::Boards => &[
                ("qemu-system-arm", "qemu-system-arm"),
                ("qemu-system-riscv32", "qemu-system-misc"),
            ],
            Self::Node => &[("node", "nodejs"), ("npm", "npm")],
            Self::C => &[(c::CROSS, "gcc-arm-none-eabi")],
        }
    }

    /// Whether it is there, besides its programs.
    fn is_ready(self) -> bool {
        match self {
            Self::Python => output(&mut command("python3 -m pip --version")).is_ok(),
            Self::Browser => toolchain::is_there(toolchain::WEB),
            Self::Boards => Board::ALL.iter().all(|board| toolchain::is_there(board.target())),
            Self::Scad | Self::Node | Self::C => true,
        }
    }

    /// The packages that are missing.
    fn missing(self) -> Vec<&'static str> {
        let programs = self.programs().iter().filter(|(program, _)| !has_program(program));
        let mut packages: Vec<&str> = programs.map(|(_, package)| *package).collect();
        if !self.is_ready() {
            let rest = if matches!(self, Self::Python) {
                "python3-pip"
            } else {
                toolchain::DEBIAN_PACKAGES
            };
            packages.extend(rest.split(' '));
        }
        packages
    }
}

/// Installs what is missing.
pub fn ensure(purposes: &[Purpose]) -> Result<(), String> {
    let packages: Vec<&str> = purposes.iter().flat_map(|purpose| purpose.missing()).collect();
    if packages.is_empty() {
        return Ok(());
    }
    done(&mut command("apt-get update -q"))?;
    // Somebody else may be installing.
    let install = "apt-get install -y -q --no-install-recommends -o DPkg::Lock::Timeout=600";
    done(command(install).args(packages))
}

/// Installs all that any step needs, so that none installs while another works.
pub fn ensure_all() -> Result<(), String> {
    ensure(&Purpose::ALL)
}
