//! Single rays.

use crate::border::{self, Plain};
use crate::number::{Number, Scalar, numbers, vector};
use crate::part::Part;
use crate::scene::{KeptScene, Scene};
use crate::status::Status;
use scancsg::geom::Ray;
use scancsg::solid::{Rgb, Shape, Solid};
use scancsg::span::SpanList;

/// What a ray sees.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[repr(C)]
pub struct Hit {
    /// The distance from the origin, in lengths of the direction.
    pub distance: Number,
    /// Where.
    pub point: [Number; 3],
    /// The normal of length 1, on the side that is seen.
    pub normal: [Number; 3],
    /// The colour of the face: red, green, blue. White if it has none.
    pub color: [u8; 3],
    /// 1 if the ray meets the scene, or 0. All other fields are 0 then.
    pub is_hit: u8,
    /// 1 if the ray begins inside, and sees the face from within, or 0.
    pub is_inside: u8,
    /// The part whose face it is, counted in the table from 0.
    pub part: u8,
}

/// Looks along a ray for the first surface of the scene, and writes what it sees to `hit`. A miss is
/// `SCANCSG_STATUS_OK`, too.
///
/// # Safety
/// `scene` is a scene's memory. `origin` and `direction` have three numbers each, and `hit` is room for one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_scene_ray(
    scene: *const Scene,
    origin: *const Number,
    direction: *const Number,
    hit: *mut Hit,
) -> Status {
    let look = || {
        // SAFETY: the caller has lent all of them.
        let (scene, origin, direction) = unsafe {
            (
                border::kept::<KeptScene>(scene)?,
                border::read(origin.cast::<[Number; 3]>())?,
                border::read(direction.cast::<[Number; 3]>())?,
            )
        };
        let seen = first_seen(scene, origin, direction)?;
        // SAFETY: as above.
        unsafe { border::write(hit, seen) }
    };
    Status::of(look())
}

fn first_seen(
    KeptScene { program, .. }: &KeptScene,
    origin: [Number; 3],
    direction: [Number; 3],
) -> Result<Hit, Status> {
    let ray = Ray::new(vector(origin), vector(direction))?;
    let Some(hit) = program.hit(&ray, &mut SpanList::<Scalar, 32>::new())? else {
        return Ok(Hit::default());
    };
    let Rgb { r, g, b } = program.color(hit.face).unwrap_or(Rgb::WHITE);
    let [distance] = numbers([hit.t]);
    Ok(Hit {
        distance,
        point: numbers(hit.point.to_array()),
        normal: numbers(hit.normal.to_array()),
        color: [r, g, b],
        is_hit: 1,
        is_inside: hit.inside.into(),
        part: (hit.face.0 / Part::<Scalar>::FACES) as u8,
    })
}

// SAFETY: it is integers and numbers.
unsafe impl Plain for Hit {}
