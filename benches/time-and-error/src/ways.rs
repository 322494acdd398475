//! Ways to residual and tangent of the same state.

use std::hint::black_box;
use std::marker::PhantomData;

use contact_verify::oracle::solve;
use nalgebra::{Const, SMatrix, SVector};
use num_dual::{Dual2Vec, DualSVec, HyperDual64, hessian, jacobian};

use crate::Failure;
use crate::case::{Answer, Request};
use crate::pairs::{Number, Pair, energy, project, residual};
use crate::states::State;

/// A way of pairs with N nodes.
pub struct Way<const N: usize> {
    /// Name.
    pub name: String,
    /// Which line of a diagram it belongs to.
    pub family: &'static str,
    run: Runner<N>,
}

type Runner<const N: usize> = Box<dyn Fn(&State<N>, &mut Answer)>;

impl<const N: usize> Way<N> {
    fn new(
        name: impl Into<String>,
        family: &'static str,
        run: impl Fn(&State<N>, &mut Answer) + 'static,
    ) -> Self {
        Self {
            name: name.into(),
            family,
            run: Box::new(run),
        }
    }

    /// Evaluates a state.
    pub fn run(&self, state: &State<N>, answer: &mut Answer) {
        (self.run)(state, answer);
        black_box(answer);
    }

    /// Largest and median error of R and K.
    pub fn errors(&self, states: &[State<N>]) -> [[f64; 2]; 2] {
        let one = |state: &State<N>| {
            let mut answer = Answer::of(&state.case);
            self.run(state, &mut answer);
            state.truth.errors(&answer.residual, &answer.tangent)
        };
        largest_and_median(states.iter().map(one).collect())
    }
}

/// Largest and median of both entries.
pub fn largest_and_median(errors: Vec<[f64; 2]>) -> [[f64; 2]; 2] {
    [0, 1].map(|k| {
        let mut column: Vec<f64> = errors.iter().map(|error| error[k]).collect();
        column.sort_by(f64::total_cmp);
        [column[column.len() - 1], column[column.len() / 2]]
    })
}

/// The generated element with its own projection: the reference of all ratios.
pub const GENERATED: &str = "generated";
/// The generated element with the projection given.
pub const GIVEN: &str = "generated, projection given";
/// Steps of the differences, relative to the size of the state.
const STEPS: [f64; 7] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// A pair of N nodes and U unknowns.
pub struct ByTools<P, const N: usize, const U: usize>(PhantomData<P>);

