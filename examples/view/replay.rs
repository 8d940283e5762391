//! A recorded line.

use crate::host::port::{Heard, Port};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::time::Duration;

/// Brings the bytes of a recording as fast as they are read; nobody hears the answers.
pub struct Replay(File);

impl Replay {
    pub fn open(path: &Path) -> Result<Self, String> {
        let file = File::open(path);
        file.map(Self).map_err(|error| format!("can't read {}: {error}", path.display()))
    }
}

impl Port for Replay {
    fn read(&mut self, buffer: &mut [u8], _: Duration) -> Heard {
        match self.0.read(buffer) {
            Ok(count @ 1..) => Heard::Bytes(count),
            _ => Heard::Closed,
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        Ok(bytes.len())
    }
}
