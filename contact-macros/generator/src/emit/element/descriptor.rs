//! What does the C interface know of the element?

use std::rc::Rc;

use proc_macro2::TokenStream;
use quote::quote;

use super::facts::Facts;
use crate::emit::parameters::{master_shape, rigid, slave_shape};
use crate::emit::program::{Emitted, fnv};
use crate::linearise::geometry;
use crate::linearise::law::{bound_program, law_program};
use crate::linearise::sliding::{friction_program, sliding_program};
use crate::model::{Body, Enforcement, Measure, Slave, TangentialLaw};

/// Limits of a batch in lanes; the kernels assert them.
const MOST_UNKNOWNS: usize = 40;
const MOST_PARAMETERS: usize = 16;

impl Facts<'_> {
    pub(super) fn descriptor(&self) -> TokenStream {
        let name = &self.element.name;
        let (d, p, h) = self.sizes();
        let q = self.points.len();
        let (slave_nodes, master_nodes) = (self.slave_nodes, self.master_nodes);
        let text = format!("{name}\0");
        let documentation = format!("{}\0", self.element.docs.trim());
        let parameters = self.parameters.list();
        let friction = self.friction.is_some();
        let rolling = self.rolling().is_some();
        let symmetric = self.element.measure == Measure::Reference && !friction;
        let has_tangent = self.tangent.is_some();
        let (slave, master) = (self.slave_description(), self.master_description());
        let layout = self.parameters.layout();
        let angle = self.angle_offset();
        let enforcement = self.enforcement();
        let has_multiplier = self.element.enforcement != Enforcement::Penalty;
        let operations = self.operations();
        let formulation = self.formulation();
        let interpolated = matches!(self.element.slave, Slave::Interpolated);
        let kernel = self.kernel();
        let flags = self.vector_flags();
        let (lanes, lanes_kernel) = self.lanes();
        let (screen, screen_kernel) = self.screen();
        quote! {
            #lanes_kernel
            #screen_kernel
            // a function, not a closure: a closure behind a pointer is compiled twice
            fn kernel(
                call: &runtime::Call<'_>,
                nodes: &runtime::Nodes<'_>,
                memory: &mut [f64],
                target: &mut ::contact_elements::abi::Target,
            ) -> Result<runtime::Summary, runtime::InputError> {
                #kernel
            }
            impl #name {
                /// What the C interface knows of this element.
                pub const DESCRIPTOR: &'static ::contact_elements::abi::Descriptor = {
                    static DESCRIPTOR: ::contact_elements::abi::Descriptor =
                        ::contact_elements::abi::Descriptor {
                            descriptor: ::contact_elements::Descriptor {
                            name: #text,
                            documentation: #documentation,
                            dimension: #d,
                            slave_nodes: #slave_nodes,
                            master_nodes: #master_nodes,
                            interpolated: #interpolated,
                            points: #q,
                            projected: #p,
                            parameters: #parameters,
                            friction: #friction,
                            enforcement: #enforcement,
                            rolling: #rolling,
                            angle: #angle,
                            keeps_side: <#name as runtime::Element<#d, #p, #h>>::KEEPS_SIDE,
                            symmetric: #symmetric,
                            tangent: #has_tangent,
                            energy: #has_multiplier
                                || <<#name as runtime::Element<#d, #p, #h>>::Law
                                    as runtime::NormalLaw>::ENERGY,
                            operations: #operations,
                            formulation: #formulation,
                            vectors: &[#(#flags),*],
                            centre: <#name as runtime::Element<#d, #p, #h>>::START,
                            slave: #slave,
                            master: #master,
                            layout: #layout,
                            domains: <#name as runtime::Element<#d, #p, #h>>::DOMAINS,
                            periods: <#name as runtime::Element<#d, #p, #h>>::PERIODS,
                            extents: <#name as runtime::Element<#d, #p, #h>>::EXTENTS,
                            },
                            kernel,
                            lanes: #lanes,
                            screen: #screen,
                        };
                    &DESCRIPTOR
                };
            }
        }
    }

    /// The call of the kernel with all sizes of this element filled in.
    fn kernel(&self) -> TokenStream {
        let name = &self.element.name;
        let (d, p, h) = self.sizes();
        let q = self.points.len();
        let n = self.slave_nodes + self.master_nodes;
        let padded = (n * d).next_multiple_of(4);
        let vectors = self.vector_flags();
        let interpolated = matches!(self.element.slave, Slave::Interpolated);
        if interpolated {
            quote! {
                runtime::interpolated::<#name, _, #d, #p, #h>(
                    call, nodes, &[#(#vectors),*], memory, target,
                )
            }
        } else {
            quote! {
                runtime::fixed::<#name, _, #d, #p, #h, #n, #q, #padded>(
                    call, nodes, &[#(#vectors),*], target,
                )
            }
        }
    }

    /// The kernel of a batch in lanes, and the function itself.
    fn lanes(&self) -> (TokenStream, TokenStream) {
        let name = &self.element.name;
        let (d, p, h) = self.sizes();
        let n = self.slave_nodes + self.master_nodes;
        let fits = n * d <= MOST_UNKNOWNS && self.parameters.count() <= MOST_PARAMETERS;
        if !self.element.lanes || !fits {
            return (quote! { None }, quote! {});
        }
        let vectors = self.vector_flags();
        let function = quote! {
            fn lanes(run: &mut ::contact_elements::abi::Run<'_>, width: runtime::Width) {
                runtime::evaluate_batch::<#name, _, #d, #p, #h, #n>(
                    run, width, &[#(#vectors),*],
                )
            }
        };
        (quote! { Some(lanes) }, function)
    }

    /// What tells open contacts without their projection, where it can, and the function itself.
    fn screen(&self) -> (TokenStream, TokenStream) {
        let name = &self.element.name;
        let (d, p, h) = self.sizes();
        let n = self.slave_nodes + self.master_nodes;
        let is_pair = matches!(self.element.slave, Slave::Point) && self.master_nodes > 0;
        if !is_pair || p + 1 != d {
            return (quote! { None }, quote! {});
        }
        let vectors = self.vector_flags();
        let function = quote! {
            fn screen(
                run: &::contact_elements::abi::Run<'_>,
                place: (usize, usize),
                bounds: &mut [f64; runtime::SCREENED],
            ) -> u32 {
                runtime::screen::<#name, _, #d, #p, #h, #n>(
                    run, place, &[#(#vectors),*], bounds,
                )
            }
        };
        let value = quote! {
            if runtime::is_screened::<#name, #d, #p, #h, #n>() {
                Some(screen)
            } else {
                None
            }
        };
        (value, function)
    }

    /// Operations of one evaluation of the point programs, the law included.
    fn operations(&self) -> usize {
        let law = Emitted::new(&law_program(&self.element.law), "");
        let tangential = self.tangential_law();
        self.emitted()
            .chain([&law])
            .chain(&tangential)
            .map(|emitted| emitted.program.operations())
            .sum()
    }

    /// The programs of the tangential law and of that of rolling.
    fn tangential_law(&self) -> Vec<Emitted> {
        let tangential = self.element.tangential.iter().map(|own| &own.law);
        let rolling = self.element.rolling.iter().map(|own| &own.law);
        let programs = |law: &Rc<TangentialLaw>| {
            let sliding = (!law.bound.is_empty()).then(|| sliding_program(law));
            [Some(friction_program(law)), sliding]
        };
        tangential
            .chain(rolling)
            .flat_map(programs)
            .flatten()
            .map(|program| Emitted::new(&program, ""))
            .collect()
    }

    /// FNV-1a hash of the programs' tables: changes when the emitted code means something else.
    fn formulation(&self) -> u64 {
        let mut all = String::new();
        let mut absorb = |text: &str| all.push_str(text);
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
        for emitted in self.tangential_law() {
            absorb(&emitted.table().to_string());
        }
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
        if self.element.enforcement != Enforcement::Penalty {
            absorb(&format!("{:?}", self.element.enforcement));
        }
        if self.rolling().is_some() {
            absorb(&self.rolling_layout().to_string());
        }
        if self.angle.is_some() {
            absorb(&self.angle_offset().to_string());
        }
        fnv(&all)
    }
}
