//! The cylinder, seen from an eye.
//!
//! In a row, q = u × axis and m = d × axis are affine in the column, and so is k = u·m, because
//! all rays run through the eye. Both vectors are at right angles to the axis, so two coordinates
//! hold each of them.

use super::{Cylinder, WALL, wall_span};
use crate::geom::{Affine, Pencil, Vec3};
use crate::scalar::{Chord, Number, Real, Scalar};
use crate::solid::row::{ConvexRow, Leaf, Project, View};
use crate::solid::silhouette::{PencilBall, constant, extent};
use crate::solid::slab;
use crate::span::Span;

impl<S: Scalar> Project<Pencil<S>> for Cylinder<S> {
    type View<'a> = PencilView<S>;

    fn view(&self, rays: &Pencil<S>) -> PencilView<S> {
        let axis = self.caps.normal.fine();
        let plane = &rays.plane;
        let convergence = rays.convergence;
        let [u, right, down] = plane.steps(self.tube.base.fine());
        let across = frame(axis);
        let flat = |moment: Vec3<S::Fine>| across.map(|side| side.dot(moment));
        let m = plane.forward.cross(axis);
        let [right, down] = [right, down].map(|step| {
            let moment = step.cross(axis);
            let k = step.dot_compensated(m) + convergence * u.dot_compensated(moment);
            (flat(moment), k)
        });
        let at_eye = u.cross(axis) - m * rays.distance;
        let radius = self.tube.radius.fine();
        let (center, ball_radius) = self.bounding_ball();
        PencilView {
            moment: [flat(u.cross(axis)), right.0, down.0],
            turn: flat(m),
            reach: [u.dot_compensated(m), right.1, down.1],
            convergence,
            radius: self.tube.radius,
            blur: ((radius + S::BLUR.fine()) * S::BLUR.fine()).sqrt(),
            eye_within: at_eye.length_squared() < radius * radius,
            caps: self.caps.view(rays),
            ball: PencilBall::new(center, ball_radius, rays),
            columns: plane.columns,
        }
    }
}

/// Two unit vectors that make a right-handed frame with `n`, a vector of length 1.
///
/// Duff et al., *Building an orthonormal basis, revisited*, Journal of Computer Graphics
/// Techniques 6 (2017), listing 3. Exact for coordinate axes.
fn frame<T: Real>(n: Vec3<T>) -> [Vec3<T>; 2] {
    let sign = if n.z < T::ZERO { -T::ONE } else { T::ONE };
    let a = -(T::ONE / (sign + n.z));
    let b = n.x * n.y * a;
    [
        Vec3::new(T::ONE + sign * n.x * n.x * a, sign * b, -sign * n.x),
        Vec3::new(b, sign + n.y * n.y * a, -n.y),
    ]
}

/// A cylinder, seen from an eye: values in the middle of the picture and their steps.
#[derive(Debug, Clone, Copy)]
pub struct PencilView<S: Scalar> {
    /// q.
    moment: [[S::Fine; 2]; 3],
    /// m in the middle; its steps are those of q times `convergence`.
    turn: [S::Fine; 2],
    /// k.
    reach: [S::Fine; 3],
    convergence: S::Fine,
    radius: S,
    /// √((r + b)b), where b is [`Scalar::BLUR`].
    blur: S::Fine,
    /// Whether the eye lies inside the infinite cylinder, and with it any ray along the axis.
    eye_within: bool,
    caps: slab::PencilView<S>,
    ball: PencilBall<S>,
    columns: u32,
}

impl<S: Scalar> View for PencilView<S> {
    type Scalar = S;
    type Row<'a> = Leaf<PencilRow<S>>;

    fn row(&self, y: i32) -> Self::Row<'_> {
        let [[q0, q1], [right0, right1], [down0, down1]] = self.moment;
        let [m0, m1] = self.turn;
        let axis = |q, m, right, down| {
            let offset = Affine::row([S::Fine::ZERO, right, down], y);
            let turn = offset.times(self.convergence);
            let plus = |middle: S::Fine, way: Affine<S::Fine>| Affine {
                middle: middle + way.middle,
                ..way
            };
            (plus(q, offset), plus(m, turn))
        };
        let ((q0, m0), (q1, m1)) = (axis(q0, m0, right0, down0), axis(q1, m1, right1, down1));
        let reach = Affine::row(self.reach, y);
        // r|m| ≥ |k| with k off by `BLUR`, however small m is: (r + b)²m² + (r + b)b ≥ (r|m| + b)².
        let radius = self.radius.plus(S::BLUR).fine();
        let wide = [m0.times(radius), m1.times(radius), constant(self.blur)];
        let silhouette = extent(&wide, &[reach], self.columns);
        Leaf {
            row: PencilRow {
                moment: [q0, q1],
                turn: [m0, m1],
                reach,
                radius: self.radius,
                eye_within: self.eye_within,
                caps: self.caps.slab_row(y),
            },
            extent: silhouette.overlap(self.ball.extent(y)),
        }
    }
}

/// A row of a cylinder, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct PencilRow<S: Scalar> {
    /// Two coordinates of q and of m, and k.
    moment: [Affine<S::Fine>; 2],
    turn: [Affine<S::Fine>; 2],
    reach: Affine<S::Fine>,
    radius: S,
    eye_within: bool,
    caps: slab::PencilRow<S>,
}

impl<S: Scalar> ConvexRow for PencilRow<S> {
    type Scalar = S;
    const FACES: u16 = 3;

    #[inline]
    fn span(&self, x: i32) -> Option<Span<S>> {
        let q = self.moment.map(|part| S::from_fine(part.at(x)));
        let m = self.turn.map(|part| S::unit(part.at(x)));
        let k = [S::from_fine(self.reach.at(x))];
        let within_wall = match S::chord(self.radius, k, q, m) {
            Chord::Between(enter, exit) => wall_span(enter, exit)?,
            Chord::Along if self.eye_within => Span::whole_line(WALL),
            Chord::Along | Chord::Beside => return None,
        };
        self.caps.span(x)?.overlap(within_wall)
    }
}
