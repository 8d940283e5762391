//! What a firmware has logged with `defmt`, as text.

use defmt_decoder::{DecodeError, Table};

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
