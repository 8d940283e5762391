//! The page in a browser: what it shows has the host's bits. `cargo xtask web --test` builds the page and
//! runs these tests, which are ignored otherwise: they need the page and Chromium.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod browser;
mod parts;

use browser::Browser;
use parts::{Noise, SIZE, Shown, canvas, recording, send};
use scancsg::render::{Gray8, Mono, Rgb565, Rgb888};
use scancsg::stream::{Delivery, PixelFormat};
use scancsg_web::draw::{Wish, draw, scenes};
use serde_json::json;
use serialport::{SerialPort, TTYPort};
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::net::TcpListener;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::{self, JoinHandle};
use std::time::Duration;
use tungstenite::{Error, Message};

const FORMATS: [PixelFormat; 4] =
    [PixelFormat::Gray8, PixelFormat::Rgb565, PixelFormat::Rgb888, PixelFormat::Mono];

/// Chooses a picture on the page, and returns what the canvas then shows.
fn drawn(browser: &mut Browser, wish: Wish) -> Vec<u8> {
    let [width, height] = wish.size;
    let steps = (wish.turn * 72.0).round();
    let values = json!({
        "scene": wish.scene, "number": u8::from(wish.is_fixed), "camera": u8::from(wish.is_perspective),
        "format": wish.format.code(), "smooth": wish.smooth, "turn": steps, "width": width,
        "height": height,
    });
    browser.value(&format!(
        "for (const [id, value] of Object.entries({values})) document.getElementById(id).value = value;
        document.querySelector('#scene').dispatchEvent(new Event('input', {{ bubbles: true }}))"
    ));
    browser.wait("document.querySelector('#canvas').ariaBusy === 'false'");
    let (size, pixels) = browser.canvas();
    assert_eq!(size, wish.size);
    pixels
}

const PLAIN: Wish = Wish {
    scene: 0,
    is_fixed: false,
    is_perspective: false,
    format: PixelFormat::Rgb565,
    smooth: 1,
    turn: 0.0,
    size: [64, 48],
};

/// FNV-1a of the colours, as the examples' test of the gallery has it.
fn hash(canvas: &[u8]) -> u32 {
    canvas
        .chunks(4)
        .flat_map(|pixel| &pixel[..3])
        .fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193))
}

#[test]
#[ignore = "needs SCANCSG_PAGE, the page, and Chromium"]
fn the_gallery_has_the_bits_that_it_always_had() {
    let mut browser = Browser::open("golden", "");
    let names: Vec<String> = scenes().into_iter().map(|[name, _]| name).collect();
    let golden = include_str!("../../examples/tests/gallery.txt");
    let mut count = 0;
    for line in golden.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let [scene, camera, float, fixed] = words[..] else { panic!("{line}") };
        let scene = names.iter().position(|name| name == scene).unwrap();
        for (is_fixed, expected) in [(false, float), (true, fixed)] {
            let wish = Wish { scene, is_fixed, is_perspective: camera == "persp", ..PLAIN };
            let pixels = drawn(&mut browser, wish);
            assert_eq!(format!("{:08x}", hash(&pixels)), expected, "{line}");
            count += 1;
        }
    }
    assert_eq!(count, 48);
    browser.close();
}

#[test]
#[ignore = "needs SCANCSG_PAGE, the page, and Chromium"]
fn every_choice_has_the_bits_of_the_host() {
    let mut browser = Browser::open("choices", "");
    let mut different = Vec::new();
    for (index, scene) in [0, 1, 2, 9, 12, 13].into_iter().enumerate() {
        for format in FORMATS {
            let wish = Wish {
                scene,
                is_fixed: index % 2 == 1,
                is_perspective: index % 3 == 1,
                format,
                smooth: [1, 2, 4][index % 3],
                turn: index as f64 / 72.0,
                size: [61 + index as u16, 40],
            };
            let mut expected = vec![0; 4 * usize::from(wish.size[0]) * 40];
            draw(wish, 0, &mut expected).unwrap();
            assert!(drawn(&mut browser, wish) == expected, "{wish:?}");
            different.push(hash(&expected));
        }
    }
    different.sort_unstable();
    different.dedup();
    assert_eq!(different.len(), 24);
    // One that takes the page several slices of time.
    let wish = Wish { scene: 13, smooth: 4, size: [640, 480], ..PLAIN };
    let mut expected = vec![0; 4 * 640 * 480];
    draw(wish, 0, &mut expected).unwrap();
    assert!(drawn(&mut browser, wish) == expected);
    browser.close();
}

