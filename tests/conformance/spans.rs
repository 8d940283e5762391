//! Span lists against a bitmap: one bit for every cell of a small grid of parameters.
//!
//! A set of cells is a set of half-open intervals, so boolean operations on bits are the
//! regularised operations on intervals, and every list can be read back from the bits.

use crate::number::{Tested, ray};
use proptest::collection::{btree_set, vec};
use proptest::prelude::*;
use scancsg::solid::{Difference, Intersection, RayCast, Shape, Slab, Solid, Union};
use scancsg::span::{Crossing, Face, Operation, Span, SpanList, merge};

/// Grid points are the whole numbers from `LOW` to `HIGH`; bit i is the cell from LOW + i on.
const LOW: i32 = -16;
const HIGH: i32 = 16;

type Interval = (i32, i32);

fn bits(intervals: &[Interval]) -> u32 {
    let cells = (LOW..HIGH).filter(|&c| intervals.iter().any(|&(a, b)| a <= c && c < b));
    cells.map(|c| 1u32 << (c - LOW)).sum()
}

/// The maximal runs of set bits.
fn intervals(bits: u32) -> Vec<Interval> {
    let inside = |t: i32| (LOW..HIGH).contains(&t) && bits >> (t - LOW) & 1 == 1;
    let starts = (LOW..=HIGH).filter(|&t| inside(t) && !inside(t - 1));
    let ends = (LOW..=HIGH).filter(|&t| !inside(t) && inside(t - 1));
    starts.zip(ends).collect()
}

/// Regularised lists of up to six intervals: any even number of different grid points, in order.
fn list() -> impl Strategy<Value = Vec<Interval>> {
    btree_set(LOW..=HIGH, 0..=12).prop_map(|points| {
        let points: Vec<i32> = points.into_iter().collect();
        points.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
    })
}

/// The intervals as spans; every crossing has a face of its own, counted from `first` on.
fn spans<S: Tested>(intervals: &[Interval], first: u16) -> Vec<Span<S>> {
    let at =
        |t: i32, face: usize| Crossing { t: S::near(t.into()), face: Face(first + face as u16) };
    let of =
        |(i, &(a, b)): (usize, &Interval)| Span { enter: at(a, 2 * i), exit: at(b, 2 * i + 1) };
    intervals.iter().enumerate().map(of).collect()
}

fn ends<S: Tested>(spans: &[Span<S>]) -> Vec<(S, S)> {
    spans.iter().map(|span| (span.enter.t, span.exit.t)).collect()
}

fn numbers<S: Tested>(intervals: &[Interval]) -> Vec<(S, S)> {
    intervals.iter().map(|&(a, b)| (S::near(a.into()), S::near(b.into()))).collect()
}

type OnBits = fn(u32, u32) -> u32;

const OPERATIONS: [(Operation, OnBits); 3] = [
    (Operation::UNION, |a, b| a | b),
    (Operation::INTERSECTION, |a, b| a & b),
    (Operation::DIFFERENCE, |a, b| a & !b),
];

fn merged<S: Tested>(operation: Operation, parts: [&[Span<S>]; 3]) -> Vec<Span<S>> {
    let [below, left, right] = parts;
    let mut list = SpanList::<S, 30>::new();
    let mut stack = list.stack();
    parts.concat().into_iter().for_each(|span| stack.push(span).unwrap());
    merge(operation, &mut stack, below.len(), below.len() + left.len()).unwrap();
    assert!(list.len() >= below.len(), "{operation:?} of {left:?} and {right:?} ate the stack");
    list.to_vec()
}

/// Everything that a merge promises, for one pair of lists and any spans below them.
fn check<S: Tested>(below: &[Interval], left: &[Interval], right: &[Interval]) {
    let (low, l, r) = (spans::<S>(below, 200), spans(left, 0), spans(right, 100));
    for (operation, of_bits) in OPERATIONS {
        let stack = merged(operation, [&low, &l, &r]);
        let (untouched, result) = stack.split_at(low.len());
        assert_eq!(untouched, low, "{operation:?} touched the spans below");

        let want = numbers(&intervals(of_bits(bits(left), bits(right))));
        assert_eq!(ends(result), want, "{operation:?} of {left:?} and {right:?}");

        for crossing in result.iter().flat_map(|span| [span.enter, span.exit]) {
            let operands = l.iter().chain(&r).flat_map(|span| [span.enter, span.exit]);
            assert!(
                operands.into_iter().any(|c| c == crossing),
                "{operation:?} of {left:?} and {right:?}: no operand has {crossing:?}"
            );
        }
    }
}

