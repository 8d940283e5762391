//! What a sender does next, apart from buffers and pixels: this code exists once.

use heapless::Vec;

use super::crc::FrameHash;
use super::error::EncodeError;
use super::wire::{FrameHeader, Part, Request, encode_end, encode_header};

/// How long a [`Sender`](super::Sender) waits for answers.
///
/// A tick is what the caller counts: a millisecond of a timer, or a look at the line that found nothing
/// ([`serve`](super::serve)).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Patience {
    /// The longest time without an answer until the frame's end is sent again. The sender begins with
    /// a short one: some times what the other end took to answer before.
    pub ticks: u32,
    /// After so many times [`ticks`](Self::ticks) without an answer, the frame counts as unheard. 0 is for
    /// lines without a way back: a frame is over with its end.
    pub silences: u16,
}

/// How a frame ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Delivery {
    /// The other end has the whole frame.
    Acknowledged {
        /// How many things it has asked for again.
        repairs: u16,
    },
    /// The other end said nothing for as long as there was [`Patience`]: nobody is there, or can't answer.
    Unheard,
}

/// The fewest bytes of contents that a packet of several rows is limited to.
const MIN_LIMIT: u8 = 31;
/// The most.
pub(super) const MAX_LIMIT: u8 = 254;
/// So many ranges of rows can wait to be sent again. What doesn't fit is asked for once more.
const REPAIRS: usize = 8;

/// Rows that go into one packet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Open {
    pub(super) y: u16,
    pub(super) count: u8,
    pub(super) is_repair: bool,
}

/// Rows that were asked for again.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Repair {
    next: u16,
    end: u16,
    limit: u8,
}

/// A frame under way: how far it is, what was asked for again, and how long to wait.
#[derive(Debug)]
pub(super) struct Schedule {
    patience: Patience,
    pub(super) header: Option<FrameHeader>,
    /// So many bytes of the packet buffer wait to be written.
    pub(super) ready: usize,
    pub(super) open: Option<Open>,
    /// The next row of the sweep; as many have been sent and hashed.
    next: u16,
    /// So many of them are on the line, and not only in a packet.
    written: u16,
    hash: FrameHash,
    /// The last one is served first.
    repairs: Vec<Repair, REPAIRS>,
    header_due: bool,
    end_due: bool,
    /// The packet that waits to be written is the frame's end.
    is_end: bool,
    /// When the end was sent.
    since: u32,
    /// The first answer to a frame's first end shows what the other end takes. Those behind it came with
    /// it, or answer an earlier end.
    is_timed: bool,
    has_ended: bool,
    /// Ticks without an answer before that.
    silent: u64,
    tries: u8,
    /// What the other end takes to answer, if it has.
    round_trip: Option<u32>,
    /// The most contents of a packet of several rows. Errors make it smaller, frames larger.
    limit: u8,
    asked: u16,
    delivery: Option<Delivery>,
    pub(super) bytes_sent: u64,
}

impl Open {
    /// Whether row `y` can be in the same packet.
    pub(super) fn is_followed_by(self, y: u16, is_repair: bool) -> bool {
        self.is_repair == is_repair
            && self.count < u8::MAX
            && self.y.checked_add(self.count.into()) == Some(y)
    }
}

/// What is next.
pub(super) enum Wanted {
    Packet,
    Row(u16),
    Silence(u32),
    Nothing(Delivery),
}

/// A row that is wanted.
pub(super) struct Target {
    pub(super) header: FrameHeader,
    pub(super) is_repair: bool,
    pub(super) limit: u8,
}

impl Schedule {
    pub(super) const fn new(patience: Patience) -> Self {
        Self {
            patience,
            header: None,
            ready: 0,
            open: None,
            next: 0,
            written: 0,
            hash: FrameHash::new(),
            repairs: Vec::new(),
            header_due: false,
            end_due: false,
            is_end: false,
            since: 0,
            is_timed: false,
            has_ended: false,
            silent: 0,
            tries: 0,
            round_trip: None,
            limit: MAX_LIMIT,
            asked: 0,
            delivery: None,
            bytes_sent: 0,
        }
    }

    #[inline(never)]
    pub(super) fn begin(&mut self, header: FrameHeader) {
        let Self { patience, round_trip, limit, bytes_sent, .. } = *self;
        *self = Self {
            header: Some(header),
            header_due: true,
            round_trip,
            limit: limit.saturating_mul(2).min(MAX_LIMIT),
            bytes_sent,
            ..Self::new(patience)
        };
    }

    fn is_swept(&self) -> bool {
        self.header.is_none_or(|header| self.next >= header.height)
    }

    /// Whether the rows that have been coded are to be sent before anything else.
    pub(super) fn is_packet_full(&self) -> bool {
        let is_repairing = !self.repairs.is_empty();
        self.open.is_some_and(|open| {
            self.header_due || open.is_repair != is_repairing || !is_repairing && self.is_swept()
        })
    }

    /// The rows that have been coded, which are no longer open.
    pub(super) fn close(&mut self) -> Option<(FrameHeader, Open)> {
        Some((self.header?, self.open.take()?))
    }

