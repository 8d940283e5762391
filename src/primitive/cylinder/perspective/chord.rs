//! Chords: where a ray from an eye meets the wall, from its own vectors.
//!
//! In a row, q = u × axis and m = d × axis are affine in the column, and so is k = u·m, because
//! all rays run through the eye. Both vectors are at right angles to the axis, so two coordinates
//! hold each of them.
//!
//! The columns that can meet the wall come from k as an affine number, but a pixel's k from its own q and
//! m, as they are rounded: then the three belong to one ray, which is a pixel's but for the rounding of
//! its point and direction, also where it is nearly parallel to the axis and m is small.

use super::super::{Cylinder, frame, set_common, wall_span};
use crate::geom::{Affine, Extent, PerspectiveRays, Vec3, signed};
use crate::scalar::{Grid, Number, Real, Roots, Scalar};
use crate::scan::bounds::{PerspectiveBall, Rows, Silhouette, Steps, constant, extent};
use crate::scan::planes;
use crate::span::{Face, Span};

impl<S: Scalar> ChordView<S> {
    pub(super) fn new(cylinder: &Cylinder<S>, rays: &PerspectiveRays<S>) -> Self {
        let Cylinder { wall, caps } = cylinder;
        let axis = caps.normal.wide();
        let plane = &rays.plane;
        let inverse_distance = rays.inverse_distance;
        let [u, right, down] = plane.steps(wall.base.wide());
        let across = frame(axis);
        let flat = |moment: Vec3<S::Wide>| across.map(|side| side.dot(moment));
        let m = plane.forward.cross(axis);
        let [right, down] = [right, down].map(|step| {
            let moment = step.cross(axis);
            let k = step.dot_compensated(m) + inverse_distance * u.dot_compensated(moment);
            (flat(moment), k)
        });
        let (center, ball_radius) = cylinder.bounding_ball();
        let ball = PerspectiveBall::new(center, ball_radius, rays);
        let view = Self {
            moment: [flat(u.cross(axis)), right.0, down.0],
            turn: flat(m),
            caps: planes::PerspectiveView::new(&caps.normal, rays),
            edges: Edges::Nowhere,
        };
        let reach = [u.dot_compensated(m), right.1, down.1];
        let lines = if is_float::<S>() && ball.is_before_eye(rays.distance) {
            Lines::new(cylinder, rays, &view, reach, ball.in_rows())
        } else {
            None
        };
        let edges = match lines {
            Some(lines) => Edges::Lines(lines),
            None => {
                let at_eye = u.cross(axis) - m * rays.distance;
                let radius = wall.radius.wide();
                Edges::Curves {
                    reach,
                    blur: ((radius + S::ROUNDING.wide()) * S::ROUNDING.wide()).sqrt(),
                    eye_within: at_eye.length() < radius,
                    ball,
                }
            }
        };
        Self { edges, ..view }
    }

    #[inline]
    pub(super) fn is_in_rows(&self, rows: [i32; 2]) -> bool {
        match &self.edges {
            Edges::Lines(lines) => lines.rows.meet(rows),
            Edges::Curves { ball, .. } => ball.is_in_rows(rows),
            Edges::Nowhere => false,
        }
    }

    /// Whether the eye lies inside the infinite cylinder, and with it any ray along the axis.
    #[inline]
    pub(super) fn eye_within(&self) -> bool {
        matches!(self.edges, Edges::Curves { eye_within: true, .. })
    }

    pub(super) fn row(&self, y: i32) -> ChordRow<S> {
        let [[q0, q1], [right0, right1], [down0, down1]] = self.moment;
        let [m0, m1] = self.turn;
        let axis = |q, m, right, down| {
            let offset = Affine::row([S::Wide::ZERO, right, down], y);
            (offset.above(q), offset.times(self.caps.inverse_distance).above(m))
        };
        let ((q0, m0), (q1, m1)) = (axis(q0, m0, right0, down0), axis(q1, m1, right1, down1));
        let caps = planes::PerspectiveRow::new(&self.caps, y);
        ChordRow { moment: [q0, q1], turn: [m0, m1], caps }
    }

