//! The things that are used, each behind a feature.

use crate::scene::Scene;
use crate::scene::housing::HousingScene;
#[cfg(any(feature = "serde", feature = "mint"))]
use core::hint::black_box;
use scancsg::Error;
use scancsg::geom::OrthographicRays;
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, RowSource, Size};
use scancsg::solid::{Cuboid, Cylinder, Scan, Solid, Sphere};

const WIDTH: u16 = 160;
const HEIGHT: u16 = 120;

/// A number made of everything that is done, so that nothing is left out.
pub fn all<S: HousingScene>() -> Result<u32, Error>
where
    Cylinder<S>: Scan<OrthographicRays<S>, Scalar = S>,
    Cuboid<S>: Scan<OrthographicRays<S>, Scalar = S>,
    Sphere<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let camera = S::orthographic()?;
    let seen = if cfg!(feature = "program") {
        used(&crate::scene::program::tee::<S>()?, &camera)?
    } else if cfg!(feature = "housing") {
        used(&S::HOUSING, &camera)?
    } else {
        used(&S::TEE, &camera)?
    };
    let of_vectors: [u32; 2] = [mint::<S>(), serde()?];
    Ok(of_vectors.into_iter().fold(seen, u32::wrapping_add))
}

/// Renders a part, and does with the picture what features say.
fn used<S: Scene, T>(part: &T, camera: &Orthographic<S>) -> Result<u32, Error>
where
    T: Solid + Scan<OrthographicRays<S>, Scalar = S>,
{
    let light = Lambert::new(S::TO_LIGHT, S::hundredths(15))?;
    let size = Size::new(WIDTH, HEIGHT)?;
    let mut picture = Picture::new(part, camera, size, light, Gray8(0));
    let picture: &mut dyn RowSource<Pixel = Gray8> = &mut picture;
    let drawn = [plain(picture)?, predictive(picture)?, in_futures(picture)?, drawn(picture)?];
    let mut row = [Gray8(0); WIDTH as usize];
    let mut sum = drawn.into_iter().fold(0, u32::wrapping_add);
    for y in 0..HEIGHT {
        picture.render(y, &mut row)?;
        sum += row.iter().map(|pixel| u32::from(pixel.0)).sum::<u32>();
    }
    Ok(sum)
}

/// A line that nobody is at.
#[cfg(any(feature = "plain", feature = "predictive", feature = "async"))]
struct Line;

#[cfg(any(feature = "plain", feature = "predictive", feature = "async"))]
mod line {
    use super::Line;
    use core::convert::Infallible;
    use core::hint::black_box;

    impl embedded_io::ErrorType for Line {
        type Error = Infallible;
    }

    impl embedded_io::Read for Line {
        fn read(&mut self, bytes: &mut [u8]) -> Result<usize, Infallible> {
            black_box(bytes);
            Ok(0)
        }
    }

    impl embedded_io::ReadReady for Line {
        fn read_ready(&mut self) -> Result<bool, Infallible> {
            Ok(black_box(false))
        }
    }

    impl embedded_io::Write for Line {
        fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
            Ok(black_box(bytes).len())
        }

        fn flush(&mut self) -> Result<(), Infallible> {
            Ok(())
        }
    }
}

/// Declares a use: what it does with the feature, and nothing without it.
macro_rules! uses {
    ($($feature:literal: $name:ident($($source:ident)?) -> Result<u32, Error> $body:block)+) => {$(
        #[cfg(feature = $feature)]
        fn $name($($source: &mut dyn RowSource<Pixel = Gray8>)?) -> Result<u32, Error> $body

        #[cfg(not(feature = $feature))]
        fn $name($($source: &mut dyn RowSource<Pixel = Gray8>)?) -> Result<u32, Error> {
            $(let _ = $source;)?
            Ok(0)
        }
    )+};
}

uses! {
    "plain": plain(picture) -> Result<u32, Error> {
        use scancsg::stream::{Looks, Patience, PixelFormat, Plain, Sender, row_capacity, serve};
        const PACKET: usize = row_capacity(WIDTH, PixelFormat::Gray8);
        let mut sender = Sender::<_, PACKET>::new(Plain, Patience { ticks: 1000, silences: 1 });
        let mut row = [Gray8(0); WIDTH as usize];
        serve(picture, 0, &mut sender, &mut Line, &mut row, &mut Looks::new())?;
        Ok(sender.bytes_sent() as u32)
    }

    "predictive": predictive(picture) -> Result<u32, Error> {
        use scancsg::stream::{
            Looks, Patience, PixelFormat, Predictive, Sender, packet_capacity, serve,
        };
        const PACKET: usize = packet_capacity(WIDTH, PixelFormat::Gray8);
        let coding = Predictive::<Gray8, { WIDTH as usize }>::new();
        let mut sender = Sender::<_, PACKET>::new(coding, Patience { ticks: 1000, silences: 1 });
        let mut row = [Gray8(0); WIDTH as usize];
        serve(picture, 0, &mut sender, &mut Line, &mut row, &mut Looks::new())?;
        Ok(sender.bytes_sent() as u32)
    }

    "async": in_futures(picture) -> Result<u32, Error> {
        futures::sent(picture)
    }

    "embedded-graphics": drawn(picture) -> Result<u32, Error> {
        display::drawn(picture)
    }

    "serde": serde() -> Result<u32, Error> {
        use scancsg::program::BytesError;
        use scancsg::stream::EncodeError;
        let mut bytes = [0; 32];
        let size = black_box(Size::new(WIDTH, HEIGHT)?);
        let text = postcard::to_slice(&size, &mut bytes).map_err(|_| EncodeError::BufferTooSmall)?;
        let read: Size = postcard::from_bytes(black_box(text)).map_err(|_| BytesError::Length)?;
        Ok(read.width().into())
    }
}

