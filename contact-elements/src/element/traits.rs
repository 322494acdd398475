//! The contract between the emitted code of an element and the driver.

use crate::arithmetic::abs;
use crate::lanes::Real;
use crate::point::blend::{AngleCoefficients, AngleForm, Blend};
use crate::point::domain::Domain;
use crate::point::friction::{Tangential, TangentialLaw};
use crate::point::history::{HistoryLayout, Reach};
use crate::point::law::{NormalLaw, Traction};
use crate::point::motion::{
    Rolling, RollingAngles, RollingCoefficients, RollingForce, RollingLayout,
};
use crate::point::tangential::{TangentialCoefficients, TangentialForce};
use crate::point::values::{Coefficients, Enforcement, Frame, Gap, Measure, Rows, Status, Vectors};

/// How the projection is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// Newton from the given start.
    Newton,
    /// The pair is affine: one linear solve.
    Affine,
    /// A closed form in the declaration, or no projection at all.
    Closed,
}

/// Where the groups of parameters begin in an element's list; the normal law's come first.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Tangential law.
    pub tangential: usize,
    /// Offset r0.
    pub r0: usize,
    /// Orientation ±1 (0 stands for +1), with a signed or oriented gap.
    pub orientation: Option<usize>,
    /// Parameters of a rigid geometry.
    pub geometry: usize,
    /// Weights of a rational master.
    pub master_weights: usize,
    /// Weights of a rational slave.
    pub slave_weights: usize,
    /// Parameters of the integration point and its weight, where given at run time.
    pub point: usize,
    /// Components w^i of a convected axis.
    pub axis: Option<usize>,
    /// Placement of a rigid geometry.
    pub placement: Option<usize>,
    /// Number of parameters.
    pub count: usize,
}

/// True where every divisor is finite and at least `least` in magnitude.
#[inline(always)]
pub fn can_divide<const N: usize>(divisors: &[f64; N], least: f64) -> bool {
    let mut can = true;
    for &divisor in divisors {
        can &= abs(divisor) >= least && abs(divisor) <= f64::MAX;
    }
    can
}

/// An element in D dimensions with P projected parameters, H = P(P+1)/2.
pub trait Element<const D: usize, const P: usize, const H: usize> {
    /// Normal law; its parameters come first.
    type Law: NormalLaw;
    /// Tangential law.
    type Tangential: TangentialLaw;
    /// Parameter list.
    const LAYOUT: Layout;
    /// How the projection is found.
    const SEARCH: Search;
    /// False where no unknown turns the tangents (rigid masters).
    const MOVING: bool;
    /// False where r_,11, r_,12 or r_,22 vanishes identically.
    const CURVED: [bool; 3];
    /// True for a gap with a sign.
    const SIGNED: bool;
    /// True where the measure moves with the slave.
    const CURRENT: bool;
    /// How the normal law holds the bodies apart.
    const ENFORCEMENT: Enforcement;
    /// Slave nodes; 0 if the call gives them.
    const SLAVE_NODES: usize;
    /// Master nodes; 0 if rigid.
    const MASTER_NODES: usize;
    /// True where the slave's tangent is an axis of the tangential law.
    const SLAVE_AXIS: bool;
    /// Periods of the parameters that a closed projection gives up to whole turns; 0 if not periodic.
    const PERIODS: [f64; 2];
    /// Domains of the projected parameters: slave curve first where both are projected.
    const DOMAINS: [Domain; 2];
    /// What parallel tangents mean: degenerate for a facet, not unique for two curves.
    const PARALLEL: Status;

    /// Where the parameters of rolling begin; `None` if two curves roll freely.
    const ROLLING: Option<RollingLayout> = None;

    /// True where the contact is weighted by the angle of two curves.
    const ANGLE: bool = false;

    /// The history of a contact point.
    const HISTORY_LAYOUT: HistoryLayout = HistoryLayout::new(
        P,
        Self::Tangential::ACTIVE,
        Self::ROLLING.is_some(),
        Self::KEEPS_SIDE,
        Self::AUGMENTED,
    );

    /// Doubles of history per contact point.
    const HISTORY: usize = Self::HISTORY_LAYOUT.size();

    /// True for edges of solids, whose side the history keeps.
    const KEEPS_SIDE: bool = Self::SIGNED && Self::TWO_CURVES;

    /// True where the history carries a multiplier.
    const AUGMENTED: bool = matches!(Self::ENFORCEMENT, Enforcement::Augmented);

    /// True where the multipliers are unknowns.
    const MULTIPLIER: bool = matches!(Self::ENFORCEMENT, Enforcement::Multiplier);

