//! What number types round to: for solids that are computed in double precision when they are made, also in
//! constants.

/// The numbers of a type among those of double precision.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Grid {
    /// `f32`.
    Single,
    /// `f64`.
    Double,
    /// Fixed point with so many bits behind the point.
    Fixed(u32),
}

impl Grid {
    /// The nearest coordinate of a direction.
    pub(crate) const fn unit(self, x: f64) -> f64 {
        match self {
            Self::Single => x as f32 as f64,
            Self::Double => x,
            Self::Fixed(_) => nearest(x, 28),
        }
    }

    /// The nearest length.
    pub(crate) const fn length(self, x: f64) -> f64 {
        match self {
            Self::Single => x as f32 as f64,
            Self::Double => x,
            Self::Fixed(bits) => nearest(x, bits),
        }
    }

    /// By how many radians rounding may turn a direction, with room for the sums that it is computed from.
    pub(crate) const fn turn(self) -> f64 {
        match self {
            Self::Single => 2.5e-7,
            Self::Double => 2e-15,
            Self::Fixed(_) => 1.5e-8,
        }
    }

    /// The distance of neighbouring lengths where it is the same everywhere, or 0.
    pub(crate) const fn quantum(self) -> f64 {
        match self {
            Self::Single | Self::Double => 0.0,
            Self::Fixed(bits) => 1.0 / (1u64 << bits) as f64,
        }
    }

    /// [`MAX_COORDINATE`](super::Scalar::MAX_COORDINATE).
    pub(crate) const fn reach(self) -> f64 {
        match self {
            Self::Single => 1e15,
            Self::Double => 1e60,
            Self::Fixed(_) => (1u64 << 28) as f64 * self.quantum(),
        }
    }
}

/// The multiple of 2^−bits nearest to a number.
const fn nearest(x: f64, bits: u32) -> f64 {
    nearest_units(x, bits) as f64 / (1u64 << bits) as f64
}

/// The same in units of 2^−bits, halves away from zero; held inside the range.
pub(super) const fn nearest_units(x: f64, bits: u32) -> i64 {
    let scaled = x * (1u64 << bits) as f64;
    (if scaled < 0.0 { scaled - 0.5 } else { scaled + 0.5 }) as i64
}

#[cfg(test)]
mod tests {
    use super::Grid;
    use crate::scalar::{I16F16, Number, Scalar};

    #[test]
    fn reaches_as_far_as_the_type() {
        assert_eq!(f32::GRID.reach() as f32, f32::MAX_COORDINATE);
        assert_eq!(f64::GRID.reach(), f64::MAX_COORDINATE);
        assert_eq!(I16F16::GRID.reach(), I16F16::MAX_COORDINATE.to_f64());
    }

    #[test]
    fn rounds_as_the_type_does() {
        for x in [0.0, 0.1, -0.1, 1.0 / 3.0, -2.7, 0.5, 0.25 + 1e-9, -0.999_999_99] {
            assert_eq!(f32::GRID.length(x), f32::from_f64(x).to_f64());
            assert_eq!(I16F16::GRID.length(x), I16F16::from_f64(x).to_f64());
            assert_eq!(I16F16::GRID.unit(x), <I16F16 as Scalar>::Unit::from_f64(x).to_f64());
            assert_eq!(Grid::Double.unit(x), x);
        }
    }
}
