//! The growing picture in the terminal, above some lines of figures.

use super::picture::half_blocks;
use console::Term;
use scancsg::stream::Assembler;
use std::time::{Duration, Instant};

/// Drawing takes time; this is often enough.
const PAUSE: Duration = Duration::from_millis(66);

/// Shows frames while they arrive. Where standard error is no terminal, it shows nothing.
pub struct Screen {
    term: Term,
    /// So many lines are drawn, and will be drawn over.
    lines: usize,
    drawn: Option<Instant>,
}

impl Screen {
    pub fn new() -> Self {
        Self { term: Term::stderr(), lines: 0, drawn: None }
    }

    /// Whether it is time to draw again.
    pub fn is_due(&self) -> bool {
        self.term.is_term() && self.drawn.is_none_or(|drawn| drawn.elapsed() >= PAUSE)
    }

    /// Whether anything is drawn.
    pub fn is_terminal(&self) -> bool {
        self.term.is_term()
    }

    /// The terminal's width.
    pub fn columns(&self) -> usize {
        usize::from(self.term.size().1).max(20)
    }

    /// Draws what is there of a frame, and the lines below it.
    pub fn draw(&mut self, frame: &Assembler<'_>, figures: &[String]) {
        if !self.term.is_term() {
            return;
        }
        self.drawn = Some(Instant::now());
        // One line is for the shell's prompt.
        let room = usize::from(self.term.size().0).saturating_sub(figures.len() + 1).max(1);
        let mut all = half_blocks(frame, room, self.columns());
        let cut = |line: &String| console::truncate_str(line, self.columns(), "").into_owned();
        all.extend(figures.iter().map(cut));
        // In one piece, and over what is there: it doesn't flicker.
        let mut text = self.back();
        for line in &all {
            text += line;
            text += "\x1b[K\n";
        }
        text += "\x1b[J";
        self.lines = all.len();
        let _ = self.term.write_str(&text);
    }

    /// Writes a line above the picture, to stay.
    pub fn note(&mut self, line: &str) {
        if self.term.is_term() {
            let _ = self.term.write_str(&format!("{}\x1b[J{line}\n", self.back()));
            (self.lines, self.drawn) = (0, None);
        } else {
            eprintln!("{line}");
        }
    }

    /// What moves the cursor to where the picture begins.
    fn back(&self) -> String {
        match self.lines {
            0 => String::new(),
            lines => format!("\x1b[{lines}A\r"),
        }
    }
}