impl<P: Pair<N> + 'static, const N: usize, const U: usize> ByTools<P, N, U> {
    /// All ways.
    pub fn ways() -> Vec<Way<N>> {
        let mut ways = vec![
            Way::new(GENERATED, "generated", |state: &State<N>, answer| {
                state.case.evaluate(Request::BOTH, answer);
            }),
            Way::new(GIVEN, "generated", |state: &State<N>, answer| {
                state.given.evaluate(Request::GIVEN, answer);
            }),
            Way::new(
                "generated, tangent plane",
                "tangent plane",
                |state: &State<N>, answer| {
                    state.tangent_plane.evaluate(Request::BOTH, answer);
                },
            ),
            Way::new("duals: Jacobian of R", "duals", Self::duals),
            Way::new("second-order duals: Hessian of W", "duals", Self::second),
            Way::new("hyper-duals: W by pairs", "hyper-duals", Self::hyper),
            Way::new("hyper-duals: oracle of the proof", "hyper-duals", oracle),
        ];
        for step in STEPS {
            let run = move |state: &State<N>, answer: &mut Answer| {
                Self::differences(step, state, answer);
            };
            let name = format!("central differences, {step:.0e}");
            ways.push(Way::new(name, "differences", run));
        }
        ways
    }

    fn vector(state: &State<N>) -> SVector<f64, U> {
        SVector::from_iterator(state.x.iter().flatten().copied())
    }

    fn duals(state: &State<N>, answer: &mut Answer) {
        let z = project::<P, N>(&state.x, state.start);
        let of = |x: SVector<DualSVec<f64, U>, U>| -> SVector<DualSVec<f64, U>, U> {
            let residual = residual::<P, _, N>(&nodes(x.as_slice()), z, &state.law);
            SVector::from_iterator(residual.into_iter().flatten())
        };
        let (r, k): (SVector<f64, U>, SMatrix<f64, U, U>) = jacobian(of, &Self::vector(state));
        answer.residual.copy_from_slice(r.as_slice());
        answer.tangent.copy_from_slice(k.transpose().as_slice());
    }

    fn second(state: &State<N>, answer: &mut Answer) {
        let z = project::<P, N>(&state.x, state.start);
        let of = |x: SVector<Dual2Vec<f64, Const<U>>, U>| {
            energy::<P, _, N>(&nodes(x.as_slice()), z, &state.law)
        };
        let (_, r, k) = hessian(of, &Self::vector(state));
        answer.residual.copy_from_slice(r.as_slice());
        answer.tangent.copy_from_slice(k.as_slice());
    }

    fn hyper(state: &State<N>, answer: &mut Answer) {
        let z = project::<P, N>(&state.x, state.start);
        let mut x = state.x.map(|node| node.map(HyperDual64::from_re));
        for i in 0..U {
            x[i / 3][i % 3].eps1 = 1.0;
            for j in i..U {
                x[j / 3][j % 3].eps2 = 1.0;
                let w = energy::<P, _, N>(&x, z, &state.law);
                answer.residual[i] = w.eps1;
                answer.tangent[U * i + j] = w.eps1eps2;
                answer.tangent[U * j + i] = w.eps1eps2;
                x[j / 3][j % 3].eps2 = 0.0;
            }
            x[i / 3][i % 3].eps1 = 0.0;
        }
    }

    fn differences(step: f64, state: &State<N>, answer: &mut Answer) {
        let z = project::<P, N>(&state.x, state.start);
        let plain = |x: &[[f64; 3]; N], z: [f64; 2]| residual::<P, f64, N>(x, z, &state.law);
        let here = plain(&state.x, z);
        answer.residual.copy_from_slice(here.as_flattened());
        let h = step * state.size;
        let mut x = state.x;
        for j in 0..U {
            let at = x[j / 3][j % 3];
            let mut moved = |by: f64| {
                x[j / 3][j % 3] = at + by;
                plain(&x, project::<P, N>(&x, z))
            };
            let (up, down) = (moved(h), moved(-h));
            x[j / 3][j % 3] = at;
            let both = up.as_flattened().iter().zip(down.as_flattened());
            for (i, (up, down)) in both.enumerate() {
                answer.tangent[U * i + j] = (up - down) / (2.0 * h);
            }
        }
    }
}

fn oracle<const N: usize>(state: &State<N>, answer: &mut Answer) {
    let found = solve::evaluate(&state.configuration.pair, &state.configuration.state());
    if let Ok(found) = found {
        answer.residual.copy_from_slice(&found.residual);
        answer.tangent.copy_from_slice(&found.tangent);
    }
}

fn nodes<D: Number, const N: usize>(x: &[D]) -> [[D; 3]; N] {
    std::array::from_fn(|node| std::array::from_fn(|c| x[3 * node + c]))
}

/// Ways that give a residual and tangent which is wrong by more than rounding are wrong themselves.
///
/// # Errors
/// Where an exact way is not exact.
pub fn must_be_exact<const N: usize>(way: &Way<N>, errors: [[f64; 2]; 2]) -> Result<(), Failure> {
    const LIMIT: f64 = 1e-9;
    let approximate = ["tangent plane", "differences"].contains(&way.family);
    let worst = if approximate {
        errors[0][0]
    } else {
        errors[0][0].max(errors[1][0])
    };
    if worst < LIMIT {
        Ok(())
    } else {
        Err(format!("{}: error {worst:.1e}", way.name).into())
    }
}
