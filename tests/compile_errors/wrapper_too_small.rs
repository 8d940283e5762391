//~ the list of spans is too small for this solid, which needs room for 16
use scancsg::geom::vec3;
use scancsg::solid::{ByLine, Sphere};

fn main() {
    if let Ok(ball) = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0) {
        let _ = ByLine::<_, 1>::new([ball; 8]);
    }
}
