//! What the page calls.
//!
//! A name that isn't mangled could clash with another one of the program, which is why the attribute is
//! unsafe. A module for a browser is a program of its own, and nothing else is linked to it.

#![allow(unsafe_code)]

use crate::draw::{self, Wish};
use crate::view::View;
use scancsg::stream::PixelFormat;
use std::cell::RefCell;

#[derive(Default)]
struct State {
    view: Option<View>,
    input: Vec<u8>,
    /// So many bytes of the input have been taken in.
    taken: usize,
    drawn: Vec<u8>,
    text: String,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::default();
}

fn with<T>(act: impl FnOnce(&mut State) -> T) -> T {
    STATE.with_borrow_mut(act)
}

fn viewing<T: Default>(act: impl FnOnce(&mut View) -> T) -> T {
    with(|state| state.view.as_mut().map(act).unwrap_or_default())
}

/// Makes room for `len` bytes of the line: the page writes them there, and then calls [`receive`].
#[unsafe(no_mangle)]
pub extern "C" fn input(len: usize) -> *mut u8 {
    with(|state| {
        state.input.clear();
        state.input.resize(len, 0);
        state.taken = 0;
        state.input.as_mut_ptr()
    })
}

/// Takes in bytes of the input up to the next [`News`](crate::view::News), whose number it returns. 0 if
/// all have been taken in. `now` is in milliseconds.
#[unsafe(no_mangle)]
pub extern "C" fn receive(now: u32) -> u32 {
    with(|state| {
        let mut bytes = state.input.get(state.taken..).unwrap_or_default();
        let news = state.view.get_or_insert_default().receive(&mut bytes, now);
        state.taken = state.input.len() - bytes.len();
        news as u32
    })
}

/// Looks at the clock: returns the news as [`receive`] does.
#[unsafe(no_mangle)]
pub extern "C" fn tick(now: u32) -> u32 {
    viewing(|view| view.tick(now) as u32)
}

/// Prepares the next answer to the sender. Returns its length; 0 if there is none.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    viewing(|view| if view.next_answer() { view.answer().len() } else { 0 })
}

/// Where the answer is.
#[unsafe(no_mangle)]
pub extern "C" fn answer_at() -> *const u8 {
    with(|state| state.view.as_ref().map_or(std::ptr::null(), |view| view.answer().as_ptr()))
}

/// A figure of the receiver: 0 width, 1 height, 2 format, 3 the frame's id, 4 rows received, 5 complete
/// frames, 6 lost frames, 7 bytes, 8 packets, 9 damaged packets, 10 requests.
#[unsafe(no_mangle)]
pub extern "C" fn figure(which: u32) -> f64 {
    viewing(|view| {
        let header = view.header();
        let of = |field: fn(scancsg::stream::FrameHeader) -> u16| header.map_or(0, field).into();
        let (traffic, [complete, lost]) = (view.traffic(), view.frames());
        let figure: u64 = match which {
            0 => of(|header| header.width),
            1 => of(|header| header.height),
            2 => of(|header| header.format.code().into()),
            3 => of(|header| header.frame),
            4 => view.rows_received().into(),
            5 => complete,
            6 => lost,
            7 => traffic.bytes,
            8 => traffic.packets,
            9 => traffic.bad_packets,
            10 => traffic.requests,
            _ => 0,
        };
        figure as f64
    })
}

/// Where the received frame is, as pixels of a canvas.
#[unsafe(no_mangle)]
pub extern "C" fn received() -> *const u8 {
    with(|state| state.view.as_ref().map_or(std::ptr::null(), |view| view.canvas().as_ptr()))
}

/// Draws `count` rows from `y` on; see [`Wish`] for what the others mean. Returns where the rows are, as
/// pixels of a canvas; null if the picture can't be drawn: then [`text`] says why, [`text_at`] where.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments)] // numbers are all that a page can pass
pub extern "C" fn draw(
    scene: usize,
    is_fixed: bool,
    is_perspective: bool,
    format: u32,
    smooth: u32,
    turn: f64,
    width: u32,
    height: u32,
    y: u32,
    count: u32,
) -> *const u8 {
    with(|state| {
        let short = |number: u32| u16::try_from(number).unwrap_or(u16::MAX);
        let format = u8::try_from(format).ok().and_then(PixelFormat::from_code);
        let wish = Wish {
            scene,
            is_fixed,
            is_perspective,
            format: format.unwrap_or(PixelFormat::Gray8),
            smooth: short(smooth),
            turn,
            size: [width, height].map(short),
        };
        state.drawn.resize(4 * usize::from(wish.size[0]) * usize::from(short(count)), 0);
        match draw::draw(wish, short(y), &mut state.drawn) {
            Ok(()) => state.drawn.as_ptr(),
            Err(error) => {
                state.text = error.to_string();
                std::ptr::null()
            }
        }
    })
}

/// Makes a text of the scenes: a line for each, of its name, a tab, and what it is. Returns its length in
/// bytes; [`text_at`] says where it is.
#[unsafe(no_mangle)]
pub extern "C" fn scenes() -> usize {
    with(|state| {
        let lines: Vec<String> = draw::scenes().iter().map(|scene| scene.join("\t")).collect();
        state.text = lines.join("\n");
        state.text.len()
    })
}

/// The length of the text, in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> usize {
    with(|state| state.text.len())
}

/// Where the text is.
#[unsafe(no_mangle)]
pub extern "C" fn text_at() -> *const u8 {
    with(|state| state.text.as_ptr())
}