for_every_number!(
    merges_agree_with_bitmaps,
    all_pairs_of_lists_on_five_cells,
    whole_lines_cancel,
    union_minus_intersection,
    differences_nested_to_the_right,
    intersections_nested_to_the_right,
    differences_nested_to_the_left,
    intersection_of_unions,
    group_minus_group,
    groups_of_composed_solids,
    a_group_of_groups_on_the_right,
    a_balanced_tree,
    a_union_reaches_all_of_its_spans,
    a_difference_reaches_all_of_its_spans,
    an_intersection_reaches_all_of_its_spans,
    a_group_reaches_all_of_its_spans,
    worst_cases_nest,
);

fn merges_agree_with_bitmaps<S: Tested>() {
    let config = ProptestConfig::with_cases(1000);
    proptest!(config, |(below in list(), left in list(), right in list())| {
        check::<S>(&below, &left, &right);
    });
}

/// On five cells every pair of lists can be tried: each way two lists can share ends is among
/// them, also those that a random draw meets once in a million.
fn all_pairs_of_lists_on_five_cells<S: Tested>() {
    for (left, right) in (0..32u32).flat_map(|l| (0..32u32).map(move |r| (l, r))) {
        check::<S>(&[], &intervals(left << 14), &intervals(right << 14));
    }
}

/// The model has to tell wrong lists from right ones: touching intervals are one, and an empty
/// one is none.
#[test]
fn the_model_is_regularised() {
    assert_eq!(intervals(bits(&[(0, 2), (2, 3)])), [(0, 3)]);
    assert_eq!(intervals(bits(&[(0, 2), (1, 3), (5, 5), (6, 7)])), [(0, 3), (6, 7)]);
    assert_eq!(intervals(bits(&[(LOW, HIGH)])), [(LOW, HIGH)]);
}

/// Ends at infinity tie with each other as all other ends do: naive code that compares with
/// a sentinel leaves a span from −∞ to −∞.
fn whole_lines_cancel<S: Tested>() {
    let whole = [Span::<S>::whole_line(Face(0))];
    let some = spans::<S>(&[(1, 2), (4, 5)], 10);
    let [one, two, four, five] = [1.0, 2.0, 4.0, 5.0].map(S::near);
    let around = [(S::LOWEST, one), (two, four), (five, S::HIGHEST)];
    assert_eq!(ends(&merged(Operation::DIFFERENCE, [&[], &whole, &some])), around);
    assert_eq!(ends(&merged(Operation::DIFFERENCE, [&[], &whole, &whole])), []);
    assert_eq!(ends(&merged(Operation::DIFFERENCE, [&[], &some, &whole])), []);
    let union = merged(Operation::UNION, [&[], &some, &whole]);
    assert_eq!(ends(&union), [(S::LOWEST, S::HIGHEST)]);
    assert_eq!(merged(Operation::INTERSECTION, [&[], &some, &whole]), some);
}

// Trees of slabs, seen by a ray along x: intervals on a line, with the types' own capacities.

type Leaf<S> = Slab<S>;

fn leaf<S: Tested>((low, high): Interval) -> Leaf<S> {
    S::slab_along(0, S::near(low.into()), S::near(high.into())).unwrap()
}

fn interval() -> impl Strategy<Value = Interval> {
    (LOW..HIGH).prop_flat_map(|a| (Just(a), a + 1..=HIGH))
}

/// What the line along x at `start` meets, there and back, as whole numbers of x.
fn check_tree<S: Tested, T: Solid<Scalar = S>, const N: usize>(
    tree: &T,
    mut list: SpanList<S, N>,
    start: i32,
    want: &[Interval],
) -> Result<(), TestCaseError> {
    for direction in [1, -1] {
        let ray = ray::<S>([start.into(), 0.25, -3.0], [direction.into(), 0.0, 0.0]);
        let spans = tree.trace(&ray, &mut list).iter();
        let mut got: Vec<Interval> = spans
            .map(|span| [span.enter.t, span.exit.t].map(|t| start + direction * t.to_f64() as i32))
            .map(|[a, b]| (a.min(b), a.max(b)))
            .collect();
        got.sort_unstable();
        prop_assert_eq!(&got, want);
        prop_assert!(got.len() <= T::SPANS);
    }
    Ok(())
}

