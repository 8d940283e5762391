//! A brute-force ray caster in `f64`, with nothing in common with the crate's way.
//!
//! No lists are merged: all parameters at which a ray might cross a surface are collected and
//! sorted, and the middle of each piece between them is asked whether it is in the solid, by
//! evaluating the boolean expression at that point.

pub use crate::vector::{V, add, cross, dot, length, sub, times, unit};

/// A solid as a tree of points' properties.
#[derive(Debug, Clone)]
pub enum Solid {
    Cylinder {
        from: V,
        to: V,
        radius: f64,
    },
    /// With a radius at either end.
    Cone {
        from: V,
        to: V,
        radii: [f64; 2],
    },
    Sphere {
        center: V,
        radius: f64,
    },
    Slab {
        normal: V,
        low: f64,
        high: f64,
    },
    Torus {
        center: V,
        axis: V,
        ring: f64,
        tube: f64,
    },
    Any(Vec<Solid>),
    All(Vec<Solid>),
    Minus(Box<Solid>, Box<Solid>),
}

#[derive(Debug, Clone, Copy)]
pub struct Ray {
    pub origin: V,
    pub direction: V,
}

impl Ray {
    pub fn at(&self, t: f64) -> V {
        add(self.origin, times(self.direction, t))
    }
}

/// Where a ray crosses the surface of a primitive, and the outward normal there.
#[derive(Debug, Clone, Copy)]
pub struct Crossing {
    pub t: f64,
    pub normal: V,
}

impl Solid {
    /// Larger by a length at all sides, or smaller.
    pub fn grown(&self, by: f64) -> Self {
        let all = |parts: &[Self]| parts.iter().map(|part| part.grown(by)).collect();
        match self {
            Self::Cylinder { from, to, radius } => {
                let way = times(unit(sub(*to, *from)), by);
                Self::Cylinder { from: sub(*from, way), to: add(*to, way), radius: radius + by }
            }
            Self::Cone { from, to, radii: [low, high] } => {
                // Wider where the side moves out, and as the caps do.
                let (axis, rise) = (sub(*to, *from), high - low);
                let way = times(unit(axis), by);
                let slope = rise / length(axis);
                let wider = by * (1.0 + slope * slope).sqrt();
                let radii = [low + wider - by * slope, high + wider + by * slope];
                let radii = radii.map(|radius| radius.max(0.0));
                Self::Cone { from: sub(*from, way), to: add(*to, way), radii }
            }
            Self::Sphere { center, radius } => {
                Self::Sphere { center: *center, radius: radius + by }
            }
            Self::Slab { normal, low, high } => {
                Self::Slab { normal: *normal, low: low - by, high: high + by }
            }
            Self::Torus { center, axis, ring, tube } => {
                Self::Torus { center: *center, axis: *axis, ring: *ring, tube: tube + by }
            }
            Self::Any(parts) => Self::Any(all(parts)),
            Self::All(parts) => Self::All(all(parts)),
            Self::Minus(left, right) => {
                Self::Minus(Box::new(left.grown(by)), Box::new(right.grown(-by)))
            }
        }
    }

    pub fn contains(&self, p: V) -> bool {
        match self {
            Self::Cylinder { from, to, radius } => {
                let axis = sub(*to, *from);
                let u = sub(p, *from);
                let along = dot(u, axis);
                let across = cross(u, unit(axis));
                (0.0..=dot(axis, axis)).contains(&along) && length(across) <= *radius
            }
            Self::Cone { from, to, radii: [low, high] } => {
                let axis = sub(*to, *from);
                let u = sub(p, *from);
                let part = dot(u, axis) / dot(axis, axis);
                let radius = low + (high - low) * part;
                (0.0..=1.0).contains(&part) && length(cross(u, unit(axis))) <= radius
            }
            Self::Sphere { center, radius } => length(sub(p, *center)) <= *radius,
            Self::Slab { normal, low, high } => (*low..=*high).contains(&dot(p, unit(*normal))),
            Self::Torus { center, axis, ring, tube } => {
                length(from_ring(sub(p, *center), unit(*axis), *ring)) <= *tube
            }
            Self::Any(parts) => parts.iter().any(|part| part.contains(p)),
            Self::All(parts) => parts.iter().all(|part| part.contains(p)),
            Self::Minus(left, right) => left.contains(p) && !right.contains(p),
        }
    }

