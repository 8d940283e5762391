//~ `u8` is not a pixel
//~ pixels are `Gray8`, `Mono`,
use scancsg::geom::vec3;
use scancsg::render::{Lambert, Orthographic, Picture, Size};
use scancsg::solid::Sphere;

fn picture() -> Result<(), scancsg::Error> {
    let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
    let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    let camera = Orthographic::look_at(eye, target, up, 3.0)?;
    let light = Lambert::new(eye, 0.2)?;
    let _ = Picture::new(&ball, &camera, Size::new(16, 12)?, light, 0_u8);
    Ok(())
}

fn main() {
    let _ = picture();
}
