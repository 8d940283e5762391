//! One error for all operations.

use crate::geom::{AffineError, AxisLineError, PoseError, RayError};
use crate::inspect::MassError;
use crate::program::{BytesError, LineError, ProgramError};
use crate::render::{CameraError, RowError, ShadeError, SizeError, SmoothError};
use crate::solid::{
    ConeError, CuboidError, CylinderError, HalfSpaceError, ManyError, PipeError, PolyhedronError,
    SlabError, SphereError, TorusError,
};
use crate::span::StackFull;
use crate::spline::{CurveError, EvaluateError, FlattenError, KnotError, SweepError};
use crate::stream::{
    EncodeError, LinkError, PacketError, ReceiveError, Refusal, ServeError, UnpackError,
};

crate::error_text! {
    /// What is kept of a display's own error.
    pub enum DisplayError {
        /// The display can't draw.
        Draw => "drawing on the target failed",
    }
}

macro_rules! errors {
    ($(#[$about:meta])* { $($(#[$when:meta])* $Variant:ident($Error:ident),)+ }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[non_exhaustive]
        pub enum Error {
            $($(#[$when])* $Variant($Error),)+
        }

        impl Error {
            /// What is wrong, in a sentence: that of the error inside.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(Self::$Variant(error) => error.as_str(),)+
                }
            }
        }

        $(impl From<$Error> for Error {
            fn from(error: $Error) -> Self {
                Self::$Variant(error)
            }
        })+
    };
}

errors! {
    /// Any error of the crate, for functions that do several things: `?` turns each error into this one.
    ///
    /// It is two or three bytes, copied at will. Operations themselves have errors of their own, which say
    /// less and so are easier to handle. Of a [`ServeError`] it keeps how the line failed, and of a display that
    /// it failed, and not the line's or the display's own error.
    ///
    /// ```
    /// use scancsg::geom::vec3;
    /// use scancsg::render::{Gray8, Lambert, Orthographic, Picture, RowSource, Size};
    /// use scancsg::solid::{Cylinder, CylinderError};
    ///
    /// /// The middle row of a rod's picture.
    /// fn middle_row(radius: f32, row: &mut [Gray8; 64]) -> Result<(), scancsg::Error> {
    ///     let rod = Cylinder::<f32>::along_x(0.0, 0.0, radius, -1.0, 1.0)?;
    ///     let (eye, target, up) = (vec3(0.0, 2.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    ///     let camera = Orthographic::look_at(eye, target, up, 3.0)?;
    ///     let light = Lambert::new(vec3(-1.0, 2.0, 1.0), 0.2)?;
    ///     let mut picture = Picture::new(&rod, &camera, Size::new(64, 48)?, light, Gray8(0));
    ///     picture.render(24, row)?;
    ///     Ok(())
    /// }
    ///
    /// let mut row = [Gray8(0); 64];
    /// assert_eq!(middle_row(0.5, &mut row), Ok(()));
    /// assert_ne!(row[32], Gray8(0));
    ///
    /// let error = middle_row(-0.5, &mut row).unwrap_err();
    /// assert_eq!(error, CylinderError::Radius.into());
    /// assert_eq!(error.as_str(), CylinderError::Radius.as_str());
    /// ```
    {
        /// Of an affine map.
        Affine(AffineError),
        /// Of an axis that solids share.
        AxisLine(AxisLineError),
        /// Of a program's bytes.
        Bytes(BytesError),
        /// Of a camera.
        Camera(CameraError),
        /// Of a cone.
        Cone(ConeError),
        /// Of a cuboid.
        Cuboid(CuboidError),
        /// Of a curve.
        Curve(CurveError),
        /// Of a cylinder.
        Cylinder(CylinderError),
        /// Of a packet that is made.
        Encode(EncodeError),
        /// Of a display.
        Display(DisplayError),
        /// Of a curve's value.
        Evaluate(EvaluateError),
        /// Of a curve that becomes a polyline.
        Flatten(FlattenError),
        /// Of a half-space.
        HalfSpace(HalfSpaceError),
        /// Of knots.
        Knot(KnotError),
        /// Of too many spans on a line.
        Line(LineError),
        /// Of a link's line.
        Link(LinkError),
        /// Of a union of many solids.
        Many(ManyError),
        /// Of a volume or a moment.
        Mass(MassError),
        /// Of a packet that came.
        Packet(PacketError),
        /// Of a pipe.
        Pipe(PipeError),
        /// Of a polyhedron.
        Polyhedron(PolyhedronError),
        /// Of a pose.
        Pose(PoseError),
        /// Of a program.
        Program(ProgramError),
        /// Of a ray.
        Ray(RayError),
        /// Of a packet that isn't taken in.
        Receive(ReceiveError),
        /// Of an upload that a device doesn't want.
        Refusal(Refusal),
        /// Of a row.
        Row(RowError),
        /// Of a shader.
        Shade(ShadeError),
        /// Of a picture's size.
        Size(SizeError),
        /// Of a slab.
        Slab(SlabError),
        /// Of a smooth picture.
        Smooth(SmoothError),
        /// Of a sphere.
        Sphere(SphereError),
        /// Of a list of spans.
        StackFull(StackFull),
        /// Of a sweep.
        Sweep(SweepError),
        /// Of a torus.
        Torus(TorusError),
        /// Of the pixels in a packet.
        Unpack(UnpackError),
    }
}

impl core::fmt::Display for Error {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.as_str())
    }
}

impl core::error::Error for Error {}

impl<E> From<ServeError<E>> for Error {
    fn from(error: ServeError<E>) -> Self {
        match error {
            ServeError::Render(error) => error.into(),
            ServeError::Encode(error) => error.into(),
            ServeError::Write(_) => LinkError::Write.into(),
            ServeError::Read(_) => LinkError::Read.into(),
            ServeError::Closed => LinkError::Closed.into(),
        }
    }
}
