//! Sections.

use crate::solid::{Difference, Painted, Rgb};

/// A solid cut open: see [`section`].
pub type Section<T, C> = Difference<T, Painted<C>>;

/// What is left of `solid` outside of `cut`, with the cut faces in a colour: for a look inside of a part.
///
/// Cut by a [`HalfSpace`](crate::solid::HalfSpace) for one flat section: `HalfSpace::above(Axis::Z, offset)`
/// takes away all that lies above.
///
/// The cut faces are faces of `cut`, seen from their other side: flat with the normal of the plane if that is
/// a slab, and as exact as any face. Faces of `solid` keep their colours. Where both coincide, the face is
/// that of `solid`. In a picture, a section costs what a [`Difference`] costs.
///
/// ```
/// use scancsg::constant;
/// use scancsg::geom::{Ray, vec3};
/// use scancsg::inspect::{Section, section};
/// use scancsg::solid::{Cylinder, Difference, HalfSpace, Painted, RayCast, Rgb, Solid};
/// use scancsg::span::SpanList;
///
/// type Tube = Difference<Cylinder<f32>, Cylinder<f32>>;
///
/// const STEEL: Rgb = Rgb::new(150, 175, 200);
/// const RED: Rgb = Rgb::new(200, 40, 30);
/// const TUBE: Tube = Tube::new(
///     constant!(Cylinder::<f32>::along_x(0.0, 0.0, 1.0, -2.0, 2.0)),
///     constant!(Cylinder::<f32>::along_x(0.0, 0.0, 0.75, -3.0, 3.0)),
/// );
/// // All that is in front of z = 0 goes: −z ≤ 0.
/// const FRONT: HalfSpace<f32> = constant!(HalfSpace::<f32>::new(vec3(0.0, 0.0, -1.0), 0.0));
/// const OPEN: Section<Painted<Tube>, HalfSpace<f32>> =
///     section(Painted::new(TUBE, STEEL), FRONT, RED);
///
/// let look = |y| {
///     let ray = Ray::new(vec3(0.0, y, 5.0), vec3(0.0, 0.0, -1.0)).ok()?;
///     let hit = OPEN.hit(&ray, &mut SpanList::<_, 8>::new())?;
///     Some((hit.point.z, hit.normal, OPEN.color(hit.face)?))
/// };
/// // The wall is cut, and the bore is behind the cut.
/// assert_eq!(look(0.875), Some((0.0, vec3(0.0, 0.0, 1.0), RED)));
/// assert_eq!(look(0.0), Some((-0.75, vec3(0.0, 0.0, 1.0), STEEL)));
/// ```
#[must_use]
pub const fn section<T, C>(solid: T, cut: C, color: Rgb) -> Section<T, C> {
    Difference::new(solid, Painted::new(cut, color))
}
