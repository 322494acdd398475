//! What can be read, and the message for what cannot.

use super::{Expr, File, Item, Statement, Value};
use crate::diagnostics::testing::{assert_mistake, mistakes};

fn read(text: &str) -> File {
    syn::parse_str(text).expect("reading never fails on tokens")
}

/// The expression in prefix notation.
fn prefix(expr: &Expr) -> String {
    match expr {
        Expr::Number(value, _) => value.to_string(),
        Expr::Name(name) => name.to_string(),
        Expr::Negate(x, _) => format!("(neg {})", prefix(x)),
        Expr::Binary(operator, x, y) => format!("({operator:?} {} {})", prefix(x), prefix(y)),
        Expr::Call(name, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(prefix).collect();
            format!("({name} {})", arguments.join(" "))
        }
    }
}

fn expression(text: &str) -> String {
    let file = read(&format!("normal law L(g) {{ N = {text}; }}"));
    assert!(file.mistakes.is_empty(), "{:?}", file.mistakes);
    let Item::Law(law) = &file.items[0] else {
        panic!()
    };
    let Statement::Field(field) = &law.body.statements[0] else {
        panic!()
    };
    let Value::Expr(expr) = &field.value else {
        panic!()
    };
    prefix(expr)
}

#[test]
fn operators_bind_as_in_mathematics() {
    assert_eq!(expression("a - b - c"), "(Subtract (Subtract a b) c)");
    assert_eq!(expression("a + b*c/d"), "(Add a (Divide (Multiply b c) d))");
    assert_eq!(expression("-a*b"), "(Multiply (neg a) b)");
    assert_eq!(expression("a*-b"), "(Multiply a (neg b))");
    assert_eq!(expression("a-1"), "(Subtract a 1)");
    assert_eq!(expression("1-2.5e-3"), "(Subtract 1 0.0025)");
    assert_eq!(expression("--(a + 1_000)"), "(neg (neg (Add a 1000)))");
    assert_eq!(expression("atan2(y, -x,)"), "(atan2 y (neg x))");
}

