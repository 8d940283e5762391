//! Cameras: where a picture is taken from.

use super::Size;
use crate::geom::{OrthographicRays, PerspectiveRays, Rays, Vec3};
use crate::scalar::{Number, Real, Scalar};

/// A camera that can hand out the rays of a picture.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a camera",
    label = "not a camera",
    note = "cameras are `Orthographic` and `Perspective`; a `Result` of their constructors needs `?` first"
)]
pub trait Camera {
    /// The kind of rays.
    type Rays: Rays;

    /// The rays of a picture: square pixels, rays through pixel centres, the target in the middle.
    fn rays(&self, size: Size) -> Self::Rays;
}

crate::error_text! {
    /// Why a camera can't be set up.
    pub enum CameraError {
        /// A coordinate is infinite or NaN.
        NotFinite => "a coordinate of the camera is infinite or not a number",
        /// The viewing direction is zero: the eye lies on the target, or too near to it to have an
        /// inverse distance.
        ZeroDirection => "the camera has no viewing direction: the eye lies on the target",
        /// In fixed point, the eye is nearer to the target than 2⁻¹⁰: what half a pixel is there would have too
        /// few digits. The picture stays the same with a target farther away along the same line.
        TooNear => "the eye of the camera is too near to its target for its number type",
        /// A coordinate of the target, or the eye's distance from it, is larger than [`Scalar::MAX_COORDINATE`].
        TooFar => "the camera is too far away for its number type",
        /// The camera looks along its up vector, or that vector is zero.
        UpAlongView => "the camera looks along its up vector, or that vector is zero",
        /// The frame height is not a positive finite number.
        FrameHeight => "the frame height of the camera is not a positive number",
        /// The field of view is not between 0 and π, or so near to π that the frame has no size. In fixed point
        /// it must be less than 2.58, or 148°: no square picture could show more.
        FieldOfView => "the field of view of the camera is not between 0 and pi, or too wide",
    }
}

/// Where a camera looks, as a right-handed frame of unit vectors: right, down, forward.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct ViewFrame<T> {
    target: Vec3<T>,
    right: Vec3<T>,
    down: Vec3<T>,
    forward: Vec3<T>,
}

impl<T: Real> ViewFrame<T> {
    fn new<S: Scalar<Wide = T>>(
        target: Vec3<S>,
        along: Vec3<T>,
        up: Vec3<S>,
    ) -> Result<Self, CameraError> {
        if !(target.is_finite() && along.is_finite() && up.is_finite()) {
            return Err(CameraError::NotFinite);
        }
        if target.max_abs() > S::MAX_COORDINATE {
            return Err(CameraError::TooFar);
        }
        let forward = along.normalized().ok_or(CameraError::ZeroDirection)?;
        // Not of the unit vectors: their rounding would hide that the two are parallel.
        let right = along.scaled_to_one().cross(up.wide().scaled_to_one());
        let right = right.normalized().ok_or(CameraError::UpAlongView)?;
        Ok(Self { target: target.wide(), right, down: forward.cross(right), forward })
    }

    fn parallel<S: Scalar<Wide = T>>(&self, frame_height: T, size: Size) -> OrthographicRays<S> {
        OrthographicRays {
            center: self.target,
            right: self.right,
            down: self.down,
            forward: self.forward,
            half_pixel: frame_height / T::from_int(2 * i32::from(size.height())),
            columns: u32::from(size.width()),
        }
    }
}

/// Fixed-point numbers stop at the end of their range, which makes a frame as high as that one
/// that can't be.
fn checked_height<S: Scalar>(frame_height: S::Wide) -> Result<S::Wide, CameraError> {
    let is_positive = frame_height > S::Wide::ZERO && (S::Wide::ONE / frame_height).is_finite();
    if is_positive && frame_height.is_finite() && frame_height < S::HIGHEST.wide() {
        Ok(frame_height)
    } else {
        Err(CameraError::FrameHeight)
    }
}

/// A camera infinitely far away: all its rays are parallel, and it sees whole lines.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Orthographic<S: Scalar> {
    frame: ViewFrame<S::Wide>,
    frame_height: S::Wide,
}

