//! One direction of a line, with its faults.

use super::random::Random;
use super::rates::{Counts, Faults};
use heapless::{Deque, Vec};

/// The longest packet that can come twice.
const COPY: usize = 256;

/// One direction of a line: bytes in, bytes out, and ticks for time.
///
/// `N` is the receive buffer at its end in bytes: what comes while that is full is lost. 1 is a serial port
/// without a FIFO.
#[derive(Debug)]
pub struct Line<const N: usize> {
    faults: Faults,
    random: Random,
    counts: Counts,
    received: Deque<u8, N>,
    is_between_packets: bool,
    is_dropping: bool,
    copy: Vec<u8, COPY>,
    copying: Copying,
    burst_left: u16,
    /// When the stall began, and how long it is.
    stall: Option<(u32, u32)>,
}

/// What becomes of the packet that is to come twice.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Copying {
    Nothing,
    Recording,
    /// It comes after so many more packets.
    Waiting(u32),
}

impl<const N: usize> Line<N> {
    /// A line with nothing on it.
    #[must_use]
    pub const fn new(faults: Faults, seed: u64) -> Self {
        Self {
            faults,
            random: Random(seed),
            counts: Counts {
                bytes: 0,
                flipped: 0,
                dropped: 0,
                packets: 0,
                packets_dropped: 0,
                packets_repeated: 0,
                bursts: 0,
                stalls: 0,
                overflowed: 0,
            },
            received: Deque::new(),
            is_between_packets: true,
            is_dropping: false,
            copy: Vec::new(),
            copying: Copying::Nothing,
            burst_left: 0,
            stall: None,
        }
    }

    /// What the line has done so far.
    #[must_use]
    pub const fn counts(&self) -> &Counts {
        &self.counts
    }

    /// A byte goes in.
    pub fn push(&mut self, byte: u8, now: u32) {
        if self.faults.cut.is_some_and(|cut| self.counts.bytes >= cut) {
            return;
        }
        self.counts.bytes += 1;
        if byte != 0 && core::mem::take(&mut self.is_between_packets) {
            self.begin_packet();
        }
        if !self.is_dropping {
            self.carry(byte, now);
        }
        if self.copying == Copying::Recording && self.copy.push(byte).is_err() {
            self.copying = Copying::Nothing;
        }
        if byte == 0 && !self.is_between_packets {
            self.end_packet(now);
        }
    }

    /// A byte that has come out, if there is one.
    pub fn pop(&mut self, now: u32) -> Option<u8> {
        let is_stalled = |(since, ticks): (u32, u32)| now.wrapping_sub(since) < ticks;
        self.stall = self.stall.filter(|stall| is_stalled(*stall));
        if self.stall.is_some() { None } else { self.received.pop_front() }
    }

    fn begin_packet(&mut self) {
        self.counts.packets += 1;
        self.is_dropping = self.random.chance(self.faults.packets_dropped);
        self.counts.packets_dropped += u64::from(self.is_dropping);
        if self.copying == Copying::Nothing
            && !self.is_dropping
            && self.random.chance(self.faults.packets_repeated)
        {
            self.copy.clear();
            self.copying = Copying::Recording;
        }
    }

    fn end_packet(&mut self, now: u32) {
        self.is_between_packets = true;
        self.is_dropping = false;
        if self.copying == Copying::Recording {
            self.copying = Copying::Waiting(self.random.below(4));
        }
        match self.copying {
            Copying::Waiting(0) => {
                self.counts.packets_repeated += 1;
                self.copying = Copying::Nothing;
                let copy = core::mem::take(&mut self.copy);
                copy.iter().for_each(|byte| self.carry(*byte, now));
            }
            Copying::Waiting(packets) => self.copying = Copying::Waiting(packets - 1),
            Copying::Nothing | Copying::Recording => {}
        }
    }

