//! The check before an evaluation: does anything vanish that the element divides by?

use proc_macro2::TokenStream;
use quote::quote;

use super::program::Emitted;
use crate::ir::Program;
use crate::linearise::divisors::divisor_program;

/// Least length that a distance function may divide by [length].
const LEAST_LENGTH: f64 = 1e-30;
/// Least area that a moving measure may divide by [length^2].
const LEAST_AREA: f64 = 1e-60;

/// What an element divides by.
#[derive(Default)]
pub struct Divisors {
    /// In the gap and the tangent of a distance function.
    pub distance: Option<Emitted>,
    /// In the variation of a moving measure.
    pub measure: Option<Emitted>,
}

impl Divisors {
    /// Divisors of the tangent of a distance function and of a moving measure, where the element has them.
    pub fn new(distance: Option<&Program>, measure: Option<&Program>) -> Self {
        let of = |program: Option<&Program>, name: &str| {
            let program = divisor_program(program?, name)?;
            Some(Emitted::new(&program, ""))
        };
        Self {
            distance: of(distance, "distance_divisors"),
            measure: of(measure, "measure_divisors"),
        }
    }

    /// The functions.
    pub fn functions(&self) -> TokenStream {
        [&self.distance, &self.measure]
            .into_iter()
            .flatten()
            .map(Emitted::guarded_function)
            .collect()
    }

    /// The trait method; the default serves where nothing can vanish. `distance`: inputs of the tangent
    /// program; `measure`: statements that define `t`, and the inputs of the measure program.
    pub fn method(
        &self,
        (d, p, h): (usize, usize, usize),
        distance: &[TokenStream],
        (tangents, measure): (TokenStream, &[TokenStream]),
    ) -> TokenStream {
        if self.distance.is_none() && self.measure.is_none() {
            return quote! {};
        }
        let distance = self.distance.as_ref().map(|program| {
            let function = &program.function;
            quote! {
                regular &= runtime::can_divide(&#function(&[#(#distance),*]), #LEAST_LENGTH);
            }
        });
        let measure = self.measure.as_ref().map(|program| {
            let function = &program.function;
            quote! {
                #tangents
                regular &= runtime::can_divide(&#function(&[#(#measure),*]), #LEAST_AREA);
            }
        });
        quote! {
            #[inline(always)]
            fn is_regular(
                point: usize,
                x: &[[f64; #d]],
                vectors: &runtime::Vectors<#d, #p, #h>,
                parameters: &[f64],
            ) -> bool {
                let mut regular = true;
                #distance
                #measure
                regular
            }
        }
    }
}
