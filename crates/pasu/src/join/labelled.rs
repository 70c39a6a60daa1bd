//! What is joined.

/// One of the bodies that are joined: closed triangles in the numbers of a file, each with a number of whoever asks.
pub(crate) struct Labelled<'a> {
    pub(crate) name: &'a str,
    /// `x, y, z` per vertex, one vertex per point.
    pub(crate) positions: &'a [f32],
    /// Three vertex numbers per triangle, counter-clockwise from outside.
    pub(crate) indices: &'a [u32],
    /// One number per triangle, which goes along with all that is left of it.
    pub(crate) labels: Vec<u32>,
}
