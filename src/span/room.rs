//! Compile errors about lists that are too small.

/// Checks while compiling that a list has as much room as a solid needs. The error says how much that is.
#[allow(clippy::panic)] // while compiling
pub(crate) const fn check_room(has: usize, needs: usize) {
    if has >= needs {
        return;
    }
    const START: &str = "the list of spans is too small for this solid, which needs room for ";
    // No number has more than 20 digits.
    let (mut message, mut length) = ([b' '; START.len() + 20], 0);
    while length < START.len() {
        message[length] = START.as_bytes()[length];
        length += 1;
    }
    let mut power = 1;
    while needs / power >= 10 {
        power *= 10;
    }
    while power > 0 {
        message[length] = b'0' + (needs / power % 10) as u8;
        (length, power) = (length + 1, power / 10);
    }
    match core::str::from_utf8(message.split_at(length).0) {
        Ok(message) => panic!("{}", message),
        Err(_) => panic!(),
    }
}
