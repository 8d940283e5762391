//! The one table of limits: how far off results may be. Tests and benchmarks read it from here; what
//! must be exact stands in the tests.
//!
//! A *unit* is [`Tested::UNIT`], the distance from 1 to the next number: ε of a float, an LSB of a
//! grid. An *ulp* is the unit in the last place of an `f32` at the exact result.

use crate::number::Tested;

/// Units that a result may be off, by the kind of numbers.
#[derive(Debug, Clone, Copy)]
pub struct Units {
    pub float: f64,
    pub fixed: f64,
}

impl Units {
    const fn new(float: f64, fixed: f64) -> Self {
        Self { float, fixed }
    }

    /// The units of a kind of numbers.
    pub fn of_kind(self, is_fixed: bool) -> f64 {
        if is_fixed { self.fixed } else { self.float }
    }

    /// The allowed error of a number type.
    pub fn of<S: Tested>(self) -> f64 {
        S::UNIT * self.of_kind(S::IS_FIXED)
    }
}

// Single rays.

/// Parameters of spans; in floating point relative to the parameter.
pub const SPANS: Units = Units::new(4.0, 0.5);
/// What is wanted of a span has a rounding error of its own, in fixed point.
pub const WANTED: f64 = 1e-9;
/// The parameter of a hit on a cap near the ray's start, relative to the parameter.
pub const NEAR_CAP: Units = Units::new(1.0, 0.5);
/// The parameter of a hit on a wall near the ray's start, relative to the parameter.
pub const NEAR_WALL: Units = Units::new(4.0, 0.5);
/// Chords of rays that graze a cylinder of radius 1.
pub const GRAZING_CHORD: Units = Units::new(8.0, 1.0);
/// The thickness of a wall of a few units.
pub const THIN_WALL: Units = Units::new(2.0, 0.0);
/// Parameters as multiples of a radius that is far from 1.
pub const RADII: Units = Units::new(2.0, 0.0);
/// Parameters of a direction that is not normalised, times its length.
pub const SCALED_DIRECTION: Units = Units::new(8.0, 0.5);
/// Parameters of a ray and of its mirror image, of the largest parameter in play.
pub const MIRRORED: Units = Units::new(4.0, 1.0);
/// Parameters that two ways to the same solid give.
pub const SAME_SOLID: Units = Units::new(1.0, 1.0);
/// Coordinates of normals.
pub const NORMAL: Units = Units::new(1.0, 1.0);
/// Hit points off their surface, for coordinates below 4.
pub const HIT_POINT: Units = Units::new(4.0, 2.0);
/// Lengths of normals, in units of the radius and of 1.
pub const NORMAL_LENGTH: f64 = 4.0;

/// The relative ε by which a solid is grown and shrunk, as a power of two, for its wall and its caps:
/// what is computed lies between the two. Of `f32`, `f64` and `I16F16`.
pub const GROWN_F32: [u32; 2] = [17; 2];
pub const GROWN_F64: [u32; 2] = [46; 2];
pub const GROWN_I16F16: [u32; 2] = [22, 16];

/// Parameters of the reference rays in ulps. Where the origin lies on the surface to within the
/// rounding of its own coordinates (`onsurf`), parameters are near zero and an ulp of them says
/// nothing; there only [`CYLINDER_BOUND`] holds.
pub const CYLINDER_F32: f64 = 4.0;
/// The same as a multiple of the bound by rounding errors, in `f32` and `f64`.
pub const CYLINDER_BOUND: f64 = 2.0;

/// Parameters of lines at a torus, in ulps or LSB: 99th percentile and maximum.
pub const TORUS_F32: [f64; 2] = [0.6, 1.0];
pub const TORUS_F64: [f64; 2] = [64.0, 4096.0];
pub const TORUS_F64_GRAZING: [f64; 2] = [1024.0, 16_384.0];
pub const TORUS_FIXED: [f64; 2] = [0.6, 1.0];
/// A torus's hit points off their surface, for coordinates below 4.
pub const TORUS_POINT: Units = Units::new(8.0, 3.0);
/// Its normals: what the point's error is seen as over the tube's radius, and their own.
pub const TORUS_NORMAL: [Units; 2] = [Units::new(8.0, 4.0), Units::new(4.0, 2.0)];

/// The benchmark's sets of rays in `f32`: 99th percentile and maximum of an entry and of an exit in
/// ulps.
pub const SHARP_P99: f64 = 2.0;
pub const SHARP_MAX: f64 = 4.0;
pub const HARD_P99: f64 = 2.5;
pub const ELSEWHERE_MAX_IN: f64 = 6.0;
pub const ELSEWHERE_MAX_OUT: f64 = 4.0;
/// Points of hits off the surface, in radii.
pub const POINT_F32: f64 = 2e-7;
/// The same of fixed point in LSB.
pub const FIXED_P99: f64 = 1.0;
pub const FIXED_MAX: f64 = 2.0;
pub const POINT_FIXED: f64 = 2.0;

