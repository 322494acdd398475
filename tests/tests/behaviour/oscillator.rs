//! A block on a plane in motion: the time steps are those of Verlet's rule, the friction that of the element.

use contact_elements::runtime::Status;

use crate::pair::Pair;

/// A block of mass 1 pressed on a plane.
struct Block {
    pair: Pair,
    depth: f64,
    x: f64,
    v: f64,
}

impl Block {
    /// At rest at `x`, held back by the friction `held`; `bound` = μ p; `eps_t` makes the elastic part
    /// bound/eps_t.
    fn new(x: f64, held: f64, bound: f64, eps_t: f64) -> Self {
        let given = [("eps_n", 1e3), ("eps_t", eps_t), ("mu", 0.1)];
        let mut pair = Pair::new("PointPlaneCoulomb", &given);
        let depth = bound / 0.1 / 1e3;
        pair.step(&[x - held / eps_t, 0.0, -depth]);
        Self {
            pair,
            depth,
            x,
            v: 0.0,
        }
    }

    /// One step of Verlet's rule under the force `load` of position and time; velocities are those
    /// between the steps. While the block sticks a dashpot ends the vibration of the elastic part.
    fn step(&mut self, (t, dt): (f64, f64), damping: f64, load: impl Fn(f64, f64) -> f64) {
        let state = self.pair.step(&[self.x, 0.0, -self.depth]);
        let mut force = load(self.x, t) - state.residual[0];
        if state.status() == Status::Stick {
            force -= damping * self.v;
        }
        self.v += if t == 0.0 { 0.5 } else { 1.0 } * dt * force;
        self.x += dt * self.v;
    }
}

/// A spring of 1e4 lets go at 0.85e-3: turning points 0.2e-3 nearer each time, and rest where the spring
/// cannot move the block any more. Turning points and rest miss the elastic part δ = 1e-8 a few times; the
/// reversal of the friction takes the time √(4 δ/a) = 7e-5, which is 7e-3 of the phase or 5e-6 on the way.
#[test]
fn a_spring_and_friction_come_to_rest() {
    const K: f64 = 1e4;
    let turns = [0.85e-3, -0.65e-3, 0.45e-3, -0.25e-3, 0.05e-3];
    // steps of 1/3200 of half a period, and positions after them
    let samples = [
        (800_u32, 0.00063033008588991064),
        (1600, 0.0001),
        (4160, -0.00042328188876086022),
        (8320, -8.1559480312315984e-6),
    ];
    let dt = std::f64::consts::PI / 100.0 / 3200.0;
    let mut block = Block::new(turns[0], -1.0, 1.0, 1e8);
    let mut most = [0.0_f64; 2];
    for step in 0..16000 {
        block.step((dt * f64::from(step), dt), 0.0, |x, _| -K * x);
        let at = step + 1;
        if at % 3200 == 0 && at / 3200 < 5 {
            most[0] = most[0].max((block.x - turns[at as usize / 3200]).abs());
        }
        if let Some((_, x)) = samples.iter().find(|sample| sample.0 == at) {
            most[1] = most[1].max((block.x - x).abs());
        }
    }
    let rest = (block.x - turns[4]).abs();
    println!(
        "oscillator: turning points {:.1e}, on the way {:.1e}, rest {rest:.1e} of 0.85e-3",
        most[0], most[1]
    );
    assert!(most[0] < 1e-7 && rest < 1e-7);
    assert!(most[1] < 5e-6);
}

/// Under 8 cos t with a bound of 4.905: where it stops, sticks for a while, and moves on the other way. The
/// elastic part is 5e-6; a fraction of it is gained or lost at every stop and start.
#[test]
fn a_driven_block_stops_and_goes() {
    // it sticks from, to, at
    let rests = [
        (1.6282935606627265, 2.2308066408952806, 1.9573133171925050),
        (5.0552982112819289, 5.3723994844850739, -3.9225435953151768),
        (8.1968908648717221, 8.5139919480748671, 1.9573133171925050),
        (11.338483518461515, 11.655584601664660, -3.9225435953151768),
    ];
    let dt = 2e-4;
    let mut block = Block::new(0.0, 4.905, 4.905, 1e6);
    let mut most: f64 = 0.0;
    for step in 0..58200_u32 {
        let t = dt * f64::from(step);
        for (from, to, x) in rests {
            // a twentieth after the stop and before the start
            let margin = 0.05 * (to - from);
            if from + margin < t && t < to - margin {
                most = most.max((block.x - x).abs());
            }
        }
        block.step((t, dt), 2e3, |_, t| 8.0 * t.cos());
    }
    println!("oscillator: driven block, positions of rest {most:.1e} of 5.9");
    assert!(most < 1e-4);
}
