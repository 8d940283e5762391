//! Pictures: what a camera sees of a scene, row by row.

use crate::border::{self, Kept, Plain};
use crate::capacity::{PART_WORDS, PARTS};
use crate::lent::{Fill, Lent};
use crate::number::{Number, Scalar, scalar, vector};
use crate::part::Program;
use crate::pixels::{Format, Lit};
use crate::scene::{KeptScene, Scene};
use crate::status::Status;
use core::cell::Cell;
use core::ops::Range;
use scancsg::geom::{OrthographicRays, PerspectiveRays, Rays};
use scancsg::render::{self, Camera, Lambert, Orthographic, Perspective, Pixel, Rgb, Run, Size};
use scancsg::scan::{Empty, Scan};

/// A camera, a light, and the size of a picture.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C)]
pub struct View {
    /// The camera looks from here. Without perspective only the direction to the target counts.
    pub eye: [Number; 3],
    /// The middle of the picture.
    pub target: [Number; 3],
    /// What points upwards in the picture, of any length.
    pub up: [Number; 3],
    /// What the picture shows from its upper to its lower edge: units of the scene, or in perspective an
    /// angle in radians.
    pub extent: Number,
    /// The direction to the light, of any length.
    pub to_light: [Number; 3],
    /// The light of what the light doesn't reach: 0 to 1.
    pub ambient: Number,
    /// The number of columns.
    pub width: u16,
    /// The number of rows.
    pub height: u16,
    /// Where nothing is seen: red, green, blue.
    pub background: [u8; 3],
    /// The bytes up to the structure's size.
    pub reserved: u8,
}

// SAFETY: it is integers and numbers, and has no padding.
unsafe impl Plain for View {}

/// The memory of a picture: a variable of this type, or an allocation of its size. It isn't moved while the
/// picture is used.
#[repr(C)]
pub struct Picture {
    words: [u64; PICTURE_WORDS],
}

/// The size of a picture, in words of eight bytes.
pub const PICTURE_WORDS: usize = PARTS * PART_WORDS + 48;

/// Renders columns of a row of a picture into their bytes.
type Render = unsafe fn(*mut Head, u16, Range<u16>, Format, &mut [u8]) -> Result<(), Status>;

/// What all pictures have.
#[repr(C)]
pub(crate) struct Head {
    mark: u32,
    /// The number of edits of the scene when the picture was made.
    edits: u32,
    scene: *const Scene,
    pub(crate) size: Size,
    /// Renders columns of a row; only the cameras that a program names are linked.
    render: Render,
}

// SAFETY: the mark is the first field, and always `MARK`; it owns nothing.
unsafe impl Kept for Head {
    type Storage = Picture;
    const MARK: u32 = 0x5363_5001;
}

/// What is in a picture's memory.
#[repr(C)]
struct KeptPicture<R: Rays + 'static>
where
    Program: Scan<R>,
{
    head: Head,
    view: <Program as Scan<R>>::View,
    row: <Program as Scan<R>>::Row,
    solid: Lent<R>,
    picture: render::Picture<'static, Lent<R>, R, Lambert<Scalar>, Lit>,
}

// SAFETY: it begins with a `Head`, which begins with the mark. Nothing in it is dropped.
unsafe impl Kept for KeptPicture<OrthographicRays<Scalar>> {
    type Storage = Picture;
    const MARK: u32 = Head::MARK;
}

// SAFETY: as above.
unsafe impl Kept for KeptPicture<PerspectiveRays<Scalar>> {
    type Storage = Picture;
    const MARK: u32 = Head::MARK;
}

/// Makes a picture without perspective: all its rays are parallel. `size` is `sizeof *picture`.
///
/// The picture refers to the scene, which must stay where it is. When the scene has changed, the picture is to
/// be made again. Unless the status is `SCANCSG_STATUS_OK`, the picture isn't made.
///
/// # Safety
/// `picture` has `size` bytes, `scene` is a scene's memory, `view` points to one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_picture_orthographic(
    picture: *mut Picture,
    size: usize,
    scene: *const Scene,
    view: *const View,
) -> Status {
    // SAFETY: the caller says the same.
    Status::of(unsafe {
        make::<Orthographic<Scalar>>(picture, size, scene, view, |view| {
            Ok(Orthographic::look_at(
                vector(view.eye),
                vector(view.target),
                vector(view.up),
                scalar(view.extent),
            )?)
        })
    })
}

/// Makes a picture in perspective: its rays come from the eye. Otherwise it is as
/// `scancsg_picture_orthographic`.
///
/// # Safety
/// As there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_picture_perspective(
    picture: *mut Picture,
    size: usize,
    scene: *const Scene,
    view: *const View,
) -> Status {
    // SAFETY: the caller says the same.
    Status::of(unsafe {
        make::<Perspective<Scalar>>(picture, size, scene, view, |view| {
            Ok(Perspective::look_at(
                vector(view.eye),
                vector(view.target),
                vector(view.up),
                scalar(view.extent),
            )?)
        })
    })
}

