//! The boards, and the number types that they compute in.

use clap::ValueEnum;
use std::fmt;

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Board {
    Microbit,
    Lm3s6965,
    An386,
    An505,
    Virt,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Number {
    F32,
    I16f16,
}

impl Board {
    pub const ALL: [Self; 5] =
        [Self::Microbit, Self::Lm3s6965, Self::An386, Self::An505, Self::Virt];

    /// One of each architecture, for what takes long.
    pub const SHORT: [Self; 2] = [Self::Microbit, Self::Virt];

    pub fn target(self) -> &'static str {
        match self {
            Self::Microbit => "thumbv6m-none-eabi",
            Self::Lm3s6965 => "thumbv7m-none-eabi",
            Self::An386 => "thumbv7em-none-eabihf",
            Self::An505 => "thumbv8m.main-none-eabihf",
            Self::Virt => "riscv32imac-unknown-none-elf",
        }
    }

    pub fn core(self) -> &'static str {
        match self {
            Self::Microbit => "Cortex-M0",
            Self::Lm3s6965 => "Cortex-M3",
            Self::An386 => "Cortex-M4F",
            Self::An505 => "Cortex-M33",
            Self::Virt => "RV32IMAC",
        }
    }

    /// The number type that suits it: floating point where that is in hardware.
    pub fn number(self) -> Number {
        match self {
            Self::An386 | Self::An505 => Number::F32,
            Self::Microbit | Self::Lm3s6965 | Self::Virt => Number::I16f16,
        }
    }

    /// The emulator's program and its machine.
    pub fn machine(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Microbit => ("qemu-system-arm", &["-M", "microbit"]),
            Self::Lm3s6965 => ("qemu-system-arm", &["-M", "lm3s6965evb"]),
            Self::An386 => ("qemu-system-arm", &["-M", "mps2-an386"]),
            Self::An505 => ("qemu-system-arm", &["-M", "mps2-an505"]),
            Self::Virt => ("qemu-system-riscv32", &["-M", "virt", "-bios", "none"]),
        }
    }

    /// The name in `cfg(board)`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Microbit => "microbit",
            Self::Lm3s6965 => "lm3s6965",
            Self::An386 => "an386",
            Self::An505 => "an505",
            Self::Virt => "virt",
        }
    }
}

impl fmt::Display for Board {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Number {
    pub const ALL: [Self; 2] = [Self::F32, Self::I16f16];

    /// The name in `cfg(number)`.
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::I16f16 => "i16f16",
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
