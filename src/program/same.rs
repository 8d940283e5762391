//! When two programs are the same.

use super::build::Program;
use crate::span::Shape;

/// They have the same parts in the same places, with the same operators, poses and faces. Memory that they have
/// room in, but don't use, doesn't count.
impl<L: Shape, const PARTS: usize, const POSES: usize, const SPANS: usize, const POOL: usize>
    PartialEq for Program<L, PARTS, POSES, SPANS, POOL>
where
    L: PartialEq,
{
    fn eq(&self, other: &Self) -> bool {
        let color = |program: &Self, part| program.in_place(part).and_then(|(part, _)| part.color);
        self.leaves() == other.leaves()
            && self.tree().postfix().eq(other.tree().postfix())
            && self.poses() == other.poses()
            && (0..self.part_count()).all(|part| {
                color(self, part) == color(other, part)
                    && self.pose_of(part) == other.pose_of(part)
                    && self.pool.of(part) == other.pool.of(part)
            })
    }
}
