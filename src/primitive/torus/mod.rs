//! The torus: a ring of round section.

mod orthographic;
mod perspective;

use crate::geom::{Axis, Direction, Line, RayRow, Vec3};
use crate::quadric::{ReadyTorus, Ring, meet};
use crate::query::Solid;
use crate::scalar::{ConstOps, Scalar, per_scalar};
use crate::scan::bounds::Bounds;
use crate::scan::leaf;
use crate::span::{Face, Shape, Span, SpanStack};

/// A solid torus: all points within the tube's radius r of a circle, the ring, of radius R > r. Take it
/// for O-rings, grooves and rounded edges.
///
/// One face. A line has up to two spans.
///
/// ```
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::solid::{RayCast, Torus};
/// use scancsg::span::SpanList;
///
/// let ring = Torus::<f32>::along_z(vec3(0.0, 0.0, 0.0), 2.0, 0.5)?;
/// let ray = Ray::new(vec3(-4.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0))?;
/// let mut list = SpanList::<_, 2>::new();
/// let ends: Vec<_> = ring.trace(&ray, &mut list).iter().map(|s| [s.enter.t, s.exit.t]).collect();
/// assert_eq!(ends, [[1.5, 2.5], [5.5, 6.5]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A tube as wide as its ring does not compile in a constant:
///
/// ```compile_fail,E0080
/// use scancsg::{constant, geom::Vec3, solid::Torus};
///
/// const RING: Torus<f32> = constant!(Torus::<f32>::along_z(Vec3::ZERO, 1.0, 1.0));
/// # let _ = RING;
/// ```
///
/// Single rays and pixels are computed in `f64` for all number types, with the same bits everywhere. On a
/// host that is quick: a picture of ten tori takes 5 times as long as one of ten cylinders. A microcontroller
/// without `f64` in hardware calls library routines: on a Cortex-M4F, a picture of one large torus takes 11,000 instructions a pixel,
/// 50 times one of ten cylinders. A scene without a torus links none of them. Errors are in the
/// repository's `docs/numerics.md`.
///
/// A tube of less than 10⁻⁶ of the ring's radius loses digits.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Torus<S: Scalar> {
    pub(crate) ring: Ring<S>,
}

crate::error_text! {
    /// Why a torus can't be made.
    pub enum TorusError {
        /// A coordinate or a radius is infinite or NaN.
        NotFinite => "a coordinate or a radius of the torus is infinite or not a number",
        /// The axis is zero.
        ZeroAxis => "the axis of the torus is zero",
        /// A radius is zero, negative, or not between [`Scalar::MIN_RADIUS`] and [`Scalar::MAX_COORDINATE`].
        Radius => "a radius of the torus is not positive, or out of its number type's range",
        /// The tube is as wide as its ring, or wider.
        Tube => "the tube of the torus is as wide as its ring, or wider",
        /// A coordinate is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the torus is too far away for its number type",
    }
}

leaf!([S: Scalar] Torus<S>);

per_scalar! { $S: impl[] Torus<$S> {
    /// A torus around `center`, with its axis along x: a ring of radius `ring`, and around that a
    /// tube of radius `tube`.
    ///
    /// # Errors
    /// [`TorusError::NotFinite`], [`TorusError::Radius`], [`TorusError::TooFar`], or
    /// [`TorusError::Tube`] where `tube ≥ ring`.
    pub const fn along_x(center: Vec3<$S>, ring: $S, tube: $S) -> Result<Self, TorusError> {
        Self::with_axis(center, Direction::<$S>::X, ring, tube)
    }

    /// A torus around `center`, with its axis along y.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn along_y(center: Vec3<$S>, ring: $S, tube: $S) -> Result<Self, TorusError> {
        Self::with_axis(center, Direction::<$S>::Y, ring, tube)
    }

    /// A torus around `center`, with its axis along z.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub const fn along_z(center: Vec3<$S>, ring: $S, tube: $S) -> Result<Self, TorusError> {
        Self::with_axis(center, Direction::<$S>::Z, ring, tube)
    }

    /// A torus around `center`, with an axis of any length but zero.
    ///
    /// The axis is brought to length 1 and rounded to the number type, in fixed point to 2⁻²⁸. That
    /// is computed in `f64` or in integers of 128 bits: better in a constant.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x), and [`TorusError::ZeroAxis`].
    pub const fn new(
        center: Vec3<$S>, axis: Vec3<$S>, ring: $S, tube: $S,
    ) -> Result<Self, TorusError> {
        if !axis.has_finite_coordinates() {
            return Err(TorusError::NotFinite);
        }
        match ConstOps::<$S>::normalized(axis.to_array()) {
            Some(axis) => Self::with_axis(center, Direction::<$S>::new(axis), ring, tube),
            None => Err(TorusError::ZeroAxis),
        }
    }

    const fn with_axis(
        center: Vec3<$S>, axis: Direction<$S>, ring: $S, tube: $S,
    ) -> Result<Self, TorusError> {
        type Ops<S> = ConstOps<S>;
        let is_finite = Ops::<$S>::is_finite(ring) && Ops::<$S>::is_finite(tube);
        let has_radii = Ops::<$S>::is_radius(ring) && Ops::<$S>::is_radius(tube);
        match () {
            () if !(center.has_finite_coordinates() && is_finite) => Err(TorusError::NotFinite),
            () if !has_radii => Err(TorusError::Radius),
            () if !Ops::<$S>::is_below(tube, ring) => Err(TorusError::Tube),
            () if !center.is_within_reach() => Err(TorusError::TooFar),
            () => Ok(Self { ring: Ring { center, axis, radius: ring, tube } }),
        }
    }
} }

