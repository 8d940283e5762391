//! What is asked: a ray, and a cylinder or a ball.

use crate::vector::{V, along};

/// A ray o + t·d and the cylinder of radius r along the first coordinate, from h below `base` to h
/// above it; or the ball of radius r around `base`.
///
/// The numbers are exact: those of a method's input type, which `f64` holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Query {
    pub origin: V,
    pub direction: V,
    pub radius: f64,
    pub half_length: f64,
    /// The middle of the axis.
    pub base: V,
    /// Which of x, y, z the first coordinate is in the scene, 0 to 2; the others follow in a circle.
    pub axis: usize,
    pub is_ball: bool,
}

impl Query {
    /// Against the cylinder −h ≤ x ≤ h around the x axis.
    pub fn new([origin, direction]: [V; 2], radius: f64, half_length: f64) -> Self {
        Self { origin, direction, radius, half_length, base: [0.0; 3], axis: 0, is_ball: false }
    }

    /// With ray and cylinder moved together, and turned.
    pub fn moved(self, base: V, axis: usize) -> Self {
        Self { origin: along(self.origin, 1.0, base), base, axis, ..self }
    }

    /// With every number rounded.
    pub fn map(&self, round: impl Fn(f64) -> f64) -> Self {
        Self {
            origin: self.origin.map(&round),
            direction: self.direction.map(&round),
            radius: round(self.radius),
            half_length: round(self.half_length),
            base: self.base.map(&round),
            ..*self
        }
    }

    pub fn is_finite(&self) -> bool {
        let vectors =
            [self.origin, self.direction, self.base, [self.radius, self.half_length, 0.0]];
        vectors.iter().flatten().all(|x| x.is_finite())
    }

    pub fn is_valid(&self) -> bool {
        self.is_finite() && self.direction != [0.0; 3]
    }
}