    /// The columns of a row.
    pub(super) fn extent(&self, row: &ChordRow<S>, radius: S, y: i32, columns: u32) -> Extent {
        match &self.edges {
            Edges::Lines(lines) => lines.extent(row, y, columns),
            Edges::Curves { reach, blur, ball, .. } => {
                let [m0, m1] = row.turn;
                let reach = Affine::row(*reach, y);
                // r|m| ≥ |k| with k off by `ROUNDING`, however small m is:
                // (r + b)²m² + (r + b)b ≥ (r|m| + b)².
                let radius = radius.plus(S::ROUNDING).wide();
                let wide = [m0.times(radius), m1.times(radius), constant(*blur)];
                extent(&wide, &[reach], columns).overlap(ball.extent(y, columns))
            }
            Edges::Nowhere => Extent::EMPTY,
        }
    }
}

impl<S: Scalar> ChordRow<S> {
    /// Sets a ray's span to that of the cylinder, if there is one.
    #[inline(always)]
    pub(super) fn set_span(
        &self,
        cylinder: &Cylinder<S>,
        eye_within: bool,
        x: i32,
        span: &mut Span<S>,
    ) {
        let Cylinder { wall, caps } = cylinder;
        let q = self.moment.map(|part| S::from_wide(part.at(x)));
        let m = self.turn.map(|part| S::unit(part.at(x)));
        let chord = match S::chord(wall.radius, [S::moment(q, m)], q, m) {
            Some(Roots::Between(enter, exit)) => [enter, exit],
            None => match self.nearly_along(wall.radius, eye_within, x) {
                Some(chord) => chord,
                None => return,
            },
            _ => return,
        };
        let between = caps.perspective_roots(&self.caps, x);
        match between.roots {
            // For each order in its place: the faces are constants.
            Roots::Between(low, high) if between.upwards => {
                set_common(span, chord, [low, high], [Face(0), Face(1)]);
            }
            Roots::Between(low, high) => {
                set_common(span, chord, [high, low], [Face(1), Face(0)]);
            }
            Roots::Everywhere => {
                let [enter, exit] = chord;
                *span = wall_span(enter, exit).unwrap_or(Span::NOWHERE);
            }
            Roots::Outside => {}
        }
    }

    /// Where a ray is inside the wall that is nearly parallel to the axis, or exactly.
    ///
    /// In fixed point, a direction has less digits than what it is rounded from. These are enough for rays
    /// down to 2⁻¹⁸ radians.
    #[cold]
    #[inline(never)]
    fn nearly_along(&self, radius: S, eye_within: bool, x: i32) -> Option<[S; 2]> {
        if S::SHORTEST > S::ZERO {
            let sixteen = S::Wide::from_int(16);
            let q = self.moment.map(|part| S::from_wide(part.at(x)));
            let m = self.turn.map(|part| S::unit(part.at(x) * sixteen));
            match S::chord(radius, [S::moment(q, m)], q, m) {
                Some(Roots::Between(enter, exit)) => {
                    return Some([enter, exit].map(|t| S::from_wide(t.wide() * sixteen)));
                }
                Some(_) => return None,
                None => {}
            }
        }
        eye_within.then_some([S::LOWEST, S::HIGHEST])
    }
}

/// A cylinder, seen from an eye: values in the middle of the picture and their steps.
#[derive(Debug, Clone, Copy)]
pub struct ChordView<S: Scalar> {
    /// q.
    moment: [[S::Wide; 2]; 3],
    /// m in the middle; its steps are those of q times the convergence.
    turn: [S::Wide; 2],
    caps: planes::PerspectiveView<S>,
    edges: Edges<S>,
}

/// Where the cylinder is seen.
#[derive(Debug, Clone, Copy)]
enum Edges<S: Scalar> {
    /// Not set yet.
    Nowhere,
    /// From outside of the wall, with all of the cylinder before the eye: between lines.
    Lines(Lines<S>),
    /// From inside or near: where quadratics aren't negative.
    Curves {
        /// k.
        reach: [S::Wide; 3],
        /// √((r + b)b), where b is [`Scalar::ROUNDING`].
        blur: S::Wide,
        eye_within: bool,
        ball: PerspectiveBall<S>,
    },
}

