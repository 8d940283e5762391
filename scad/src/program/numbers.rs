//! Numbers of programs: `f32`, or 32 bits of which 16 are fraction.

use crate::map::Vector;
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

    /// A bound of what rounding does to corners of this size.
    pub(super) fn room(self, size: f64) -> f64 {
        size * f64::from(f32::EPSILON) * 16.0
            + match self {
                Self::F32 => 0.0,
                Self::I16F16 => 4.0 * I16F16::DELTA.to_f64(),
            }
    }

    /// The bits of the nearest number.
    fn number(self, number: f64) -> [u8; 4] {
        match self {
            Self::F32 => (number as f32 + 0.0).to_le_bytes(),
            Self::I16F16 => I16F16::from_f64(number).to_bits().to_le_bytes(),
        }
    }

    /// The bits of a coordinate of a unit vector.
    fn unit(self, number: f64) -> [u8; 4] {
        match self {
            Self::F32 => self.number(number),
            Self::I16F16 => <I16F16 as Scalar>::Unit::from_f64(number).to_bits().to_le_bytes(),
        }
    }
}

impl fmt::Display for NumberType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The bytes of a program that is written, and the largest number in them.
#[derive(Debug)]
pub(super) struct Writer {
    pub(super) number_type: NumberType,
    pub(super) bytes: Vec<u8>,
    pub(super) largest: f64,
}

impl Writer {
    pub(super) fn new(number_type: NumberType) -> Self {
        Self { number_type, bytes: Vec::new(), largest: 0.0 }
    }

    pub(super) fn number(&mut self, number: f64) {
        self.largest = self.largest.max(number.abs());
        self.bytes.extend(self.number_type.number(number));
    }

    pub(super) fn vector(&mut self, vector: Vector) {
        vector.to_array().into_iter().for_each(|part| self.number(part));
    }

    pub(super) fn unit(&mut self, vector: Vector) {
        let number_type = self.number_type;
        self.bytes.extend(vector.to_array().into_iter().flat_map(|part| number_type.unit(part)));
    }

    /// A coordinate axis, or a vector of length 1.
    pub(super) fn direction(&mut self, vector: Vector) {
        match vector.to_array().into_iter().position(|part| part == 1.0) {
            Some(axis) => self.bytes.push(axis as u8),
            None => {
                self.bytes.push(3);
                self.unit(vector);
            }
        }
    }
}