/// Makes a picture in its place.
///
/// # Safety
/// As [`scancsg_picture_orthographic`].
#[inline]
unsafe fn make<C: Camera>(
    picture: *mut Picture,
    size: usize,
    storage: *const Scene,
    view: *const View,
    camera: fn(&View) -> Result<C, Status>,
) -> Result<(), Status>
where
    C::Rays: Rays<Scalar = Scalar> + 'static,
    Program: Scan<C::Rays, View: Fill>,
    KeptPicture<C::Rays>: Kept<Storage = Picture>,
{
    let place = border::place::<KeptPicture<C::Rays>>(picture, size)?;
    // SAFETY: the caller has lent all of them, the scene for as long as the picture is used.
    let (scene, view) = unsafe {
        border::clear(place);
        (border::kept::<KeptScene>(storage)?, border::read(view)?)
    };
    let camera = camera(&view)?;
    let light = Lambert::new(vector(view.to_light), scalar(view.ambient))?;
    let size = Size::new(view.width, view.height)?;
    let [r, g, b] = view.background;
    let background = Lit::shaded(Rgb::new(r, g, b), u8::MAX);
    let head = Head {
        mark: Head::MARK,
        edits: scene.edits,
        scene: storage,
        size,
        render: render::<C::Rays>,
    };
    // SAFETY: the place is aligned and large enough, and the caller has lent it for as long as the picture is
    // used. Each field is written, and then nobody but the reference made here has it.
    unsafe {
        let (view, row) = (&raw mut (*place).view, &raw mut (*place).row);
        Fill::fill(view);
        row.write(Empty::EMPTY);
        let solid = &raw mut (*place).solid;
        let (view, row) = (Cell::new(Some(&mut *view)), Cell::new(Some(&mut *row)));
        solid.write(Lent { program: &scene.program, view, row });
        let picture = render::Picture::new(&*solid, &camera, size, light, background);
        (&raw mut (*place).picture).write(picture);
        (&raw mut (*place).head).write(head);
    }
    Ok(())
}

/// The columns that are rendered together.
const CHUNK: u16 = 32;

/// Renders columns of a row into their bytes.
///
/// # Safety
/// `head` is that of a picture that was made with this kind of rays, and its scene hasn't changed.
unsafe fn render<R>(
    head: *mut Head,
    y: u16,
    columns: Range<u16>,
    format: Format,
    bytes: &mut [u8],
) -> Result<(), Status>
where
    R: Rays<Scalar = Scalar> + 'static,
    Program: Scan<R>,
{
    // SAFETY: the caller says so, and a picture begins with its head.
    let picture = unsafe { &mut (*head.cast::<KeptPicture<R>>()).picture };
    let mut scanline = picture.scanline(y)?;
    let mut chunk = [Lit::BLACK; CHUNK as usize];
    let mut start = columns.start;
    for bytes in bytes.chunks_mut(format.bytes(CHUNK.into())) {
        let end = start.saturating_add(CHUNK).min(columns.end);
        let pixels = chunk.get_mut(..usize::from(end.saturating_sub(start))).unwrap_or_default();
        scanline.render_run(&Run { columns: start..end, is_background: false }, pixels)?;
        format.write(pixels, bytes);
        start = end;
    }
    Ok(())
}

/// A picture that is made, and whose scene is as it was then.
///
/// # Safety
/// `picture` is a picture's memory, its scene is where it was.
pub(crate) unsafe fn current<'a>(picture: *const Picture) -> Result<&'a Head, Status> {
    // SAFETY: the caller says the same, for the scene too.
    unsafe {
        let head = border::kept::<Head>(picture)?;
        let scene = border::kept::<KeptScene>(head.scene)?;
        if scene.edits == head.edits { Ok(head) } else { Err(Status::Changed) }
    }
}

/// Renders some columns of row `y`, counted from the top: those from `first` on, `count` of them. They have the
/// bits that a whole row has there.
///
/// `format` is a `scancsg_format`. `bytes` must be just as many as the pixels have, or nothing is written.
///
/// # Safety
/// `picture` is a picture's memory, `pixels` has so many `bytes`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_picture_run(
    picture: *mut Picture,
    y: u16,
    first: u16,
    count: u16,
    format: u8,
    pixels: *mut u8,
    bytes: usize,
) -> Status {
    let show = || {
        // SAFETY: the caller says the same.
        let Head { size, render, .. } = *unsafe { current(picture) }?;
        let format = Format::of(format)?;
        let end = first.checked_add(count).filter(|end| *end <= size.width());
        let columns = first..end.ok_or(Status::Index)?;
        if y >= size.height() {
            return Err(Status::Index);
        }
        if bytes != format.bytes(columns.len()) {
            return Err(Status::Length);
        }
        // SAFETY: the caller has lent the bytes; the picture was made with its own `render`.
        unsafe {
            let pixels = border::room(pixels, bytes)?;
            render(picture.cast(), y, columns, format, pixels)
        }
    };
    Status::of(show())
}

/// Renders row `y`, counted from the top. Rows may be rendered in any order, and again.
///
/// `format` is a `scancsg_format`. `bytes` must be just as many as a row has, or nothing is written.
///
/// # Safety
/// As `scancsg_picture_run`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn scancsg_picture_row(
    picture: *mut Picture,
    y: u16,
    format: u8,
    pixels: *mut u8,
    bytes: usize,
) -> Status {
    // SAFETY: the caller says the same.
    match unsafe { current(picture) } {
        // SAFETY: as above.
        Ok(head) => unsafe {
            scancsg_picture_run(picture, y, 0, head.size.width(), format, pixels, bytes)
        },
        Err(status) => status,
    }
}
