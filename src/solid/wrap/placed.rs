//! Solids that stand somewhere else than where they were made.

use super::wrapping::Wrap;
use crate::geom::Pose;
use crate::span::Shape;

/// A solid moved by a rigid motion. It owns its solid, or borrows it: `Placed::new(&part, pose)` lets
/// one part stand in many places.
///
/// Nothing is moved but the rays: once per picture, or once per single ray.
///
/// To move what is placed already, put one pose after the other ([`Pose::then`]), which is checked. A
/// placed solid that is placed again has no such check: in fixed point, a ray that is out of range in
/// the innermost frame (farther than 2³⁰ units from its origin) meets nothing.
///
/// ```
/// use scancsg::geom::{Pose, vec3};
/// use scancsg::solid::{Placed, Sphere};
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let pose = Pose::<f32>::translation(vec3(3.0, 0.0, 0.0))?;
/// let both = Placed::new(&ball, pose) | ball;
/// # let _ = both;
///
/// // A joint turns a little further in every frame.
/// let mut hand = Placed::new(&ball, pose);
/// let step = Pose::<f32>::about(vec3(0.0, 1.0, 2.0), 0.01)?;
/// let mut joint = pose;
/// for _frame in 0..100 {
///     joint = joint.then(&step)?;
///     hand.set_pose(joint);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Placed<T: Shape> {
    solid: T,
    pose: Pose<T::Scalar>,
}

impl<T: Shape> Placed<T> {
    /// Puts `solid`, together with its own frame, to `pose`.
    #[must_use]
    pub const fn new(solid: T, pose: Pose<T::Scalar>) -> Self {
        Self { solid, pose }
    }

    /// Puts the solid to another pose: for joints that move from frame to frame.
    pub const fn set_pose(&mut self, pose: Pose<T::Scalar>) {
        self.pose = pose;
    }
}

impl<T: Shape> Wrap for Placed<T> {
    type Inner = T;

    #[inline]
    fn inner(&self) -> &T {
        &self.solid
    }

    #[inline]
    fn pose(&self) -> Option<&Pose<T::Scalar>> {
        Some(&self.pose)
    }
}
