//! Rings of cylinders.

use crate::geom::Axis;
use crate::primitive::{Cylinder, CylinderError};
use crate::scalar::{ConstOps, Number, Real, Scalar, per_scalar, sin_cos_of_part};

per_scalar! { $S: impl[] Cylinder<$S> {
    /// `N` cylinders along a coordinate axis, evenly spaced on a circle: as [`ring`](Self::ring), for constants.
    ///
    /// It is computed in `f64`. A coordinate may differ from that of `ring` by a rounding error.
    ///
    /// ```
    /// use scancsg::constant;
    /// use scancsg::geom::Axis;
    /// use scancsg::solid::Cylinder;
    ///
    /// const HOLES: [Cylinder<f32>; 6] =
    ///     constant!(Cylinder::<f32>::ring_along(Axis::Z, [0.0, 0.0], 1.5, 0.2, -1.0, 1.0));
    /// # let _ = HOLES;
    /// ```
    ///
    /// A ring of negative radius does not compile:
    ///
    /// ```compile_fail,E0080
    /// use scancsg::constant;
    /// use scancsg::geom::Axis;
    /// use scancsg::solid::Cylinder;
    ///
    /// const HOLES: [Cylinder<f32>; 6] =
    ///     constant!(Cylinder::<f32>::ring_along(Axis::Z, [0.0, 0.0], -1.5, 0.2, -1.0, 1.0));
    /// # let _ = HOLES;
    /// ```
    ///
    /// # Errors
    /// As [`ring`](Self::ring).
    pub const fn ring_along<const N: usize>(
        axis: Axis, [u, v]: [$S; 2], ring_radius: $S, radius: $S, low: $S, high: $S,
    ) -> Result<[Self; N], CylinderError> {
        type Ops<S> = ConstOps<S>;
        if !Ops::<$S>::is_radius(ring_radius) {
            return Err(CylinderError::Radius);
        }
        let mut ring: Option<[Self; N]> = None;
        let mut index = 0;
        loop {
            let (sin, cos) = sin_cos_of_part(index, N);
            let size = Ops::<$S>::to_f64(ring_radius);
            let x = Ops::<$S>::sum(u, Ops::<$S>::from_f64(size * cos));
            let y = Ops::<$S>::sum(v, Ops::<$S>::from_f64(size * sin));
            match (Self::spanning(axis, low..high, [x, y], radius), &mut ring) {
                (Err(error), _) => return Err(error),
                (Ok(hole), None) => ring = Some([hole; N]),
                (Ok(hole), Some(ring)) => ring[index] = hole,
            }
            index += 1;
            if let (Some(ring), true) = (ring, index >= N) {
                return Ok(ring);
            }
        }
    }
} }

impl<S: Scalar> Cylinder<S> {
    /// `N` cylinders along a coordinate axis, evenly spaced on a circle: a ring of bolt holes. In
    /// constants, use [`ring_along`](Self::ring_along).
    ///
    /// `[u, v]` is the circle's middle in the other two coordinates, in the order x, y, z. Cylinder k is at the
    /// angle 2πk/N, counted from u to v. `ring_radius` is the circle's radius, `radius` that of each cylinder;
    /// they reach from `low` to `high` along the axis.
    ///
    /// ```
    /// use scancsg::geom::Axis;
    /// use scancsg::solid::Cylinder;
    ///
    /// let holes = Cylinder::<f32>::ring::<6>(Axis::Z, [0.0, 0.0], 1.5, 0.2, -1.0, 1.0)?;
    /// let flange = Cylinder::<f32>::along_z(0.0, 0.0, 2.0, -0.2, 0.2)? - holes;
    /// # let _ = flange;
    /// # Ok::<(), scancsg::solid::CylinderError>(())
    /// ```
    ///
    /// # Errors
    /// As [`along`](Self::along), and [`CylinderError::Radius`] for a `ring_radius` that isn't one.
    pub fn ring<const N: usize>(
        axis: Axis,
        [u, v]: [S; 2],
        ring_radius: S,
        radius: S,
        low: S,
        high: S,
    ) -> Result<[Self; N], CylinderError> {
        if !ring_radius.is_radius() {
            return Err(CylinderError::Radius);
        }
        let first = Self::along(axis, [u.plus(ring_radius), v], radius, low, high)?;
        let mut ring = [first; N];
        let turn = (S::Wide::PI + S::Wide::PI) / S::Wide::from_int(N as i32);
        for (hole, index) in ring.iter_mut().zip(0..).skip(1) {
            let (sin, cos) = (turn * S::Wide::from_int(index)).sin_cos();
            let [x, y] = [cos, sin].map(|part| S::from_wide(ring_radius.wide() * part));
            *hole = Self::along(axis, [u.plus(x), v.plus(y)], radius, low, high)?;
        }
        Ok(ring)
    }
}
