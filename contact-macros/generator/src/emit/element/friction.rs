//! What are frame, residual and tangent of tangential contact?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::{components, geometry_path, is_rational, matrix, nodes, shape_call};
use super::facts::{Facts, kinematics};
use super::friction_tangent::{contact_inputs, joins, tangent_call, tangent_items};
use super::rolling::Rolling;
use crate::emit::imports;
use crate::emit::program::Emitted;
use crate::linearise::{Kinematics, frame, tangential};
use crate::model::{Axis, Element, Geometry, Master, Rule, Slave};

/// The programs of tangential contact.
pub(super) struct Friction {
    pub(super) frame: Emitted,
    pub(super) residual: Emitted,
    pub(super) tangent: Option<Emitted>,
    pub(super) rolling: Option<Rolling>,
    axis: Option<Axis>,
}

impl Friction {
    /// `None` for a frictionless element.
    pub(super) fn new(element: &Element, kinematics: &Kinematics) -> Option<Self> {
        let axis = element.tangential.as_ref()?.axis;
        let rolls = element.rolling.is_some();
        let tangent = (!element.residual_only)
            .then(|| Emitted::shared(&tangential::tangent_program(kinematics, axis, rolls)));
        Some(Self {
            frame: Emitted::shared(&frame::frame_program(kinematics, axis)),
            residual: Emitted::shared(&tangential::residual_program(kinematics)),
            tangent,
            rolling: Rolling::new(element, kinematics),
            axis,
        })
    }

    pub(super) fn emitted(&self) -> impl Iterator<Item = &Emitted> {
        [&self.frame, &self.residual]
            .into_iter()
            .chain(&self.tangent)
            .chain(self.rolling.iter().flat_map(Rolling::emitted))
    }
}

/// The module of the programs of tangential contact. Elements with the same number of parameters and the same
/// vanishing terms share them: the tangent is compiled once, as a call from values to values.
pub fn emit_friction(elements: &[Element]) -> TokenStream {
    let mut seen = std::collections::BTreeSet::new();
    let mut items = TokenStream::new();
    for element in elements {
        let kinematics = kinematics(element);
        let friction = Friction::new(element, &kinematics);
        for emitted in friction.iter().flat_map(Friction::emitted) {
            if seen.insert(emitted.function.to_string()) {
                items.extend(emitted.shared_items());
            }
        }
        let tangent = friction.and_then(|friction| friction.tangent.map(|t| (t, friction.axis)));
        if let Some((tangent, axis)) = tangent {
            let name = tangent_call(element, &tangent);
            if seen.insert(name.to_string()) {
                items.extend(tangent_items(element, &kinematics, &tangent, axis));
            }
        }
    }
    if seen.is_empty() {
        return items;
    }
    let imports = imports();
    quote! {
        #[allow(non_snake_case, non_upper_case_globals, unused_variables, clippy::all)]
        mod friction {
            #imports
            #items
        }
    }
}