/// For any number type: what a type parameter can call. In constants, use the constructors above.
impl<S: Scalar> Torus<S> {
    /// A torus around `center`, with its axis along a coordinate axis.
    ///
    /// # Errors
    /// As [`along_x`](Self::along_x).
    pub fn along(axis: Axis, center: Vec3<S>, ring: S, tube: S) -> Result<Self, TorusError> {
        Self::checked(center, Direction::along_axis(axis), ring, tube)
    }

    /// A torus around `center`, with an axis of any length but zero.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn around(center: Vec3<S>, axis: Vec3<S>, ring: S, tube: S) -> Result<Self, TorusError> {
        if !axis.is_finite() {
            return Err(TorusError::NotFinite);
        }
        let axis = Direction::normalized(axis).ok_or(TorusError::ZeroAxis)?;
        Self::checked(center, axis, ring, tube)
    }

    pub(crate) fn checked(
        center: Vec3<S>,
        axis: Direction<S>,
        ring: S,
        tube: S,
    ) -> Result<Self, TorusError> {
        let is_finite = center.is_finite() && ring.is_finite() && tube.is_finite();
        match () {
            () if !is_finite => Err(TorusError::NotFinite),
            () if !(ring.is_radius() && tube.is_radius()) => Err(TorusError::Radius),
            () if tube >= ring => Err(TorusError::Tube),
            () if !center.is_within_range() => Err(TorusError::TooFar),
            () => Ok(Self { ring: Ring { center, axis, radius: ring, tube } }),
        }
    }
}

impl<S: Scalar> Shape for Torus<S> {
    type Scalar = S;
    const SPANS: usize = 2;
    const FACES: u16 = 1;
}

impl<S: Scalar> Solid for Torus<S> {
    fn spans(&self, line: &Line<S>, first: Face, stack: &mut SpanStack<'_, S>) {
        stack.put_all(meet::torus(&self.ready(), line).into_iter().flatten(), first);
    }

    fn bounds(&self) -> Bounds<S> {
        let Ring { center, radius, tube, .. } = self.ring;
        Bounds::Ball { center, radius: radius.plus(tube) }
    }

    fn onto(&self, _: Face, near: Vec3<S>) -> Vec3<S> {
        self.ring.onto(near)
    }

    fn normal(&self, _: Face, at: Vec3<S>) -> Vec3<S> {
        self.ring.normal(at)
    }
}

impl<S: Scalar> Torus<S> {
    fn ready(&self) -> ReadyTorus<S> {
        meet::ready_torus(&self.ring)
    }
}

/// The spans of a pixel's line.
#[inline]
fn spans<S: Scalar>(
    torus: Option<&ReadyTorus<S>>,
    row: Option<&impl RayRow<Scalar = S>>,
    x: i32,
) -> [Span<S>; 2] {
    let found = torus.zip(row).map(|(torus, row)| meet::torus(torus, &row.line(x)));
    found.unwrap_or_default().map(|span| span.unwrap_or(Span::NOWHERE))
}
