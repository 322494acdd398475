//! Built-in normal laws, declared in the language (`library/laws.contact` of the generator).

contact_macros::library!(laws);
