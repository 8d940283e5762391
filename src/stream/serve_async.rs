//! The loops over a line, for `async` firmware.

use core::future::poll_fn;
use core::pin::pin;
use core::task::Poll;

use embedded_io_async::{Read, Write};

use super::assembler::Event;
use super::clock::AsyncClock;
use super::codec::RowCoding;
use super::pixel::WirePixel;
use super::receiver::Receiver;
use super::sender::{Delivery, Sender, Task};
use super::serve::{READS, header_of};
use super::serve_error::ServeError;
use super::upload::Inbox;
use crate::render::RowSource;

/// As [`serve`](super::serve), for `async` firmware: sends one frame, and renders again whatever was lost.
///
/// It yields at each packet and while it listens; a row is rendered without a pause. A read that is
/// dropped before it is done must lose nothing: those of buffered serial ports don't.
///
/// # Errors
///
/// As [`serve`](super::serve).
pub async fn serve_async<S, L, C, const N: usize>(
    source: &mut S,
    frame: u16,
    sender: &mut Sender<C, N>,
    line: &mut L,
    pixels: &mut [S::Pixel],
    clock: &mut impl AsyncClock,
) -> Result<Delivery, ServeError<L::Error>>
where
    S: RowSource<Pixel: WirePixel> + ?Sized,
    L: Read + Write + ?Sized,
    C: RowCoding<S::Pixel>,
{
    sender.begin(header_of(source, frame)).map_err(ServeError::Encode)?;
    let mut rendered = None;
    let mut ticks = 0;
    let mut is_flushed = true;
    loop {
        let mut bytes = [0; 16];
        for _ in 0..READS {
            let Some(count) = read(line, &mut bytes, clock, ticks).await? else { break };
            ticks = 0;
            let now = clock.now();
            bytes.iter().take(count).for_each(|byte| sender.receive(*byte, now));
        }
        ticks = 0;
        match sender.poll(clock.now()) {
            Task::Send(packet) => {
                write(line, packet).await?;
                sender.sent(clock.now());
                is_flushed = false;
            }
            Task::Row(y) => {
                if rendered != Some(y) {
                    source.render(y, pixels).map_err(ServeError::Render)?;
                    rendered = Some(y);
                }
                sender.row(y, pixels).map_err(ServeError::Encode)?;
            }
            Task::Listen(silence) if is_flushed => ticks = silence,
            Task::Listen(_) => {
                line.flush().await.map_err(ServeError::Write)?;
                is_flushed = true;
            }
            Task::Done(delivery) => {
                line.flush().await.map_err(ServeError::Write)?;
                return Ok(delivery);
            }
        }
    }
}

/// As [`receive`](super::receive), for `async` firmware: listens to the line until something has happened.
///
/// # Errors
///
/// [`ServeError::Write`], [`ServeError::Read`] or [`ServeError::Closed`] if the line fails.
pub async fn receive_async<L, const N: usize>(
    receiver: &mut Receiver<'_, N>,
    line: &mut L,
    clock: &mut impl AsyncClock,
) -> Result<Event, ServeError<L::Error>>
where
    L: Read + Write + ?Sized,
{
    loop {
        let mut byte = [0];
        let count = read(line, &mut byte, clock, 1).await?;
        let now = clock.now();
        let mut bytes = byte.get(..count.unwrap_or(0)).unwrap_or_default();
        let event = receiver.receive(&mut bytes, now).or_else(|| receiver.poll(now));
        let written = answer(receiver, line).await;
        if let Some(event) = event {
            return Ok(event);
        }
        written?;
    }
}

/// As [`take`](super::take), for `async` firmware: waits until an upload has come, whole and checked.
///
/// # Errors
///
/// As [`take`](super::take).
pub async fn take_async<'i, L>(
    inbox: &'i mut Inbox<'_>,
    line: &mut L,
) -> Result<&'i [u8], ServeError<L::Error>>
where
    L: Read + Write + ?Sized,
{
    loop {
        if let Some(answer) = inbox.answer() {
            write(line, answer).await?;
            line.flush().await.map_err(ServeError::Write)?;
        }
        let mut byte = [0];
        if line.read(&mut byte).await.map_err(ServeError::Read)? == 0 {
            return Err(ServeError::Closed);
        }
        if byte.into_iter().any(|byte| inbox.receive(byte)) {
            return Ok(inbox.bytes());
        }
    }
}

/// Writes the answers.
async fn answer<L: Write + ?Sized, const N: usize>(
    receiver: &mut Receiver<'_, N>,
    line: &mut L,
) -> Result<(), ServeError<L::Error>> {
    while let Some(answer) = receiver.answer() {
        write(line, answer).await?;
        line.flush().await.map_err(ServeError::Write)?;
    }
    Ok(())
}

/// Writes all of the bytes.
async fn write<L: Write + ?Sized>(
    line: &mut L,
    mut bytes: &[u8],
) -> Result<(), ServeError<L::Error>> {
    while !bytes.is_empty() {
        match line.write(bytes).await.map_err(ServeError::Write)? {
            0 => return Err(ServeError::Closed),
            count => bytes = bytes.get(count..).unwrap_or_default(),
        }
    }
    Ok(())
}

/// Reads what is there, or waits for that long until something is.
async fn read<L: Read + ?Sized>(
    line: &mut L,
    bytes: &mut [u8],
    clock: &mut impl AsyncClock,
    ticks: u32,
) -> Result<Option<usize>, ServeError<L::Error>> {
    let mut reading = pin!(line.read(bytes));
    let mut waiting = pin!(async {
        if ticks > 0 {
            clock.wait(ticks).await;
        }
    });
    let read = poll_fn(|context| match reading.as_mut().poll(context) {
        Poll::Ready(read) => Poll::Ready(Some(read)),
        Poll::Pending => waiting.as_mut().poll(context).map(|()| None),
    });
    match read.await.transpose().map_err(ServeError::Read)? {
        Some(0) => Err(ServeError::Closed),
        count => Ok(count),
    }
}
