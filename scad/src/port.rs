//! A part on a device: it is sent as a program, and the device answers with its picture.

use crate::host::meter::Meter;
use crate::host::port::{self, Port};
use crate::host::receive::{Frame, Room, Session, timing};
use crate::host::screen::Screen;
use crate::host::send;
use scancsg_scad::Error;
use scancsg_scad::program::{Bytes, NumberType};

/// Sends the part that is made for the number type of a device, and returns what the device sees.
pub fn picture(
    device: &str,
    baud: u32,
    make: impl FnOnce(NumberType) -> Result<Bytes, Error>,
) -> Result<Frame, Error> {
    let line = port::open(device, baud).map_err(Error::file)?;
    on_line(line, Some(baud), make)
}

fn on_line(
    line: Box<dyn Port>,
    baud: Option<u32>,
    make: impl FnOnce(NumberType) -> Result<Bytes, Error>,
) -> Result<Frame, Error> {
    let mut room = Room::new();
    let mut session: Session<'_> = Session::new(line, &mut room, timing(baud));
    let device = send::ask(&mut session, baud).map_err(Error::file)?;
    let number = NumberType::of_code(device.number).ok_or_else(|| {
        let name = send::number_name(device.number);
        Error::file(format!("the device computes in {name}: there are programs in f32 and I16F16"))
    })?;
    let part = make(number)?;
    let (mut screen, meter) = (Screen::new(), Meter::new());
    let received = send::picture(&mut session, &part.bytes, baud, |session| {
        if screen.is_terminal() && screen.is_due() {
            let figures = meter.lines(session.picture(), session.traffic(), None);
            screen.draw(session.picture(), &figures);
        }
    });
    let refused = |error| {
        let kinds: Vec<String> = part.kinds().map(|kind| kind.solid(part.faces)).collect();
        let (parts, poses, kinds) = (part.parts, part.poses, kinds.join(", "));
        let faces = if part.faces > 0 { " (faces: see --faces)" } else { "" };
        Error::file(format!("{error}; it has {parts} parts of {kinds}{faces}, and {poses} poses"))
    };
    received.map_err(refused)
}

#[cfg(test)]
mod tests {
    use super::on_line;
    use crate::host::port::loopback;
    use crate::host::wire::{Trouble, Wire};
    use crate::line::{Line, patience};
    use scancsg::geom::vec3;
    use scancsg::program::Program;
    use scancsg::render::{Gray8, Lambert, Orthographic, Picture, RowSource, Size};
    use scancsg::stream::{
        Inbox, PixelFormat, Plain, Refusal, Sender, packet_capacity, serve, take,
    };
    use scancsg_scad::program::{FACES, Leaf, NumberType, program};
    use scancsg_scad::{Model, lower, parse};
    use std::error::Error;
    use std::thread;

    type Part = Program<Leaf<f32>, 16, 2>;

    const SIDE: u16 = 32;

    /// A camera from above, and light from there.
    fn from_above() -> Option<(Orthographic<f32>, Lambert<f32>, Size)> {
        let [down, up] = [vec3(0.0, 0.0, -1.0), vec3(0.0, 1.0, 0.0)];
        let camera = Orthographic::look_along(down, vec3(0.0, 0.0, 0.0), up, 8.0).ok()?;
        Some((camera, Lambert::new(-down, 0.0).ok()?, Size::new(SIDE, SIDE).ok()?))
    }

    const TEXT: &str = "difference() { sphere(r = 3); cube(size = [2, 2, 9], center = true); }";

    /// A device in a thread, which takes one part in `f32`.
    #[test]
    fn a_device_answers_with_the_picture() -> Result<(), Box<dyn Error>> {
        let (host, device) = loopback()?;
        let thread = thread::spawn(move || -> Option<()> {
            let line = Line::new(Wire::new(device, Trouble::default()));
            let mut memory = [0; 512];
            let mut inbox = Inbox::new(&mut memory, 32);
            let bytes = take(&mut inbox, &mut &line, &mut &line).ok()?;
            let part = Part::from_bytes(bytes).ok()?;
            let (camera, light, size) = from_above()?;
            let mut picture = Picture::new(&part, &camera, size, light, Gray8(7));
            const CAPACITY: usize = packet_capacity(SIDE, PixelFormat::Gray8);
            let mut sender = Sender::<_, CAPACITY>::new(Plain, patience(1000));
            let mut row = [Gray8(0); SIDE as usize];
            serve(&mut picture, 0, &mut sender, &mut &line, &mut row, &mut &line).ok().map(|_| ())
        });
        let model = Model::of(lower(&parse(TEXT)?, false)?.tree)?;
        let mut asked = None;
        let frame = on_line(host, None, |number| {
            asked = Some(number);
            program(&model, number, FACES)
        })?;
        assert_eq!(asked, Some(NumberType::F32));
        assert_eq!((frame.header.width, frame.header.height), (SIDE, SIDE));

        let part = Part::from_bytes(&program(&model, NumberType::F32, FACES)?.bytes)?;
        let (camera, light, size) = from_above().ok_or("no camera")?;
        let mut picture = Picture::new(&part, &camera, size, light, Gray8(7));
        let mut row = [Gray8(0); SIDE as usize];
        let mut want = Vec::new();
        for y in 0..SIDE {
            picture.render(y, &mut row)?;
            want.extend(row.map(|pixel| pixel.0));
        }
        assert!(want.iter().any(|level| *level > 100));
        assert_eq!(frame.pixels, want);
        // The host hangs up as soon as it has the picture, so the device may hear no acknowledgement.
        assert!(thread.join().is_ok());
        Ok(())
    }

    /// A device that doesn't know a kind of part, say: the error has what the part is made of.
    #[test]
    fn a_refusal_comes_with_what_the_part_has() -> Result<(), Box<dyn Error>> {
        let (host, device) = loopback()?;
        thread::spawn(move || {
            let line = Line::new(Wire::new(device, Trouble::default()));
            let mut memory = [0; 512];
            let mut inbox = Inbox::new(&mut memory, 32);
            if take(&mut inbox, &mut &line, &mut &line).is_ok() {
                inbox.refuse(Refusal::Kind);
                let _ = take(&mut inbox, &mut &line, &mut &line);
            }
        });
        let model = Model::of(lower(&parse(TEXT)?, false)?.tree)?;
        match on_line(host, None, |number| program(&model, number, FACES)) {
            Err(error) => {
                let said = error.to_string();
                assert!(said.contains("a kind that the device doesn't know"), "{said}");
                assert!(said.ends_with("2 parts of Cuboid<S>, Sphere<S>, and 0 poses"), "{said}");
            }
            Ok(_) => assert_eq!("an error", ""),
        }
        Ok(())
    }

    /// A device whose numbers aren't those of any program.
    #[test]
    fn a_device_of_other_numbers_is_an_error() -> Result<(), Box<dyn Error>> {
        let (host, device) = loopback()?;
        thread::spawn(move || {
            let line = Line::new(Wire::new(device, Trouble::default()));
            let mut memory = [0; 64];
            let _ = take(&mut Inbox::new(&mut memory, 12), &mut &line, &mut &line);
        });
        let model = Model::of(lower(&parse(TEXT)?, false)?.tree)?;
        match on_line(host, None, |number| program(&model, number, FACES)) {
            Err(error) => assert!(error.to_string().contains("I20F12"), "{error}"),
            Ok(_) => assert_eq!("an error", ""),
        }
        Ok(())
    }
}
