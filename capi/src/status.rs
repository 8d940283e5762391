//! What functions return: whether they did what was asked, and what is wrong if not.

use core::ffi::{CStr, c_char};
use scancsg::geom::{PoseError, RayError};
use scancsg::program::{BytesError, LineError, ProgramError};
use scancsg::render::{CameraError, RowError, ShadeError, SizeError};
use scancsg::solid::{
    ConeError, CuboidError, CylinderError, HalfSpaceError, SphereError, TorusError,
};
use scancsg::stream::EncodeError;

/// What a function returns: `SCANCSG_STATUS_OK`, or why it did nothing.
///
/// Codes stay as they are in later versions, which may have more of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i32)]
#[must_use]
pub enum Status {
    /// It is done.
    Ok = 0,
    /// A pointer is null.
    Null = 1,
    /// A pointer isn't aligned as its type must be.
    Alignment = 2,
    /// A scene or picture has another size in the header than in the library: they were built with
    /// different options.
    Storage = 3,
    /// The scene isn't built, or the picture isn't made.
    NotMade = 4,
    /// The scene has changed since its picture was made: make the picture again.
    Changed = 5,
    /// A buffer is shorter than what goes into it, or pixels are more or fewer than their bytes.
    Length = 6,
    /// No pixel format has this number, or packets can't have it.
    Format = 7,
    /// The library has failed in a way that this version has no code for.
    Other = 8,

    /// A number of a part, pose, view or ray is infinite or not a number.
    NotFinite = 16,
    /// A part, a pose, a view or a ray's start is too far away for the number type.
    TooFar = 17,
    /// A radius isn't positive, or out of the number type's range.
    Radius = 18,
    /// A part has no volume: its ends coincide, or its corners are the wrong way round.
    Empty = 19,
    /// An axis or a normal is zero.
    ZeroAxis = 20,
    /// The tube of a torus is as wide as its ring, or wider.
    Tube = 21,

    /// A step is of no kind that this build has.
    Kind = 32,
    /// A step has bits in `has` that mean nothing.
    Has = 33,
    /// The scene has no room for another part.
    Parts = 34,
    /// The scene has no room for another pose.
    Poses = 35,
    /// There are fewer operands than are to be combined, or no part at all.
    Operands = 36,
    /// No pose has this index.
    NoPose = 37,

    /// The bytes are no program.
    Magic = 48,
    /// The program has another version of the format.
    Version = 49,
    /// The program has numbers of another type.
    NumberType = 50,
    /// The bytes of the program end too early or too late.
    Bytes = 51,
    /// The program has an unknown tag.
    Tag = 52,
    /// The numbers of a part of the program make no solid of its kind.
    Solid = 53,
    /// The numbers of a pose of the program are no rigid motion.
    Motion = 54,
    /// The program's tree is too large, or an operator has too few operands.
    Tree = 55,

    /// The eye lies on the target.
    ZeroDirection = 64,
    /// The camera looks along its up vector, or that vector is zero.
    UpAlongView = 65,
    /// The height of the frame isn't positive.
    FrameHeight = 66,
    /// The field of view isn't between 0 and pi, or too wide.
    FieldOfView = 67,
    /// The direction to the light is zero, infinite or not a number.
    LightDirection = 68,
    /// The ambient light isn't between 0 and 1.
    Ambient = 69,
    /// The width or the height is zero.
    Size = 70,
    /// A row or a column isn't inside the picture.
    Index = 71,
    /// The picture shows more of the scene than its number type's range.
    Range = 72,
    /// The eye is too near to the target for the number type.
    TooNear = 73,

    /// The direction of the ray is zero.
    ZeroRay = 80,
    /// The direction of the ray is too short or too long for the number type.
    RayLength = 81,
    /// The ray has more spans in the scene than there is room for.
    Spans = 82,
}

