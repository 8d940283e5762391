//! The emulator's console and end, through semihosting. (A core without a debugger would stop here.)

/// Writes text to the console.
pub fn say(text: &str) {
    write(text.as_bytes());
}

/// Writes a number in decimal, without `core::fmt`.
pub fn say_number(number: u32) {
    let mut digits = [0; 10];
    let mut rest = number;
    let mut first = digits.len();
    for (place, digit) in digits.iter_mut().enumerate().rev() {
        *digit = b'0' + (rest % 10) as u8;
        rest /= 10;
        first = place;
        if rest == 0 {
            break;
        }
    }
    write(digits.get(first..).unwrap_or_default());
}

fn write(bytes: &[u8]) {
    use semihosting::io::Write;
    if let Ok(mut console) = semihosting::io::stderr() {
        let _ = console.write_all(bytes);
    }
}

/// Ends the program, and with it the emulator. On a board of yours it returns, to begin anew.
pub fn finish(is_good: bool) {
    semihosting::process::exit(i32::from(!is_good))
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    say("panic\n");
    semihosting::process::exit(101)
}
