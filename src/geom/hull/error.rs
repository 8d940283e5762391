//! What can be wrong with polyhedra.

crate::error_text! {
    /// Why a polyhedron can't be made.
    pub enum PolyhedronError {
        /// A coordinate is infinite or NaN.
        NotFinite => "a coordinate of the polyhedron is infinite or not a number",
        /// There are more faces than the type has room for.
        TooManyFaces => "the polyhedron has more faces than its type has room for",
        /// The faces have nothing in common, or nothing that has a volume.
        Empty => "the faces of the polyhedron have no volume in common",
        /// The faces don't close: a line can leave between them without end.
        Unbounded => "the faces of the polyhedron don't close",
        /// The polygon or the corners aren't those of a convex solid, a face isn't flat, or corners coincide.
        NotConvex => "the corners of the polyhedron coincide, or aren't those of a convex solid",
        /// A coordinate is larger than [`Scalar::MAX_COORDINATE`](crate::scalar::Scalar::MAX_COORDINATE).
        TooFar => "the polyhedron is too far away for its number type",
    }
}
