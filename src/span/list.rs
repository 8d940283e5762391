//! The memory of the span merge: a fixed array, and the stack that solids push to.

use super::span::{Face, Span};
use crate::scalar::Scalar;
use heapless::{Vec, VecView};

/// Room for the spans of a line with a solid, and for merging them.
///
/// `N` must be at least the [`Shape::STACK`](crate::span::Shape::STACK) of the solid; less does
/// not compile:
///
/// ```
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::solid::{RayCast, Sphere, Union};
/// use scancsg::span::{Shape, SpanList};
///
/// type Pair = Union<Sphere<f32>, Sphere<f32>>;
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let pair: Pair = ball | Sphere::<f32>::new(vec3(3.0, 0.0, 0.0), 1.0)?;
/// let ray = Ray::new(vec3(-9.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0))?;
/// let mut list = SpanList::<f32, { Pair::STACK }>::new();
/// assert_eq!(pair.trace(&ray, &mut list).len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// ```compile_fail,E0080
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::solid::{RayCast, Sphere, Union};
/// use scancsg::span::{Shape, SpanList};
///
/// type Pair = Union<Sphere<f32>, Sphere<f32>>;
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let pair: Pair = ball | Sphere::<f32>::new(vec3(3.0, 0.0, 0.0), 1.0)?;
/// let ray = Ray::new(vec3(-9.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0))?;
/// let mut list = SpanList::<f32, 3>::new();
/// assert_eq!(pair.trace(&ray, &mut list).len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct SpanList<S, const N: usize> {
    spans: Vec<Span<S>, N>,
}

impl<S, const N: usize> SpanList<S, N> {
    /// An empty list.
    #[must_use]
    #[inline]
    pub const fn new() -> Self {
        Self { spans: Vec::new() }
    }

    /// The spans, in ascending order.
    #[must_use]
    #[inline]
    pub fn as_slice(&self) -> &[Span<S>] {
        &self.spans
    }

    /// Empties the list and lends it out as a stack.
    #[inline]
    pub fn stack(&mut self) -> SpanStack<'_, S> {
        self.spans.clear();
        SpanStack { spans: &mut self.spans }
    }

    #[inline]
    pub(crate) fn as_mut_slice(&mut self) -> &mut [Span<S>] {
        &mut self.spans
    }
}

impl<S, const N: usize> Default for SpanList<S, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S, const N: usize> core::ops::Deref for SpanList<S, N> {
    type Target = [Span<S>];

    #[inline]
    fn deref(&self) -> &[Span<S>] {
        &self.spans
    }
}

/// Where a solid puts the spans of a line: the part of a [`SpanList`] above those already there.
///
/// One type for lists of every capacity, so that what uses it is compiled once.
#[derive(Debug)]
pub struct SpanStack<'a, S> {
    pub(super) spans: &'a mut VecView<Span<S>>,
}

impl<S> SpanStack<'_, S> {
    /// Puts a span on top.
    ///
    /// # Errors
    /// [`StackFull`]; the spans are as they were.
    #[inline]
    pub fn push(&mut self, span: Span<S>) -> Result<(), StackFull> {
        self.spans.push(span).map_err(|_| StackFull)
    }

    /// [`push`](Self::push) for solids: their need of room is a constant of their types, and a
    /// list with less does not compile. So nothing is ever left out here.
    #[inline]
    pub(crate) fn put(&mut self, span: Span<S>) {
        let _ = self.push(span);
    }

    /// [`put`](Self::put) for all spans of a primitive, with its faces counted from `first` on.
    #[inline(always)]
    pub(crate) fn put_all(&mut self, spans: impl IntoIterator<Item = Span<S>>, first: Face)
    where
        S: Scalar,
    {
        for span in spans {
            self.put(span.with_faces_from(first));
        }
    }

    /// How many spans there are, those of other solids included.
    #[must_use]
    #[inline]
    pub fn len(&self) -> usize {
        self.spans.len()
    }

    /// How many more spans there is room for.
    #[inline]
    pub(crate) fn room(&self) -> usize {
        self.spans.capacity() - self.spans.len()
    }

    /// Drops the spans from `start` on.
    pub(crate) fn truncate(&mut self, start: usize) {
        self.spans.truncate(start);
    }

    /// Drops the spans from `start` on that have no length, or don't lie behind the one before them.
    pub(crate) fn keep_ordered(&mut self, start: usize)
    where
        S: PartialOrd + Copy,
    {
        let (mut kept, mut last) = (start, None);
        for index in start..self.spans.len() {
            let Some(&span) = self.spans.get(index) else { break };
            if span.enter.t < span.exit.t && last.is_none_or(|last| last < span.enter.t) {
                if let Some(place) = self.spans.get_mut(kept) {
                    *place = span;
                }
                (kept, last) = (kept + 1, Some(span.exit.t));
            }
        }
        self.spans.truncate(kept);
    }

    /// Takes the parameters of the spans from `start` on to those of another line that is the same but for
    /// where it is counted from, and how fast. A span whose ends round to one number keeps a length.
    pub(crate) fn recount(&mut self, start: usize, of: impl Fn(S) -> S)
    where
        S: Scalar,
    {
        for Span { enter, exit } in self.spans.iter_mut().skip(start) {
            (enter.t, exit.t) = (of(enter.t), of(exit.t));
            if enter.t == exit.t {
                exit.t = exit.t.negated().next_below().negated();
            }
        }
        self.keep_ordered(start);
    }

    /// Whether there is no span at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.spans.is_empty()
    }
}

/// A list is logged as its spans.
#[cfg(feature = "defmt")]
mod logged {
    use super::{SpanList, SpanStack};

    impl<S: defmt::Format, const N: usize> defmt::Format for SpanList<S, N> {
        fn format(&self, f: defmt::Formatter<'_>) {
            defmt::write!(f, "{=[?]}", self.spans.as_slice());
        }
    }

    impl<S: defmt::Format> defmt::Format for SpanStack<'_, S> {
        fn format(&self, f: defmt::Formatter<'_>) {
            defmt::write!(f, "{=[?]}", self.spans.as_slice());
        }
    }
}

/// A list of spans has no room left.
///
/// It can't happen to the crate's own solids, whose need of room is a constant of their types.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StackFull;

impl StackFull {
    /// What is wrong, in a sentence.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        "the list of spans has no room left"
    }
}

impl core::fmt::Display for StackFull {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.as_str())
    }
}

impl core::error::Error for StackFull {}
