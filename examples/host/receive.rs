//! Receiving frames: the host's end of the link.

use super::port::{Heard, Port, READ_TIMEOUT, listen};
use scancsg::stream::{
    CONTROL_CAPACITY, Decoder, Event, FrameHeader, Packet, Part, PixelFormat, Receiver, Request,
    encode_ack, encode_request, packet_capacity,
};
use std::io::Write;
use std::time::Duration;

/// The widest picture that is received, in pixels.
pub const MAX_WIDTH: u16 = 4096;
/// The highest picture.
pub const MAX_HEIGHT: u16 = 4096;
/// A packet buffer for such pictures.
pub const CAPACITY: usize = packet_capacity(MAX_WIDTH, PixelFormat::Rgb565);

/// After this silence in the middle of a frame, what is missing is asked for.
const ASK_AFTER: Duration = Duration::from_millis(400);
/// So many times without a new row; then the frame is given up.
const ASK_TIMES: u32 = 30;

/// A frame, or what arrived of it.
pub struct Frame {
    pub header: FrameHeader,
    /// Top row first, little-endian pixels; missing rows are zero.
    pub pixels: Vec<u8>,
    /// Which rows are there.
    pub rows: Vec<bool>,
    pub ending: Ending,
}

impl Frame {
    /// What is wrong with the frame, and what is left of it.
    pub fn problem(&self, index: usize) -> Option<String> {
        let why = match self.ending {
            Ending::Complete => return None,
            Ending::Overtaken => "the next frame began before it was whole",
            Ending::Closed => "the line closed in the middle of it",
            Ending::Silent => "the sender fell silent",
        };
        let rows = self.missing().map_or_else(
            || "all rows are there, but not its end".to_string(),
            |rows| format!("what arrived is saved; missing rows: {rows}"),
        );
        Some(format!("frame {}: {why}: {rows}", index + 1))
    }

    /// The missing rows, as ranges for people: `3, 7-9`.
    fn missing(&self) -> Option<String> {
        let mut ranges: Vec<(usize, usize)> = Vec::new();
        for (y, _) in self.rows.iter().enumerate().filter(|(_, here)| !**here) {
            match ranges.last_mut() {
                Some((_, last)) if *last + 1 == y => *last = y,
                _ => ranges.push((y, y)),
            }
        }
        let texts: Vec<String> = ranges
            .into_iter()
            .map(|(first, last)| match first == last {
                true => first.to_string(),
                false => format!("{first}-{last}"),
            })
            .collect();
        (!texts.is_empty()).then(|| texts.join(", "))
    }
}

/// Why no more of a frame is to be expected.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// It is whole, and its hash is right.
    Complete,
    /// The sender began another frame.
    Overtaken,
    /// The line was closed.
    Closed,
    /// Nothing came any more, whatever was asked for.
    Silent,
}

/// What has happened on the line so far.
#[derive(Debug, Clone, Copy, Default)]
pub struct Traffic {
    /// Bytes received.
    pub bytes: u64,
    /// Packets that were damaged, or not part of their frame.
    pub bad_packets: u64,
    /// Packets sent back to ask for something again.
    pub requests: u64,
}

/// Receives frame after frame from a port.
pub struct Session {
    port: Box<dyn Port>,
    decoder: Decoder<CAPACITY>,
    buffer: Vec<u8>,
    /// The header of a frame that has begun while another was being received.
    begun: Option<FrameHeader>,
    traffic: Traffic,
}

impl Session {
    pub fn new(port: Box<dyn Port>) -> Self {
        let decoder = Decoder::new();
        Self { port, decoder, buffer: Vec::new(), begun: None, traffic: Traffic::default() }
    }

    pub fn traffic(&self) -> Traffic {
        self.traffic
    }

