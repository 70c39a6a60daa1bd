//! The kernel: rows of a mesh as Fourier sums in single precision, four rows and four columns at a time.
//!
//! [`Kernel`] is the door. From the ground up: `lanes` are four numbers; `waves` what four rows are sums of, in double precision; `copy`, `outline`, `ring` and `copies` the rows
//! that are copies of others; `extent` how large all is; `strands` the waves rounded, with what that costs; `sums`, `place`, `split`, `block` and `quarters`
//! sum them and make positions and normals of that; `doubt` knows which normals that does not hold, and `double` forms these; `circles` goes along a row, `kernel` from row to row.

mod block;
mod circles;
mod copies;
mod copy;
mod double;
mod doubt;
mod extent;
mod kernel;
mod lanes;
mod outline;
mod place;
mod quarters;
mod ring;
mod split;
mod strands;
mod sums;
mod waves;

pub(super) use kernel::Kernel;