    /// Every parameter at which the ray might cross the surface: caps are planes here, walls
    /// are infinite, and membership sorts out the rest.
    fn candidates(&self, ray: &Ray, found: &mut Vec<Crossing>) {
        match self {
            Self::Cylinder { from, to, radius } => {
                let axis = unit(sub(*to, *from));
                plane(ray, times(axis, -1.0), -dot(axis, *from), found);
                plane(ray, axis, dot(axis, *to), found);
                let reject = |v: V| sub(v, times(axis, dot(v, axis)));
                let (u, d) = (reject(sub(ray.origin, *from)), reject(ray.direction));
                quadratic(u, d, *radius, found);
            }
            Self::Cone { from, to, radii: [low, high] } => {
                let way = sub(*to, *from);
                let axis = unit(way);
                plane(ray, times(axis, -1.0), -dot(axis, *from), found);
                plane(ray, axis, dot(axis, *to), found);
                let slope = (high - low) / length(way);
                let reject = |v: V| sub(v, times(axis, dot(v, axis)));
                let u = sub(ray.origin, *from);
                let radius = low + slope * dot(u, axis);
                let growth = slope * dot(ray.direction, axis);
                nappes(reject(u), reject(ray.direction), [radius, growth], (axis, slope), found);
            }
            Self::Sphere { center, radius } => {
                quadratic(sub(ray.origin, *center), ray.direction, *radius, found);
            }
            Self::Slab { normal, low, high } => {
                let normal = unit(*normal);
                plane(ray, times(normal, -1.0), -low, found);
                plane(ray, normal, *high, found);
            }
            Self::Torus { center, axis, ring, tube } => {
                let way = |t| from_ring(sub(ray.at(t), *center), unit(*axis), *ring);
                let speed = length(ray.direction);
                let middle = dot(sub(*center, ray.origin), ray.direction) / (speed * speed);
                let half = (ring + tube) / speed;
                let distance = |t| (length(way(t)) - tube) / speed;
                let mut roots = Vec::new();
                zeros(&distance, [middle - half, middle + half], &mut roots);
                found.extend(roots.into_iter().map(|t| Crossing { t, normal: unit(way(t)) }));
            }
            Self::Any(parts) | Self::All(parts) => {
                parts.iter().for_each(|part| part.candidates(ray, found));
            }
            Self::Minus(left, right) => {
                left.candidates(ray, found);
                right.candidates(ray, found);
            }
        }
    }

    /// The pieces of the whole line inside the solid, in order, with a gap between any two.
    pub fn spans(&self, ray: &Ray) -> Vec<[Crossing; 2]> {
        let mut marks = Vec::new();
        self.candidates(ray, &mut marks);
        marks.sort_by(|a, b| a.t.total_cmp(&b.t));
        let mut spans: Vec<[Crossing; 2]> = Vec::new();
        let mut was_inside = false;
        for pair in marks.windows(2) {
            // A piece of a few rounding errors' length is one crossing found twice.
            if pair[1].t - pair[0].t < 1e-13 * (1.0 + pair[0].t.abs()) {
                continue;
            }
            let inside = self.contains(ray.at(0.5 * (pair[0].t + pair[1].t)));
            match spans.last_mut() {
                Some(span) if inside && was_inside => span[1] = pair[1],
                _ if inside => spans.push([pair[0], pair[1]]),
                _ => {}
            }
            was_inside = inside;
        }
        spans
    }

    /// The first crossing at or after `start`; its normal turned to the side that is seen.
    pub fn seen(&self, ray: &Ray, start: f64) -> Option<Crossing> {
        let seen = self.spans(ray).into_iter().flatten().find(|crossing| crossing.t >= start)?;
        let faces_away = dot(seen.normal, ray.direction) > 0.0;
        let normal = if faces_away { times(seen.normal, -1.0) } else { seen.normal };
        Some(Crossing { normal, ..seen })
    }
}

/// The way to a point from the nearest point of a circle around (0, 0, 0).
fn from_ring(u: V, axis: V, ring: f64) -> V {
    let across = sub(u, times(axis, dot(u, axis)));
    // On the axis, all points of the circle are as far.
    let far = length(across).max(1e-300);
    sub(u, times(across, ring / far))
}

/// Where a function changes its sign that changes by no more than its argument does: so halves that are
/// far from zero in their middle have none.
fn zeros(of: &impl Fn(f64) -> f64, [low, high]: [f64; 2], found: &mut Vec<f64>) {
    let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
    if of(middle).abs() > half * (1.0 + 1e-9) {
        return;
    }
    if half > 1e-6 {
        zeros(of, [low, middle], found);
        zeros(of, [middle, high], found);
        return;
    }
    let ([mut low, mut high], is_inside) = ([low, high], of(low) < 0.0);
    if is_inside != (of(high) < 0.0) {
        for _ in 0..40 {
            let middle = (low + high) / 2.0;
            if (of(middle) < 0.0) == is_inside { low = middle } else { high = middle }
        }
        found.push((low + high) / 2.0);
    }
}