#[test]
fn a_substituted_expression_is_one_operand() {
    use proc_macro2::{Delimiter, Group, TokenTree};
    let sum = TokenTree::from(Group::new(Delimiter::None, quote::quote!(a + b)));
    let file: File = syn::parse2(quote::quote!(normal law L(g) { N = 2*#sum; })).unwrap();
    let Item::Law(law) = &file.items[0] else {
        panic!("{:?}", file.mistakes)
    };
    let Statement::Field(field) = &law.body.statements[0] else {
        panic!()
    };
    let Value::Expr(expr) = &field.value else {
        panic!()
    };
    assert_eq!(prefix(expr), "(Multiply 2 (Add a b))");
}

/// A law whose traction is `text`.
fn law(text: &str) -> String {
    format!("normal law Soft(g; e) {{\n    N = {text};\n}}")
}

#[test]
fn unknown_items() {
    assert_mistake(
        "«surfce Facet(u, v) in triangle { N = [1 - u - v, u, v]; }",
        "unknown item `surfce`",
        "did you mean `surface`?",
    );
    assert_mistake(
        "«distance Ball(x, y) { d = x; }",
        "unknown item `distance`",
        "did you mean `rigid distance`?",
    );
    assert_mistake(
        "element E { slave: point; master: Quad4; normal: Penalty; } «export mine;",
        "unknown item `export`",
        "`export PREFIX;` stands once, before all items",
    );
    assert_mistake(
        "«law Soft(g) { N = g; }",
        "unknown item `law`",
        "did you mean `normal law` or `tangential law`?",
    );
    assert_mistake(
        "«friction law Rub(p, s; e) { stiffness = e; }",
        "unknown item `friction`",
        "did you mean `tangential law`?",
    );
    assert_mistake(
        "«struct Soft { x: f64 }",
        "unknown item `struct`",
        "an item starts with `surface`, `curve`, `rigid surface`, `rigid curve`, `rigid distance`, \
         `normal law`, `tangential law` or `element`",
    );
    assert_mistake(
        "«42;",
        "expected an item, found `42`",
        "an item starts with `surface`, `curve`, `rigid`, `normal law`, `tangential law` or `element`",
    );
    assert_mistake(
        "rigid «surfac Flat(u, v) { rho = [u, v, 0]; }",
        "unknown kind of rigid geometry `surfac`",
        "did you mean `rigid surface`?",
    );
    assert_mistake(
        "rigid «point Flat(u, v) { rho = [u, v, 0]; }",
        "unknown kind of rigid geometry `point`",
        "write `rigid surface`, `rigid curve` or `rigid distance`",
    );
    assert_mistake(
        "«#[inline] element E { slave: point; master: Quad4; normal: Penalty; }",
        "only doc comments can stand before an item",
        "remove the attribute; choices are entries of the element",
    );
}

#[test]
fn words_without_law() {
    assert_mistake(
        "normal «lw Soft(g; e) { N = e*g; }",
        "expected `law` after `normal`, found `lw`",
        "write `normal law Name(g; parameter: \"unit\") { N = ..; }`",
    );
    assert_mistake(
        "tangential «Rub(p, s; e) { stiffness = e; }",
        "expected `law` after `tangential`, found `Rub`",
        "write `tangential law Name(pressure, slip; parameter: \"unit\") { stiffness = ..; }`",
    );
}

#[test]
fn heads() {
    assert_mistake(
        "curve Arc «{ N = [1]; }",
        "expected `(`, found `{`",
        "write `Name(coordinates; parameters)`",
    );
    assert_mistake(
        "curve «fn(t) in line { N = [1]; }",
        "expected a name, found `fn`",
        "names are made of letters, digits and `_`; words of Rust are taken",
    );
    assert_mistake(
        "curve Arc(t «s) in line { N = [1]; }",
        "expected `,`, `;` or `)`, found `s`",
        "write `(coordinates; name: \"unit\" in (lower, upper), ..)`",
    );
    assert_mistake(
        "normal law Soft(g; e: «length) { N = e*g; }",
        "expected a unit, found `length`",
        "write the unit as text, such as `\"force/length\"`, or `\"1\"`",
    );
    let range = "write `in (lower, upper)`, or `in [lower, upper]` if the bounds are allowed";
    assert_mistake(
        "normal law Soft(g; e in «0) { N = e*g; }",
        "expected a range, found `0`",
        range,
    );
    assert_mistake(
        "normal law Soft(g; e in (0«)) { N = e*g; }",
        "expected `,`, found the end",
        range,
    );
    assert_mistake(
        "normal law Soft(g; e in (0, 1 «2)) { N = e*g; }",
        "expected the end of the range, found `2`",
        range,
    );
    assert_mistake(
        "normal law Soft(g; e in (0, «big)) { N = e*g; }",
        "expected a bound, found `big`",
        "a bound is a number or `inf`, with or without `-`",
    );
    assert_mistake(
        "curve Arc(t) in interval(0 «1) { N = [1]; }",
        "expected `,`, found `1`",
        "bounds are separated by commas",
    );
    assert_mistake(
        "rigid surface Flat(u, v) «= [u, v, 0];",
        "expected `{`, found `=`",
        "an item ends with a block: `{ name = value; }`",
    );
}

#[test]
fn statements() {
    assert_mistake(
        "normal law Soft(g; e) {\n    let a = e*g\n    «N = a;\n}",
        "expected an operator or `;`, found `N`",
        "a product is written `a*b`; a statement ends with `;`",
    );
    assert_mistake(
        "curve Arc(t) in line { N = [1 - t, t] «}",
        "expected `;`, found the end",
        "every statement and every entry ends with `;`",
    );
    assert_mistake(
        "normal law Soft(g; e) { N «: e*g; }",
        "expected `=`, found `:`",
        "a statement is `let name = value;` or `name = value;`",
    );
    assert_mistake(
        "rigid curve Line(u) { rho = [u, 0]; projection(x «+ 1, y) = [x]; }",
        "expected `,` or `)`, found `+`",
        "the arguments are names",
    );
}

#[test]
fn tangential_laws_are_read_like_normal_ones() {
    let file = read(
        "/// Doc.
         tangential law Rub(p, s; e: \"force\", m) { stiffness = e; let a = m*p; bound = [a, 2*a]; }",
    );
    assert!(file.mistakes.is_empty(), "{:?}", file.mistakes);
    let Item::TangentialLaw(law) = &file.items[0] else {
        panic!()
    };
    assert_eq!((file.items[0].name(), &*law.docs), (&law.name, "Doc."));
    let head = &law.head;
    assert_eq!((head.coordinates.len(), head.parameters.len()), (2, 2));
    let [
        Statement::Field(stiffness),
        Statement::Let(..),
        Statement::Field(bound),
    ] = law.body.statements.as_slice()
    else {
        panic!()
    };
    assert!(matches!(&stiffness.value, Value::Expr(_)));
    assert!(matches!(&bound.value, Value::List(values) if values.len() == 2));
    assert_mistake(
        "tangential law Rub(p, s; e) { stiffness = e; bound = e*«[p, s]; }",
        "a list cannot stand inside an expression",
        "lists stand alone, as in `N = [a, b];`",
    );
}

#[test]
fn entries() {
    assert_mistake(
        "element E { slave «= point; master: Quad4; normal: Penalty; }",
        "expected `:`, found `=`",
        "an entry of an element is `key: value;`",
    );
    assert_mistake(
        "element E { slave: point«, master: Quad4; normal: Penalty; }",
        "expected `;`, found `,`",
        "every statement and every entry ends with `;`",
    );
    assert_mistake(
        "element E { slave: Quad4 at gauss(2, «n); master: Quad4; normal: Penalty; }",
        "expected a whole number, found `n`",
        "write a whole number, such as `2`",
    );
    assert_mistake(
        "element E { slave: Quad4 at gauss(«2u8, 2); master: Quad4; normal: Penalty; }",
        "expected a whole number, found `2u8`",
        "write a whole number, such as `2`",
    );
}

#[test]
fn operators_that_do_not_exist() {
    let comparison = "comparisons stand in `active` and `valid` only, once, as `g < e` or `g > e`";
    let cases = [
        ("g «^ 2", "^", "write `x*x` or `pow(x, y)`"),
        ("g «** 2", "**", "write `x*x` or `pow(x, y)`"),
        ("g«.sqrt()", ".", "write `f(x)` for a function of x"),
        (
            "g «% 2",
            "%",
            "the operators are `+`, `-`, `*`, `/`; functions are written `f(x)`",
        ),
        ("g «<= e", "<=", comparison),
        ("g «== e", "==", comparison),
        ("0 < g «< e", "<", comparison),
        ("(g «< e)", "<", comparison),
        ("sin(g «> e)", ">", comparison),
        (
            "g < 0 «&& g > e",
            "&",
            "a law has one half line of gaps in `active` and one in `valid`",
        ),
    ];
    for (text, operator, hint) in cases {
        assert_mistake(
            &law(text),
            &format!("`{operator}` cannot stand in an expression"),
            hint,
        );
    }
}

#[test]
fn operands_that_do_not_exist() {
    let cases = [
        (
            "«2xi",
            "`2xi` is not a number",
            "write `2*xi` for a product",
        ),
        (
            "«2.0f64*g",
            "`2.0f64` is not a number",
            "write `2.0` without a type",
        ),
        (
            "«0x10",
            "`0x10` is not a number",
            "numbers are decimal, such as `2`, `0.5` or `1e-3`",
        ),
        (
            "«\"two\"",
            "`\"two\"` is not a number",
            "numbers are decimal, such as `2`, `0.5` or `1e-3`",
        ),
        (
            "e*«",
            "expected an expression, found `;`",
            "an expression is made of numbers, names, `+ - * /`, brackets and functions",
        ),
        (
            "e*«[g]",
            "a list cannot stand inside an expression",
            "lists stand alone, as in `N = [a, b];`",
        ),
        (
            "2 «g",
            "expected an operator or `;`, found `g`",
            "a product is written `a*b`; a statement ends with `;`",
        ),
        (
            "«let",
            "expected a name, found `let`",
            "names are made of letters, digits and `_`; words of Rust are taken",
        ),
    ];
    for (text, message, hint) in cases {
        assert_mistake(&law(text), message, hint);
    }
}

#[test]
fn reading_goes_on_after_a_mistake() {
    let text = "\
normal law Soft(g; e) {
    let a = g ^ 2;
    N = e*(a + );
    W = 2 e;
}
curve Arc { N = [t]; }
element E { slave = point; master: Arc; normal: Soft }
";
    let places: Vec<String> = mistakes(text)
        .iter()
        .map(|mistake| mistake.split(' ').next().unwrap().to_string())
        .collect();
    assert_eq!(places, ["2:15", "3:16", "4:11", "6:11", "7:19", "7:54"]);
}

#[test]
fn broken_items_are_remembered_by_name() {
    let file = read("curve Arc { } element E { }");
    assert_eq!(file.broken, ["Arc"]);
    assert_eq!(file.items[0].name(), "E");
}
