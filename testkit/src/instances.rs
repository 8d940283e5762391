//! Solids of each number type under test, compiled once and with optimisation. Crates above this one link
//! them, as long as both have an `opt-level` of at most "s". Otherwise each suite compiles its own.

use crate::number::Tested;
use fixed::types::I20F12;
use scancsg::geom::{OrthographicRays, PerspectiveRays, Ray, Rays};
use scancsg::render::{Camera, Gray8, Orthographic, Perspective, Picture, Size, XRay};
use scancsg::scalar::{I16F16, Scalar};
use scancsg::solid::{
    Cone, Cuboid, Cylinder, HalfSpace, Placed, Polyhedron, RayCast, Scaled, Scan, Slab, Solid,
    Sphere, Torus,
};
use scancsg::span::SpanList;

/// What is looked at, and who looks.
pub struct Views<'a, S: Scalar> {
    pub solids: Solids<'a, S>,
    pub ray: Ray<S>,
    pub orthographic: Orthographic<S>,
    pub perspective: Perspective<S>,
}

/// One solid of each kind.
type Solids<'a, S> = (
    (&'a Cylinder<S>, &'a Sphere<S>, &'a Slab<S>, &'a Cone<S>, &'a Torus<S>),
    (&'a Cuboid<S>, &'a Polyhedron<S, 6>, &'a HalfSpace<S>),
    (&'a Placed<Cylinder<S>>, &'a Scaled<Cylinder<S>>),
);

/// Nobody has to call it: it is there so that its callees are.
pub fn instances(
    f32s: &Views<f32>,
    f64s: &Views<f64>,
    i16f16s: &Views<I16F16>,
    i20f12s: &Views<I20F12>,
) {
    look(f32s);
    look(f64s);
    look(i16f16s);
    look(i20f12s);
}

fn look<S: Tested>(views: &Views<S>) {
    let (round, flat, wrapped) = views.solids;
    views.at(round.0);
    views.at(round.1);
    views.at(round.2);
    views.at(round.3);
    views.at(round.4);
    views.at(flat.0);
    views.at(flat.1);
    views.at(flat.2);
    views.at(wrapped.0);
    views.at(wrapped.1);
}

impl<S: Scalar> Views<'_, S> {
    fn at<T>(&self, solid: &T)
    where
        T: Solid<Scalar = S> + Scan<OrthographicRays<S>> + Scan<PerspectiveRays<S>>,
    {
        picture(solid, &self.orthographic);
        picture(solid, &self.perspective);
        let mut list = SpanList::<S, 8>::new();
        solid.trace(&self.ray, &mut list);
        solid.hit(&self.ray, &mut list);
    }
}

fn picture<S, T, C>(solid: &T, camera: &C) -> Option<S>
where
    S: Scalar,
    T: Solid<Scalar = S> + Scan<C::Rays>,
    C: Camera<Rays: Rays<Scalar = S>>,
{
    let (size, shader) = (Size::new(8, 8).ok()?, XRay::new(S::ONE).ok()?);
    let mut picture = Picture::new(solid, camera, size, shader, Gray8(0));
    let mut scanline = picture.scanline(0).ok()?;
    scanline.spans(0, &mut SpanList::<S, 8>::new());
    scanline.render(&mut [Gray8(0); 8]).ok()?;
    Some(scanline.seen(0)?.t)
}
