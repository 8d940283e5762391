//! Coordinates of faces that differ by no more than six digits allow are made equal.

use super::{Body, Placed};
use crate::map::SIX_DIGITS;
use crate::tree::Tree;

/// Makes equal what was meant to be.
pub(super) fn merge(tree: &mut Tree<Placed>, frames: usize) {
    for frame in 0..frames {
        for axis in 0..3 {
            let mut found = Vec::new();
            tree.change_each(&mut |solid| {
                if solid.frame == frame {
                    found.extend(
                        faces(&mut solid.body, axis).into_iter().map(|ends| ends.map(|end| *end)),
                    );
                }
            });
            let merged = Merged::of(found.into_iter().flatten().collect());
            tree.change_each(&mut |solid| {
                if solid.frame == frame
                    && let Some([low, high]) = faces(&mut solid.body, axis)
                {
                    let ends = [merged.get(*low), merged.get(*high)];
                    if ends[0] < ends[1] {
                        [*low, *high] = ends;
                    }
                }
            });
        }
    }
}

/// The faces of a solid across an axis of its frame.
fn faces(body: &mut Body, across: usize) -> Option<[&mut f64; 2]> {
    match body {
        Body::Cuboid([low, high]) => Some(match across {
            0 => [&mut low.x, &mut high.x],
            1 => [&mut low.y, &mut high.y],
            _ => [&mut low.z, &mut high.z],
        }),
        Body::Cylinder { axis, ends: [low, high], .. }
        | Body::Cone { axis, ends: [low, high], .. }
            if *axis == across =>
        {
            Some([low, high])
        }
        _ => None,
    }
}

/// Sorted numbers, each with the one that stands for it.
struct Merged {
    numbers: Vec<[f64; 2]>,
}

impl Merged {
    fn of(mut numbers: Vec<f64>) -> Self {
        numbers.sort_by(f64::total_cmp);
        let size = numbers.iter().fold(0.0f64, |size, number| size.max(number.abs()));
        let mut merged = Vec::new();
        let mut rest = &numbers[..];
        while let Some(first) = rest.first() {
            // A number that is the sum of larger ones has their digits: so the least is not of its own size alone.
            let room = SIX_DIGITS * first.abs().max(size / 16.0);
            let count = rest.partition_point(|number| number - first <= room);
            let (group, later) = rest.split_at(count);
            let times = |number: f64| group.iter().filter(|other| **other == number).count();
            let most = group.iter().copied().max_by_key(|number| times(*number)).unwrap_or(*first);
            merged.extend(group.iter().map(|number| [*number, most]));
            rest = later;
        }
        merged.dedup();
        Self { numbers: merged }
    }

    fn get(&self, number: f64) -> f64 {
        let found = self.numbers.binary_search_by(|pair| pair[0].total_cmp(&number));
        found.ok().and_then(|index| self.numbers.get(index)).map_or(number, |pair| pair[1])
    }
}

#[cfg(test)]
mod tests {
    use super::Merged;

    #[test]
    fn what_six_digits_can_tell_apart_stays_apart() {
        let merged = Merged::of(vec![10.0, 10.000_01, 10.0, 10.001, -3.0, 0.0, 1e-17, 1e-3]);
        let got = [10.000_01, 10.001, -3.0, 1e-3].map(|number| merged.get(number));
        assert_eq!(got, [10.0, 10.001, -3.0, 1e-3]);
        assert_eq!(merged.get(0.0), merged.get(1e-17));
    }
}
