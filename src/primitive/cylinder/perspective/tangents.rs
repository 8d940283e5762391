//! The cylinder seen from an eye outside of its wall, in fixed point.
//!
//! Instead of a ray's parameter t, a pixel computes w = Z/(D + t): the inverse depth, with D the eye's
//! distance from the picture's middle and Z a power of two times D. It is affine along planes. So rays
//! from the eye become parallel ones, and nothing is divided before a crossing counts.
//!
//! With e the eye as seen from the axis, across it, c = |e|² − r², and d a ray's direction across the axis, the
//! wall is crossed at `w = W ± √(A·B)`, where W, A and B are Z/c times scalar products of d:
//!
//! ```text
//! W = −e·d    A = (−r e + √c e⊥)·d/|e|    B = (−r e − √c e⊥)·d/|e|
//! ```
//!
//! All three are affine in the pixel. A and B are the distances from the two planes through the eye that
//! touch the wall, so both are positive where a ray meets it. A cap is crossed where `H·w = h`, with H its
//! height above the eye, and h that of the image plane's point times Z/D.

use super::super::Cylinder;
use super::measure::{across, ball, bits, block, dot, mantissa};
use super::near::{NearRow, NearView};
use crate::geom::{Affine, Extent, PerspectiveRays};
use crate::numeric::{product, unsigned_product};
use crate::quadric::WALL;
use crate::scalar::integer::{normalized, reciprocal, shift_right, sqrt};
use crate::scalar::{FixedPoint, Number, Scalar, Wide};
use crate::scan::bounds::{Rows, Steps};
use crate::scan::{OPEN, planes};
use crate::span::{Crossing, Face, Span};

/// The bits behind the point of what is affine in the pixel, and of what a pixel makes of it.
const AFFINE_BITS: i32 = 44;
const PIXEL_BITS: i32 = 28;
/// W is less than this in all pixels that are asked: then A and B are less than twice as much.
const LARGEST: i64 = 4 << AFFINE_BITS;

/// A cylinder, seen from an eye.
#[derive(Debug, Clone, Copy)]
pub enum TangentView<S: Scalar> {
    /// From outside of the wall, in these rows.
    Outside(Tangents<S>, Rows),
    /// From inside of the wall, or too near; and whether from inside.
    Near(NearView<S>, bool),
}

/// A row of it.
#[derive(Debug, Clone, Copy)]
pub enum TangentRow<S: Scalar> {
    /// From outside of the wall.
    Outside(Pixels<S>),
    /// From inside or near.
    Near(NearRow<S>),
}

/// What a camera decides. It waits once for each cylinder, so its numbers have no more bits than they need.
#[derive(Debug, Clone, Copy)]
pub struct Tangents<S: Scalar> {
    /// W, A and B, each in the middle of the picture, and its steps to the right and down.
    lines: [[i32; 3]; 3],
    /// How far they are shifted: in the middle, and the steps.
    shifts: [i8; 2],
    /// D = Z · 2^halvings.
    distance: S::Wide,
    halvings: i8,
    /// Z is `zoom` with its last bit at this place.
    exponent: i8,
    zoom: u32,
    /// By how many of the last bits of [`Wide`] the eye's rounded height is below the eye.
    below: i32,
    caps: planes::PerspectiveView<S>,
}

/// Values in the middle of a row, and their steps.
#[derive(Debug, Clone, Copy)]
pub struct Pixels<S: Scalar> {
    middle: Affine<S::Wide>,
    sides: [Affine<S::Wide>; 2],
    /// How high the ray is above the eye where it has t = 0, in the units of `ends` times w.
    rise: Affine<S::Wide>,
    /// How fast it rises.
    speed: Affine<S::Wide>,
    /// How high the caps are above the eye's rounded height.
    ends: [S; 2],
}

impl<S: FixedPoint> TangentView<S> {
    pub(super) fn new(cylinder: &Cylinder<S>, rays: &PerspectiveRays<S>) -> Self {
        match Tangents::new(cylinder, rays) {
            Some((view, rows)) => Self::Outside(view, rows),
            None => {
                let (view, eye_within) = NearView::new(cylinder, rays);
                Self::Near(view, eye_within)
            }
        }
    }

