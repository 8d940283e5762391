//! Smooth pictures against a model that asks every point of the grid on its own, and
//! against ordinary pictures of n times the size.

use crate::number::{Tested, ball, rod, vector};
use scancsg::geom::{Rays, Vec3};
use scancsg::render::{
    Blend, Camera, Gray8, Lambert, Orthographic, Perspective, Picture, Rgb565, RowError, Sample,
    Shader, Size, SmoothColumn, SmoothError, SmoothPicture, Smoothing,
};
use scancsg::scan::Empty;
use scancsg::solid::{Cylinder, Difference, Painted, Rgb, Scan, Solid, Sphere, Union};
use scancsg::span::Face;
use scancsg::span::walk::Cold;
use std::fmt::Debug;

for_every_number!(
    a_smooth_picture_is_its_points,
    edges_are_means_of_larger_pictures,
    what_cannot_be_smoothed,
);

const WIDTH: u16 = 29;
const HEIGHT: u16 = 22;
const LINE: usize = WIDTH as usize;

type Part<S> = Difference<Painted<Union<Cylinder<S>, Sphere<S>>>, Painted<Cylinder<S>>>;

/// A ball and a rod through it, and a bore through both: walls, caps, a curve where two faces meet.
fn part<S: Tested>() -> Part<S> {
    let body = ball::<S>([0.25, 0.0, 0.0], 1.0);
    let body = Painted::new(rod(0.5, -1.5, 1.75) | body, Rgb::new(150, 175, 200));
    body - Painted::new(rod(0.25, -2.0, 2.0), Rgb::new(235, 175, 70))
}

fn orthographic<S: Tested>() -> Orthographic<S> {
    let along = vector([-3.0, -1.0, -2.0]);
    Orthographic::look_along(along, Vec3::ZERO, vector([0.0, 1.0, 0.0]), S::near(3.0)).unwrap()
}

fn perspective<S: Tested>() -> Perspective<S> {
    let eye = vector([4.0, 2.0, 3.0]);
    Perspective::look_at(eye, Vec3::ZERO, vector([0.0, 1.0, 0.0]), S::near(0.5)).unwrap()
}

/// Of which face a point is, and where on the ray, in every bit: no two points look alike.
#[derive(Clone, Copy)]
struct Noise;

fn noise<S: Tested>(face: Face, t: S) -> u8 {
    let bits = (t.to_f64() + 0.0).to_bits().wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (bits >> 56) as u8 ^ (37 * face.0) as u8
}

impl<S: Tested> Shader<S> for Noise {
    fn level<T, R>(&self, sample: Sample<'_, T, R>) -> u8
    where
        T: Solid<Scalar = S> + Scan<R>,
        R: Rays<Scalar = S>,
    {
        noise(sample.seen.face, sample.seen.t)
    }
}

/// A format whose pixels can be taken to pieces.
trait Format: Blend + Eq + Debug {
    fn channels(self) -> Vec<f64>;
    fn of(channels: &[f64]) -> Self;
}

impl Format for Gray8 {
    fn channels(self) -> Vec<f64> {
        vec![self.0.into()]
    }

    fn of(channels: &[f64]) -> Self {
        Self(channels[0] as u8)
    }
}

impl Format for Rgb565 {
    fn channels(self) -> Vec<f64> {
        [self.0 >> 11, (self.0 >> 5) % 64, self.0 % 32].map(f64::from).to_vec()
    }

