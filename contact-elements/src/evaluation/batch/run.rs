//! A batch at work: in lanes where its element has a kernel for that, else contact after contact.

use super::arrays::Arrays;
use super::shape::{Layout, Shape};
use crate::batch::block::ROOM;
use crate::batch::contacts::{AllPlaces, Contacts, Places};
use crate::batch::screen::SCREENED;
use crate::codes::{code, request};
use crate::element::gather::Nodes;
use crate::element::receiver::{Call, Wanted};
use crate::error::Error;
use crate::evaluation::inputs::{check_parameters, wanted};
use crate::evaluation::target::{Kernel, Target};
use crate::lanes::Width;
use crate::point::history::History;
use crate::point::values::Status;

/// The kernel of an element for many contacts at once.
pub type BatchKernel = fn(&mut Run<'_>, Width);

/// Which contacts of an element are open wherever their projection lies, and lower bounds of their gaps.
pub type ScreenKernel = fn(&Run<'_>, (usize, usize), &mut [f64; SCREENED]) -> u32;

/// Takes the outputs of the contacts of a batch.
pub(crate) trait Outputs {
    /// Where the outputs of a contact go.
    fn target(&mut self, contact: usize) -> Target<'_>;

    /// The result for a contact.
    fn note(&mut self, contact: usize, result: Result<Status, Error>);
}

/// How many contacts failed, and the first of them with its error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Failures {
    pub(crate) count: usize,
    pub(crate) first: Option<(usize, Error)>,
}

impl Failures {
    pub(crate) const NONE: Self = Self {
        count: 0,
        first: None,
    };
}

/// How far the contacts of a batch have been looked at.
pub(crate) struct Screening {
    /// `None`: all contacts are evaluated.
    pub(crate) kernel: Option<ScreenKernel>,
    /// The first contact that nobody has looked at.
    pub(crate) next: usize,
    /// Where the bits begin.
    pub(crate) first: usize,
    /// Contacts that were looked at and are to be evaluated, one bit each.
    pub(crate) left: u32,
}

impl Screening {
    /// The screening of a batch that begins. A frozen state is not asked for its gap, and a given projection costs
    /// nothing: neither is screened.
    fn new(kernel: Option<ScreenKernel>, shape: &Shape<'_>) -> Self {
        let is_wanted = shape.wants(request::SCREEN)
            && !shape.wants(request::FREEZE_STATE | request::PROJECTION_GIVEN);
        Self {
            kernel: kernel.filter(|_| is_wanted),
            next: 0,
            first: 0,
            left: 0,
        }
    }
}

/// A batch at work.
pub struct Run<'a> {
    pub(crate) shape: &'a Shape<'a>,
    pub(crate) arrays: &'a Arrays<'a>,
    pub(crate) outputs: &'a mut dyn Outputs,
    pub(crate) screening: Screening,
    kernel: Kernel,
    /// Parameters of the first contact.
    shared: Result<&'a [f64], Error>,
    memory: &'a mut [f64],
    pub(crate) failures: Failures,
}

impl core::fmt::Debug for Run<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut shown = f.debug_struct("Run");
        shown.field("contacts", &self.shape.count);
        shown.finish_non_exhaustive()
    }
}

impl<'a> Run<'a> {
    pub(crate) fn new(
        kernel: Kernel,
        screen: Option<ScreenKernel>,
        shape: &'a Shape<'a>,
        arrays: &'a Arrays<'a>,
        outputs: &'a mut dyn Outputs,
        memory: &'a mut [f64],
    ) -> Self {
        let first = arrays.parameters(shape, 0);
        Self {
            shape,
            arrays,
            outputs,
            screening: Screening::new(screen, shape),
            kernel,
            shared: check_parameters(shape.element, first).map(|()| first),
            memory,
            failures: Failures::NONE,
        }
    }

    fn one(&mut self, contact: usize) -> Result<Status, Error> {
        let (shape, arrays) = (self.shape, self.arrays);
        let parameters = arrays.parameters(shape, contact);
        check_parameters(shape.element, parameters)?;
        let call = Call {
            parameters,
            history: arrays.history(shape, contact),
            slave_row: arrays.slave_row(shape, contact),
            wanted: wanted(shape.form.request),
        };
        let nodes = arrays.nodes(shape, contact);
        let mut target = self.outputs.target(contact);
        let summary = (self.kernel)(&call, &nodes, self.memory, &mut target)?;
        if shape.wants(request::SYMMETRISE) {
            target.symmetrise();
        }
        Ok(summary.status)
    }

    #[inline]
    pub(crate) fn note(&mut self, contact: usize, result: Result<Status, Error>) {
        self.outputs.note(contact, result);
        if let Err(error) = result {
            self.failures.first.get_or_insert((contact, error));
            self.failures.count += 1;
        }
    }
}

impl Contacts for Run<'_> {
    type Receiver<'r>
        = Target<'r>
    where
        Self: 'r;

    #[inline(always)]
    fn next(&mut self, numbers: &mut [usize; ROOM]) -> usize {
        self.next_to_evaluate(numbers)
    }

    #[inline(always)]
    fn wanted(&self) -> Wanted {
        wanted(self.shape.form.request)
    }

    #[inline(always)]
    fn reports(&self) -> bool {
        self.shape.wants(request::OUTPUT | request::HISTORY)
    }

    #[inline(always)]
    fn have_same_parameters(&self) -> bool {
        self.shape.parameter_stride == 0
    }

    #[inline(always)]
    fn parameters(&self, contact: usize) -> Option<&[f64]> {
        if self.have_same_parameters() {
            return self.shared.ok();
        }
        let own = self.arrays.parameters(self.shape, contact);
        check_parameters(self.shape.element, own).ok().map(|()| own)
    }

    #[inline(always)]
    fn history(&self, contact: usize) -> Option<History<'_>> {
        self.arrays.history(self.shape, contact)
    }

    #[inline(always)]
    fn nodes(&self, contact: usize) -> Nodes<'_> {
        self.arrays.nodes(self.shape, contact)
    }

    #[inline(always)]
    fn places(&self) -> Option<AllPlaces<'_>> {
        let (shape, arrays) = (self.shape, self.arrays);
        let places = |values, layout: Layout| Places {
            values,
            contact_stride: layout.element,
            node_stride: layout.node,
        };
        if shape.x.component != 1 || arrays.u.is_some() && shape.u.component != 1 {
            return None;
        }
        Some(AllPlaces {
            x: places(arrays.x, shape.x),
            u: arrays.u.map(|u| places(u, shape.u)),
            connectivity: arrays.connectivity,
        })
    }

    #[inline(always)]
    fn receiver(&mut self, contact: usize) -> Target<'_> {
        self.outputs.target(contact)
    }

    #[inline(never)]
    fn evaluate_alone(&mut self, contact: usize) {
        let result = self.one(contact);
        self.note(contact, result);
    }

    #[inline(always)]
    fn settle(&mut self, contact: usize, status: Status) {
        if self.shape.wants(request::SYMMETRISE) {
            self.outputs.target(contact).symmetrise();
        }
        self.note(contact, Ok(status));
    }
}

impl Failures {
    /// The result of a batch: the first failure, in the order of the contacts.
    pub(crate) fn outcome(&self) -> Result<(), Error> {
        match self.first {
            None => Ok(()),
            Some((contact, error)) => Err(Error {
                code: code::CUT_BACK,
                index: contact,
                ..error
            }),
        }
    }
}
