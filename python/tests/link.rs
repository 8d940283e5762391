//! The Python package at the other end of this crate's sender. `cargo xtask python` installs the package and
//! runs these tests, which are ignored otherwise.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../../web/tests/parts/mod.rs"]
mod parts;

use parts::{Noise, SIZE, Shown, colors, recording, send};
use scancsg::render::{Gray8, Mono, Rgb565, Rgb888};
use scancsg::stream::{Delivery, PixelFormat};
use serialport::{SerialPort, TTYPort};
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// Starts the receiver.
fn python(source: &str, count: u16) -> Child {
    let site = std::env::var_os("SCANCSG_PYTHON").expect("SCANCSG_PYTHON is where the package is");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../python/tests/receive.py");
    let mut command = Command::new("python3");
    command.arg(script).arg(source).arg(count.to_string()).arg("115200").env("PYTHONPATH", site);
    command.stdout(Stdio::piped()).spawn().unwrap()
}

/// What the receiver must say of a complete frame.
fn line<P: Shown>(frame: u16) -> String {
    let [width, height] = SIZE;
    let (format, has_colors) = match P::FORMAT {
        PixelFormat::Gray8 => ("GRAY8", false),
        PixelFormat::Rgb565 => ("RGB565", true),
        PixelFormat::Rgb888 => ("RGB888", true),
        _ => ("MONO", false),
    };
    let (shape, channels) = if has_colors { ("x3", 3) } else { ("", 1) };
    let bytes = colors::<P>(frame).flat_map(|color| color.into_iter().take(channels));
    let pixels: String = bytes.map(|byte| format!("{byte:02x}")).collect();
    format!("{frame} {format} {height}x{width}{shape} none {pixels}")
}

/// Sends frames over a pseudo-terminal pair with noise on it, and compares what Python says.
fn receives<P: Shown>(start: u16) {
    let (mut port, far) = TTYPort::pair().unwrap();
    let receiver = python(&far.name().unwrap(), 4);
    let mut noise = Noise::default();
    for frame in start..start + 4 {
        let mut reader = port.try_clone_native().unwrap();
        let write = |packet: &[u8]| {
            let mut rest = &noise.on(packet)[..];
            while !rest.is_empty() {
                match port.write(rest) {
                    Ok(count) => rest = &rest[count..],
                    Err(error) if error.kind() == ErrorKind::TimedOut => {}
                    Err(error) => panic!("{error}"),
                }
            }
        };
        let listen = |wait: Duration| {
            let mut bytes = [0; 64];
            reader.set_timeout(wait).unwrap();
            match reader.read(&mut bytes) {
                Ok(count) => bytes[..count].to_vec(),
                Err(error) if error.kind() == ErrorKind::TimedOut => Vec::new(),
                Err(error) => panic!("{error}"),
            }
        };
        let delivery = send::<P>(frame, 200, write, listen);
        assert!(matches!(delivery, Delivery::Acknowledged { .. }), "frame {frame}: {delivery:?}");
    }
    let said = receiver.wait_with_output().unwrap();
    assert!(said.status.success());
    let said = String::from_utf8(said.stdout).unwrap();
    let lines: Vec<&str> = said.lines().collect();
    let [frames @ .., traffic] = &lines[..] else { panic!("nothing was received") };
    let expected: Vec<String> = (start..start + 4).map(line::<P>).collect();
    assert!(*frames == expected, "{:?}: {traffic}", P::FORMAT);
    let figures: Vec<u32> = traffic.split(' ').skip(1).map(|text| text.parse().unwrap()).collect();
    let [complete, lost, damaged, requests] = figures[..] else { panic!("{traffic}") };
    assert_eq!((complete, lost), (4, 0));
    assert!(damaged > 0 && requests > 0, "the noise damaged nothing: {traffic}");
}

#[test]
#[ignore = "needs SCANCSG_PYTHON, where the package is"]
fn a_pseudo_terminal_brings_the_pixels_of_the_sender() {
    receives::<Gray8>(0);
    receives::<Rgb565>(10);
    receives::<Rgb888>(65_530);
    receives::<Mono>(7);
}

#[test]
#[ignore = "needs SCANCSG_PYTHON, where the package is"]
fn a_recording_is_read_and_says_what_is_missing() {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("python.bin");
    let mut bytes = recording::<Rgb565>(0..3);
    // Only the last frame's end is missing, and a packet in the first third: a frame in plain rows.
    let third = bytes.len() / 5;
    bytes[third] ^= 0x40;
    bytes.truncate(bytes.len() - 5);
    std::fs::write(&path, &bytes).unwrap();
    let said = python(&path.display().to_string(), 0).wait_with_output().unwrap();
    assert!(said.status.success());
    let said = String::from_utf8(said.stdout).unwrap();
    let lines: Vec<Vec<&str>> = said.lines().map(|line| line.split(' ').collect()).collect();
    assert_eq!(lines.len(), 4, "{said}");
    assert_eq!((lines[0][0], lines[1].join(" ")), ("0", line::<Rgb565>(1)));
    assert_eq!((lines[2][0], lines[2][3]), ("2", "end"));
    let missing: usize = lines[0][3].parse().unwrap();
    let expected: Vec<u8> = colors::<Rgb565>(0)
        .enumerate()
        .flat_map(|(at, color)| if at / usize::from(SIZE[0]) == missing { [0; 3] } else { color })
        .collect();
    let expected: String = expected.iter().map(|byte| format!("{byte:02x}")).collect();
    assert!(lines[0][4] == expected);
    assert_eq!(lines[3], ["traffic", "1", "2", "1", "2"]);
}
