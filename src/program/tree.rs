//! A boolean tree in postfix order, without its leaves.

use crate::span::Operation;
use crate::span::chain::Link;

/// What is done with the leaves of a program. Leaf i is the i-th one in postfix order.
///
/// Every operator takes the place of two operands, so there are fewer operators than leaves. What isn't
/// combined is united: so there is no unfinished tree.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tree<const N: usize> {
    operators: [Operator; N],
    count: u16,
    leaves: u16,
}

/// An operator, and in its lower bits how many leaves are in front of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Operator(u16);

/// More leaves than any tree has.
pub(super) const MOST_LEAVES: usize = 1 << 14;

impl Operator {
    const fn new(kind: Kind, leaves: u16) -> Self {
        Self((kind as u16) << 14 | leaves)
    }

    const fn leaves(self) -> u16 {
        self.0 & (MOST_LEAVES as u16 - 1)
    }

    const fn kind(self) -> Kind {
        match self.0 >> 14 {
            0 => Kind::Unite,
            1 => Kind::Intersect,
            _ => Kind::Subtract,
        }
    }
}

/// What an operator does with the two operands in front of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Unite,
    Intersect,
    Subtract,
}

impl Kind {
    pub(super) const fn operation(self) -> Operation {
        match self {
            Self::Unite => Operation::UNION,
            Self::Intersect => Operation::INTERSECTION,
            Self::Subtract => Operation::DIFFERENCE,
        }
    }

    const fn is_subtraction(self) -> bool {
        matches!(self, Self::Subtract)
    }
}

impl<const N: usize> Tree<N> {
    pub(super) const NOTHING: Self = Self { operators: [Operator(0); N], count: 0, leaves: 0 };

    /// One leaf.
    pub(super) const LEAF: Self = Self { leaves: 1, ..Self::NOTHING };

    /// The number of leaves; the compiler sees that there is room for them.
    pub(super) const fn leaves(&self) -> usize {
        if (self.leaves as usize) < N { self.leaves as usize } else { N }
    }

    /// The number of operators.
    const fn count(&self) -> usize {
        if (self.count as usize) < N { self.count as usize } else { N }
    }

    /// Adds a leaf, if there is room.
    pub(super) const fn push(&mut self) -> bool {
        let has_room = self.leaves() < N;
        if has_room {
            self.leaves += 1;
        }
        has_room
    }

    /// The number of operands that no operator has taken.
    pub(super) const fn open(&self) -> usize {
        self.leaves().saturating_sub(self.count())
    }

    /// Takes the last two operands for one.
    pub(super) const fn combine(&mut self, kind: Kind) {
        let count = self.count();
        if self.open() > 1 && count < N {
            self.operators[count] = Operator::new(kind, self.leaves);
            self.count += 1;
        }
    }

    /// The first leaf of the last so many operands.
    pub(super) const fn start_of(&self, operands: usize) -> usize {
        let (mut missing, mut count, mut leaf) = (operands, self.count(), self.leaves());
        while missing > 0 && leaf > 0 {
            if count > 0 && self.operators[count - 1].leaves() as usize == leaf {
                count -= 1;
                missing += 1;
            } else {
                leaf -= 1;
                missing -= 1;
            }
        }
        leaf
    }

    /// The place of the operator that takes a leaf as it is, and whether the leaf is its left operand.
    const fn parent(&self, leaf: usize) -> Option<(usize, bool)> {
        let mut place = 0;
        while place < self.count() && self.operators[place].leaves() as usize <= leaf {
            place += 1;
        }
        let (mut operands, mut at) = (1, leaf + 1);
        while place < self.count() {
            // Leaves up to the next operator are operands behind it.
            let next = self.operators[place].leaves() as usize;
            operands += next - at;
            at = next;
            match operands {
                1 => return Some((place, false)),
                2 => return Some((place, true)),
                _ => operands -= 1,
            }
            place += 1;
        }
        None
    }

