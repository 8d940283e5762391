//~ `{float}` is not a solid
//~ what is combined by `|`, `&` and `-` are solids of one number type
use scancsg::geom::vec3;
use scancsg::solid::Sphere;

fn main() {
    if let Ok(ball) = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0) {
        let _ = ball - 0.5;
    }
}
