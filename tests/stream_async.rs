//! The loops of `async` firmware, both at once over a lossy line, in simulated time.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::cell::{Cell, RefCell};
use std::future::{Future, poll_fn};
use std::pin::pin;
use std::rc::Rc;
use std::task::{Context, Poll, Waker};

use embedded_io_async::{ErrorKind, ErrorType, Read, Write};
use scancsg::render::{Gray8, RowError, RowSource, Size};
use scancsg::stream::faults::{Faults, Line};
use scancsg::stream::{
    AsyncClock, Delivery, Event, Inbox, Memory, Patience, PixelFormat, Plain, Receiver, Sender,
    ServeError, Timing, Upload, UploadTask, packet_capacity, receive_async, serve_async,
    take_async,
};

const WIDTH: u16 = 20;
const HEIGHT: u16 = 15;
const CAPACITY: usize = packet_capacity(WIDTH, PixelFormat::Gray8);
const PATIENCE: Patience = Patience { ticks: 100, silences: 50 };

/// A picture that is different in each frame.
struct Scene(u16);

impl Scene {
    fn level(frame: u16, y: u16, x: usize) -> u8 {
        (frame * 50 + y * 10 + x as u16) as u8
    }
}

impl RowSource for Scene {
    type Pixel = Gray8;

    fn size(&self) -> Size {
        Size::new(WIDTH, HEIGHT).unwrap()
    }

    fn render(&mut self, y: u16, pixels: &mut [Gray8]) -> Result<(), RowError> {
        for (x, pixel) in pixels.iter_mut().enumerate() {
            *pixel = Gray8(Scene::level(self.0, y, x));
        }
        Ok(())
    }
}

type Now = Rc<Cell<u32>>;
type Wire = Rc<RefCell<Line<4096>>>;

/// One end of a line.
struct End {
    now: Now,
    out: Wire,
    back: Wire,
    is_closed: bool,
}

impl ErrorType for End {
    type Error = ErrorKind;
}

impl Read for End {
    async fn read(&mut self, bytes: &mut [u8]) -> Result<usize, ErrorKind> {
        poll_fn(|_| {
            let mut line = self.back.borrow_mut();
            let came = std::iter::from_fn(|| line.pop(self.now.get()));
            let count = bytes.iter_mut().zip(came).map(|(to, from)| *to = from).count();
            if count == 0 && !self.is_closed { Poll::Pending } else { Poll::Ready(Ok(count)) }
        })
        .await
    }
}

impl Write for End {
    async fn write(&mut self, bytes: &[u8]) -> Result<usize, ErrorKind> {
        // A byte at a time, and a tick after each: somebody else runs then.
        self.out.borrow_mut().push(bytes[0], self.now.get());
        Ticks(self.now.clone()).wait(1).await;
        Ok(1)
    }

    async fn flush(&mut self) -> Result<(), ErrorKind> {
        Ok(())
    }
}

struct Ticks(Now);

impl AsyncClock for Ticks {
    fn now(&mut self) -> u32 {
        self.0.get()
    }

    fn wait(&mut self, ticks: u32) -> impl Future<Output = ()> {
        let (now, start) = (self.0.clone(), self.0.get());
        poll_fn(move |_| match now.get().wrapping_sub(start) >= ticks {
            true => Poll::Ready(()),
            false => Poll::Pending,
        })
    }
}

fn line(there: Faults, back: Faults) -> (Now, End, End) {
    let now = Now::default();
    let [there, back] = [(there, 1), (back, 2)]
        .map(|(faults, seed)| Rc::new(RefCell::new(Line::new(faults, seed))));
    let end = |out: &Wire, back: &Wire| End {
        now: now.clone(),
        out: out.clone(),
        back: back.clone(),
        is_closed: false,
    };
    (now.clone(), end(&there, &back), end(&back, &there))
}

/// Runs the first future to its end, and the second one as long as that takes.
fn run<T>(now: &Now, first: impl Future<Output = T>, second: impl Future<Output = ()>) -> T {
    let (mut first, mut second) = (pin!(first), pin!(second));
    let mut context = Context::from_waker(Waker::noop());
    let mut is_second_over = false;
    for _ in 0..2_000_000 {
        if let Poll::Ready(result) = first.as_mut().poll(&mut context) {
            return result;
        }
        is_second_over = is_second_over || second.as_mut().poll(&mut context).is_ready();
        now.set(now.get().wrapping_add(1));
    }
    panic!("stuck");
}