/// Waits until so many frames are complete, and looks at the last one.
fn sees_frames<P: Shown>(browser: &mut Browser, count: u16, last: u16) {
    browser.wait(&format!("{} === '{count}'", figure("Frames")));
    let (size, pixels) = browser.canvas();
    assert_eq!(size, SIZE);
    assert!(pixels == canvas::<P>(last), "frame {last}, {:?}", P::FORMAT);
}

fn figure(name: &str) -> String {
    format!("document.querySelector('[data-figure=\"{name}\"]')?.textContent")
}

/// Chooses where pictures come from.
fn choose(browser: &mut Browser, source: &str) {
    browser.value(&format!("document.querySelector('[value={source}]').click()"));
}

/// Gives the page a file, as the user would.
fn play(browser: &mut Browser, name: &str, bytes: &[u8]) {
    let path = browser.folder().join(name);
    std::fs::write(&path, bytes).unwrap();
    let document = browser.call("DOM.getDocument", json!({}));
    let query = json!({ "nodeId": document["root"]["nodeId"], "selector": "#file" });
    let node = browser.call("DOM.querySelector", query);
    let files = json!({ "nodeId": node["nodeId"], "files": [path] });
    browser.call("DOM.setFileInputFiles", files);
}

#[test]
#[ignore = "needs SCANCSG_PAGE, the page, and Chromium"]
fn a_recording_is_played_and_a_picture_is_saved() {
    let mut browser = Browser::open("recording", "");
    choose(&mut browser, "file");
    let says = |text: &str| format!("document.querySelector('#status').textContent === '{text}'");
    play(&mut browser, "frames.bin", &recording::<Rgb565>(0..3));
    browser.wait(&says("The recording ends after 3 complete frames"));
    sees_frames::<Rgb565>(&mut browser, 3, 2);

    let downloads = json!({ "behavior": "allow", "downloadPath": browser.folder() });
    browser.call("Page.setDownloadBehavior", downloads);
    browser.value("document.querySelector('#save').click()");
    let path = browser.folder().join("frame-2.png");
    for _ in 0..500 {
        if path.exists() {
            break;
        }
        thread::sleep(Duration::from_millis(20));
    }
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!([info.width, info.height], SIZE.map(u32::from));
    let has_opacity = info.color_type == png::ColorType::Rgba;
    let expected = canvas::<Rgb565>(2);
    let expected: Vec<u8> = expected
        .chunks(4)
        .flat_map(|pixel| &pixel[..if has_opacity { 4 } else { 3 }])
        .copied()
        .collect();
    assert!(pixels == expected);

    // The same once more: a new line knows nothing of the old one.
    browser.value("document.querySelector('#replay').click()");
    browser.wait(&says("The recording ends after 3 complete frames"));

    // Cut off, and not from its beginning.
    let bytes = recording::<Gray8>(0..2);
    play(&mut browser, "cut.bin", &bytes[100..bytes.len() - 300]);
    browser
        .wait("document.querySelector('#status').textContent.includes('in the middle of frame 1')");
    let missing = browser.value("document.querySelector('#status').textContent");
    assert!(missing.as_str().unwrap().ends_with(" of 40 rows are missing"), "{missing}");

    play(&mut browser, "noise.bin", &[0x55; 4000]);
    browser.wait(&says("The recording ends before a frame began"));
    browser.close();
}