/// What the benchmark allows of a kind of solids.
#[derive(Debug, Clone, Copy)]
pub struct SolidLimits {
    /// The 99th percentile of entries and of exits of ordinary rays, in ulps or in LSB.
    pub p99: Units,
    /// Wrong classes, as a part of those that are robust.
    pub wrong: f64,
}

/// Boxes, polyhedra, cones and ellipsoids.
pub const SOLIDS: SolidLimits = SolidLimits { p99: Units::new(3.0, 1.0), wrong: 0.0 };
/// Tori.
pub const TORI: SolidLimits = SolidLimits { p99: Units::new(16.0, 4.0), wrong: 1e-5 };

// Poses.

/// Points that a pose turns about an axis through the origin, for coordinates below 3.
pub const TURN: Units = Units::new(8.0, 1.0);
/// The same about an axis elsewhere.
pub const JOINT: Units = Units::new(16.0, 2.0);

// Pictures.

/// Scene units by which a pixel's ray may miss what it should see, in floating point.
pub const SILHOUETTE: f64 = 1e-5;
/// Scene units by which a depth may be off, in floating point.
pub const DEPTH: f64 = 1e-4;
/// Both in fixed point, in units at a distance of 1. In 1,500 pictures of each kind, 3 were enough.
pub const FIXED_PICTURE: f64 = 5.0;
/// Grey levels by which a shaded pixel may be off.
pub const LEVEL: f64 = 1.0;
/// Luma off its exact value, in thousandths of a level: half a level, and a little.
pub const LUMA: i64 = 502;

// Pipes.

/// How far off a surface a single ray's answer may be because of rounding: of points, axes, planes
/// and parameters.
pub const PIPE: Units = Units::new(16.0, 4.0);
/// A hollow pipe's depth in a picture, against a single ray's.
pub const PIPE_DEPTH_FLOAT: f64 = 2e-4;
pub const PIPE_DEPTH_FIXED: f64 = 0.01;

// Splines, in units of the largest coordinate of the control points.

/// An editable curve in `f32`, by its order.
pub const EDITABLE: [f64; 7] = [0.0, 0.0, 5.0, 5.0, 5.0, 5.0, 5.0];
pub const EDITABLE_F64: f64 = 1.5;
pub const EDITABLE_FIXED: f64 = 0.51;
/// The benchmark's editable curves, quadratics and cubics in `f32`.
pub const EDITABLE_BENCH: f64 = 5.0;
/// A baked curve in `f32` and `f64`.
pub const BAKED: f64 = 3.1;
/// What the seeded search may find of baked curves in `f32`, by the order.
pub const BAKED_SEARCH: [f64; 7] = [0.0, 0.0, 1.6, 2.5, 2.8, 3.1, 3.1];
pub const BAKED_FIXED: f64 = 0.6;
/// A point of a sweep in fixed point.
pub const SWEEP_FIXED: f64 = 0.6;
/// The editable form against the baked one: both errors.
pub const FORMS: f64 = BAKED + EDITABLE_F64;
pub const FORMS_F64: f64 = BAKED + 1.75;
pub const FORMS_FIXED: f64 = 1.0;
/// A curve with a knot inserted against the curve as it was.
pub const INSERTION: f64 = 3.0;
pub const INSERTION_FIXED: f64 = 1.1;
/// Basis functions in units of the value, their derivatives in units of the sum of their terms.
pub const BASIS: [f64; 2] = [1.0, 3.0];
/// The same on the reference table: of values and of derivatives.
pub const BASIS_TABLE: [f64; 2] = [3.0, 3.0];
pub const BASIS_FIXED: [f64; 2] = [0.6, 0.6];
/// Derivatives of a curve: editable and baked.
pub const DERIVATIVES: [f64; 2] = [3.0, 4.0];
pub const DERIVATIVES_FIXED: [f64; 2] = [0.51, 0.51];
/// The length of a long polyline.
pub const LENGTH: f64 = 1.5;

#[cfg(test)]
mod tests {
    #[test]
    fn units_are_those_of_the_number_type() {
        assert_eq!(super::SPANS.of::<f32>(), 4.0 * f64::from(f32::EPSILON));
        assert_eq!(super::SPANS.of::<scancsg::scalar::I16F16>(), 0.5 / 65536.0);
    }
}
