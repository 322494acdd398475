//! The C library as a host sees it: programs in C, C++ and Fortran, the symbols of the elements, the frozen interface.

mod abi;
mod clients;
mod symbols;
