//! Parts as programs: trees that are built at run time.

use super::Scene;
use super::housing::HousingScene;
use scancsg::Error;
use scancsg::geom::vec3;
use scancsg::program::Program;
use scancsg::solid::{Cuboid, Cylinder, Sphere};

scancsg::leaves! {
    /// What these programs are made of.
    pub enum Part<S> {
        Cylinder(Cylinder<S>),
        Cuboid(Cuboid<S>),
        Sphere(Sphere<S>),
    }
}

/// `tee` as a program.
pub fn tee<S: Scene>() -> Result<Program<Part<S>, 10>, Error> {
    let [first, body @ ..] = S::TEE.left().map(Part::Cylinder);
    drilled(first, body, S::TEE.right().map(Part::Cylinder))
}

/// `housing` as a program.
pub fn housing<S: HousingScene>() -> Result<Program<Part<S>, 15>, Error> {
    let part = S::HOUSING;
    let (foot, body) = (*part.left().left(), part.left().right().map(Part::Cylinder));
    let bores = part.right().left().map(Part::Cylinder).into_iter();
    drilled(Part::Cuboid(foot), body, bores.chain(part.right().right().map(Part::Sphere)))
}

/// Parts united, less others.
fn drilled<S: Scene, const N: usize>(
    first: Part<S>,
    body: impl IntoIterator<Item = Part<S>>,
    bores: impl IntoIterator<Item = Part<S>>,
) -> Result<Program<Part<S>, N>, Error> {
    let mut program = Program::new(first);
    for part in body {
        program.push(part)?;
    }
    program.unite(program.operand_count())?;
    for part in bores {
        program.push(part)?;
    }
    program.subtract(program.operand_count() - 1)?;
    Ok(program)
}

/// `field`: a square plate with bosses, domes and holes by turns, one on each square of a grid, `N` parts
/// with the plate. Whatever N is, they take the same share of the picture.
pub fn field<S: Scene, const N: usize>() -> Result<Program<Part<S>, N>, Error> {
    let n = S::hundredths;
    let plate = Cuboid::between(vec3(n(-200), n(-200), n(-10)), vec3(n(200), n(200), n(10)))?;
    let side = (N.isqrt() as i32).max(1);
    let pitch = 400 / side;
    let at = |index: i32| {
        let (column, row) = (index % side, index / side);
        [column, row].map(|step| (2 * step + 1 - side) * pitch / 2)
    };
    let rod = |index: i32, low, high| {
        let middle = at(index).map(n);
        let axis = scancsg::geom::Axis::Z;
        Cylinder::along(axis, middle, n(pitch / 3), n(low), n(high)).ok().map(Part::Cylinder)
    };
    let indices = |kind| (1..N as i32).filter(move |index| index % 3 == kind);
    let domes = indices(0).filter_map(|index| {
        let [x, y] = at(index).map(n);
        Sphere::around(vec3(x, y, n(10)), n(pitch / 3)).ok().map(Part::Sphere)
    });
    let bosses = indices(1).filter_map(|index| rod(index, 0, 10 + pitch / 2));
    let holes = indices(2).filter_map(|index| rod(index, -20, 20));
    drilled(Part::Cuboid(plate), domes.chain(bosses), holes)
}
