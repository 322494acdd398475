//! A program as a Rust function of straight-line code, and as a constant table.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::names::{Names, marked_value};
use crate::formulate::Routine;
use crate::ir::{Binary, Node, NodeId, Program, Unary};

/// How the comment of an equation begins.
pub const TAG: &str = "[eq:";

/// Name of the emitted function.
pub fn name(routine: &Routine) -> Ident {
    format_ident!("{}", routine.function)
}

/// Name of the constant table of a shared routine.
pub fn constant(routine: &Routine) -> Ident {
    format_ident!("{}_TABLE", routine.function)
}

/// The shared function, guarded against zero divisors, and its table as a constant of the same name.
pub fn shared_items(routine: &Routine) -> TokenStream {
    let visible = quote! { #[inline(always)] pub(super) };
    let function = function_with(routine, Style::Guarded, &visible);
    let (table, constant) = (table(routine), constant(routine));
    quote! {
        #function
        pub(super) const #constant: Table = #table;
    }
}

/// The function: `fn name<T>(i: &[T; n]) -> [T; m]`, T one number or several side by side.
pub fn function(routine: &Routine) -> TokenStream {
    function_with(routine, Style::Generic, &quote! { #[inline(always)] })
}

/// The function for one number, which divides by 1 instead of 0 and takes a negative radicand as 0: it
/// raises no floating-point exception where the plain one would.
pub fn guarded_function(routine: &Routine) -> TokenStream {
    function_with(routine, Style::Guarded, &quote! { #[inline(always)] })
}

fn function_with(routine: &Routine, style: Style, inline: &TokenStream) -> TokenStream {
    let name = name(routine);
    let program = &routine.program;
    let names = Names::new(program);
    let printer = Printer {
        program,
        names: &names,
        style,
    };
    let (count, outputs) = (program.inputs.len(), program.outputs.len());
    let comment = format!(
        " {} operations, {count} inputs, {outputs} outputs.",
        program.operations()
    );
    let body = printer.statements();
    let results = program.outputs.iter();
    let results = results.map(|&(_, value)| printer.operand(value));
    let inputs = names.inputs();
    let (generics, number) = match style {
        Style::Generic => (
            quote! { <T: ::contact_elements::runtime::Real> },
            quote! { T },
        ),
        Style::Guarded => (quote! {}, quote! { f64 }),
    };
    quote! {
        #[doc = #comment]
        #[allow(clippy::all, unused_variables, unused_doc_comments)]
        #inline
        fn #name #generics(i: &[#number; #count]) -> [#number; #outputs] {
            let [#(#inputs),*] = *i;
            #body
            [#(#results),*]
        }
    }
}

/// The constant `Table { … }` of a routine.
pub fn table(routine: &Routine) -> TokenStream {
    let program = &routine.program;
    let name = &program.name;
    let inputs = &program.inputs;
    let operations = program.graph.nodes().iter().map(|&node| table_entry(node));
    let outputs = program.outputs.iter().map(|(name, id)| {
        let position = position(*id);
        quote! { (#name, #position) }
    });
    let terms = program.terms.iter().map(|term| {
        let (tag, present, reason) = (term.tag, term.present, &term.reason);
        quote! { Term { tag: #tag, present: #present, reason: #reason } }
    });
    let cost = program.operations();
    let function = self::name(routine);
    quote! {
        Table {
            name: #name,
            inputs: &[#(#inputs),*],
            operations: &[#(#operations),*],
            outputs: &[#(#outputs),*],
            terms: &[#(#terms),*],
            cost: #cost,
            compiled: |inputs, outputs| {
                if let Some(inputs) = inputs.first_chunk() {
                    for (to, from) in outputs.iter_mut().zip(#function(inputs)) {
                        *to = from;
                    }
                }
            },
        }
    }
}

/// `Some(table)` where there is a routine.
pub fn optional_table(routine: Option<&Routine>) -> TokenStream {
    match routine {
        Some(routine) => {
            let table = table(routine);
            quote! { Some(#table) }
        }
        None => quote! { None },
    }
}

fn position(id: NodeId) -> u16 {
    u16::try_from(id.0).expect("the budget keeps programs below 65536 nodes")
}

/// What the function of a program works on.
#[derive(Clone, Copy)]
enum Style {
    /// One number or several side by side, as written.
    Generic,
    /// One number, without a floating-point exception at a zero divisor or a negative radicand.
    Guarded,
}

/// A program on its way to a function.
struct Printer<'a> {
    program: &'a Program,
    names: &'a Names,
    style: Style,
}

impl Printer<'_> {
    /// One statement per operation that an output needs; those at a term carry its equation as a comment.
    fn statements(&self) -> TokenStream {
        let needed = self.program.needed();
        let tags = tags(self.program);
        let mut last = &String::new();
        let mut lines = TokenStream::new();
        for (index, &node) in self.program.graph.nodes().iter().enumerate() {
            if !needed[index] || !node.is_operation() {
                continue;
            }
            let name = self.names.value(NodeId(index as u32));
            let value = self.operation(node);
            if let Some(tag) = tags.get(&index).filter(|&tag| tag != last) {
                lines.extend(quote! { #[doc = #tag] });
                last = tag;
            }
            lines.extend(quote! { let #name = #value; });
        }
        lines
    }

    fn operand(&self, id: NodeId) -> TokenStream {
        match self.program.graph.node(id) {
            Node::Constant(bits) => self.literal(f64::from_bits(bits)),
            Node::Input(index) => {
                let input = self.names.input(index);
                quote! { #input }
            }
            Node::Term(inner, _) => self.operand(inner),
            _ => {
                let name = self.names.value(id);
                quote! { #name }
            }
        }
    }

    fn literal(&self, value: f64) -> TokenStream {
        let literal = literal(value);
        match self.style {
            Style::Generic => quote! { T::constant(#literal) },
            Style::Guarded => literal,
        }
    }

    fn operation(&self, node: Node) -> TokenStream {
        let of = |id: NodeId| self.operand(id);
        match (self.style, node) {
            (_, Node::Negate(a)) => {
                let a = of(a);
                quote! { -#a }
            }
            (_, Node::Add(a, b)) => infix(of(a), quote!(+), of(b)),
            (_, Node::Subtract(a, b)) => infix(of(a), quote!(-), of(b)),
            (_, Node::Multiply(a, b)) => infix(of(a), quote!(*), of(b)),
            (Style::Generic, Node::Divide(a, b)) => infix(of(a), quote!(/), of(b)),
            (Style::Generic, Node::Unary(function, a)) => {
                let (name, a) = (Ident::new(unary_name(function), Span::call_site()), of(a));
                quote! { T::#name(#a) }
            }
            (Style::Generic, Node::Binary(function, a, b)) => {
                let (name, a, b) = (binary_name(function), of(a), of(b));
                quote! { T::#name(#a, #b) }
            }
            (Style::Guarded, _) => self.guarded(node),
            (_, Node::Constant(_) | Node::Input(_) | Node::Term(..)) => {
                unreachable!("not an operation")
            }
        }
    }

    fn guarded(&self, node: Node) -> TokenStream {
        let of = |id: NodeId| self.operand(id);
        let library = quote! { ::contact_elements::arithmetic };
        match node {
            Node::Divide(a, b) => {
                let (a, b) = (of(a), of(b));
                quote! { #a / #library::divisor(#b) }
            }
            Node::Unary(Unary::Sqrt, a) => {
                let a = of(a);
                quote! { #library::sqrt(#library::radicand(#a)) }
            }
            Node::Unary(Unary::Ln, a) => {
                let a = of(a);
                quote! { #library::ln(#library::divisor(#library::radicand(#a))) }
            }
            Node::Unary(function, a) => {
                let (name, a) = (Ident::new(unary_name(function), Span::call_site()), of(a));
                quote! { #library::#name(#a) }
            }
            Node::Binary(Binary::Pow, a, b) => {
                let exponent = self.program.graph.value(b);
                let whole = exponent.is_some_and(|exponent| exponent.fract() == 0.0);
                let (a, b) = (of(a), of(b));
                let base = if whole {
                    a
                } else {
                    quote! { #library::radicand(#a) }
                };
                quote! { #library::pow(#library::divisor(#base), #b) }
            }
            Node::Binary(Binary::Atan2, a, b) => {
                let (a, b) = (of(a), of(b));
                quote! { #library::atan2(#a, #b) }
            }
            _ => unreachable!("not an operation"),
        }
    }
}

/// The comment at each operation that a term's coefficient enters, or that is an output marked as a term.
fn tags(program: &Program) -> BTreeMap<usize, String> {
    let tag = |id: NodeId| match program.graph.node(id) {
        Node::Term(_, term) => Some(program.terms[usize::from(term.0)].tag),
        _ => None,
    };
    let mut found: BTreeMap<usize, String> = BTreeMap::new();
    let mut add = |index: usize, tag: &str| {
        let text = found.entry(index).or_default();
        let tag = format!(" {TAG}{tag}]");
        if !text.contains(&tag) {
            text.push_str(&tag);
        }
    };
    for (index, node) in program.graph.nodes().iter().enumerate() {
        if node.is_operation() {
            node.operands()
                .filter_map(tag)
                .for_each(|tag| add(index, tag));
        }
    }
    for &(_, id) in &program.outputs {
        if let Some(tag) = tag(id) {
            add(marked_value(program, id).0 as usize, tag);
        }
    }
    found
}

fn literal(value: f64) -> TokenStream {
    let magnitude = proc_macro2::Literal::f64_suffixed(value.abs());
    if value < 0.0 {
        quote! { (-#magnitude) }
    } else {
        quote! { #magnitude }
    }
}

fn infix(a: TokenStream, operator: TokenStream, b: TokenStream) -> TokenStream {
    quote! { #a #operator #b }
}

fn binary_name(function: Binary) -> Ident {
    let name = match function {
        Binary::Pow => "pow",
        Binary::Atan2 => "atan2",
    };
    Ident::new(name, Span::call_site())
}

fn unary_name(function: Unary) -> &'static str {
    match function {
        Unary::Sqrt => "sqrt",
        Unary::Sin => "sin",
        Unary::Cos => "cos",
        Unary::Tan => "tan",
        Unary::Exp => "exp",
        Unary::Ln => "ln",
    }
}

fn table_entry(node: Node) -> TokenStream {
    let two = |name: &str, a: NodeId, b: NodeId| {
        let name = Ident::new(name, Span::call_site());
        let (a, b) = (position(a), position(b));
        quote! { Operation::#name(#a, #b) }
    };
    let one = |name: &str, a: NodeId| {
        let name = Ident::new(name, Span::call_site());
        let a = position(a);
        quote! { Operation::#name(#a) }
    };
    match node {
        Node::Constant(bits) => {
            let value = literal(f64::from_bits(bits));
            quote! { Operation::Constant(#value) }
        }
        Node::Input(index) => {
            let index = index as u16;
            quote! { Operation::Input(#index) }
        }
        Node::Negate(a) => one("Negate", a),
        Node::Add(a, b) => two("Add", a, b),
        Node::Subtract(a, b) => two("Subtract", a, b),
        Node::Multiply(a, b) => two("Multiply", a, b),
        Node::Divide(a, b) => two("Divide", a, b),
        Node::Unary(function, a) => {
            let name = unary_name(function);
            one(&format!("{}{}", name[..1].to_uppercase(), &name[1..]), a)
        }
        Node::Binary(Binary::Pow, a, b) => two("Pow", a, b),
        Node::Binary(Binary::Atan2, a, b) => two("Atan2", a, b),
        Node::Term(a, term) => {
            let (a, term) = (position(a), term.0);
            quote! { Operation::Term(#a, #term) }
        }
    }
}