async fn receive_frames(mut end: End, now: Now, complete: &RefCell<Vec<u16>>) {
    let (mut pixels, mut rows) = ([0; 300], [false; HEIGHT as usize]);
    let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut [] };
    let timing = Timing { ask: 500, give_up: 100_000 };
    let mut receiver = Receiver::<CAPACITY>::new(memory, timing);
    loop {
        let event = receive_async(&mut receiver, &mut end, &mut Ticks(now.clone())).await.unwrap();
        if event == Event::Complete {
            let frame = receiver.frame().header().unwrap().frame;
            for y in 0..HEIGHT {
                let row = receiver.frame().row(y).unwrap().iter().enumerate();
                assert!(row.clone().all(|(x, level)| *level == Scene::level(frame, y, x)));
            }
            complete.borrow_mut().push(frame);
        }
    }
}

#[test]
fn frames_arrive_over_a_lossy_line() {
    let clean = Faults::NONE;
    let noisy = Faults {
        flipped: 0.002,
        packets_dropped: 0.1,
        packets_repeated: 0.05,
        stalls: 0.001,
        stall_ticks: 200,
        ..clean
    };
    for faults in [clean, noisy] {
        let (now, mut device, host) = line(faults, faults);
        // Over the end of the clock.
        now.set(u32::MAX - 5_000);
        let complete = RefCell::new(Vec::new());
        let sends = async {
            let mut sender = Sender::<_, CAPACITY>::new(Plain, PATIENCE);
            let mut pixels = [Gray8(0); WIDTH as usize];
            let mut clock = Ticks(now.clone());
            let mut repairs = 0;
            for frame in 0..20 {
                let mut scene = Scene(frame);
                let (line, pixels) = (&mut device, &mut pixels);
                let delivery =
                    serve_async(&mut scene, frame, &mut sender, line, pixels, &mut clock).await;
                match delivery {
                    Ok(Delivery::Acknowledged { repairs: more }) => repairs += more,
                    other => panic!("{other:?}"),
                }
            }
            // The receiver says so once its answer is written.
            clock.wait(9).await;
            repairs
        };
        let repairs = run(&now, sends, receive_frames(host, now.clone(), &complete));
        assert_eq!(repairs > 0, faults != clean);
        assert_eq!(complete.into_inner(), (0..20).collect::<Vec<_>>());
    }
}

#[test]
fn a_part_arrives_over_a_lossy_line() {
    let faults = Faults { flipped: 0.002, packets_dropped: 0.1, ..Faults::NONE };
    let (now, mut device, mut host) = line(faults, faults);
    let part: Vec<u8> = (0..500_u16).map(|i| (i / 3) as u8).collect();
    let uploads = async {
        let mut upload = Upload::new(&part, Patience { ticks: 500, silences: 50 });
        let mut clock = Ticks(now.clone());
        loop {
            match upload.poll(now.get()) {
                UploadTask::Send(packet) => {
                    for byte in packet {
                        host.write(&[*byte]).await.unwrap();
                    }
                    upload.sent(now.get());
                }
                UploadTask::Listen(_) => {
                    clock.wait(1).await;
                    while let Some(byte) = host.back.borrow_mut().pop(now.get()) {
                        upload.receive(byte, now.get());
                    }
                }
                UploadTask::Done(outcome) => panic!("nothing answers it, and it is {outcome:?}"),
            }
        }
    };
    let mut memory = [0; 600];
    let mut inbox = Inbox::new(&mut memory, 32);
    let taken = run(&now, take_async(&mut inbox, &mut device), uploads);
    assert_eq!(taken, Ok(&part[..]));
    device.is_closed = true;
    let taken = run(&now, take_async(&mut inbox, &mut device), async {});
    assert_eq!(taken, Err(ServeError::Closed));
}

#[test]
fn nobody_answers_and_the_line_is_closed() {
    let cut = Faults { cut: Some(0), ..Faults::NONE };
    let (now, mut device, _) = line(Faults::NONE, cut);
    let mut sender = Sender::<_, CAPACITY>::new(Plain, PATIENCE);
    let mut pixels = [Gray8(0); WIDTH as usize];
    let mut clock = Ticks(now.clone());
    let mut scene = Scene(0);
    let sends = serve_async(&mut scene, 0, &mut sender, &mut device, &mut pixels, &mut clock);
    assert_eq!(run(&now, sends, async {}), Ok(Delivery::Unheard));

    device.is_closed = true;
    let sends = serve_async(&mut scene, 1, &mut sender, &mut device, &mut pixels, &mut clock);
    assert_eq!(run(&now, sends, async {}), Err(ServeError::Closed));

    let (mut pixels, mut rows) = ([0; 300], [false; HEIGHT as usize]);
    let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut [] };
    let timing = Timing { ask: 500, give_up: 10_000 };
    let mut receiver = Receiver::<CAPACITY>::new(memory, timing);
    let receives = receive_async(&mut receiver, &mut device, &mut clock);
    assert_eq!(run(&now, receives, async {}), Err(ServeError::Closed));
}
