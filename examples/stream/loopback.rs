//! The host: chooses what is rendered, gives it a line, and looks at what comes out.

use crate::args::{self, Args, Camera, Coding, Format, Number, Path};
use crate::coding::Chosen;
use crate::gallery::Assembly;
use crate::host::film::Film;
use crate::host::meter::Meter;
use crate::host::port::{self, Port};
use crate::host::receive::{CAPACITY, Ending, Room, Session, timing};
use crate::host::screen::Screen;
use crate::host::wire::{Trouble, Wire};
use crate::line::{Line, ONE_WAY, PATIENCE};
use crate::scene::LAP;
use crate::scene::pipe::PipeScene;
use crate::shading::Shading;
use clap::Parser;
use scancsg::geom::{OrthographicRays, PerspectiveRays, Pose, Rays};
use scancsg::render::{
    Blend, Gray8, Picture, Rgb565, Size, SmoothColumn, SmoothPicture, Smoothing,
};
use scancsg::scalar::I16F16;
use scancsg::solid::{Placed, Scan, Solid};
use scancsg::stream::{Delivery, Predictable, Sender, ServeError, Timing, WirePixel, serve};
use std::f64::consts::TAU;
use std::io;
use std::process::ExitCode;
use std::thread;
use std::time::{Duration, Instant};

/// The pipe's segments follow its curve to this part of a pixel, in pictures of up to so many rows:
/// there is room for no more segments.
const PIXEL_PART: f64 = 0.25;
const FINEST_ROWS: u16 = 480;

/// The height of what the camera sees at the pipe's nearest point, or less.
const NEAR_HEIGHT: f64 = 3.7;

/// For the pipe's segments, and their views and rows, which an unoptimised build copies about.
const SENDER_STACK: usize = 16 << 20;

/// A frame's first packet may have to be rendered for so long; a sender that fails closes the line.
const FRAME_WAIT: Duration = Duration::from_secs(120);

/// After so many frames in a row that nobody has acknowledged, no more are sent.
const UNHEARD: u32 = 3;

/// A frame is incomplete, or not acknowledged.
const INCOMPLETE: u8 = 3;

pub fn run() -> ExitCode {
    let args = Args::parse();
    let result = match &args.port {
        Some(device) => send_to_device(&args, device),
        None => loop_back(&args),
    };
    match result {
        Ok(problems) if problems.is_empty() => ExitCode::SUCCESS,
        Ok(problems) => {
            eprintln!("stream: {}", problems.join("\n        "));
            ExitCode::from(INCOMPLETE)
        }
        Err(message) => {
            eprintln!("stream: {message}");
            ExitCode::FAILURE
        }
    }
}

fn line(port: Box<dyn Port>, args: &Args) -> Line {
    let baud = args.baud.filter(|_| args.port.is_none());
    Line::new(Wire::new(port, Trouble { baud, noise: args.noise, cut_after: args.cut_after }))
}

/// What the sending side has to say when it is done.
struct Sent {
    frames: u16,
    bytes: u64,
    unheard: u32,
}

/// Sends to a real device, and waits for it to acknowledge. Returns the problems.
fn send_to_device(args: &Args, device: &str) -> Result<Vec<String>, String> {
    let port = port::open(device, args.baud.unwrap_or(115_200))?;
    let start = Instant::now();
    let sent = send(args, &line(port, args), &mut |frame| {
        eprintln!("frame {}/{} sent to {device}", frame + 1, args.frames);
    })?;
    println!(
        "{} frame(s) of {}x{}, {} bytes in {:.1} s to {device}",
        sent.frames,
        args.size.width(),
        args.size.height(),
        sent.bytes,
        start.elapsed().as_secs_f32()
    );
    let mut problems = Vec::new();
    if sent.unheard > 0 && !args.one_way {
        problems.push(format!("{} frame(s) were not acknowledged by the other end", sent.unheard));
    }
    if sent.frames < args.frames {
        problems.push(format!("gave up after {} of {} frames", sent.frames, args.frames));
    }
    Ok(problems)
}

