//! References on disk: a line of numbers in `volumes.txt`, and a silhouette as a PNG file of one bit a pixel.

use super::SIZE;
use scancsg_scad::map::Vector;
use std::fs::{self, File};
use std::io::{BufReader, BufWriter};
use std::path::{Path, PathBuf};

/// What OpenSCAD makes of a part.
pub struct Reference {
    pub volume: f64,
    /// What is in the middle of the picture.
    pub target: Vector,
    /// How many units the picture is high.
    pub height: f64,
    pub silhouette: Vec<bool>,
}

/// The crate's own parts.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/parts")
}

impl Reference {
    /// The line of `volumes.txt`.
    pub fn line(&self, name: &str) -> String {
        let [x, y, z] = self.target.to_array();
        format!("{name} {} {x} {y} {z} {}", self.volume, self.height)
    }

    pub fn read(name: &str) -> Option<Self> {
        let table = fs::read_to_string(folder().join("volumes.txt")).ok()?;
        let line = table.lines().find(|line| line.split(' ').next() == Some(name))?;
        let numbers: Option<Vec<f64>> =
            line.split(' ').skip(1).map(|part| part.parse().ok()).collect();
        let [volume, x, y, z, height] = numbers?.try_into().ok()?;
        let silhouette = read_bits(&folder().join(format!("{name}.png")))?;
        Some(Self { volume, target: Vector::new(x, y, z), height, silhouette })
    }

    pub fn write_silhouette(&self, name: &str) -> Result<(), png::EncodingError> {
        let file = File::create(folder().join(format!("{name}.png")))?;
        let mut encoder = png::Encoder::new(BufWriter::new(file), SIZE[0].into(), SIZE[1].into());
        encoder.set_color(png::ColorType::Grayscale);
        encoder.set_depth(png::BitDepth::One);
        encoder.set_compression(png::Compression::High);
        let byte = |bits: &[bool]| bits.iter().fold(0, |byte, bit| byte << 1 | u8::from(*bit));
        let bytes: Vec<u8> = self.silhouette.chunks(8).map(byte).collect();
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&bytes)?;
        writer.finish()
    }
}

fn read_bits(path: &Path) -> Option<Vec<bool>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?)).read_info().ok()?;
    let mut bytes = vec![0; reader.output_buffer_size()?];
    reader.next_frame(&mut bytes).ok()?;
    let bits = |byte: &u8| (0..8).rev().map(|bit| byte >> bit & 1 == 1).collect::<Vec<_>>();
    let bits: Vec<bool> = bytes.iter().flat_map(bits).collect();
    (bits.len() == usize::from(SIZE[0]) * usize::from(SIZE[1])).then_some(bits)
}
