//! An enum of the solids that programs are made of.

/// Makes an enum of solids: what the parts of a [`Program`](crate::program::Program) can be. What it
/// doesn't name isn't linked.
///
/// The enum is a solid itself, and is seen along all rays that all of its solids are seen along. Its
/// parameter is the number type.
///
/// Each part takes as much memory as the largest of these solids, and so do its view and its row. So a
/// [`Polyhedron`](crate::solid::Polyhedron) is named with the number of faces that most need. The faces of those
/// with more lie in the program's pool: name [`Pooled`](crate::solid::Pooled) for them.
///
/// Where all of the solids have a form as bytes ([`Coded`](crate::program::Coded)), the enum has one, too.
///
/// ```
/// use scancsg::geom::vec3;
/// use scancsg::solid::{Cylinder, Difference, Sphere};
///
/// scancsg::leaves! {
///     /// Balls and tubes.
///     pub enum Part<S> {
///         Ball(Sphere<S>),
///         /// A typed tree is a leaf as well.
///         Tube(Difference<Cylinder<S>, Cylinder<S>>),
///     }
/// }
///
/// let ball = Part::Ball(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?);
/// # let _ = ball;
/// # Ok::<(), scancsg::solid::SphereError>(())
/// ```
#[macro_export]
macro_rules! leaves {
    (
        $(#[$about:meta])*
        $visible:vis enum $Leaves:ident<$S:ident> {
            $($(#[$of:meta])* $Kind:ident($Solid:ty)),+ $(,)?
        }
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        $visible enum $Leaves<$S: $crate::scalar::Scalar> {
            $($(#[$of])* #[allow(missing_docs)] $Kind($Solid),)+
        }

        const _: () = {
            // All is named in full: leaves and solids may have any names.
            use $crate::scan::Scan as _;
            use $crate::solid::{Shape as _, Solid as _};

            const fn most(counts: &[usize]) -> usize {
                let (mut most, mut rest) = (0, counts);
                while let [count, others @ ..] = rest {
                    if *count > most {
                        most = *count;
                    }
                    rest = others;
                }
                most
            }

            impl<$S: $crate::scalar::Scalar> $crate::solid::Shape for $Leaves<$S> {
                type Scalar = $S;
                const SPANS: usize = most(&[$(<$Solid as $crate::solid::Shape>::SPANS),+]);
                const STACK: usize = most(&[$(<$Solid as $crate::solid::Shape>::STACK),+]);
                const FACES: u16 =
                    most(&[$(<$Solid as $crate::solid::Shape>::FACES as usize),+]) as u16;
            }

            impl<$S: $crate::scalar::Scalar> $crate::solid::Solid for $Leaves<$S> {
                fn spans(
                    &self,
                    line: &$crate::geom::Line<$S>,
                    first: $crate::span::Face,
                    stack: &mut $crate::span::SpanStack<'_, $S>,
                ) {
                    match self {
                        $(Self::$Kind(solid) => solid.spans(line, first, stack),)+
                    }
                }

                fn normal(
                    &self,
                    face: $crate::span::Face,
                    at: $crate::geom::Vec3<$S>,
                ) -> $crate::geom::Vec3<$S> {
                    match self {
                        $(Self::$Kind(solid) => solid.normal(face, at),)+
                    }
                }

                fn bounds(&self) -> $crate::solid::Bounds<$S> {
                    match self {
                        $(Self::$Kind(solid) => solid.bounds(),)+
                    }
                }

                fn onto(
                    &self,
                    face: $crate::span::Face,
                    near: $crate::geom::Vec3<$S>,
                ) -> $crate::geom::Vec3<$S> {
                    match self {
                        $(Self::$Kind(solid) => solid.onto(face, near),)+
                    }
                }

                #[inline]
                fn cosine(
                    &self,
                    face: $crate::span::Face,
                    at: impl FnOnce() -> $crate::geom::Vec3<$S>,
                    to: $crate::geom::Vec3<$S>,
                ) -> $S {
                    match self {
                        $(Self::$Kind(solid) => solid.cosine(face, at, to),)+
                    }
                }

                fn color(&self, face: $crate::span::Face) -> Option<$crate::solid::Rgb> {
                    match self {
                        $(Self::$Kind(solid) => solid.color(face),)+
                    }
                }

                #[inline]
                fn pooled(&self) -> Option<[$crate::geom::Vec3<$S>; 2]> {
                    match self {
                        $(Self::$Kind(solid) => solid.pooled(),)+
                    }
                }
            }

            /// Where all of them have a form as bytes. The lifetime keeps solids without a parameter from
            /// being looked at here.
            impl<$S: $crate::scalar::Scalar> $crate::program::Coded for $Leaves<$S>
            where
                $(for<'any> $Solid: $crate::program::Coded,)+
            {
                fn has_kind(kind: u8) -> bool {
                    [$(<$Solid as $crate::program::Coded>::has_kind(kind)),+].contains(&true)
                }

                fn kind(&self) -> u8 {
                    match self {
                        $(Self::$Kind(solid) => $crate::program::Coded::kind(solid),)+
                    }
                }

                fn write(
                    &self,
                    to: &mut $crate::program::Writer<'_>,
                ) -> Result<(), $crate::program::BytesError> {
                    match self {
                        $(Self::$Kind(solid) => $crate::program::Coded::write(solid, to),)+
                    }
                }

                fn read(
                    kind: u8,
                    from: &mut $crate::program::Reader<'_>,
                ) -> Result<Self, $crate::program::BytesError> {
                    // Several may have the kind of scaled solids: they differ inside.
                    let start = *from;
                    $(if <$Solid as $crate::program::Coded>::has_kind(kind) {
                        match $crate::program::Coded::read(kind, from) {
                            Err($crate::program::BytesError::Kind) => *from = start,
                            solid => return solid.map(Self::$Kind),
                        }
                    })+
                    Err($crate::program::BytesError::Kind)
                }
            }

            /// A stage of one of the solids.
            #[derive(Debug, Clone, Copy)]
            pub enum LeafStage<$($Kind),+> {
                Unset,
                $($Kind($Kind),)+
            }

            impl<$($Kind),+> $crate::scan::Empty for LeafStage<$($Kind),+> {
                const EMPTY: Self = Self::Unset;
            }

            impl<$S, AllRays> $crate::scan::Scan<AllRays> for $Leaves<$S>
            where
                $S: $crate::scalar::Scalar,
                $($Solid: $crate::scan::Scan<AllRays, Scalar = $S>,)+
            {
                type View = LeafStage<$(<$Solid as $crate::scan::Scan<AllRays>>::View),+>;
                type Row = LeafStage<$(<$Solid as $crate::scan::Scan<AllRays>>::Row),+>;

                fn view(&self, rays: &AllRays, view: &mut Self::View) {
                    match self {
                        $(Self::$Kind(solid) => {
                            if !matches!(view, LeafStage::$Kind(_)) {
                                *view = LeafStage::$Kind($crate::scan::Empty::EMPTY);
                            }
                            if let LeafStage::$Kind(view) = view {
                                solid.view(rays, view);
                            }
                        })+
                    }
                }

                fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
                    match (self, view) {
                        $((Self::$Kind(solid), LeafStage::$Kind(view)) => {
                            solid.is_in_rows(view, rows)
                        })+
                        _ => false,
                    }
                }

                fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
                    match (self, view) {
                        $((Self::$Kind(solid), LeafStage::$Kind(view)) => {
                            if !matches!(row, LeafStage::$Kind(_)) {
                                *row = LeafStage::$Kind($crate::scan::Empty::EMPTY);
                            }
                            if let LeafStage::$Kind(row) = row {
                                solid.row(view, y, columns, row);
                            }
                        })+
                        _ => *row = LeafStage::Unset,
                    }
                }

                fn enter(row: &mut Self::Row, column: u32) -> $crate::scan::ColumnRun {
                    match row {
                        $(LeafStage::$Kind(row) => {
                            <$Solid as $crate::scan::Scan<AllRays>>::enter(row, column)
                        })+
                        LeafStage::Unset => $crate::scan::ColumnRun::EMPTY,
                    }
                }

                #[inline(always)]
                fn contains<OnePath: $crate::span::walk::Path>(
                    &self,
                    view: &Self::View,
                    row: &mut Self::Row,
                    x: i32,
                    t: $S,
                ) -> bool {
                    match (self, view, row) {
                        $((Self::$Kind(solid), LeafStage::$Kind(view), LeafStage::$Kind(row)) => {
                            solid.contains::<OnePath>(view, row, x, t)
                        })+
                        _ => false,
                    }
                }

                #[inline(always)]
                fn step<OnePath: $crate::span::walk::Path>(
                    &self,
                    view: &Self::View,
                    row: &mut Self::Row,
                    x: i32,
                    t: $S,
                    first: $crate::span::Face,
                ) -> $crate::span::walk::Step<$S> {
                    match (self, view, row) {
                        $((Self::$Kind(solid), LeafStage::$Kind(view), LeafStage::$Kind(row)) => {
                            solid.step::<OnePath>(view, row, x, t, first)
                        })+
                        _ => $crate::span::walk::Step::OUTSIDE,
                    }
                }

                fn view_faces(
                    &self,
                    rays: &AllRays,
                    faces: &[$crate::solid::HalfSpace<$S>],
                    views: &mut [$crate::scan::FaceView<$S>],
                    range: [u16; 2],
                    view: &mut Self::View,
                ) {
                    match (self, view) {
                        $((Self::$Kind(solid), LeafStage::$Kind(view)) => {
                            solid.view_faces(rays, faces, views, range, view);
                        })+
                        _ => {}
                    }
                }

                fn row_faces(
                    &self,
                    view: &Self::View,
                    pool: $crate::scan::PoolRow<'_, $S>,
                    y: i32,
                    columns: u32,
                    row: &mut Self::Row,
                ) {
                    match (self, view) {
                        $((Self::$Kind(solid), LeafStage::$Kind(view)) => {
                            if !matches!(row, LeafStage::$Kind(_)) {
                                *row = LeafStage::$Kind($crate::scan::Empty::EMPTY);
                            }
                            if let LeafStage::$Kind(row) = row {
                                solid.row_faces(view, pool, y, columns, row);
                            }
                        })+
                        _ => {}
                    }
                }

                #[inline(always)]
                fn ray_faces(
                    &self,
                    view: &Self::View,
                    pool: $crate::scan::PoolRow<'_, $S>,
                    x: i32,
                    row: &mut Self::Row,
                ) {
                    match (self, view, row) {
                        $((Self::$Kind(solid), LeafStage::$Kind(view), LeafStage::$Kind(row)) => {
                            solid.ray_faces(view, pool, x, row);
                        })+
                        _ => {}
                    }
                }
            }
        };
    };
}