const TEXTS: [(Status, &CStr); 42] = [
    (Status::Ok, c"it is done"),
    (Status::Null, c"a pointer is null"),
    (Status::Alignment, c"a pointer isn't aligned as its type must be"),
    (Status::Storage, c"header and library were built with different options"),
    (Status::NotMade, c"the scene isn't built, or the picture isn't made"),
    (Status::Changed, c"the scene has changed since its picture was made"),
    (Status::Length, c"a buffer is shorter or longer than what goes into it"),
    (Status::Format, c"no such pixel format, or packets can't have it"),
    (Status::Other, c"the library has failed without a code"),
    (Status::NotFinite, c"a number is infinite or not a number"),
    (Status::TooFar, c"something is too far away for the number type"),
    (Status::Radius, c"a radius isn't positive, or out of the number type's range"),
    (Status::Empty, c"a part has no volume"),
    (Status::ZeroAxis, c"an axis or a normal is zero"),
    (Status::Tube, c"the tube of a torus is as wide as its ring, or wider"),
    (Status::Kind, c"a step is of no kind that this build has"),
    (Status::Has, c"a step has bits in `has` that mean nothing"),
    (Status::Parts, c"the scene has no room for another part"),
    (Status::Poses, c"the scene has no room for another pose"),
    (Status::Operands, c"there are fewer operands than are to be combined"),
    (Status::NoPose, c"no pose has this index"),
    (Status::Magic, c"the bytes are no program"),
    (Status::Version, c"the program has another version of the format"),
    (Status::NumberType, c"the program has numbers of another type"),
    (Status::Bytes, c"the bytes of the program end too early or too late"),
    (Status::Tag, c"the program has an unknown tag"),
    (Status::Solid, c"the numbers of a part make no solid of its kind"),
    (Status::Motion, c"the numbers of a pose are no rigid motion"),
    (Status::Tree, c"the tree is too large, or an operator has too few operands"),
    (Status::ZeroDirection, c"the eye lies on the target"),
    (Status::UpAlongView, c"the camera looks along its up vector, or that is zero"),
    (Status::FrameHeight, c"the height of the frame isn't positive"),
    (Status::FieldOfView, c"the field of view isn't between 0 and pi, or too wide"),
    (Status::LightDirection, c"the direction to the light is no direction"),
    (Status::Ambient, c"the ambient light isn't between 0 and 1"),
    (Status::Size, c"the width or the height is zero"),
    (Status::Index, c"a row or a column isn't inside the picture"),
    (Status::Range, c"the picture shows more than its number type's range"),
    (Status::TooNear, c"the eye is too near to the target for the number type"),
    (Status::ZeroRay, c"the direction of the ray is zero"),
    (Status::RayLength, c"the direction of the ray is too short or too long"),
    (Status::Spans, c"the ray has more spans than there is room for"),
];

/// What a status means, in English. It is never null, whatever the number.
#[unsafe(no_mangle)]
pub extern "C" fn scancsg_status_text(status: i32) -> *const c_char {
    let known = TEXTS.iter().find(|(known, _)| *known as i32 == status);
    known.map_or(c"no status has this number", |(_, text)| text).as_ptr()
}

impl Status {
    /// The status of what was done, or not.
    pub(crate) fn of(result: Result<(), Self>) -> Self {
        result.err().unwrap_or(Self::Ok)
    }
}

/// Errors of the library, which may have more of them in a later version.
macro_rules! from {
    ($($Error:ident { $($Variant:ident => $Status:ident,)+ })+) => {$(
        impl From<$Error> for Status {
            fn from(error: $Error) -> Self {
                match error {
                    $($Error::$Variant => Self::$Status,)+
                    _ => Self::Other,
                }
            }
        }
    )+};
}

from! {
    CylinderError { NotFinite => NotFinite, Radius => Radius, TooFar => TooFar, Empty => Empty, }
    CuboidError { NotFinite => NotFinite, Empty => Empty, TooFar => TooFar, Radius => Radius, }
    SphereError { NotFinite => NotFinite, Radius => Radius, TooFar => TooFar, }
    ConeError { NotFinite => NotFinite, Radius => Radius, TooFar => TooFar, Empty => Empty, }
    HalfSpaceError { NotFinite => NotFinite, ZeroNormal => ZeroAxis, TooFar => TooFar, }
    TorusError {
        NotFinite => NotFinite, ZeroAxis => ZeroAxis, Radius => Radius, Tube => Tube, TooFar => TooFar,
    }
    PoseError { NotFinite => NotFinite, TooFar => TooFar, ZeroAxis => ZeroAxis, }
    ProgramError { Parts => Parts, Poses => Poses, Operands => Operands, NoPose => NoPose, }
    BytesError {
        Magic => Magic, Version => Version, Number => NumberType, Length => Bytes, Tag => Tag,
        Kind => Kind, Solid => Solid, Pose => Motion, Tree => Tree,
    }
    CameraError {
        NotFinite => NotFinite, ZeroDirection => ZeroDirection, TooNear => TooNear, TooFar => TooFar,
        UpAlongView => UpAlongView, FrameHeight => FrameHeight, FieldOfView => FieldOfView,
    }
    ShadeError { LightDirection => LightDirection, Ambient => Ambient, }
    SizeError { Zero => Size, }
    RowError { Index => Index, Length => Length, Range => Range, }
    RayError {
        NotFinite => NotFinite, ZeroDirection => ZeroRay, TooFar => TooFar, DirectionLength => RayLength,
    }
    LineError { Spans => Spans, }
    EncodeError { BufferTooSmall => Length, Size => Size, Format => Format, }
}
