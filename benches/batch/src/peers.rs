//! The hand-written peers of the kit.

use std::hint::black_box;

use libloading::Library;

use crate::states::States;

type Function = unsafe extern "C" fn(*const f64, *const f64, f64, *mut f64, *mut f64);

/// A library of the kit.
pub struct Peer {
    pub name: String,
    given: Function,
    newton: Function,
    _library: Library,
}

impl Peer {
    /// The peers that this machine can run.
    pub fn all(folder: &str) -> Vec<Self> {
        let mut names = vec!["hand_vmv_rows"];
        if std::arch::is_x86_feature_detected!("avx512f") {
            names.push("hand_schur");
        }
        names
            .into_iter()
            .filter_map(|name| Self::new(folder, name))
            .collect()
    }

    fn new(folder: &str, name: &str) -> Option<Self> {
        // SAFETY: the kit's libraries run nothing when they are loaded, and have these functions.
        unsafe {
            let library = Library::new(format!("{folder}/{name}.so")).ok()?;
            let given = *library.get::<Function>(b"peer_pts_q4").ok()?;
            let newton = *library.get::<Function>(b"peer_pts_q4_cpp").ok()?;
            Some(Self {
                name: name.into(),
                given,
                newton,
                _library: library,
            })
        }
    }

    pub fn run(&self, states: &States, given: bool) {
        let (mut residual, mut tangent) = ([0.0; 16], [0.0; 232]);
        let function = if given { self.given } else { self.newton };
        for e in 0..states.count {
            let x = &states.x[15 * e..];
            let start = states.start(given);
            // SAFETY: 15 coordinates, 2 parameters, room for 15 and 225 numbers.
            unsafe {
                function(
                    x.as_ptr(),
                    start[3 * e + 1..].as_ptr(),
                    1000.0,
                    residual.as_mut_ptr(),
                    tangent.as_mut_ptr(),
                );
            }
            black_box((&residual, &tangent));
        }
    }
}