impl Facts<'_> {
    /// The methods of the trait that only tangential contact has.
    pub(super) fn friction_methods(&self) -> TokenStream {
        let Some(friction) = &self.friction else {
            return quote! {};
        };
        let frame = self.frame_method(friction);
        let force = self.force_method(friction);
        let (higher, tangent) = match &friction.tangent {
            Some(tangent) => (
                self.higher_method(),
                self.tangential_method(friction, tangent),
            ),
            None if friction.rolling.is_some() => (self.higher_method(), quote! {}),
            None => (quote! {}, quote! {}),
        };
        let rolling = self.rolling_methods();
        let direction = (friction.axis == Some(Axis::Slave)).then(|| self.direction_method());
        quote! { #frame #force #higher #tangent #direction #rolling }
    }

    /// Factor of δζ̂^q: t_q, with rolling also the share of the moments.
    fn effective_force(&self, friction: &Friction) -> Vec<TokenStream> {
        let (_, p, _) = self.sizes();
        let field = match friction.rolling {
            Some(_) => quote! { force },
            None => quote! { t },
        };
        (0..p).map(|q| quote! { tangential.#field[#q] }).collect()
    }

    /// `slave_tangent`: the slave curve's own tangent, where it is an axis.
    fn slave_tangent(&self, friction: &Friction) -> Option<TokenStream> {
        let needed = friction.axis == Some(Axis::Slave);
        needed.then(|| self.fixed_tangent()).flatten()
    }

    /// `slave_tangent`: the tangent of a slave curve at an integration point.
    pub(super) fn fixed_tangent(&self) -> Option<TokenStream> {
        let Slave::Integrated { geometry, rule } = &self.element.slave else {
            return None;
        };
        let (d, n) = (self.element.dimension, nodes(geometry));
        let slopes = self.slave_slopes(geometry, rule);
        Some(quote! {
            let slopes: Option<[[f64; #n]; 1]> = #slopes;
            let slave_tangent =
                runtime::slave_tangents::<#d, 1, #n>(&slopes.unwrap_or([[0.0; #n]; 1]), x)[0];
        })
    }

    /// N_A,1 of the slave curve at an integration point.
    fn slave_slopes(&self, geometry: &Geometry, rule: &Rule) -> TokenStream {
        let shape = shape_call(geometry);
        let weights = self.parameters.slave_weights();
        let start = self.parameters.point();
        let weights = quote! { parameters.get(#weights..).unwrap_or(&[]) };
        match rule {
            Rule::Given => quote! {
                parameters
                    .get(#start..)
                    .and_then(|eta| eta.first_chunk::<1>())
                    .map(|eta| #shape(eta, #weights).d1)
            },
            Rule::Gauss(_) if is_rational(geometry) => {
                quote! { POINTS.get(point).map(|eta| #shape(eta, #weights).d1) }
            }
            Rule::Gauss(_) => quote! { SLOPES.get(point).copied() },
        }
    }

    pub(super) fn direction_method(&self) -> TokenStream {
        let Slave::Integrated { geometry, rule } = &self.element.slave else {
            return quote! {};
        };
        let n = nodes(geometry);
        let slopes = self.slave_slopes(geometry, rule);
        quote! {
            #[inline(always)]
            fn slave_direction(point: usize, parameters: &[f64], row: &mut [f64]) {
                let slopes: Option<[[f64; #n]; 1]> = #slopes;
                if let (Some([slopes]), Some(row)) = (slopes, row.first_chunk_mut::<#n>()) {
                    *row = slopes;
                }
            }
        }
    }

    fn frame_method(&self, friction: &Friction) -> TokenStream {
        let (d, p, h) = self.sizes();
        let tangent = self.slave_tangent(friction);
        let mut inputs: Vec<TokenStream> = (0..d).map(|k| quote! { gap.n[#k] }).collect();
        for i in 0..p {
            inputs.extend(components("b", Some(i), d));
        }
        inputs.extend((0..p).map(|i| quote! { moved[#i] }));
        match friction.axis {
            Some(Axis::Convected) => {
                let at = self.parameters.axis();
                inputs.extend(
                    (at..at + 2).map(|at| quote! { parameters.get(#at).copied().unwrap_or(0.0) }),
                );
            }
            Some(Axis::Slave) => inputs.extend((0..d).map(|k| quote! { slave_tangent[#k] })),
            None => {}
        }
        let slip = (0..p).map(|q| quote! { o[#q] });
        let frame = matrix(p, p, p);
        let share = p + p * p;
        let function = &friction.frame.function;
        quote! {
            #[inline(always)]
            fn frame(
                point: usize,
                x: &[[f64; #d]],
                vectors: &runtime::Vectors<#d, #p, #h>,
                gap: &runtime::Gap<#d>,
                moved: &[f64; #p],
                parameters: &[f64],
            ) -> runtime::Frame<#p> {
                #tangent
                let o = friction::#function(&[#(#inputs),*]);
                runtime::Frame { s: [#(#slip),*], e: #frame, share: o[#share] }
            }
        }
    }

    fn force_method(&self, friction: &Friction) -> TokenStream {
        let function = &friction.residual.function;
        let (d, p, h) = self.sizes();
        let mut inputs = contact_inputs((d, p, h));
        inputs.extend(self.effective_force(friction));
        let force = (0..d).map(|k| quote! { o[#k] });
        let turn = (d..d + p).map(|k| quote! { o[#k] });
        quote! {
            #[inline(always)]
            fn tangential_force(
                vectors: &runtime::Vectors<#d, #p, #h>,
                gap: &runtime::Gap<#d>,
                frame: &runtime::Frame<#p>,
                tangential: &runtime::Tangential,
            ) -> runtime::TangentialForce<#d, #p> {
                let o = friction::#function(&[#(#inputs),*]);
                runtime::TangentialForce { force: [#(#force),*], turn: [#(#turn),*] }
            }
        }
    }

    fn tangential_method(&self, friction: &Friction, tangent: &Emitted) -> TokenStream {
        let (d, p, h) = self.sizes();
        let slave_tangent = self.slave_tangent(friction);
        let along = slave_tangent.is_some().then(|| quote! { , &slave_tangent });
        let call = tangent_call(self.element, tangent);
        let (method, result) = if joins(self.element, &self.kinematics) {
            (quote! { joined_tangent }, quote! { [[f64; #d]; #d] })
        } else {
            let result = quote! { runtime::TangentialCoefficients<#d, #p, #h> };
            (quote! { tangential_tangent }, result)
        };
        quote! {
            #[inline(always)]
            fn #method(
                (point, x): (usize, &[[f64; #d]]),
                vectors: &runtime::Vectors<#d, #p, #h>,
                gap: &runtime::Gap<#d>,
                frame: &runtime::Frame<#p>,
                third: &[[f64; #d]; 4],
                (tangential, slope): (&runtime::Tangential, f64),
                parameters: &[f64],
            ) -> #result {
                #slave_tangent
                friction::#call(vectors, gap, frame, third, (tangential, slope) #along)
            }
        }
    }

    pub(super) fn higher_method(&self) -> TokenStream {
        let (d, p, h) = self.sizes();
        let master_weights = self.parameters.master_weights();
        let slave_weights = self.parameters.slave_weights();
        let at = self.parameters.geometry();
        let weights = |at: usize| quote! { parameters.get(#at..).unwrap_or(&[]) };
        let (own, of_master, of_slave) =
            (weights(at), weights(master_weights), weights(slave_weights));
        let body = match (&self.element.slave, &self.element.master) {
            (Slave::Projected(slave), Master::Shape(master)) => {
                let (s, m) = (geometry_path(slave), geometry_path(master));
                let (ns, nm) = (nodes(slave), nodes(master));
                quote! {
                    runtime::curve_to_curve_higher::<#s, #m, #d, #ns, #nm>(
                        x, zeta, (#of_slave, #of_master), second,
                    )
                }
            }
            (Slave::Projected(slave), Master::Rigid { geometry, .. }) => {
                let (s, m, ns) = (geometry_path(slave), geometry_path(geometry), nodes(slave));
                quote! {
                    runtime::curve_to_rigid_higher::<#s, #m, #d, #ns>(
                        x, zeta, (#of_slave, #own), second,
                    )
                }
            }
            (_, Master::Shape(master)) => {
                let (m, nm) = (geometry_path(master), nodes(master));
                quote! {
                    runtime::onto_shape_higher::<#m, #d, #p, #h, #nm>(x, zeta, #of_master, second)
                }
            }
            (_, Master::Rigid { geometry, .. }) => {
                let m = geometry_path(geometry);
                quote! { runtime::onto_rigid_higher::<#m, #d, #p, #h>(zeta, #own) }
            }
            (_, Master::Point | Master::Distance { .. }) => quote! { [[0.0; #d]; 4] },
        };
        quote! {
            #[inline(always)]
            fn higher(
                x: &[[f64; #d]],
                zeta: &[f64; #p],
                parameters: &[f64],
                second: &mut [&mut [f64]; #h],
            ) -> [[f64; #d]; 4] {
                #body
            }
        }
    }
}