    /// Receives the next frame; `watch` sees it grow. `None` if the line closes before one begins,
    /// or stays silent for `patience`.
    pub fn frame(
        &mut self,
        patience: Duration,
        mut watch: impl FnMut(&Receiver<'_>, Traffic),
    ) -> Result<Option<Frame>, String> {
        let Some(header) = self.header(patience) else { return Ok(None) };
        if header.width > MAX_WIDTH || header.height > MAX_HEIGHT {
            return Err(format!(
                "a frame of {}x{} pixels is announced; {MAX_WIDTH}x{MAX_HEIGHT} is the limit",
                header.width, header.height
            ));
        }
        let mut pixels = vec![0; header.frame_bytes().unwrap_or(0)];
        let mut rows = vec![false; usize::from(header.height)];
        let mut receiver = Receiver::new(&mut pixels, &mut rows);
        receiver.accept(&Packet::Header(header)).map_err(|error| error.to_string())?;
        let ending = self.rows(header, &mut receiver, &mut watch);
        watch(&receiver, self.traffic);
        Ok(Some(Frame { header, pixels, rows, ending }))
    }

    /// Waits for the header of a frame.
    fn header(&mut self, patience: Duration) -> Option<FrameHeader> {
        if let Some(header) = self.begun.take() {
            return Some(header);
        }
        let mut silence = Duration::ZERO;
        // A frame whose header was lost: it is asked for when the line has gone quiet.
        let mut unknown = None;
        loop {
            let mut bytes = self.buffer.as_slice();
            while let Some(packet) = self.decoder.feed(&mut bytes) {
                match packet {
                    Ok(Packet::Header(header)) => {
                        self.buffer = bytes.to_vec();
                        return Some(header);
                    }
                    Ok(Packet::Row { frame, .. } | Packet::End { frame, .. }) => {
                        unknown = Some(frame);
                    }
                    Ok(_) => {}
                    Err(_) => self.traffic.bad_packets += 1,
                }
            }
            match self.hear() {
                Heard::Bytes(_) => silence = Duration::ZERO,
                Heard::Silence => silence += READ_TIMEOUT,
                Heard::Closed => return None,
            }
            if silence >= ASK_AFTER
                && let Some(frame) = unknown.take()
            {
                let request = Request { frame, part: Part::Header };
                ask(&mut *self.port, &mut self.traffic, request);
            }
            if silence >= patience {
                return None;
            }
        }
    }

    /// Receives the rows of a frame until it is complete or given up.
    fn rows(
        &mut self,
        header: FrameHeader,
        receiver: &mut Receiver<'_>,
        watch: &mut impl FnMut(&Receiver<'_>, Traffic),
    ) -> Ending {
        let mut silence = Duration::ZERO;
        let mut asked = 0;
        loop {
            let mut should_ask = false;
            let mut bytes = self.buffer.as_slice();
            while let Some(packet) = self.decoder.feed(&mut bytes) {
                let event = match packet {
                    Ok(Packet::Header(next)) if next.frame != header.frame => {
                        self.begun = Some(next);
                        self.buffer = bytes.to_vec();
                        return Ending::Overtaken;
                    }
                    Ok(packet) => receiver.accept(&packet).ok(),
                    Err(_) => None,
                };
                match event {
                    Some(Event::Complete) => {
                        let mut packet = [0; CONTROL_CAPACITY];
                        let length = encode_ack(header.frame, &mut packet).unwrap_or(0);
                        // The sender ends the frame once more if this gets lost.
                        let _ = self.port.write_all(packet.get(..length).unwrap_or_default());
                        self.buffer = bytes.to_vec();
                        return Ending::Complete;
                    }
                    Some(Event::Row { .. }) => {
                        asked = 0;
                        watch(receiver, self.traffic);
                    }
                    Some(Event::Incomplete { .. } | Event::HashMismatch) => should_ask = true,
                    Some(_) => {}
                    None => self.traffic.bad_packets += 1,
                }
            }
            match self.hear() {
                Heard::Bytes(_) => silence = Duration::ZERO,
                Heard::Silence => silence += READ_TIMEOUT,
                Heard::Closed => return Ending::Closed,
            }
            if should_ask || silence >= ASK_AFTER {
                silence = Duration::ZERO;
                asked += 1;
                if asked > ASK_TIMES {
                    return Ending::Silent;
                }
                for request in receiver.requests() {
                    ask(&mut *self.port, &mut self.traffic, request);
                }
            }
        }
    }

    /// Refills the buffer from the port.
    fn hear(&mut self) -> Heard {
        self.buffer.resize(4096, 0);
        let heard = listen(&mut *self.port, &mut self.buffer);
        let count = match heard {
            Heard::Bytes(count) => count,
            _ => 0,
        };
        self.buffer.truncate(count);
        self.traffic.bytes += count as u64;
        heard
    }
}

/// Sends a request. If it gets lost, the next silence asks again.
fn ask(port: &mut dyn Port, traffic: &mut Traffic, request: Request) {
    let mut packet = [0; CONTROL_CAPACITY];
    let length = encode_request(request, &mut packet).unwrap_or(0);
    let _ = port.write_all(packet.get(..length).unwrap_or_default());
    traffic.requests += 1;
}
