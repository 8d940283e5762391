//! What can go wrong with a part, and on which line.

use std::fmt;

/// Why a part can't be read or modelled.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Error {
    /// The line of the file, counted from 1. Zero if it is no line's fault.
    pub line: usize,
    /// What is wrong.
    pub kind: ErrorKind,
}

/// Kinds of [`Error`]s.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The text isn't that of a `.csg` file: what was expected, and what is there.
    Syntax(String),
    /// An argument is missing or isn't of the kind that the node needs.
    Argument(String),
    /// A node, or a use of it, that the importer doesn't model.
    NotModelled(String),
    /// The part is too large or too deep.
    Limit(String),
    /// A file can't be read or written, or `openscad` can't be run.
    File(String),
}

impl Error {
    pub(crate) fn not_modelled(line: usize, what: impl Into<String>) -> Self {
        Self { line, kind: ErrorKind::NotModelled(what.into()) }
    }

    pub(crate) fn argument(line: usize, what: impl Into<String>) -> Self {
        Self { line, kind: ErrorKind::Argument(what.into()) }
    }

    pub(crate) fn syntax(line: usize, what: impl Into<String>) -> Self {
        Self { line, kind: ErrorKind::Syntax(what.into()) }
    }

    pub(crate) fn limit(what: impl Into<String>) -> Self {
        Self { line: 0, kind: ErrorKind::Limit(what.into()) }
    }

    /// A file that can't be read or written.
    #[must_use]
    pub fn file(what: impl Into<String>) -> Self {
        Self { line: 0, kind: ErrorKind::File(what.into()) }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.line > 0 {
            write!(f, "line {}: ", self.line)?;
        }
        match &self.kind {
            ErrorKind::NotModelled(what) => write!(f, "not modelled: {what}"),
            ErrorKind::Syntax(what)
            | ErrorKind::Argument(what)
            | ErrorKind::Limit(what)
            | ErrorKind::File(what) => f.write_str(what),
        }
    }
}

impl std::error::Error for Error {}
