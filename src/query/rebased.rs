//! Rebased rays: their parameter is counted from elsewhere than their start.
//!
//! That pays where they start far from everything, and costs bits near their start. So if a crossing
//! is closer to the start than to the rebased origin, the ray is asked a second time, counted from its
//! start. Crossings near the start come from the second answer, all others from the first.

use super::hit::{Seen, first_seen};
use crate::geom::{Line, Ray};
use crate::query::Solid;
use crate::scalar::{Number, Real, Scalar};
use crate::span::{Crossing, Face, Span, SpanList, check_room};

/// Fills the list with the spans of a line, in the line's own parameter.
#[inline(always)]
pub(super) fn line_spans<T: Solid + ?Sized, const N: usize>(
    solid: &T,
    line: &Line<T::Scalar>,
    list: &mut SpanList<T::Scalar, N>,
) {
    const { check_room(N, T::STACK) };
    solid.spans(line, Face(0), &mut list.stack());
}

/// True if a crossing is closer to the ray's start than to the rebased origin, or if the ray looks away
/// from there: then it is asked a second time, counted from the start.
#[inline]
pub(super) fn is_near_start<S: Scalar>(ray: &Ray<S>, spans: &[Span<S>]) -> bool {
    let looks_away = ray.start() > S::ZERO;
    ray.is_moved() && (looks_away || crossings(spans).any(|crossing| ray.is_near_start(crossing.t)))
}

/// The spans of such a ray in its own parameter.
// A list of its own: written through a reference, the caller's couldn't stay in registers for all other
// rays, which costs these 20 instructions on a Cortex-M4F.
#[cold]
#[inline(never)]
pub(super) fn trace_rebased<T: Solid + ?Sized, const N: usize>(
    solid: &T,
    ray: &Ray<T::Scalar>,
) -> SpanList<T::Scalar, N> {
    let mut list = SpanList::new();
    line_spans(solid, ray.line(), &mut list);
    let has_near = is_near_start(ray, &list);
    count_from_start(ray, &mut list);
    if has_near {
        add_near(solid, ray, &mut list);
    }
    for Span { enter, exit } in list.as_mut_slice() {
        (enter.t, exit.t) = (ray.scaled(enter.t), ray.scaled(exit.t));
    }
    list
}

/// What such a ray sees, and the ray as it is counted there; `moved` are its spans.
#[cold]
#[inline(never)]
pub(super) fn seen_near<S: Scalar, T: Solid<Scalar = S> + ?Sized, const N: usize>(
    solid: &T,
    ray: &Ray<S>,
    moved: &SpanList<S, N>,
) -> Option<(Ray<S>, Seen<S>)> {
    let mut list = moved.clone();
    count_from_start(ray, &mut list);
    add_near(solid, ray, &mut list);
    let seen = first_seen(&list, S::ZERO)?;
    // Far away, the ray's point is known better from where its parameter is counted from.
    let is_seen = |crossing: &Crossing<S>| {
        crossing.face == seen.face && ray.since_start(crossing.t) == seen.t
    };
    let far = crossings(moved).find(is_seen).filter(|crossing| !ray.is_near_start(crossing.t));
    Some(match far {
        Some(Crossing { t, .. }) => (*ray, Seen { t, ..seen }),
        None => (ray.from_start(), seen),
    })
}

/// Turns the line's parameters into those that are counted from the start.
#[inline]
fn count_from_start<S: Scalar, const N: usize>(ray: &Ray<S>, list: &mut SpanList<S, N>) {
    for Span { enter, exit } in list.as_mut_slice() {
        (enter.t, exit.t) = (ray.since_start(enter.t), ray.since_start(exit.t));
    }
}

/// Replaces what is nearer to the start by what the ray has there if it is counted from its start. All
/// parameters are counted from there.
fn add_near<T: Solid + ?Sized, const N: usize>(
    solid: &T,
    ray: &Ray<T::Scalar>,
    list: &mut SpanList<T::Scalar, N>,
) {
    let mut near = SpanList::<T::Scalar, N>::new();
    line_spans(solid, ray.from_start().line(), &mut near);
    let border = half(ray.start().negated());
    let [first, last] = if border > T::Scalar::ZERO { [&near, &*list] } else { [&*list, &near] };
    if let Some(both) = spliced(first, last, border) {
        *list = both;
    }
}

fn half<S: Scalar>(length: S) -> S {
    S::from_wide(length.wide() * S::Wide::HALF)
}

fn crossings<S: Scalar>(spans: &[Span<S>]) -> impl Iterator<Item = Crossing<S>> {
    spans.iter().flat_map(|span| [span.enter, span.exit])
}

/// The spans of the first list before `border`, and those of the last one behind it; `None` if one
/// of them is inside there and the other isn't, which is so only if a crossing is there.
fn spliced<S: Scalar, const N: usize>(
    first: &[Span<S>],
    last: &[Span<S>],
    border: S,
) -> Option<SpanList<S, N>> {
    let is_before = |crossing: &Crossing<S>| crossing.t < border;
    let is_inside = |spans| crossings(spans).filter(is_before).count() % 2 == 1;
    if is_inside(first) != is_inside(last) {
        return None;
    }
    let behind = crossings(last).filter(|crossing| !is_before(crossing));
    let mut both = crossings(first).filter(is_before).chain(behind);
    let mut list = SpanList::new();
    let mut stack = list.stack();
    while let (Some(enter), Some(exit)) = (both.next(), both.next()) {
        stack.put(Span { enter, exit });
    }
    Some(list)
}
