//! The examples as a user runs them: what they print, what they write, how they fail.

#![cfg(unix)]

use super::common::{Guarded, Pty, at_once, example, read_png, scratch};
use super::scene;
use scancsg::render::{Gray8, Lambert, Picture, Size, SmoothColumn, SmoothPicture, Smoothing};
use scancsg::stream::{
    Assembler, CONTROL_CAPACITY, Decoder, Memory, PixelFormat, encode_ack, packet_capacity,
};
use std::process::Output;

fn stream(arguments: &[&str]) -> Output {
    example("stream").args(arguments).output().unwrap()
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
    let output = stream(&["--out", out.to_str().unwrap(), "--cut-after", "1000"]);
    assert_eq!(output.status.code(), Some(3));
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
    let cases = [("turn", "f64", "2000"), ("orbit", "f32", "0.002"), ("turn", "i16f16", "0.001")];
    for (path, number, noise) in cases {
        let out = scratch(&format!("pipe-{path}-{number}.png"));
        let arguments = ["--scene", "pipe", "--frames", "3", "--size", "48x36", "--path", path];
        let rest = ["--format", "rgb565", "--noise", noise, "--number", number];
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
        (vec!["--noise", "0.5"], "0.05"),
        (vec!["--noise", "19"], "20"),
        (vec!["--coding", "zip"], "predictive"),
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
        "--scene",
        "--out",
        "--size",
        "--format",
        "--shade",
        "--camera",
        "--number",
        "--smooth",
        "--frames",
        "--path",
        "--port",
        "--baud",
        "--coding",
        "--noise",
        "--one-way",
        "Exit codes",
    ] {
        assert!(text.contains(option), "{option}");
    }
}

#[test]
fn stream_sends_to_a_serial_device() {
    const CAPACITY: usize = packet_capacity(48, PixelFormat::Gray8);
    let mut pty = Pty::new();
    let mut stream =
        Guarded::spawn(example("stream").args(["--port", &pty.name, "--size", "48x36"]));
    let (mut pixels, mut rows, mut above) = ([0; 48 * 36], [false; 36], [0; 50]);
    let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut above };
    let mut receiver = Assembler::new(memory);
    let mut decoder = Decoder::<CAPACITY>::new();
    while !receiver.is_complete() && stream.is_running() {
        let bytes = pty.read();
        let mut bytes = bytes.as_slice();
        while let Some(packet) = decoder.feed(&mut bytes) {
            receiver.accept(&packet.unwrap()).unwrap();
        }
    }
    let mut ack = [0; CONTROL_CAPACITY];
    let length = encode_ack(0, &mut ack).unwrap();
    pty.write(&mut stream, ack.get(..length).unwrap());
    let output = stream.end();
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let levels: Vec<u8> = rendered(48, 36).iter().map(|pixel| pixel.0).collect();
    assert_eq!(receiver.pixels(), levels);
}

/// Nobody reads or answers: it ends all the same, and says so.
#[test]
fn stream_ends_if_nobody_is_there() {
    let large = ["--size", "640x480", "--frames", "99", "--coding", "plain", "--format", "rgb565"];
    let cases = [
        (
            &["--frames", "99", "--size", "48x36", "--patience", "200"][..],
            3,
            "gave up after 3 of 99 frames",
        ),
        (&large[..], 1, "nobody reads"),
    ];
    at_once(cases, |(more, code, hint)| {
        let pty = Pty::new();
        let output = Guarded::spawn(example("stream").args(["--port", &pty.name]).args(more)).end();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{message}");
        assert!(message.contains(hint), "{message}");
    });
}

/// The reader takes some bytes, and is gone.
#[test]
fn stream_ends_if_the_reader_vanishes() {
    let mut pty = Pty::new();
    let arguments = ["--port", &pty.name, "--frames", "99"];
    let mut stream = Guarded::spawn(example("stream").args(arguments));
    let mut read = 0;
    while read < 1000 && stream.is_running() {
        read += pty.read().len();
    }
    drop(pty);
    let output = stream.end();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{message}");
}

#[test]
fn a_line_without_a_way_back_needs_no_answers() {
    let pty = Pty::new();
    let arguments = ["--port", &pty.name, "--one-way", "--frames", "9", "--size", "48x36"];
    let output = Guarded::spawn(example("stream").args(arguments)).end();
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

/// The example `bench` counts on boards what the set `benign` takes: its table is that set.
#[test]
fn the_rays_that_boards_count_are_the_benign_ones() {
    let table = include_str!("../../bench/benign.rs").lines().filter_map(|line| {
        let numbers = line.trim().strip_prefix("[0x")?.strip_suffix("],")?;
        Some(numbers.replace(", 0x", ","))
    });
    let benign = include_str!("../../../tests/reference/cylinder.csv").lines().filter_map(|line| {
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