    fn of(channels: &[f64]) -> Self {
        Self(channels[0] as u16 * 2048 + channels[1] as u16 * 32 + channels[2] as u16)
    }
}

/// Rounded to nearest, upwards half-way between two.
fn mean<P: Format>(pixels: &[P]) -> P {
    let channels: Vec<_> = pixels.iter().map(|pixel| pixel.channels()).collect();
    let of = |i: usize| channels.iter().map(|pixel| pixel[i]).sum::<f64>();
    let rounded = |i| (of(i) / pixels.len() as f64 + 0.5).floor();
    P::of(&(0..channels[0].len()).map(rounded).collect::<Vec<_>>())
}

/// What a point of the grid sees, and how that looks.
type Point<P> = (Option<Face>, P);

/// All points: `2n` steps a pixel, from the upper left corner of the picture to the lower right.
fn points<S, T, C, P>(solid: &T, camera: &C, n: u16, background: P) -> Vec<Vec<Point<P>>>
where
    S: Tested,
    T: Solid<Scalar = S> + Scan<C::Rays>,
    C: Camera<Rays: Rays<Scalar = S>>,
    P: Format,
{
    let [across, down] = [WIDTH, HEIGHT].map(|count| i32::from(2 * n * count));
    let rays = camera.rays(Size::new(across as u16, down as u16).unwrap());
    let (mut view, mut row) = (T::View::EMPTY, T::Row::EMPTY);
    solid.view(&rays, &mut view);
    (0..=down)
        .map(|y| {
            solid.row(&view, 2 * y - down, across as u32 + 1, &mut row);
            let mut point = |x| {
                if !T::enter(&mut row, x as u32).is_visible {
                    return (None, background);
                }
                let before = rays.start().next_below();
                let next =
                    solid.step::<Cold>(&view, &mut row, 2 * x - across, before, Face(0)).next;
                if next.t >= S::HIGHEST {
                    return (None, background);
                }
                let color = solid.color(next.face).unwrap();
                (Some(next.face), P::shaded(color, noise(next.face, next.t)))
            };
            (0..=across).map(&mut point).collect()
        })
        .collect()
}

/// Whether a pixel's corners and its middle see something different, and its samples.
fn pixel<P: Copy>(points: &[Vec<Point<P>>], n: u16, [x, y]: [u16; 2]) -> (bool, Vec<Point<P>>) {
    let n = usize::from(n);
    let (left, top) = (2 * n * usize::from(x), 2 * n * usize::from(y));
    let of = |[x, y]: [usize; 2]| points[top + y][left + x];
    let five = [[0, 0], [2 * n, 0], [0, 2 * n], [2 * n, 2 * n], [n, n]].map(of);
    let is_edge = five.iter().any(|point| point.0 != five[4].0);
    let samples = (0..n * n).map(|i| of([2 * (i % n) + 1, 2 * (i / n) + 1])).collect();
    (is_edge, if is_edge { samples } else { vec![five[4]] })
}

/// The whole picture, in an order of rows in which some follow each other and some don't, and
/// every row twice.
fn rendered<S, T, C, P, H>(solid: &T, camera: &C, n: u16, shader: H, background: P) -> Vec<Vec<P>>
where
    S: Tested,
    T: Solid<Scalar = S> + Scan<C::Rays>,
    C: Camera<Rays: Rays<Scalar = S>>,
    P: Format,
    H: Shader<S>,
{
    let mut columns = [SmoothColumn::EMPTY; LINE + 1];
    let size = Size::new(WIDTH, HEIGHT).unwrap();
    let smoothing = Smoothing::new(size, n, &mut columns).unwrap();
    let mut picture = SmoothPicture::new(solid, camera, smoothing, shader, background);
    assert_eq!(picture.size(), size);
    let mut rows = vec![vec![]; HEIGHT.into()];
    for (step, first) in [(1, 0), (7, 3), (HEIGHT - 1, 0)] {
        for y in (0..HEIGHT).map(|i| (first + i * step) % HEIGHT) {
            let mut row = [P::shaded(Rgb::WHITE, 99); LINE];
            picture.render(y, &mut row).unwrap();
            let known = &mut rows[usize::from(y)];
            assert!(known.is_empty() || *known == row, "row {y} is another one now");
            *known = row.to_vec();
        }
    }
    rows
}

fn check_points<S, C, P>(camera: &C, n: u16, background: P)
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    P: Format,
    Part<S>: Scan<C::Rays> + Solid<Scalar = S>,
{
    let part = part::<S>();
    let points = points(&part, camera, n, background);
    let mut edges = 0;
    for (y, row) in (0..).zip(rendered(&part, camera, n, Noise, background)) {
        for (x, got) in (0..).zip(row) {
            let (is_edge, samples) = pixel(&points, n, [x, y]);
            edges += usize::from(is_edge);
            let samples: Vec<P> = samples.iter().map(|point| point.1).collect();
            assert_eq!(got, mean(&samples), "column {x} of row {y}, {samples:?}");
        }
    }
    assert!((90..250).contains(&edges), "{edges}");
}

/// Every pixel, bit by bit: what its five points decide, and the mean of its samples.
fn a_smooth_picture_is_its_points<S: Tested>() {
    for n in [1, 2, 3, 4, 16] {
        check_points(&orthographic::<S>(), n, Gray8(11));
        check_points(&perspective::<S>(), n, Gray8(11));
    }
    check_points(&orthographic::<S>(), 4, Rgb565(0x1234));
    check_points(&perspective::<S>(), 3, Rgb565(0x1234));
}

/// A picture of `times` the size in each direction.
fn plain<S, C>(camera: &C, times: u16, shader: Lambert<S>) -> Vec<Vec<Gray8>>
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    Part<S>: Scan<C::Rays> + Solid<Scalar = S>,
{
    let part = part::<S>();
    let size = Size::new(WIDTH * times, HEIGHT * times).unwrap();
    let mut picture = Picture::new(&part, camera, size, shader, Gray8(0));
    let row = |y| {
        let mut row = vec![Gray8(1); size.width().into()];
        picture.scanline(y).unwrap().render(&mut row).unwrap();
        row
    };
    (0..size.height()).map(row).collect()
}

fn check_larger<S, C>(camera: &C, n: u16)
where
    S: Tested,
    C: Camera<Rays: Rays<Scalar = S>>,
    Part<S>: Scan<C::Rays> + Solid<Scalar = S>,
{
    let light = Lambert::new(vector([0.25, 1.0, 0.5]), S::near(0.25)).unwrap();
    let part = part::<S>();
    let points = points(&part, camera, n, Gray8(0));
    let smooth = rendered(&part, camera, n, light, Gray8(0));
    let [small, large] = [1, n].map(|times| plain(camera, times, light));
    let (mut unseen, mut different) = (0, 0);
    for (x, y) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))) {
        let level = |Gray8(level)| i32::from(level);
        let of = |rows: &[Vec<Gray8>], x: u16, y: u16| rows[usize::from(y)][usize::from(x)];
        let samples: Vec<Gray8> =
            (0..n * n).map(|i| of(&large, n * x + i % n, n * y + i / n)).collect();
        let (got, mean) = (level(of(&smooth, x, y)), level(mean(&samples)));
        let at = format!("column {x} of row {y}");
        if pixel(&points, n, [x, y]).0 {
            // In fixed point, half the step of half a pixel is not that of a quarter: one sample
            // may see something else.
            let off = if S::IS_FIXED { 1 + 255 / i32::from(n * n) } else { 0 };
            assert!((got - mean).abs() <= off, "{at}: {got} is not {mean}");
            different += u32::from(got != mean);
            continue;
        }
        let off = if S::IS_FIXED { 1 } else { 0 };
        let middle = level(of(&small, x, y));
        assert!((got - middle).abs() <= off, "{at}: {got} is not {middle}");
        different += u32::from(got != middle);
        // All samples of one face differ as little as the light on it does. Otherwise they have
        // found a detail that five points don't see.
        let levels = || samples.iter().copied().map(level);
        let (low, high) = (levels().min().unwrap(), levels().max().unwrap());
        assert!((got - mean).abs() <= high - low + off, "{at}: {got} among {low} to {high}");
        unseen += u32::from(high - low > 60);
    }
    println!("details unseen in {unseen} pixels; {different} differ in the last place");
    assert!(unseen <= 3 && different <= 6, "{unseen}, {different}");
}

