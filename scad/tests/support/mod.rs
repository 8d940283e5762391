//! What the tests share: references, and how a part compares with one.
#![allow(dead_code, reason = "each test uses some of it")]

pub mod mesh;
pub mod reference;

use mesh::Mesh;
use reference::Reference;
use scancsg::render::{Pixel, Rgb};
use scancsg_scad::picture::{Angles, View, render};
use scancsg_scad::scene::Scene;
use scancsg_scad::{Error, Model, lower, measure, parse};

/// The size of the silhouettes.
pub const SIZE: [u16; 2] = [320, 240];

/// A pixel that only says whether something is there.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Seen(pub bool);

impl Pixel for Seen {
    fn shaded(_: Rgb, _: u8) -> Self {
        Self(true)
    }
}

/// The scene of a `.csg` text.
pub fn scene(text: &str) -> Result<Scene, Error> {
    Scene::of(&Model::of(lower(&parse(text)?, false)?.tree)?)
}

/// How far a part is off a reference.
#[derive(Debug, Clone, Copy)]
pub struct Difference {
    /// In parts of the reference's volume.
    pub volume: f64,
    /// In parts of all pixels.
    pub pixels: f64,
}

/// Compares a part with a reference. So many pixels a side measure its volume.
pub fn compare(scene: &Scene, reference: &Reference, pixels: u16) -> Result<Difference, Error> {
    let volume = measure(scene, pixels).map_or(0.0, |measures| measures.volume);
    let view =
        View { angles: Angles::default(), target: reference.target, height: reference.height };
    let seen = render(scene, &view, SIZE, Seen(false))?;
    let differing = seen.iter().zip(&reference.silhouette).filter(|(a, b)| a.0 != **b).count();
    Ok(Difference {
        volume: (volume - reference.volume) / reference.volume,
        pixels: differing as f64 / seen.len() as f64,
    })
}

/// The reference that a mesh is.
pub fn of_mesh(mesh: &Mesh) -> Reference {
    let view = View::of_box(mesh.corners(), Angles::default(), SIZE);
    Reference {
        volume: mesh.volume(),
        target: view.target,
        height: view.height,
        silhouette: mesh.silhouette(&view, SIZE),
    }
}