    /// Whether something is cut out of the leaf as it is.
    pub(super) const fn is_cut_into(&self, leaf: usize) -> bool {
        match self.parent(leaf) {
            Some((place, is_left)) => is_left && self.operators[place].kind().is_subtraction(),
            None => false,
        }
    }

    /// Removes one of several leaves, and the operator that takes it as it is: the other operand stays.
    pub(super) const fn remove(&mut self, leaf: usize) {
        let (parent, count) = match self.parent(leaf) {
            Some((place, _)) => (place, self.count - 1),
            None => (N, self.count),
        };
        let mut place = 0;
        while place < count as usize && place < N {
            let from = if place < parent { place } else { place + 1 };
            if from >= N {
                break;
            }
            let mut operator = self.operators[from];
            if operator.leaves() as usize > leaf {
                operator.0 -= 1;
            }
            self.operators[place] = operator;
            place += 1;
        }
        (self.count, self.leaves) = (count, self.leaves - 1);
    }

    pub(super) fn as_ref(&self) -> TreeRef<'_> {
        let operators = self.operators.get(..self.count.into()).unwrap_or_default();
        TreeRef { operators, leaves: self.leaves }
    }
}

/// What leaves and operators come to.
pub(super) trait Fold<T> {
    fn leaf(&mut self, index: u16) -> T;

    fn combine(&mut self, operation: Operation, left: T, right: T) -> T;

    /// Whether an operand is empty, so that nothing need be cut out of it.
    fn is_nothing(&self, _: T) -> bool {
        false
    }
}

/// The operator whose left operand is what the leaves up to `index` came to last, if it is nothing
/// without that; and the operators behind it.
fn that_needs_left(operators: &[Operator], index: u16) -> Option<(Operator, &[Operator])> {
    let (mut operands, mut at, mut rest) = (1, index, operators);
    while let [operator, behind @ ..] = rest {
        operands += operator.leaves().saturating_sub(at);
        (at, rest) = (operator.leaves(), behind);
        match operands {
            1 => return None,
            2 => return operator.kind().operation().needs_left().then_some((*operator, behind)),
            _ => operands -= 1,
        }
    }
    None
}

/// A tree of any capacity.
#[derive(Debug, Clone, Copy)]
pub(super) struct TreeRef<'a> {
    operators: &'a [Operator],
    leaves: u16,
}