/// The sum of a vector of `mint`'s.
#[cfg(feature = "mint")]
fn mint<S: Scene>() -> u32 {
    let point = black_box(mint::Point3::from(S::TO_LIGHT));
    let vector = scancsg::geom::Vec3::from(point);
    u32::from(vector.x.plus(vector.y).plus(vector.z) > S::ZERO)
}

#[cfg(not(feature = "mint"))]
fn mint<S: Scene>() -> u32 {
    0
}

#[cfg(feature = "async")]
mod futures {
    use super::{Line, WIDTH};
    use core::convert::Infallible;
    use core::future::{Future, pending};
    use core::pin::pin;
    use core::task::{Context, Poll, Waker};
    use scancsg::Error;
    use scancsg::render::{Gray8, RowSource};
    use scancsg::stream::{
        AsyncClock, Patience, PixelFormat, Predictive, Sender, packet_capacity, serve_async,
    };

    const PACKET: usize = packet_capacity(WIDTH, PixelFormat::Gray8);

    impl embedded_io_async::Read for Line {
        async fn read(&mut self, _: &mut [u8]) -> Result<usize, Infallible> {
            pending().await
        }
    }

    impl embedded_io_async::Write for Line {
        async fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
            Ok(core::hint::black_box(bytes).len())
        }

        async fn flush(&mut self) -> Result<(), Infallible> {
            Ok(())
        }
    }

    /// A clock on which every wait is over at once.
    struct Hasty(u32);

    impl AsyncClock for Hasty {
        fn now(&mut self) -> u32 {
            self.0
        }

        async fn wait(&mut self, ticks: u32) {
            self.0 = self.0.wrapping_add(ticks.max(1));
        }
    }

    pub fn sent(picture: &mut dyn RowSource<Pixel = Gray8>) -> Result<u32, Error> {
        let coding = Predictive::<Gray8, { WIDTH as usize }>::new();
        let mut sender = Sender::<_, PACKET>::new(coding, Patience { ticks: 1000, silences: 1 });
        let mut row = [Gray8(0); WIDTH as usize];
        let (mut line, mut clock) = (Line, Hasty(0));
        {
            let mut all =
                pin!(serve_async(picture, 0, &mut sender, &mut line, &mut row, &mut clock));
            let mut context = Context::from_waker(Waker::noop());
            loop {
                match all.as_mut().poll(&mut context) {
                    Poll::Ready(delivery) => {
                        delivery?;
                        break;
                    }
                    Poll::Pending => {}
                }
            }
        }
        Ok(sender.bytes_sent() as u32)
    }
}

#[cfg(feature = "embedded-graphics")]
mod display {
    use super::WIDTH;
    use core::convert::Infallible;
    use core::hint::black_box;
    use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
    use embedded_graphics_core::pixelcolor;
    use embedded_graphics_core::prelude::{DrawTarget, Pixel};
    use embedded_graphics_core::primitives::Rectangle;
    use scancsg::Error;
    use scancsg::interop::embedded_graphics::draw;
    use scancsg::render::{Gray8, RowSource};

    /// A display that shows nothing.
    struct Dark;

    impl OriginDimensions for Dark {
        fn size(&self) -> Size {
            Size::new(160, 128)
        }
    }

    impl DrawTarget for Dark {
        type Color = pixelcolor::Gray8;
        type Error = Infallible;

        fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
        where
            I: IntoIterator<Item = Pixel<pixelcolor::Gray8>>,
        {
            pixels.into_iter().for_each(|pixel| {
                black_box(pixel);
            });
            Ok(())
        }
    }

    pub fn drawn(picture: &mut dyn RowSource<Pixel = Gray8>) -> Result<u32, Error> {
        let mut row = [Gray8(0); WIDTH as usize];
        let window = Rectangle::new(Point::zero(), Size::new(160, 120));
        draw(picture, Point::zero(), &mut row, &mut Dark, &window)?;
        Ok(1)
    }
}
