//! Fixed point where its range or its digits end.

mod extremes;
mod perspective;