    /// Start of the projection if the call gives none.
    const START: [f64; 2] = if Self::TWO_CURVES {
        [Self::DOMAINS[0].centre()[0], Self::DOMAINS[1].centre()[0]]
    } else {
        Self::DOMAINS[0].centre()
    };

    /// Extents of the projected parameters.
    const EXTENTS: [f64; 2] = if Self::TWO_CURVES {
        [Self::DOMAINS[0].extent(0), Self::DOMAINS[1].extent(0)]
    } else {
        [Self::DOMAINS[0].extent(0), Self::DOMAINS[0].extent(1)]
    };

    /// How far a history may lead.
    const REACH: Reach = Reach {
        centre: Self::START,
        extent: Self::EXTENTS,
    };

    /// [`Element::START`] as parameters.
    #[inline(always)]
    fn centre() -> [f64; P] {
        Self::REACH.centre()
    }

    /// True where ζ = (slave curve, master curve).
    const TWO_CURVES: bool;

    /// Extent of parameter i's domain; infinite where an end is missing.
    #[inline(always)]
    fn extent(i: usize) -> f64 {
        Self::EXTENTS[i]
    }

    /// 0 inside the domain, else the feature beyond which the projection lies: 1 + edge or 5 + vertex;
    /// for two curves 1 + end (slave 0, 1, master 2, 3), or 5 + slave end + 2 × master end beyond both.
    #[inline(always)]
    fn feature(zeta: &[f64; P]) -> u8 {
        const SLACK: f64 = 1e-12;
        if P == 0 {
            return 0;
        }
        let first = zeta[0];
        let last = zeta[P - 1];
        if !Self::TWO_CURVES {
            return Self::DOMAINS[0].feature([first, last], SLACK);
        }
        let slave = Self::DOMAINS[0].feature([first, 0.0], SLACK);
        let master = Self::DOMAINS[1].feature([last, 0.0], SLACK);
        match (slave, master) {
            (0, 0) => 0,
            (end, 0) => end - 4,
            (0, end) => end - 2,
            (slave, master) => slave + 2 * (master - 5),
        }
    }

    /// Writes the fixed row of the slave's point; does nothing if the point is projected or comes with the call.
    fn slave<T: Real>(point: usize, parameters: &[T], s: &mut [T]);

    /// Kinematics at ζ; fills the rows of the nodes that depend on it.
    fn kinematics<T: Real>(
        x: &[[T; D]],
        zeta: &[T; P],
        parameters: &[T],
        rows: &mut Rows<'_, P, T>,
    ) -> Vectors<D, P, H, T>;

    /// Closed projection of the slave's point.
    fn closed_projection(x: &[f64; D], parameters: &[f64]) -> [f64; P];

    /// False where a divisor of `gap`, `tangent` or `measure` vanishes: on a master's axis, or for a
    /// slave without area.
    #[inline(always)]
    #[allow(unused_variables)]
    fn is_regular(
        point: usize,
        x: &[[f64; D]],
        vectors: &Vectors<D, P, H>,
        parameters: &[f64],
    ) -> bool {
        true
    }

    /// Normal, distance and gap. [eq:gap]
    fn gap<T: Real>(vectors: &Vectors<D, P, H, T>, parameters: &[T], orientation: T) -> Gap<D, T>;

    /// Coefficients of the tangent.
    fn tangent<T: Real>(
        vectors: &Vectors<D, P, H, T>,
        gap: &Gap<D, T>,
        traction: &Traction<T>,
        parameters: &[T],
        orientation: T,
    ) -> Coefficients<D, P, T>;

    /// Frame and slip of a point whose parameters moved by ζ − ζ_st since the anchor. [eq:frame] [eq:slip]
    #[inline(always)]
    #[allow(unused_variables)]
    fn frame(
        point: usize,
        x: &[[f64; D]],
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        moved: &[f64; P],
        parameters: &[f64],
    ) -> Frame<P> {
        Frame::default()
    }

    /// Coefficients of the tangential residual. [eq:tangential-residual]
    #[inline(always)]
    #[allow(unused_variables)]
    fn tangential_force(
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        frame: &Frame<P>,
        tangential: &Tangential,
    ) -> TangentialForce<D, P> {
        TangentialForce::default()
    }

    /// r_,111, r_,112, r_,122, r_,222; fills the rows s_A,ij of the nodes.
    #[inline(always)]
    #[allow(unused_variables)]
    fn higher(
        x: &[[f64; D]],
        zeta: &[f64; P],
        parameters: &[f64],
        second: &mut [&mut [f64]; H],
    ) -> [[f64; D]; 4] {
        [[0.0; D]; 4]
    }

    /// Writes the row of the slave's tangent, where it is an axis.
    #[inline(always)]
    #[allow(unused_variables)]
    fn slave_direction(point: usize, parameters: &[f64], row: &mut [f64]) {}

