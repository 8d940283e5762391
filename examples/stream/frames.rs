//! Renders and sends frames: of the scene, in the number type, by the camera and the shader that were asked for.

use crate::args::{self, Args, Camera, Coding, Format, Number, Path};
use crate::coding::Chosen;
use crate::file;
use crate::gallery::Assembly;
use crate::host::receive::CAPACITY;
use crate::line::{Line, ONE_WAY, patience};
use crate::scene::fit::Fit;
use crate::setting::{Choice, Setting};
use crate::shading::Shading;
use clap::ValueEnum;
use scancsg::geom::{OrthographicRays, PerspectiveRays, Pose, Rays};
use scancsg::render::{
    Blend, CameraError, Gray8, Picture, Rgb565, RowSource, Size, SmoothColumn, SmoothPicture,
    Smoothing,
};
use scancsg::scalar::I16F16;
use scancsg::solid::{Placed, Scan, Solid};
use scancsg::stream::{Delivery, Predictable, Sender, ServeError, WirePixel, serve};
use std::f64::consts::TAU;
use std::io;

/// The pipe's segments follow its curve to this part of a pixel, in pictures of up to so many rows:
/// there is room for no more segments.
const PIXEL_PART: f64 = 0.25;
const FINEST_ROWS: u16 = 480;

/// The height of what the camera sees at the pipe's nearest point, or less.
const NEAR_HEIGHT: f64 = 3.7;

/// After so many frames in a row that nobody has acknowledged, no more are sent.
const UNHEARD: u32 = 3;

/// What the sending side has to say when it is done.
pub struct Sent {
    pub frames: u16,
    pub bytes: u64,
    pub unheard: u32,
}

/// Renders and sends all frames, in the number type and the pixel format that were asked for.
pub fn send(args: &Args, line: &Line, sent: &mut dyn FnMut(u16)) -> Result<Sent, String> {
    if let args::Part::File(path) = &args.scene {
        let (bytes, number) = file::read(path)?;
        if args.number.is_some_and(|wanted| wanted != number) {
            let name = number.to_possible_value().map(|value| value.get_name().to_owned());
            let name = name.unwrap_or_default();
            return Err(format!("{} is in {name}: leave --number out", path.display()));
        }
        return match number {
            Number::F32 => send_file::<f32>(args, path, &bytes, line, sent),
            Number::F64 => send_file::<f64>(args, path, &bytes, line, sent),
            Number::I16f16 => send_file::<I16F16>(args, path, &bytes, line, sent),
        };
    }
    match args.number.unwrap_or(Number::F32) {
        Number::F32 => send_number::<f32>(args, line, sent),
        Number::F64 => send_number::<f64>(args, line, sent),
        Number::I16f16 => send_number::<I16F16>(args, line, sent),
    }
}

