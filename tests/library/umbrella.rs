//! The error of all operations holds every other one.
#![allow(clippy::unwrap_used)]

use scancsg::Error;
use scancsg::render::RowError;
use std::fs;
use std::path::{Path, PathBuf};

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

#[test]
fn every_error_enum_is_a_variant() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src");
    let umbrella = fs::read_to_string(source.join("interop/error.rs")).unwrap();
    let mut paths = Vec::new();
    files(&source, &mut paths);
    let texts = paths.iter().map(|path| fs::read_to_string(path).unwrap());
    let names: Vec<String> = texts
        .flat_map(|text| {
            let names = text.split("pub enum ").skip(1).map(|rest| {
                let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap();
                (rest[..end].to_owned(), rest[end..].starts_with('<'))
            });
            // One with a type parameter holds an error of a device's.
            let ours = names.filter(|(name, is_generic)| name.ends_with("Error") && !is_generic);
            ours.map(|(name, _)| name).collect::<Vec<_>>()
        })
        .collect();
    let is_missing = |name: &&String| {
        let variant = name.strip_suffix("Error").unwrap();
        !variant.is_empty() && !umbrella.contains(&format!(" {variant}({name}),"))
    };
    assert_eq!(names.iter().filter(is_missing).collect::<Vec<_>>(), Vec::<&String>::new());
    assert!(names.len() > 25, "{names:?}");
}

#[test]
fn it_is_small_and_says_what_the_error_inside_says() {
    const ERROR: Error = Error::Row(RowError::Length);
    const TEXT: &str = ERROR.as_str();
    assert_eq!(ERROR, RowError::Length.into());
    assert_eq!(TEXT, RowError::Length.to_string());
    assert_eq!(ERROR.to_string(), TEXT);
    assert!(size_of::<Error>() <= 3, "{}", size_of::<Error>());
    fn copied<T: Copy + std::error::Error + Send + Sync + 'static>(_: T) {}
    copied(ERROR);
}
