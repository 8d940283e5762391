//! Three ways to the same picture.
//!
//! Solids are constants, as in a firmware: so each way gets a function that gives one.

use super::scene::Scene;
use scancsg::geom::{Line, RayRow, Rays, Vec3};
use scancsg::render::{Camera, Gray8, Lambert, Picture, RowError, Size};
use scancsg::scalar::Scalar;
use scancsg::solid::{Scan, Seen, Solid, first_seen};
use scancsg::span::{Face, SpanList};

/// Renders a frame into its argument, view included.
pub type Frame = Box<dyn Fn(&mut [Gray8])>;

/// Ambient light, in hundredths.
const AMBIENT: i32 = 15;

fn light<S: Scene>() -> Lambert<S> {
    Lambert::new(S::TO_LIGHT, S::hundredths(AMBIENT)).unwrap()
}

fn width(size: Size) -> usize {
    size.width().into()
}

/// As pictures are rendered: row by row, by silhouettes, and only up to the first surface.
pub fn rows<S, T, C>(solid: impl Fn() -> T + 'static, camera: C, size: Size) -> Frame
where
    S: Scene,
    C: Camera<Rays: Rays<Scalar = S>> + 'static,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    Box::new(move |pixels| {
        let solid = solid();
        let mut picture = Picture::new(&solid, &camera, size, light::<S>(), Gray8(0));
        let mut rows = (0..).zip(pixels.chunks_exact_mut(width(size)));
        let done: Result<(), RowError> =
            rows.try_for_each(|(y, row)| picture.scanline(y)?.render(row));
        done.unwrap();
    })
}

/// By the same rows, with the list of all spans in every pixel that its silhouettes don't rule out.
pub fn lists<S, T, C, const N: usize>(
    solid: impl Fn() -> T + 'static,
    camera: C,
    size: Size,
) -> Frame
where
    S: Scene,
    C: Camera<Rays: Rays<Scalar = S>> + 'static,
    T: Solid<Scalar = S> + Scan<C::Rays>,
{
    Box::new(move |pixels| {
        let solid = solid();
        let mut picture = Picture::new(&solid, &camera, size, light::<S>(), Gray8(0));
        let shade = Shade::<S>::new();
        let rays = camera.rays(size);
        let mut list = SpanList::<S, N>::new();
        for (y, row) in (0..size.height()).zip(pixels.chunks_exact_mut(width(size))) {
            let mut scanline = picture.scanline(y).unwrap();
            let lines = rays.row(from_middle(y, size.height()));
            for (x, pixel) in (0..).zip(row) {
                let seen = first_seen(scanline.spans(x, &mut list), rays.start());
                *pixel = shade.pixel(&solid, seen, || lines.line(from_middle(x, size.width())));
            }
        }
    })
}

/// Every primitive asked about the line of every pixel, as about any line.
pub fn naive<S, T, C, const N: usize>(
    solid: impl Fn() -> T + 'static,
    camera: C,
    size: Size,
) -> Frame
where
    S: Scene,
    C: Camera<Rays: Rays<Scalar = S>> + 'static,
    T: Solid<Scalar = S>,
{
    Box::new(move |pixels| {
        let solid = solid();
        let shade = Shade::<S>::new();
        let rays = camera.rays(size);
        let mut list = SpanList::<S, N>::new();
        for (y, row) in (0..size.height()).zip(pixels.chunks_exact_mut(width(size))) {
            let lines = rays.row(from_middle(y, size.height()));
            for (x, pixel) in (0..).zip(row) {
                let line = lines.line(from_middle(x, size.width()));
                solid.spans(&line, Face(0), &mut list.stack());
                let seen = first_seen(list.as_slice(), rays.start());
                *pixel = shade.pixel(&solid, seen, || line);
            }
        }
    })
}

/// The centre of a pixel, in half pixels from the middle of the picture.
fn from_middle(index: u16, count: u16) -> i32 {
    2 * i32::from(index) + 1 - i32::from(count)
}

/// The light of [`Lambert`], which shades nothing but pictures.
struct Shade<S> {
    to_light: Vec3<S>,
    ambient: S,
}

impl<S: Scene> Shade<S> {
    fn new() -> Self {
        let to_light = S::TO_LIGHT.map(Scalar::wide).normalized().unwrap().map(S::from_wide);
        Self { to_light, ambient: S::hundredths(AMBIENT) }
    }

    #[inline]
    fn pixel<T: Solid<Scalar = S>>(
        &self,
        solid: &T,
        seen: Option<Seen<S>>,
        line: impl FnOnce() -> Line<S>,
    ) -> Gray8 {
        let Some(Seen { t, face, inside }) = seen else { return Gray8(0) };
        let outward = solid.normal(face, line().at(t));
        let normal = if inside { -outward } else { outward };
        let cosine = normal.dot(self.to_light).max(S::ZERO);
        let diffuse = S::ONE.minus(self.ambient);
        Gray8(self.ambient.plus(diffuse.times(cosine)).to_level())
    }
}
