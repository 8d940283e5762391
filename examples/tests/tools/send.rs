//! Parts as programs in bytes: `stream --scene FILE` renders them, `view --send FILE` sends them to a device.

#![cfg(unix)]

use super::common::{Guarded, Pty, at_once, example, read_png, scratch};
use super::scene::fit::Fit;
use super::scene::program::{Part, tee};
use super::scene::{Scene, Tee};
use scancsg::geom::{OrthographicRays, PerspectiveRays, Rays, vec3};
use scancsg::program::Program;
use scancsg::render::{Camera, Gray8, Lambert, Picture, RowSource, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::{HalfSpace, Scan, Solid};
use scancsg::stream::{
    Delivery, Inbox, Patience, PixelFormat, Plain, Refusal, Sender, Task, packet_capacity,
};
use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// `tee` as a file.
fn file<S: Scene>(name: &str) -> PathBuf {
    let mut buffer = [0; 1024];
    let program = tee::<S>().unwrap();
    let path = scratch(name);
    fs::write(&path, program.to_bytes(&mut buffer).unwrap()).unwrap();
    path
}

/// The levels of `tee`: as a typed tree, and without a link.
fn levels<S: Scene, C: Camera<Rays: Rays<Scalar = S>>>(camera: &C, size: Size) -> Vec<u8>
where
    Tee<S>: Scan<C::Rays, Scalar = S>,
{
    let light = Lambert::new(Fit::to_light(), S::hundredths(15)).unwrap();
    let part = S::TEE;
    let mut picture = Picture::new(&part, camera, size, light, Gray8(0));
    let mut row = vec![Gray8(0); usize::from(size.width())];
    let rows = (0..size.height()).flat_map(|y| {
        picture.render(y, &mut row).unwrap();
        row.iter().map(|pixel| pixel.0).collect::<Vec<_>>()
    });
    rows.collect()
}

fn is_rendered<S: Scene>(name: &str)
where
    Part<S>: Solid<Scalar = S>,
    Tee<S>: Scan<OrthographicRays<S>, Scalar = S> + Scan<PerspectiveRays<S>>,
{
    let path = file::<S>(&format!("{name}.scene"));
    let fit = Fit::of(&tee::<S>().unwrap().bounds()).unwrap();
    let size = Size::new(80, 60).unwrap();
    for (camera, wanted) in [
        ("ortho", levels(&fit.orthographic(None).unwrap(), size)),
        ("persp", levels(&fit.perspective(None).unwrap(), size)),
    ] {
        let out = scratch(&format!("{name}-{camera}.png"));
        let output = example("stream")
            .args(["--scene", path.to_str().unwrap(), "--size", "80x60", "--camera", camera])
            .args(["--out", out.to_str().unwrap()])
            .output()
            .unwrap();
        assert!(output.status.success(), "{output:?}");
        let pixels = read_png(&out).pixels;
        assert!(pixels == wanted, "{name}, {camera}");
        // All of it is seen: nothing is at the border, and it isn't lost in the middle.
        let lit = |x: usize, y: usize| pixels[80 * y + x] > 0;
        let is_at_border = (0..80).any(|x| lit(x, 0) || lit(x, 59));
        assert!(!is_at_border && (0..60).filter(|y| (0..80).any(|x| lit(x, *y))).count() > 20);
    }
}

#[test]
fn a_file_is_rendered_in_its_number_type() {
    is_rendered::<f32>("file-f32");
    is_rendered::<f64>("file-f64");
    is_rendered::<I16F16>("file-i16f16");
}

#[test]
fn a_file_moves_in_all_ways() {
    let path = file::<I16F16>("moves.scene");
    for path_of in ["turn", "orbit"] {
        for (camera, shade) in [("ortho", "depth"), ("persp", "xray")] {
            let out = scratch(&format!("moves-{path_of}-{camera}.png"));
            let output = example("stream")
                .args(["--scene", path.to_str().unwrap(), "--size", "48x36", "--frames", "3"])
                .args(["--path", path_of, "--camera", camera, "--shade", shade])
                .args(["--format", "rgb565", "--out", out.to_str().unwrap()])
                .output()
                .unwrap();
            assert!(output.status.success(), "{output:?}");
            let png = read_png(&out);
            assert_eq!(png.frames, 3);
            assert!(png.pixels.iter().any(|level| *level > 0));
        }
    }
}

#[test]
fn a_file_that_is_none_says_what_is_wrong() {
    let written = |name: &str, bytes: &[u8]| {
        fs::write(scratch(name), bytes).unwrap();
        scratch(name).to_str().unwrap().to_owned()
    };
    let mut buffer = [0; 1024];
    let good = tee::<f32>().unwrap().to_bytes(&mut buffer).unwrap().to_vec();
    let with = |index: usize, byte: u8| {
        let mut bytes = good.clone();
        bytes[index] = byte;
        bytes
    };
    let half_space = HalfSpace::<f32>::new(vec3(0.0, 0.0, 1.0), 0.0).unwrap();
    let endless = Program::<HalfSpace<f32>, 1>::new(half_space);
    let mut buffer = [0; 64];
    let cases: [(String, &[&str], &str); 8] = [
        ("nonesuch".into(), &[], "neither a scene nor a file; the scenes are\n  tee, pipe"),
        (written("empty.scene", &[]), &[], "no program"),
        (written("text.scene", b"cube([1, 2, 3]);"), &[], "no program"),
        (written("version.scene", &with(2, 99)), &[], "another version"),
        (written("i12f20.scene", &with(3, 20)), &[], "I12F20"),
        (written("cut.scene", &good[..50]), &[], "too early"),
        (written("good.scene", &good), &["--number", "i16f16"], "is in f32"),
        (written("endless.scene", endless.to_bytes(&mut buffer).unwrap()), &[], "no end"),
    ];
    for (scene, more, hint) in cases {
        let out = scratch("none.png");
        let output = example("stream")
            .args(["--scene", &scene, "--out", out.to_str().unwrap()])
            .args(more)
            .output()
            .unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success(), "{scene}");
        assert!(message.contains(hint) && !message.contains("panicked"), "{scene}: {message}");
    }
}

