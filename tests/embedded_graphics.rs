//! Pictures on targets of `embedded-graphics`.
#![cfg(feature = "embedded-graphics")]
#![allow(clippy::unwrap_used)]

use embedded_graphics::geometry;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{self, BinaryColor};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scancsg::geom::vec3;
use scancsg::interop::DisplayError;
use scancsg::interop::embedded_graphics::{DrawError, draw};
use scancsg::render::{
    Gray8, Lambert, Mono, Orthographic, Picture, Pixel as _, Rgb, Rgb565, Rgb888, RowError,
    RowSource, Size,
};
use scancsg::solid::Sphere;

type Gray = pixelcolor::Gray8;

/// A target that keeps what it shows and how it was drawn.
struct Screen {
    area: Rectangle,
    dots: Vec<Option<Gray>>,
    filled: usize,
    contiguous: usize,
}

impl Screen {
    fn new(area: Rectangle) -> Self {
        let dots = vec![None; (area.size.width * area.size.height) as usize];
        Self { area, dots, filled: 0, contiguous: 0 }
    }

    fn at(&mut self, point: Point) -> &mut Option<Gray> {
        assert!(self.area.contains(point), "{point:?} isn't on the target");
        let from = point - self.area.top_left;
        &mut self.dots[from.y as usize * self.area.size.width as usize + from.x as usize]
    }
}

impl Dimensions for Screen {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Screen {
    type Color = Gray;
    type Error = &'static str;

    fn draw_iter<I>(&mut self, _: I) -> Result<(), &'static str>
    where
        I: IntoIterator<Item = Pixel<Gray>>,
    {
        Err("not pixel by pixel")
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), &'static str>
    where
        I: IntoIterator<Item = Gray>,
    {
        self.contiguous += 1;
        let mut colors = colors.into_iter();
        for point in area.points() {
            let dot = self.at(point);
            assert!(dot.is_none(), "{point:?} is drawn twice");
            *dot = colors.next();
        }
        assert_eq!(colors.next(), None, "more colours than the area has");
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Gray) -> Result<(), &'static str> {
        self.fill_contiguous(area, area.points().map(|_| color))?;
        (self.filled, self.contiguous) = (self.filled + 1, self.contiguous - 1);
        Ok(())
    }
}

/// Levels that depend on the place, with background at both ends.
struct Card;

const WIDTH: u16 = 60;

impl Card {
    fn level(x: i32, y: i32) -> u8 {
        if (20..40).contains(&x) { (x * 5 + y) as u8 } else { 7 }
    }
}

impl RowSource for Card {
    type Pixel = Gray8;

    fn size(&self) -> Size {
        Size::new(WIDTH, 30).unwrap()
    }

    fn render(&mut self, y: u16, pixels: &mut [Gray8]) -> Result<(), RowError> {
        if pixels.len() != usize::from(WIDTH) {
            return Err(RowError::Length);
        }
        let levels = (0..).map(|x| Gray8(Self::level(x, y.into())));
        pixels.iter_mut().zip(levels).for_each(|(pixel, level)| *pixel = level);
        Ok(())
    }
}

#[test]
fn what_lies_in_the_window_and_on_the_target_is_drawn_once() {
    let screen = Rectangle::new(Point::new(-5, 3), embedded_graphics::geometry::Size::new(50, 20));
    let windows = [
        ([-100, -100], [200, 200]),
        ([0, 5], [1, 1]),
        ([10, 0], [20, 12]),
        ([30, 30], [60, 60]),
        ([3, 3], [0, 9]),
        ([i32::MIN; 2], [u32::MAX; 2]),
    ];
    let places = [0, 7, -8, 40, -59, -60, 60, i32::MIN, i32::MAX];
    let mut row = [Gray8(0); WIDTH as usize];
    for (low, sides) in windows {
        for at in places.iter().flat_map(|&x| places.map(|y| Point::new(x, y))) {
            let mut target = Screen::new(screen);
            let window = Rectangle::new(low.into(), sides.into());
            draw(&mut Card, at, &mut row, &mut target, &window).unwrap();
            for point in screen.points() {
                let [x, y] = [point.x as i64 - at.x as i64, point.y as i64 - at.y as i64];
                // `contains` panics where a side is longer than an `i32`.
                let inside = |at: i32, low: i32, side: u32| {
                    (0..i64::from(side)).contains(&(i64::from(at) - i64::from(low)))
                };
                let is_there = inside(point.x, low[0], sides[0])
                    && inside(point.y, low[1], sides[1])
                    && (0..i64::from(WIDTH)).contains(&x)
                    && (0..30).contains(&y);
                let want = is_there.then(|| Gray::new(Card::level(x as i32, y as i32)));
                assert_eq!(*target.at(point), want, "{point:?} of a picture at {at:?}");
            }
        }
    }
}

#[test]
fn background_is_filled_and_the_rest_goes_together() {
    let mut target = Screen::new(Rectangle::new(Point::zero(), Card.size_on_target()));
    let (mut row, window) = ([Gray8(0); WIDTH as usize], target.area);
    draw(&mut Card, Point::zero(), &mut row, &mut target, &window).unwrap();
    assert_eq!((target.filled, target.contiguous), (2 * 30, 30));
}

impl Card {
    fn size_on_target(&self) -> embedded_graphics::geometry::Size {
        embedded_graphics::geometry::Size::new(self.size().width().into(), 30)
    }
}

