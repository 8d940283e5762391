//! Where a single line meets each family: the one place that takes the body for the kind of number.

use super::ball::Ball;
use super::corners::Corners;
use super::half_space::HalfSpace;
use super::planes::{PlaneRoots, Planes};
use super::quartic::ReadyTorus;
use super::ring::Ring;
use super::taper::{Conic, Taper};
use super::wall::Wall;
use super::{fixed, float};
use crate::geom::Line;
use crate::scalar::{FixedPoint, Float, Formula, Roots, Scalar};
use crate::span::Span;

/// A question about a line, or after `of` about whatever it is, as a type with the bodies in floating and
/// in fixed point.
macro_rules! formula {
    ($(#[$docs:meta])* $name:ident($($of:ident: $Of:ident),+) -> $Output:ty, $Formula:ident) => {
        formula! { $(#[$docs])* of $name($($of: $Of,)+ line: Line) -> $Output, $Formula }
    };
    ($(#[$docs:meta])* of $name:ident($($of:ident: $Of:ident),+) -> $Output:ty, $Formula:ident) => {
        struct $Formula<'a, S: Scalar>($(&'a $Of<S>),+);

        impl<S: Scalar> Formula<S> for $Formula<'_, S> {
            type Output = $Output;

            #[inline(always)]
            fn float(self) -> $Output
            where
                S: Float,
            {
                let Self($($of),+) = self;
                float::$name($($of),+)
            }

            fn fixed(self) -> $Output
            where
                S: FixedPoint,
            {
                let Self($($of),+) = self;
                fixed::$name($($of),+)
            }
        }

        $(#[$docs])*
        #[inline(always)]
        pub(crate) fn $name<S: Scalar>($($of: &$Of<S>),+) -> $Output {
            S::compute($Formula($($of),+))
        }
    };
}

formula! {
    /// The part of a line inside a wall and between the caps. Where both begin or end together, the
    /// face is the cap's.
    cylinder(wall: Wall, caps: Planes) -> Option<Span<S>>, Cylinder
}

formula! {
    /// The same for an axis along a coordinate axis. What others need isn't linked in fixed point.
    aligned_cylinder(wall: Wall, caps: Planes) -> Option<Span<S>>, AlignedCylinder
}

formula! {
    /// Where a line enters a wall and where it exits, as far as these points are between the caps or
    /// on a rim. A tangent has both, at the same parameter.
    open_cylinder(wall: Wall, caps: Planes) -> [Option<S>; 2], OpenCylinder
}

formula! {
    /// The part of a line inside a cone's wall and between the caps. Where both begin or end together,
    /// the face is the cap's.
    cone(taper: Taper, caps: Planes) -> Option<Span<S>>, InCone
}

formula! {
    /// Where a pixel's ray is inside the nappe of a cone that is between the caps, and perhaps in the other
    /// one beyond the tip.
    of conic(ray: Conic) -> Option<[S; 2]>, InNappe
}

formula! {
    /// Where a line is inside a ball. A tangent has equal roots, or none.
    ball(ball: Ball) -> Roots<S>, InBall
}

formula! {
    /// Where a line is between two planes.
    planes(planes: Planes) -> PlaneRoots<S>, BetweenPlanes
}

formula! {
    /// The part of a line inside a box.
    cuboid(corners: Corners) -> Option<Span<S>>, InCuboid
}

/// Half-spaces as one operand.
type Faces<S> = [HalfSpace<S>];

formula! {
    /// The part of a line inside all half-spaces.
    half_spaces(faces: Faces) -> Option<Span<S>>, InHalfSpaces
}

formula! {
    /// Where a line is inside a torus, in order.
    torus(torus: ReadyTorus) -> [Option<Span<S>>; 2], InTorus
}

formula! {
    /// A torus in `f64`, ready for any number of lines.
    of ready_torus(ring: Ring) -> ReadyTorus<S>, ToDoubles
}
