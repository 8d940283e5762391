//! A line that loses, damages and repeats what it carries, for tests.
//!
//! Put a [`Line`] between the two ends of your program, one for each direction, and see whether it still
//! does what it should. The same [`Faults`] and the same seed give the same faults on every machine.
//!
//! ```
//! use scancsg::render::{Gray8, Palette};
//! use scancsg::stream::faults::{Faults, Line};
//! use scancsg::stream::{
//!     Delivery, Event, FrameHeader, Memory, Patience, PixelFormat, Plain, Receiver, Sender, Task,
//!     Timing, packet_capacity,
//! };
//!
//! const CAPACITY: usize = packet_capacity(32, PixelFormat::Gray8);
//! // One byte in a hundred is damaged on the way there, one packet in five is lost on the way back.
//! let mut there = Line::<4096>::new(Faults { flipped: 0.01, ..Faults::NONE }, 1);
//! let mut back = Line::<64>::new(Faults { packets_dropped: 0.2, ..Faults::NONE }, 2);
//!
//! let mut sender = Sender::<_, CAPACITY>::new(Plain, Patience { ticks: 100, silences: 50 });
//! let (format, palette) = (PixelFormat::Gray8, Palette::EMPTY);
//! sender.begin(FrameHeader { frame: 1, width: 32, height: 24, format, palette })?;
//! let (mut pixels, mut rows) = ([0; 32 * 24], [false; 24]);
//! let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut [] };
//! let mut receiver = Receiver::<CAPACITY>::new(memory, Timing { ask: 400, give_up: 10_000 });
//!
//! let mut now = 0;
//! let delivery = loop {
//!     now += 1;
//!     match sender.poll(now) {
//!         Task::Send(packet) => {
//!             packet.iter().for_each(|byte| there.push(*byte, now));
//!             sender.sent(now);
//!         }
//!         Task::Row(y) => sender.row(y, &[Gray8(y as u8); 32])?,
//!         Task::Listen(_) => {}
//!         Task::Done(delivery) => break delivery,
//!     }
//!     while let Some(byte) = there.pop(now) {
//!         receiver.receive(&mut &[byte][..], now);
//!     }
//!     receiver.poll(now);
//!     while let Some(answer) = receiver.answer() {
//!         answer.iter().for_each(|byte| back.push(*byte, now));
//!     }
//!     while let Some(byte) = back.pop(now) {
//!         sender.receive(byte, now);
//!     }
//! };
//! assert!(matches!(delivery, Delivery::Acknowledged { repairs } if repairs > 0));
//! assert!(receiver.frame().is_complete());
//! # Ok::<(), scancsg::stream::EncodeError>(())
//! ```

mod line;
mod random;
mod rates;

pub use line::Line;
pub use rates::{Counts, Faults};