/// A tree as a type, its value made of leaves, and the same expression on bits. The list has the
/// capacity that the type asks for and not one span more: that is the same for every number type,
/// but its constant can't be named in a generic function.
macro_rules! tree {
    ($name:ident, $Tree:ty, $count:literal, |$s:ident| $solid:expr, |$b:ident| $bits:expr) => {
        fn $name<S: Tested>() {
            type Tree<S> = $Tree;
            const STACK: usize = <Tree<f64> as Shape>::STACK;
            proptest!(|(leaves in vec(interval(), $count), start in -20i32..=20)| {
                let ($s, $b): (Vec<Leaf<S>>, Vec<u32>) =
                    leaves.iter().map(|&i| (leaf(i), bits(&[i]))).unzip();
                let tree: Tree<S> = $solid;
                check_tree(&tree, SpanList::<S, STACK>::new(), start, &intervals($bits))?;
            });
        }
    };
}

tree!(
    union_minus_intersection,
    Difference<Union<Leaf<S>, Leaf<S>>, Intersection<Leaf<S>, Leaf<S>>>,
    4,
    |s| (s[0] | s[1]) - (s[2] & s[3]),
    |b| (b[0] | b[1]) & !(b[2] & b[3])
);
tree!(
    differences_nested_to_the_right,
    Difference<Leaf<S>, Difference<Leaf<S>, Difference<Leaf<S>, Difference<Leaf<S>, Leaf<S>>>>>,
    5,
    |s| s[0] - (s[1] - (s[2] - (s[3] - s[4]))),
    |b| b[0] & !(b[1] & !(b[2] & !(b[3] & !b[4])))
);
tree!(
    intersections_nested_to_the_right,
    Intersection<
        Leaf<S>,
        Intersection<Leaf<S>, Intersection<Leaf<S>, Intersection<Leaf<S>, Leaf<S>>>>,
    >,
    5,
    |s| s[0] & (s[1] & (s[2] & (s[3] & s[4]))),
    |b| b[0] & b[1] & b[2] & b[3] & b[4]
);
tree!(
    differences_nested_to_the_left,
    Difference<Difference<Difference<Difference<Leaf<S>, Leaf<S>>, Leaf<S>>, Leaf<S>>, Leaf<S>>,
    5,
    |s| s[0] - s[1] - s[2] - s[3] - s[4],
    |b| b[0] & !b[1] & !b[2] & !b[3] & !b[4]
);
tree!(
    intersection_of_unions,
    Intersection<Union<Union<Leaf<S>, Leaf<S>>, Leaf<S>>, Union<Leaf<S>, Leaf<S>>>,
    5,
    |s| (s[0] | s[1] | s[2]) & (s[3] | s[4]),
    |b| (b[0] | b[1] | b[2]) & (b[3] | b[4])
);
tree!(
    group_minus_group,
    Difference<[Leaf<S>; 4], [Leaf<S>; 6]>,
    10,
    |s| Difference::new([s[0], s[1], s[2], s[3]], [s[4], s[5], s[6], s[7], s[8], s[9]]),
    |b| (b[0] | b[1] | b[2] | b[3]) & !(b[4] | b[5] | b[6] | b[7] | b[8] | b[9])
);
tree!(
    groups_of_composed_solids,
    Difference<[Difference<Leaf<S>, Leaf<S>>; 3], [Intersection<Leaf<S>, Leaf<S>>; 2]>,
    10,
    |s| Difference::new([s[0] - s[1], s[2] - s[3], s[4] - s[5]], [s[6] & s[7], s[8] & s[9]]),
    |b| (b[0] & !b[1] | b[2] & !b[3] | b[4] & !b[5]) & !(b[6] & b[7] | b[8] & b[9])
);
tree!(
    a_group_of_groups_on_the_right,
    Union<Leaf<S>, Intersection<Leaf<S>, [[Leaf<S>; 3]; 2]>>,
    8,
    |s| s[0] | (s[1] & [[s[2], s[3], s[4]], [s[5], s[6], s[7]]]),
    |b| b[0] | b[1] & (b[2] | b[3] | b[4] | b[5] | b[6] | b[7])
);
tree!(
    a_balanced_tree,
    Intersection<
        Union<Difference<Leaf<S>, Leaf<S>>, Difference<Leaf<S>, Leaf<S>>>,
        Difference<Union<Leaf<S>, Leaf<S>>, Intersection<Leaf<S>, Leaf<S>>>,
    >,
    8,
    |s| ((s[0] - s[1]) | (s[2] - s[3])) & ((s[4] | s[5]) - (s[6] & s[7])),
    |b| (b[0] & !b[1] | b[2] & !b[3]) & ((b[4] | b[5]) & !(b[6] & b[7]))
);