/// Sends in a thread into one end of a line, receives at the other end, shows and saves.
fn loop_back(args: &Args) -> Result<Vec<String>, String> {
    let (near, far) = port::loopback()?;
    let start = Instant::now();
    thread::scope(|scope| {
        let sender = thread::Builder::new()
            .stack_size(SENDER_STACK)
            .spawn_scoped(scope, || send(args, &line(far, args), &mut |_| {}))
            .map_err(|error| format!("starting a thread failed: {error}"))?;
        let mut room = Room::new();
        let give_up = FRAME_WAIT.as_millis() as u32;
        let timing = Timing { give_up, ..timing(args.baud) };
        let mut session: Session<'_> = Session::new(near, &mut room, timing);
        let (mut screen, mut meter, mut film) = (Screen::new(), Meter::new(), Film::new(&args.out));
        let count = u32::from(args.frames);
        let (mut problems, mut arrived, mut raw) = (Vec::new(), 0, 0);
        while arrived < count {
            let frame = session.frame(FRAME_WAIT, |session| {
                if screen.is_due() {
                    let figures = meter.lines(session.picture(), session.traffic(), Some(count));
                    screen.draw(session.picture(), &figures);
                }
            });
            let Some(frame) = frame else { break };
            arrived += 1;
            meter.count(&frame);
            film.push(&frame)?;
            raw += frame.pixels.len();
            problems.extend(frame.problem().map(|problem| problem + "; what arrived is saved"));
            if frame.ending == Ending::Closed {
                break;
            }
        }
        let traffic = session.traffic();
        screen.draw(session.picture(), &meter.lines(session.picture(), traffic, Some(count)));
        // The sender may still be waiting for an answer.
        drop(session);
        match arrived {
            0 => problems.push("no frame arrived, and nothing was written".to_string()),
            arrived if arrived < count => {
                problems.push(format!("only {arrived} of {count} frames arrived"));
            }
            _ => {}
        }
        for file in film.files() {
            println!(
                "{}: {arrived} frame(s) of {}x{}\n{} bytes on the line for {raw} bytes of pixels, {:.2} s",
                file.display(),
                args.size.width(),
                args.size.height(),
                traffic.bytes,
                start.elapsed().as_secs_f32()
            );
        }
        if traffic.bad_packets > 0 || traffic.requests > 0 {
            println!(
                "{} damaged packet(s), {} request(s) to send something again",
                traffic.bad_packets, traffic.requests
            );
        }
        let sent = sender.join().map_err(|_| "the sending thread panicked")?;
        if let (Err(cause), false) = (sent, problems.is_empty()) {
            problems.push(cause);
        }
        Ok(problems)
    })
}

/// Renders and sends all frames, in the number type and the pixel format that were asked for.
fn send(args: &Args, line: &Line, sent: &mut dyn FnMut(u16)) -> Result<Sent, String> {
    match args.number {
        Number::F32 => send_number::<f32>(args, line, sent),
        Number::F64 => send_number::<f64>(args, line, sent),
        Number::I16f16 => send_number::<I16F16>(args, line, sent),
    }
}

/// A number type that the example can be asked for.
trait Choice: PipeScene {
    fn nearest(number: f64) -> Self;
}

impl Choice for f32 {
    fn nearest(number: f64) -> Self {
        number as Self
    }
}

impl Choice for f64 {
    fn nearest(number: f64) -> Self {
        number
    }
}

impl Choice for I16F16 {
    fn nearest(number: f64) -> Self {
        Self::saturating_from_num(number)
    }
}

fn send_number<S: Choice>(
    args: &Args,
    line: &Line,
    sent: &mut dyn FnMut(u16),
) -> Result<Sent, String> {
    let pixel = NEAR_HEIGHT / f64::from(args.size.height().min(FINEST_ROWS));
    let tolerance = S::nearest(PIXEL_PART * pixel);
    let text = |error: scancsg::solid::PipeError| error.to_string();
    match (args.scene, args.format) {
        (args::Part::Tee, Format::Gray8) => send_shaded(args, line, sent, &S::TEE, Gray8(0)),
        (args::Part::Tee, Format::Rgb565) => {
            send_shaded(args, line, sent, &S::PAINTED_TEE, Rgb565(0))
        }
        (args::Part::Pipe, Format::Gray8) => {
            let pipe = S::pipe(tolerance).map_err(text)?;
            send_shaded(args, line, sent, &pipe, Gray8(0))
        }
        (args::Part::Pipe, Format::Rgb565) => {
            let pipe = S::painted_pipe(tolerance).map_err(text)?;
            send_shaded(args, line, sent, &pipe, Rgb565(0))
        }
        (args::Part::Gallery(scene), format) => {
            let parts: Box<Assembly<S>> =
                Box::new(scene.build().map_err(|error| error.to_string())?);
            match format {
                Format::Gray8 => send_shaded(args, line, sent, &*parts, Gray8(0)),
                Format::Rgb565 => send_shaded(args, line, sent, &*parts, Rgb565(0)),
            }
        }
    }
}

