//! `docs/link.md` says what the code does: its bytes, and its decoder in Python.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::io::Write;
use std::process::{Command, Stdio};

use scancsg::render::{Gray8, Palette, Pixel, Rgb, Rgb565};
use scancsg::stream::{
    Decoder, FrameHash, FrameHeader, Inbox, Part, Patience, PixelFormat, Plain, Predictive,
    Request, RowCoding, RowHash, Sender, Task, Upload, UploadTask, Wire, WirePixel, encode_ack,
    encode_end, encode_header, encode_request, encode_row,
};

const DOCUMENT: &str = include_str!("../../docs/link.md");

/// The block of code with this label.
fn block(label: &str) -> &'static str {
    let start = format!("```{label}\n");
    let (_, rest) = DOCUMENT.split_once(&start).unwrap_or_else(|| panic!("no block {label}"));
    rest.split_once("```").unwrap().0
}

/// The bytes of a block of hexadecimal numbers.
fn bytes(name: &str) -> Vec<u8> {
    let numbers = block(&format!("hex {name}"));
    numbers.split_whitespace().map(|number| u8::from_str_radix(number, 16).unwrap()).collect()
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect::<Vec<_>>().join(" ")
}

/// The document's bytes are these, and a decoder finds one packet in them.
#[track_caller]
fn check(name: &str, encode: impl FnOnce(&mut [u8]) -> usize) {
    let mut buffer = [0; 300];
    let len = encode(&mut buffer);
    assert_eq!(hex(&bytes(name)), hex(&buffer[..len]), "{name}");
    let mut decoder = Decoder::<300>::new();
    let packets = buffer[..len].iter().filter(|byte| decoder.push(**byte).is_some()).count();
    assert_eq!(packets, 1);
}

#[test]
fn packets_are_as_documented() {
    let palette: Palette =
        [Rgb::new(0x96, 0x9B, 0xA0), Rgb::new(0xC8, 0xA0, 0x50)].into_iter().collect();
    let format = PixelFormat::Rgb565;
    let header = FrameHeader { frame: 1, width: 160, height: 120, format, palette };
    check("header", |buffer| encode_header(header, buffer).unwrap());
    let pixels = [1, 2, 3, 4].map(Gray8);
    check("raw", |buffer| encode_row(1, 7, &pixels, buffer).unwrap());
    check("packbits", |buffer| encode_row(1, 8, &[Rgb565(0x1234); 160], buffer).unwrap());
    let mut hash = FrameHash::new();
    hash.add(RowHash::of(0, &pixels));
    hash.add(RowHash::of(1, &pixels));
    check("end", |buffer| encode_end(1, hash, buffer).unwrap());
    let part = Part::Rows { y: 7, count: 2, limit: 127 };
    check("request", |buffer| encode_request(Request { frame: 1, part }, buffer).unwrap());
    check("ack", |buffer| encode_ack(1, buffer).unwrap());
}

/// Both ends of an upload say the document's bytes, one after the other.
#[test]
fn uploads_are_as_documented() {
    let patience = Patience { ticks: 9, silences: 9 };
    let sends = |upload: &mut Upload<'_>| match upload.poll(0) {
        UploadTask::Send(packet) => {
            let packet = hex(packet);
            upload.sent(0);
            packet
        }
        other => panic!("{other:?}"),
    };
    let mut question = Upload::new(&[], patience);
    assert_eq!(sends(&mut question), hex(&bytes("question")));

    let part = [1, 2, 0, 4, 5, 6];
    let mut memory = [0; 1024];
    let mut inbox = Inbox::new(&mut memory, 16);
    assert!(bytes("first_chunk").iter().all(|byte| !inbox.receive(*byte)));
    assert_eq!(inbox.answer().map(hex), Some(hex(&bytes("status"))));

    let mut upload = Upload::new(&part, patience);
    bytes("status").iter().for_each(|byte| upload.receive(*byte, 0));
    assert_eq!(sends(&mut upload), hex(&bytes("chunk")));
    assert!(bytes("chunk").iter().all(|byte| !inbox.receive(*byte)));
    inbox.answer().unwrap().iter().for_each(|byte| upload.receive(*byte, 0));
    assert_eq!(sends(&mut upload), hex(&bytes("hand_over")));
    let given = bytes("hand_over").iter().filter(|byte| inbox.receive(**byte)).count();
    assert_eq!((given, inbox.bytes()), (1, &part[..]));
}