/// Counts the spans along x; a solid that outgrew its type's capacity would panic in `push`.
fn count<S: Tested, const N: usize>(
    solid: &impl Solid<Scalar = S>,
    mut list: SpanList<S, N>,
) -> usize {
    solid.trace(&ray([-20.0, 0.0, 0.0], [1.0, 0.0, 0.0]), &mut list).len()
}

/// Nothing overlaps, so every span of both operands reaches the result, all at once.
fn a_union_reaches_all_of_its_spans<S: Tested>() {
    type Comb<S> = Union<[Leaf<S>; 3], [Leaf<S>; 3]>;
    let comb =
        Comb::<S>::new([(0, 1), (4, 5), (8, 9)].map(leaf), [(2, 3), (6, 7), (10, 11)].map(leaf));
    assert_eq!(<Comb<f64> as Shape>::SPANS, 6);
    assert_eq!(count(&comb, SpanList::<S, { <Comb<f64> as Shape>::STACK }>::new()), 6);
}

/// Every hole splits a span: as many pieces as both operands have spans.
fn a_difference_reaches_all_of_its_spans<S: Tested>() {
    type Drilled<S> = Difference<[Leaf<S>; 2], [Leaf<S>; 3]>;
    let drilled =
        Drilled::<S>::new([(0, 10), (12, 15)].map(leaf), [(1, 2), (4, 5), (7, 8)].map(leaf));
    assert_eq!(<Drilled<f64> as Shape>::SPANS, 5);
    assert_eq!(count(&drilled, SpanList::<S, { <Drilled<f64> as Shape>::STACK }>::new()), 5);
}

/// Two chains that overlap link by link have a piece for every link but one.
fn an_intersection_reaches_all_of_its_spans<S: Tested>() {
    type Chain<S> = Intersection<[Leaf<S>; 3], [Leaf<S>; 3]>;
    let chain =
        Chain::<S>::new([(0, 3), (4, 7), (8, 11)].map(leaf), [(2, 5), (6, 9), (10, 13)].map(leaf));
    assert_eq!(<Chain<f64> as Shape>::SPANS, 5);
    assert_eq!(count(&chain, SpanList::<S, { <Chain<f64> as Shape>::STACK }>::new()), 5);
}

/// The last element of a group is merged while all others are in memory, and so is the result.
fn a_group_reaches_all_of_its_spans<S: Tested>() {
    type Comb<S> = [Leaf<S>; 4];
    let comb = [(0, 1), (2, 3), (4, 5), (6, 7)].map(leaf);
    assert_eq!(<Comb<f64> as Shape>::SPANS, 4);
    assert_eq!(count(&comb, SpanList::<S, { <Comb<f64> as Shape>::STACK }>::new()), 4);
}

/// The right operand is worked out above the left one's finished spans, and needs its whole
/// working memory there: a capacity of only the results' sizes overflows.
fn worst_cases_nest<S: Tested>() {
    type Comb<S> = Union<[Leaf<S>; 2], [Leaf<S>; 2]>;
    type Nest<S> = Union<[Leaf<S>; 2], Difference<[Leaf<S>; 1], Comb<S>>>;
    let comb = Comb::<S>::new([(1, 2), (5, 6)].map(leaf), [(3, 4), (7, 8)].map(leaf));
    let nest =
        Nest::<S>::new([(-6, -5), (-3, -2)].map(leaf), Difference::new([(0, 9)].map(leaf), comb));
    assert_eq!(<Nest<f64> as Shape>::SPANS, 7);
    assert_eq!(count(&nest, SpanList::<S, { <Nest<f64> as Shape>::STACK }>::new()), 7);
}
