//! Numbers of programs: `f32`, or 32 bits of which 16 are fraction.

use scancsg::scalar::{I16F16, Number as _, Scalar};
use std::fmt;

/// The number type of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NumberType {
    /// Single precision: for processors that have it in hardware.
    #[default]
    F32,
    /// 32 bits of which 16 are fraction: for the others.
    I16F16,
}

impl NumberType {
    /// All number types.
    pub const ALL: [Self; 2] = [Self::F32, Self::I16F16];

    /// The name, as the command line and `cargo xtask` have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::I16F16 => "i16f16",
        }
    }

    /// The type with a code.
    #[must_use]
    pub fn of_code(code: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|number| number.code() == code)
    }

    /// The largest coordinate that a solid may have.
    #[must_use]
    pub fn most(self) -> f64 {
        match self {
            Self::F32 => f32::MAX_COORDINATE.to_f64(),
            Self::I16F16 => I16F16::MAX_COORDINATE.to_f64(),
        }
    }

    /// The code in a program's header, and of devices.
    #[must_use]
    pub fn code(self) -> u8 {
        match self {
            Self::F32 => 32,
            Self::I16F16 => 16,
        }
    }
}

impl fmt::Display for NumberType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
