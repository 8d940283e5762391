//! A line whose bytes are recorded and passed on while they come.

use crate::host::port::{Heard, Port, write_all};
use crate::serve::Server;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use std::time::Duration;

/// So long the answer of a web page waits for room on the line.
const ANSWER_WAIT: Duration = Duration::from_millis(100);

/// A port, if there is one at the moment, and who else gets its bytes.
pub struct Tap {
    line: Option<Box<dyn Port>>,
    recording: Option<File>,
    server: Option<Server>,
    /// Why the recording could not be written.
    failure: Option<String>,
}

impl Tap {
    pub fn new(line: Box<dyn Port>, server: Option<Server>) -> Self {
        Self { line: Some(line), recording: None, server, failure: None }
    }

    /// Records all bytes from now on.
    pub fn record(&mut self, path: &Path) -> Result<(), String> {
        let file = File::create(path);
        let file = file.map_err(|error| format!("can't write {}: {error}", path.display()))?;
        self.recording = Some(file);
        Ok(())
    }

    /// The line is gone.
    pub fn disconnect(&mut self) {
        self.line = None;
    }

    /// The line is back.
    pub fn connect(&mut self, line: Box<dyn Port>) {
        self.line = Some(line);
    }

    pub fn is_connected(&self) -> bool {
        self.line.is_some()
    }

    /// Why the recording could not be written, if it could not.
    pub fn failure(&self) -> Option<&String> {
        self.failure.as_ref()
    }
}

impl Port for Tap {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        let Some(line) = &mut self.line else { return Heard::Closed };
        if let Some(server) = &self.server {
            while let Some(answer) = server.answer() {
                let _ = write_all(line, &answer, ANSWER_WAIT);
            }
        }
        let heard = line.read(buffer, wait);
        if let Heard::Bytes(count) = heard {
            let bytes = buffer.get(..count).unwrap_or_default();
            if let Some(Err(error)) = self.recording.as_mut().map(|file| file.write_all(bytes)) {
                self.failure = Some(format!("can't write the recording: {error}"));
            }
            if let Some(server) = &mut self.server {
                server.send(bytes);
            }
        }
        heard
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.line {
            Some(line) => line.write(bytes),
            None => Err(io::ErrorKind::NotConnected.into()),
        }
    }
}
