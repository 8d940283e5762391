//! Whole numbers with more bits than a word has, on cores that have nothing for them.
//!
//! A Cortex-M0 multiplies 32 by 32 bits to 32, and its run-time library makes 64 bits out of 64 by
//! 64, which is twice what is needed here. Its shifts of 64 bits are calls, and it counts no leading
//! zeros. Other cores have instructions, and take none of this.

/// `a · b`.
#[inline(never)]
pub(super) const fn unsigned_product(a: u32, b: u32) -> u64 {
    let (a_high, a_low) = (a >> 16, a & 0xffff);
    let (b_high, b_low) = (b >> 16, b & 0xffff);
    let ends = ((a_high * b_high) as u64) << 32 | (a_low * b_low) as u64;
    let middle = ((a_high * b_low) as u64) << 16;
    ends.wrapping_add(middle).wrapping_add(((a_low * b_high) as u64) << 16)
}

/// `a · b`.
#[inline(never)]
pub(super) const fn signed_product(a: i32, b: i32) -> i64 {
    let product = unsigned_product(a.cast_unsigned(), b.cast_unsigned());
    // A negative number counts 2³² too much.
    let too_much = (a >> 31 & b).wrapping_add(b >> 31 & a);
    product.wrapping_sub((too_much.cast_unsigned() as u64) << 32).cast_signed()
}

/// `a · b`.
#[inline]
pub(super) const fn short_product(a: i32, b: u16) -> i64 {
    let upper = (a >> 16).wrapping_mul(b as i32) as i64;
    let lower = (a.cast_unsigned() & 0xffff).wrapping_mul(b as u32);
    (upper << 16).wrapping_add(lower as i64)
}

/// `a · b / 2¹⁶`, cut off, for b below 2¹⁶.
#[inline]
pub(super) const fn upper_product(a: u32, b: u32) -> u32 {
    ((a >> 16).wrapping_mul(b)).wrapping_add(((a & 0xffff).wrapping_mul(b)) >> 16)
}

/// `a · b`: halves that are zero cost nothing, as those before the point of numbers below 1.
#[inline]
pub(super) const fn long_product(a: i64, b: i64) -> i128 {
    // As of vectors along coordinate axes.
    if a == 0 || b == 0 {
        return 0;
    }
    let (x, y) = (a.unsigned_abs(), b.unsigned_abs());
    let (x_high, x_low, y_high, y_low) = ((x >> 32) as u32, x as u32, (y >> 32) as u32, y as u32);
    let low = unsigned_product(x_low, y_low);
    let (mut high, mut middle) = (0, low >> 32);
    if x_high != 0 {
        let of_high = unsigned_product(x_high, y_low);
        middle += of_high & 0xffff_ffff;
        high += of_high >> 32;
    }
    if y_high != 0 {
        let of_high = unsigned_product(x_low, y_high);
        middle += of_high & 0xffff_ffff;
        high += of_high >> 32;
        if x_high != 0 {
            high += unsigned_product(x_high, y_high);
        }
    }
    high += middle >> 32;
    let size = (high as u128) << 64 | (middle << 32) as u128 | (low & 0xffff_ffff) as u128;
    if (a < 0) != (b < 0) { -size.cast_signed() } else { size.cast_signed() }
}

/// `step · count`, modulo 2⁶⁴.
#[inline(never)]
pub(super) const fn steps(step: i64, count: i32) -> i64 {
    let (high, low) = ((step >> 32) as i32, step as u32);
    let of_high = (high.wrapping_mul(count) as i64) << 32;
    // Pictures of up to 32,768 columns and rows.
    if count as i16 as i32 == count {
        let lower = (low & 0xffff).cast_signed() * count;
        let upper = ((low >> 16).cast_signed() * count) as i64;
        of_high.wrapping_add(upper << 16).wrapping_add(lower as i64)
    } else {
        let of_low = unsigned_product(low, count.cast_unsigned()).cast_signed();
        let too_much = ((count >> 31).cast_unsigned() & low) as i64;
        of_high.wrapping_add(of_low).wrapping_sub(too_much << 32)
    }
}

/// `value >> by`, for shifts by less than 64 bits.
#[inline]
pub(super) const fn shifted(value: i64, by: u32) -> i64 {
    let (high, low) = ((value >> 32) as i32, value as u32);
    let (high, low) = if by == 0 {
        (high, low)
    } else if by < 32 {
        (high >> by, low >> by | high.cast_unsigned() << (32 - by))
    } else {
        (high >> 31, (high >> (by & 31)).cast_unsigned())
    };
    (high as i64) << 32 | low as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn halves_make_the_whole_product(a: i32, b: i32, step: i64, other: i64, small in -40_000i32..40_000) {
            prop_assert_eq!(signed_product(a, b), i64::from(a) * i64::from(b));
            let (x, y) = (a.cast_unsigned(), b.cast_unsigned());
            prop_assert_eq!(unsigned_product(x, y), u64::from(x) * u64::from(y));
            let short = y as u16;
            prop_assert_eq!(short_product(a, short), i64::from(a) * i64::from(short));
            let upper = (u64::from(x) * u64::from(short)) >> 16;
            prop_assert_eq!(upper_product(x, short.into()), upper as u32);
            for (a, b) in [(step, other), (step, other >> 40), (step >> 40, step >> 20)] {
                prop_assert_eq!(long_product(a, b), i128::from(a) * i128::from(b));
            }
            for by in 0..64 {
                prop_assert_eq!(shifted(step, by), step >> by);
            }
            for count in [a, small] {
                let want = step.wrapping_mul(i64::from(count));
                prop_assert_eq!(steps(step, count), want);
            }
        }
    }

    #[test]
    fn the_ends_of_the_range() {
        let ends = [i32::MIN, i32::MIN + 1, -1, 0, 1, 0x7fff, 0x8000, 0xffff, i32::MAX];
        let long = [i64::MIN, i64::MIN + 1, -1, 0, 1, 0xffff_ffff, 1 << 32, i64::MAX];
        for a in long {
            for b in long {
                assert_eq!(long_product(a, b), i128::from(a) * i128::from(b));
            }
        }
        for a in ends {
            for b in ends {
                assert_eq!(signed_product(a, b), i64::from(a) * i64::from(b));
                let step = i64::from(a) << 32 | i64::from(b);
                assert_eq!(steps(step, a), step.wrapping_mul(i64::from(a)));
                assert_eq!(steps(step, b), step.wrapping_mul(i64::from(b)));
            }
        }
    }
}
