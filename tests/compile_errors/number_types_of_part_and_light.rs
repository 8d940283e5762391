//~ doesn't shade parts whose numbers are `f32`
//~ a part, its camera, its light and its rays have one number type
use scancsg::geom::vec3;
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
use scancsg::{scalar::I16F16, solid::Sphere};

fn picture() -> Result<(), scancsg::Error> {
    let one = I16F16::from_num(1);
    let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
    let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    let camera = Orthographic::look_at(eye, target, up, 3.0)?;
    let light = Lambert::new(vec3(one, one, one), one)?;
    let _ = Picture::new(&ball, &camera, Size::new(16, 12)?, light, Gray8(0));
    Ok(())
}

fn main() {
    let _ = picture();
}
