//! The structs of `contact_elements.h`, read from its text.

/// A struct and its fields in order.
pub struct Struct {
    /// Name of the type.
    pub name: String,
    /// Names of the fields.
    pub fields: Vec<String>,
}

/// Every struct with a body.
pub fn structs(header: &str) -> Vec<Struct> {
    let text = without_comments(header);
    let mut list = Vec::new();
    let mut rest = text.as_str();
    while let Some((_, after)) = rest.split_once("typedef struct ") {
        rest = after;
        let Some((head, body)) = after.split_once('{') else {
            break;
        };
        // `typedef struct cte_element cte_element;` has no body.
        if head.contains(';') {
            continue;
        }
        let (body, _) = body.split_once('}').expect("the end of a struct");
        list.push(Struct {
            name: head.trim().to_string(),
            fields: body.split(';').flat_map(fields).collect(),
        });
    }
    list
}

/// Names that one declaration gives: `int64_t a, b`, `double *x`, `uint64_t r[8]`, `int32_t (*f)(int)`.
fn fields(declaration: &str) -> Vec<String> {
    if let Some((_, after)) = declaration.split_once("(*") {
        let (name, _) = after.split_once(')').expect("a function pointer");
        return vec![name.trim().to_string()];
    }
    declaration
        .split(',')
        .filter_map(|part| {
            let name = part.split('[').next()?.trim();
            let start = name.rfind(|c: char| !c.is_ascii_alphanumeric() && c != '_');
            let name = &name[start.map_or(0, |position| position + 1)..];
            (!name.is_empty()).then(|| name.to_string())
        })
        .collect()
}

fn without_comments(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some((before, comment)) = rest.split_once("/*") {
        plain.push_str(before);
        rest = comment.split_once("*/").map_or("", |(_, after)| after);
    }
    plain + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_field_is_read() {
        let text = "typedef struct a a; /* { */ typedef struct b {\n uint32_t n; /* x; */\n\
                    int64_t p, q; const double *x; uint64_t r[8]; int32_t (*f)(const b *, int); } b;";
        let list = structs(text);
        assert_eq!(list.len(), 1);
        assert_eq!(list[0].name, "b");
        assert_eq!(list[0].fields, ["n", "p", "q", "x", "r", "f"]);
    }
}