/// Sends frames, with noise on the line, to the first who connects.
fn sender<P: Shown>(listener: TcpListener, frames: u16) -> JoinHandle<Vec<Delivery>> {
    thread::spawn(move || {
        let (stream, _) = listener.accept().unwrap();
        let mut socket = tungstenite::accept(stream).unwrap();
        let mut noise = Noise::default();
        let deliveries = (0..frames).map(|frame| {
            // Both closures need the socket, one after the other.
            let shared = std::cell::RefCell::new((&mut socket, &mut noise));
            let write = |packet: &[u8]| {
                let (socket, noise) = &mut *shared.borrow_mut();
                socket.send(Message::binary(noise.on(packet))).unwrap();
            };
            let listen = |wait: Duration| {
                let (socket, _) = &mut *shared.borrow_mut();
                let wait = wait.max(Duration::from_millis(1));
                socket.get_ref().set_read_timeout(Some(wait)).unwrap();
                match socket.read() {
                    Ok(Message::Binary(bytes)) => bytes.to_vec(),
                    Ok(_) => Vec::new(),
                    Err(Error::Io(error))
                        if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) =>
                    {
                        Vec::new()
                    }
                    Err(error) => panic!("{error}"),
                }
            };
            send::<P>(frame, 100, write, listen)
        });
        let deliveries = deliveries.collect();
        // Until the page closes the connection.
        socket.get_ref().set_read_timeout(None).unwrap();
        while socket.read().is_ok() {}
        deliveries
    })
}

fn receives<P: Shown>(browser: &mut Browser) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    let sender = sender::<P>(listener, 4);
    browser.value(&format!(
        "document.querySelector('#address').value = 'ws://127.0.0.1:{port}/';
        document.querySelector('#open-socket').click()"
    ));
    sees_frames::<P>(browser, 4, 3);
    // So much noise that something must have been repaired.
    browser.wait(&format!("Number({}) > 0", figure("Damaged packets")));
    browser.wait(&format!("Number({}) > 0", figure("Repairs asked for")));
    browser.value("document.querySelector('#open-socket').click()");
    let deliveries = sender.join().unwrap();
    assert!(deliveries.iter().all(|delivery| matches!(delivery, Delivery::Acknowledged { .. })));
    browser.wait("document.querySelector('#open-socket').textContent === 'Connect'");
}

#[test]
#[ignore = "needs SCANCSG_PAGE, the page, and Chromium"]
fn a_websocket_brings_the_pixels_of_the_sender() {
    let mut browser = Browser::open("websocket", "");
    choose(&mut browser, "socket");
    receives::<Gray8>(&mut browser);
    receives::<Rgb565>(&mut browser);
    receives::<Rgb888>(&mut browser);
    receives::<Mono>(&mut browser);
    // Nobody is there.
    browser.value(
        "document.querySelector('#address').value = 'ws://127.0.0.1:1/';
        document.querySelector('#open-socket').click()",
    );
    browser.wait("document.querySelector('#status').textContent.startsWith('Nothing answers')");
    browser.close();
}

/// A serial port whose bytes go through a WebSocket, as there is no device: the browser's streams, and
/// what the page does with them, are the same.
const PORT: &str = "
    Object.defineProperty(navigator, 'serial', { value: { requestPort: async () => {
        const socket = new WebSocket(globalThis.portAddress);
        socket.binaryType = 'arraybuffer';
        const opened = new Promise((done) => socket.onopen = done);
        return {
            async open({ baudRate }) {
                globalThis.portSpeed = baudRate;
                await opened;
                this.writable = new WritableStream({ write: (bytes) => socket.send(bytes) });
                this.readable = new ReadableStream({
                    start: (line) => socket.onmessage = ({ data }) => line.enqueue(new Uint8Array(data)),
                    cancel: () => { this.readable = null; },
                });
            },
            close: async () => socket.close(),
        };
    } } });";