    #[inline]
    pub(super) fn is_in_rows(&self, rows: [i32; 2]) -> bool {
        match self {
            Self::Outside(_, seen) => seen.meet(rows),
            Self::Near(..) => true,
        }
    }

    pub(super) fn row(
        &self,
        cylinder: &Cylinder<S>,
        y: i32,
        columns: u32,
    ) -> (TangentRow<S>, Extent) {
        match self {
            Self::Outside(view, _) => {
                let row = view.row(cylinder, y);
                (TangentRow::Outside(row), view.extent(&row, columns))
            }
            Self::Near(view, _) => {
                let (row, extent) = view.row(cylinder, y, columns);
                (TangentRow::Near(row), extent)
            }
        }
    }
}

impl<S: FixedPoint> Tangents<S> {
    /// `None` from inside of the wall, or too near.
    fn new(cylinder: &Cylinder<S>, rays: &PerspectiveRays<S>) -> Option<(Self, Rows)> {
        let Cylinder { wall, caps } = cylinder;
        let plane = &rays.plane;
        let across = across(&caps.normal);
        // Of unit vectors, 30 bits are behind the point.
        let unit = |v| across(v).map(|x: Wide| (x.to_bits() >> 2) as i32);
        let times = |[x, y]: [i32; 2], (length, exponent): (i32, i32)| {
            ([x, y].map(|x| (product(x, length) >> 31) as i32), exponent + 1)
        };
        let (zoom, zoom_exponent) = mantissa(rays.distance);
        let half_pixel = mantissa(plane.half_pixel);
        let forward = times(unit(plane.forward), (zoom, zoom_exponent));
        let right = times(unit(plane.right), half_pixel);
        let down = times(unit(plane.down), half_pixel);

        let [x, y] = across(plane.center - wall.base.wide());
        let back = forward.0.map(|x| Wide::from_bits(shift_right(x.into(), -forward.1)));
        let (eye, exponent) = block([x - back[0], y - back[1]]);
        // At most 2⁶⁰ · 2, so the length has 30 or 31 bits.
        let square = dot(eye, eye).unsigned_abs();
        let length = sqrt(square);
        let radius = shift_right(wall.radius.wide().to_bits(), exponent);
        let gap = i64::from(length) - radius;
        if radius < 1 << 8 || gap <= i64::from(length >> 8) {
            return None;
        }
        let radius = radius as i32;
        let c = square - unsigned_product(radius.cast_unsigned(), radius.cast_unsigned());
        let root = sqrt(c).cast_signed();

        let view = planes::PerspectiveView::new(&caps.normal, rays);
        let eye_height = view.at_eye(rays.distance);
        let ([nearest, farthest], rows) = ball(cylinder, rays, &view);
        let of_distance = bits(rays.distance.to_bits());
        // W is less than 2 to the power of the smaller one of two bounds: by the nearest point of the ball,
        // and by the eye's distance from the wall, because directions have coordinates below 8.
        let by_gap = of_distance + 5 - bits(shift_right(gap, -exponent));
        let by_ball = of_distance + bits(length.into()) + 2 - bits(nearest.to_bits()) - bits(gap);
        let bound = if nearest > Wide::ZERO { by_gap.min(by_ball) } else { by_gap };
        let halvings = (bound - 2).max(-8);
        // The last bit of w must not be more than 4 units of t for each unit of depth.
        let most = 29 - S::BITS as i32 + of_distance - bits(farthest.to_bits());
        if halvings > most.min(S::BITS as i32 - 4) {
            return None;
        }

        // Directions have coordinates below 8, so nothing that is affine exceeds its range.
        if of_distance - halvings + bits(length.into()) - exponent - bits(c.cast_signed()) > 11 {
            return None;
        }

        let (part, short) = normalized(length.into());
        let inverse = (reciprocal(part) >> 1).cast_signed();
        let by_length = |x: i64| shift_right(product((x >> 31) as i32, inverse), 31 + short);
        let [e0, e1] = eye;
        let side = |root: i32| {
            [
                by_length(-product(radius, e0) - product(root, e1)) as i32,
                by_length(product(root, e0) - product(radius, e1)) as i32,
            ]
        };
        let (part, short) = normalized(c);
        let inverse = (reciprocal(part) >> 1).cast_signed();
        let line = |plane: [i32; 2]| {
            [&forward, &right, &down]
                .map(|(step, _)| (product((dot(plane, *step) >> 30) as i32, inverse) >> 31) as i32)
        };
        let shift = short + exponent + halvings + 1 - AFFINE_BITS;
        // Farther, nothing is left, or all of the range.
        let stored = |shift: i32| shift.clamp(-127, 127) as i8;
        let view = Self {
            lines: [line([-e0, -e1]), line(side(root)), line(side(-root))],
            shifts: [forward.1, right.1].map(|of_step| stored(shift - of_step)),
            distance: rays.distance,
            halvings: stored(halvings),
            exponent: stored(63 - PIXEL_BITS + halvings - zoom_exponent),
            zoom: zoom.cast_unsigned(),
            below: (eye_height - S::from_wide(eye_height).wide()).to_bits() as i32,
            caps: view,
        };
        Some((view, rows))
    }

