//! Unions of solids of one kind, written once for arrays and for [`Many`].

use super::many::Many;
use crate::geom::{Line, Vec3};
use crate::scalar::Number;
use crate::scan::{Active, ColumnRun, GroupRow, Member, Scan, view_each};
use crate::solid::{Rgb, Solid};
use crate::span::walk::{Path, Step};
use crate::span::{Face, Operation, Shape, SpanStack};

const fn faces_of_group(count: usize, faces: u16) -> u16 {
    assert!(count > 0, "a group of solids needs at least one");
    assert!(count * (faces as usize) < u16::MAX as usize, "the group has too many faces");
    count as u16 * faces
}

const fn stack_of_group(count: usize, spans: usize, stack: usize) -> usize {
    // Before the last element: the union of all others. Then the element's own work, or the
    // element's spans and the merged list.
    let merging = if count > 1 { spans + count * spans } else { spans };
    let others = count.saturating_sub(1) * spans;
    others + if stack > merging { stack } else { merging }
}

/// The element that a face belongs to, and the face within that element.
fn element<T: Shape>(group: &[T], face: Face) -> Option<(&T, Face)> {
    let index = face.0.checked_div(T::FACES)?;
    Some((group.get(usize::from(index))?, Face(face.0 % T::FACES)))
}

/// Pushes the union of the elements' spans.
fn spans<T: Solid>(
    group: &[T],
    line: &Line<T::Scalar>,
    mut first: Face,
    stack: &mut SpanStack<'_, T::Scalar>,
) {
    let left = stack.len();
    for solid in group {
        let right = stack.len();
        solid.spans(line, first, stack);
        stack.merge(Operation::UNION, left, right);
        first = first.offset(T::FACES);
    }
}

/// A group is a solid of the elements in its slice.
macro_rules! group {
    ($Group:ty) => {
        impl<T: Shape, const N: usize> Shape for $Group {
            type Scalar = T::Scalar;
            const SPANS: usize = {
                assert!(Self::FACES > 0);
                N * T::SPANS
            };
            const STACK: usize = stack_of_group(N, T::SPANS, T::STACK);
            const FACES: u16 = faces_of_group(N, T::FACES);
        }

        impl<T: Solid, const N: usize> Solid for $Group {
            fn spans(
                &self,
                line: &Line<T::Scalar>,
                first: Face,
                stack: &mut SpanStack<'_, T::Scalar>,
            ) {
                spans(self.as_slice(), line, first, stack);
            }

            fn onto(&self, face: Face, near: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
                element(self.as_slice(), face).map_or(near, |(solid, face)| solid.onto(face, near))
            }

            fn normal(&self, face: Face, at: Vec3<Self::Scalar>) -> Vec3<Self::Scalar> {
                let element = element(self.as_slice(), face);
                element.map_or(Vec3::ZERO, |(solid, face)| solid.normal(face, at))
            }

            #[inline]
            fn cosine(
                &self,
                face: Face,
                at: impl FnOnce() -> Vec3<T::Scalar>,
                to: Vec3<T::Scalar>,
            ) -> T::Scalar {
                let element = element(self.as_slice(), face);
                element.map_or(T::Scalar::ZERO, |(solid, face)| solid.cosine(face, at, to))
            }

            fn color(&self, face: Face) -> Option<Rgb> {
                element(self.as_slice(), face).and_then(|(solid, face)| solid.color(face))
            }
        }

        impl<P, T: Scan<P>, const N: usize> Scan<P> for $Group {
            type View = [T::View; N];
            type Row = GroupRow<[Member<T::Row>; N]>;

            fn view(&self, rays: &P, view: &mut Self::View) {
                view_each(self.as_slice(), rays, view);
            }

            fn is_in_rows(&self, view: &Self::View, rows: [i32; 2]) -> bool {
                any_in_rows(self.as_slice(), view, rows)
            }

            fn row(&self, view: &Self::View, y: i32, columns: u32, row: &mut Self::Row) {
                row.as_slice_mut().set::<P, T>(self.as_slice(), view, y, columns);
            }

            fn enter(row: &mut Self::Row, column: u32) -> ColumnRun {
                row.as_slice_mut().enter::<P, T>(column)
            }

            #[inline]
            fn contains<H: Path>(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: T::Scalar,
            ) -> bool {
                let (group, solids) = (row.as_slice_mut(), self.as_slice());
                Active::<P, T> { group, solids, views: view, x, first: Face(0) }.contains::<H>(t)
            }

            #[inline]
            fn step<H: Path>(
                &self,
                view: &Self::View,
                row: &mut Self::Row,
                x: i32,
                t: T::Scalar,
                first: Face,
            ) -> Step<T::Scalar> {
                let (group, solids) = (row.as_slice_mut(), self.as_slice());
                Active::<P, T> { group, solids, views: view, x, first }.step::<H>(t)
            }
        }
    };
}

group!([T; N]);
group!(Many<T, N>);

/// Whether any element may be seen in these rows.
#[inline(never)]
fn any_in_rows<P, T: Scan<P>>(solids: &[T], views: &[T::View], rows: [i32; 2]) -> bool {
    solids.iter().zip(views).any(|(solid, view)| solid.is_in_rows(view, rows))
}