/// Renders and sends the part of a file.
fn send_file<S: Choice>(
    args: &Args,
    path: &std::path::Path,
    bytes: &[u8],
    line: &Line,
    sent: &mut dyn FnMut(u16),
) -> Result<Sent, String> {
    let part = file::part::<S>(path, bytes)?;
    let fit = Fit::of(&part.bounds());
    let fit = fit.ok_or_else(|| format!("{}: the part has no end", path.display()))?;
    let setting = &Setting::Fitted(fit);
    match args.format {
        Format::Gray8 => send_shaded(args, line, sent, setting, &*part, Gray8(0)),
        Format::Rgb565 => send_shaded(args, line, sent, setting, &*part, Rgb565(0)),
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
    let setting = &Setting::Named;
    match (&args.scene, args.format) {
        (args::Part::Tee, Format::Gray8) => {
            send_shaded(args, line, sent, setting, &S::TEE, Gray8(0))
        }
        (args::Part::Tee, Format::Rgb565) => {
            send_shaded(args, line, sent, setting, &S::PAINTED_TEE, Rgb565(0))
        }
        (args::Part::Pipe, Format::Gray8) => {
            let pipe = S::pipe(tolerance).map_err(text)?;
            send_shaded(args, line, sent, setting, &pipe, Gray8(0))
        }
        (args::Part::Pipe, Format::Rgb565) => {
            let pipe = S::painted_pipe(tolerance).map_err(text)?;
            send_shaded(args, line, sent, setting, &pipe, Rgb565(0))
        }
        (args::Part::Gallery(scene), format) => {
            let parts: Box<Assembly<S>> =
                Box::new(scene.build().map_err(|error| error.to_string())?);
            match format {
                Format::Gray8 => send_shaded(args, line, sent, setting, &*parts, Gray8(0)),
                Format::Rgb565 => send_shaded(args, line, sent, setting, &*parts, Rgb565(0)),
            }
        }
        // It has a number type of its own.
        (args::Part::File(path), _) => Err(format!("{} is a file", path.display())),
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
    setting: &Setting<S>,
    part: &T,
    background: P,
) -> Result<Sent, String>
where
    S: Choice,
    T: Part<S>,
    P: Blend + WirePixel<Wire: Predictable>,
{
    let text = |error: CameraError| error.to_string();
    let shading = setting.shading(args.shade).map_err(|error| error.to_string())?;
    // Where the camera is in a frame, unless it stays where it is.
    let eye = |frame: u16| match args.path {
        Path::Turn => Ok(None),
        Path::Orbit => setting.eye(f64::from(frame) / f64::from(args.frames)).map(Some),
    };
    let turn = |frame: u16| {
        let turns = match args.path {
            Path::Turn => f64::from(frame) / f64::from(args.frames),
            Path::Orbit => 0.0,
        };
        setting.turn(S::nearest(TAU * turns))
    };
    match args.camera {
        Camera::Ortho => {
            let camera = |frame| setting.orthographic(eye(frame)?).map_err(text);
            send_frames(args, line, sent, part, turn, camera, shading, background)
        }
        Camera::Persp => {
            let camera = |frame| setting.perspective(eye(frame)?).map_err(text);
            send_frames(args, line, sent, part, turn, camera, shading, background)
        }
    }
}

#[allow(clippy::too_many_arguments)] // what a frame is made of
fn send_frames<S, T, C, P>(
    args: &Args,
    line: &Line,
    sent: &mut dyn FnMut(u16),
    part: &T,
    turn: impl Fn(u16) -> Result<Pose<S>, String>,
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
    let mut sending = Sending::new(args, line, background);
    let mut columns = vec![SmoothColumn::EMPTY; usize::from(size.width()) + 1];
    for frame in 0..args.frames {
        let turned = Placed::new(part, turn(frame)?);
        let camera = camera(frame)?;
        match args.smooth {
            None => {
                let mut picture = Picture::new(&turned, &camera, size, shading, background);
                sending.send(&mut picture)?;
            }
            Some(samples) => {
                let smoothing = Smoothing::new(size, samples, &mut columns)
                    .map_err(|error| error.to_string())?;
                let mut picture =
                    SmoothPicture::new(&turned, &camera, smoothing, shading, background);
                sending.send(&mut picture)?;
            }
        }
        sent(frame);
        if sending.is_in_vain() {
            break;
        }
    }
    Ok(sending.end())
}

/// The sending end of the link. It is compiled once for all pictures of a pixel.
struct Sending<'a, P: WirePixel<Wire: Predictable>> {
    line: &'a Line,
    sender: Box<Sender<Chosen<P::Wire>, CAPACITY>>,
    pixels: Vec<P>,
    is_one_way: bool,
    frames: u16,
    unheard: u32,
    /// Frames in a row that nobody has acknowledged.
    in_a_row: u32,
}

impl<'a, P: WirePixel<Wire: Predictable> + Clone> Sending<'a, P> {
    fn new(args: &Args, line: &'a Line, background: P) -> Self {
        let coding = match args.coding {
            Coding::Plain => Chosen::plain(),
            Coding::Predictive => Chosen::predictive(),
        };
        let patience = if args.one_way { ONE_WAY } else { patience(args.patience) };
        Self {
            line,
            sender: Box::new(Sender::new(coding, patience)),
            pixels: vec![background; usize::from(args.size.width())],
            is_one_way: args.one_way,
            frames: 0,
            unheard: 0,
            in_a_row: 0,
        }
    }

    fn send(&mut self, picture: &mut dyn RowSource<Pixel = P>) -> Result<(), String> {
        let (mut port, mut clock) = (self.line, self.line);
        let Self { sender, pixels, .. } = self;
        let delivery = serve(picture, self.frames, sender, &mut port, pixels, &mut clock)
            .map_err(|error| describe_error(&error))?;
        let is_unheard = delivery == Delivery::Unheard;
        self.frames += 1;
        self.unheard += u32::from(is_unheard);
        self.in_a_row = if is_unheard { self.in_a_row + 1 } else { 0 };
        Ok(())
    }

    fn is_in_vain(&self) -> bool {
        self.in_a_row >= UNHEARD && !self.is_one_way
    }

    fn end(&self) -> Sent {
        Sent { frames: self.frames, bytes: self.sender.bytes_sent(), unheard: self.unheard }
    }
}

fn describe_error(error: &ServeError<io::Error>) -> String {
    match error {
        ServeError::Write(cause) | ServeError::Read(cause) => format!("sending failed: {cause}"),
        error => error.to_string(),
    }
}
