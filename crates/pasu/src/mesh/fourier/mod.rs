//! The kernel: rows of a mesh as Fourier sums in single precision, four rows and four columns at a time.
//!
//! [`Kernel`] is the door. From the ground up: `lanes` are four numbers; `waves` what four rows are sums of, in double precision; `copy`, `outline`, `ring` and `copies` the rows
//! that are copies of others; `extent` how large all is; `strands` the waves rounded, with what that costs; `sums`, `form` and `block` sum them; `watch` knows which normals that
//! does not hold; `circles` goes along a row, `kernel` from row to row.

mod block;
mod circles;
mod copies;
mod copy;
mod extent;
mod form;
mod kernel;
mod lanes;
mod outline;
mod ring;
mod strands;
mod sums;
mod watch;
mod waves;

pub(super) use kernel::Kernel;
