//! Built-in elements, declared in the language (`library/elements.contact` of the generator).

contact_macros::library!(elements);
