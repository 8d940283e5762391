//! The command line.

use crate::gallery::Scene;
use clap::builder::{PossibleValue, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, Command, Parser, ValueEnum};
use scancsg::render::Size;
use std::ffi::OsStr;
use std::path::{self, PathBuf};
use std::sync::LazyLock;

const EXIT_CODES: &str = "\
Exit codes: 0 all frames are whole and acknowledged, 1 something failed, 2 wrong options, \
3 a frame is incomplete or not acknowledged.";

/// Render a part row by row, send it through a serial line, and put it together at the other end.
///
/// Without --port, the line is a pseudo-terminal pair of this computer: a thread renders and
/// sends into one end, the other end is received, shown and saved. With --port, the frames go
/// to a device, and the example `view` can receive them.
#[derive(Debug, Parser)]
#[command(name = "stream", version, after_help = EXIT_CODES)]
pub struct Args {
    /// What is rendered: one of these scenes, or a file with a part as a program in bytes
    #[arg(long, value_name = "NAME|FILE", default_value = "tee", value_parser = SceneOrFile)]
    pub scene: Part,

    /// The PNG file to write; several frames become an animation
    #[arg(long, value_name = "FILE.png", default_value = "tee.png")]
    pub out: PathBuf,

    /// Width and height of the picture in pixels, at most 4096x4096
    #[arg(long, value_name = "WxH", default_value = "160x120", value_parser = size)]
    pub size: Size,

    /// Grey levels, or 16-bit colours
    #[arg(long, value_enum, default_value_t = Format::Gray8)]
    pub format: Format,

    /// Lit from above, by depth, or by thickness
    #[arg(long, value_enum, default_value_t = Shade::Lambert)]
    pub shade: Shade,

    /// Parallel rays, or rays through an eye
    #[arg(long, value_enum, default_value_t = Camera::Ortho)]
    pub camera: Camera,

    /// The number type to render with: floating point, or fixed point with 16 fraction bits. f32 if it isn't
    /// given; a file says itself which it is in
    #[arg(long, value_enum)]
    pub number: Option<Number>,

    /// Smooth edges: the mean of NxN samples in every pixel that is not all of one face
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=16))]
    pub smooth: Option<u16>,

    /// How rows are coded: several together, each pixel predicted from its neighbours, or each row for
    /// itself, in runs of equal pixels
    #[arg(long, value_enum, default_value_t = Coding::Predictive)]
    pub coding: Coding,

    /// How many frames; all of them together are one turn
    #[arg(long, value_name = "N", default_value_t = 1,
          value_parser = clap::value_parser!(u16).range(1..=3600))]
    pub frames: u16,

    /// What moves from frame to frame: the part about y, or the camera along a spline around it
    #[arg(long, value_enum, default_value_t = Path::Turn)]
    pub path: Path,

    /// Send to this serial device instead of to this computer itself
    #[arg(long, value_name = "DEVICE")]
    pub port: Option<String>,

    /// The line's speed in bits per second: 115200 for a device, unlimited for the loopback
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(300..))]
    pub baud: Option<u32>,

    /// Flip bits, to see the repair at work: in this share of the bytes sent, as 0.001, or in about
    /// every N-th
    #[arg(long, value_name = "RATE", default_value = "0", value_parser = noise)]
    pub noise: f32,

    /// How long the other end may take to answer, in milliseconds. It is asked three times
    #[arg(long, value_name = "MS", default_value_t = 1000,
          value_parser = clap::value_parser!(u32).range(10..=60_000))]
    pub patience: u32,

    /// Don't wait for the other end's answers: the line has no way back
    #[arg(long, requires = "port", conflicts_with = "patience")]
    pub one_way: bool,

    /// Close the line after N bytes, to see what becomes of an interrupted frame
    #[arg(long, value_name = "N")]
    pub cut_after: Option<u64>,
}

/// What is rendered.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Part {
    Tee,
    Pipe,
    Gallery(Scene),
    File(PathBuf),
}

impl ValueEnum for Part {
    fn value_variants<'a>() -> &'a [Self] {
        static ALL: LazyLock<Vec<Part>> = LazyLock::new(|| {
            let gallery = Scene::value_variants().iter().copied().map(Part::Gallery);
            [Part::Tee, Part::Pipe].into_iter().chain(gallery).collect()
        });
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let named = |name, help: &'static str| Some(PossibleValue::new(name).help(help));
        match self {
            Self::Tee => named("tee", "A pipe tee with flanges"),
            Self::Pipe => named("pipe", "A pipe along a B-spline"),
            Self::Gallery(scene) => scene.to_possible_value(),
            Self::File(_) => None,
        }
    }
}

/// The name of a scene, or else of a file.
#[derive(Clone)]
struct SceneOrFile;

impl TypedValueParser for SceneOrFile {
    type Value = Part;

    fn parse_ref(
        &self,
        command: &Command,
        _: Option<&Arg>,
        value: &OsStr,
    ) -> Result<Part, clap::Error> {
        let named = value.to_str().and_then(|name| Part::from_str(name, false).ok());
        match named {
            Some(part) => Ok(part),
            None if path::Path::new(value).is_file() => Ok(Part::File(value.into())),
            None => {
                let names: Vec<String> = self
                    .possible_values()
                    .into_iter()
                    .flatten()
                    .map(|name| name.get_name().into())
                    .collect();
                let message = format!(
                    "`{}` is neither a scene nor a file; the scenes are\n  {}\n",
                    value.display(),
                    wrapped(&names)
                );
                Err(clap::Error::raw(ErrorKind::InvalidValue, message).with_cmd(command))
            }
        }
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue>>> {
        Some(Box::new(Part::value_variants().iter().filter_map(ValueEnum::to_possible_value)))
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    Gray8,
    Rgb565,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Coding {
    Predictive,
    Plain,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Shade {
    Lambert,
    Depth,
    Xray,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Camera {
    Ortho,
    Persp,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Path {
    Turn,
    Orbit,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Number {
    F32,
    F64,
    I16f16,
}

/// A share of bytes, or one in so many.
fn noise(text: &str) -> Result<f32, String> {
    match text.parse() {
        Ok(rate @ 0.0..=0.05) => Ok(rate),
        Ok(every @ 20.0..=1e9) => Ok(1.0 / every),
        _ => Err("not a share of bytes up to 0.05, nor a number of bytes from 20 on".into()),
    }
}

fn size(text: &str) -> Result<Size, String> {
    let (width, height) =
        text.split_once(['x', 'X']).ok_or("not a width and a height: write it as 160x120")?;
    let number = |text: &str| {
        text.parse::<u16>()
            .ok()
            .filter(|number| *number <= 4096)
            .ok_or_else(|| format!("`{text}` is not a number of pixels between 1 and 4096"))
    };
    Size::new(number(width)?, number(height)?).map_err(|error| error.to_string())
}

/// Names in lines of at most 78 columns.
fn wrapped(names: &[String]) -> String {
    let (mut text, mut column) = (String::new(), 0);
    for name in names {
        let comma = if text.is_empty() { "" } else { ", " };
        text += comma;
        column += comma.len() + name.len();
        if column > 76 {
            text.truncate(text.trim_end().len());
            text += "\n  ";
            column = name.len();
        }
        text += name;
    }
    text
}
