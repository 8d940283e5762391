//! What a device does for a picture: rendered here by the same program, and counted.

use super::kind::Kind;
use super::leaf::Leaf;
use crate::error::Error;
use crate::map::Vector;
use crate::picture::View;
use scancsg::geom::{Line, OrthographicRays, Vec3};
use scancsg::program::{BytesError, Coded, Program, Reader, Writer};
use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Rgb, RowSource, Size};
use scancsg::scan::{ColumnRun, Empty, Scan};
use scancsg::solid::{Bounds, Solid};
use scancsg::span::walk::{Path, Step};
use scancsg::span::{Face, Shape, SpanStack};
use std::cell::Cell;
use std::thread;

const KINDS: usize = Kind::ALL.len();

/// How often something is done in a picture, by kinds of parts.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Pixels of the picture.
    pub pixels: u64,
    /// Pixels that show a part.
    pub shaded: u64,
    /// How often a part is made ready for a picture.
    pub views: [u64; KINDS],
    /// How often a part is made ready for a row.
    pub rows: [u64; KINDS],
    /// In how many pixels parts are asked for their spans: the first time, which computes them.
    pub rays: [u64; KINDS],
    /// How often parts are asked in all.
    pub asked: u64,
    /// How often parts are made ready for a run of columns.
    pub entered: u64,
    /// How often several parts are crossed at once, so that the whole tree is looked at.
    pub tied: u64,
    /// How often parts are asked then.
    pub asked_cold: u64,
}

thread_local! {
    /// The first face of the part that was asked last where several are crossed at once.
    static LAST: Cell<u16> = const { Cell::new(0) };
    static DONE: Cell<Work> = const {
        Cell::new(Work { pixels: 0, shaded: 0, views: [0; KINDS], rows: [0; KINDS], rays: [0; KINDS], asked: 0, entered: 0, tied: 0, asked_cold: 0 })
    };
}

fn note(change: impl FnOnce(&mut Work)) {
    DONE.with(|done| {
        let mut work = done.get();
        change(&mut work);
        done.set(work);
    });
}

/// The most parts and poses of a program that is rendered here.
pub(super) const PARTS: usize = 1024;
pub(super) const POSES: usize = 254;

/// Counts what a picture of a program in `f32` takes. The stack of a thread has room for the program.
///
/// # Errors
/// An [`Error`] for bytes that are no program here: of another number type, or of more than 1,024 parts.
pub(super) fn count(bytes: &[u8], view: &View, size: [u16; 2]) -> Result<Work, Error> {
    on_large_stack(|| rendered(bytes, view, size))
}

/// Does something that needs 64 MB of stack.
pub(super) fn on_large_stack<T: Send>(
    work: impl FnOnce() -> Result<T, Error> + Send,
) -> Result<T, Error> {
    let failed = || Error::limit("there is no memory for a program of 1,024 parts");
    thread::scope(|scope| {
        let builder = thread::Builder::new().stack_size(64 << 20);
        let thread = builder.spawn_scoped(scope, work).map_err(|_| failed())?;
        thread.join().map_err(|_| failed())?
    })
}

fn rendered(bytes: &[u8], view: &View, size: [u16; 2]) -> Result<Work, Error> {
    let wrong = |error: &dyn std::fmt::Display| Error::limit(error.to_string());
    let part = Program::<Counted, PARTS, POSES>::from_bytes(bytes).map_err(|e| wrong(&e))?;
    let narrow = |vector: Vector| vector.map(|part| part as f32);
    let [_, up, back] = view.angles.axes().map(narrow);
    let camera = Orthographic::look_along(-back, narrow(view.target), up, view.height as f32)
        .map_err(|error| wrong(&error))?;
    let light = Lambert::new(back, 0.0).map_err(|error| wrong(&error))?;
    let [width, height] = size;
    let size = Size::new(width, height).map_err(|error| wrong(&error))?;
    let mut picture = Picture::new(&part, &camera, size, light, Gray8(0));
    DONE.set(Work { pixels: u64::from(width) * u64::from(height), ..Work::default() });
    let mut row = vec![Gray8(0); width.into()];
    for y in 0..height {
        RowSource::render(&mut picture, y, &mut row).map_err(|error| wrong(&error))?;
    }
    Ok(DONE.get())
}

