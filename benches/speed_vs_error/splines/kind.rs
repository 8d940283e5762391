//! Number types and the units of their errors.

/// The numbers that a method is asked with, and the unit of its error.
#[derive(Clone, Copy)]
pub struct Kind {
    pub unit: &'static str,
    pub nearest: fn(f64) -> f64,
    pub largest: f64,
    /// The unit for numbers of a size.
    pub unit_of: fn(f64) -> f64,
}

pub const F32: Kind = Kind {
    unit: "ulp",
    nearest: |x| f64::from(x as f32),
    largest: 1e15,
    unit_of: |size| size.log2().floor().exp2() * f64::from(f32::EPSILON),
};

pub const GRID: Kind = Kind {
    unit: "LSB",
    nearest: |x| (x * 65536.0).round() / 65536.0,
    largest: 32_767.0,
    unit_of: |_| 1.0 / 65536.0,
};
