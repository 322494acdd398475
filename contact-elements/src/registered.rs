//! An element with its kernels, as a library holds it.

use core::ops::Deref;

use crate::codes::request;
use crate::descriptor::Descriptor;
use crate::evaluation::{BatchKernel, Kernel, ScreenKernel};

/// An element and the kernels that run it; `cte_element` of the C header. It has the fields and methods of its
/// [`Descriptor`].
#[derive(Clone, Copy, Debug)]
pub struct Registered {
    /// What the element is.
    pub descriptor: Descriptor,
    /// The kernel of one contact.
    pub kernel: Kernel,
    /// The kernel in lanes, if the declaration asks for one.
    pub lanes: Option<BatchKernel>,
    /// Recognises open contacts without their projection, for elements that offer it.
    pub screen: Option<ScreenKernel>,
}

impl Registered {
    /// Request bits that the element offers.
    pub fn requests(&self) -> u32 {
        let own = self.descriptor.requests();
        if self.screen.is_some() {
            own | request::SCREEN
        } else {
            own
        }
    }
}

impl Deref for Registered {
    type Target = Descriptor;

    #[inline(always)]
    fn deref(&self) -> &Descriptor {
        &self.descriptor
    }
}
