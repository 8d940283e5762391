//! What counts the ticks of the loops over a line.

/// What counts the ticks of [`serve`](super::serve) and [`receive`](super::receive), and passes the time.
///
/// [`Looks`] needs no timer. Implement it for your timer to count milliseconds, or to sleep.
pub trait Clock {
    /// The ticks so far; they wrap around.
    fn now(&mut self) -> u32;

    /// There is nothing to do for so many ticks, unless the other end says something: waits for that long
    /// or less.
    fn idle(&mut self, ticks: u32);
}

/// A [`Clock`] that counts looks at the line that found nothing.
///
/// On a microcontroller whose `read_ready` asks a register, some ten to thirty
/// instructions pass from look to look: 500,000 looks are about a second at 16 MHz.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Looks(u32);

impl Looks {
    /// No looks so far.
    #[must_use]
    pub const fn new() -> Self {
        Self(0)
    }
}

impl Clock for Looks {
    fn now(&mut self) -> u32 {
        self.0
    }

    fn idle(&mut self, _: u32) {
        self.0 = self.0.wrapping_add(1);
    }
}

/// A [`Clock`] for `serve_async` and `receive_async`.
///
/// With embassy, `now` is `Instant::now().as_millis() as u32`, and `wait` is `Timer::after_millis`.
#[cfg(feature = "async")]
pub trait AsyncClock {
    /// The ticks so far; they wrap around.
    fn now(&mut self) -> u32;

    /// Waits for so many ticks. It is dropped when the line has something to say before.
    fn wait(&mut self, ticks: u32) -> impl Future<Output = ()>;
}
