//! What does the verification know of the element?

use proc_macro2::TokenStream;
use quote::quote;

use super::angle::angle_description;
use super::expressions::{geometry_path, law_path, tangential_law_path};
use super::rolling::rolling_layout;
use crate::emit::parameters;
use crate::emit::program::{constant, optional_table, table};
use crate::formulate::FormulatedElement;
use crate::formulate::Routine;
use crate::model::{Axis, Gap, Linearisation, Master, Measure, Rule, Slave};

pub(super) fn tables(e: &FormulatedElement<'_>) -> TokenStream {
    let name = &e.declared.name;
    let gap = table(&e.gap);
    let tangent = optional_table(e.tangent.as_ref());
    let measure = optional_table(e.measure.as_ref());
    let friction = e.friction.as_ref();
    let frame = shared(friction.map(|friction| &friction.frame));
    let force = shared(friction.map(|friction| &friction.residual));
    let turn = shared(friction.and_then(|friction| friction.tangent.as_ref()));
    let description = description(e);
    quote! {
        impl #name {
            /// The programs of this element, for verification.
            pub const PROGRAMS: ElementPrograms =
                ElementPrograms {
                    gap: #gap,
                    tangent: #tangent,
                    measure: #measure,
                    frame: #frame,
                    tangential_residual: #force,
                    tangential_tangent: #turn,
                };
            /// What was declared, for verification.
            pub const DESCRIPTION: ElementDescription = #description;
        }
    }
}

fn description(e: &FormulatedElement<'_>) -> TokenStream {
    let text = e.declared.name.to_string();
    let slave = slave_description(e);
    let master = master_description(e);
    let law = law_path(&e.declared.law);
    let tangential = match &e.declared.tangential {
        Some(tangential) => {
            let path = tangential_law_path(&tangential.law);
            quote! { Some(&#path::PROGRAMS) }
        }
        None => quote! { None },
    };
    let axis = match e.declared.tangential.as_ref().and_then(|t| t.axis) {
        None => quote! { AxisDescription::None },
        Some(Axis::Convected) => quote! { AxisDescription::Convected },
        Some(Axis::Slave) => quote! { AxisDescription::Slave },
    };
    let rolling = rolling_description(e);
    let angle = angle_description(e);
    let placed = e.declared.master.is_placed();
    let signed = e.declared.gap == Gap::Signed;
    let tangent_plane = e.declared.linearisation == Linearisation::TangentPlane;
    let current = e.declared.measure == Measure::Current;
    let moving = e.kinematics.moving.iter().any(|&moving| moving);
    let layout = parameters::layout(&e.parameters);
    let name = &e.declared.name;
    quote! {
        ElementDescription {
            name: #text,
            descriptor: #name::DESCRIPTOR,
            programs: &#name::PROGRAMS,
            slave: #slave,
            master: #master,
            law: &#law::PROGRAMS,
            tangential: #tangential,
            axis: #axis,
            rolling: #rolling,
            angle: #angle,
            placed: #placed,
            signed: #signed,
            tangent_plane: #tangent_plane,
            current: #current,
            moving: #moving,
            layout: #layout,
        }
    }
}

fn rolling_description(e: &FormulatedElement<'_>) -> TokenStream {
    let (Some(rolling), Some(declared)) = (e.rolling(), &e.declared.rolling) else {
        return quote! { None };
    };
    let path = tangential_law_path(&declared.law);
    let layout = rolling_layout(e);
    let (angle, residual) = (constant(&rolling.angle), constant(&rolling.residual));
    let tangent = shared(rolling.tangent.as_ref());
    quote! {
        Some(&RollingDescription {
            law: &#path::PROGRAMS,
            layout: #layout,
            angle: friction::#angle,
            residual: friction::#residual,
            tangent: #tangent,
        })
    }
}

pub(super) fn master_description(e: &FormulatedElement<'_>) -> TokenStream {
    match &e.declared.master {
        Master::Point => quote! { MasterDescription::Point },
        Master::Shape(geometry) => {
            let path = geometry_path(geometry);
            quote! { MasterDescription::Shape(#path::PROGRAMS) }
        }
        Master::Rigid { geometry, .. } => {
            let path = geometry_path(geometry);
            quote! { MasterDescription::Rigid(#path::PROGRAMS) }
        }
        Master::Distance { geometry, .. } => {
            let path = geometry_path(geometry);
            quote! { MasterDescription::Distance(#path::PROGRAMS) }
        }
    }
}

pub(super) fn slave_description(e: &FormulatedElement<'_>) -> TokenStream {
    match &e.declared.slave {
        Slave::Point => quote! { SlaveDescription::Point },
        Slave::Interpolated => quote! { SlaveDescription::Interpolated },
        Slave::Projected(geometry) => {
            let path = geometry_path(geometry);
            quote! { SlaveDescription::Projected(#path::PROGRAMS) }
        }
        Slave::Integrated { geometry, rule } => {
            let path = geometry_path(geometry);
            if *rule == Rule::Given {
                return quote! { SlaveDescription::Given(#path::PROGRAMS) };
            }
            let points = e.points.iter().map(|(point, weight)| {
                let [first, second] = point;
                quote! { ([#first, #second], #weight) }
            });
            quote! { SlaveDescription::Integrated(#path::PROGRAMS, &[#(#points),*]) }
        }
    }
}

/// `Some(friction::TABLE)` where there is a shared routine.
fn shared(routine: Option<&Routine>) -> TokenStream {
    match routine {
        Some(routine) => {
            let table = constant(routine);
            quote! { Some(friction::#table) }
        }
        None => quote! { None },
    }
}