#[test]
fn errors_of_both_sides_come_through() {
    struct Broken;
    impl Dimensions for Broken {
        fn bounding_box(&self) -> Rectangle {
            Rectangle::new(Point::zero(), embedded_graphics::geometry::Size::new_equal(9))
        }
    }
    impl DrawTarget for Broken {
        type Color = Gray;
        type Error = u8;
        fn draw_iter<I: IntoIterator<Item = Pixel<Gray>>>(&mut self, _: I) -> Result<(), u8> {
            Err(42)
        }
    }
    let (mut short, mut row) = ([Gray8(0); 59], [Gray8(0); 60]);
    let window = Broken.bounding_box();
    let result = draw(&mut Card, Point::zero(), &mut short, &mut Broken, &window);
    assert_eq!(result, Err(DrawError::Render(RowError::Length)));
    let result = draw(&mut Card, Point::zero(), &mut row, &mut Broken, &window);
    assert_eq!(result, Err(DrawError::Target(42)));
    // Nothing is asked of either for what isn't seen.
    assert_eq!(draw(&mut Card, Point::new(9, 0), &mut short, &mut Broken, &window), Ok(()));
}

#[test]
fn nothing_is_drawn_beyond_the_last_coordinate() {
    /// A target without end.
    struct Plane(Vec<Point>);
    impl Dimensions for Plane {
        fn bounding_box(&self) -> Rectangle {
            Rectangle::new(Point::new(i32::MAX - 9, i32::MAX - 9), geometry::Size::new_equal(99))
        }
    }
    impl DrawTarget for Plane {
        type Color = Gray;
        type Error = core::convert::Infallible;
        fn draw_iter<I>(&mut self, _: I) -> Result<(), Self::Error> {
            unreachable!()
        }
        fn fill_contiguous<I: IntoIterator<Item = Gray>>(
            &mut self,
            area: &Rectangle,
            colors: I,
        ) -> Result<(), Self::Error> {
            for (x, _) in (area.top_left.x..=i32::MAX).zip(colors) {
                self.0.push(Point::new(x, area.top_left.y));
            }
            Ok(())
        }
    }
    let (mut plane, mut row) = (Plane(Vec::new()), [Gray8(0); 60]);
    let (at, window) = (Point::new(i32::MAX - 2, i32::MAX - 1), plane.bounding_box());
    draw(&mut Card, at, &mut row, &mut plane, &window).unwrap();
    let points = [0, 1].into_iter().flat_map(|y| (0..3).map(move |x| at + Point::new(x, y)));
    assert_eq!(plane.0, points.collect::<Vec<_>>());
}

#[test]
fn colors_have_the_bits_of_pixels() {
    for bits in 0..=u16::MAX {
        let color = pixelcolor::Rgb565::from(Rgb565(bits));
        let [r, g, b] = [bits >> 11, bits >> 5 & 63, bits & 31].map(|channel| channel as u8);
        assert_eq!(color, pixelcolor::Rgb565::new(r, g, b));
        assert_eq!(Rgb565::from(color), Rgb565(bits));
    }
    for level in 0..=255 {
        assert_eq!(Gray8::from(Gray::from(Gray8(level))), Gray8(level));
        assert_eq!(Gray::from(Gray8(level)).luma(), level);
        let color = Rgb::new(level, 255 - level, 77);
        let shaded = Rgb565::shaded(color, 200);
        assert_eq!(pixelcolor::Rgb565::shaded(color, 200), shaded.into());
        assert_eq!(pixelcolor::Rgb888::shaded(color, 200), Rgb888::shaded(color, 200).into());
        let swapped = pixelcolor::Bgr565::shaded(color, 200);
        assert_eq!(pixelcolor::Rgb565::from(swapped), shaded.into());
    }
    let color = pixelcolor::Rgb888::from(Rgb888([1, 2, 3]));
    assert_eq!(color, pixelcolor::Rgb888::new(1, 2, 3));
    assert_eq!(Rgb888::from(color), Rgb888([1, 2, 3]));
    assert_eq!(
        [Mono(false), Mono(true)].map(BinaryColor::from),
        [BinaryColor::Off, BinaryColor::On]
    );
    assert_eq!([BinaryColor::Off, BinaryColor::On].map(Mono::from), [Mono(false), Mono(true)]);
}

#[test]
fn a_ball_on_a_display_of_two_colors() {
    let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0).unwrap();
    let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    let camera = Orthographic::look_at(eye, target, up, 2.0).unwrap();
    let light = Lambert::new(vec3(0.0, 0.0, 1.0), 1.0).unwrap();
    let size = Size::new(6, 6).unwrap();
    let mut picture = Picture::new(&ball, &camera, size, light, BinaryColor::Off);
    let mut display = MockDisplay::<BinaryColor>::new();
    let window = display.bounding_box();
    let mut row = [BinaryColor::Off; 6];
    draw(&mut picture, Point::new(-1, 0), &mut row, &mut display, &window).unwrap();
    display.assert_pattern(&["####.", "#####", "#####", "#####", "#####", "####."]);
}

#[test]
fn errors_of_displays_are_handed_up() {
    let from = |error: DrawError<u8>| scancsg::Error::from(error);
    assert_eq!(from(DrawError::Target(7)), DisplayError::Draw.into());
    assert_eq!(from(DrawError::Target(7)).as_str(), DrawError::Target(7).as_str());
    assert_eq!(from(DrawError::Render(RowError::Length)), RowError::Length.into());
}
