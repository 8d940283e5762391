//! Saves frames while they come.

use crate::args::Args;
use crate::host::film::Film;
use crate::host::image::png;
use crate::host::receive::Frame;
use std::fs;
use std::path::{Path, PathBuf};

/// The file that is written if no other one is wanted.
const DEFAULT: &str = "view.png";

/// Where frames go.
pub struct Saver {
    film: Option<Film>,
    series: Option<PathBuf>,
    /// Frames that were saved.
    count: u32,
}

impl Saver {
    pub fn new(args: &Args) -> Result<Self, String> {
        let is_elsewhere = args.series.is_some() || args.record.is_some();
        let out = args.out.as_deref().or((!is_elsewhere).then_some(Path::new(DEFAULT)));
        if let Some(directory) = &args.series {
            fs::create_dir_all(directory)
                .map_err(|error| format!("can't make {}: {error}", directory.display()))?;
        }
        Ok(Self { film: out.map(Film::new), series: args.series.clone(), count: 0 })
    }

    /// Saves a frame: it is in the files when this returns.
    pub fn save(&mut self, frame: &Frame) -> Result<(), String> {
        self.count += 1;
        if let Some(directory) = &self.series {
            let path = directory.join(format!("{:05}.png", self.count));
            fs::write(&path, png(frame)?)
                .map_err(|error| format!("can't write {}: {error}", path.display()))?;
        }
        self.film.as_mut().map_or(Ok(()), |film| film.push(frame))
    }

    /// How many frames were saved.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Where they are.
    pub fn places(&self) -> Vec<String> {
        let films = self.film.iter().flat_map(Film::files);
        let places = films.map(|path| path.display().to_string());
        let series = self.series.iter().filter(|_| self.count > 0);
        places.chain(series.map(|path| path.display().to_string())).collect()
    }
}
