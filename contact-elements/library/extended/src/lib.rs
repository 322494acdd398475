//! Built-in elements: friction, multipliers, rolling, gaps with a side, curves at any angle, declared in the language
//! (`library/elements_extended.contact` of the generator). `contact-library` has all of them.
#![no_std]

contact_macros::library!(elements_extended);
