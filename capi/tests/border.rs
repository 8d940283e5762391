//! Whatever C passes has a code, and the packets are the link's.

#![allow(unsafe_code)] // it is C's side that is tested
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use scancsg_capi::number::Number;
use scancsg_capi::packet::*;
use scancsg_capi::picture::*;
use scancsg_capi::pixels::Format;
use scancsg_capi::ray::*;
use scancsg_capi::scene::*;
use scancsg_capi::status::*;
use scancsg_capi::table::*;
use std::ffi::CStr;
use std::ptr::{null, null_mut};

/// The number nearest to this many hundredths.
#[cfg(not(feature = "i16f16"))]
fn n(hundredths: i32) -> Number {
    hundredths as f32 / 100.0
}

/// The number nearest to this many hundredths.
#[cfg(feature = "i16f16")]
fn n(hundredths: i32) -> Number {
    ((i64::from(hundredths) * 65_536 + 50).div_euclid(100)) as i32
}

/// Memory that is zero.
fn empty<T>() -> Box<T> {
    // SAFETY: only for scenes and pictures, which are words.
    unsafe { Box::<T>::new_zeroed().assume_init() }
}

fn build(scene: &mut Scene, steps: &[Step], poses: &[Motion]) -> (Status, usize) {
    let mut failed = usize::MAX;
    // SAFETY: all of it is here.
    let status = unsafe {
        scancsg_scene_from_table(
            scene,
            size_of::<Scene>(),
            steps.as_ptr(),
            steps.len(),
            poses.as_ptr(),
            poses.len(),
            &raw mut failed,
        )
    };
    (status, failed)
}

fn ball() -> Step {
    Step { kind: Kind::Sphere as u8, r: [n(100), n(0)], ..Step::default() }
}

fn view(width: u16, height: u16) -> View {
    View {
        eye: [n(100), n(200), n(500)],
        up: [n(0), n(100), n(0)],
        extent: n(100),
        to_light: [n(25), n(85), n(45)],
        ambient: n(25),
        width,
        height,
        background: [10, 20, 30],
        ..View::default()
    }
}

fn picture(scene: &Scene, view: &View, has_eye: bool) -> (Box<Picture>, Status) {
    let mut picture = empty::<Picture>();
    let make = if has_eye { scancsg_picture_perspective } else { scancsg_picture_orthographic };
    // SAFETY: all of it is here.
    let status = unsafe { make(&raw mut *picture, size_of::<Picture>(), scene, view) };
    (picture, status)
}

#[test]
fn every_status_has_a_text_of_its_own() {
    let text = |status| {
        // SAFETY: it is never null, and ends with a zero.
        unsafe { CStr::from_ptr(scancsg_status_text(status)) }.to_str().unwrap()
    };
    let unknown = text(-1);
    let known: Vec<&str> = (0..200).map(text).filter(|text| *text != unknown).collect();
    let mut different = known.clone();
    different.sort_unstable();
    different.dedup();
    assert_eq!((known.len(), different.len()), (42, 42));
}

/// A frame of packets, as a receiver of the library takes it.
#[test]
fn the_receiver_gets_the_frame() {
    use scancsg::stream::{Event, Memory, Receiver, Timing};
    let mut scene = empty::<Scene>();
    assert_eq!(build(&mut scene, &[ball()], &[]).0, Status::Ok);
    let (mut picture, status) = picture(&scene, &view(29, 17), true);
    assert_eq!(status, Status::Ok);
    for (format, width, code) in [
        (Format::Gray8, 29, 0),
        (Format::Rgb565, 58, 1),
        (Format::Rgb565Be, 58, 1),
        (Format::Rgb888, 87, 2),
    ] {
        let format = format as u8;
        let (mut packet, mut length, mut hash) = ([0; 400], 0, 0);
        let capacity = scancsg_packet_capacity(29, format);
        assert!((1..=packet.len()).contains(&capacity));
        let (mut line, mut pixels) = (Vec::new(), Vec::new());
        // SAFETY: all of it is here.
        unsafe {
            let (p, l) = (packet.as_mut_ptr(), &raw mut length);
            let status = scancsg_packet_header(&raw const *picture, 7, format, p, capacity, l);
            assert_eq!(status, Status::Ok);
            line.extend_from_slice(&packet[..length]);
            for y in 0..17 {
                let mut row = vec![0; width];
                let status =
                    scancsg_picture_row(&raw mut *picture, y, format, row.as_mut_ptr(), width);
                assert_eq!(status, Status::Ok);
                let (p, l, h) = (packet.as_mut_ptr(), &raw mut length, &raw mut hash);
                pixels.extend_from_slice(&row);
                let row = row.as_ptr();
                let status = scancsg_packet_row(7, y, format, row, width, h, p, capacity, l);
                assert_eq!(status, Status::Ok);
                line.extend_from_slice(&packet[..length]);
            }
            let (p, l) = (packet.as_mut_ptr(), &raw mut length);
            assert_eq!(scancsg_packet_end(7, hash, p, capacity, l), Status::Ok);
            line.extend_from_slice(&packet[..length]);
        }
        let (mut held, mut rows) = (vec![0; width * 17], [false; 17]);
        let memory = Memory { pixels: &mut held, rows: &mut rows, above: &mut [] };
        let mut receiver = Receiver::<512>::new(memory, Timing { ask: 400, give_up: 10_000 });
        let mut bytes = line.as_slice();
        let last = std::iter::from_fn(|| receiver.receive(&mut bytes, 0)).last();
        // The hash of all rows is the one that came, too.
        assert_eq!(last, Some(Event::Complete));
        let header = receiver.frame().header().unwrap();
        assert_eq!((header.frame, header.format.code()), (7, code));
        if format == Format::Rgb565Be as u8 {
            pixels.as_chunks_mut::<2>().0.iter_mut().for_each(|pixel| pixel.swap(0, 1));
        }
        assert_eq!(receiver.frame().pixels(), pixels);
        assert_eq!((receiver.traffic().packets, receiver.traffic().bad_packets), (19, 0));
    }
}

