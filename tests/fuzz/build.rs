//! Shows what libFuzzer offers to the instrumented library, which is loaded at run time.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var_os("CARGO_FEATURE_GUIDED").is_some() {
        println!("cargo::rustc-link-arg-bin=guided=-rdynamic");
    }
}
