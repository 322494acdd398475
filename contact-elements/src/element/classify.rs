//! First pass over a contact point: projection, gap, open or closed. It writes no output.

use crate::arithmetic::abs;
use crate::element::angle;
use crate::element::edge_side::side;
use crate::element::pass::Pass;
use crate::element::receiver::Receiver;
use crate::element::rolling::roll;
use crate::element::sliding::{Touch, slide};
use crate::element::traits::Element;
use crate::point::blend::Blend;
use crate::point::enforcement::enforced;
use crate::point::friction::TangentialLaw;
use crate::point::history::{History, HistoryLayout, is_load};
use crate::point::law::{LARGEST_VALUE, NormalLaw, Traction};
use crate::point::projection::foot::{Projected, largest};
use crate::point::projection::newton::project;
use crate::point::state::{Point, Sliding};
use crate::point::values::{Gap, Status, Vectors, is_zero};

impl<E: Element<D, P, H>, R: Receiver, const D: usize, const P: usize, const H: usize>
    Pass<'_, '_, E, R, D, P, H>
{
    /// First pass: projection, gap, status. `state` is what friction leaves.
    #[inline(always)]
    pub(crate) fn classify(
        &mut self,
        number: usize,
        state: &mut Sliding<P>,
    ) -> Result<Point<D, P, H>, Status> {
        self.load_slave(number);
        let (call, x) = (self.call, self.stage.x);
        let history = call
            .history
            .and_then(|history| history.from(number * E::HISTORY));
        let given = call.wanted.projection_given;
        let start = start::<E, D, P, H>(history, given);
        let rows = &mut self.stage.rows;
        let mut point = match project::<E, D, P, H>(x, start, given, call.parameters, rows) {
            Ok(projected) => outside(projected),
            Err(status) if E::ANGLE => {
                let stage = &mut *self.stage;
                return angle::without_projection::<E, D, P, H>(call, stage, number, start, status);
            }
            Err(status) => return Err(status),
        };
        let mut weight = [1.0, 0.0, 0.0];
        if E::ANGLE {
            weight = angle::weight::<E, D, P, H>(number, x, &point.vectors, call.parameters)?;
            if weight[0] <= 0.0 {
                return Ok(self.silent(&point));
            }
        }
        self.measure_gap(number, history, &mut point)?;
        if point.feature != 0 {
            return Ok(point);
        }
        if !self.is_closed(history, &point) {
            point.status = Status::Open;
            return Ok(point);
        }
        self.load(number, &mut point, state)?;
        if E::ANGLE {
            angle::weigh(&mut point, weight);
        }
        if call.wanted.tangent && !has_derivatives(&point.vectors) {
            return Err(Status::Degenerate);
        }
        Ok(point)
    }

    /// A point that the angle of the curves leaves without weight.
    #[inline(always)]
    fn silent(&self, point: &Point<D, P, H>) -> Point<D, P, H> {
        let mut silent = angle::open(point.zeta, point.vectors, point.iterations);
        if angle::has_normal(self.stage.x, &silent.vectors) {
            silent.gap = E::gap(&silent.vectors, self.call.parameters, 1.0);
        }
        silent
    }

    /// True where a multiplier stands beside the law.
    const HAS_MULTIPLIER: bool = E::AUGMENTED || E::MULTIPLIER;

    /// Normal and gap of a projected point; law and multiplier, where it has one.
    #[inline(always)]
    fn measure_gap(
        &self,
        number: usize,
        history: Option<History<'_>>,
        point: &mut Point<D, P, H>,
    ) -> Result<(), Status> {
        let (x, parameters) = (self.stage.x, self.call.parameters);
        if !E::SIGNED && is_zero(&point.vectors.r, largest(x)) {
            return Err(Status::Degenerate);
        }
        if !E::is_regular(number, x, &point.vectors, parameters) {
            return Err(Status::Degenerate);
        }
        point.orientation = side::<E, D, P, H>(history, &point.vectors, point.feature, parameters)?;
        point.gap = E::gap(&point.vectors, parameters, point.orientation);
        if !(is_finite(&point.gap.n) & is_finite(&[point.gap.gap])) {
            return Err(Status::Degenerate);
        }
        if Self::HAS_MULTIPLIER {
            point.multiplier = self.multiplier(history, number);
            let law = law::<E, D, P, H>(point.gap.gap, parameters)?;
            point.law = enforced(law, point.multiplier, E::MULTIPLIER).ok_or(Status::Law)?;
        }
        Ok(())
    }

    /// λ: an unknown, or from the history.
    #[inline(always)]
    fn multiplier(&self, history: Option<History<'_>>, number: usize) -> f64 {
        if E::MULTIPLIER {
            return self.stage.multipliers.get(number).copied().unwrap_or(0.0);
        }
        let at = E::HISTORY_LAYOUT.multiplier_at();
        history.map_or(0.0, |history| history.at(at))
    }

    /// True where a point within the domain is in contact.
    #[inline(always)]
    fn is_closed(&self, history: Option<History<'_>>, point: &Point<D, P, H>) -> bool {
        match (self.call.wanted.freeze, history) {
            (true, Some(history)) => is_load(history.at(HistoryLayout::STATUS)),
            _ if Self::HAS_MULTIPLIER => point.law.traction < 0.0,
            _ => E::Law::active(point.gap.gap, self.call.parameters) > 0.0,
        }
    }

    /// Law of a point in contact; with friction its slip, with rolling its moments.
    #[inline(always)]
    fn load(
        &self,
        number: usize,
        point: &mut Point<D, P, H>,
        state: &mut Sliding<P>,
    ) -> Result<(), Status> {
        point.status = Status::Closed;
        if !Self::HAS_MULTIPLIER {
            point.law = law::<E, D, P, H>(point.gap.gap, self.call.parameters)?;
        }
        if E::Tangential::ACTIVE {
            // copies: arguments of a call would be kept in memory on every path
            let touch = Touch {
                number,
                nodes: if E::SLAVE_AXIS { self.stage.x } else { &[] },
                zeta: point.zeta,
                vectors: point.vectors,
                gap: point.gap,
                traction: point.law.traction,
            };
            point.status = slide::<E, D, P, H>(self.call, &touch, state)?;
            if E::ROLLING.is_some() {
                roll::<E, D, P, H>(self.call, self.stage.x, number, point, state)?;
            }
        }
        Ok(())
    }
}

