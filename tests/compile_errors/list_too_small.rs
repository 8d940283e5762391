//~ the list of spans is too small for this solid, which needs room for 4
use scancsg::geom::{Ray, vec3};
use scancsg::solid::{RayCast, Sphere};
use scancsg::span::SpanList;

fn trace() -> Result<(), scancsg::Error> {
    let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
    let ray = Ray::new(vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, -1.0))?;
    let mut spans = SpanList::<_, 3>::new();
    let _ = (ball - ball).trace(&ray, &mut spans);
    Ok(())
}

fn main() {
    let _ = trace();
}
