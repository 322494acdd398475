//! Elements as types: the programs of their closed forms, the trait implementation, the descriptor.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::divisors::Divisors;
use super::parameters::{Parameters, master_shape, rigid, slave_shape};
use super::rule::{WeightedPoint, gauss};
use super::{domain, imports, program::Emitted};
use crate::ir::interpret;
use crate::linearise::law::{bound_program, law_program};
use crate::linearise::{Kinematics, distance, gap, geometry, measure, normal, second_derivatives};
use crate::model::{
    Body, Element, Gap, Geometry, Law, Linearisation, Master, Measure, Rule, Slave,
};

/// Everything about an element that several parts of the output need.
struct Facts<'a> {
    element: &'a Element,
    kinematics: Kinematics,
    parameters: Parameters,
    points: Vec<WeightedPoint>,
    slave_nodes: usize,
    master_nodes: usize,
    gap: Emitted,
    tangent: Option<Emitted>,
    measure: Option<Emitted>,
    divisors: Divisors,
}

/// The type of an element with all that belongs to it.
pub fn emit_element(element: &Element) -> TokenStream {
    let facts = Facts::new(element);
    let name = &element.name;
    let docs = &element.docs;
    let module = format_ident!("_element_{}", name.to_string().to_lowercase());
    let functions: TokenStream = [
        Some(&facts.gap),
        facts.tangent.as_ref(),
        facts.measure.as_ref(),
    ]
    .into_iter()
    .flatten()
    .map(Emitted::whole_function)
    .collect();
    let divisors = facts.divisors.functions();
    let statics = facts.statics();
    let implementation = facts.implementation();
    let descriptor = facts.descriptor();
    let tables = facts.tables();
    let imports = imports();
    quote! {
        #[doc = #docs]
        #[derive(Clone, Copy, Debug)]
        pub struct #name;

        #[allow(non_snake_case, unused_variables)]
        mod #module {
            use super::*;
            #imports
            #functions
            #divisors
            #statics
            #implementation
            #descriptor
            #tables
        }
    }
}

impl<'a> Facts<'a> {
    fn new(element: &'a Element) -> Self {
        let kinematics = kinematics(element);
        let parameters = Parameters::new(element);
        let points = match &element.slave {
            Slave::Integrated {
                geometry,
                rule: Rule::Gauss(counts),
            } => gauss(geometry, counts),
            _ => vec![([0.0; 2], 1.0)],
        };
        let (gap, tangent) = match &element.master {
            Master::Distance { geometry, .. } => (
                distance::gap_program(geometry),
                distance::tangent_program(geometry),
            ),
            _ => (
                gap::gap_program(&kinematics),
                normal::tangent_program(&kinematics),
            ),
        };
        let measure = match &element.slave {
            Slave::Integrated {
                geometry,
                rule: Rule::Gauss(_),
            } => Some(measure::measure_program(
                element.dimension,
                geometry.coordinates.len(),
                element.measure == Measure::Current,
            )),
            _ => None,
        };
        let is_distance = matches!(element.master, Master::Distance { .. });
        let moves = element.measure == Measure::Current;
        Self {
            divisors: Divisors::new(
                is_distance.then_some(&tangent),
                measure.as_ref().filter(|_| moves),
            ),
            slave_nodes: match &element.slave {
                Slave::Point => 1,
                Slave::Interpolated => 0,
                Slave::Projected(geometry) | Slave::Integrated { geometry, .. } => nodes(geometry),
            },
            master_nodes: match &element.master {
                Master::Point => 1,
                Master::Shape(geometry) => nodes(geometry),
                _ => 0,
            },
            element,
            kinematics,
            parameters,
            points,
            gap: Emitted::new(&gap, ""),
            tangent: (!element.residual_only).then(|| Emitted::new(&tangent, "")),
            measure: measure.map(|program| Emitted::new(&program, "")),
        }
    }

    fn is_distance(&self) -> bool {
        matches!(self.element.master, Master::Distance { .. })
    }

    fn projected_slave(&self) -> bool {
        matches!(self.element.slave, Slave::Projected(_))
    }

    /// D, P, H.
    fn sizes(&self) -> (usize, usize, usize) {
        let p = if self.is_distance() {
            0
        } else {
            self.kinematics.projected()
        };
        (self.element.dimension, p, second_derivatives(p))
    }

