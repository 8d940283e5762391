//! The crate's own methods and others, for any kind of solids.

use super::subject::{Spans, Subject};
use crate::methods::{F32, GRID, Gives, Inputs};
use crate::timing::Pass;
use scancsg::geom::{Ray, Vec3};
use scancsg::scalar::I16F16;
use scancsg::solid::RayCast;
use scancsg::span::SpanList;
use std::hint::black_box;
use testkit::number::{Tested, vector};
use testkit::vector::V;

/// A solid and a ray at it, by numbers that the method's type holds.
#[derive(Clone, Copy)]
pub struct Query<Q> {
    pub solid: Q,
    pub ray: [V; 2],
}

type Answer<Q> = dyn Fn(&Query<Q>) -> Option<Spans<f64>>;
type PreparePass<Q> = dyn Fn(&[Query<Q>]) -> Pass;

pub struct Method<Q> {
    pub name: &'static str,
    /// The number type that it computes in.
    pub number: &'static str,
    pub inputs: &'static Inputs,
    pub gives: Gives,
    /// `None` where it doesn't take the query.
    pub answer: Box<Answer<Q>>,
    /// Gets ready to answer all of these queries.
    pub prepare_pass: Box<PreparePass<Q>>,
}

impl<Q: Subject> Method<Q> {
    /// `prepare` is what a caller has ready before the clock starts; `solve` is measured.
    pub fn new<P: 'static, T: Copy + Into<f64> + 'static>(
        [name, number]: [&'static str; 2],
        prepare: fn(&Query<Q>) -> Option<P>,
        solve: impl Fn(&P) -> Spans<T> + Copy + 'static,
    ) -> Self {
        let wide = |ends: [T; 2]| ends.map(Into::into);
        let answer = move |query: &Query<Q>| {
            prepare(query).map(|input| solve(&input).map(|span| span.map(wide)))
        };
        let prepare_pass = move |queries: &[Query<Q>]| -> Pass {
            let inputs: Vec<P> = queries.iter().filter_map(prepare).collect();
            Box::new(move || {
                for input in &inputs {
                    black_box(solve(black_box(input)));
                }
            })
        };
        Self {
            name,
            number,
            inputs: &F32,
            gives: Gives::Span,
            answer: Box::new(answer),
            prepare_pass: Box::new(prepare_pass),
        }
    }

    /// A textbook's formula in `f32`.
    pub fn textbook<P: 'static>(
        prepare: fn(&Query<Q>) -> Option<P>,
        solve: fn(&P) -> Spans<f32>,
    ) -> Self {
        Self::new(["textbook", "f32"], prepare, solve)
    }

    /// parry3d's, as a surface, so that the crossing is given from inside, too.
    pub fn parry<T: parry3d::query::RayCast + 'static>(
        prepare: fn(&Query<Q>) -> Option<(parry3d::query::Ray, T)>,
    ) -> Self {
        let solve = |(ray, shape): &(parry3d::query::Ray, T)| {
            [shape.cast_local_ray(ray, f32::MAX, false).map(|t| [t, t]), None]
        };
        Self { gives: Gives::First, ..Self::new(["parry3d", "f32"], prepare, solve) }
    }

    /// The peers, and the crate's.
    pub fn all() -> Vec<Self> {
        let mut methods = Q::peers();
        methods.push(Self::new(["scancsg", "f32"], ready::<f32, Q>, trace::<f32, Q>));
        let fixed = Self::new(["scancsg", "I16F16"], ready::<I16F16, Q>, trace::<I16F16, Q>);
        methods.push(Self { inputs: &GRID, ..fixed });
        methods
    }

    pub fn is_shipped(&self) -> bool {
        self.name == "scancsg"
    }
}

type Ready<S, Q> = ([Vec3<S>; 2], <Q as Subject>::Solid<S>);

fn ready<S: Tested, Q: Subject>(query: &Query<Q>) -> Option<Ready<S, Q>> {
    Some((query.ray.map(vector), query.solid.solid::<S>()?))
}

// Always, as `trace` itself: a ray that has just been made stays in registers.
#[inline(always)]
fn trace<S: Tested, Q: Subject>(&([origin, direction], ref solid): &Ready<S, Q>) -> Spans<S> {
    let Ok(ray) = Ray::new(origin, direction) else { return [None; 2] };
    let mut list = SpanList::<S, 2>::new();
    let spans = solid.trace(&ray, &mut list);
    [0, 1].map(|i| spans.get(i).map(|span| [span.enter.t, span.exit.t]))
}

/// In `f32`, from a middle that is the formula's origin: that difference isn't timed.
pub fn from_middle(ray: [V; 2], middle: V) -> [[f32; 3]; 2] {
    let [origin, direction] = ray.map(|v| v.map(|x| x as f32));
    let middle = middle.map(|x| x as f32);
    [std::array::from_fn(|i| origin[i] - middle[i]), direction]
}

pub fn narrow(v: V) -> [f32; 3] {
    v.map(|x| x as f32)
}

pub fn dot([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> f32 {
    a * x + b * y + c * z
}