const WIDTH: u16 = 40;
const HEIGHT: u16 = 30;

/// A lit ball on a dark background, with some pixels that no shading makes.
fn ball<P: Pixel>(colors: &[Rgb], other: P) -> Vec<P> {
    let pixel = |x: i32, y: i32| {
        let off = (x - 20).pow(2) + (y - 15).pow(2);
        let color = colors[usize::from(x > y)];
        match off {
            _ if (x + 5 * y) % 97 == 0 => other,
            150.. => P::shaded(color, 0),
            _ => P::shaded(color, (255 - off) as u8),
        }
    };
    let rows = 0..i32::from(HEIGHT);
    rows.flat_map(|y| (0..i32::from(WIDTH)).map(move |x| pixel(x, y))).collect()
}

/// What a sender sends without a way back.
fn line<P: WirePixel>(coding: impl RowCoding<P>, palette: Palette, pixels: &[P]) -> Vec<u8> {
    let mut sender = Sender::<_, 256>::new(coding, Patience { ticks: 1, silences: 0 });
    let format = P::Wire::FORMAT;
    sender.begin(FrameHeader { frame: 9, width: WIDTH, height: HEIGHT, format, palette }).unwrap();
    let mut line = Vec::new();
    loop {
        match sender.poll(0) {
            Task::Send(bytes) => {
                line.extend_from_slice(bytes);
                sender.sent(0);
            }
            Task::Row(y) => {
                let row = pixels.chunks(WIDTH.into()).nth(y.into()).unwrap();
                sender.row(y, row).unwrap();
            }
            Task::Listen(_) => panic!("there is no way back"),
            Task::Done(_) => return line,
        }
    }
}

/// What the document's decoder prints.
fn decoded(line: &[u8]) -> String {
    let docs = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs");
    let mut python = Command::new("python3")
        .args(["-B", "-c", block("python")])
        .env("PYTHONPATH", docs)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("python3 runs the decoder of docs/link.md");
    python.stdin.take().unwrap().write_all(line).unwrap();
    let output = python.wait_with_output().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_decoder_reads_what_the_sender_sends() {
    assert!(block("python").lines().count() <= 42);
    let colors = [Rgb::new(150, 155, 160), Rgb::new(200, 160, 80)];
    let palette: Palette = colors.into_iter().collect();

    let gray = ball(&colors, Gray8(77));
    let levels: Vec<_> = gray.iter().map(|pixel| pixel.0.to_string()).collect();
    let wanted = format!("9 {}\n", levels.join(" "));
    let (rows, packed) = (Predictive::<Gray8, 40>::new(), Plain);
    assert_eq!(decoded(&line(rows, Palette::EMPTY, &gray)), wanted);
    assert_eq!(decoded(&line(packed, Palette::EMPTY, &gray)), wanted);

    let colored = ball(&colors, Rgb565(0xF81F));
    let channels = |pixel: &Rgb565| [pixel.0 >> 11, pixel.0 >> 5 & 63, pixel.0 & 31];
    let numbers: Vec<_> =
        colored.iter().flat_map(channels).map(|channel| channel.to_string()).collect();
    let wanted = format!("9 {}\n", numbers.join(" "));
    assert_eq!(decoded(&line(Predictive::<Rgb565, 40>::new(), palette, &colored)), wanted);
    assert_eq!(decoded(&line(Plain, palette, &colored)), wanted);
}