const SIZE: [u16; 2] = [48, 36];
const CAPACITY: usize = packet_capacity(SIZE[0], PixelFormat::Gray8);

/// A device that takes parts and sends their pictures, as long as the tool runs.
struct Device {
    port: Pty,
    sender: Sender<Plain, CAPACITY>,
    /// Frames that it doesn't end: it is reset instead.
    resets: u8,
    pictures: u16,
}

impl Device {
    fn new(resets: u8) -> Self {
        let sender = Sender::new(Plain, Patience { ticks: 500, silences: 20 });
        Self { port: Pty::new(), sender, resets, pictures: 0 }
    }

    fn run(&mut self, tool: &mut Guarded) {
        let mut memory = [0; 512];
        let mut inbox = Inbox::new(&mut memory, 32);
        while tool.is_running() {
            for byte in self.port.read() {
                if !inbox.receive(byte) {
                    continue;
                }
                match Program::<Part<f32>, 16>::from_bytes(inbox.bytes()) {
                    Ok(part) => self.show(tool, &part),
                    Err(error) => inbox.refuse(error.into()),
                }
            }
            while let Some(answer) = inbox.answer() {
                let answer = answer.to_vec();
                self.port.write(tool, &answer);
            }
        }
    }

    fn show(&mut self, tool: &mut Guarded, part: &Program<Part<f32>, 16>) {
        let [width, height] = SIZE;
        let camera = Fit::of(&part.bounds()).unwrap().orthographic(None).unwrap();
        let light = Lambert::new(Fit::to_light(), f32::hundredths(15)).unwrap();
        let size = Size::new(width, height).unwrap();
        let mut picture = Picture::new(part, &camera, size, light, Gray8(0));
        let (format, palette) = (PixelFormat::Gray8, scancsg::render::Palette::EMPTY);
        let header = scancsg::stream::FrameHeader { frame: 0, width, height, format, palette };
        self.sender.begin(header).unwrap();
        let start = Instant::now();
        while tool.is_running() {
            let now = start.elapsed().as_millis() as u32;
            let mut row = [Gray8(0); SIZE[0] as usize];
            match self.sender.poll(now) {
                Task::Send(packet) => {
                    let packet = packet.to_vec();
                    self.port.write(tool, &packet);
                    self.sender.sent(now);
                }
                Task::Row(20) if self.resets > 0 => {
                    self.resets -= 1;
                    return;
                }
                Task::Row(y) => {
                    picture.render(y, &mut row).unwrap();
                    self.sender.row(y, &row).unwrap();
                }
                Task::Listen(_) => {
                    let heard = self.port.read();
                    heard.iter().for_each(|byte| self.sender.receive(*byte, now));
                }
                Task::Done(Delivery::Acknowledged { .. }) => {
                    self.pictures += 1;
                    return;
                }
                Task::Done(_) => return,
            }
        }
    }
}