    /// Coefficients of the tangential tangent; `slope`: N'. [eq:tangential-tangent]
    #[inline(always)]
    #[allow(unused_variables)]
    fn tangential_tangent(
        (point, x): (usize, &[[f64; D]]),
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        frame: &Frame<P>,
        third: &[[f64; D]; 4],
        (tangential, slope): (&Tangential, f64),
        parameters: &[f64],
    ) -> TangentialCoefficients<D, P, H> {
        TangentialCoefficients::default()
    }

    /// Angles about both curves. [eq:rolling-angle]
    #[inline(always)]
    #[allow(unused_variables)]
    fn rolling_angles(
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        parameters: &[f64],
    ) -> RollingAngles {
        RollingAngles::default()
    }

    /// Moment at an angle since its anchor, `parameters` from the law's own on.
    #[inline(always)]
    #[allow(unused_variables)]
    fn rolling_law(
        angle: f64,
        pressure: f64,
        path: f64,
        parameters: &[f64],
        forced: Option<Status>,
    ) -> Result<(Status, Tangential), Status> {
        Ok((Status::Stick, Tangential::default()))
    }

    /// Coefficients of the residual of the moments. [eq:rolling-residual]
    #[inline(always)]
    #[allow(unused_variables)]
    fn rolling_force(
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        frame: &Frame<P>,
        third: &[[f64; D]; 4],
        rolling: &Rolling,
        parameters: &[f64],
    ) -> RollingForce<D, P> {
        RollingForce::default()
    }

    /// Coefficients of the tangent of the moments; `slope`: N'. [eq:rolling-tangent]
    #[inline(always)]
    #[allow(unused_variables)]
    fn rolling_tangent(
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        frame: &Frame<P>,
        third: &[[f64; D]; 4],
        (rolling, slope): (&Rolling, f64),
        parameters: &[f64],
    ) -> RollingCoefficients<D, P> {
        RollingCoefficients::default()
    }

    /// Tangents of slave and master at a contact point of two curves.
    #[inline(always)]
    #[allow(unused_variables)]
    fn curve_tangents(
        point: usize,
        x: &[[f64; D]],
        vectors: &Vectors<D, P, H>,
        parameters: &[f64],
    ) -> [[f64; D]; 2] {
        [[0.0; D]; 2]
    }

    /// Where sin²θ lies in the window of the weight, and how fast it moves with sin²θ. [eq:angle-window]
    #[inline(always)]
    #[allow(unused_variables)]
    fn angle_position(tangents: &[[f64; D]; 2], parameters: &[f64]) -> [f64; 2] {
        [1.0, 0.0]
    }

    /// w, w', w'' at a position in [0, 1] with its rate. [eq:angle-weight]
    #[inline(always)]
    #[allow(unused_variables)]
    fn angle_weight(position: [f64; 2]) -> [f64; 3] {
        [1.0, 0.0, 0.0]
    }

    /// The share of the weight in the residual. [eq:angle-residual]
    #[inline(always)]
    #[allow(unused_variables)]
    fn angle_force(
        tangents: &[[f64; D]; 2],
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        blend: &Blend,
    ) -> AngleForm<D> {
        AngleForm::default()
    }

    /// The share of the weight in the tangent. [eq:angle-tangent]
    #[inline(always)]
    #[allow(unused_variables)]
    fn angle_tangent(
        tangents: &[[f64; D]; 2],
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        third: &[[f64; D]; 4],
        blend: &Blend,
    ) -> AngleCoefficients<D> {
        AngleCoefficients::default()
    }

    /// Fills the rows s_A,iii if the angles move with them; they are zero on entry.
    #[inline(always)]
    #[allow(unused_variables)]
    fn third_rows(zeta: &[f64; P], rows: &mut [&mut [f64]; P]) {}

    /// The tangential tangent where all of it multiplies s_A s_B. [eq:tangential-contraction]
    #[inline(always)]
    #[allow(unused_variables)]
    fn joined_tangent(
        (point, x): (usize, &[[f64; D]]),
        vectors: &Vectors<D, P, H>,
        gap: &Gap<D>,
        frame: &Frame<P>,
        third: &[[f64; D]; 4],
        (tangential, slope): (&Tangential, f64),
        parameters: &[f64],
    ) -> [[f64; D]; D] {
        [[0.0; D]; D]
    }

    /// Weight times Jacobian of a point. `reference`, `x`: reference and current slave nodes. The rows
    /// of the measure's variation go to `variation` (per slave unknown) where it moves.
    fn measure(
        point: usize,
        reference: &[[f64; D]],
        x: &[[f64; D]],
        parameters: &[f64],
        variation: &mut [f64],
    ) -> Measure<D>;
}
