//! The log of the feature `defmt`, through semihosting: to standard output, as the console is standard
//! error. Without the feature it is nothing.

// They hold the logger and its critical sections, which are linked by name.
#[cfg(all(feature = "defmt", target_arch = "arm"))]
use cortex_m as _;
#[cfg(feature = "defmt")]
use defmt_semihosting as _;
#[cfg(all(feature = "defmt", target_arch = "riscv32"))]
use riscv as _;

/// `log!(info, "…", …)` is `defmt::info!("…", …)`, if the feature is on.
macro_rules! log {
    ($level:ident, $format:literal $(, $argument:expr)*) => {{
        #[cfg(feature = "defmt")]
        defmt::$level!($format $(, $argument)*);
        #[cfg(not(feature = "defmt"))]
        let _ = ($(&$argument,)*);
    }};
}
pub(crate) use log;
