//! The gallery: every scene is a picture, the same one in floating and in fixed point, and the same bits as
//! ever.

#![cfg(unix)]
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

#[path = "../../../testkit/src/fnv.rs"]
mod fnv;

const SCENES: [&str; 12] = [
    "box",
    "half-space",
    "polyhedron",
    "cone",
    "torus",
    "ellipsoid",
    "capsule",
    "rounded",
    "ring",
    "housing",
    "knob",
    "arm",
];
const SIZE: [usize; 2] = [64, 48];

/// The colours of a scene's pixels.
fn picture(scene: &str, camera: &str, number: &str) -> Vec<[u8; 3]> {
    let test = std::env::current_exe().unwrap();
    let stream = test.parent().and_then(Path::parent).unwrap().join("examples/stream");
    let out =
        PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{scene}-{camera}-{number}.png"));
    let size = format!("{}x{}", SIZE[0], SIZE[1]);
    let arguments = ["--scene", scene, "--camera", camera, "--number", number, "--size", &size];
    let mut command = Command::new(stream);
    let output = command.args(arguments).args(["--format", "rgb565", "--out"]).arg(&out).output();
    let output = output.unwrap();
    assert!(output.status.success(), "{scene}: {output:?}");
    let file = std::io::BufReader::new(std::fs::File::open(&out).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    pixels.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

fn hash(pixels: &[[u8; 3]]) -> u32 {
    fnv::fnv(pixels.as_flattened().iter().map(|byte| u32::from(*byte)))
}

#[test]
fn every_scene_is_the_same_picture_in_both_kinds_of_numbers() {
    let mut hashes = String::new();
    for scene in SCENES {
        for camera in ["ortho", "persp"] {
            let [float, fixed] = ["f32", "i16f16"].map(|number| picture(scene, camera, number));
            let seen = float.iter().filter(|pixel| **pixel != [0; 3]).count();
            assert!(seen * 20 > float.len(), "{scene}: {seen} pixels");
            let apart = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).any(|i| a[i].abs_diff(b[i]) > 24);
            let differ = float.iter().zip(&fixed).filter(|pair| apart(*pair)).count();
            assert!(differ * 100 < seen, "{scene}, {camera}: {differ} of {seen} pixels differ");
            writeln!(hashes, "{scene} {camera} {:08x} {:08x}", hash(&float), hash(&fixed)).unwrap();
        }
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/gallery.txt");
    if std::env::var_os("SCANCSG_BLESS").is_some() {
        std::fs::write(&path, &hashes).unwrap();
    }
    let golden = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(golden, hashes, "not the pictures of gallery.txt (SCANCSG_BLESS=1 writes it anew)");
}
