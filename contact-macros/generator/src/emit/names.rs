//! What the values of a program are called in the emitted function.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span};

use crate::ir::{Node, NodeId, Program};

/// Names of the inputs and of every operation: outputs have their own, the others are `t` with a number.
pub struct Names {
    inputs: Vec<Ident>,
    values: Vec<Option<Ident>>,
}

impl Names {
    /// The names of the values of `program`.
    pub fn new(program: &Program) -> Self {
        let mut taken = BTreeSet::from(["i".to_string()]);
        let inputs = program.inputs.iter();
        let inputs = inputs.map(|name| unique(name, &mut taken)).collect();
        let mut values = vec![None; program.graph.nodes().len()];
        for (name, id) in &program.outputs {
            let id = marked_value(program, *id);
            let value = &mut values[id.0 as usize];
            if value.is_none() && program.graph.node(id).is_operation() {
                *value = Some(unique(name, &mut taken));
            }
        }
        Self { inputs, values }
    }

    /// All inputs in order.
    pub fn inputs(&self) -> &[Ident] {
        &self.inputs
    }

    /// Input number `number`.
    pub fn input(&self, number: u32) -> &Ident {
        &self.inputs[number as usize]
    }

    /// The value of an operation.
    pub fn value(&self, id: NodeId) -> Ident {
        let temporary = || Ident::new(&format!("t{}", id.0), Span::call_site());
        self.values[id.0 as usize].clone().unwrap_or_else(temporary)
    }
}

/// The value behind the marks of terms.
pub fn marked_value(program: &Program, mut id: NodeId) -> NodeId {
    while let Node::Term(inner, _) = program.graph.node(id) {
        id = inner;
    }
    id
}

/// `name` in small letters (so that it is never taken for a constant), with `_` behind it while it is taken, a word
/// of Rust, or the name of a temporary.
fn unique(name: &str, taken: &mut BTreeSet<String>) -> Ident {
    let mut name = name.to_lowercase();
    loop {
        let is_word = syn::parse_str::<Ident>(&name).is_err();
        if !is_word && !is_temporary(&name) && taken.insert(name.clone()) {
            return Ident::new(&name, Span::call_site());
        }
        name.push('_');
    }
}

fn is_temporary(name: &str) -> bool {
    name.strip_prefix('t')
        .is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_differ_from_words_temporaries_and_each_other() {
        let mut taken = BTreeSet::from(["i".to_string()]);
        let names = ["gap", "Gap", "t8", "i", "Fn", "E_0_0", "gap"];
        let unique = names.map(|name| unique(name, &mut taken).to_string());
        assert_eq!(
            unique,
            ["gap", "gap_", "t8_", "i_", "fn_", "e_0_0", "gap__"]
        );
    }
}