    /// Brings a byte to the other end.
    fn carry(&mut self, byte: u8, now: u32) {
        let Faults { flipped, dropped, bursts, burst_bytes, stalls, stall_ticks, .. } = self.faults;
        if self.random.chance(bursts) {
            let shortest = burst_bytes / 8;
            let more = self.random.below(u32::from(burst_bytes - shortest) + 1);
            self.burst_left = shortest.saturating_add(more as u16);
            self.counts.bursts += 1;
        }
        if self.random.chance(stalls) {
            self.stall = Some((now, self.random.below(stall_ticks).saturating_add(1)));
            self.counts.stalls += 1;
        }
        let mut byte = byte;
        if self.burst_left > 0 {
            self.burst_left -= 1;
            byte = self.random.below(256) as u8;
            if self.random.chance(0.5) {
                return;
            }
        }
        if self.random.chance(dropped) {
            self.counts.dropped += 1;
            return;
        }
        if self.random.chance(flipped) {
            self.counts.flipped += 1;
            byte ^= 1 << self.random.below(8);
        }
        self.counts.overflowed += u64::from(self.received.push_back(byte).is_err());
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use std::vec;
    use std::vec::Vec;

    const COUNT: usize = 200_000;

    /// Packets of 20 bytes, none of them zero but the last.
    fn packets() -> Vec<u8> {
        (0..COUNT).map(|i| if i % 20 == 19 { 0 } else { (i % 255) as u8 + 1 }).collect()
    }

    fn carried<const N: usize>(faults: Faults, seed: u64) -> (Vec<u8>, Counts) {
        let mut line = Line::<N>::new(faults, seed);
        let mut out = vec![];
        for (now, byte) in (0..).zip(packets()) {
            line.push(byte, now);
            out.extend(core::iter::from_fn(|| line.pop(now)));
        }
        out.extend(core::iter::from_fn(|| line.pop(u32::MAX / 2)));
        (out, *line.counts())
    }

    /// Whether something happened as often as it should: five standard deviations off is never.
    #[track_caller]
    fn is_rate(happened: u64, of: u64, rate: f32) {
        let expected = of as f64 * f64::from(rate);
        let off = (happened as f64 - expected).abs();
        assert!(off <= 5.0 * (expected * (1.0 - f64::from(rate))).sqrt() + 1.0, "{happened}");
    }

    #[test]
    fn no_faults_are_the_identity() {
        for seed in 0..9 {
            let (out, counts) = carried::<1>(Faults::NONE, seed);
            assert_eq!(out, packets());
            let (bytes, packets) = (COUNT as u64, COUNT as u64 / 20);
            assert_eq!(counts, Counts { bytes, packets, ..Counts::default() });
        }
    }

    #[test]
    fn rates_are_met_and_the_bytes_show_it() {
        let all = COUNT as u64;
        for rate in [0.001, 0.01, 0.2, 1.0] {
            let (out, counts) = carried::<9>(Faults { flipped: rate, ..Faults::NONE }, 1);
            is_rate(counts.flipped, all, rate);
            let differences = out.iter().zip(packets()).map(|(a, b)| (a ^ b).count_ones());
            let (ones, total) = differences.fold((0, 0), |(ones, total), bits| {
                assert!(bits <= 1);
                (ones + u64::from(bits), total + 1)
            });
            assert_eq!((ones, total), (counts.flipped, all));

            let (out, counts) = carried::<9>(Faults { dropped: rate, ..Faults::NONE }, 2);
            is_rate(counts.dropped, all, rate);
            assert_eq!(out.len() as u64, all - counts.dropped);

            let (out, counts) = carried::<9>(Faults { packets_dropped: rate, ..Faults::NONE }, 3);
            is_rate(counts.packets_dropped, all / 20, rate);
            assert_eq!(out.len() as u64, all - 20 * counts.packets_dropped);
            assert!(out.chunks(20).all(|packet| packet.iter().position(|b| *b == 0) == Some(19)));

            let faults = Faults { bursts: rate / 100.0, burst_bytes: 64, ..Faults::NONE };
            let (out, counts) = carried::<9>(faults, 4);
            is_rate(counts.bursts, all, rate / 100.0);
            let lost = all - out.len() as u64;
            assert!(lost > counts.bursts && lost < 64 * counts.bursts, "{lost}");
        }
    }

    /// A packet comes twice, whole, and its second copy some packets later.
    #[test]
    fn packets_come_twice() {
        let faults = Faults { packets_repeated: 0.05, ..Faults::NONE };
        let (out, counts) = carried::<64>(faults, 5);
        // While one waits no other one is chosen.
        assert!((300..500).contains(&counts.packets_repeated), "{}", counts.packets_repeated);
        assert_eq!(out.len(), COUNT + 20 * counts.packets_repeated as usize);
        let mut rest = out.chunks(20);
        let (mut before, mut late, mut repeated) = (vec![], 0, 0);
        for packet in packets().chunks(20) {
            let mut came = rest.next().unwrap();
            if came != packet {
                let at = before.iter().rev().take(4).position(|old: &Vec<u8>| old == came);
                late += usize::from(at.unwrap() > 0);
                repeated += 1;
                came = rest.next().unwrap();
            }
            assert_eq!(came, packet);
            before.push(packet.to_vec());
        }
        repeated += rest.count() as u64;
        assert_eq!(repeated, counts.packets_repeated);
        assert!(late > 100, "{late}");
        // A packet that is longer than the buffer for it never does.
        let mut line = Line::<4096>::new(Faults { packets_repeated: 1.0, ..Faults::NONE }, 1);
        (0..3000).for_each(|i| line.push(u8::from(i % 300 != 299), 0));
        assert_eq!(line.counts().packets_repeated, 0);
        assert_eq!(core::iter::from_fn(|| line.pop(0)).count(), 3000);
    }

    #[test]
    fn a_stall_holds_bytes_back_and_a_full_buffer_loses_them() {
        let faults = Faults { stalls: 0.001, stall_ticks: 500, ..Faults::NONE };
        let (out, counts) = carried::<4096>(faults, 6);
        is_rate(counts.stalls, COUNT as u64, 0.001);
        assert_eq!(out, packets());
        assert_eq!(counts.overflowed, 0);
        let (out, counts) = carried::<16>(faults, 6);
        assert!(counts.overflowed > 1000);
        assert_eq!(out.len() as u64, COUNT as u64 - counts.overflowed);

        // Nobody empties it: the first bytes stay.
        let mut line = Line::<3>::new(Faults::NONE, 0);
        (1..=9).for_each(|byte| line.push(byte, 0));
        assert_eq!(line.counts().overflowed, 6);
        assert!(core::iter::from_fn(|| line.pop(0)).eq([1, 2, 3]));

        // Over the end of the clock, and for exactly as long as it says.
        let mut line = Line::<3>::new(Faults { stalls: 1.0, stall_ticks: 1, ..Faults::NONE }, 0);
        line.push(7, u32::MAX);
        assert_eq!(line.pop(u32::MAX), None);
        assert_eq!(line.pop(0), Some(7));
    }

    #[test]
    fn a_cut_is_for_good() {
        for cut in [0, 1, 777] {
            let faults = Faults { cut: Some(cut), ..Faults::NONE };
            assert_eq!(carried::<1>(faults, 1).0, packets()[..cut as usize]);
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_faults() {
        let faults = Faults {
            flipped: 0.01,
            dropped: 0.01,
            packets_dropped: 0.1,
            packets_repeated: 0.1,
            bursts: 0.001,
            burst_bytes: 512,
            stalls: 0.001,
            stall_ticks: 50,
            cut: None,
        };
        let once = carried::<64>(faults, 7);
        assert_eq!(once, carried::<64>(faults, 7));
        assert_ne!(once, carried::<64>(faults, 8));
        // On every machine, in every version: a hash of all that came out.
        let hash = once.0.iter().fold(0_u32, |hash, byte| {
            hash.rotate_left(5).wrapping_mul(31).wrapping_add(u32::from(*byte))
        });
        assert_eq!(hash, 1_202_239_159);
        // What is no share is never or always.
        for never in [-1.0, f32::NAN, f32::NEG_INFINITY] {
            let faults = Faults { dropped: never, ..Faults::NONE };
            assert_eq!(carried::<1>(faults, 1).0, packets());
        }
        for always in [1.0, 2.0, f32::INFINITY] {
            let faults = Faults { dropped: always, ..Faults::NONE };
            assert!(carried::<1>(faults, 1).0.is_empty());
        }
    }
}
