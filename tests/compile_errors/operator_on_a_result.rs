//~ is not a solid
//~ a constructor's `Result` needs `?` first
use scancsg::geom::vec3;
use scancsg::solid::Sphere;

fn main() {
    if let Ok(ball) = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0) {
        let _ = ball - Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 0.5);
    }
}
