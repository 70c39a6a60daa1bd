//! How it is known which normals single precision does not hold.

use super::lanes::Lanes;

/// Where `|X_u x X_v|^2` is less, beside tangents of about 1, single precision has lost digits of it or soon will.
pub(super) const LEAST_SQUARE: f32 = 1e-30;

/// How many rows are asked normal by normal after one in which it mattered.
pub(super) const WARY_ROWS: u32 = 16;

/// When a normal of a row is known to be off.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// It is where `tilt_u |X_v|^2 + tilt_v |X_u|^2 > |X_u x X_v|^2`.
    pub(super) tilt: [Lanes; 2],
    /// It is not where `|X_u x X_v|^2` is more than this.
    pub(super) steepest: Lanes,
}

/// A way of asking for them.
pub(super) trait Doubt: Copy {
    /// All normals are sure.
    const SURE: Self;
    /// Whether rows are asked as a whole, as most are: only these have loops for every kind of row.
    const IS_WHOLE: bool;
    /// What is seen of four normals, given `X_u`, `X_v` and the squared length of their product.
    fn look(limits: &Limits, du: [Lanes; 3], dv: [Lanes; 3], squared: Lanes) -> Self;
    fn and(self, other: Self) -> Self;
    fn is_sure(self) -> bool;
    /// Notes the lanes of a block that are unsure.
    fn keep(seen: [Self; 4], unsure: &mut [u8; 4]);
}

/// The lanes whose normals are unsure, as bits.
#[derive(Clone, Copy)]
pub(super) struct EachNormal(u8);

impl EachNormal {
    #[inline(always)]
    pub(super) fn lanes(self) -> u8 {
        self.0
    }
}

impl Doubt for EachNormal {
    const SURE: Self = EachNormal(0);
    const IS_WHOLE: bool = false;

    #[inline(always)]
    fn look(limits: &Limits, [ux, uy, uz]: [Lanes; 3], [vx, vy, vz]: [Lanes; 3], squared: Lanes) -> Self {
        let tilted = limits.tilt[0] * (vx * vx + vy * vy + vz * vz) + limits.tilt[1] * (ux * ux + uy * uy + uz * uz);
        // Not the other way round: what is not a number is unsure too.
        EachNormal(!((tilted + LEAST_SQUARE).simd_lt(squared).to_bitmask() as u8) & 15)
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        EachNormal(self.0 | other.0)
    }

    #[inline(always)]
    fn is_sure(self) -> bool {
        self.0 == 0
    }

    #[inline(always)]
    fn keep(seen: [Self; 4], unsure: &mut [u8; 4]) {
        *unsure = seen.map(|each| each.0);
    }
}

/// Lanes all of whose bits are set where no normal so far is so short that any could be unsure.
#[derive(Clone, Copy)]
pub(super) struct WholeRow(Lanes);

impl WholeRow {
    /// The lanes whose normals are so short that they could be unsure, as bits.
    #[inline(always)]
    pub(super) fn short_lanes(self) -> u8 {
        !(self.0.to_bitmask() as u8) & 15
    }
}

impl Doubt for WholeRow {
    const SURE: Self = WholeRow(ALL_BITS);
    const IS_WHOLE: bool = true;

    #[inline(always)]
    fn look(limits: &Limits, _du: [Lanes; 3], _dv: [Lanes; 3], squared: Lanes) -> Self {
        WholeRow(limits.steepest.simd_lt(squared))
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        WholeRow(self.0 & other.0)
    }

    #[inline(always)]
    fn is_sure(self) -> bool {
        self.0.to_bitmask() & 15 == 15
    }

    #[inline(always)]
    fn keep(_seen: [Self; 4], _unsure: &mut [u8; 4]) {}
}

const ALL_BITS: Lanes = Lanes::new([f32::from_bits(u32::MAX); 4]);
