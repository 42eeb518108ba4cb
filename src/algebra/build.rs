//! From expressions to the normal form, without recursion.

use std::collections::HashMap;

use super::expression::{Expression, Operation};
use super::graph::Graph;
use super::term::{Multiple, NoForm};

/// An expression in normal form, and all that it is made of.
pub(super) struct Normal<'a> {
    pub(super) graph: Graph,
    /// The expression itself.
    pub(super) goal: Multiple,
    /// Every node that was not known to be rational.
    pub(super) nodes: Vec<(&'a Expression, Multiple)>,
}

/// The forms of nodes, by their addresses.
type Forms = HashMap<usize, Multiple>;

impl<'a> Normal<'a> {
    /// The normal form, with enclosures of so many bits.
    pub(super) fn of(root: &'a Expression, bits: u32) -> Result<Self, NoForm> {
        let mut graph = Graph::new(bits);
        let mut forms = Forms::new();
        let mut nodes = Vec::new();
        let mut pending = vec![root];
        while let Some(&node) = pending.last() {
            if forms.contains_key(&node.address()) {
                pending.pop();
                continue;
            }
            let missing = missing_operands(node, &forms);
            if missing.iter().any(Option::is_some) {
                pending.extend(missing.into_iter().flatten());
                continue;
            }
            let form = form_of(node, &mut graph, &forms)?;
            if node.rational().is_none() {
                nodes.push((node, form.clone()));
            }
            forms.insert(node.address(), form);
        }
        let goal = forms[&root.address()].clone();
        Ok(Self { graph, goal, nodes })
    }
}

fn missing_operands<'a>(node: &'a Expression, forms: &Forms) -> [Option<&'a Expression>; 2] {
    if node.rational().is_some() {
        return [None, None];
    }
    let missing = |operand: &&Expression| !forms.contains_key(&operand.address());
    node.operation()
        .operands()
        .map(|operand| operand.filter(missing))
}

/// The form of a node of which the operands have theirs.
fn form_of(node: &Expression, graph: &mut Graph, forms: &Forms) -> Result<Multiple, NoForm> {
    if let Some(value) = node.rational() {
        return Ok(Multiple::rational(value.clone()));
    }
    let form = |operand: &Expression| &forms[&operand.address()];
    match node.operation() {
        Operation::Undefined => Err(NoForm::Undefined),
        Operation::Rational(value) => Ok(Multiple::rational(value.clone())),
        Operation::Negate(a) => Ok(form(a).clone().negated()),
        Operation::Add(a, b) => graph.add(form(a), form(b)),
        Operation::Multiply(a, b) => graph.multiply(form(a), form(b)),
        Operation::Divide(a, b) => {
            let inverse = graph.invert(form(b))?;
            graph.multiply(form(a), &inverse)
        }
        Operation::Root(a) => graph.root(form(a)),
    }
}
