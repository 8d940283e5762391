//! Vectors of three `f64`, for models that must have nothing in common with the crate.

pub type V = [f64; 3];

pub fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn times(a: V, k: f64) -> V {
    a.map(|x| x * k)
}

/// a + s·b
pub fn along(a: V, s: f64, b: V) -> V {
    std::array::from_fn(|i| a[i] + s * b[i])
}

pub fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: V) -> f64 {
    let square = dot(a, a);
    // The library's function is ten times as slow, and knows no limits.
    if (1e-200..1e200).contains(&square) { square.sqrt() } else { a[0].hypot(a[1]).hypot(a[2]) }
}

/// The vector of length 1 in the same direction.
pub fn unit(a: V) -> V {
    let length = length(a);
    a.map(|x| x / length)
}