    fn row(&self, cylinder: &Cylinder<S>, y: i32) -> Pixels<S> {
        let caps = planes::PerspectiveRow::new(&self.caps, y);
        let [height, speed] = caps.lines();
        let eye = self.caps.at_eye(self.distance);
        let [rise, rise_step] = [height.middle - eye, height.step]
            .map(|x| Wide::from_bits(x.to_bits() << self.finer()));
        let [of_middle, of_step] = self.shifts.map(i32::from);
        let [middle, a, b] = self.lines.map(|[middle, right, down]| {
            let value = |bits: i32, shift| Wide::from_bits(shift_right(bits.into(), shift));
            Affine::row([value(middle, of_middle), value(right, of_step), value(down, of_step)], y)
        });
        Pixels {
            middle,
            sides: [a, b],
            rise: Affine { middle: rise, step: rise_step },
            speed,
            ends: [cylinder.caps.low, cylinder.caps.high].map(|end| end.minus(S::from_wide(eye))),
        }
    }

    /// So many bits has [`Pixels::rise`] below the last one of [`Wide`].
    fn finer(&self) -> i32 {
        S::BITS as i32 + PIXEL_BITS - 32 - i32::from(self.halvings)
    }

    /// The columns of a row: between the planes that touch the wall, and two that touch the caps. With
    /// |w − W| ≤ (A + B)/2 on the wall, a cap's edge is between `H·(W ± (A + B)/2)`.
    fn extent(&self, row: &Pixels<S>, columns: u32) -> Extent {
        let [a, b] = row.sides.map(Steps::not_below);
        let steps = a.overlap(b);
        if steps.are_beside(columns) {
            return Extent::EMPTY;
        }
        let shifted = |line: Affine<Wide>, shift| {
            let [middle, step] =
                [line.middle, line.step].map(|x| Wide::from_bits(shift_right(x.to_bits(), shift)));
            Affine { middle, step }
        };
        let shift = AFFINE_BITS - 32 - i32::from(self.halvings);
        let middle = shifted(row.middle, shift);
        // By how much w differs from W at most: (A + B)/2.
        let [a, b] = row.sides;
        let half = shifted(a.plus(&b), shift + 1);
        let rise = shifted(row.rise, self.finer());
        let room = S::ROUNDING.wide() * Wide::from_int(16);
        let ends = row.ends.map(Scalar::wide);
        let lean = |end: Wide, outwards: bool| {
            let is_added = (end > Wide::ZERO) == outwards;
            let edge = if is_added { middle.plus(&half) } else { middle.minus(&half) };
            edge.times(end)
        };
        let edge = |over: Affine<Wide>, under| {
            let room = room + Wide::from_bits(over.middle.abs().to_bits() >> 24);
            Steps::not_below(over.minus(&under).above(room))
        };
        let steps = steps
            .overlap(edge(rise, lean(ends[0], false)))
            .overlap(edge(lean(ends[1], true), rise));
        let room = Wide::from_bits(LARGEST) - row.middle.middle;
        let near = Affine { middle: room, step: -row.middle.step };
        steps.overlap(Steps::not_below(near)).columns(columns)
    }

