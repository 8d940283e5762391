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

    /// The packages that are missing.
    fn missing(self) -> Vec<&'static str> {
        let lacks = |target| !toolchain::is_there(target);
        let rest = match self {
            Self::Python if output(&mut command("python3 -m pip --version")).is_err() => {
                "python3-pip"
            }
            Self::Browser if lacks(toolchain::WEB) => toolchain::DEBIAN_PACKAGES,
            Self::Boards if Board::ALL.iter().any(|board| lacks(board.target())) => {
                toolchain::DEBIAN_PACKAGES
            }
            _ => "",
        };
        let programs = self.programs().iter().filter(|(program, _)| !has_program(program));
        programs.map(|(_, package)| *package).chain(rest.split_whitespace()).collect()
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