impl TreeRef<'_> {
    /// The leaves and operators in postfix order: `None` for a leaf. What is left is united.
    pub(super) fn postfix(self) -> impl Iterator<Item = Option<Kind>> {
        let mut operators = self.operators.iter().peekable();
        let mut leaves = 0;
        core::iter::from_fn(move || {
            if let Some(operator) = operators.next_if(|operator| operator.leaves() == leaves) {
                return Some(Some(operator.kind()));
            }
            leaves += 1;
            (leaves <= self.leaves).then_some(None)
        })
    }

    /// Computes what the whole tree comes to. `stack` has room for all leaves.
    pub(super) fn fold<T: Copy>(self, stack: &mut [T], by: &mut impl Fold<T>) {
        fn take<T: Copy>(stack: &mut [T], by: &mut impl Fold<T>, operation: Operation) {
            if let [.., left, right] = stack {
                *left = by.combine(operation, *left, *right);
            }
        }
        let (mut depth, mut index, mut operators) = (0, 0, self.operators);
        loop {
            match operators {
                [operator, rest @ ..] if operator.leaves() <= index => {
                    let operation = operator.kind().operation();
                    take(stack.get_mut(..depth).unwrap_or_default(), by, operation);
                    (depth, operators) = (depth - 1, rest);
                }
                _ if index < self.leaves => {
                    if let Some(top) = stack.get_mut(depth) {
                        *top = by.leaf(index);
                    }
                    (depth, index) = (depth + 1, index + 1);
                }
                _ => break,
            }
            let top = depth.checked_sub(1).and_then(|last| stack.get(last));
            while top.is_some_and(|top| by.is_nothing(*top))
                && let Some((operator, rest)) = that_needs_left(operators, index)
            {
                (index, operators) = (operator.leaves(), rest);
            }
        }
        while depth > 1 {
            take(stack.get_mut(..depth).unwrap_or_default(), by, Operation::UNION);
            depth -= 1;
        }
    }

    /// Makes a chain of the leaves that aren't [hidden](is_hidden) in `links`, and returns where it
    /// begins. `pending` has room for all leaves.
    pub(super) fn link(self, links: &mut [Link], pending: &mut [Link]) -> u16 {
        /// Where the chain goes on with the leaf that was linked last.
        const NEXT: u16 = HIDDEN;
        let (mut operators, mut waiting, mut entry) = (self.operators, 0, Link::OUT);
        let mut ends = Link { inside: Link::IN, outside: Link::OUT };
        for leaf in (0..self.leaves).rev() {
            while let [rest @ .., operator] = operators
                && operator.leaves() > leaf
            {
                // The right operand is linked first, so where it begins is known when the left one is.
                let Link { inside, outside } = ends;
                let left = match operator.kind() {
                    Kind::Unite => Link { inside, outside: NEXT },
                    Kind::Intersect => Link { inside: NEXT, outside },
                    Kind::Subtract => {
                        ends = Link { inside: outside, outside: inside };
                        Link { inside: NEXT, outside }
                    }
                };
                if let Some(place) = pending.get_mut(waiting) {
                    *place = left;
                    waiting += 1;
                }
                operators = rest;
            }
            if let Some(link) = links.get_mut(usize::from(leaf)) {
                if is_hidden(link) {
                    entry = ends.outside;
                } else {
                    (*link, entry) = (ends, leaf);
                }
            }
            ends = match waiting.checked_sub(1).and_then(|last| pending.get(last)) {
                Some(&Link { inside, outside }) => {
                    waiting -= 1;
                    let known = |target| if target == NEXT { entry } else { target };
                    Link { inside: known(inside), outside: known(outside) }
                }
                None => Link { inside: Link::IN, outside: entry },
            };
        }
        entry
    }
}

/// Marks a leaf that can't be seen.
const HIDDEN: u16 = Link::IN - 1;

/// Hides all leaves but these.
pub(super) fn hide_all_but(seen: impl Iterator<Item = u16>, links: &mut [Link]) {
    links.fill(Link { inside: HIDDEN, outside: Link::OUT });
    show(seen, links);
}

fn show(seen: impl Iterator<Item = u16>, links: &mut [Link]) {
    for leaf in seen {
        if let Some(link) = links.get_mut(usize::from(leaf)) {
            link.inside = Link::IN;
        }
    }
}

fn is_hidden(link: &Link) -> bool {
    link.inside == HIDDEN
}

/// Hides leaves.
pub(super) fn hide(leaves: impl Iterator<Item = u16>, links: &mut [Link]) {
    for leaf in leaves {
        if let Some(link) = links.get_mut(usize::from(leaf)) {
            link.inside = HIDDEN;
        }
    }
}

/// Shortens a chain to the leaves that are seen, and returns where it begins. In `short` all are
/// hidden.
pub(super) fn shorten(
    entry: u16,
    links: &[Link],
    seen: impl Iterator<Item = u16> + Clone,
    short: &mut [Link],
) -> u16 {
    show(seen.clone(), short);
    // Most leaves of a union go on with the same one.
    let mut last = [Link::OUT; 2];
    let mut known = |short: &[Link], target: u16| {
        if target == last[0] {
            return last[1];
        }
        let mut at = target;
        while let (Some(link), Some(short)) =
            (links.get(usize::from(at)), short.get(usize::from(at)))
            && is_hidden(short)
        {
            at = link.outside;
        }
        last = [target, at];
        at
    };
    for leaf in seen {
        let Some(&Link { inside, outside }) = links.get(usize::from(leaf)) else { continue };
        let outside = known(short, outside);
        let inside = known(short, inside);
        if let Some(link) = short.get_mut(usize::from(leaf)) {
            *link = Link { inside, outside };
        }
    }
    known(short, entry)
}