fn view(device: &Device, part: &std::path::Path, out: &std::path::Path) -> Guarded {
    let arguments = ["--port", &device.port.name, "--baud", "921600", "--wait", "6", "--send"];
    let (part, out) = (part.to_str().unwrap(), out.to_str().unwrap());
    Guarded::spawn(example("view").args(arguments).args([part, "--out", out]))
}

/// Also if the device is reset in the middle of its picture.
#[test]
fn view_sends_a_part_and_receives_its_picture() {
    let path = file::<f32>("sent.scene");
    let camera = Fit::of(&tee::<f32>().unwrap().bounds()).unwrap().orthographic(None).unwrap();
    let wanted = levels(&camera, Size::new(SIZE[0], SIZE[1]).unwrap());
    let (path, wanted) = (&path, &wanted);
    at_once([0, 1], |resets| {
        let mut device = Device::new(resets);
        let out = scratch(&format!("sent-{resets}.png"));
        let mut view = view(&device, path, &out);
        device.run(&mut view);
        let output = view.end();
        assert!(output.status.success(), "{output:?}");
        assert_eq!((device.resets, device.pictures), (0, 1));
        assert!(read_png(&out).pixels == *wanted);
    });
}

#[test]
fn view_says_why_a_part_is_refused() {
    let foreign = file::<I16F16>("foreign.scene");
    let long = scratch("long.scene");
    fs::write(&long, [0; 513]).unwrap();
    let number = format!("{}. It takes up to 512 bytes, in f32", Refusal::Number);
    let cases = [(&foreign, number.as_str()), (&long, "longer than the device has room for")];
    for (path, hint) in cases {
        let mut device = Device::new(0);
        let mut view = view(&device, path, &scratch("refused.png"));
        device.run(&mut view);
        let output = view.end();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains(hint), "{message}");
    }
}

#[test]
fn view_says_what_is_wrong_with_sending() {
    for (arguments, code, hint) in [
        (&["--send", "/nonexistent/part.scene", "--port", "/nonexistent/tty"][..], 1, "part.scene"),
        (&["--send", "a", "--replay", "b"], 2, "--replay"),
        (&["--send", "a", "--frames", "2"], 2, "--frames"),
    ] {
        let output = example("view").args(arguments).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{message}");
        assert!(message.contains(hint), "{message}");
    }
}

/// Ctrl-C while nobody answers.
#[test]
fn view_stops_sending() {
    let mut port = Pty::new();
    let path = file::<f32>("stopped.scene");
    let arguments = ["--port", &port.name, "--send", path.to_str().unwrap()];
    let mut view = Guarded::spawn(example("view").args(arguments));
    while view.is_running() && port.read().is_empty() {
        std::thread::sleep(Duration::from_millis(5));
    }
    view.interrupt();
    let output = view.end();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success() && message.contains("stopped"), "{message}");
}