/// A number of the kind that C may well pass.
fn number() -> impl Strategy<Value = Number> {
    prop_oneof![
        6 => (-300..300_i32).prop_map(n),
        1 => any::<i32>().prop_map(n),
        1 => any::<u32>().prop_map(bits),
    ]
}

#[cfg(not(feature = "i16f16"))]
fn bits(bits: u32) -> Number {
    f32::from_bits(bits)
}

#[cfg(feature = "i16f16")]
fn bits(bits: u32) -> Number {
    bits.cast_signed()
}

fn three() -> impl Strategy<Value = [Number; 3]> {
    [number(), number(), number()]
}

fn step() -> impl Strategy<Value = Step> {
    let kind = prop_oneof![8 => 1..=6_u8, 3 => 240..=242_u8, 1 => any::<u8>()];
    let count = prop_oneof![6 => 1..4_u8, 1 => any::<u8>()];
    let has = prop_oneof![6 => 0..4_u8, 1 => any::<u8>()];
    let rest = (0..4_u8, any::<[u8; 3]>(), three(), three(), [number(), number()]);
    (kind, count, has, rest).prop_map(|(kind, count, has, (pose, color, a, b, r))| Step {
        kind,
        count,
        has,
        pose,
        color,
        a,
        b,
        r,
    })
}

fn motion() -> impl Strategy<Value = Motion> {
    (three(), number(), three()).prop_map(|(axis, angle, shift)| Motion { axis, angle, shift })
}

