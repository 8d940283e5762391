//! Real roots of quartics: an accurate way for references, and the textbook's.

/// The roots at which a polynomial changes its sign in an interval, in order: those of its derivative are
/// what they lie between. Coefficients come in the order of the powers.
pub fn bracketed(polynomial: &[f64], [low, high]: [f64; 2]) -> Vec<f64> {
    let value = |t: f64| polynomial.iter().rev().fold(0.0, |sum, x| sum * t + x);
    if polynomial.len() < 2 {
        return Vec::new();
    }
    let derivative: Vec<f64> =
        polynomial.iter().enumerate().skip(1).map(|(power, x)| power as f64 * x).collect();
    let mut ends = bracketed(&derivative, [low, high]);
    ends.insert(0, low);
    ends.push(high);
    let between = ends.windows(2).filter_map(|pair| {
        let [mut near, mut far] = [pair[0], pair[1]];
        let sign = value(near) < 0.0;
        if (value(far) < 0.0) == sign {
            return None;
        }
        loop {
            let middle = 0.5 * (near + far);
            if middle <= near || far <= middle {
                return Some(middle);
            }
            if (value(middle) < 0.0) == sign {
                near = middle;
            } else {
                far = middle;
            }
        }
    });
    between.collect()
}

/// Below that, a number counts as zero.
const ZERO: f32 = 1e-9;

/// Ferrari's solution in the form of J. Schwarze, *Cubic and quartic roots*, Graphics Gems, 1990. Returns the
/// roots, unsorted, and their number.
pub fn ferrari(coefficients: [f32; 5]) -> ([f32; 4], usize) {
    let [d, c, b, a] = [0, 1, 2, 3].map(|power| coefficients[power] / coefficients[4]);
    // Substituted x = y − a/4, so that the cubic term vanishes: y⁴ + p·y² + q·y + r.
    let square = a * a;
    let p = -0.375 * square + b;
    let q = 0.125 * square * a - 0.5 * a * b + c;
    let r = -0.011_718_75 * square * square + 0.0625 * square * b - 0.25 * a * c + d;
    let mut found = ([0.0; 4], 0);
    let mut add = |y: f32| {
        if !y.is_nan() && found.1 < 4 {
            found.0[found.1] = y - 0.25 * a;
            found.1 += 1;
        }
    };
    if r.abs() < ZERO {
        // y·(y³ + p·y + q)
        let (roots, count) = cubic(0.0, p, q);
        roots[..count].iter().for_each(|&root| add(root));
        add(0.0);
        return found;
    }
    let (roots, _) = cubic(-0.5 * p, -r, 0.5 * r * p - 0.125 * q * q);
    let z = roots[0];
    let [u, v] = [z * z - r, 2.0 * z - p].map(|x| if x.abs() < ZERO { 0.0 } else { x });
    if u < 0.0 || v < 0.0 {
        return found;
    }
    let (u, v) = (u.sqrt(), v.sqrt());
    let v = if q < 0.0 { -v } else { v };
    for (half, rest) in [(0.5 * v, z - u), (-0.5 * v, z + u)] {
        let discriminant = half * half - rest;
        if discriminant >= 0.0 {
            let root = discriminant.sqrt();
            add(-half + root);
            add(-half - root);
        }
    }
    found
}

/// Cardano's: the roots of x³ + a·x² + b·x + c, and their number.
fn cubic(a: f32, b: f32, c: f32) -> ([f32; 3], usize) {
    let square = a * a;
    let p = (-square / 3.0 + b) / 3.0;
    let q = 0.5 * (2.0 / 27.0 * a * square - a * b / 3.0 + c);
    let cube = p * p * p;
    let discriminant = q * q + cube;
    let shift = a / 3.0;
    if discriminant.abs() < ZERO {
        let root = (-q).cbrt();
        return ([2.0 * root - shift, -root - shift, 0.0], 2);
    }
    if discriminant < 0.0 {
        let angle = (-q / (-cube).sqrt()).acos() / 3.0;
        let reach = 2.0 * (-p).sqrt();
        let third = std::f32::consts::FRAC_PI_3;
        let roots = [angle.cos(), -(angle + third).cos(), -(angle - third).cos()]
            .map(|x| reach * x - shift);
        return (roots, 3);
    }
    let root = discriminant.sqrt();
    ([(root - q).cbrt() - (root + q).cbrt() - shift, 0.0, 0.0], 1)
}
