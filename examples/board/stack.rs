//! How deep the stack has ever been: free memory is painted, and what is still paint was not used.

use core::ptr;

unsafe extern "C" {
    // The first free word of RAM, by the same name in cortex-m-rt and riscv-rt.
    static mut __sheap: u32;
    static mut _stack_start: u32;
}

const PAINT: u32 = 0xC5C5_5C5C;

/// Memory in bytes.
#[derive(Debug, Clone, Copy)]
pub struct Usage {
    /// The deepest that the stack has been since [`paint`].
    pub stack: usize,
    /// What the stack could use.
    pub room: usize,
}

#[inline(always)]
fn stack_pointer() -> usize {
    let pointer: usize;
    // SAFETY: reads a register.
    unsafe {
        #[cfg(target_arch = "arm")]
        core::arch::asm!("mov {0}, sp", out(reg) pointer, options(nomem, nostack));
        #[cfg(target_arch = "riscv32")]
        core::arch::asm!("mv {0}, sp", out(reg) pointer, options(nomem, nostack));
    }
    pointer
}

/// Paints what is free below the caller's frame.
#[inline(never)]
pub fn paint() {
    let end = (stack_pointer() - 64) as *mut u32;
    let mut word = &raw mut __sheap;
    while word < end {
        // SAFETY: between the end of all statics and the stack, nothing is stored.
        unsafe {
            ptr::write_volatile(word, PAINT);
            word = word.add(1);
        }
    }
}

impl Usage {
    /// Since the memory was painted.
    pub fn measure() -> Self {
        let (low, top) = (&raw const __sheap, &raw const _stack_start);
        let mut word = low;
        // SAFETY: RAM from the end of all statics to the top of the stack can be read.
        while word < top && unsafe { ptr::read_volatile(word) } == PAINT {
            // SAFETY: stays below `top`.
            word = unsafe { word.add(1) };
        }
        Self { stack: top as usize - word as usize, room: top as usize - low as usize }
    }
}
