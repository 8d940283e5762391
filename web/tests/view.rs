//! The receiver of the page, without a browser.

#![allow(clippy::unwrap_used)]

mod parts;

use parts::{Shown, canvas, recording};
use scancsg::render::{Gray8, Mono, Rgb565, Rgb888};
use scancsg_web::view::{News, View};

fn news(view: &mut View, mut bytes: &[u8]) -> Vec<News> {
    let next = || Some(view.receive(&mut bytes, 0)).filter(|news| *news != News::Nothing);
    std::iter::from_fn(next).collect()
}

fn shows_what_was_sent<P: Shown>() {
    let mut view = View::new();
    let heard = news(&mut view, &recording::<P>(0..2));
    assert_eq!(heard, [News::Started, News::Complete, News::Started, News::Complete]);
    assert!(view.canvas() == canvas::<P>(1), "{:?}", P::FORMAT);
    assert!(canvas::<P>(1) != canvas::<P>(0));
    assert_eq!(view.frames(), [2, 0]);
}

#[test]
fn every_format_is_shown() {
    shows_what_was_sent::<Gray8>();
    shows_what_was_sent::<Rgb565>();
    shows_what_was_sent::<Rgb888>();
    shows_what_was_sent::<Mono>();
}

#[test]
fn missing_rows_show_the_frame_before_half_transparent() {
    let mut view = View::new();
    news(&mut view, &recording::<Gray8>(0..1));
    let mut second = recording::<Gray8>(2..3);
    // Some packet in the middle, of a row.
    let middle = second.len() / 2;
    second[middle] ^= 0x10;
    assert_eq!(news(&mut view, &second), [News::Started]);
    let missing = parts::SIZE[1] - view.rows_received();
    assert_eq!((missing, view.traffic().bad_packets), (1, 1));
    let width = 4 * usize::from(parts::SIZE[0]);
    let (before, now) = (canvas::<Gray8>(0), canvas::<Gray8>(2));
    let rows = view.canvas().chunks(width).zip(before.chunks(width)).zip(now.chunks(width));
    let faint = rows.filter(|((shown, before), now)| {
        let is_faint = shown.chunks(4).all(|pixel| pixel[3] == 127);
        assert!(is_faint || shown == now);
        is_faint && shown.iter().zip(*before).enumerate().all(|(i, (a, b))| i % 4 == 3 || a == b)
    });
    assert_eq!(faint.count(), 1);
    // It asks for the row at once, and the next frame loses this one.
    assert!(view.next_answer());
    assert!(!view.answer().is_empty());
    news(&mut view, &recording::<Gray8>(3..4));
    assert_eq!(view.frames(), [2, 1]);
}
