//! Pipes are laid segment by segment.

use super::{Joint, Pipe, PipeError};
use crate::geom::Vec3;
use crate::quadric::Wall;
use crate::scalar::{ConstOps, Scalar, per_scalar};
use crate::solid::{Cylinder, CylinderError, Intersection, Many, Slab, Sphere, SphereError, Union};
use crate::spline::Curve;

/// A pipe from its first point to the last one so far.
struct Laying<S: Scalar, const SEGMENTS: usize> {
    radius: S,
    from: Vec3<S>,
    to: Vec3<S>,
    laid: Option<Laid<S, SEGMENTS>>,
}

/// At least one segment.
#[derive(Clone, Copy)]
struct Laid<S: Scalar, const SEGMENTS: usize> {
    cylinders: Many<Cylinder<S>, SEGMENTS>,
    /// Each at the beginning of a cylinder.
    joints: Many<Joint<S>, SEGMENTS>,
    last: Cylinder<S>,
}

impl<S: Scalar, const SEGMENTS: usize> Laying<S, SEGMENTS> {
    /// Adds a segment, and the joint at its beginning.
    const fn push(&mut self, cylinder: Cylinder<S>, joint: Joint<S>) -> Result<(), PipeError> {
        let Some(laid) = &mut self.laid else {
            let (cylinders, joints) = (Many::new(cylinder), Many::new(joint));
            self.laid = Some(Laid { cylinders, joints, last: cylinder });
            return Ok(());
        };
        if laid.cylinders.push(cylinder).is_err() || laid.joints.push(joint).is_err() {
            return Err(PipeError::Capacity);
        }
        laid.last = cylinder;
        Ok(())
    }
}

per_scalar! { $S: impl[const SEGMENTS: usize] Pipe<$S, SEGMENTS> {
    /// A pipe along a curve: with as many segments as it takes to stay within `tolerance`,
    /// which see [above](Self#how-near-it-is-to-the-tube).
    ///
    /// Everything within two radii of the curve must be within [`Scalar::MAX_COORDINATE`]. In fixed
    /// point, points are rounded to units, so the tolerance should be many of them. The polyline is
    /// followed for as long as there is room, and the radius is checked first.
    ///
    /// # Errors
    /// [`PipeError::Capacity`] if there is no room for so many segments,
    /// [`PipeError::Tolerance`], [`PipeError::Radius`], [`PipeError::NotFinite`],
    /// [`PipeError::TooFar`], [`PipeError::Empty`].
    pub fn along<const K: usize, const C: usize, const N: usize>(
        curve: &Curve<Vec3<$S>, K, C, N>,
        radius: $S,
        tolerance: $S,
    ) -> Result<Self, PipeError> {
        let mut vertices = curve.flatten(tolerance).map_err(|_| PipeError::Tolerance)?;
        let first = vertices.next().ok_or(PipeError::Empty)?;
        let mut pipe = Laying::<$S, SEGMENTS>::new(first.point, radius)?;
        // A vertex may be equal to the one before it at each jump, and between two others.
        for _ in 0..=SEGMENTS.saturating_mul(2).saturating_add(N) {
            let Some(vertex) = vertices.next() else { return pipe.finish() };
            pipe.lay(vertex.point)?;
        }
        Err(PipeError::Capacity)
    }

    /// A pipe along a polyline. Points that are equal to the one before them count once.
    ///
    /// # Errors
    /// As [`along`](Self::along).
    pub const fn through(points: &[Vec3<$S>], radius: $S) -> Result<Self, PipeError> {
        let [first, rest @ ..] = points else { return Err(PipeError::Empty) };
        let mut pipe = match Laying::<$S, SEGMENTS>::new(*first, radius) {
            Ok(pipe) => pipe,
            Err(error) => return Err(error),
        };
        let mut rest = rest;
        while let [point, others @ ..] = rest {
            if let Err(error) = pipe.lay(*point) {
                return Err(error);
            }
            rest = others;
        }
        pipe.finish()
    }
} }

per_scalar! { $S: impl[const SEGMENTS: usize] Laying<$S, SEGMENTS> {
    const fn new(from: Vec3<$S>, radius: $S) -> Result<Self, PipeError> {
        match Sphere::<$S>::new(from, radius) {
            Ok(_) => Ok(Self { radius, from, to: from, laid: None }),
            Err(SphereError::NotFinite) => Err(PipeError::NotFinite),
            Err(SphereError::Radius) => Err(PipeError::Radius),
            Err(SphereError::TooFar) => Err(PipeError::TooFar),
        }
    }

    /// Adds a segment up to a point.
    const fn lay(&mut self, to: Vec3<$S>) -> Result<(), PipeError> {
        let cylinder = match Cylinder::<$S>::between(self.to, to, self.radius) {
            Ok(cylinder) => cylinder,
            Err(CylinderError::Empty) => return Ok(()),
            Err(CylinderError::NotFinite) => return Err(PipeError::NotFinite),
            // The radius is checked already.
            Err(_) => return Err(PipeError::TooFar),
        };
        let before = match &self.laid {
            Some(laid) => laid.last,
            None => cylinder,
        };
        let Some(joint) = ConstOps::<$S>::joint(&before, &cylinder) else {
            return Err(PipeError::TooFar);
        };
        self.to = to;
        self.push(cylinder, joint)
    }

    const fn finish(self) -> Result<Pipe<$S, SEGMENTS>, PipeError> {
        let Some(Laid { cylinders, mut joints, last }) = self.laid else {
            return Err(PipeError::Empty);
        };
        if ConstOps::<$S>::is_same(self.from, self.to) {
            match ConstOps::<$S>::joint(&last, &cylinders.as_slice()[0]) {
                Some(joint) => joints.as_mut_slice()[0] = joint,
                None => return Err(PipeError::TooFar),
            }
        }
        let segments = cylinders.as_slice().len();
        Ok(Pipe { parts: Union::new(cylinders, joints), segments })
    }
} }

per_scalar! { $S: impl[] ConstOps<$S> {
    const fn is_same(a: Vec3<$S>, b: Vec3<$S>) -> bool {
        Self::is_zero(Self::difference(a.x, b.x))
            && Self::is_zero(Self::difference(a.y, b.y))
            && Self::is_zero(Self::difference(a.z, b.z))
    }

    /// The part of a ball beyond the end of one cylinder and before the beginning of the
    /// next one, which is nothing where both are the same. `None` if two radii farther than the
    /// ends is too far.
    const fn joint(before: &Cylinder<$S>, after: &Cylinder<$S>) -> Option<Joint<$S>> {
        let Wall { base, radius, .. } = after.wall;
        let (end, start) = (before.caps.high, after.caps.low);
        let width = Self::sum(radius, radius);
        let beyond = [end, Self::sum(end, width)];
        let ahead = [Self::difference(start, width), start];
        let (Ok(ball), Ok(beyond), Ok(ahead)) = (
            Sphere::<$S>::new(base, radius),
            Slab::<$S>::with_normal(before.caps.normal, beyond[0], beyond[1]),
            Slab::<$S>::with_normal(after.caps.normal, ahead[0], ahead[1]),
        ) else {
            return None;
        };
        Some(Joint::new(Intersection::new(ball, beyond), ahead))
    }
} }