/// A part that both cameras can see.
trait Part<S: Choice>:
    Solid<Scalar = S> + Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>
{
}
impl<S, T> Part<S> for T
where
    S: Choice,
    T: Solid<Scalar = S> + Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
{
}

fn send_shaded<S, T, P>(
    args: &Args,
    line: &Line,
    sent: &mut dyn FnMut(u16),
    part: &T,
    background: P,
) -> Result<Sent, String>
where
    S: Choice,
    T: Part<S>,
    P: Blend + WirePixel<Wire: Predictable>,
{
    let shading = Shading::new(args.shade, S::TO_LIGHT, S::hundredths);
    let shading = shading.map_err(|error| error.to_string())?;
    // Where the camera is in a frame, unless it stays where it is.
    let eye = |frame: u16| match args.path {
        Path::Turn => Ok(None),
        Path::Orbit => {
            let time = S::nearest(LAP * f64::from(frame) / f64::from(args.frames));
            S::eye(time).map(Some).map_err(|error| error.to_string())
        }
    };
    let text = |error: scancsg::render::CameraError| error.to_string();
    match args.camera {
        Camera::Ortho => {
            let camera = |frame| {
                eye(frame)?.map_or_else(S::orthographic, S::orthographic_from).map_err(text)
            };
            send_frames(args, line, sent, part, camera, shading, background)
        }
        Camera::Persp => {
            let camera =
                |frame| eye(frame)?.map_or_else(S::perspective, S::perspective_from).map_err(text);
            send_frames(args, line, sent, part, camera, shading, background)
        }
    }
}

fn send_frames<S, T, C, P>(
    args: &Args,
    line: &Line,
    sent: &mut dyn FnMut(u16),
    part: &T,
    camera: impl Fn(u16) -> Result<C, String>,
    shading: Shading<S>,
    background: P,
) -> Result<Sent, String>
where
    S: Choice,
    C: scancsg::render::Camera<Rays: Rays<Scalar = S>>,
    T: Solid<Scalar = S> + Scan<C::Rays>,
    P: Blend + WirePixel<Wire: Predictable>,
{
    let size: Size = args.size;
    let coding = match args.coding {
        Coding::Plain => Chosen::plain(),
        Coding::Predictive => Chosen::predictive(),
    };
    let patience = if args.one_way { ONE_WAY } else { PATIENCE };
    let mut sender = Box::new(Sender::<_, CAPACITY>::new(coding, patience));
    let (mut port, mut clock) = (line, line);
    let mut pixels = vec![background; usize::from(size.width())];
    let mut columns = vec![SmoothColumn::EMPTY; usize::from(size.width()) + 1];
    let (mut unheard, mut in_a_row, mut frames) = (0, 0, 0);
    for frame in 0..args.frames {
        let turns = match args.path {
            Path::Turn => f64::from(frame) / f64::from(args.frames),
            Path::Orbit => 0.0,
        };
        let turn = Pose::rotation_y(S::nearest(TAU * turns)).map_err(|error| error.to_string())?;
        let turned = Placed::new(part, turn);
        let camera = camera(frame)?;
        let delivery = match args.smooth {
            None => {
                let mut picture = Picture::new(&turned, &camera, size, shading, background);
                serve(&mut picture, frame, &mut sender, &mut port, &mut pixels, &mut clock)
            }
            Some(samples) => {
                let smoothing = Smoothing::new(size, samples, &mut columns)
                    .map_err(|error| error.to_string())?;
                let mut picture =
                    SmoothPicture::new(&turned, &camera, smoothing, shading, background);
                serve(&mut picture, frame, &mut sender, &mut port, &mut pixels, &mut clock)
            }
        };
        let delivery = delivery.map_err(|error| describe_error(&error))?;
        let is_unheard = delivery == Delivery::Unheard;
        unheard += u32::from(is_unheard);
        in_a_row = if is_unheard { in_a_row + 1 } else { 0 };
        frames += 1;
        sent(frame);
        if in_a_row >= UNHEARD && !args.one_way {
            break;
        }
    }
    Ok(Sent { frames, bytes: sender.bytes_sent(), unheard })
}

fn describe_error(error: &ServeError<io::Error>) -> String {
    match error {
        ServeError::Write(cause) | ServeError::Read(cause) => format!("sending failed: {cause}"),
        error => error.to_string(),
    }
}
