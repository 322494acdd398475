//! Integration points of a slave.

use crate::model::{Domain, Geometry};

/// A point and its weight in the parameter domain.
pub type WeightedPoint = ([f64; 2], f64);

/// Gauss points of a geometry's domain: `counts` per direction, or in all on a triangle.
pub fn gauss(geometry: &Geometry, counts: &[usize]) -> Vec<WeightedPoint> {
    match geometry.domain {
        Domain::Interval(lower, upper) => line(lower, upper, counts[0])
            .into_iter()
            .map(|(x, w)| ([x, 0.0], w))
            .collect(),
        Domain::Rectangle(lower, upper) => {
            let first = line(lower[0], upper[0], counts[0]);
            let second = line(lower[1], upper[1], counts[1]);
            let mut points = Vec::new();
            for &(y, v) in &second {
                for &(x, w) in &first {
                    points.push(([x, y], w * v));
                }
            }
            points
        }
        Domain::Triangle => triangle(counts[0]),
        Domain::Unbounded => vec![],
    }
}

/// Gauss–Legendre points on [lower, upper]: exact for polynomials of degree 2n − 1.
fn line(lower: f64, upper: f64, n: usize) -> Vec<(f64, f64)> {
    let (middle, half) = (0.5 * (lower + upper), 0.5 * (upper - lower));
    (0..n)
        .map(|k| {
            let guess = (std::f64::consts::PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
            let x = refine(-guess, n);
            let (_, slope) = legendre(x, n);
            let weight = 2.0 / ((1.0 - x * x) * slope * slope);
            (middle + half * x, half * weight)
        })
        .collect()
}

fn refine(mut x: f64, n: usize) -> f64 {
    for _ in 0..20 {
        let (value, slope) = legendre(x, n);
        x -= value / slope;
    }
    if x.abs() < 1e-15 { 0.0 } else { x }
}

/// P_n(x) and its derivative by the three-term recurrence.
fn legendre(x: f64, n: usize) -> (f64, f64) {
    let (mut previous, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        let next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k;
        previous = value;
        value = next;
    }
    let slope = n as f64 * (x * value - previous) / (x * x - 1.0);
    (value, slope)
}

/// Symmetric rules on the unit triangle with 1, 3 and 6 points: exact for degree 1, 2 and 4.
fn triangle(n: usize) -> Vec<WeightedPoint> {
    let orbit = |a: f64, w: f64| {
        let b = 1.0 - 2.0 * a;
        [([a, a], w), ([b, a], w), ([a, b], w)]
    };
    match n {
        1 => vec![([1.0 / 3.0, 1.0 / 3.0], 0.5)],
        3 => orbit(1.0 / 6.0, 1.0 / 6.0).to_vec(),
        _ => {
            let root = 10f64.sqrt();
            let spread = (38.0 - 44.0 * 0.4f64.sqrt()).sqrt();
            let weight = (213_125.0 - 53_320.0 * root).sqrt();
            let outer = orbit((8.0 - root + spread) / 18.0, (620.0 + weight) / 7440.0);
            let inner = orbit((8.0 - root - spread) / 18.0, (620.0 - weight) / 7440.0);
            outer.into_iter().chain(inner).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ x^k over [0, 1] for all degrees up to 2n − 1, to 1e-15 relative.
    #[test]
    fn gauss_integrates_polynomials() {
        for n in 1..=10 {
            for degree in 0..2 * n as i32 {
                let sum: f64 = line(0.0, 1.0, n)
                    .iter()
                    .map(|(x, w)| w * x.powi(degree))
                    .sum();
                let exact = 1.0 / f64::from(degree + 1);
                assert!((sum - exact).abs() < 2e-15, "{n} points, degree {degree}");
            }
        }
    }

    /// ∫ x^i y^j over the unit triangle = i! j!/(i + j + 2)!.
    #[test]
    fn triangle_rules_integrate_polynomials() {
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        for (n, degree) in [(1, 1), (3, 2), (6, 4)] {
            for i in 0..=degree {
                for j in 0..=degree - i {
                    let sum: f64 = triangle(n)
                        .iter()
                        .map(|(x, w)| w * x[0].powi(i) * x[1].powi(j))
                        .sum();
                    let exact = factorial(i) * factorial(j) / factorial(i + j + 2);
                    assert!((sum - exact).abs() < 1e-15, "{n} points, x^{i} y^{j}");
                }
            }
        }
    }
}
