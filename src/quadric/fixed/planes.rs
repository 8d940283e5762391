//! Where a line crosses planes: two parallel ones, those of a box, and those of half-spaces.

use super::lines::{bits, dot, is_in_range, unit_bits};
use crate::geom::{Axis, Direction, Line};
use crate::quadric::{Corners, HalfSpace, PlaneRoots, Planes};
use crate::scalar::{FixedPoint, integer};
use crate::span::{Crossing, Face, Span};

/// Where a line crosses parallel planes: at `heights / speed`, in integers.
pub(super) struct Crossings<const N: usize = 2> {
    pub(super) heights: [i64; N],
    pub(super) speed: i64,
}

impl<const N: usize> Crossings<N> {
    fn of<S: FixedPoint>(normal: &Direction<S>, offsets: [S; N], line: &Line<S>) -> Self {
        let vector = unit_bits::<S>(normal.vector());
        let at_zero = dot(vector, bits(line.origin));
        let heights = offsets.map(|offset| (i64::from(offset.to_bits()) << 28) - at_zero);
        let speed = dot(vector, bits(line.direction));
        match normal.along() {
            // All are multiples of 2^28, and short numbers are divided faster.
            Some(_) => Self { heights: heights.map(|height| height >> 28), speed: speed >> 28 },
            None => Self { heights, speed },
        }
    }
}

impl Crossings {
    pub(super) fn new<S: FixedPoint>(planes: &Planes<S>, line: &Line<S>) -> Self {
        Self::of(&planes.normal, [planes.low, planes.high], line)
    }

    /// The parameters of the low plane and of the high one, each rounded.
    pub(super) fn rounded<S: FixedPoint>(&self) -> [S; 2] {
        self.heights.map(|height| Fraction { numerator: height, denominator: self.speed }.rounded())
    }

    /// The fractions at which the line crosses the planes, in ascending order: their numerators, and
    /// their denominator, which is positive.
    pub(super) fn fractions(&self) -> [i128; 3] {
        let [low, high] = self.heights;
        let [first, last] = if self.speed > 0 { [low, high] } else { [-high, -low] };
        [first, last, self.speed.abs()].map(i128::from)
    }

    /// Whether a line along the planes is between them.
    pub(super) fn is_between<S: FixedPoint>(&self, planes: &Planes<S>) -> bool {
        let [low, high] = self.heights;
        planes.has_between(low, high, 0)
    }

    /// Whether a line along the planes is between them or on one.
    pub(super) fn touches(&self) -> bool {
        let [low, high] = self.heights;
        low <= 0 && 0 <= high
    }
}

pub(in crate::quadric) fn planes<S: FixedPoint>(
    planes: &Planes<S>,
    line: &Line<S>,
) -> PlaneRoots<S> {
    if !is_in_range(line) {
        return PlaneRoots::along(false);
    }
    let crossings = Crossings::new(planes, line);
    if crossings.speed == 0 {
        return PlaneRoots::along(crossings.is_between(planes));
    }
    let (upwards, [low, high]) = (crossings.speed > 0, crossings.rounded::<S>());
    let (first, last) = if upwards { (low, high) } else { (high, low) };
    // The planes are apart, however fast the line passes them: but not beyond the grid.
    let is_beyond = first == S::HIGHEST || first == S::LOWEST;
    let last = if first == last && !is_beyond { next(last) } else { last };
    PlaneRoots::across(if upwards { [first, last] } else { [last, first] }, upwards)
}

/// The next larger number, or the largest.
pub(super) fn next<S: FixedPoint>(t: S) -> S {
    S::from_bits(t.to_bits().saturating_add(1))
}

/// Where a line crosses a plane, in integers.
#[derive(Clone, Copy)]
struct Fraction {
    numerator: i64,
    /// Not zero.
    denominator: i64,
}

impl Fraction {
    fn rounded<S: FixedPoint>(self) -> S {
        let numerator = i128::from(self.numerator) << S::BITS;
        let t = integer::divide(numerator, self.denominator.into());
        S::from_bits(t.clamp(i32::MIN.into(), i32::MAX.into()) as i32)
    }

    /// Whether it is below another one, exactly. Denominators below zero turn the order round.
    fn is_below(self, other: Self) -> bool {
        let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
        let left = product(self.numerator, other.denominator);
        let right = product(other.numerator, self.denominator);
        if (self.denominator < 0) == (other.denominator < 0) { left < right } else { right < left }
    }
}

/// The part of a line that several planes leave, with ends that aren't rounded yet: `None` is no end.
#[derive(Default)]
struct Common {
    enter: Option<(Fraction, Face)>,
    exit: Option<(Fraction, Face)>,
}

impl Common {
    /// Cuts off what is beyond a plane: what comes later if the line exits there.
    fn cut(&mut self, at: Fraction, face: Face, exits: bool) {
        if exits {
            if self.exit.is_none_or(|(exit, _)| at.is_below(exit)) {
                self.exit = Some((at, face));
            }
        } else if self.enter.is_none_or(|(enter, _)| enter.is_below(at)) {
            self.enter = Some((at, face));
        }
    }

    /// What is left, with its ends rounded: of some length, however short it is.
    fn span<S: FixedPoint>(self) -> Option<Span<S>> {
        if let (Some((enter, _)), Some((exit, _))) = (self.enter, self.exit)
            && !enter.is_below(exit)
        {
            return None;
        }
        let crossing = |end: Option<(Fraction, Face)>, never| match end {
            Some((at, face)) => Crossing { t: at.rounded(), face },
            None => Crossing { t: never, face: Face(0) },
        };
        let enter: Crossing<S> = crossing(self.enter, S::LOWEST);
        let exit = crossing(self.exit, S::HIGHEST);
        let is_beyond = enter.t == S::HIGHEST || exit.t == S::LOWEST;
        let t = if enter.t == exit.t && !is_beyond { next(exit.t) } else { exit.t };
        Span::new(enter, Crossing { t, ..exit })
    }
}

/// The part of a line inside a box.
pub(in crate::quadric) fn cuboid<S: FixedPoint>(
    cuboid: &Corners<S>,
    line: &Line<S>,
) -> Option<Span<S>> {
    if !is_in_range(line) {
        return None;
    }
    let mut common = Common::default();
    for axis in Axis::ALL {
        let planes = cuboid.planes(axis);
        let crossings = Crossings::new(&planes, line);
        if crossings.speed == 0 {
            if !crossings.is_between(&planes) {
                return None;
            }
            continue;
        }
        let Crossings { heights, speed } = crossings;
        let first = Corners::<S>::first_face(axis);
        for (numerator, is_high) in heights.into_iter().zip([false, true]) {
            let at = Fraction { numerator, denominator: speed };
            common.cut(at, first.offset(u16::from(is_high)), is_high == (speed > 0));
        }
    }
    common.span()
}

/// The part of a line inside all half-spaces.
pub(in crate::quadric) fn half_spaces<S: FixedPoint>(
    faces: &[HalfSpace<S>],
    line: &Line<S>,
) -> Option<Span<S>> {
    if !is_in_range(line) {
        return None;
    }
    let mut common = Common::default();
    for (face, index) in faces.iter().zip(0..) {
        let Crossings { heights: [numerator], speed } =
            Crossings::of(&face.normal, [face.offset], line);
        if speed == 0 {
            if !face.has_below(numerator, 0) {
                return None;
            }
            continue;
        }
        common.cut(Fraction { numerator, denominator: speed }, Face(index), speed > 0);
    }
    common.span()
}
