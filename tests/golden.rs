//! Golden pictures: `tee`, `pipe` and `plate` as text art that a reader can judge, and a hash for every row of a
//! larger picture that pins down each bit of `f32` and of `I16F16`.
//!
//! Run with `SCANCSG_BLESS=1` to write the files anew, and then look at the difference before
//! it is committed: a picture that changed is either a bug or news for the changelog.

#![allow(clippy::unwrap_used, clippy::panic)]

#[path = "../examples/scene/mod.rs"]
mod scene;

use scene::Scene;
use scene::pipe::PipeScene;
use scene::plate::PlateScene;

use scancsg::geom::Rays;
use scancsg::render::{
    Camera, Gray8, Lambert, Picture, Shader, Size, SmoothColumn, SmoothPicture, Smoothing, XRay,
};
use scancsg::scalar::{I16F16, Number, Scalar};
use scancsg::solid::{Scan, Solid};
use scancsg::stream::encode_row;
use std::fmt::Write as _;
use std::path::Path;

/// The rows of a part in grey.
fn rows<S, T, C, H>(part: &T, camera: &C, shader: H, width: u16, height: u16) -> Vec<Vec<u8>>
where
    S: Scene,
    T: Solid<Scalar = S> + Scan<C::Rays>,
    C: Camera<Rays: Rays<Scalar = S>>,
    H: Shader<S>,
{
    let size = Size::new(width, height).unwrap();
    let mut picture = Picture::new(part, camera, size, shader, Gray8(0));
    let mut row = vec![Gray8(0); width.into()];
    let render = |y| {
        picture.scanline(y).unwrap().render(&mut row).unwrap();
        row.iter().map(|pixel| pixel.0).collect()
    };
    (0..height).map(render).collect()
}

/// `tee` with edges of 4 × 4 samples a pixel.
fn smooth<S: Scene>(width: u16, height: u16) -> Vec<Vec<u8>> {
    let mut columns = vec![SmoothColumn::EMPTY; usize::from(width) + 1];
    let smoothing = Smoothing::new(Size::new(width, height).unwrap(), 4, &mut columns).unwrap();
    let camera = S::orthographic().unwrap();
    let tee = S::TEE;
    let mut picture = SmoothPicture::new(&tee, &camera, smoothing, lambert::<S>(), Gray8(0));
    let mut row = vec![Gray8(0); width.into()];
    let render = |y| {
        picture.render(y, &mut row).unwrap();
        row.iter().map(|pixel| pixel.0).collect()
    };
    (0..height).map(render).collect()
}

/// One character a pixel, ten shades, background blank.
fn art(rows: &[Vec<u8>]) -> String {
    let shade = |&level: &u8| char::from(b" .:-=+*#%@"[usize::from(level) * 10 / 256]);
    let line = |row: &Vec<u8>| row.iter().map(shade).collect::<String>();
    rows.iter().map(|row| line(row).trim_end().to_owned() + "\n").collect()
}

/// One line a row: its number and the CRC-32/ISO-HDLC of its bytes.
fn hashes(rows: &[Vec<u8>]) -> String {
    let crc = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC);
    rows.iter().enumerate().fold(String::new(), |mut text, (y, row)| {
        writeln!(text, "{y:3} {:08x}", crc.checksum(row)).unwrap();
        text
    })
}

/// Compares with a file of `tests/golden`, and shows the lines that differ.
#[track_caller]
fn golden(name: &str, got: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden").join(name);
    if std::env::var_os("SCANCSG_BLESS").is_some_and(|value| value == "1") {
        std::fs::write(&path, got).unwrap();
        return;
    }
    let want = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    let count = got.lines().count().max(want.lines().count());
    let line = |text: &str, i: usize| text.lines().nth(i).unwrap_or("(no line)").to_owned();
    let differences: String = (0..count)
        .map(|i| (i, line(&want, i), line(got, i)))
        .filter(|(_, want, got)| want != got)
        .map(|(i, want, got)| format!("{:4} want |{want}\n      got |{got}\n", i + 1))
        .collect();
    assert!(
        differences.is_empty() && got == want,
        "not the picture of tests/golden/{name} (SCANCSG_BLESS=1 writes it anew):\n{differences}"
    );
}

/// An ambient light of 1/8, which every number type has exactly.
fn lambert<S: Scene>() -> Lambert<S> {
    let eighth = Wide::<S>::ONE / Wide::<S>::from_int(8);
    Lambert::new(S::TO_LIGHT, S::from_wide(eighth)).unwrap()
}

type Wide<S> = <S as Scalar>::Wide;

fn orthographic<S: Scene>(width: u16, height: u16) -> Vec<Vec<u8>> {
    rows(&S::TEE, &S::orthographic().unwrap(), lambert::<S>(), width, height)
}