/// `normal · p = offset`.
fn plane(ray: &Ray, normal: V, offset: f64, found: &mut Vec<Crossing>) {
    let speed = dot(normal, ray.direction);
    if speed != 0.0 {
        found.push(Crossing { t: (offset - dot(normal, ray.origin)) / speed, normal });
    }
}

/// |u + t·d| = r by the school's formula.
fn quadratic(u: V, d: V, radius: f64, found: &mut Vec<Crossing>) {
    let (a, b, c) = (dot(d, d), dot(u, d), dot(u, u) - radius * radius);
    let discriminant = b * b - a * c;
    if a > 0.0 && discriminant >= 0.0 {
        for root in [-discriminant.sqrt(), discriminant.sqrt()] {
            let t = (-b + root) / a;
            found.push(Crossing { t, normal: times(add(u, times(d, t)), 1.0 / radius) });
        }
    }
}

/// |u + t·d| = ±(r + t·g), with one root or two; the normal leans against the axis by the slope.
fn nappes(u: V, d: V, [r, g]: [f64; 2], (axis, slope): (V, f64), found: &mut Vec<Crossing>) {
    let (a, b, c) = (dot(d, d) - g * g, dot(u, d) - r * g, dot(u, u) - r * r);
    let discriminant = (b * b - a * c).max(0.0);
    // The larger of −b ± √D, so that neither root is lost where a is about zero.
    let s = -b - discriminant.sqrt().copysign(b);
    for t in [s / a, c / s] {
        let outward = unit(add(u, times(d, t)));
        let normal = unit(sub(outward, times(axis, slope)));
        if t.is_finite() {
            found.push(Crossing { t, normal });
        }
    }
}

/// A camera by the definition: pixel (x, y) sees a point of the plane through the target.
#[derive(Debug, Clone, Copy)]
pub struct Camera {
    pub target: V,
    /// Where the eye is; for an orthographic camera, only the way from there counts.
    pub eye: V,
    pub up: V,
    /// In the plane through the target.
    pub frame_height: f64,
    pub is_perspective: bool,
}

impl Camera {
    /// The ray whose parameter counts units along the viewing direction from the target's
    /// plane. `nudge` moves the pixel's point by scene units to the right and down.
    pub fn ray(&self, [x, y]: [u16; 2], [width, height]: [u16; 2], nudge: [f64; 2]) -> Ray {
        let forward = unit(sub(self.target, self.eye));
        let right = unit(cross(forward, self.up));
        let down = cross(forward, right);
        let half_pixel = self.frame_height / f64::from(height);
        let offset = |i: u16, n: u16| (f64::from(i) + 0.5 - f64::from(n) / 2.0) * half_pixel;
        let across = times(right, offset(x, width) + nudge[0]);
        let origin = add(self.target, add(across, times(down, offset(y, height) + nudge[1])));
        let direction = if self.is_perspective {
            times(sub(origin, self.eye), 1.0 / length(sub(self.target, self.eye)))
        } else {
            forward
        };
        Ray { origin, direction }
    }

    /// From the eye to the target; an orthographic camera has none.
    pub fn distance(&self) -> f64 {
        if self.is_perspective { length(sub(self.target, self.eye)) } else { 0.0 }
    }

    /// The smallest parameter that is seen.
    pub fn start(&self) -> f64 {
        if self.is_perspective { -self.distance() } else { f64::NEG_INFINITY }
    }

    /// The pixel's ray moved by `by` scene units in eight directions.
    pub fn rays_around(&self, pixel: [u16; 2], size: [u16; 2], by: f64) -> [Ray; 8] {
        std::array::from_fn(|i| {
            let (sin, cos) = (i as f64 * std::f64::consts::FRAC_PI_4).sin_cos();
            self.ray(pixel, size, [by * cos, by * sin])
        })
    }

    /// The pixel's ray moved likewise and not turned, so that it is as far off near the eye.
    pub fn rays_beside(&self, pixel: [u16; 2], size: [u16; 2], by: f64) -> [Ray; 8] {
        let Ray { direction, .. } = self.ray(pixel, size, [0.0; 2]);
        self.rays_around(pixel, size, by).map(|moved| Ray { direction, ..moved })
    }
}
