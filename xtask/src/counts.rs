//! Instructions, counted on a board, and compared with those that are expected.

use crate::board::{Board, Number};
use crate::boot;
use crate::paths::root;
use crate::points::{Splines, digest};
use crate::toolchain::Toolchain;
use scancsg::geom::Vec3;
use scancsg::scalar::I16F16;
use scancsg::spline::Outside;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

/// More than this is worse, in parts of a thousand.
const TOLERANCE: u64 = 30;

pub struct Counts {
    board: Board,
    number: Number,
    version: String,
    /// What was done, and in how many instructions.
    pub entries: Vec<(String, u64)>,
    /// All bits of points of splines.
    points: u64,
}

pub struct Change {
    pub text: String,
    pub is_worse: bool,
}

/// Runs the example `bench` on a board.
pub fn measure(toolchain: &Toolchain, board: Board, number: Number) -> Result<Counts, String> {
    let elf = toolchain.build(board, number, "bench", &[])?;
    let said = boot::listen(board, &elf)?;
    let mut entries: Vec<(String, u64)> = said
        .lines()
        .filter_map(|line| {
            let (name, count) = line.rsplit_once(' ')?;
            Some((name.trim().to_owned(), count.parse().ok()?))
        })
        .collect();
    if entries.is_empty() {
        return Err(format!("{board}: the benchmark said nothing: {said}"));
    }
    let place = entries.iter().position(|(name, _)| name == "points");
    let (_, points) =
        entries.remove(place.ok_or_else(|| format!("{board} said no points: {said}"))?);
    Ok(Counts { board, number, version: toolchain.version.clone(), entries, points })
}

impl Counts {
    pub fn version(&self) -> &str {
        &self.version
    }

    /// What is wrong with what was computed.
    pub fn problem(&self) -> Option<String> {
        fn on_host<S: Splines>() -> u32 {
            let clamp = Outside::Clamp;
            let points = |t| [S::EDITABLE.value(t, clamp), S::BAKED.value(t, clamp)];
            digest(|t| points(t).map(|point| point.unwrap_or(Vec3::ZERO)))
        }
        let want = match self.number {
            Number::F32 => on_host::<f32>(),
            Number::I16f16 => on_host::<I16F16>(),
        };
        (self.points != u64::from(want))
            .then(|| "points of splines differ from the host's".to_owned())
    }

    pub fn of(&self, name: &str) -> Option<u64> {
        self.entries.iter().find(|(entry, _)| entry == name).map(|(_, count)| *count)
    }

    fn path(&self) -> PathBuf {
        root().join("tests/expected").join(format!("{}-{}.txt", self.board, self.number))
    }

    fn text(&self) -> String {
        let mut text = format!("# {}\n", self.version);
        for (name, count) in &self.entries {
            let _ = writeln!(text, "{name} {count}");
        }
        text
    }

    /// Compares with the expected counts, or writes them anew.
    pub fn compare(&self, overwrite: bool) -> Result<Vec<Change>, String> {
        let path = self.path();
        let error = |error: std::io::Error| format!("{}: {error}", path.display());
        if overwrite {
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder).map_err(error)?;
            }
            fs::write(&path, self.text()).map_err(error)?;
            return Ok(Vec::new());
        }
        let expected = fs::read_to_string(&path).map_err(|cause| {
            format!("no counts are expected ({}: {cause}); --overwrite writes them", path.display())
        })?;
        Ok(compare(&expected, &self.version, &self.entries))
    }
}

fn compare(expected: &str, version: &str, entries: &[(String, u64)]) -> Vec<Change> {
    let is_same_compiler = expected.lines().next() == Some(&format!("# {version}"));
    let mut changes = Vec::new();
    let mut known: Vec<(&str, u64)> = expected
        .lines()
        .filter(|line| !line.starts_with('#'))
        .filter_map(|line| {
            let (name, count) = line.rsplit_once(' ')?;
            Some((name, count.parse().ok()?))
        })
        .collect();
    for (name, count) in entries {
        let Some(place) = known.iter().position(|(entry, _)| entry == name) else {
            changes.push(Change {
                text: format!("{name}: {count}, and none expected"),
                is_worse: true,
            });
            continue;
        };
        let (_, before) = known.swap_remove(place);
        if *count == before {
            continue;
        }
        let is_worse = is_same_compiler && *count * 1000 > before * (1000 + TOLERANCE);
        let note = if is_same_compiler { "" } else { " by another compiler" };
        changes.push(Change {
            text: format!("{name}: {count} instructions, {before} expected{note}"),
            is_worse,
        });
    }
    changes.extend(known.into_iter().map(|(name, _)| Change {
        text: format!("{name} is expected, and was not measured"),
        is_worse: true,
    }));
    changes
}

#[cfg(test)]
mod tests {
    use super::compare;

    fn worse(expected: &str, version: &str, count: u64) -> Vec<bool> {
        let entries = [("row".to_owned(), count)];
        compare(expected, version, &entries).iter().map(|change| change.is_worse).collect()
    }

    #[test]
    fn three_percent_more_are_too_many() {
        let expected = "# rustc 1\nrow 1000\n";
        assert!(worse(expected, "rustc 1", 1000).is_empty());
        assert_eq!(worse(expected, "rustc 1", 1030), [false]);
        assert_eq!(worse(expected, "rustc 1", 1031), [true]);
        assert_eq!(worse(expected, "rustc 1", 10), [false]);
        assert_eq!(worse(expected, "rustc 2", 5000), [false]);
        assert_eq!(worse("# rustc 1\nframe 9\n", "rustc 1", 9), [true, true]);
    }
}