/// Inside a surface, the pixels of an ordinary picture; at edges, the mean of those of a larger one.
fn edges_are_means_of_larger_pictures<S: Tested>() {
    for n in [1, 2, 4, 8] {
        check_larger(&orthographic::<S>(), n);
        check_larger(&perspective::<S>(), n);
    }
}

fn what_cannot_be_smoothed<S: Tested>() {
    let try_it = |width, samples, memory| {
        let mut columns = vec![SmoothColumn::<Gray8>::EMPTY; memory];
        Smoothing::new(Size::new(width, 3).unwrap(), samples, &mut columns).err()
    };
    assert_eq!(try_it(9, 0, 10), Some(SmoothError::Samples));
    assert_eq!(try_it(9, 17, 10), Some(SmoothError::Samples));
    assert_eq!(try_it(9, u16::MAX, 10), Some(SmoothError::Samples));
    assert_eq!(try_it(9, 4, 9), Some(SmoothError::Memory));
    assert_eq!(try_it(9, 4, 11), Some(SmoothError::Memory));
    assert_eq!(try_it(2048, 16, 2049), Some(SmoothError::Size));
    assert_eq!(try_it(2047, 16, 2048), None);
    assert_eq!(try_it(32_767, 1, 32_768), None);
    assert_eq!(try_it(32_768, 1, 32_769), Some(SmoothError::Size));
    assert_eq!(try_it(u16::MAX, 16, 65_536), Some(SmoothError::Size));

    let mut columns = [SmoothColumn::EMPTY; 5];
    let smoothing = Smoothing::new(Size::new(4, 3).unwrap(), 2, &mut columns).unwrap();
    let (part, camera) = (part::<S>(), orthographic::<S>());
    let mut picture = SmoothPicture::new(&part, &camera, smoothing, Noise, Gray8(0));
    let mut pixels = [Gray8(9); 5];
    assert_eq!(picture.render(3, &mut pixels[..4]), Err(RowError::Index));
    assert_eq!(picture.render(0, &mut pixels), Err(RowError::Length));
    assert_eq!(picture.render(0, &mut pixels[..3]), Err(RowError::Length));
    assert_eq!(pixels, [Gray8(9); 5]);
    assert_eq!(picture.render(2, &mut pixels[..4]), Ok(()));
}
