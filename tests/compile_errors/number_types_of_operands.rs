//~ Sphere<f32> as Shape>::Scalar ==
use scancsg::geom::vec3;
use scancsg::{scalar::I16F16, solid::Sphere};

fn part() -> Result<(), scancsg::Error> {
    let one = I16F16::from_num(1);
    let ball = Sphere::<I16F16>::new(vec3(one, one, one), one)?;
    let _ = ball - Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
    Ok(())
}

fn main() {
    let _ = part();
}