    /// Shape rows at the integration points, and their derivatives where a measure needs them.
    fn statics(&self) -> TokenStream {
        let Slave::Integrated {
            geometry,
            rule: Rule::Gauss(_),
        } = &self.element.slave
        else {
            return quote! {};
        };
        let program = geometry::shape_program(geometry);
        let n = nodes(geometry);
        let p = geometry.coordinates.len();
        let q = self.points.len();
        let coordinates = self.points.iter().map(|(point, _)| {
            let point = &point[..p];
            quote! { [#(#point),*] }
        });
        let weights = self.points.iter().map(|(_, weight)| weight);
        let rows = if is_rational(geometry) {
            quote! {}
        } else {
            let values: Vec<Vec<f64>> = self
                .points
                .iter()
                .map(|(point, _)| interpret(&program, &point[..p]))
                .collect();
            let rows = values.iter().map(|values| {
                let row = &values[..n];
                quote! { [#(#row),*] }
            });
            let slopes = values.iter().map(|values| {
                let rows = (0..p).map(|i| {
                    let row = &values[n * (1 + i)..n * (2 + i)];
                    quote! { [#(#row),*] }
                });
                quote! { [#(#rows),*] }
            });
            quote! {
                static ROWS: [[f64; #n]; #q] = [#(#rows),*];
                static SLOPES: [[[f64; #n]; #p]; #q] = [#(#slopes),*];
            }
        };
        quote! {
            #rows
            static POINTS: [[f64; #p]; #q] = [#(#coordinates),*];
            static WEIGHTS: [f64; #q] = [#(#weights),*];
        }
    }

    fn implementation(&self) -> TokenStream {
        let name = &self.element.name;
        let (d, p, h) = self.sizes();
        let law = law_path(&self.element.law);
        let layout = self.parameters.layout();
        let search = self.search();
        let moving = self.kinematics.moving.iter().any(|&moving| moving);
        let signed = self.element.gap == Gap::Signed;
        let current = self.element.measure == Measure::Current;
        let (slave_nodes, master_nodes) = (self.slave_nodes, self.master_nodes);
        let domains = self.domains();
        let two_curves = self.projected_slave();
        let curved = (0..3).map(|h| self.kinematics.curved.get(h).copied().unwrap_or(false));
        let parallel = if two_curves {
            quote! { runtime::Status::NotUnique }
        } else {
            quote! { runtime::Status::Degenerate }
        };
        let methods = [
            self.slave_method(),
            self.kinematics_method(),
            self.projection_method(),
            self.divisors_method(),
            self.gap_method(),
            self.tangent_method(),
            self.measure_method(),
        ];
        quote! {
            impl runtime::Element<#d, #p, #h> for #name {
                type Law = #law;
                const LAYOUT: runtime::Layout = #layout;
                const SEARCH: runtime::Search = #search;
                const MOVING: bool = #moving;
                const CURVED: [bool; 3] = [#(#curved),*];
                const SIGNED: bool = #signed;
                const CURRENT: bool = #current;
                const SLAVE_NODES: usize = #slave_nodes;
                const MASTER_NODES: usize = #master_nodes;
                const DOMAINS: [runtime::Domain; 2] = [#(#domains),*];
                const TWO_CURVES: bool = #two_curves;
                const PARALLEL: runtime::Status = #parallel;
                #(#methods)*
            }
        }
    }

    fn search(&self) -> TokenStream {
        let closed = match &self.element.master {
            Master::Point | Master::Distance { .. } => true,
            Master::Rigid { geometry, .. } => {
                !self.projected_slave()
                    && matches!(
                        &geometry.body,
                        Body::Rigid {
                            projection: Some(_),
                            ..
                        }
                    )
            }
            Master::Shape(_) => false,
        };
        if closed {
            quote! { runtime::Search::Closed }
        } else if self.kinematics.curved.iter().all(|&curved| !curved) {
            quote! { runtime::Search::Affine }
        } else {
            quote! { runtime::Search::Newton }
        }
    }

    fn domains(&self) -> Vec<TokenStream> {
        let master = match &self.element.master {
            Master::Shape(geometry) | Master::Rigid { geometry, .. } => domain(&geometry.domain),
            _ => quote! { runtime::Domain::Unbounded },
        };
        match &self.element.slave {
            Slave::Projected(geometry) => vec![domain(&geometry.domain), master],
            _ => vec![master, quote! { runtime::Domain::Unbounded }],
        }
    }

    fn slave_method(&self) -> TokenStream {
        let body = match &self.element.slave {
            Slave::Point => quote! {
                if let Some(s) = s.first_mut() {
                    *s = 1.0;
                }
            },
            Slave::Interpolated | Slave::Projected(_) => quote! {},
            Slave::Integrated { geometry, rule } => {
                let n = nodes(geometry);
                let row = self.slave_rows(geometry, rule);
                quote! {
                    #row
                    if let (Some(row), Some(s)) = (row, s.first_chunk_mut::<#n>()) {
                        *s = row;
                    }
                }
            }
        };
        quote! {
            #[inline(always)]
            fn slave(point: usize, parameters: &[f64], s: &mut [f64]) {
                #body
            }
        }
    }

    /// `let row: Option<[f64; n]> = …;`
    fn slave_rows(&self, geometry: &Geometry, rule: &Rule) -> TokenStream {
        let shape = shape_call(geometry);
        let weights = self.parameters.slave_weights();
        let start = self.parameters.point();
        let p = geometry.coordinates.len();
        match rule {
            Rule::Given => quote! {
                let weights = parameters.get(#weights..).unwrap_or(&[]);
                let row = parameters
                    .get(#start..)
                    .and_then(|eta| eta.first_chunk::<#p>())
                    .map(|eta| #shape(eta, weights).n);
            },
            Rule::Gauss(_) if is_rational(geometry) => quote! {
                let weights = parameters.get(#weights..).unwrap_or(&[]);
                let row = POINTS.get(point).map(|eta| #shape(eta, weights).n);
            },
            Rule::Gauss(_) => quote! { let row = ROWS.get(point).copied(); },
        }
    }

    fn kinematics_method(&self) -> TokenStream {
        let (d, p, h) = self.sizes();
        let master_weights = self.parameters.master_weights();
        let slave_weights = self.parameters.slave_weights();
        let at = self.parameters.geometry();
        let body = match (&self.element.slave, &self.element.master) {
            (Slave::Projected(slave), Master::Shape(master)) => {
                let (s, m) = (geometry_path(slave), geometry_path(master));
                let (ns, nm) = (nodes(slave), nodes(master));
                quote! {
                    let weights = (
                        parameters.get(#slave_weights..).unwrap_or(&[]),
                        parameters.get(#master_weights..).unwrap_or(&[]),
                    );
                    runtime::curve_to_curve::<#s, #m, #d, #ns, #nm>(x, zeta, weights, rows)
                }
            }
            (Slave::Projected(slave), Master::Rigid { geometry, .. }) => {
                let (s, m) = (geometry_path(slave), geometry_path(geometry));
                let ns = nodes(slave);
                quote! {
                    let data = (
                        parameters.get(#slave_weights..).unwrap_or(&[]),
                        parameters.get(#at..).unwrap_or(&[]),
                    );
                    runtime::curve_to_rigid::<#s, #m, #d, #ns>(x, zeta, data, rows)
                }
            }
            (_, Master::Shape(master)) => {
                let (m, nm) = (geometry_path(master), nodes(master));
                quote! {
                    let weights = parameters.get(#master_weights..).unwrap_or(&[]);
                    runtime::onto_shape::<#m, #d, #p, #h, #nm>(x, zeta, weights, rows)
                }
            }
            (_, Master::Rigid { geometry, .. }) => {
                let m = geometry_path(geometry);
                quote! {
                    let own = parameters.get(#at..).unwrap_or(&[]);
                    runtime::onto_rigid::<#m, #d, #p, #h>(x, zeta, own, rows)
                }
            }
            (_, Master::Point) => quote! { runtime::onto_point(x, rows) },
            (_, Master::Distance { .. }) => quote! {
                runtime::Vectors {
                    r: runtime::slave_point(x, rows.s, 0),
                    ..runtime::Vectors::default()
                }
            },
        };
        quote! {
            #[inline(always)]
            fn kinematics(
                x: &[[f64; #d]],
                zeta: &[f64; #p],
                parameters: &[f64],
                rows: &mut runtime::Rows<'_, #p>,
            ) -> runtime::Vectors<#d, #p, #h> {
                #body
            }
        }
    }

    fn projection_method(&self) -> TokenStream {
        let (d, p, h) = self.sizes();
        let at = self.parameters.geometry();
        let body = match &self.element.master {
            Master::Rigid { geometry, .. } if !self.projected_slave() => {
                let path = geometry_path(geometry);
                quote! {
                    let own = parameters.get(#at..).unwrap_or(&[]);
                    <#path as runtime::Rigid<#d, #p, #h>>::projection(x, own).unwrap_or([0.0; #p])
                }
            }
            _ => quote! { [0.0; #p] },
        };
        quote! {
            #[inline(always)]
            fn closed_projection(x: &[f64; #d], parameters: &[f64]) -> [f64; #p] {
                #body
            }
        }
    }

    fn gap_method(&self) -> TokenStream {
        let (d, p, h) = self.sizes();
        let r0 = self.parameters.r0();
        let mut inputs = if self.is_distance() {
            self.distance_inputs()
        } else {
            components("r", None, d)
        };
        for i in 0..p {
            inputs.extend(components("b", Some(i), d));
        }
        inputs.push(quote! { orientation });
        inputs.push(quote! { r0 });
        let normal = (0..d).map(|k| quote! { o[#k] });
        let (distance, gap) = (d, d + 1);
        quote! {
            #[inline(always)]
            fn gap(
                vectors: &runtime::Vectors<#d, #p, #h>,
                parameters: &[f64],
                orientation: f64,
            ) -> runtime::Gap<#d> {
                let r0 = parameters.get(#r0).copied().unwrap_or(0.0);
                let o = gap(&[#(#inputs),*]);
                runtime::Gap { n: [#(#normal),*], distance: o[#distance], gap: o[#gap] }
            }
        }
    }

    fn divisors_method(&self) -> TokenStream {
        let mut distance = self.distance_inputs();
        // orientation, N and N' are factors only
        distance.extend([quote!(1.0), quote!(1.0), quote!(1.0)]);
        let default = quote! { return true };
        let measure = match &self.element.slave {
            Slave::Integrated {
                geometry,
                rule: Rule::Gauss(_),
            } => (
                self.gauss_tangents(geometry, &default),
                tangent_inputs(geometry, self.element.dimension),
            ),
            _ => Default::default(),
        };
        self.divisors
            .method(self.sizes(), &distance, (measure.0, &measure.1))
    }

    /// The coordinates and parameters of a distance function as expressions.
    fn distance_inputs(&self) -> Vec<TokenStream> {
        let mut inputs = components("r", None, self.element.dimension);
        inputs.extend(self.own_parameters());
        inputs
    }

    /// The parameters of a distance function as expressions.
    fn own_parameters(&self) -> Vec<TokenStream> {
        let (rigid, _) = rigid(self.element);
        let count = rigid.map_or(0, |geometry| geometry.parameters.len());
        let at = self.parameters.geometry();
        (at..at + count)
            .map(|index| quote! { parameters.get(#index).copied().unwrap_or(0.0) })
            .collect()
    }

    fn tangent_method(&self) -> TokenStream {
        let (d, p, h) = self.sizes();
        let body = if self.tangent.is_none() {
            quote! { runtime::Coefficients::default() }
        } else {
            let mut inputs;
            if self.is_distance() {
                inputs = self.distance_inputs();
                inputs.push(quote! { orientation });
            } else {
                inputs = (0..d).map(|k| quote! { gap.n[#k] }).collect();
                inputs.push(quote! { gap.distance });
                for i in 0..p {
                    inputs.extend(components("b", Some(i), d));
                }
                for i in 0..h {
                    inputs.extend(components("second", Some(i), d));
                }
            }
            inputs.push(quote! { traction.traction });
            inputs.push(quote! { traction.slope });
            let position = matrix(0, d, d);
            let right = matrix(d * d, p, d);
            let left = matrix(d * d + p * d, p, d);
            let rotation = matrix(d * d + 2 * p * d, p, p);
            quote! {
                let o = tangent(&[#(#inputs),*]);
                runtime::Coefficients { p: #position, right: #right, left: #left, s: #rotation }
            }
        };
        quote! {
            #[inline(always)]
            fn tangent(
                vectors: &runtime::Vectors<#d, #p, #h>,
                gap: &runtime::Gap<#d>,
                traction: &runtime::Traction,
                parameters: &[f64],
                orientation: f64,
            ) -> runtime::Coefficients<#d, #p> {
                #body
            }
        }
    }

    fn measure_method(&self) -> TokenStream {
        let d = self.element.dimension;
        let body = match &self.element.slave {
            Slave::Integrated {
                geometry,
                rule: Rule::Given,
            } => {
                let index = self.parameters.point() + geometry.coordinates.len();
                quote! {
                    runtime::Measure {
                        weight: parameters.get(#index).copied().unwrap_or(1.0),
                        ..runtime::Measure::default()
                    }
                }
            }
            Slave::Integrated { geometry, .. } => self.gauss_measure(geometry),
            _ => quote! { runtime::Measure::default() },
        };
        quote! {
            #[inline(always)]
            fn measure(
                point: usize,
                reference: &[[f64; #d]],
                x: &[[f64; #d]],
                parameters: &[f64],
                variation: &mut [f64],
            ) -> runtime::Measure<#d> {
                #body
            }
        }
    }

    /// Statements that define `weight` and the tangents `t` of the slave at integration point `point`, of
    /// the configuration that the measure is taken in.
    fn gauss_tangents(&self, geometry: &Geometry, otherwise: &TokenStream) -> TokenStream {
        let d = self.element.dimension;
        let (n, p) = (nodes(geometry), geometry.coordinates.len());
        let shape = shape_call(geometry);
        let start = self.parameters.slave_weights();
        let slopes = if is_rational(geometry) {
            quote! {
                let weights = parameters.get(#start..).unwrap_or(&[]);
                let slopes = POINTS.get(point).map(|eta| #shape(eta, weights).d1);
            }
        } else {
            quote! { let slopes = SLOPES.get(point).copied(); }
        };
        let positions = if self.element.measure == Measure::Current {
            quote!(x)
        } else {
            quote!(reference)
        };
        quote! {
            #slopes
            let (Some(slopes), Some(&weight)) = (slopes, WEIGHTS.get(point)) else {
                #otherwise;
            };
            let t = runtime::slave_tangents::<#d, #p, #n>(&slopes, #positions);
        }
    }

    fn gauss_measure(&self, geometry: &Geometry) -> TokenStream {
        let d = self.element.dimension;
        let (n, p) = (nodes(geometry), geometry.coordinates.len());
        let current = self.element.measure == Measure::Current;
        let tangents =
            self.gauss_tangents(geometry, &quote! { return runtime::Measure::default() });
        let function = Ident::new(
            if current {
                "measure_current"
            } else {
                "measure_reference"
            },
            self.element.name.span(),
        );
        let inputs = tangent_inputs(geometry, d);
        let spread = current.then(|| {
            let slots = (0..p).map(|i| {
                let entries = (0..d).map(|k| {
                    let index = 1 + i * d + k;
                    quote! { weight * o[#index] }
                });
                quote! { measure.variation[#i] = [#(#entries),*]; }
            });
            quote! {
                #(#slots)*
                runtime::spread_variation::<#d, #p, #n>(&slopes, &measure, variation);
            }
        });
        quote! {
            #tangents
            let o = #function(&[#(#inputs),*]);
            let mut measure = runtime::Measure::default();
            measure.weight = weight * o[0];
            #spread
            measure
        }
    }

    fn descriptor(&self) -> TokenStream {
        let name = &self.element.name;
        let (d, p, h) = self.sizes();
        let q = self.points.len();
        let n = self.slave_nodes + self.master_nodes;
        let padded = (n * d).next_multiple_of(4);
        let (slave_nodes, master_nodes) = (self.slave_nodes, self.master_nodes);
        let text = format!("{name}\0");
        let documentation = format!("{}\0", self.element.docs.trim());
        let parameters = self.parameters.list();
        let symmetric = self.element.measure == Measure::Reference;
        let has_tangent = self.tangent.is_some();
        let operations = self.operations();
        let formulation = self.formulation();
        let vectors = self.vector_flags();
        let interpolated = matches!(self.element.slave, Slave::Interpolated);
        let kernel = if interpolated {
            quote! {
                |call, nodes, memory, target| {
                    runtime::interpolated::<#name, _, #d, #p, #h>(
                        call, nodes, &[#(#vectors),*], memory, target,
                    )
                }
            }
        } else {
            quote! {
                |call, nodes, memory, target| {
                    runtime::fixed::<#name, _, #d, #p, #h, #n, #q, #padded>(
                        call, nodes, &[#(#vectors),*], target,
                    )
                }
            }
        };
        let flags = self.vector_flags();
        quote! {
            impl #name {
                /// What the C interface knows of this element.
                pub const DESCRIPTOR: &'static ::contact_elements::abi::Descriptor = {
                    static DESCRIPTOR: ::contact_elements::abi::Descriptor =
                        ::contact_elements::abi::Descriptor {
                            name: #text,
                            documentation: #documentation,
                            dimension: #d,
                            slave_nodes: #slave_nodes,
                            master_nodes: #master_nodes,
                            interpolated: #interpolated,
                            points: #q,
                            projected: #p,
                            parameters: #parameters,
                            symmetric: #symmetric,
                            tangent: #has_tangent,
                            energy: <<#name as runtime::Element<#d, #p, #h>>::Law
                                as runtime::NormalLaw>::ENERGY,
                            operations: #operations,
                            formulation: #formulation,
                            vectors: &[#(#flags),*],
                            centre: <#name as runtime::Element<#d, #p, #h>>::START,
                            kernel: #kernel,
                        };
                    &DESCRIPTOR
                };
            }
        }
    }

    /// Which nodes are tangent vectors.
    fn vector_flags(&self) -> Vec<bool> {
        let mut flags = vec![];
        for (geometry, count) in [
            (slave_shape(self.element), self.slave_nodes),
            (master_shape(self.element), self.master_nodes),
        ] {
            match geometry.map(|geometry| &geometry.body) {
                Some(Body::Shape { vectors, .. }) => {
                    flags.extend((0..count).map(|a| vectors.contains(&a)));
                }
                _ => flags.extend(vec![false; count]),
            }
        }
        flags
    }

    fn emitted(&self) -> impl Iterator<Item = &Emitted> {
        [
            Some(&self.gap),
            self.tangent.as_ref(),
            self.measure.as_ref(),
        ]
        .into_iter()
        .flatten()
    }

    /// Operations of one evaluation of the point programs, the law included.
    fn operations(&self) -> usize {
        let law = Emitted::new(&law_program(&self.element.law), "");
        self.emitted()
            .chain([&law])
            .map(|emitted| emitted.program.operations())
            .sum()
    }

    /// FNV-1a hash of the programs' tables: changes when the emitted code means something else.
    fn formulation(&self) -> u64 {
        let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
        let mut absorb = |text: &str| {
            for byte in text.bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        };
        for emitted in self.emitted() {
            absorb(&emitted.table().to_string());
        }
        for geometry in [
            slave_shape(self.element),
            master_shape(self.element),
            rigid(self.element).0,
        ]
        .into_iter()
        .flatten()
        {
            let program = match &geometry.body {
                Body::Shape { .. } => geometry::shape_program(geometry),
                Body::Rigid { .. } => geometry::rigid_program(geometry),
                Body::Distance { .. } => continue,
            };
            absorb(&Emitted::new(&program, "").table().to_string());
        }
        let law = &self.element.law;
        absorb(&Emitted::new(&law_program(law), "").table().to_string());
        let bounds = [Some(&law.active), law.valid.as_ref()];
        for bound in bounds.into_iter().flatten() {
            let program = bound_program(law, "bound", bound);
            absorb(&Emitted::new(&program, "").table().to_string());
        }
        for domain in self.domains() {
            absorb(&domain.to_string());
        }
        absorb(&format!("{:?} {:?}", self.points, self.vector_flags()));
        absorb(&self.parameters.layout().to_string());
        hash
    }

    fn tables(&self) -> TokenStream {
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
        let description = self.description();
        quote! {
            impl #name {
                /// The programs of this element, for verification.
                pub const PROGRAMS: ElementPrograms =
                    ElementPrograms { gap: #gap, tangent: #tangent, measure: #measure };
                /// What was declared, for verification.
                pub const DESCRIPTION: ElementDescription = #description;
            }
        }
    }

    fn description(&self) -> TokenStream {
        let text = self.element.name.to_string();
        let slave = self.slave_description();
        let master = match &self.element.master {
            Master::Point => quote! { MasterDescription::Point },
            Master::Shape(geometry) => {
                let path = geometry_path(geometry);
                quote! { MasterDescription::Shape(&#path::PROGRAMS) }
            }
            Master::Rigid { geometry, .. } => {
                let path = geometry_path(geometry);
                quote! { MasterDescription::Rigid(&#path::PROGRAMS) }
            }
            Master::Distance { geometry, .. } => {
                let path = geometry_path(geometry);
                quote! { MasterDescription::Distance(&#path::PROGRAMS) }
            }
        };
        let law = law_path(&self.element.law);
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
                placed: #placed,
                signed: #signed,
                tangent_plane: #tangent_plane,
                current: #current,
                moving: #moving,
                layout: #layout,
            }
        }
    }

    fn slave_description(&self) -> TokenStream {
        match &self.element.slave {
            Slave::Point => quote! { SlaveDescription::Point },
            Slave::Interpolated => quote! { SlaveDescription::Interpolated },
            Slave::Projected(geometry) => {
                let path = geometry_path(geometry);
                quote! { SlaveDescription::Projected(&#path::PROGRAMS) }
            }
            Slave::Integrated { geometry, rule } => {
                let path = geometry_path(geometry);
                if *rule == Rule::Given {
                    return quote! { SlaveDescription::Given(&#path::PROGRAMS) };
                }
                let points = self.points.iter().map(|(point, weight)| {
                    let [first, second] = point;
                    quote! { ([#first, #second], #weight) }
                });
                quote! { SlaveDescription::Integrated(&#path::PROGRAMS, &[#(#points),*]) }
            }
        }
    }
}

fn kinematics(element: &Element) -> Kinematics {
    let (moving, curved) = match (&element.slave, &element.master) {
        (Slave::Projected(slave), Master::Shape(master)) => {
            let (first, second) = (geometry::curved(slave)[0], geometry::curved(master)[0]);
            (vec![true, true], vec![first, false, second])
        }
        (
            Slave::Projected(slave),
            Master::Rigid {
                geometry: master, ..
            },
        ) => {
            let (first, second) = (geometry::curved(slave)[0], geometry::curved(master)[0]);
            (vec![true, false], vec![first, false, second])
        }
        (_, Master::Shape(master)) => (
            vec![true; master.coordinates.len()],
            geometry::curved(master),
        ),
        (
            _,
            Master::Rigid {
                geometry: master, ..
            },
        ) => (
            vec![false; master.coordinates.len()],
            geometry::curved(master),
        ),
        (_, Master::Point | Master::Distance { .. }) => (vec![], vec![]),
    };
    Kinematics {
        dimension: element.dimension,
        moving,
        curved,
        signed: element.gap == Gap::Signed,
        linearisation: element.linearisation,
    }
}

fn nodes(geometry: &Geometry) -> usize {
    match &geometry.body {
        Body::Shape { functions, .. } => functions.len(),
        _ => 0,
    }
}

/// `t[i][k]` for all tangents of the slave.
fn tangent_inputs(geometry: &Geometry, d: usize) -> Vec<TokenStream> {
    (0..geometry.coordinates.len())
        .flat_map(|i| (0..d).map(move |k| quote! { t[#i][#k] }))
        .collect()
}

fn is_rational(geometry: &Geometry) -> bool {
    matches!(geometry.body, Body::Shape { rational: true, .. })
}

fn geometry_path(geometry: &Geometry) -> TokenStream {
    let name = &geometry.name;
    if geometry.built_in {
        quote! { ::contact_elements::geometry::#name }
    } else {
        quote! { #name }
    }
}

fn law_path(law: &Law) -> TokenStream {
    let name = &law.name;
    if law.built_in {
        quote! { ::contact_elements::laws::#name }
    } else {
        quote! { #name }
    }
}

/// `<G as runtime::Shape<p, h, n>>::rows`
fn shape_call(geometry: &Geometry) -> TokenStream {
    let path = geometry_path(geometry);
    let p = geometry.coordinates.len();
    let (h, n) = (second_derivatives(p), nodes(geometry));
    quote! { <#path as runtime::Shape<#p, #h, #n>>::rows }
}

/// `vectors.field[i][k]` for all components.
fn components(field: &str, index: Option<usize>, d: usize) -> Vec<TokenStream> {
    let field = format_ident!("{field}");
    (0..d)
        .map(|k| match index {
            None => quote! { vectors.#field[#k] },
            Some(i) => quote! { vectors.#field[#i][#k] },
        })
        .collect()
}

/// `[[o[start], …]; rows]`
fn matrix(start: usize, rows: usize, width: usize) -> TokenStream {
    let rows = (0..rows).map(|row| {
        let entries = (0..width).map(|k| {
            let index = start + row * width + k;
            quote! { o[#index] }
        });
        quote! { [#(#entries),*] }
    });
    quote! { [#(#rows),*] }
}
