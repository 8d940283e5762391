//! Inverses of 3 × 3 matrices with more digits than their entries have, for constants and for generic code.

use super::const_ops::ConstOps;
use super::fixed::{FixedI32, Fraction, Wide};
use super::scalar::{Inverse, Matrix, Scalar};
use crate::numeric::Double;

/// The rows and columns that a cofactor is made of.
const OTHERS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

/// For every entry of a matrix, in constants.
macro_rules! each_entry {
    ($i:ident, $j:ident => $body:expr) => {{
        let mut $i = 0;
        while $i < 3 {
            let mut $j = 0;
            while $j < 3 {
                $body;
                $j += 1;
            }
            $i += 1;
        }
    }};
}

macro_rules! floats {
    ($($Float:ident),+) => {$(
        impl ConstOps<$Float> {
            pub(crate) const fn wide(x: $Float) -> $Float {
                x
            }

            /// [`Scalar::inverted`].
            #[allow(clippy::indexing_slicing)] // constants have no iterators
            pub(crate) const fn inverted(matrix: Matrix<$Float>) -> Option<Inverse<$Float>> {
                let mut exact = [[0.0; 3]; 3];
                each_entry!(i, j => exact[i][j] = matrix[i][j] as f64);
                let most = <$Float>::MAX_COORDINATE as f64;
                let Some(exact) = inverted(exact, most) else { return None };
                let mut inverse = [[[0.0; 3]; 3]; 2];
                each_entry!(i, j => {
                    let Double { high, low } = exact[i][j];
                    inverse[0][i][j] = high as $Float;
                    inverse[1][i][j] = ((high - inverse[0][i][j] as f64) + low) as $Float;
                });
                Some(inverse)
            }
        }
    )+};
}

floats!(f32, f64);

/// Cramer's rule in twice the precision of `f64`, for finite entries up to `most`; `None` also where rounding
/// hides whether there is an inverse.
#[allow(clippy::indexing_slicing)]
pub(super) const fn inverted(m: Matrix<f64>, most: f64) -> Option<Matrix<Double<f64>>> {
    type Words = Double<f64>;
    /// Rounding errors of a determinant, of the size of its terms: a few 2⁻¹⁰⁶.
    const ROUNDING: f64 = 1.0 / (1u128 << 100) as f64;
    let zero = Words::exactly(0.0);
    let (mut cofactors, mut determinant, mut size) = ([[zero; 3]; 3], zero, 0.0);
    each_entry!(i, j => {
        if m[i][j].abs() > most {
            return None;
        }
        let ([i0, i1], [j0, j1]) = (OTHERS[i], OTHERS[j]);
        let one = Words::exactly(m[i0][j0]).mul(Words::exactly(m[i1][j1]));
        let other = Words::exactly(m[i0][j1]).mul(Words::exactly(m[i1][j0]));
        cofactors[i][j] = one.sub(other);
        if i == 0 {
            determinant = determinant.add(cofactors[i][j].mul(Words::exactly(m[i][j])));
            size += m[i][j].abs() * (one.high.abs() + other.high.abs());
        }
    });
    if determinant.high.abs() <= size * ROUNDING {
        return None;
    }
    let mut inverse = [[zero; 3]; 3];
    each_entry!(i, j => {
        inverse[j][i] = cofactors[i][j].div(determinant);
        if inverse[j][i].high.abs() > most {
            return None;
        }
    });
    Some(inverse)
}

impl<F: Fraction> ConstOps<FixedI32<F>> {
    pub(crate) const fn wide(x: FixedI32<F>) -> Wide {
        Wide::from_bits((x.to_bits() as i64) << (Wide::FRACTION_BITS - F::BITS))
    }

    /// [`Scalar::inverted`]: Cramer's rule in integers of 128 bits.
    #[allow(clippy::indexing_slicing)]
    pub(crate) const fn inverted(matrix: Matrix<Wide>) -> Option<Inverse<Wide>> {
        /// Bits of the largest entry of a column: cofactors have 81 then, and the determinant 123.
        const BITS: i32 = 40;
        /// 4096.
        const LARGEST: u64 = 1 << (Wide::FRACTION_BITS + 12);
        // The longest direction times an entry has to fit.
        let most = if F::BITS < 16 { LARGEST >> (16 - F::BITS) } else { LARGEST };

        let (mut m, mut shifts) = ([[0i128; 3]; 3], [0; 3]);
        let mut j = 0;
        while j < 3 {
            let column = [matrix[0][j].to_bits(), matrix[1][j].to_bits(), matrix[2][j].to_bits()];
            let (mut all, mut i) = (0, 0);
            while i < 3 {
                if column[i].unsigned_abs() > LARGEST {
                    return None;
                }
                all |= column[i].unsigned_abs();
                i += 1;
            }
            shifts[j] = BITS - length(all as u128);
            i = 0;
            while i < 3 {
                m[i][j] = shifted(column[i] as i128, shifts[j]);
                i += 1;
            }
            j += 1;
        }

        let (mut cofactors, mut determinant) = ([[0i128; 3]; 3], 0);
        each_entry!(i, j => {
            let ([i0, i1], [j0, j1]) = (OTHERS[i], OTHERS[j]);
            cofactors[i][j] = m[i0][j0] * m[i1][j1] - m[i0][j1] * m[i1][j0];
            if i == 0 {
                determinant += m[i][j] * cofactors[i][j];
            }
        });
        if determinant == 0 {
            return None;
        }
        // Its first 62 bits divide numerators of 126.
        let spare = beyond(length(determinant.unsigned_abs()), 62);
        let divisor = shifted(determinant, -spare);
        let mut inverse = [[Wide::from_bits(0); 3]; 3];
        each_entry!(i, j => {
            let numerator = cofactors[i][j];
            let raised = 126 - length(numerator.unsigned_abs());
            let quotient = shifted(numerator, raised) / divisor;
            let exponent = 64 + shifts[j] - raised - spare;
            if length(quotient.unsigned_abs()) + exponent > 63 {
                return None;
            }
            let bits = shifted(quotient, exponent) as i64;
            if bits.unsigned_abs() > most {
                return None;
            }
            inverse[j][i] = Wide::from_bits(bits);
        });
        Some([inverse, [[Wide::from_bits(0); 3]; 3]])
    }
}

/// The number of bits.
const fn length(value: u128) -> i32 {
    (u128::BITS - value.leading_zeros()) as i32
}

const fn beyond(bits: i32, limit: i32) -> i32 {
    if bits > limit { bits - limit } else { 0 }
}

/// `value · 2^left`, rounded to nearest.
const fn shifted(value: i128, left: i32) -> i128 {
    match left {
        0.. => value << left,
        -126..0 => ((value >> (-1 - left)) + 1) >> 1,
        _ => 0,
    }
}
