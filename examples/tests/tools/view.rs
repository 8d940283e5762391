//! The receiver `view` as a user runs it, with a device at the other end of a pseudo-terminal.

#![cfg(unix)]

use super::common::{Guarded, Png, Pty, at_once, example, read_png, scratch};
use scancsg::render::{Gray8, Palette};
use scancsg::stream::{
    CONTROL_CAPACITY, Decoder, FrameHash, FrameHeader, Packet, PixelFormat, RowHash, encode_end,
    encode_header, encode_row, packet_capacity,
};
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::time::{Duration, Instant};

/// A frame of a device: Gray8, and different for each id and size.
struct Frame {
    id: u16,
    width: u16,
    height: u16,
}

impl Frame {
    const fn new(id: u16, width: u16, height: u16) -> Self {
        Self { id, width, height }
    }

    fn row(&self, y: u16) -> Vec<Gray8> {
        (0..self.width).map(|x| Gray8((x * 3 + y * 7 + self.id * 31 + self.width) as u8)).collect()
    }

    fn levels(&self) -> Vec<u8> {
        (0..self.height).flat_map(|y| self.row(y)).map(|pixel| pixel.0).collect()
    }

    fn header(&self) -> Vec<u8> {
        let Self { id: frame, width, height } = *self;
        let (format, palette) = (PixelFormat::Gray8, Palette::EMPTY);
        packet(|buffer| {
            encode_header(FrameHeader { frame, width, height, format, palette }, buffer).unwrap()
        })
    }

    /// The packets of the first rows.
    fn rows(&self, count: u16) -> Vec<u8> {
        let row = |y| packet(|buffer| encode_row(self.id, y, &self.row(y), buffer).unwrap());
        (0..count).flat_map(row).collect()
    }

    fn end(&self) -> Vec<u8> {
        let mut hash = FrameHash::new();
        (0..self.height).for_each(|y| hash.add(RowHash::of(y, &self.row(y))));
        packet(|buffer| encode_end(self.id, hash, buffer).unwrap())
    }

    fn all(&self) -> Vec<u8> {
        [self.header(), self.rows(self.height), self.end()].concat()
    }

    #[track_caller]
    fn is_in(&self, png: &Png) {
        let size = (u32::from(self.width), u32::from(self.height));
        assert_eq!((png.width, png.height), size);
        assert!(png.pixels == self.levels(), "these are not the pixels of frame {}", self.id);
    }
}

fn packet(encode: impl FnOnce(&mut [u8]) -> usize) -> Vec<u8> {
    let mut buffer = vec![0; packet_capacity(320, PixelFormat::Gray8)];
    let length = encode(&mut buffer);
    buffer.truncate(length);
    buffer
}

/// A device that can't repair: it sends the same again and again until it is answered.
struct Device {
    port: Pty,
    decoder: Decoder<CONTROL_CAPACITY>,
}

impl Device {
    fn new() -> Self {
        Self { port: Pty::new(), decoder: Decoder::new() }
    }

    fn name(&self) -> &str {
        &self.port.name
    }

