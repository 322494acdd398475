//! Vectors of three components.

pub type Vector = [f64; 3];

pub fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn scaled(factor: f64, a: Vector) -> Vector {
    a.map(|component| factor * component)
}

pub fn subtract(a: Vector, b: Vector) -> Vector {
    add(a, scaled(-1.0, b))
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub fn unit(a: Vector) -> Vector {
    scaled(1.0 / length(a), a)
}

/// `a` turned by `angle` about the unit vector `axis`.
pub fn turned(a: Vector, axis: Vector, angle: f64) -> Vector {
    let (s, c) = angle.sin_cos();
    let along = scaled((1.0 - c) * dot(axis, a), axis);
    add(add(scaled(c, a), along), scaled(s, cross(axis, a)))
}

/// Polar angle of the first two components in degrees.
pub fn degrees(a: &[f64]) -> f64 {
    a[1].atan2(a[0]).to_degrees()
}

/// Largest |a_i − b_i|.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// Largest |a_i|.
pub fn largest(a: &[f64]) -> f64 {
    a.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Largest |a_i − b_i| relative to the largest |b_i|.
pub fn relative(a: &[f64], b: &[f64]) -> f64 {
    difference(a, b) / largest(b)
}

/// The values with two digits, for the lines that tests print.
pub fn list(values: &[f64]) -> String {
    let values: Vec<_> = values.iter().map(|value| format!("{value:.1e}")).collect();
    values.join(", ")
}
