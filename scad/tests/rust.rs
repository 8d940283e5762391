//! Constants of Rust that were made of parts: they compile, they are what is made now, and they look alike.

mod support;

use scancsg::geom::OrthographicRays;
use scancsg::render::{Lambert, Orthographic, Picture, RowSource, Size};
use scancsg::scan::Scan;
use scancsg::solid::Solid;
use scancsg_scad::map::Vector;
use scancsg_scad::picture::{Angles, View, render};
use scancsg_scad::{Model, lower, parse, rust};
use std::error::Error;
use std::{env, fs};
use support::reference::folder;
use support::{SIZE, Seen, scene};

mod hinge {
    include!("generated/hinge.rs");
}

mod skewed {
    include!("generated/skewed.rs");
}

/// `SCAD_RECORD=1` writes the constant anew.
fn check<T>(name: &str, recorded: &str, part: &T) -> Result<(), Box<dyn Error>>
where
    T: Solid<Scalar = f32> + Scan<OrthographicRays<f32>>,
{
    let text = fs::read_to_string(folder().join(name).with_extension("csg"))?;
    let made = rust(&Model::of(lower(&parse(&text)?, false)?.tree)?, "PART")?;
    if env::var_os("SCAD_RECORD").is_some() {
        fs::write(folder().join("../generated").join(name).with_extension("rs"), &made)?;
    }
    assert!(made == recorded, "another constant of {name} is made now");

    let scene = scene(&text)?;
    let view = View::of_all(&scene, Angles::default(), SIZE)?;
    let want = render(&scene, &view, SIZE, Seen(false))?;
    let narrow = |v: Vector| v.map(|part| part as f32);
    let [_, up, back] = view.angles.axes();
    let camera = Orthographic::look_along(
        narrow(-back),
        narrow(view.target),
        narrow(up),
        view.height as f32,
    )?;
    let light = Lambert::new(narrow(back), 1.0)?;
    let mut picture = Picture::new(part, &camera, Size::new(SIZE[0], SIZE[1])?, light, Seen(false));
    let mut differing = 0;
    let mut row = vec![Seen(false); SIZE[0].into()];
    for (y, want) in (0..).zip(want.chunks(SIZE[0].into())) {
        picture.render(y, &mut row)?;
        differing += row.iter().zip(want).filter(|(a, b)| a.0 != b.0).count();
    }
    // Of 76,800: where `f32` decides otherwise.
    assert!(differing <= 4, "{name}: {differing} pixels");
    Ok(())
}

#[test]
fn a_hinge_of_coloured_solids() -> Result<(), Box<dyn Error>> {
    check("hinge", include_str!("generated/hinge.rs"), &hinge::PART)
}

#[test]
fn turned_and_stretched_solids() -> Result<(), Box<dyn Error>> {
    check("skewed", include_str!("generated/skewed.rs"), &skewed::PART)
}
