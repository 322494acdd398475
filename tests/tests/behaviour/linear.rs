//! Systems of linear equations, and Newton's method for the small models of the tests.

/// x with A x = b, by elimination with the largest pivot; `None` where A is singular to rounding.
pub fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    const SINGULAR: f64 = 1e-13;
    let n = b.len();
    let scale = a
        .iter()
        .flatten()
        .fold(0.0_f64, |most, v| most.max(v.abs()));
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        if a[pivot][k].abs() <= SINGULAR * scale {
            return None;
        }
        a.swap(k, pivot);
        b.swap(k, pivot);
        let (upper, lower) = a.split_at_mut(k + 1);
        for (row, i) in lower.iter_mut().zip(k + 1..) {
            let factor = row[k] / upper[k][k];
            if factor == 0.0 {
                continue;
            }
            for (entry, above) in row.iter_mut().zip(&upper[k]).skip(k) {
                *entry -= factor * above;
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    Some(b)
}

/// A zero of `system`, which returns residual and derivative, to `tolerance` in the largest entry of the
/// residual; `None` after 30 steps or where the derivative is singular.
pub fn newton(
    mut x: Vec<f64>,
    tolerance: f64,
    mut system: impl FnMut(&[f64]) -> (Vec<f64>, Vec<Vec<f64>>),
) -> Option<Vec<f64>> {
    for _ in 0..30 {
        let (residual, derivative) = system(&x);
        if residual.iter().all(|value| value.abs() <= tolerance) {
            return Some(x);
        }
        let step = solve(derivative, residual)?;
        for (value, step) in x.iter_mut().zip(step) {
            *value -= step;
        }
    }
    None
}

/// The value between `low`, where `holds` is true, and `high`, where it is false, at which it changes.
pub fn bisect(mut low: f64, mut high: f64, mut holds: impl FnMut(f64) -> bool) -> (f64, f64) {
    assert!(holds(low) && !holds(high));
    while high - low > 2.0 * f64::EPSILON * high.abs() {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low, high)
}
