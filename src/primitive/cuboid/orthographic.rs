//! The box along parallel rays.
//!
//! Each pair of faces is crossed at parameters that are affine in the column. So is the distance of any
//! two faces of different pairs along the ray, which gives the exact silhouette.

use super::Cuboid;
use crate::geom::{Axis, Extent, OrthographicRays};
use crate::quadric::Corners;
use crate::query::Solid;
use crate::scalar::{Number, Scalar};
use crate::scan::bounds::{Outline, Rows, Steps};
use crate::scan::planes::{EdgeOn, Ends, OrthographicRow as PairRow, OrthographicView as PairView};
use crate::scan::{Empty, Leaf};
use crate::span::{Crossing, Face, Span};

impl<S: Scalar> Leaf<OrthographicRays<S>> for Cuboid<S> {
    type View = OrthographicView<S>;
    type Row = OrthographicRow<S>;
    type Spans = [Span<S>; 1];

    fn view(&self, rays: &OrthographicRays<S>) -> Self::View {
        let rows = rays.outline(&self.bounds()).map_or(Rows::ALL, |outline| outline.rows);
        let pairs = Axis::ALL.map(|axis| self.corners.planes(axis).orthographic_view(rays));
        let near = Axis::ALL.map(|axis| {
            let is_high = pairs[axis as usize].high_first();
            let first = Corners::<S>::first_face(axis).0 as u8;
            if is_high { first + 1 } else { first }
        });
        OrthographicView { pairs, near, rows }
    }

    #[inline]
    fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
        view.rows.meet(rows)
    }

    #[inline(never)]
    fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) -> Extent {
        let pairs = Axis::ALL.map(|axis| {
            let view = &view.pairs[axis as usize];
            self.corners.planes(axis).orthographic_row(view, y, columns)
        });
        let mut steps = Steps::ALL;
        for (index, axis) in Axis::ALL.into_iter().enumerate() {
            match &pairs[index] {
                PairRow::EdgeOn(row) => {
                    steps = steps.overlap(self.corners.planes(axis).edge_on_steps(row));
                }
                PairRow::Across(ends) => {
                    for (other, its_view) in pairs.iter().zip(&view.pairs).skip(index + 1) {
                        if let PairRow::Across(other) = other {
                            let view = &view.pairs[index];
                            steps =
                                steps.overlap(ends.common_steps(view, other, its_view, columns));
                        }
                    }
                }
                PairRow::Nowhere => {}
            }
        }
        *row = match pairs {
            [PairRow::Across(x), PairRow::Across(y), PairRow::Across(z)] => {
                OrthographicRow::Across([x, y, z])
            }
            pairs => OrthographicRow::EdgeOn {
                along: pairs.iter().zip(0..).fold(0, |along, (row, index)| {
                    along | u32::from(matches!(row, PairRow::EdgeOn(_))) << index
                }),
                ends: pairs.map(|row| match row {
                    PairRow::Across(ends) => ends,
                    PairRow::EdgeOn(EdgeOn { height, .. }) => Ends { near: height, far: height },
                    PairRow::Nowhere => Ends { near: S::Wide::ZERO, far: S::Wide::ZERO },
                }),
            },
        };
        steps.columns(columns)
    }

    #[inline(always)]
    fn spans(&self, view: &Self::View, row: &Self::Row, x: i32, [span]: &mut [Span<S>; 1]) {
        match row {
            OrthographicRow::Across(pairs) => {
                let [first, second, third] = pairs;
                let [one, two, three] = &view.pairs;
                let [of_x, of_y, of_z] = [first.at(one, x), second.at(two, x), third.at(three, x)];
                let later = |a: (S, Face), b: (S, Face)| if b.0 > a.0 { b } else { a };
                let earlier = |a: (S, Face), b: (S, Face)| if b.0 < a.0 { b } else { a };
                let [x, y, z] = view.near.map(|face| Face(face.into()));
                let enter = later(later((of_x[0], x), (of_y[0], y)), (of_z[0], z));
                let [x, y, z] = view.near.map(|face| Face(u16::from(face) ^ 1));
                let exit = earlier(earlier((of_x[1], x), (of_y[1], y)), (of_z[1], z));
                let is_met = enter.0 < exit.0;
                // Set before it is known: so the comparisons that find parameters find faces, too.
                span.enter = Crossing { t: enter.0, face: enter.1 };
                span.exit = Crossing { t: exit.0, face: exit.1 };
                if !is_met {
                    *span = Span::NOWHERE;
                }
            }
            OrthographicRow::EdgeOn { ends, along } => {
                *span = self.edge_on_span(view, ends, *along, x).unwrap_or(Span::NOWHERE);
            }
            OrthographicRow::Nowhere => *span = Span::NOWHERE,
        }
    }
}

impl<S: Scalar> Cuboid<S> {
    /// Of a ray along some of the faces, or almost.
    #[inline(never)]
    fn edge_on_span(
        &self,
        view: &OrthographicView<S>,
        ends: &[Ends<S>; 3],
        along: u32,
        x: i32,
    ) -> Option<Span<S>> {
        let pairs = [0, 1, 2].map(|index| match along >> index & 1 {
            1 => PairRow::EdgeOn(view.pairs[index].edge_on(ends[index].near)),
            _ => PairRow::Across(ends[index]),
        });
        let mut common = Span::whole_line(Face(0));
        for (index, axis) in Axis::ALL.into_iter().enumerate() {
            let (view, row) = (&view.pairs[index], &pairs[index]);
            let between = self.corners.planes(axis).orthographic_span(view, row, x);
            common = common.overlap(between?.with_faces_from(Corners::<S>::first_face(axis)))?;
        }
        Some(common)
    }
}

/// A box, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub struct OrthographicView<S: Scalar> {
    /// The faces across each axis, and the number of that which comes first.
    pairs: [PairView<S>; 3],
    near: [u8; 3],
    rows: Rows,
}

impl<S: Scalar> Empty for OrthographicView<S> {
    const EMPTY: Self = Self { pairs: [PairView::EMPTY; 3], near: [0; 3], rows: Rows::EMPTY };
}

/// A row of a box, seen along parallel rays.
#[derive(Debug, Clone, Copy)]
pub enum OrthographicRow<S: Scalar> {
    /// Not set yet.
    Nowhere,
    /// The rays cross all faces.
    Across([Ends<S>; 3]),
    /// The rays run along some of the faces, or almost.
    EdgeOn {
        /// Where the faces are crossed, or how high the rays are above them, twice.
        ends: [Ends<S>; 3],
        /// Bit i is set where the rays run along pair i. A whole word: so is what tells these rows apart, which
        /// enums of solids read for each pixel.
        along: u32,
    },
}

impl<S: Scalar> Empty for OrthographicRow<S> {
    const EMPTY: Self = Self::Nowhere;
}
