//! What a line does wrong, and how often it did.

/// What a [`Line`](super::Line) does to bytes and packets.
///
/// Rates are shares: 0.001 is one in a thousand, 0 never, 1 always. A packet is what a zero byte ends.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Faults {
    /// The share of bytes in which one bit is flipped.
    pub flipped: f32,
    /// The share of bytes that are lost.
    pub dropped: f32,
    /// The share of packets that are lost.
    pub packets_dropped: f32,
    /// The share of packets that come twice: the second time up to three packets later. Only those of up
    /// to 256 bytes do, and one at a time.
    pub packets_repeated: f32,
    /// The share of bytes that a burst begins at. In a burst, each byte is lost or becomes any other.
    pub bursts: f32,
    /// The length of the longest burst in bytes. The shortest is an eighth of it.
    pub burst_bytes: u16,
    /// The share of bytes that the line stalls at: what goes in waits, and then comes out all at once.
    pub stalls: f32,
    /// The length of the longest stall in ticks.
    pub stall_ticks: u32,
    /// The line is cut after so many bytes: no more come out.
    pub cut: Option<u64>,
}

impl Faults {
    /// None.
    pub const NONE: Self = Self {
        flipped: 0.0,
        dropped: 0.0,
        packets_dropped: 0.0,
        packets_repeated: 0.0,
        bursts: 0.0,
        burst_bytes: 0,
        stalls: 0.0,
        stall_ticks: 0,
        cut: None,
    };
}

/// How often a [`Line`](super::Line) did what.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counts {
    /// Bytes that went in.
    pub bytes: u64,
    /// Bytes in which a bit was flipped.
    pub flipped: u64,
    /// Bytes that were lost one by one.
    pub dropped: u64,
    /// Packets that began.
    pub packets: u64,
    /// Packets that were lost.
    pub packets_dropped: u64,
    /// Packets that came twice.
    pub packets_repeated: u64,
    /// Bursts.
    pub bursts: u64,
    /// Stalls.
    pub stalls: u64,
    /// Bytes that found the receive buffer full.
    pub overflowed: u64,
}
