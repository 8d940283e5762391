//! What can be wrong with splines.

crate::error_text! {
    /// Why knots can't be made, or why a knot can't be inserted into a curve.
    pub enum KnotError {
        /// There are not even order + 1 knots, so that no basis function has its knots; or a uniform
        /// or periodic sequence has too few spans for its order.
        TooFew => "too few knots for the order",
        /// There are more knots, or more control points, than the type can hold.
        TooMany => "more knots or control points than there is room for",
        /// A knot is smaller than the one before it; or the ends of a domain are not in ascending
        /// order.
        Decreasing => "the knots are not in ascending order",
        /// A knot is infinite or NaN.
        NotFinite => "a knot is infinite or not a number",
        /// A knot is, or would be, there more often than the order, so that a basis function vanishes
        /// everywhere. Knots nearer to each other than numbers of their size may be rounded to the same
        /// one: in `f32` there is a number every 1.2·10⁻⁴ at 1,163.
        Multiplicity => "more knots than the order of the spline are equal, perhaps because their number \
            type rounds them to the same number",
        /// A knot is outside of the curve's domain.
        Outside => "the knot is outside of the domain",
        /// A knot, or the distance of the first from the last one, is out of the number type's range.
        TooFar => "the knots are farther apart than their number type allows",
    }
}

crate::error_text! {
    /// Why a curve can't be made.
    pub enum CurveError {
        /// The number of control points is not the number of knots less the order.
        PointCount => "the number of control points is not the number of knots less the order",
        /// A coordinate of a control point is infinite or NaN.
        NotFinite => "a coordinate of a control point is infinite or not a number",
        /// A coordinate of a control point is larger than [`Scalar::MAX_COORDINATE`](crate::scalar::Scalar::MAX_COORDINATE)
        /// in floating point; or, for a baked curve in fixed point, a span goes so far that less than
        /// four guard bits are left.
        TooFar => "a control point is too far away for its number type",
        /// The domain has no length: there are fewer control points than the order, or all knots from
        /// one end of it to the other coincide.
        Empty => "the domain of the curve has no length",
        /// The number of spans is not the one that a baked curve has room for.
        SpanCount => "the number of spans is not that of the type",
    }
}

crate::error_text! {
    /// Why a curve has no value.
    pub enum EvaluateError {
        /// The parameter is infinite or NaN.
        NotFinite => "the parameter is infinite or not a number",
        /// The parameter is outside of the domain.
        Outside => "the parameter is outside of the domain",
        /// The result, or a number on the way to it, is too large for its type.
        Overflow => "the result is too large for its number type",
        /// The curve stands still, so that it has no tangent.
        Stationary => "the curve stands still there and has no tangent",
    }
}

crate::error_text! {
    /// Why a curve can't be flattened.
    pub enum FlattenError {
        /// The tolerance is zero, negative, infinite or NaN.
        Tolerance => "the tolerance is not a positive number",
    }
}

crate::error_text! {
    /// Why a sweep can't be made.
    pub enum SweepError {
        /// There are fewer control points than the order.
        TooFew => "there are fewer control points than the order",
        /// There are fewer ticks to a span than the degree, or so many that the common divisor of its basis
        /// functions exceeds 2³¹: (k−1)!·ticks^(k−1) for uniform knots and the order k.
        Ticks => "too few or too many ticks to a span for the order",
        /// The step is not positive, or two knots are not an integer number of steps apart.
        Step => "the knots are not whole steps apart",
    }
}
