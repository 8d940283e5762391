//! The border to C: pointers become references here, after what can be checked of them is checked.

use crate::status::Status;

/// What C may hand over: any bits of it are a value.
///
/// # Safety
/// Every pattern of bits is a value of the type.
pub(crate) unsafe trait Plain: Copy {}

// SAFETY: integers, and floats, have a value for all bits.
unsafe impl Plain for u8 {}
// SAFETY: as above.
unsafe impl Plain for u32 {}
// SAFETY: as above.
unsafe impl Plain for i32 {}
// SAFETY: as above.
unsafe impl Plain for f32 {}
// SAFETY: an array is its elements.
unsafe impl<T: Plain, const N: usize> Plain for [T; N] {}

fn check<T>(pointer: *const T) -> Result<(), Status> {
    match () {
        () if pointer.is_null() => Err(Status::Null),
        () if !pointer.is_aligned() => Err(Status::Alignment),
        () => Ok(()),
    }
}

fn check_many<T>(first: *const T, count: usize) -> Result<(), Status> {
    check(first)?;
    let bytes = count.checked_mul(size_of::<T>()).ok_or(Status::Length)?;
    let is_in_memory = bytes <= isize::MAX as usize && first.addr().checked_add(bytes).is_some();
    if is_in_memory { Ok(()) } else { Err(Status::Length) }
}

/// `count` values that C hands over. Of none, the pointer may be null.
///
/// # Safety
/// A pointer that isn't null has so many values behind it, which nobody writes meanwhile.
pub(crate) unsafe fn slice<'a, T: Plain>(first: *const T, count: usize) -> Result<&'a [T], Status> {
    if count == 0 {
        return Ok(&[]);
    }
    check_many(first, count)?;
    // SAFETY: it is neither null nor misaligned, its bytes end in memory, and the caller says the rest.
    Ok(unsafe { core::slice::from_raw_parts(first, count) })
}

/// Room for `count` values that C lends. Of none, the pointer may be null.
///
/// # Safety
/// As [`slice`], and nobody reads it meanwhile.
pub(crate) unsafe fn room<'a, T: Plain>(
    first: *mut T,
    count: usize,
) -> Result<&'a mut [T], Status> {
    if count == 0 {
        return Ok(&mut []);
    }
    check_many(first, count)?;
    // SAFETY: as in `slice`; nobody else has it.
    Ok(unsafe { core::slice::from_raw_parts_mut(first, count) })
}

/// One value that C hands over.
///
/// # Safety
/// A pointer that isn't null has a value behind it.
pub(crate) unsafe fn read<T: Plain>(from: *const T) -> Result<T, Status> {
    check(from)?;
    // SAFETY: it is neither null nor misaligned, and any bits are a value.
    Ok(unsafe { from.read() })
}

/// Writes a value to where C wants it.
///
/// # Safety
/// A pointer that isn't null has room for a value behind it.
pub(crate) unsafe fn write<T>(to: *mut T, value: T) -> Result<(), Status> {
    check(to)?;
    // SAFETY: it is neither null nor misaligned.
    unsafe { to.write(value) };
    Ok(())
}

/// Something of the library's in memory of C's: it begins with [`MARK`](Self::MARK) once it is made.
///
/// # Safety
/// The first field is a `u32` (`repr(C)`), which is `MARK` in every value. It has no destructor, and it is
/// no larger than [`Storage`](Self::Storage), nor stricter aligned.
pub(crate) unsafe trait Kept: Sized {
    /// What C sees of it.
    type Storage;
    const MARK: u32;
}

/// The place for a thing, and whether header and library agree on its size.
pub(crate) fn place<T: Kept>(storage: *mut T::Storage, size: usize) -> Result<*mut T, Status> {
    const {
        assert!(size_of::<T>() <= size_of::<T::Storage>(), "the header has too little room");
        assert!(align_of::<T>() <= align_of::<T::Storage>(), "the header aligns too little");
    }
    check(storage)?;
    if size == size_of::<T::Storage>() { Ok(storage.cast()) } else { Err(Status::Storage) }
}

/// Marks a place as one that holds nothing, until something is written there.
///
/// # Safety
/// `place` comes from [`place`](place()), and C has lent all of the storage.
pub(crate) unsafe fn clear<T: Kept>(place: *mut T) {
    // SAFETY: a thing begins with its mark, which is aligned as the thing is.
    unsafe { place.cast::<u32>().write(!T::MARK) };
}

/// A thing in memory of C's, if it is made.
///
/// # Safety
/// A pointer that isn't null has a whole storage behind it, which only this library has written to, or
/// that is zero. Nobody writes to it meanwhile.
pub(crate) unsafe fn kept<'a, T: Kept>(storage: *const T::Storage) -> Result<&'a T, Status> {
    check(storage)?;
    // SAFETY: the storage begins with a word, whether the thing is made or not.
    if unsafe { storage.cast::<u32>().read() } != T::MARK {
        return Err(Status::NotMade);
    }
    // SAFETY: whoever wrote the mark has written the rest of it.
    Ok(unsafe { &*storage.cast::<T>() })
}

/// As [`kept`], to change it.
///
/// # Safety
/// As [`kept`], and nobody reads it meanwhile.
pub(crate) unsafe fn kept_mut<'a, T: Kept>(storage: *mut T::Storage) -> Result<&'a mut T, Status> {
    // SAFETY: as in `kept`, which the caller knows.
    unsafe { kept::<T>(storage) }?;
    // SAFETY: it is made; nobody else has it.
    Ok(unsafe { &mut *storage.cast::<T>() })
}
