//~ can't take a picture of `impl Solid<Scalar = f32>`
//~ `part: &(impl Solid<Scalar = f32> + Scan<OrthographicRays<f32>>)`
use scancsg::geom::vec3;
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
use scancsg::solid::Solid;

fn picture(part: &impl Solid<Scalar = f32>) -> Result<(), scancsg::Error> {
    let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    let camera = Orthographic::look_at(eye, target, up, 3.0)?;
    let light = Lambert::new(eye, 0.2)?;
    let _ = Picture::new(part, &camera, Size::new(16, 12)?, light, Gray8(0));
    Ok(())
}

fn main() {
    let ball = scancsg::solid::Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0);
    let _ = ball.map(|ball| picture(&ball));
}