/// The traces of planes through the eye that touch the wall or the caps, as in `tangents.rs`.
#[derive(Debug, Clone, Copy)]
struct Lines<S: Scalar> {
    /// A and B.
    sides: [[S::Wide; 3]; 2],
    /// W is the scalar product of m and this.
    toward: [S::Wide; 2],
    /// How high the edges of the caps are above the eye, over D.
    ends: [S::Wide; 2],
    rows: Rows,
}

impl<S: Scalar> Lines<S> {
    /// `None` from inside of the wall or near to it, or where a number leaves its type's range.
    fn new(
        Cylinder { wall, caps }: &Cylinder<S>,
        rays: &PerspectiveRays<S>,
        view: &ChordView<S>,
        reach: [S::Wide; 3],
        rows: Rows,
    ) -> Option<Self> {
        let PerspectiveRays { distance, inverse_distance, .. } = *rays;
        let radius = wall.radius.wide();
        let ([q0, q1], [m0, m1]) = (view.moment[0], view.turn);
        let eye = [q0 - m0 * distance, q1 - m1 * distance];
        let length = (eye[0] * eye[0] + eye[1] * eye[1]).sqrt();
        let gap = length - radius;
        if gap * S::Wide::from_int(64) <= length {
            return None;
        }
        let c = gap * (length + radius);
        let factor = distance / c;
        let toward = eye.map(|x| -(x * factor));
        let [slope, across] = [radius / length, c.sqrt() / length * factor];
        let flat = |m: [S::Wide; 2]| m[0] * toward[0] + m[1] * toward[1];
        // The steps of m are those of q over D.
        let [_, right, down] = view.moment.map(|q| flat(q) * inverse_distance);
        let sides = [across, -across].map(|across| {
            let [k, k_right, k_down] = reach.map(|k| k * across);
            let [w, w_right, w_down] = [flat(view.turn), right, down].map(|w| w * slope);
            [w + k, w_right + k_right, w_down + k_down]
        });
        let at_eye = view.caps.at_eye(distance);
        let ends = [(caps.low, -slope), (caps.high, slope)].map(|(cap, lean)| {
            let end = (cap.wide() - at_eye) * inverse_distance;
            end + lean * end.abs()
        });
        let all = sides.as_flattened().iter().chain(&ends).chain(&toward);
        let has_size = toward.iter().any(|x| x.is_divisor());
        let fits = has_size && all.clone().all(|x| x.is_finite());
        fits.then_some(Self { sides, toward, ends, rows })
    }

    /// The columns of a row.
    fn extent(&self, row: &ChordRow<S>, y: i32, columns: u32) -> Extent {
        let reach = S::Wide::from_int(signed(columns));
        let size = |line: &Affine<S::Wide>| line.middle.abs() + line.step.abs() * reach;
        let [m0, m1] = row.turn;
        let w = m0.times(self.toward[0]).plus(&m1.times(self.toward[1]));
        let [_, speed] = row.caps.lines();
        let unit = S::Wide::EPSILON * S::Wide::from_int(64);
        let around = (size(&m0) * self.toward[0].abs() + size(&m1) * self.toward[1].abs()) * unit;
        let from = |line: Affine<S::Wide>, room| Steps::not_below(line.above(room));
        let [a, b] = self.sides.map(|side| from(Affine::row(side, y), around));
        let steps = a.overlap(b);
        if steps.are_beside(columns) {
            return Extent::EMPTY;
        }
        let [low, high] = self.ends.map(|end| w.times(end));
        let [room_low, room_high] = self.ends.map(|end| around * end.abs() + size(&speed) * unit);
        steps
            .overlap(from(speed.minus(&low), room_low))
            .overlap(from(high.minus(&speed), room_high))
            .columns(columns)
    }
}

/// Whether the number type is a floating-point one.
const fn is_float<S: Scalar>() -> bool {
    !matches!(S::GRID, Grid::Fixed(_))
}

/// A row of a cylinder, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub struct ChordRow<S: Scalar> {
    /// Two coordinates of q, and of m.
    pub(super) moment: [Affine<S::Wide>; 2],
    pub(super) turn: [Affine<S::Wide>; 2],
    pub(super) caps: planes::PerspectiveRow<S>,
}
