//! Instructions, counted by the emulator's clock.
//!
//! With `-icount shift=7` an instruction takes exactly 2⁷ ns of QEMU's time. SysTick counts that time in
//! the board's clock, and RISC-V's `minstret` in nanoseconds. How many ticks an instruction is, is
//! measured on a loop of known length, so no clock rate is needed.

#[cfg(target_arch = "arm")]
use core::ptr;

/// Ticks of the counter, modulo 2^24 on Arm and 2^32 on RISC-V.
#[cfg(target_arch = "arm")]
#[inline(always)]
fn ticks() -> u32 {
    // SAFETY: SYST_CVR can always be read.
    unsafe { ptr::read_volatile(0xE000_E018 as *const u32) }
}

#[cfg(target_arch = "arm")]
fn between(start: u32, end: u32) -> u32 {
    start.wrapping_sub(end) & 0xFF_FFFF
}

#[cfg(target_arch = "riscv32")]
#[inline(always)]
fn ticks() -> u32 {
    let count: u32;
    // SAFETY: reads a counter.
    unsafe { core::arch::asm!("csrr {0}, minstret", out(reg) count, options(nostack)) };
    count
}

#[cfg(target_arch = "riscv32")]
fn between(start: u32, end: u32) -> u32 {
    end.wrapping_sub(start)
}

// 2n + 1 instructions, the return included and the call not. In assembly, because a Rust function may
// have a prologue.
#[cfg(target_arch = "arm")]
core::arch::global_asm!(
    ".global known_loop",
    ".type known_loop,%function",
    ".thumb_func",
    "known_loop:",
    "1: subs r0, #1",
    "bne 1b",
    "bx lr"
);
#[cfg(target_arch = "riscv32")]
core::arch::global_asm!(
    ".global known_loop",
    ".type known_loop,@function",
    "known_loop:",
    "1: addi a0, a0, -1",
    "bnez a0, 1b",
    "ret"
);

unsafe extern "C" {
    fn known_loop(count: u32);
}

/// Nothing but the call is between the two readings: not inlined, or the optimizer moves other work
/// there.
#[inline(never)]
fn ticks_of(work: unsafe extern "C" fn(u32), argument: u32) -> u32 {
    let start = ticks();
    // SAFETY: `work` is one of this file's, or a safe function.
    unsafe { work(argument) };
    between(start, ticks())
}

/// Counts instructions.
pub struct Counter {
    /// Ticks of the shortest known loop.
    shortest: u32,
    /// Ticks of a million instructions.
    million: u32,
}

impl Counter {
    /// Starts the counter and calibrates it.
    pub fn start() -> Self {
        #[cfg(target_arch = "arm")]
        // SAFETY: SysTick's registers: the longest period, from now on, by the core's clock.
        unsafe {
            ptr::write_volatile(0xE000_E014 as *mut u32, 0xFF_FFFF);
            ptr::write_volatile(0xE000_E018 as *mut u32, 0);
            ptr::write_volatile(0xE000_E010 as *mut u32, 5);
        }
        let shortest = ticks_of(known_loop, 1);
        let million = ticks_of(known_loop, 500_001).wrapping_sub(shortest).max(1);
        Self { shortest, million }
    }

    /// The instructions of a call, its return included; up to some millions.
    pub fn instructions(&self, work: extern "C" fn(u32), argument: u32) -> u32 {
        self.counted(work, argument)
    }

    fn counted(&self, work: unsafe extern "C" fn(u32), argument: u32) -> u32 {
        let of = |ticks: u32| {
            let million = u64::from(self.million);
            ((u64::from(ticks) * 1_000_000 + million / 2) / million) as u32
        };
        // The shortest known loop is 3 instructions.
        (of(ticks_of(work, argument)) + 3).wrapping_sub(of(self.shortest))
    }

    /// The largest error on loops of known lengths: with an emulator that counts, 0 or 1.
    pub fn error(&self) -> u32 {
        [1, 2, 10, 1_000, 10_007, 100_003, 1_000_003]
            .into_iter()
            .map(|count| self.counted(known_loop, count).abs_diff(2 * count + 1))
            .max()
            .unwrap_or(0)
    }
}
