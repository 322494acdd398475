//! What does the verification know of the element?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::{geometry_path, law_path, tangential_law_path};
use super::facts::Facts;
use crate::emit::parameters::rigid;
use crate::emit::program::Emitted;
use crate::model::{Axis, Gap, Linearisation, Master, Measure, Rule, Slave};

impl Facts<'_> {
    pub(super) fn tables(&self) -> TokenStream {
        let name = &self.element.name;
        let gap = self.gap.table();
        let optional = |emitted: Option<&Emitted>| match emitted {
            Some(emitted) => {
                let table = emitted.table();
                quote! { Some(#table) }
            }
            None => quote! { None },
        };
        let tangent = optional(self.tangent.as_ref());
        let measure = optional(self.measure.as_ref());
        let friction = self.friction.as_ref();
        let shared = |emitted: Option<&Emitted>| match emitted {
            Some(emitted) => {
                let table = emitted.constant();
                quote! { Some(friction::#table) }
            }
            None => quote! { None },
        };
        let frame = shared(friction.map(|friction| &friction.frame));
        let force = shared(friction.map(|friction| &friction.residual));
        let turn = shared(friction.and_then(|friction| friction.tangent.as_ref()));
        let description = self.description();
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

    fn description(&self) -> TokenStream {
        let text = self.element.name.to_string();
        let slave = self.slave_description();
        let master = self.master_description();
        let law = law_path(&self.element.law);
        let tangential = match &self.element.tangential {
            Some(tangential) => {
                let path = tangential_law_path(&tangential.law);
                quote! { Some(&#path::PROGRAMS) }
            }
            None => quote! { None },
        };
        let axis = match self.element.tangential.as_ref().and_then(|t| t.axis) {
            None => quote! { AxisDescription::None },
            Some(Axis::Convected) => quote! { AxisDescription::Convected },
            Some(Axis::Slave) => quote! { AxisDescription::Slave },
        };
        let rolling = self.rolling_description();
        let angle = self.angle_description();
        let (_, placed) = rigid(self.element);
        let signed = self.element.gap == Gap::Signed;
        let tangent_plane = self.element.linearisation == Linearisation::TangentPlane;
        let current = self.element.measure == Measure::Current;
        let moving = self.kinematics.moving.iter().any(|&moving| moving);
        let layout = self.parameters.layout();
        let name = &self.element.name;
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

    fn rolling_description(&self) -> TokenStream {
        let (Some(rolling), Some(declared)) = (self.rolling(), &self.element.rolling) else {
            return quote! { None };
        };
        let path = tangential_law_path(&declared.law);
        let layout = self.rolling_layout();
        let (angle, residual) = (rolling.angle.constant(), rolling.residual.constant());
        let tangent = match &rolling.tangent {
            Some(tangent) => {
                let table = tangent.constant();
                quote! { Some(friction::#table) }
            }
            None => quote! { None },
        };
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

    pub(super) fn master_description(&self) -> TokenStream {
        match &self.element.master {
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

    pub(super) fn slave_description(&self) -> TokenStream {
        match &self.element.slave {
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
                let points = self.points.iter().map(|(point, weight)| {
                    let [first, second] = point;
                    quote! { ([#first, #second], #weight) }
                });
                quote! { SlaveDescription::Integrated(#path::PROGRAMS, &[#(#points),*]) }
            }
        }
    }
}
