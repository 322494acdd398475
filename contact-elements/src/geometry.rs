//! Built-in geometries, declared in the language (`library/geometries.contact` of the generator).

contact_macros::library!(geometries);