/// A part that counts what it is asked.
#[derive(Debug, Clone, Copy)]
struct Counted(Leaf<f32>);

/// A row of it, and the column that it was asked for last.
struct CountedRow<R> {
    row: R,
    column: i32,
}

impl<R: Empty> Empty for CountedRow<R> {
    const EMPTY: Self = Self { row: R::EMPTY, column: i32::MIN };
}

impl Counted {
    fn asked<R>(&self, row: &mut CountedRow<R>, column: i32) {
        let is_new = row.column != column;
        row.column = column;
        note(|work| {
            work.asked += 1;
            work.rays[self.0.kind_of() as usize] += u64::from(is_new);
        });
    }
}

impl Shape for Counted {
    type Scalar = f32;
    const SPANS: usize = Leaf::<f32>::SPANS;
    const STACK: usize = Leaf::<f32>::STACK;
    const FACES: u16 = Leaf::<f32>::FACES;
}

impl Solid for Counted {
    fn spans(&self, line: &Line<f32>, first: Face, stack: &mut SpanStack<'_, f32>) {
        self.0.spans(line, first, stack);
    }

    fn normal(&self, face: Face, at: Vec3<f32>) -> Vec3<f32> {
        self.0.normal(face, at)
    }

    fn bounds(&self) -> Bounds<f32> {
        self.0.bounds()
    }

    fn cosine(&self, face: Face, at: impl FnOnce() -> Vec3<f32>, to: Vec3<f32>) -> f32 {
        note(|work| work.shaded += 1);
        self.0.cosine(face, at, to)
    }

    fn color(&self, face: Face) -> Option<Rgb> {
        self.0.color(face)
    }
}

impl Coded for Counted {
    fn has_kind(kind: u8) -> bool {
        Leaf::<f32>::has_kind(kind)
    }

    fn kind(&self) -> u8 {
        self.0.kind()
    }

    fn write(&self, to: &mut Writer<'_>) -> Result<(), BytesError> {
        self.0.write(to)
    }

    fn read(kind: u8, from: &mut Reader<'_>) -> Result<Self, BytesError> {
        Leaf::read(kind, from).map(Self)
    }
}

type Rays = OrthographicRays<f32>;

impl Scan<Rays> for Counted {
    type View = <Leaf<f32> as Scan<Rays>>::View;
    type Row = CountedRow<<Leaf<f32> as Scan<Rays>>::Row>;

    fn view(&self, rays: &Rays, view: &mut Self::View) {
        note(|work| work.views[self.0.kind_of() as usize] += 1);
        Scan::<Rays>::view(&self.0, rays, view);
    }

    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        Scan::<Rays>::is_in_rows(&self.0, view, rows)
    }

    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
        note(|work| work.rows[self.0.kind_of() as usize] += 1);
        row.column = i32::MIN;
        Scan::<Rays>::row(&self.0, view, y, columns, &mut row.row);
    }

    fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
        note(|work| work.entered += 1);
        <Leaf<f32> as Scan<Rays>>::enter(&mut row.row, column)
    }

    fn contains<P: Path>(&self, view: &Self::View, row: &mut Self::Row, x: i32, t: f32) -> bool {
        self.asked(row, x);
        Scan::<Rays>::contains::<P>(&self.0, view, &mut row.row, x, t)
    }

    fn step<P: Path>(
        &self,
        view: &Self::View,
        row: &mut Self::Row,
        x: i32,
        t: f32,
        first: Face,
    ) -> Step<f32> {
        self.asked(row, x);
        if P::IS_COLD {
            // Parts are asked in their order: a smaller one is asked for another crossing.
            let is_new = first.0 <= LAST.replace(first.0);
            note(|work| {
                work.tied += u64::from(is_new);
                work.asked_cold += 1;
            });
        }
        Scan::<Rays>::step::<P>(&self.0, view, &mut row.row, x, t, first)
    }
}
