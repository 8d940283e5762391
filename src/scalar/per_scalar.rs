//! Constructors for constants: written once, expanded for each kind of number type.

/// Writes an `impl` block for each kind of number type, with the type's name in place of `$S`: for
/// `const` functions, which can't be generic.
///
/// ```ignore
/// per_scalar! { $S: impl[const N: usize] Points<$S, N> { … } }
/// ```
macro_rules! per_scalar {
    ($dollar:tt $S:ident: impl[$($generics:tt)*] $($block:tt)*) => {
        macro_rules! expand {
            ([$dollar($dollar fraction:tt)*] $dollar $S:ty) => {
                impl<$dollar($dollar fraction)* $($generics)*> $($block)*
            };
        }
        expand!([] f32);
        expand!([] f64);
        expand!([F: $crate::scalar::Fraction,] $crate::scalar::FixedI32<F>);
    };
}
pub(crate) use per_scalar;