fn any_view() -> impl Strategy<Value = View> {
    let lengths = (number(), number(), 0..40_u16, 0..20_u16, any::<[u8; 3]>());
    (three(), three(), three(), three(), lengths).prop_map(
        |(eye, target, up, to_light, (extent, ambient, width, height, background))| View {
            eye,
            target,
            up,
            extent,
            to_light,
            ambient,
            width,
            height,
            background,
            reserved: 0,
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Tables, views and rays of any numbers: a status, and a row again to the same bits.
    #[test]
    fn whatever_is_passed_has_a_status(
        steps in prop::collection::vec(step(), 0..20),
        poses in prop::collection::vec(motion(), 0..6),
        view in any_view(),
        has_eye: bool,
        format in 0..6_u8,
        origin in three(),
        direction in three(),
    ) {
        let mut scene = empty::<Scene>();
        let (status, failed) = build(&mut scene, &steps, &poses);
        let mut hit = Hit::default();
        // SAFETY: all of it is here.
        let seen = unsafe {
            scancsg_scene_ray(&raw const *scene, origin.as_ptr(), direction.as_ptr(), &raw mut hit)
        };
        let (mut picture, made) = picture(&scene, &view, has_eye);
        if status != Status::Ok {
            prop_assert!(failed < steps.len().max(1));
            prop_assert_eq!((seen, made), (Status::NotMade, Status::NotMade));
            return Ok(());
        }
        prop_assert_eq!(failed, usize::MAX);
        prop_assert!(seen == Status::Ok || hit == Hit::default());
        prop_assert!(usize::from(hit.part) < steps.len());
        if made != Status::Ok {
            return Ok(());
        }
        let bits = match format { 0 => 8, 1 | 4 => 16, 2 => 24, 3 => 1, _ => 8 };
        let bytes = (usize::from(view.width) * bits).div_ceil(8);
        for y in 0..=view.height {
            let mut rows = [vec![1; bytes], vec![2; bytes]];
            let statuses = rows.each_mut().map(|row| {
                // SAFETY: all of it is here.
                unsafe { scancsg_picture_row(&raw mut *picture, y, format, row.as_mut_ptr(), bytes) }
            });
            prop_assert_eq!(statuses[0], statuses[1]);
            prop_assert_eq!(rows[0] == rows[1], statuses[0] == Status::Ok);
            prop_assert_eq!(statuses[0] == Status::Format, format == 5);
            prop_assert!(y < view.height || statuses[0] != Status::Ok);
        }
    }

    /// Bytes that are no program, and those of one that were changed.
    #[test]
    fn bytes_have_a_status(
        steps in prop::collection::vec(step(), 1..8),
        at: prop::sample::Index,
        value: u8,
        noise in prop::collection::vec(any::<u8>(), 0..64),
    ) {
        let (mut scene, mut other) = (empty::<Scene>(), empty::<Scene>());
        let mut bytes = noise;
        if build(&mut scene, &steps, &[]).0 == Status::Ok {
            let mut length = 0;
            bytes = vec![0; 2000];
            // SAFETY: all of it is here.
            let status = unsafe {
                scancsg_scene_to_bytes(&raw const *scene, bytes.as_mut_ptr(), 2000, &raw mut length)
            };
            prop_assert_eq!(status, Status::Ok);
            bytes.truncate(length);
            let place = at.index(length);
            bytes[place] = value;
        }
        // SAFETY: all of it is here.
        let status = unsafe {
            scancsg_scene_from_bytes(&raw mut *other, size_of::<Scene>(), bytes.as_ptr(), bytes.len())
        };
        let (_, made) = picture(&other, &view(8, 8), false);
        prop_assert_eq!(made == Status::NotMade, status != Status::Ok);
    }

    /// Null pointers and other sizes, in any combination.
    #[test]
    fn null_is_a_status(nulls: [bool; 7], size in 0..6000_usize) {
        let mut scene = empty::<Scene>();
        prop_assume!(nulls.contains(&true) && size != size_of::<Scene>());
        prop_assert_eq!(build(&mut scene, &[ball()], &[]).0, Status::Ok);
        let (mut picture, made) = picture(&scene, &view(16, 8), false);
        prop_assert_eq!(made, Status::Ok);
        let (s, p) = (&raw mut *scene, &raw mut *picture);
        let (mut row, mut packet, mut length, mut hash) = ([0; 16], [0; 300], 0, 0);
        let numbers = [n(100); 3];
        let (mut hit, step, motion, view) = (Hit::default(), ball(), Motion::default(), view(4, 4));
        fn or<T>(is_null: bool, pointer: *mut T) -> *mut T {
            if is_null { null_mut() } else { pointer }
        }
        fn or_const<T>(is_null: bool, pointer: *const T) -> *const T {
            if is_null { null() } else { pointer }
        }
        let [a, b, c, d, ..] = nulls;
        let expect = |all: &[bool]| if all.contains(&true) { Status::Null } else { Status::Ok };
        // SAFETY: what isn't null is here.
        unsafe {
            let (q, l) = (or(a, packet.as_mut_ptr()), or(b, &raw mut length));
            prop_assert_eq!(scancsg_packet_end(1, 2, q, 300, l), expect(&[a, b]));
            let h = or(c, &raw mut hash);
            let pixels = or_const(d, row.as_ptr());
            let status = scancsg_packet_row(1, 2, 0, pixels, 16, h, q, 300, l);
            prop_assert_eq!(status, expect(&[a, b, c, d]));
            let status = scancsg_packet_header(or_const(c, p), 1, 0, q, 300, l);
            prop_assert_eq!(status, expect(&[a, b, c]));
            let status = scancsg_picture_row(or(a, p), 1, 0, or(b, row.as_mut_ptr()), 16);
            prop_assert_eq!(status, expect(&[a, b]));
            let (o, v) = (or_const(b, numbers.as_ptr()), or_const(c, numbers.as_ptr()));
            let status = scancsg_scene_ray(or_const(a, s), o, v, or(d, &raw mut hit));
            prop_assert_eq!(status, expect(&[a, b, c, d]));
            let status = scancsg_scene_to_bytes(or_const(a, s), q, 300, l);
            prop_assert_eq!(status, expect(&[a, b]));
            let bytes = or_const(a, [0; 9].as_ptr());
            let status = scancsg_scene_from_bytes(or(b, s), size_of::<Scene>(), bytes, 9);
            prop_assert_eq!(status, if a || b { Status::Null } else { Status::Magic });
            let (steps, failed) = (or_const(a, &raw const step), or(c, &raw mut length));
            let status =
                scancsg_scene_from_table(or(b, s), size_of::<Scene>(), steps, 1, null(), 0, failed);
            prop_assert_eq!(status, expect(&[a, b]));
            let status = scancsg_scene_from_table(s, size, steps, 1, null(), 0, failed);
            prop_assert_eq!(status, Status::Storage);
            let status = scancsg_scene_from_table(s, size_of::<Scene>(), &raw const step, 1, null(), 0, null_mut());
            prop_assert_eq!(status, Status::Ok);
            let status = scancsg_scene_move(or(a, s), 0, or_const(b, &raw const motion));
            prop_assert_eq!(status, if a || b { Status::Null } else { Status::NoPose });
            let (v, size) = (or_const(c, &raw const view), size_of::<Picture>());
            let status = scancsg_picture_perspective(or(a, p), size, or_const(b, s), v);
            prop_assert_eq!(status, expect(&[a, b, c]));
        }
    }
}
