//! A PNG file that grows while frames come, and is whole after each of them.
//!
//! One frame is a still picture. Several are an animation (APNG, Portable Network Graphics
//! Specification, third edition, sections 11.3.4 and 4.9), whose first frame is the still picture. Frames
//! of another size or format begin another file.

use super::image::png;
use super::receive::Frame;
use scancsg::stream::FrameHeader;
use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Frames a second of an animation.
const SPEED: u16 = 12;

/// A PNG file's first bytes, and the size of a chunk without its data.
const SIGNATURE: usize = 8;
const CHUNK: usize = 12;
/// The header chunk has 13 bytes of data; `acTL` comes behind it.
const AFTER_HEADER: usize = SIGNATURE + CHUNK + 13;

/// Saves frames as they come.
pub struct Film {
    path: PathBuf,
    /// Files that were written, this one included.
    files: Vec<PathBuf>,
    reel: Option<Reel>,
}

/// The file that is being written.
struct Reel {
    header: FrameHeader,
    frames: u32,
    /// The number of the next chunk of the animation.
    sequence: u32,
    /// The first frame's file, until a second one comes.
    still: Vec<u8>,
    file: File,
}

impl Film {
    pub fn new(path: &Path) -> Self {
        Self { path: path.to_owned(), files: Vec::new(), reel: None }
    }

    /// The files that were written.
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Adds a frame; the file is whole again then.
    pub fn push(&mut self, frame: &Frame) -> Result<(), String> {
        let data = png(frame)?;
        let (path, result) = match &mut self.reel {
            Some(reel) if frame.is_like(&reel.header) => {
                (self.files.last().cloned().unwrap_or_default(), reel.push(frame.header, &data))
            }
            _ => {
                let path = self.next_path();
                let reel = Reel::create(&path, frame.header, data);
                let result = reel.map(|reel| self.reel = Some(reel));
                if result.is_ok() {
                    self.files.push(path.clone());
                }
                (path, result)
            }
        };
        result.map_err(|error| format!("can't write {}: {error}", path.display()))
    }

    /// `part.png`, then `part-2.png`.
    fn next_path(&self) -> PathBuf {
        let count = self.files.len() + 1;
        if count == 1 {
            return self.path.clone();
        }
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        let ending = self.path.extension().unwrap_or_default().to_string_lossy();
        self.path.with_file_name(format!("{stem}-{count}.{ending}"))
    }
}

impl Reel {
    fn create(path: &Path, header: FrameHeader, still: Vec<u8>) -> io::Result<Self> {
        let mut file = File::create(path)?;
        file.write_all(&still)?;
        Ok(Self { header, frames: 1, sequence: 0, still, file })
    }

    fn push(&mut self, header: FrameHeader, png: &[u8]) -> io::Result<()> {
        let mut new = Vec::new();
        if self.frames == 1 {
            let still = std::mem::take(&mut self.still);
            let (start, rest) = still.split_at_checked(AFTER_HEADER).unwrap_or_default();
            self.file.rewind()?;
            self.file.write_all(start)?;
            self.file.write_all(&control(2))?;
            new.extend(self.control_of_frame(header));
            // Up to the end chunk.
            new.extend(rest.get(..rest.len().saturating_sub(CHUNK)).unwrap_or_default());
        } else {
            self.file.seek(SeekFrom::End(-(CHUNK as i64)))?;
        }
        new.extend(self.control_of_frame(header));
        for (kind, data) in chunks(png) {
            if kind == b"IDAT" {
                let number = self.next_number();
                new.extend(chunk(b"fdAT", &[&number, data]));
            }
        }
        new.extend(chunk(b"IEND", &[]));
        self.file.write_all(&new)?;
        self.frames += 1;
        self.file.seek(SeekFrom::Start(AFTER_HEADER as u64))?;
        self.file.write_all(&control(self.frames))
    }

    fn next_number(&mut self) -> [u8; 4] {
        let number = self.sequence;
        self.sequence += 1;
        number.to_be_bytes()
    }

    /// `fcTL`: the frame is as large as the picture, replaces it, and is shown for so long.
    fn control_of_frame(&mut self, header: FrameHeader) -> Vec<u8> {
        let number = self.next_number();
        let size = [header.width, header.height].map(|side| u32::from(side).to_be_bytes());
        let delay = [1_u16, SPEED].map(u16::to_be_bytes);
        chunk(b"fcTL", &[&number, size.as_flattened(), &[0; 8], delay.as_flattened(), &[0; 2]])
    }
}

/// `acTL`: so many frames, again and again.
fn control(frames: u32) -> Vec<u8> {
    chunk(b"acTL", &[&frames.to_be_bytes(), &[0; 4]])
}

fn chunk(kind: &[u8; 4], parts: &[&[u8]]) -> Vec<u8> {
    let data = parts.concat();
    let body = [&kind[..], &data].concat();
    let sum = crc32fast::hash(&body);
    [&(data.len() as u32).to_be_bytes()[..], &body, &sum.to_be_bytes()].concat()
}

/// The kinds and data of a PNG file's chunks.
fn chunks(png: &[u8]) -> impl Iterator<Item = (&[u8], &[u8])> {
    let mut rest = png.get(SIGNATURE..).unwrap_or_default();
    std::iter::from_fn(move || {
        let (length, behind) = rest.split_first_chunk::<4>()?;
        let length = u32::from_be_bytes(*length) as usize;
        let (kind, data) = (behind.get(..4)?, behind.get(4..4 + length)?);
        rest = rest.get(CHUNK + length..)?;
        Some((kind, data))
    })
}
