//! The memory of the span merge: a fixed array, and the stack that solids push to.

use super::Span;
use heapless::{Vec, VecView};

/// Room for the spans of a line with a solid, and for merging them.
///
/// `N` must be at least the [`Shape::STACK`](crate::solid::Shape::STACK) of the solid; less does
/// not compile:
///
/// ```
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::solid::{Shape, Solid, Sphere, Union};
/// use scancsg::span::SpanList;
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
/// use scancsg::solid::{Shape, Solid, Sphere, Union};
/// use scancsg::span::SpanList;
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
    pub const fn new() -> Self {
        Self { spans: Vec::new() }
    }

    /// The spans, in ascending order.
    #[must_use]
    pub fn as_slice(&self) -> &[Span<S>] {
        &self.spans
    }

    /// Empties the list and lends it out as a stack.
    pub fn stack(&mut self) -> SpanStack<'_, S> {
        self.spans.clear();
        SpanStack { spans: &mut self.spans }
    }

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
    /// Puts a span on top. On a full stack nothing happens: the capacity is checked against the
    /// solid's type when the program is compiled, so a solid that keeps to its type never gets
    /// there.
    #[inline]
    pub fn push(&mut self, span: Span<S>) {
        let pushed = self.spans.push(span);
        debug_assert!(pushed.is_ok(), "a solid has more spans than its type says");
    }

    /// How many spans there are, those of other solids included.
    #[must_use]
    #[inline]
    pub fn len(&self) -> usize {
        self.spans.len()
    }

    /// Whether there is no span at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.spans.is_empty()
    }
}
