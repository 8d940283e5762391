//~ can't take a picture of `Mine`
//~ a solid of your own is wrapped: `ByLine::<_, SPANS>::new(solid)`
use scancsg::geom::vec3;
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};

struct Mine;

fn picture() -> Result<(), scancsg::Error> {
    let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    let camera = Orthographic::look_at(eye, target, up, 3.0)?;
    let light = Lambert::new(eye, 0.2)?;
    let _ = Picture::new(&Mine, &camera, Size::new(16, 12)?, light, Gray8(0));
    Ok(())
}

fn main() {
    let _ = picture();
}
