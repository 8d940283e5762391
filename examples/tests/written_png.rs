//! Looks at the picture that the README's main command wrote. CI runs the command and then this
//! test, which is ignored otherwise: it needs a file from outside.

#![allow(clippy::unwrap_used)]

#[test]
#[ignore = "needs SCANCSG_PNG, the file that the example `stream` wrote with its defaults"]
fn the_written_png_shows_the_part() {
    let path = std::env::var("SCANCSG_PNG").unwrap();
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (160, 120));
    assert_eq!(
        (info.color_type, info.bit_depth),
        (png::ColorType::Grayscale, png::BitDepth::Eight)
    );

    // 55 % of the pixels are covered. The light leaves no covered pixel quite black.
    let covered = pixels.iter().filter(|level| **level > 0).count();
    assert_eq!(covered, 10_485);
    // Both the dark and the lit side are there.
    assert!(pixels.iter().any(|level| *level > 240));
    assert!(pixels.iter().any(|level| (1..60).contains(level)));
}
