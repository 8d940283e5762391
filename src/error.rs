//! What every error type of the crate can do, written once.

/// Declares an error enum, each variant with its text: `as_str` (`const`, for messages at compile time),
/// `Display` and `core::error::Error`.
macro_rules! error_text {
    ($(#[$about:meta])* pub enum $Error:ident {
        $($(#[$when:meta])* $Variant:ident => $text:literal,)+
    }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[non_exhaustive]
        pub enum $Error {
            $($(#[$when])* $Variant,)+
        }

        impl $Error {
            /// What is wrong, in a sentence.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(Self::$Variant => $text,)+
                }
            }
        }

        impl core::fmt::Display for $Error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str(self.as_str())
            }
        }

        impl core::error::Error for $Error {}
    };
}
pub(crate) use error_text;

/// Takes the value out of a `Result` while compiling; an error becomes a compile error.
///
/// For solids that live in flash: the expression must be `const`, and its error one of this crate's.
///
/// ```
/// use scancsg::{constant, solid::Cylinder};
///
/// const SHAFT: Cylinder<f32> = constant!(Cylinder::<f32>::along_x(0.0, 0.0, 0.5, -1.0, 1.0));
/// # let _ = SHAFT;
/// ```
///
/// A radius below zero does not compile:
///
/// ```compile_fail,E0080
/// use scancsg::{constant, solid::Cylinder};
///
/// const SHAFT: Cylinder<f32> = constant!(Cylinder::<f32>::along_x(0.0, 0.0, -0.5, -1.0, 1.0));
/// # let _ = SHAFT;
/// ```
///
/// Several expressions become an array:
///
/// ```
/// use scancsg::{constant, geom::Axis, solid::Cylinder};
///
/// const STEPS: [Cylinder<f32>; 2] = constant![
///     Cylinder::<f32>::spanning(Axis::X, -1.0..0.0, [0.0, 0.0], 0.5),
///     Cylinder::<f32>::spanning(Axis::X, 0.0..1.0, [0.0, 0.0], 0.3),
/// ];
/// # let _ = STEPS;
/// ```
#[macro_export]
macro_rules! constant {
    ($result:expr, $($more:expr),+ $(,)?) => {
        [$crate::constant!($result), $($crate::constant!($more)),+]
    };
    ($result:expr $(,)?) => {
        const {
            match $result {
                Ok(value) => value,
                Err(error) => panic!("{}", error.as_str()),
            }
        }
    };
}
