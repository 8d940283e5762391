//! What can be wrong with splines.

/// Why knots can't be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum KnotError {
    /// There are not even order + 1 knots, so that no basis function has its knots; or a uniform
    /// or periodic sequence has too few spans for its order.
    TooFew,
    /// There are more knots than the type can hold.
    TooMany,
    /// A knot is smaller than the one before it; or the ends of a domain are not in ascending
    /// order.
    Decreasing,
    /// A knot is infinite or NaN.
    NotFinite,
    /// A knot is there more often than the order, so that a basis function vanishes everywhere. Knots
    /// nearer to each other than numbers of their size may be rounded to the same one: in `f32` there is a
    /// number every 1.2·10⁻⁴ at 1,163.
    Multiplicity,
    /// A knot, or the distance of the first from the last one, is out of the number type's range.
    TooFar,
}

crate::error_text!(KnotError {
    TooFew => "too few knots for the order",
    TooMany => "more knots than there is room for",
    Decreasing => "the knots are not in ascending order",
    NotFinite => "a knot is infinite or not a number",
    Multiplicity => "more knots than the order of the spline are equal, perhaps because their number type \
        rounds them to the same number",
    TooFar => "the knots are farther apart than their number type allows",
});

/// Why a curve can't be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CurveError {
    /// The number of control points is not the number of knots less the order.
    PointCount,
    /// A coordinate of a control point is infinite or NaN.
    NotFinite,
    /// A coordinate of a control point is larger than [`Scalar::MAX_COORDINATE`](crate::scalar::Scalar::MAX_COORDINATE)
    /// in floating point; or, for a baked curve in fixed point, a span goes so far that less than
    /// four guard bits are left.
    TooFar,
    /// The domain has no length: there are fewer control points than the order, or all knots from
    /// one end of it to the other coincide.
    Empty,
    /// The number of spans is not the one that a baked curve has room for.
    SpanCount,
}

crate::error_text!(CurveError {
    PointCount => "the number of control points is not the number of knots less the order",
    NotFinite => "a coordinate of a control point is infinite or not a number",
    TooFar => "a control point is too far away for its number type",
    Empty => "the domain of the curve has no length",
    SpanCount => "the number of spans is not that of the type",
});

/// Why a curve has no value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EvaluateError {
    /// The parameter is infinite or NaN.
    NotFinite,
    /// The parameter is outside of the domain.
    Outside,
    /// The result, or a number on the way to it, is too large for its type.
    Overflow,
    /// The curve stands still, so that it has no tangent.
    Stationary,
}

crate::error_text!(EvaluateError {
    NotFinite => "the parameter is infinite or not a number",
    Outside => "the parameter is outside of the domain",
    Overflow => "the result is too large for its number type",
    Stationary => "the curve stands still there and has no tangent",
});

/// Why a knot can't be inserted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InsertError {
    /// The knot is infinite or NaN.
    NotFinite,
    /// The knot is outside of the domain.
    Outside,
    /// The knot is there as often as the order already, perhaps because it was rounded to another one.
    Multiplicity,
    /// There is no room for another knot, or for another control point.
    Full,
}

crate::error_text!(InsertError {
    NotFinite => "the knot is infinite or not a number",
    Outside => "the knot is outside of the domain",
    Multiplicity => "the knot is there as often as the order already, perhaps because its number type \
        rounds it to another one",
    Full => "there is no room for another knot and control point",
});

/// Why a curve can't be flattened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FlattenError {
    /// The tolerance is zero, negative, infinite or NaN.
    Tolerance,
}

crate::error_text!(FlattenError {
    Tolerance => "the tolerance is not a positive number",
});

/// Why a sweep can't be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SweepError {
    /// There are fewer control points than the order.
    TooFew,
    /// There are fewer ticks to a span than the degree, or so many that the common divisor of its basis
    /// functions exceeds 2³¹: (k−1)!·ticks^(k−1) for uniform knots and the order k.
    Ticks,
    /// The step is not positive, or two knots are not an integer number of steps apart.
    Step,
}

crate::error_text!(SweepError {
    TooFew => "there are fewer control points than the order",
    Ticks => "too few or too many ticks to a span for the order",
    Step => "the knots are not whole steps apart",
});
