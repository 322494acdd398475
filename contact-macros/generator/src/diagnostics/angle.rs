//! Messages about the angle of two curves.

use super::Diagnostic;

/// An angle of a pair that is not two curves with nodes in space.
pub fn angle_without_curves() -> Diagnostic {
    Diagnostic::new(
        "`angle` needs two curves with nodes in three dimensions",
        "remove `angle`, or name two curves: `slave: Hermite; master: Hermite; gap: distance;` for large angles, \
         `slave: Hermite at gauss(3); master: Hermite;` for small ones",
    )
}

/// An angle of edges.
pub fn angle_of_edges() -> Diagnostic {
    Diagnostic::new(
        "`angle` needs `gap: distance`: nearly parallel edges have no normal",
        "write `gap: distance;` for beams (no sign, radii in r0)",
    )
}

/// An angle with friction or rolling.
pub fn angle_with_friction() -> Diagnostic {
    Diagnostic::new(
        "`angle` is not offered with `tangential` or `rolling`",
        "remove `tangential` and `rolling`, or `angle`",
    )
}

/// An angle on the tangent plane.
pub fn angle_on_tangent_plane() -> Diagnostic {
    Diagnostic::new(
        "`angle` has no `linearisation: tangent_plane`",
        "remove `linearisation`: the exact tangent holds at any distance",
    )
}

/// An angle with a multiplier.
pub fn angle_with_multiplier() -> Diagnostic {
    Diagnostic::new(
        "`angle` is offered with `enforcement: penalty` only",
        "remove `enforcement`: the weight blends the energy of a law",
    )
}

/// An angle with a moving measure.
pub fn angle_with_current_measure() -> Diagnostic {
    Diagnostic::new(
        "`angle` is not offered with `measure: current`",
        "remove `measure`: with the reference measure the force derives from an energy",
    )
}

/// An angle with a law that declares no energy.
pub fn angle_without_energy(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!("`angle` blends energies, but `{law}` declares none"),
        "declare its energy, `W = ...;` with dW/dg = N, zero where contact begins",
    )
}

/// An angle with a law whose energy is not zero where contact begins.
pub fn angle_with_jump_of_energy(law: &str) -> Diagnostic {
    Diagnostic::new(
        format!(
            "`angle` needs an energy that is zero where contact begins, but that of `{law}` is not"
        ),
        "subtract its value there from `W`: the force that turns the curves is proportional to W",
    )
}