    /// What is answered, up to the answer that is wanted, or until there is a pause.
    fn answers(&mut self, is_wanted: impl Fn(&Packet<'_>) -> bool) -> Vec<Packet<'static>> {
        let (mut answers, mut since) = (Vec::new(), Instant::now());
        while since.elapsed() < PAUSE && !answers.iter().any(&is_wanted) {
            let bytes = self.port.read();
            let mut bytes = bytes.as_slice();
            while let Some(packet) = self.decoder.feed(&mut bytes) {
                match packet {
                    Ok(Packet::Ack { frame }) => answers.push(Packet::Ack { frame }),
                    Ok(Packet::Request(request)) => answers.push(Packet::Request(request)),
                    _ => continue,
                }
                since = Instant::now();
            }
        }
        answers
    }

    /// Whether this frame is acknowledged.
    fn is_acknowledged(&mut self, frame: u16) -> bool {
        let ack = Packet::Ack { frame };
        self.answers(|answer| *answer == ack).contains(&ack)
    }

    /// Sends bytes until they are answered as they should be.
    fn until(&mut self, view: &mut Guarded, bytes: &[u8], is_right: impl Fn(&Packet<'_>) -> bool) {
        let start = Instant::now();
        loop {
            self.port.write(view, bytes);
            if self.answers(&is_right).iter().any(&is_right) || !view.is_running() {
                return;
            }
            assert!(start.elapsed() < Duration::from_secs(60), "no answer");
        }
    }

    /// Sends a frame until it is acknowledged.
    fn deliver(&mut self, view: &mut Guarded, frame: &Frame) {
        let id = frame.id;
        self.until(view, &frame.all(), |answer| *answer == Packet::Ack { frame: id });
    }

    /// Sends the first rows of a frame until the others are asked for.
    fn deliver_part(&mut self, view: &mut Guarded, frame: &Frame, rows: u16) {
        let part = [frame.header(), frame.rows(rows)].concat();
        self.until(view, &part, |answer| matches!(answer, Packet::Request(_)));
    }
}

/// Longer than the receiver waits until it asks for more.
const PAUSE: Duration = Duration::from_millis(600);

fn view(device: &str, arguments: &[&str]) -> Guarded {
    Guarded::spawn(example("view").args(["--port", device]).args(arguments))
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// A directory of this test's own, empty.
fn directory(name: &str) -> std::path::PathBuf {
    let path = scratch(name);
    let _ = fs::remove_dir_all(&path);
    path
}

#[track_caller]
fn ends(view: Guarded, code: i32) -> String {
    let output = view.end();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{message}");
    message
}

const FRAMES: [Frame; 3] = [Frame::new(1, 48, 36), Frame::new(2, 48, 36), Frame::new(3, 48, 36)];

#[test]
fn a_frame_is_received_and_saved() {
    let (mut device, out) = (Device::new(), scratch("view.png"));
    let mut view = view(device.name(), &["--out", text(&out), "--frames", "1"]);
    device.deliver(&mut view, &FRAMES[0]);
    ends(view, 0);
    FRAMES[0].is_in(&read_png(&out));
}

#[test]
fn ctrl_c_ends_it_with_everything_saved() {
    let (mut device, out, series) = (Device::new(), scratch("film.png"), directory("series"));
    let mut view = view(device.name(), &["--out", text(&out), "--series", text(&series)]);
    for (count, frame) in (1..).zip(&FRAMES) {
        device.deliver(&mut view, frame);
        // After each frame, the animation is whole.
        has_frames(&out, count);
        FRAMES[0].is_in(&read_png(&out));
    }
    view.interrupt();
    ends(view, 0);
    let mut files: Vec<_> =
        fs::read_dir(series).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert_eq!(files.len(), 3);
    files.iter().zip(&FRAMES).for_each(|(file, frame)| frame.is_in(&read_png(file)));
    assert_eq!(all_frames(&out), FRAMES.each_ref().map(Frame::levels));
}

/// Waits until a picture has so many frames: a frame is acknowledged before it is saved.
fn has_frames(path: &Path, count: usize) {
    let start = Instant::now();
    while read_frames(path).is_none_or(|frames| frames.len() != count) {
        assert!(start.elapsed() < Duration::from_secs(60), "not {count} frames");
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// All frames of an animation.
fn all_frames(path: &Path) -> Vec<Vec<u8>> {
    read_frames(path).unwrap()
}

/// All frames of a picture, if it is whole.
fn read_frames(path: &Path) -> Option<Vec<Vec<u8>>> {
    let file = BufReader::new(fs::File::open(path).ok()?);
    let mut reader = png::Decoder::new(file).read_info().ok()?;
    let count = reader.info().animation_control.map_or(1, |animation| animation.num_frames);
    let mut frame = || {
        let mut pixels = vec![0; reader.output_buffer_size()?];
        let size = reader.next_frame(&mut pixels).ok()?.buffer_size();
        pixels.truncate(size);
        Some(pixels)
    };
    (0..count).map(|_| frame()).collect()
}

#[test]
fn a_repeated_end_is_acknowledged_and_not_saved_again() {
    let (mut device, series) = (Device::new(), directory("repeated"));
    let mut view = view(device.name(), &["--series", text(&series), "--frames", "3"]);
    for frame in &FRAMES {
        device.deliver(&mut view, frame);
        for _ in 0..3 {
            device.port.write(&mut view, &frame.end());
            let is_acknowledged = device.is_acknowledged(frame.id);
            // After the last one it listens a little longer.
            assert!(is_acknowledged || frame.id == 3, "frame {}", frame.id);
        }
    }
    ends(view, 0);
    assert_eq!(fs::read_dir(&series).unwrap().count(), 3);
    for (number, frame) in (1..).zip(&FRAMES) {
        frame.is_in(&read_png(&series.join(format!("{number:05}.png"))));
    }
}

/// A device that was reset sends the same number, but of another size.
#[test]
fn a_reset_device_begins_a_new_frame() {
    at_once([(60, 60), (48, 36), (100, 80)], |(width, height)| {
        let (mut device, out) = (Device::new(), scratch(&format!("reset-{width}.png")));
        let mut view = view(device.name(), &["--out", text(&out), "--frames", "1"]);
        let (before, after) = (Frame::new(0, 80, 60), Frame::new(0, width, height));
        device.deliver_part(&mut view, &before, 20);
        device.deliver(&mut view, &after);
        let message = ends(view, 0);
        assert!(message.contains("the device began it again"), "{message}");
        after.is_in(&read_png(&out));
    });
}

#[test]
fn garbage_ends_and_is_called_so() {
    let mut device = Device::new();
    let out = scratch("garbage.png");
    let mut view = view(device.name(), &["--wait", "3", "--out", text(&out)]);
    let mut state = 1_u32;
    while view.is_running() {
        let mut byte = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        };
        let bytes: Vec<u8> = (0..64).map(|_| byte()).collect();
        device.port.write(&mut view, &bytes);
        device.port.read();
    }
    let message = ends(view, 4);
    assert!(message.contains("bytes, but no packet: wrong baud rate?"), "{message}");
    assert!(!out.exists());
}

#[test]
fn silence_ends() {
    let device = Device::new();
    let message = ends(view(device.name(), &["--wait", "1"]), 4);
    assert!(message.contains("nothing of a frame came for 1 s"), "{message}");
}

/// What has come of a frame is saved, and what is missing is named: if the sender stops, if the port
/// vanishes, and at ctrl-C.
#[test]
fn a_frame_that_breaks_off_is_saved_in_part() {
    let cases = [
        ("silent", "the sender fell silent; missing rows: 20-35"),
        ("closed", "the line closed in the middle of it; missing rows: 20-35"),
        ("stopped", "stopped in the middle of it; missing rows: 20-35"),
    ];
    at_once(cases, |(way, hint)| {
        let (mut device, out) = (Device::new(), scratch(&format!("{way}.png")));
        let mut view = view(device.name(), &["--out", text(&out), "--frames", "1", "--wait", "4"]);
        let frame = &FRAMES[0];
        device.deliver_part(&mut view, frame, 20);
        match way {
            "closed" => drop(device),
            "stopped" => view.interrupt(),
            _ => {}
        }
        let message = ends(view, 3);
        assert!(message.contains(hint), "{message}");
        let png = read_png(&out);
        let (here, missing) = png.pixels.split_at(20 * 48);
        assert_eq!(here, frame.levels().get(..20 * 48).unwrap());
        assert!(missing.iter().all(|level| *level == 0));
    });
}

#[test]
fn a_port_that_vanishes_is_opened_again() {
    let (link, series) = (scratch("device"), directory("vanished"));
    let connect = |device: &Device| {
        let _ = fs::remove_file(&link);
        std::os::unix::fs::symlink(device.name(), &link).unwrap();
    };
    let mut device = Device::new();
    connect(&device);
    let mut view = view(text(&link), &["--series", text(&series)]);
    device.deliver(&mut view, &FRAMES[0]);
    drop(device);
    let mut device = Device::new();
    connect(&device);
    device.deliver(&mut view, &FRAMES[1]);
    view.interrupt();
    let message = ends(view, 0);
    assert!(message.contains("is back"), "{message}");
    assert_eq!(fs::read_dir(&series).unwrap().count(), 2);
    FRAMES[1].is_in(&read_png(&series.join("00002.png")));
}

#[test]
fn a_recording_gives_the_same_pictures() {
    let (mut device, out, again) = (Device::new(), scratch("live.png"), scratch("again.png"));
    let recording = scratch("line.bin");
    let record = ["--record", text(&recording), "--frames", "3"];
    let mut view = view(device.name(), &[&record[..], &["--out", text(&out)]].concat());
    for frame in &FRAMES {
        // A damaged packet is in it too.
        device.port.write(&mut view, &[frame.header(), b"\x03abc\0".to_vec()].concat());
        device.deliver(&mut view, frame);
    }
    ends(view, 0);
    let replay = ["--replay", text(&recording), "--out", text(&again)];
    ends(Guarded::spawn(example("view").args(replay)), 0);
    assert_eq!(fs::read(&again).unwrap(), fs::read(&out).unwrap());
    assert_eq!(all_frames(&again), FRAMES.each_ref().map(Frame::levels));
    // Part of it is part of the frames.
    fs::write(&recording, fs::read(&recording).unwrap().split_last_chunk::<200>().unwrap().0)
        .unwrap();
    let replay = [&replay[..], &["--frames", "3"]].concat();
    let message = ends(Guarded::spawn(example("view").args(replay)), 3);
    assert!(message.contains("only 2 of 3 frames"), "{message}");
}

#[test]
fn frames_of_another_size_are_in_a_file_of_their_own() {
    let (mut device, out) = (Device::new(), scratch("sizes.png"));
    let mut view = view(device.name(), &["--out", text(&out), "--frames", "4"]);
    let frames = [(48, 36), (48, 36), (20, 30), (48, 36)];
    let frames = [1, 2, 3, 4].map(|id| {
        let (width, height) = frames[usize::from(id) - 1];
        Frame::new(id, width, height)
    });
    frames.iter().for_each(|frame| device.deliver(&mut view, frame));
    ends(view, 0);
    assert_eq!(all_frames(&out), [&frames[0], &frames[1]].map(Frame::levels));
    frames[2].is_in(&read_png(&scratch("sizes-2.png")));
    frames[3].is_in(&read_png(&scratch("sizes-3.png")));
}

/// What is too large is refused, said, and no reason to end.
#[test]
fn a_frame_that_is_too_large_is_refused() {
    let (mut device, out) = (Device::new(), scratch("fits.png"));
    let mut view = view(device.name(), &["--out", text(&out), "--frames", "1"]);
    for _ in 0..3 {
        device.port.write(&mut view, &Frame::new(9, 48, 60_000).header());
        device.answers(|_| false);
    }
    device.deliver(&mut view, &FRAMES[0]);
    let message = ends(view, 0);
    assert!(message.contains("refused: frame does not fit"), "{message}");
    FRAMES[0].is_in(&read_png(&out));
}

/// The header of a frame of 4×3 pixels in version 1 of the protocol.
const VERSION_1: &[u8] = &[
    0x00, 0x04, 0x01, 0x01, 0x05, 0x02, 0x04, 0x02, 0x03, 0x01, 0x05, 0x4D, 0x37, 0x26, 0x98, 0x00,
];

#[test]
fn another_version_is_refused_by_name() {
    let directory = directory("version");
    fs::create_dir_all(&directory).unwrap();
    let recording = directory.join("line.bin");
    fs::write(&recording, [VERSION_1, &Frame::new(5, 4, 3).rows(3)].concat()).unwrap();
    let never = directory.join("never.png");
    let replay = ["--replay", text(&recording), "--out", text(&never)];
    let message = ends(Guarded::spawn(example("view").args(replay)), 1);
    assert!(message.contains("another version"), "{message}");
}

#[test]
fn a_recording_is_not_overwritten_by_its_replay() {
    let directory = directory("same_file");
    fs::create_dir_all(&directory).unwrap();
    let recording = directory.join("line.bin");
    let line = Frame::new(5, 4, 3).all();
    fs::write(&recording, &line).unwrap();
    let same = ["--replay", text(&recording), "--record", text(&recording)];
    let message = ends(Guarded::spawn(example("view").args(same)), 1);
    assert!(message.contains("at once"), "{message}");
    assert_eq!(fs::read(&recording).unwrap(), line);
}

#[test]
fn view_receives_what_stream_sends() {
    let [noisy, clean] = ["noisy-line.png", "clean-line.png"].map(scratch);
    let frames = ["--frames", "3", "--size", "48x36", "--format", "rgb565"];
    let arguments = [&frames[..], &["--out", text(&clean)]].concat();
    assert!(Guarded::spawn(example("stream").args(arguments)).end().status.success());

    let (mut near, mut far) = (Pty::new(), Pty::new());
    let mut view = view(&near.name, &["--frames", "3", "--out", text(&noisy)]);
    let arguments = [&frames[..], &["--noise", "0.01", "--port", &far.name]].concat();
    let mut stream = Guarded::spawn(example("stream").args(arguments));
    while view.is_running() || stream.is_running() {
        near.write(&mut view, &far.read());
        far.write(&mut stream, &near.read());
    }
    ends(view, 0);
    ends(stream, 0);
    assert_eq!(fs::read(noisy).unwrap(), fs::read(clean).unwrap());
}

/// Web pages get the line's bytes, and their answers go to the device; pages of other hosts don't.
#[test]
fn web_pages_are_served() {
    use tungstenite::{Message, client::IntoClientRequest};
    let (mut device, out) = (Device::new(), scratch("served.png"));
    let arguments = ["--serve", "127.0.0.1:0", "--frames", "1", "--out", text(&out)];
    let mut view = view(device.name(), &arguments);
    let mut said = BufReader::new(view.child().stderr.take().unwrap()).lines();
    let line = said.next().unwrap().unwrap();
    let address = line.strip_prefix("serving ").unwrap();

    let mut request = address.into_client_request().unwrap();
    request.headers_mut().insert("Origin", "https://example.org".parse().unwrap());
    assert!(tungstenite::connect(request).is_err());
    let mut request = address.into_client_request().unwrap();
    request.headers_mut().insert("Origin", "null".parse().unwrap());
    let (mut page, _) = tungstenite::connect(request).unwrap();

    page.send(Message::binary(&b"from a page\0"[..])).unwrap();
    let mut heard = Vec::new();
    let start = Instant::now();
    while !heard.ends_with(b"from a page\0") {
        assert!(start.elapsed() < Duration::from_secs(60), "{heard:?}");
        heard.extend(device.port.read());
    }
    let frame = &FRAMES[0];
    device.deliver(&mut view, frame);
    let mut bytes = Vec::new();
    while let Ok(Message::Binary(more)) = page.read() {
        bytes.extend_from_slice(&more);
    }
    assert!(bytes.windows(frame.all().len()).any(|window| window == frame.all()));
    ends(view, 0);
    frame.is_in(&read_png(&out));
}

#[test]
fn wrong_options_say_what_is_wrong() {
    for (arguments, code, hint) in [
        (&["--port", "/nonexistent/tty"][..], 1, "/nonexistent/tty"),
        (&["--replay", "/nonexistent/line.bin"], 1, "/nonexistent/line.bin"),
        (&["--port", "a", "--replay", "b"], 2, "--replay"),
        (&["--frames", "0"], 2, "--frames"),
        (&["--baud", "9"], 2, "--baud"),
        (&["--serve", "here"], 2, "--serve"),
    ] {
        let message = ends(Guarded::spawn(example("view").args(arguments)), code);
        assert!(message.contains(hint) && !message.contains("panicked"), "{message}");
    }
    ends(Guarded::spawn(example("view").arg("--list")), 0);
}
