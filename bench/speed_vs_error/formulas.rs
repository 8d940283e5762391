//! The formulas that others use, as well as they can be written in a few lines.

/// What is left of the wall's chord between the caps, by the slab test.
macro_rules! capped {
    ($t_in:expr, $t_out:expr, $ox:expr, $dx:expr, $h:expr) => {{
        let (t_in, t_out) = if $dx == 0.0 {
            if $ox.abs() > $h {
                return None;
            }
            ($t_in, $t_out)
        } else {
            let (low, high) = ((-$h - $ox) / $dx, ($h - $ox) / $dx);
            ($t_in.max(low.min(high)), $t_out.min(low.max(high)))
        };
        (t_in <= t_out).then_some([t_in, t_out])
    }};
}

macro_rules! formulas {
    ($Float:ident) => {
        pub mod $Float {
            /// ox oy oz dx dy dz r h.
            pub type Input = [$Float; 8];

            /// The textbook's b² − 4ac with c = |o|² − r².
            pub fn textbook(&[ox, oy, oz, dx, dy, dz, r, h]: &Input) -> Option<[$Float; 2]> {
                let a = dy * dy + dz * dz;
                let b = 2.0 * (oy * dy + oz * dz);
                let c = oy * oy + oz * oz - r * r;
                let (t_in, t_out) = if a == 0.0 {
                    if c > 0.0 {
                        return None;
                    }
                    ($Float::NEG_INFINITY, $Float::INFINITY)
                } else {
                    let discriminant = b * b - 4.0 * a * c;
                    if discriminant < 0.0 {
                        return None;
                    }
                    let root = discriminant.sqrt();
                    ((-b - root) / (2.0 * a), (-b + root) / (2.0 * a))
                };
                capped!(t_in, t_out, ox, dx, h)
            }

            /// The discriminant as r²a − k², k = u·(d × axis): no squares of distances cancel,
            /// but rounding errors are left as they are.
            pub fn stable(&[ox, oy, oz, dx, dy, dz, r, h]: &Input) -> Option<[$Float; 2]> {
                let a = dy * dy + dz * dz;
                let (t_in, t_out) = if a == 0.0 {
                    if oy * oy + oz * oz > r * r {
                        return None;
                    }
                    ($Float::NEG_INFINITY, $Float::INFINITY)
                } else {
                    let k = oy * dz - oz * dy;
                    let discriminant = r * r * a - k * k;
                    if discriminant < 0.0 {
                        return None;
                    }
                    let (middle, root) = (-(oy * dy + oz * dz), discriminant.sqrt());
                    ((middle - root) / a, (middle + root) / a)
                };
                capped!(t_in, t_out, ox, dx, h)
            }
        }
    };
}

formulas!(f32);
formulas!(f64);
