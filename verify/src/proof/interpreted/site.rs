//! Where the terms of an element stand: which of its programs holds them.

use contact_elements::table::Table;

use crate::interpret::Change;
use crate::subject::Subject;

/// Table of an element that holds terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TermSite {
    /// Law.
    Law,
    /// Coefficients of the tangent.
    Tangent,
    /// Measure.
    Measure,
    /// Stiffness and bound of the tangential law.
    Friction,
    /// Force beyond the bound.
    Sliding,
    /// Coefficients of the tangential residual.
    TangentialResidual,
    /// Coefficients of the tangential tangent.
    TangentialTangent,
    /// Stiffness and bound of the law of rolling.
    RollingLaw,
    /// Moment beyond the bound.
    RollingSliding,
    /// Coefficients of the residual of the moments.
    RollingResidual,
    /// Coefficients of the tangent of the moments.
    RollingTangent,
    /// Weight by the angle and its derivatives.
    AngleWeight,
    /// Form of the residual that the weight adds.
    AngleResidual,
    /// Pairs of forms of the tangent that the weight adds.
    AngleTangent,
}

impl TermSite {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::Law,
        Self::Tangent,
        Self::Measure,
        Self::Friction,
        Self::Sliding,
        Self::TangentialResidual,
        Self::TangentialTangent,
        Self::RollingLaw,
        Self::RollingSliding,
        Self::RollingResidual,
        Self::RollingTangent,
        Self::AngleWeight,
        Self::AngleResidual,
        Self::AngleTangent,
    ];
}

/// A changed term: where, which, how.
pub type Mutation = (TermSite, Change);

/// The program of a subject at a site.
pub fn program(subject: &Subject, site: TermSite) -> Option<&'static Table> {
    match site {
        TermSite::Law => Some(&subject.description.law.law),
        TermSite::Tangent => subject.description.programs.tangent.as_ref(),
        TermSite::Measure => subject.description.programs.measure.as_ref(),
        TermSite::Friction => subject.description.tangential.map(|law| &law.friction),
        TermSite::Sliding => subject.description.tangential?.sliding.as_ref(),
        TermSite::TangentialResidual => subject.description.programs.tangential_residual.as_ref(),
        TermSite::TangentialTangent => subject.description.programs.tangential_tangent.as_ref(),
        TermSite::RollingLaw => subject.description.rolling.map(|own| &own.law.friction),
        TermSite::RollingSliding => subject.description.rolling?.law.sliding.as_ref(),
        TermSite::RollingResidual => subject.description.rolling.map(|own| &own.residual),
        TermSite::RollingTangent => subject.description.rolling?.tangent.as_ref(),
        TermSite::AngleWeight => subject.description.angle.map(|own| &own.weight),
        TermSite::AngleResidual => subject.description.angle.map(|own| &own.residual),
        TermSite::AngleTangent => subject.description.angle?.tangent.as_ref(),
    }
}