    /// The parameter of an inverse depth.
    #[inline(always)]
    fn parameter(&self, w: u32) -> S {
        let zeros = w.leading_zeros();
        let inverse = reciprocal(w << zeros);
        let depth = unsigned_product(self.zoom, inverse).cast_signed();
        let depth = shift_right(depth, i32::from(self.exponent) - zeros.cast_signed());
        S::from_wide(Wide::from_bits(depth) - self.distance)
    }

    /// Where a ray crosses a cap so high above the eye's rounded height. What that rounding took counts here:
    /// flush caps have the same parameter, from near as from afar.
    #[inline(never)]
    fn at_cap(&self, end: S, row: &Pixels<S>, x: i32) -> Option<S> {
        let speed = row.speed.at(x);
        let rise =
            Wide::from_bits((row.rise.at(x).to_bits() >> self.finer()) + i64::from(self.below));
        (speed != Wide::ZERO).then(|| S::quotient(end.wide() - rise, speed))
    }
}

impl<S: FixedPoint> Pixels<S> {
    /// How far the point of a ray with an inverse depth is above the low cap and below the high one: each
    /// times that depth.
    #[inline(always)]
    fn inside(&self, rise: i64, w: u32) -> [bool; 2] {
        let [low, high] = self.ends.map(|end| product(end.to_bits(), w.cast_signed()));
        [low <= rise, rise <= high]
    }
}

impl<S: FixedPoint> TangentRow<S> {
    /// Sets a ray's span to that of the cylinder, if there is one. Its end is left open: the inverse depth
    /// there takes its place.
    #[inline(always)]
    pub(super) fn set_span(
        &self,
        cylinder: &Cylinder<S>,
        view: &TangentView<S>,
        x: i32,
        span: &mut Span<S>,
    ) {
        let (Self::Outside(row), TangentView::Outside(view, _)) = (self, view) else {
            return self.set_near(cylinder, view, x, span);
        };
        let [a, b] = row.sides.map(|side| side.at(x).to_bits());
        let middle = row.middle.at(x).to_bits();
        // All are small numbers where all are positive. Else their upper bits say that they aren't.
        if a < 0 || b < 0 || !(0..LARGEST).contains(&middle) {
            return;
        }
        let [a, b, middle] = [a, b, middle].map(|x| (x >> (AFFINE_BITS - PIXEL_BITS)) as u32);
        let half = sqrt(unsigned_product(a, b));
        if half == 0 {
            return;
        }
        let (near, far) = (middle.wrapping_add(half), middle.wrapping_sub(half));
        let rise = row.rise.at(x).to_bits();
        let enter = match row.inside(rise, near) {
            [true, true] => Crossing { t: view.parameter(near), face: WALL },
            [above, _] => {
                let [low, high] = row.inside(rise, far);
                let (reaches, end, face) =
                    if above { (high, row.ends[1], Face(1)) } else { (low, row.ends[0], Face(0)) };
                match view.at_cap(end, row, x).filter(|_| reaches) {
                    Some(t) => Crossing { t, face },
                    None => return,
                }
            }
        };
        *span = Span { enter, exit: Crossing { t: S::from_bits(far.cast_signed()), face: OPEN } };
    }

    #[inline(never)]
    fn set_near(&self, cylinder: &Cylinder<S>, view: &TangentView<S>, x: i32, span: &mut Span<S>) {
        if let (Self::Near(row), TangentView::Near(view, eye_within)) = (self, view) {
            view.chords(row).set_span(cylinder, *eye_within, x, span);
        }
    }

    /// Sets the end of a span that was left open.
    pub(super) fn close(&self, view: &TangentView<S>, x: i32, span: &mut Span<S>) {
        let (Self::Outside(row), TangentView::Outside(view, _)) = (self, view) else { return };
        if span.exit.face != OPEN {
            return;
        }
        let far = span.exit.t.to_bits().cast_unsigned();
        let (t, face) = match row.inside(row.rise.at(x).to_bits(), far) {
            [true, true] => (Some(view.parameter(far)), WALL),
            [false, _] => (view.at_cap(row.ends[0], row, x), Face(0)),
            [true, false] => (view.at_cap(row.ends[1], row, x), Face(1)),
        };
        // A span keeps the length of a unit.
        let least = span.enter.t.plus(S::from_bits(1));
        span.exit = Crossing { t: t.map_or(least, |t| t.max(least)), face };
    }
}
