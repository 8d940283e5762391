//! A list of solids of one kind, of a fixed capacity.

/// From one to `N` solids of one kind: their union, like that of an array, but made at run time.
///
/// Use it where the number of parts is known when the program runs: holes from a drill table, the
/// segments of a tube. Capacity that isn't used costs memory and no time.
///
/// ```
/// use scancsg::solid::{Cylinder, Many};
///
/// let hole = |x| Cylinder::<f32>::along_z(x, 0.0, 0.2, -1.0, 1.0);
/// let mut holes = Many::<_, 8>::new(hole(-1.0)?);
/// holes.push(hole(0.0)?)?;
/// holes.push(hole(1.0)?)?;
/// assert_eq!(holes.as_slice().len(), 3);
///
/// let plate = Cylinder::<f32>::along_z(0.0, 0.0, 2.0, -0.1, 0.1)? - holes;
/// # let _ = plate;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Faces are counted as in an array of `N`: the i-th solid's begin at i times their number.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Many<T, const N: usize> {
    /// Behind the last one, the first one again and again.
    items: [T; N],
    count: usize,
}

crate::error_text! {
    /// Why a [`Many`] can't be made, or added to.
    pub enum ManyError {
        /// There is no solid.
        Empty => "a union of many solids needs at least one",
        /// There are more solids than there is room for.
        Full => "there are more solids than there is room for",
    }
}

impl<T: Copy, const N: usize> Many<T, N> {
    /// A list of one solid.
    #[must_use]
    pub const fn new(first: T) -> Self {
        const { assert!(N > 0, "a list of solids needs room for at least one") };
        Self { items: [first; N], count: 1 }
    }

    /// The solids of a slice.
    ///
    /// # Errors
    /// [`ManyError::Empty`], [`ManyError::Full`].
    pub const fn from_slice(solids: &[T]) -> Result<Self, ManyError> {
        let [first, rest @ ..] = solids else { return Err(ManyError::Empty) };
        let mut many = Self::new(*first);
        let mut rest = rest;
        while let [solid, others @ ..] = rest {
            if let Err(error) = many.push(*solid) {
                return Err(error);
            }
            rest = others;
        }
        Ok(many)
    }

    /// Adds a solid.
    ///
    /// # Errors
    /// [`ManyError::Full`]; the list is as it was.
    pub const fn push(&mut self, solid: T) -> Result<(), ManyError> {
        if self.count >= N {
            return Err(ManyError::Full);
        }
        self.items[self.count] = solid;
        self.count += 1;
        Ok(())
    }
}

impl<T, const N: usize> Many<T, N> {
    /// The solids.
    #[must_use]
    #[inline]
    pub const fn as_slice(&self) -> &[T] {
        match self.items.split_at_checked(self.count) {
            Some((solids, _)) => solids,
            None => &self.items,
        }
    }

    /// The solids, to change them.
    #[must_use]
    pub const fn as_mut_slice(&mut self) -> &mut [T] {
        if self.count > N {
            return &mut self.items;
        }
        self.items.split_at_mut(self.count).0
    }
}
