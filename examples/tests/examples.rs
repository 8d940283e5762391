//! The examples as a user runs them: what they print, what they write, how they fail.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic)]

#[path = "../scene/mod.rs"]
mod scene;

use scancsg::render::{Gray8, Lambert, Picture, Size, SmoothColumn, SmoothPicture, Smoothing};
use scancsg::stream::{
    CONTROL_CAPACITY, Decoder, FrameHeader, PixelFormat, Receiver, Sender, encode_ack,
    packet_capacity,
};
use serialport::SerialPort;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// An example's binary, which `cargo test` builds beside the tests.
fn example(name: &str) -> Command {
    let test = std::env::current_exe().unwrap();
    let path = test.parent().and_then(Path::parent).unwrap().join("examples").join(name);
    assert!(path.exists(), "{} is missing: run `cargo build --examples`", path.display());
    Command::new(path)
}

fn stream(arguments: &[&str]) -> Output {
    example("stream").args(arguments).output().unwrap()
}

/// A file of this test's own.
fn scratch(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

struct Png {
    width: u32,
    height: u32,
    color: png::ColorType,
    frames: u32,
    pixels: Vec<u8>,
}

fn read_png(path: &Path) -> Png {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    pixels.truncate(info.buffer_size());
    let frames = reader.info().animation_control.map_or(1, |animation| animation.num_frames);
    Png { width: info.width, height: info.height, color: info.color_type, frames, pixels }
}

/// `tee` as the library renders it, without any link.
fn rendered(width: u16, height: u16) -> Vec<Gray8> {
    let camera = scene::f32::orthographic().unwrap();
    let light = Lambert::new(scene::f32::TO_LIGHT, 0.15).unwrap();
    let size = Size::new(width, height).unwrap();
    let mut picture = Picture::new(&scene::f32::TEE, &camera, size, light, Gray8(0));
    let mut row = vec![Gray8(0); usize::from(width)];
    let mut pixels = Vec::new();
    for y in 0..height {
        picture.scanline(y).unwrap().render(&mut row).unwrap();
        pixels.extend_from_slice(&row);
    }
    pixels
}

#[test]
fn the_streamed_picture_is_the_rendered_one() {
    let out = scratch("plain.png");
    let output = stream(&["--out", out.to_str().unwrap()]);
    assert!(output.status.success(), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("160x120"));

    let png = read_png(&out);
    assert_eq!((png.width, png.height, png.color), (160, 120, png::ColorType::Grayscale));
    let levels: Vec<u8> = rendered(160, 120).iter().map(|pixel| pixel.0).collect();
    assert_eq!(png.pixels, levels);
}

/// Rows that are asked for again are the same, though others were rendered in between.
#[test]
fn smooth_edges_survive_noise() {
    let out = scratch("smooth.png");
    let arguments = ["--smooth", "3", "--size", "80x60", "--noise", "300", "--out"];
    let output = stream(&[&arguments[..], &[out.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("damaged packet"));

    let camera = scene::f32::orthographic().unwrap();
    let light = Lambert::new(scene::f32::TO_LIGHT, 0.15).unwrap();
    let mut columns = [SmoothColumn::EMPTY; 81];
    let smoothing = Smoothing::new(Size::new(80, 60).unwrap(), 3, &mut columns).unwrap();
    let mut picture = SmoothPicture::new(&scene::f32::TEE, &camera, smoothing, light, Gray8(0));
    let mut levels = Vec::new();
    for y in (0..60).rev() {
        let mut row = [Gray8(0); 80];
        picture.render(y, &mut row).unwrap();
        levels.splice(0..0, row.map(|pixel| pixel.0));
    }
    assert_eq!(read_png(&out).pixels, levels);
}

#[test]
fn a_noisy_line_is_repaired_to_the_same_picture() {
    let (clean, noisy) = (scratch("clean.png"), scratch("noisy.png"));
    let size = ["--size", "96x72", "--format", "rgb565", "--camera", "persp"];
    let run = |more: &[&str]| stream(&[&size, more].concat());
    assert!(run(&["--out", clean.to_str().unwrap()]).status.success());
    let output = run(&["--out", noisy.to_str().unwrap(), "--noise", "300"]);
    assert!(output.status.success(), "{output:?}");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(text.contains("damaged packet"), "{text}");
    assert_eq!(read_png(&clean).pixels, read_png(&noisy).pixels);
    assert_eq!(read_png(&clean).color, png::ColorType::Rgb);
}

#[test]
fn a_cut_line_saves_what_arrived_and_names_the_rest() {
    let out = scratch("cut.png");
    let output = stream(&["--out", out.to_str().unwrap(), "--cut-after", "3000"]);
    assert!(!output.status.success());
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    let (_, rows) = message.split_once("missing rows: ").unwrap();
    let first: usize = rows.split('-').next().unwrap().parse().unwrap();
    assert!(rows.contains("-119"), "{message}");

    let png = read_png(&out);
    let levels: Vec<u8> = rendered(160, 120).iter().map(|pixel| pixel.0).collect();
    let (here, missing) = png.pixels.split_at(first * 160);
    assert_eq!(here, levels.get(..first * 160).unwrap());
    assert!(first > 10 && missing.iter().all(|level| *level == 0));
}

#[test]
fn several_frames_are_an_animation() {
    for (path, number) in [("turn", "f32"), ("orbit", "f64"), ("orbit", "i16f16")] {
        let out = scratch(&format!("{path}-{number}.png"));
        let arguments = ["--frames", "3", "--size", "48x36", "--shade", "xray", "--path", path];
        let rest = ["--number", number, "--out", out.to_str().unwrap()];
        assert!(stream(&[&arguments[..], &rest[..]].concat()).status.success());
        assert_eq!(read_png(&out).frames, 3);
    }
}

#[test]
fn the_pipe_looks_alike_in_all_number_types() {
    let picture = |number: &str| {
        let out = scratch(&format!("pipe-{number}.png"));
        let arguments = ["--scene", "pipe", "--camera", "persp", "--size", "96x72"];
        let rest = ["--number", number, "--out", out.to_str().unwrap()];
        let output = stream(&[&arguments[..], &rest[..]].concat());
        assert!(output.status.success(), "{output:?}");
        read_png(&out).pixels
    };
    let single = picture("f32");
    let bright = single.iter().filter(|&&level| level > 0).count();
    assert!((1500..4000).contains(&bright), "{bright}");
    for other in ["f64", "i16f16"].map(picture) {
        let differs = |(a, b): &(&u8, &u8)| a.abs_diff(**b) > 8;
        let different = single.iter().zip(&other).filter(differs).count();
        assert!(different < bright / 50, "{different} of {bright}");
    }
}

#[test]
fn the_pipe_moves_and_survives_noise() {
    for (path, number) in [("turn", "f64"), ("orbit", "f32"), ("turn", "i16f16")] {
        let out = scratch(&format!("pipe-{path}-{number}.png"));
        let arguments = ["--scene", "pipe", "--frames", "3", "--size", "48x36", "--path", path];
        let rest = ["--format", "rgb565", "--noise", "2000", "--number", number];
        let output =
            stream(&[&arguments[..], &rest[..], &["--out", out.to_str().unwrap()]].concat());
        assert!(output.status.success(), "{output:?}");
        assert_eq!(read_png(&out).frames, 3);
    }
}

#[test]
fn wrong_arguments_say_what_is_wrong() {
    let cases = [
        (vec!["--size", "0x9"], "zero"),
        (vec!["--size", "12"], "160x120"),
        (vec!["--size", "9999x9"], "4096"),
        (vec!["--frames", "0"], "1..=3600"),
        (vec!["--smooth", "0"], "1..=16"),
        (vec!["--smooth", "9", "--size", "4096x9"], "samples"),
        (vec!["--format", "cmyk"], "rgb565"),
        (vec!["--baud", "1"], "300"),
        (vec!["--port", "/nonexistent/tty"], "/nonexistent/tty"),
        (vec!["--out", "/nonexistent/a.png"], "/nonexistent/a.png"),
    ];
    for (arguments, hint) in cases {
        let output = stream(&arguments);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success(), "{arguments:?}");
        assert!(message.contains(hint), "{arguments:?}: {message}");
        assert!(!message.contains("panicked"), "{arguments:?}: {message}");
    }
}

#[test]
fn help_names_every_option() {
    let output = stream(&["--help"]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    for option in [
        "--scene", "--out", "--size", "--format", "--shade", "--camera", "--number", "--smooth",
        "--frames", "--path", "--port", "--baud",
    ] {
        assert!(text.contains(option), "{option}");
    }
}

#[test]
fn view_receives_from_a_serial_device() {
    const CAPACITY: usize = packet_capacity(48, PixelFormat::Gray8);
    let (mut near, far) = serialport::TTYPort::pair().unwrap();
    let device = far.name().unwrap();
    drop(far);
    let out = scratch("view.png");
    let mut view = example("view")
        .args(["--port", &device, "--out", out.to_str().unwrap(), "--wait", "20"])
        .stderr(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();

    let pixels = rendered(48, 36);
    let mut bytes = Vec::new();
    let mut sender = Sender::<_, CAPACITY>::new(&mut bytes);
    let (width, height) = (48, 36);
    sender.begin(FrameHeader { frame: 7, width, height, format: PixelFormat::Gray8 }).unwrap();
    for (y, row) in (0..).zip(pixels.chunks_exact(48)) {
        sender.row(y, row).unwrap();
    }
    sender.end().unwrap();
    // Until the other program opens the device, the line is down, and when it does, it may find
    // itself in the middle of a frame: send until it has had enough and ends.
    let pause = std::time::Duration::from_millis(200);
    near.set_timeout(pause).unwrap();
    let mut answer = [0; 64];
    for _ in 0..60 {
        let _ = near.write_all(&bytes);
        let _ = near.read(&mut answer);
        if view.try_wait().unwrap().is_some() {
            break;
        }
        std::thread::sleep(pause);
    }
    let output = view.wait_with_output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let levels: Vec<u8> = pixels.iter().map(|pixel| pixel.0).collect();
    assert_eq!(read_png(&out).pixels, levels);
}

#[test]
fn stream_sends_to_a_serial_device() {
    const CAPACITY: usize = packet_capacity(48, PixelFormat::Gray8);
    let (mut near, far) = serialport::TTYPort::pair().unwrap();
    let device = far.name().unwrap();
    drop(far);
    let mut stream = example("stream")
        .args(["--port", &device, "--size", "48x36"])
        .stderr(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();

    let (mut pixels, mut rows) = ([0; 48 * 36], [false; 36]);
    let mut receiver = Receiver::new(&mut pixels, &mut rows);
    let mut decoder = Decoder::<CAPACITY>::new();
    let mut buffer = [0; 512];
    while !receiver.is_complete() && stream.try_wait().unwrap().is_none() {
        // Until the other program opens the device, reading fails.
        let count = near.read(&mut buffer).unwrap_or(0);
        let mut bytes = buffer.get(..count).unwrap();
        while let Some(packet) = decoder.feed(&mut bytes) {
            receiver.accept(&packet.unwrap()).unwrap();
        }
    }
    let mut ack = [0; CONTROL_CAPACITY];
    let length = encode_ack(0, &mut ack).unwrap();
    near.write_all(ack.get(..length).unwrap()).unwrap();
    let output = stream.wait_with_output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!message.contains("not acknowledged"), "{message}");
    let levels: Vec<u8> = rendered(48, 36).iter().map(|pixel| pixel.0).collect();
    assert_eq!(receiver.pixels(), levels);
}

/// The example `bench` counts on boards what the set `benign` takes: its table is that set.
#[test]
fn the_rays_that_boards_count_are_the_benign_ones() {
    let table = include_str!("../bench/benign.rs").lines().filter_map(|line| {
        let numbers = line.trim().strip_prefix("[0x")?.strip_suffix("],")?;
        Some(numbers.replace(", 0x", ","))
    });
    let benign = include_str!("../../tests/reference/cylinder.csv").lines().filter_map(|line| {
        let numbers: Vec<&str> = line.strip_prefix("benign,")?.split(',').take(8).collect();
        Some(numbers.join(","))
    });
    assert!(table.clone().count() == 100 && table.eq(benign));
}

/// The arm turns, and the lidar sees it: at first, straight below it is the upper face of the lower link.
#[test]
fn a_lidar_meets_the_arm() {
    let output = example("joint").output().unwrap();
    assert!(output.status.success());
    let said = String::from_utf8(output.stdout).unwrap();
    let frames: Vec<&str> = said.split("frame ").skip(1).collect();
    assert_eq!(frames.len(), 12);
    let ranges = |frame: &str| -> Vec<String> {
        let line = frame.trim_end().lines().last().unwrap();
        line.split(' ').map(str::to_owned).collect()
    };
    assert_eq!((ranges(frames[0])[18].as_str(), ranges(frames[0])[6].as_str()), ("2.10", "-"));
    let first_row = |frame: &str| frame.lines().nth(1).unwrap().len();
    assert!(frames.iter().all(|frame| ranges(frame).len() == 24 && first_row(frame) == 60));
    let picture = |frame: &str| frame.lines().skip(1).take(30).collect::<String>();
    assert!(frames.windows(2).all(|pair| picture(pair[0]) != picture(pair[1])));
}
