//! The order of an equation.

/// The order of the partial differential equation of one component.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// `s X_uu + t X_vv = p`.
    Second,
    /// `s X_uuuu + t X_uuvv + w X_vvvv = p`.
    Fourth,
}
