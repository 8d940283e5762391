//! Runs of rows are what the whole rows have there, in whatever order.
#![allow(clippy::unwrap_used)]

use scancsg::geom::vec3;
use scancsg::render::{
    Blend, Gray8, Lambert, Perspective, Picture, Pixel, Rgb565, Rgb565Be, Rgb888, RowError,
    RunSource, Size, SmoothColumn, SmoothPicture, Smoothing,
};
use scancsg::solid::{Cuboid, Cylinder, Difference};

type Part = Difference<Cuboid<f32>, Cylinder<f32>>;

fn part() -> Part {
    let block = Cuboid::<f32>::new(vec3(-1.0, -0.7, -0.6), vec3(1.0, 0.7, 0.6)).unwrap();
    block - Cylinder::<f32>::along_z(0.2, 0.1, 0.4, -2.0, 2.0).unwrap()
}

fn camera() -> Perspective<f32> {
    let (eye, target, up) = (vec3(1.5, 2.0, 4.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    Perspective::look_at(eye, target, up, 0.6).unwrap()
}

fn light() -> Lambert<f32> {
    Lambert::new(vec3(0.3, 1.0, 0.5), 0.2).unwrap()
}

const SIZE: [u16; 2] = [47, 33];

/// All rows, then runs of all rows in an order that jumps.
fn check<S: RunSource<Pixel = P>, P: Pixel + PartialEq + core::fmt::Debug>(mut source: S, no: P) {
    let [width, height] = SIZE;
    let mut rows = vec![vec![no; width.into()]; height.into()];
    for (y, row) in (0..).zip(&mut rows) {
        source.render(y, row).unwrap();
    }
    assert!(rows.iter().flatten().any(|pixel| *pixel != no));
    let runs = [0..47, 0..20, 20..47, 46..47, 0..1, 13..29, 9..9];
    for index in 0..u32::from(height) * 7 {
        let (y, run) = ((index * 5 / 7 % 33) as u16, runs[index as usize % 7].clone());
        let mut pixels = vec![no; run.len()];
        source.render_run(y, run.clone(), &mut pixels).unwrap();
        let whole = &rows[usize::from(y)][usize::from(run.start)..usize::from(run.end)];
        assert_eq!(pixels, whole, "{run:?} of row {y}");
    }
    // Halves of row after row, as a double buffer has them.
    for y in 0..height {
        for run in [0..23, 23..47] {
            let mut pixels = vec![no; run.len()];
            source.render_run(y, run.clone(), &mut pixels).unwrap();
            let whole = &rows[usize::from(y)][usize::from(run.start)..usize::from(run.end)];
            assert_eq!(pixels, whole, "{run:?} of row {y}");
        }
    }
    let mut two = [no; 2];
    assert_eq!(source.render_run(33, 0..2, &mut two), Err(RowError::Index));
    assert_eq!(source.render_run(0, 46..48, &mut two), Err(RowError::Index));
    assert_eq!(source.render_run(0, 0..3, &mut two), Err(RowError::Length));
    assert_eq!(two, [no; 2]);
}

fn check_both<P: Blend + PartialEq + core::fmt::Debug>(no: P) {
    let (part, size) = (part(), Size::new(SIZE[0], SIZE[1]).unwrap());
    check(Picture::new(&part, &camera(), size, light(), no), no);
    let mut columns = [SmoothColumn::EMPTY; 48];
    let smoothing = Smoothing::new(size, 3, &mut columns).unwrap();
    let mut picture = SmoothPicture::new(&part, &camera(), smoothing, light(), no);
    check(&mut picture, no);
}

#[test]
fn runs_are_parts_of_rows() {
    check_both(Gray8(3));
    check_both(Rgb565(3));
}

#[test]
fn rows_of_bytes_are_rows_of_pixels() {
    fn rows<P: Blend, Q: Blend + From<P> + PartialEq + core::fmt::Debug>(background: P) {
        let (part, size) = (part(), Size::new(SIZE[0], SIZE[1]).unwrap());
        let (mut of_pixels, mut of_bytes) = ([SmoothColumn::EMPTY; 48], [SmoothColumn::EMPTY; 48]);
        let smoothing = Smoothing::new(size, 4, &mut of_pixels).unwrap();
        let mut pixels = SmoothPicture::new(&part, &camera(), smoothing, light(), background);
        let smoothing = Smoothing::new(size, 4, &mut of_bytes).unwrap();
        let mut bytes = SmoothPicture::new(&part, &camera(), smoothing, light(), background.into());
        let mut rows = ([background; 47], [Q::from(background); 47]);
        for y in 0..33 {
            pixels.render(y, &mut rows.0).unwrap();
            bytes.render(y, &mut rows.1).unwrap();
            assert_eq!(rows.0.map(Q::from), rows.1);
        }
    }
    rows::<Gray8, [u8; 1]>(Gray8(9));
    rows::<Rgb565, Rgb565Be>(Rgb565(0x1234));
    rows::<Rgb888, [u8; 3]>(Rgb888([1, 2, 3]));
    assert_eq!(Rgb565Be::from(Rgb565(0xF800)), [0xF8, 0]);
}
