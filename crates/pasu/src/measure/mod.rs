//! What can be measured on a pot: by quadrature on the closed form, each with the error that it may have.

mod bare;
mod column;
mod fill;
mod integral;
mod moments;
mod quantity;
mod rule;
mod search;

pub use quantity::Quantity;