    #[inline(never)]
    pub(super) fn poll(&mut self, packet: &mut [u8], now: u32) -> Wanted {
        let Some(header) = self.header else { return Wanted::Nothing(Delivery::Unheard) };
        if self.ready > 0 {
            return Wanted::Packet;
        }
        if let Some(delivery) = self.delivery {
            return Wanted::Nothing(delivery);
        }
        if self.header_due {
            self.header_due = false;
            // Cannot fail: the header has pixels, and the buffer is large enough for a control packet.
            self.ready = encode_header(header, packet).unwrap_or_default();
            return Wanted::Packet;
        }
        if let Some(repair) = self.repairs.last() {
            return Wanted::Row(repair.next);
        }
        if self.next < header.height {
            return Wanted::Row(self.next);
        }
        let wait = self.wait();
        let waited = now.wrapping_sub(self.since);
        if !self.end_due && waited < wait {
            return Wanted::Silence(wait - waited);
        }
        if !self.end_due {
            self.silent += u64::from(waited);
            self.tries = self.tries.saturating_add(1);
        }
        let most = u64::from(self.patience.ticks) * u64::from(self.patience.silences);
        if self.silent >= most && !self.end_due {
            self.delivery = Some(Delivery::Unheard);
            return Wanted::Nothing(Delivery::Unheard);
        }
        (self.end_due, self.is_end) = (false, true);
        self.ready = encode_end(header.frame, self.hash, packet).unwrap_or_default();
        Wanted::Packet
    }

    /// How long to wait for an answer: some times what it took before, and longer each time.
    fn wait(&self) -> u32 {
        let most = self.patience.ticks;
        let first = self.round_trip.map_or(most, |ticks| ticks.saturating_mul(4).saturating_add(2));
        first.saturating_mul(1 << self.tries.min(4)).min(most)
    }

    pub(super) fn sent(&mut self, now: u32) {
        self.bytes_sent = self.bytes_sent.wrapping_add(self.ready as u64);
        self.ready = 0;
        let open = self.open.filter(|open| !open.is_repair);
        self.written = open.map_or(self.next, |open| open.y);
        if core::mem::take(&mut self.is_end) {
            self.since = now;
            self.is_timed = !core::mem::replace(&mut self.has_ended, true);
            if self.patience.silences == 0 {
                self.delivery = Some(Delivery::Unheard);
            }
        }
    }

    /// What row `y` is wanted for.
    #[inline(never)]
    pub(super) fn target(&self, y: u16) -> Result<Target, EncodeError> {
        let header = self.header.ok_or(EncodeError::NoFrame)?;
        let (wanted, is_repair, limit) = match self.repairs.last() {
            Some(repair) => (repair.next, true, repair.limit.max(MIN_LIMIT).min(self.limit)),
            None => (self.next, false, self.limit),
        };
        if self.ready > 0 || y != wanted || y >= header.height {
            return Err(EncodeError::Order);
        }
        Ok(Target { header, is_repair, limit })
    }

    /// The row that was wanted is in a packet.
    pub(super) fn row_taken(&mut self, is_repair: bool, hash: impl FnOnce() -> u32) {
        if !is_repair {
            // The sum of the hashes is right only if every row is in it once.
            self.hash.add(hash());
            self.next += 1;
            self.end_due = self.is_swept();
        } else if let Some(repair) = self.repairs.last_mut() {
            repair.next += 1;
            if repair.next >= repair.end {
                self.repairs.pop();
                self.end_due = self.is_swept();
            }
        }
    }

    /// The other end is there.
    fn heard(&mut self, now: u32) {
        if self.is_swept() && !self.end_due {
            if core::mem::take(&mut self.is_timed) {
                let ticks = now.wrapping_sub(self.since);
                // Waiting too long costs little; a request from before the end must not make it short.
                let before = self.round_trip.unwrap_or(ticks);
                self.round_trip = Some(ticks.max(before.midpoint(ticks)));
            }
            self.since = now;
        }
        (self.silent, self.tries) = (0, 0);
    }

    #[inline(never)]
    pub(super) fn acknowledge(&mut self, frame: u16, now: u32) {
        // Before the end, it is late and of another frame with this number.
        if self.header.is_some_and(|header| header.frame == frame) && self.has_ended {
            self.heard(now);
            self.repairs.clear();
            self.delivery = Some(Delivery::Acknowledged { repairs: self.asked });
        }
    }

    /// The header is to be sent again.
    fn header_due(&mut self) {
        self.header_due = true;
        self.end_due = self.is_swept();
    }

    #[inline(never)]
    pub(super) fn ask(&mut self, request: Request, now: u32) {
        let Some(header) = self.header.filter(|header| header.frame == request.frame) else {
            return;
        };
        self.heard(now);
        self.asked = self.asked.saturating_add(1);
        match request.part {
            // Who asks for rows that the frame doesn't have has the header of another one with this number.
            Part::Rows { y, .. } if y >= header.height => self.header_due(),
            Part::Header => self.header_due(),
            Part::End => self.end_due = self.is_swept(),
            Part::Rows { y, count, limit } => {
                // Rows that are still to come are not lost.
                let end = y.saturating_add(count).min(self.written);
                if y >= end {
                    return;
                }
                self.limit = limit.max(MIN_LIMIT).min(self.limit);
                let repair = Repair { next: y, end, limit };
                if !self.repairs.iter().any(|other| other.end == end) {
                    // If there is no place, it is asked for once more.
                    let _ = self.repairs.push(repair);
                }
            }
        }
    }
}