#[test]
#[ignore = "needs SCANCSG_PAGE, the page, and Chromium"]
fn a_serial_port_brings_the_pixels_of_the_sender() {
    let mut browser = Browser::open("serial", PORT);
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    let sender = sender::<Rgb565>(listener, 4);
    choose(&mut browser, "serial");
    browser.value(&format!(
        "globalThis.portAddress = 'ws://127.0.0.1:{port}/';
        document.querySelector('#baud').value = 921600;
        document.querySelector('#open-serial').click()"
    ));
    sees_frames::<Rgb565>(&mut browser, 4, 3);
    assert_eq!(browser.value("globalThis.portSpeed"), json!(921_600));
    browser.value("document.querySelector('#open-serial').click()");
    let deliveries = sender.join().unwrap();
    assert!(deliveries.iter().all(|delivery| matches!(delivery, Delivery::Acknowledged { .. })));
    browser.wait("document.querySelector('#status').textContent.startsWith('You disconnected')");
    browser.close();
}

/// Passes bytes on from one port to another, until one is closed.
fn pass_on(mut from: TTYPort, mut to: TTYPort) {
    thread::spawn(move || {
        let mut buffer = [0; 1024];
        loop {
            match from.read(&mut buffer) {
                Ok(count) => to.write_all(&buffer[..count]).unwrap(),
                Err(error) if error.kind() == ErrorKind::TimedOut => {}
                Err(_) => break,
            }
        }
    });
}

/// A program that ends with the test.
struct Running(Child);

impl Running {
    fn example(name: &str, arguments: &[&str]) -> Self {
        let examples = std::env::var_os("SCANCSG_EXAMPLES").expect("where the examples are");
        let mut command = Command::new(Path::new(&examples).join(name));
        command.args(arguments).stdout(Stdio::null()).stderr(Stdio::piped());
        Self(command.spawn().unwrap())
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
#[ignore = "needs SCANCSG_PAGE, the page, SCANCSG_EXAMPLES, the examples, and Chromium"]
fn view_serves_the_page_what_stream_sends() {
    let [(sender, device), (receiver, port)] = [(), ()].map(|()| TTYPort::pair().unwrap());
    pass_on(sender.try_clone_native().unwrap(), receiver.try_clone_native().unwrap());
    pass_on(receiver, sender);
    let (device_name, port_name) = (device.name().unwrap(), port.name().unwrap());
    let mut browser = Browser::open("view", "");
    let png = browser.folder().join("view.png").display().to_string();
    let view = ["--port", &port_name, "--serve", "127.0.0.1:0", "--frames", "3", "--out", &png];
    let mut view = Running::example("view", &view);
    let said = BufReader::new(view.0.stderr.take().unwrap());
    let mut lines = said.lines().map_while(Result::ok);
    let address = lines.find_map(|line| Some(line.split_once("serving ")?.1.trim().to_owned()));
    let address = address.expect("`view` says its address");
    choose(&mut browser, "socket");
    browser.value(&format!(
        "document.querySelector('#address').value = '{address}';
        document.querySelector('#open-socket').click()"
    ));
    browser.wait("document.querySelector('#status').textContent === 'Waiting for a frame'");

    let arguments = "--scene knob --size 64x48 --format rgb565 --frames 3 --noise 0.001 --port";
    let mut arguments: Vec<&str> = arguments.split(' ').collect();
    arguments.push(&device_name);
    let mut stream = Running::example("stream", &arguments);
    browser.wait(&format!("{} === '3'", figure("Frames")));
    let scene = scenes().iter().position(|[name, _]| name == "knob").unwrap();
    let wish = Wish { scene, turn: 2.0 / 3.0, ..PLAIN };
    let mut expected = vec![0; 4 * 64 * 48];
    draw(wish, 0, &mut expected).unwrap();
    assert!(browser.canvas() == (wish.size, expected));
    assert!(stream.0.wait().unwrap().success());
    // `view` ends with its last frame, and the page says so.
    browser
        .wait("document.querySelector('#status').textContent.includes('after 3 complete frames')");
    assert!(view.0.wait().unwrap().success());
    browser.close();
}
