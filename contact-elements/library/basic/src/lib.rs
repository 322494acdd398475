//! Built-in elements: normal contact by a penalty, declared in the language (`library/elements.contact` of the
//! generator). `contact-library` has all of them.
#![no_std]

contact_macros::library!(elements);