fn perspective<S: Scene>(width: u16, height: u16) -> Vec<Vec<u8>> {
    rows(&S::TEE, &S::perspective().unwrap(), lambert::<S>(), width, height)
}

/// Along its curve to 1/128 of a unit.
fn pipe<S: PipeScene>(width: u16, height: u16) -> Vec<Vec<u8>> {
    let tolerance = S::from_wide(Wide::<S>::ONE / Wide::<S>::from_int(128));
    let pipe = S::pipe(tolerance).unwrap();
    rows(&pipe, &S::perspective().unwrap(), lambert::<S>(), width, height)
}

/// With so many holes.
fn plate<S: PlateScene<N>, const N: usize>(width: u16, height: u16) -> Vec<Vec<u8>> {
    rows(&S::PLATE, &S::orthographic().unwrap(), lambert::<S>(), width, height)
}

#[test]
fn lambert_orthographic() {
    golden("tee_lambert_orthographic.txt", &art(&orthographic::<f32>(48, 36)));
}

#[test]
fn lambert_perspective() {
    golden("tee_lambert_perspective.txt", &art(&perspective::<f32>(48, 36)));
}

/// To the eye the number types show the same picture.
#[test]
fn lambert_in_fixed_point() {
    golden("tee_lambert_orthographic.txt", &art(&orthographic::<I16F16>(48, 36)));
    golden("tee_lambert_perspective.txt", &art(&perspective::<I16F16>(48, 36)));
}

#[test]
fn xray_orthographic() {
    let camera = f32::orthographic().unwrap();
    let xray = XRay::new(3.0).unwrap();
    golden("tee_xray_orthographic.txt", &art(&rows(&f32::TEE, &camera, xray, 48, 36)));
}

#[test]
fn smooth_edges() {
    golden("tee_smooth_orthographic.txt", &art(&smooth::<f32>(48, 36)));
    golden("tee_smooth_orthographic.txt", &art(&smooth::<I16F16>(48, 36)));
    golden("tee_smooth_160x120_orthographic.txt", &hashes(&smooth::<f32>(160, 120)));
    golden("tee_smooth_160x120_orthographic_i16f16.txt", &hashes(&smooth::<I16F16>(160, 120)));
}

#[test]
fn row_hashes_orthographic() {
    golden("tee_160x120_orthographic.txt", &hashes(&orthographic::<f32>(160, 120)));
    golden("tee_160x120_orthographic_i16f16.txt", &hashes(&orthographic::<I16F16>(160, 120)));
}

#[test]
fn row_hashes_perspective() {
    golden("tee_160x120_perspective.txt", &hashes(&perspective::<f32>(160, 120)));
    golden("tee_160x120_perspective_i16f16.txt", &hashes(&perspective::<I16F16>(160, 120)));
}

#[test]
fn pipe_in_perspective() {
    golden("pipe_lambert_perspective.txt", &art(&pipe::<f32>(48, 36)));
    golden("pipe_160x120_perspective.txt", &hashes(&pipe::<f32>(160, 120)));
    golden("pipe_160x120_perspective_i16f16.txt", &hashes(&pipe::<I16F16>(160, 120)));
}

#[test]
fn plate_with_sixteen_holes() {
    golden("plate_lambert_orthographic.txt", &art(&plate::<f32, 16>(48, 36)));
    golden("plate_160x120_orthographic.txt", &hashes(&plate::<f32, 16>(160, 120)));
    golden("plate_160x120_orthographic_i16f16.txt", &hashes(&plate::<I16F16, 16>(160, 120)));
}

/// More holes are more primitives, and not more or less to see: figures of `scene::plate`.
#[test]
fn plates_cover_the_same_whatever_the_number_of_holes() {
    let covered = |rows: Vec<Vec<u8>>| rows.iter().flatten().filter(|level| **level > 0).count();
    let counts = [
        plate::<f32, 1>(160, 120),
        plate::<f32, 4>(160, 120),
        plate::<f32, 16>(160, 120),
        plate::<f32, 64>(160, 120),
    ];
    let per_thousand = counts.map(|rows| (covered(rows) * 1000 + 9600) / 19_200);
    assert_eq!(per_thousand, [371, 376, 385, 401]);
}

/// The catalogue's check value: the hash is the one that other tools call CRC-32.
#[test]
fn the_hash_is_crc_32() {
    assert_eq!(hashes(&[b"123456789".to_vec()]), "  0 cbf43926\n");
}

/// A grey pixel goes over the link as the byte that is hashed here.
#[test]
fn the_bytes_are_those_of_the_link() {
    // Behind the framing's code byte and a packet's six bytes, whose zeros are code bytes there.
    let mut packet = [0; 16];
    encode_row(0x0101, 0x0101, &[Gray8(200)], &mut packet).unwrap();
    assert_eq!(packet[7], 200);
}