/// A point that is only projected.
#[inline(always)]
fn outside<const D: usize, const P: usize, const H: usize>(
    projected: Projected<D, P, H>,
) -> Point<D, P, H> {
    Point {
        status: Status::Outside,
        feature: projected.feature,
        zeta: projected.zeta,
        vectors: projected.vectors,
        gap: Gap::default(),
        orientation: 1.0,
        law: Traction::default(),
        blend: Blend::default(),
        multiplier: 0.0,
        iterations: projected.iterations,
    }
}

/// Where the search begins: at the last projection, or at the centre.
#[inline(always)]
fn start<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    history: Option<History<'_>>,
    given: bool,
) -> [f64; P] {
    let Some(history) = history else {
        return E::centre();
    };
    let projection = core::array::from_fn(|i| history.at(HistoryLayout::PROJECTION + i));
    E::REACH.start(history.at(HistoryLayout::STATUS), projection, given)
}

/// N, N' and W of a closed point, if the law is defined and its values are small enough to form forces.
#[inline(always)]
fn law<E: Element<D, P, H>, const D: usize, const P: usize, const H: usize>(
    gap: f64,
    parameters: &[f64],
) -> Result<Traction, Status> {
    if E::Law::valid(gap, parameters) <= 0.0 {
        return Err(Status::Law);
    }
    let law = E::Law::evaluate(gap, parameters);
    let mut usable = true;
    for value in [law.traction, law.slope, law.energy] {
        // false for NaN
        usable &= abs(value) <= LARGEST_VALUE;
    }
    if usable { Ok(law) } else { Err(Status::Law) }
}

/// The tangents and second derivatives are finite.
#[inline(always)]
fn has_derivatives<const D: usize, const P: usize, const H: usize>(
    vectors: &Vectors<D, P, H>,
) -> bool {
    // no chain of the two: with its running pointer the vectors could not stay in registers
    let mut finite = true;
    for vector in &vectors.b {
        finite &= is_finite(vector);
    }
    for vector in &vectors.second {
        finite &= is_finite(vector);
    }
    finite
}

#[inline(always)]
fn is_finite<const N: usize>(values: &[f64; N]) -> bool {
    let mut finite = true;
    for &value in values {
        finite &= abs(value) <= f64::MAX;
    }
    finite
}