impl<S: Scalar> Orthographic<S> {
    /// A camera that looks from `eye` towards `target`, with `up` pointing upwards in the
    /// picture, and shows `frame_height` units of the scene from its upper to its lower edge.
    ///
    /// # Errors
    /// [`CameraError`], all but [`FieldOfView`](CameraError::FieldOfView) and [`TooNear`](CameraError::TooNear).
    pub fn look_at(
        eye: Vec3<S>,
        target: Vec3<S>,
        up: Vec3<S>,
        frame_height: S,
    ) -> Result<Self, CameraError> {
        Self::looking(target.wide() - eye.wide(), target, up, frame_height)
    }

    /// A camera that looks along a direction, with `target` in the middle of its picture.
    ///
    /// # Errors
    /// As [`look_at`](Self::look_at).
    pub fn look_along(
        direction: Vec3<S>,
        target: Vec3<S>,
        up: Vec3<S>,
        frame_height: S,
    ) -> Result<Self, CameraError> {
        Self::looking(direction.wide(), target, up, frame_height)
    }

    fn looking(
        direction: Vec3<S::Wide>,
        target: Vec3<S>,
        up: Vec3<S>,
        frame_height: S,
    ) -> Result<Self, CameraError> {
        let frame = ViewFrame::new(target, direction, up)?;
        Ok(Self { frame, frame_height: checked_height::<S>(frame_height.wide())? })
    }
}

impl<S: Scalar> Camera for Orthographic<S> {
    type Rays = OrthographicRays<S>;

    fn rays(&self, size: Size) -> OrthographicRays<S> {
        self.frame.parallel(self.frame_height, size)
    }
}

/// A camera at a point: rays run from its eye through the pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Perspective<S: Scalar> {
    frame: ViewFrame<S::Wide>,
    distance: S::Wide,
    /// In the plane through the target.
    frame_height: S::Wide,
}

impl<S: Scalar> Perspective<S> {
    /// A camera at `eye` that looks towards `target`, with `up` pointing upwards in the picture.
    ///
    /// `field_of_view` is the angle between the upper and the lower edge, in radians. The picture
    /// is most exact near the target's distance, so `target` is best the middle of the scene.
    ///
    /// # Errors
    /// [`CameraError`], all but [`FrameHeight`](CameraError::FrameHeight).
    pub fn look_at(
        eye: Vec3<S>,
        target: Vec3<S>,
        up: Vec3<S>,
        field_of_view: S,
    ) -> Result<Self, CameraError> {
        let to_target = target.wide() - eye.wide();
        let frame = ViewFrame::new(target, to_target, up)?;
        let field_of_view = field_of_view.wide();
        if !(S::Wide::ZERO < field_of_view && field_of_view < S::Wide::PI) {
            return Err(CameraError::FieldOfView);
        }
        let (sin, cos) = (field_of_view * S::Wide::HALF).sin_cos();
        let distance = frame.forward.dot_compensated(to_target);
        // In floating point, nothing is nearer than that.
        if distance < S::Wide::QUANTUM * S::Wide::from_int(1 << 22) {
            return Err(CameraError::TooNear);
        }
        if distance > S::MAX_COORDINATE.wide() {
            return Err(CameraError::TooFar);
        }
        if !(S::Wide::ONE / distance).is_finite() {
            return Err(CameraError::ZeroDirection);
        }
        let tangent = sin / cos;
        if !PerspectiveRays::<S>::can_hold(tangent + tangent) {
            return Err(CameraError::FieldOfView);
        }
        let frame_height = checked_height::<S>((distance + distance) * tangent)
            .map_err(|_| CameraError::FieldOfView)?;
        Ok(Self { frame, distance, frame_height })
    }
}

impl<S: Scalar> Camera for Perspective<S> {
    type Rays = PerspectiveRays<S>;

    fn rays(&self, size: Size) -> PerspectiveRays<S> {
        let plane = self.frame.parallel(self.frame_height, size);
        let inverse_distance = S::Wide::ONE / self.distance;
        PerspectiveRays { plane, distance: self.distance, inverse_distance }
    }
}
