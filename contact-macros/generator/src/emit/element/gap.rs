//! What is the gap, and does anything vanish that gap or tangent divide by?

use proc_macro2::TokenStream;
use quote::quote;

use super::expressions::components;
use super::facts::Facts;
use super::measure::tangent_inputs;
use crate::emit::parameters::rigid;
use crate::model::{Rule, Slave};

impl Facts<'_> {
    pub(super) fn gap_method(&self) -> TokenStream {
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
            fn gap<T: runtime::Real>(
                vectors: &runtime::Vectors<#d, #p, #h, T>,
                parameters: &[T],
                orientation: T,
            ) -> runtime::Gap<#d, T> {
                let r0 = parameters.get(#r0).copied().unwrap_or(T::constant(0.0));
                let o = gap(&[#(#inputs),*]);
                runtime::Gap { n: [#(#normal),*], distance: o[#distance], gap: o[#gap] }
            }
        }
    }

    pub(super) fn divisors_method(&self) -> TokenStream {
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
    pub(super) fn distance_inputs(&self) -> Vec<TokenStream> {
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
            .map(|index| quote! { parameters.get(#index).copied().unwrap_or(runtime::Real::constant(0.0)) })
            .collect()
    }
}
