//! The `defmt` log of a firmware.

use crate::board::{Board, Number};
use crate::boot;
use crate::toolchain;
use defmt_decoder::{DecodeError, Table};

/// The feature that a firmware logs with.
pub const FEATURE: &str = "defmt";

/// The lines of a log that came through semihosting: what they say is in the firmware's ELF.
pub fn decode(elf: &[u8], bytes: &[u8]) -> Result<String, String> {
    let table = Table::parse(elf).map_err(|error| error.to_string())?;
    let Some(table) = table else { return Ok(String::from_utf8_lossy(bytes).into_owned()) };
    let mut decoder = table.new_stream_decoder();
    decoder.received(bytes);
    let mut lines = String::new();
    loop {
        match decoder.decode() {
            Ok(frame) => lines += &format!("{}\n", frame.display(false)),
            Err(DecodeError::UnexpectedEof) => return Ok(lines),
            Err(DecodeError::Malformed) => lines += "(a line that can't be decoded)\n",
        }
    }
}

/// With its log the firmware must send the same picture, and say what it does.
pub fn check(board: Board, number: Number) -> Result<(), String> {
    let elf = toolchain::find(board.target())?.build(board, number, "stream", &[FEATURE])?;
    let outcome = boot::stream(board, number, &elf)?;
    let mut problems = outcome.problems;
    let stack = outcome.stack.unwrap_or_default();
    let expected = [
        (" 160x120 pixels in ", number.name()),
        (": 120 rows, ", " repairs"),
        (&format!(" stack: {stack} of "), " bytes"),
    ];
    for (start, end) in expected {
        let is_it = |line: &str| {
            let line = line.to_ascii_lowercase();
            line.starts_with("info") && line.contains(start) && line.ends_with(end)
        };
        if !outcome.said.lines().any(is_it) {
            problems.push(format!("the log has no line of \"{start}…{end}\""));
        }
    }
    if problems.is_empty() {
        println!("{board}, {number}: the picture is the host's, and the log is\n{}", outcome.said);
        Ok(())
    } else {
        Err(format!("{board}, {number}: {}\n{}", problems.join("\n       "), outcome.said))
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn what_is_not_a_log_is_text() {
        // The smallest ELF there is: a header, and no sections.
        let mut elf = vec![0; 64];
        for (place, byte) in elf.iter_mut().zip(*b"\x7FELF\x02\x01\x01") {
            *place = byte;
        }
        for (at, byte) in [(16, 2), (18, 62), (20, 1), (52, 64), (58, 64)] {
            if let Some(place) = elf.get_mut(at) {
                *place = byte;
            }
        }
        assert_eq!(super::decode(&elf, b"plain").as_deref(), Ok("plain"));
        assert!(super::decode(b"no ELF", b"plain").is_err());
    }
}
