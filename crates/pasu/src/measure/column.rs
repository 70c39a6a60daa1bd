//! The inside of a pot, column by column: how high it is, where it is wet, and where water runs out.

use core::f64::consts::TAU;

use glam::DVec3;

use crate::face::{Face, FaceJet, FaceKind, FaceWalk, Seams};
use crate::numeric::grid::Grid;
use crate::numeric::{brent, illinois, minima};

/// One face of the inside, run through from the middle of the floor to the rim.
#[derive(Clone, Copy)]
pub(crate) struct Link<'a> {
    face: &'a dyn Face,
    /// Whether `a` of the face runs the other way.
    is_reversed: bool,
}

/// Places of a link one after the other.
pub(crate) struct LinkWalk<'a> {
    walk: Box<dyn FaceWalk + 'a>,
    is_reversed: bool,
}

impl LinkWalk<'_> {
    /// As [`Link::jet`].
    pub(crate) fn jet(&mut self, s: f64, v: f64) -> FaceJet {
        self.walk.jet(if self.is_reversed { 1.0 - s } else { s }, v)
    }

    /// Height and its derivative by `s`.
    fn height(&mut self, s: f64, v: f64) -> (f64, f64) {
        let jet = self.jet(s, v);
        (jet.position.z, if self.is_reversed { -jet.da.z } else { jet.da.z })
    }

    fn sample(&mut self, link: usize, s: f64, v: f64) -> Sample {
        let (z, slope) = self.height(s, v);
        Sample { link, s, z, slope }
    }
}

impl<'a> Link<'a> {
    /// One place after the other.
    pub(crate) fn walk(&self) -> LinkWalk<'a> {
        LinkWalk { walk: self.face.walk(), is_reversed: self.is_reversed }
    }

    /// 1 where the sense of the chain times that round the axis points out of the clay, otherwise -1.
    pub(crate) fn outward(&self) -> f64 {
        if self.is_reversed { -self.face.outward() } else { self.face.outward() }
    }

    pub(crate) fn face(&self) -> &dyn Face {
        self.face
    }

    /// The stretch of a column between two places, in the coordinates in which the face's seams are straight, ascending.
    pub(crate) fn straight(&self, (from, to): (f64, f64), v: f64) -> (f64, f64) {
        let [from, to] = [from, to].map(|s| self.face.straight(if self.is_reversed { 1.0 - s } else { s }, v));
        (from.min(to), from.max(to))
    }

    /// The face at `s` in [0, 1] from the floor to the rim.
    pub(crate) fn jet(&self, s: f64, v: f64) -> FaceJet {
        self.face.jet(if self.is_reversed { 1.0 - s } else { s }, v)
    }

    /// Height and its derivative by `s`.
    fn height(&self, s: f64, v: f64) -> (f64, f64) {
        self.walk().height(s, v)
    }

    /// Cells in which at most one extreme of the height is looked for.
    pub(crate) fn cells(&self) -> usize {
        match self.face.kind() {
            // Straight.
            FaceKind::Floor | FaceKind::Underside | FaceKind::FootRing | FaceKind::Recess | FaceKind::Lid => 2,
            FaceKind::Rim => 8,
            _ => 40,
        }
    }
}

/// The faces that water touches: floor, lining and rim, in this order.
pub(crate) struct Inside<'a> {
    links: Vec<Link<'a>>,
    /// The seams of each face.
    seams: Vec<Option<Seams>>,
    /// The middle of the rim and the direction of the axis.
    rim: (DVec3, DVec3),
    /// The largest coordinate.
    size: f64,
    /// Columns from which searches begin.
    columns: usize,
    /// Where not all that is below a level up to the crest is wet, but what belongs to a basin: then columns go on beyond their crests.
    chosen: Option<Chosen<'a>>,
    /// The numbers of the links that columns run through.
    looked_at: Vec<usize>,
    /// Whether the last link ends where the first begins.
    is_ring: bool,
}

/// Whether a stretch of a column that is below a level holds water, given with all of its pieces, face by face, `v` and the level.
pub(crate) type Chosen<'a> = Box<dyn Fn(&[Wet], f64, f64) -> bool + 'a>;

/// A point of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sample {
    link: usize,
    s: f64,
    z: f64,
    slope: f64,
}

/// One column of constant `v`, from its beginning to its crest: the highest point after its lowest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Column {
    v: f64,
    samples: Vec<Sample>,
    /// The level at which water leaves this column.
    pub(crate) brim: f64,
    /// Where that is: number of the link and `s`.
    pub(crate) at: (usize, f64),
}

/// A stretch of a column below the level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Wet {
    pub(crate) link: usize,
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Whether it begins, and whether it ends, on the level and not at the end of its link.
    pub(crate) is_cut: [bool; 2],
}

/// Heights that differ by less than this part of the largest coordinate are one.
pub(crate) const LEVEL: f64 = 1e-13;

/// A crest is smooth where what a face rises by in this part of it is rounding.
const SMOOTH: f64 = 1e-6;

/// Low places of the brim that are looked at more closely: petals repeat the same one.
const LOWS: usize = 6;

impl<'a> Inside<'a> {
    /// Chains faces, of which the first comes from the middle of the floor or is the whole inside; `highest` is their highest harmonic.
    pub(crate) fn new(faces: &[&'a dyn Face], axis: DVec3, highest: f64) -> Inside<'a> {
        let mut links: Vec<Link> = Vec::with_capacity(faces.len());
        for (index, &face) in faces.iter().enumerate() {
            let gap = |this: f64, other: &dyn Fn(f64) -> DVec3| {
                [0.3, 2.5].iter().map(|&v| face.jet(this, v).position.distance(other(v))).sum::<f64>()
            };
            // It begins where the one before it ends, or ends where the one after it begins.
            let is_reversed = match (links.last(), faces.get(index + 1)) {
                (Some(before), _) => {
                    let end = |v: f64| before.jet(1.0, v).position;
                    gap(1.0, &end) < gap(0.0, &end)
                }
                (None, Some(next)) => {
                    let near = |this: f64| {
                        gap(this, &|v| next.jet(0.0, v).position).min(gap(this, &|v| next.jet(1.0, v).position))
                    };
                    near(0.0) < near(1.0)
                }
                (None, None) => false,
            };
            links.push(Link { face, is_reversed });
        }
        let columns = (4 * highest.abs().clamp(1.0, 1e4) as usize + 1).max(49);
        let (mut middle, mut size) = (DVec3::ZERO, 0.0f64);
        let lining = links.iter().rfind(|link| link.face.kind() != FaceKind::Rim);
        let v = |j: usize| TAU * j as f64 / columns as f64;
        if let Some(mut lining) = lining.map(Link::walk) {
            middle = (0..columns).fold(middle, |sum, j| sum + lining.jet(1.0, v(j)).position / columns as f64);
        }
        for link in &links {
            let mut walk = link.walk();
            for s in [0.0, 0.5, 1.0] {
                size = (0..columns).fold(size, |size, j| size.max(walk.jet(s, v(j)).position.abs().max_element()));
            }
        }
        let seams = links.iter().map(|link| link.face.seams()).collect();
        let looked_at = (0..links.len()).collect();
        Inside { links, seams, rim: (middle, axis), size, columns, chosen: None, looked_at, is_ring: false }
    }

    /// The same of a tube, whose last face ends where the first begins.
    pub(crate) fn ring(self) -> Inside<'a> {
        Inside { is_ring: true, ..self }
    }

    /// Whether the last link ends where the first begins.
    pub(crate) fn is_ring(&self) -> bool {
        self.is_ring
    }

    /// The number of the link so many further on, or back: once round in a tube.
    pub(crate) fn link_beyond(&self, link: usize, by: isize) -> Option<usize> {
        let (n, beyond) = (self.links.len(), link as isize + by);
        if self.is_ring {
            Some(beyond.rem_euclid(n as isize) as usize)
        } else {
            usize::try_from(beyond).ok().filter(|link| *link < n)
        }
    }

    /// The same, of which only some is wet, and that on no other links.
    pub(crate) fn only(mut self, links: &[usize], chosen: Chosen<'a>) -> Inside<'a> {
        for (number, seams) in self.seams.iter_mut().enumerate() {
            if !links.contains(&number) {
                *seams = None;
            }
        }
        self.looked_at.retain(|number| links.contains(number));
        Inside { chosen: Some(chosen), ..self }
    }

    /// The links that may be wet.
    fn looked_at(&self) -> impl Iterator<Item = (usize, &Link<'a>)> {
        self.looked_at.iter().filter_map(|&number| Some((number, self.links.get(number)?)))
    }

    pub(crate) fn links(&self) -> &[Link<'a>] {
        &self.links
    }

    /// For each link the lines along which its derivatives jump.
    pub(crate) fn seams(&self) -> &[Option<Seams>] {
        &self.seams
    }

    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    /// How many columns to begin with.
    pub(crate) fn n_columns(&self) -> usize {
        self.columns
    }

    /// The position at a place of a column.
    pub(crate) fn position(&self, (link, s): (usize, f64), v: f64) -> DVec3 {
        self.links[link].jet(s, v).position
    }

    /// The column at `v`.
    pub(crate) fn column(&self, v: f64) -> Column {
        let samples = self.looked_at().flat_map(|(link, face)| {
            let cells = face.cells();
            let mut walk = face.walk();
            (0..=cells).map(move |k| walk.sample(link, k as f64 / cells as f64, v))
        });
        self.column_of(v, samples.collect())
    }

    /// The columns at several `v`: as [`Self::column`], and faster, because row by row.
    pub(crate) fn columns(&self, places: &[f64]) -> Vec<Column> {
        let mut samples: Vec<Vec<Sample>> = places.iter().map(|_| Vec::with_capacity(64)).collect();
        for (link, face) in self.looked_at() {
            let cells = face.cells();
            let mut walk = face.walk();
            for k in 0..=cells {
                let s = k as f64 / cells as f64;
                for (samples, &v) in samples.iter_mut().zip(places) {
                    samples.push(walk.sample(link, s, v));
                }
            }
        }
        samples.into_iter().zip(places).map(|(samples, &v)| self.column_of(v, samples)).collect()
    }

    /// Finds the crest of a column.
    fn column_of(&self, v: f64, mut samples: Vec<Sample>) -> Column {
        if self.chosen.is_some() {
            return Column { v, samples, brim: f64::INFINITY, at: (0, 0.0) };
        }
        let eps = LEVEL * self.size;
        let mut lowest = 0;
        for (index, sample) in samples.iter().enumerate() {
            if sample.z < samples[lowest].z - eps {
                lowest = index;
            }
        }
        let mut crest = lowest;
        for (index, sample) in samples.iter().enumerate().skip(lowest) {
            if sample.z > samples[crest].z + eps {
                crest = index;
            }
        }
        // The crest itself lies between samples of one link: that of the highest sample or, where it goes on rising beyond the end of that, the next.
        let top = samples[crest];
        let beside = |of: Sample, other: usize| {
            samples.get(other).copied().filter(|other| other.link == of.link).map(|other| (of, other))
        };
        let onwards = || {
            let next = samples.get(crest + 1).copied().filter(|next| next.link != top.link && next.slope > 0.0)?;
            beside(next, crest + 2)
        };
        let between = if top.slope > 0.0 {
            beside(top, crest + 1).or_else(onwards)
        } else {
            crest.checked_sub(1).and_then(|before| beside(top, before))
        };
        let refined = between.filter(|(one, other)| (other.slope > 0.0) != (one.slope > 0.0) && one.slope != 0.0).map(
            |(one, other)| {
                let link = &self.links[one.link];
                let s = illinois::root((one.s, one.slope), (other.s, other.slope), |s| link.height(s, v).1);
                let (z, slope) = link.height(s, v);
                Sample { link: one.link, s, z, slope }
            },
        );
        let end = samples.iter().rfind(|sample| self.links[sample.link].face.kind() != FaceKind::Rim).copied();
        match refined.filter(|refined| refined.z >= top.z) {
            Some(refined) => {
                samples.retain(|sample| (sample.link, sample.s) < (refined.link, refined.s));
                samples.push(refined);
            }
            None => samples.truncate(crest + 1),
        }
        let top = samples.last().copied().unwrap_or(top);
        let (mut brim, mut at) = (top.z, (top.link, top.s));
        // Where the wall turns in and down again, water leaves by the mouth and does not reach the crest.
        if let Some(end) = end.filter(|end| end.z < top.z && (top.link, top.s) < (end.link, end.s)) {
            let (middle, axis) = self.rim;
            let far = |place| (self.position(place, v) - middle).reject_from_normalized(axis).length();
            if far((end.link, end.s)) < far(at) {
                (brim, at) = (end.z, (end.link, end.s));
            }
        }
        Column { v, samples, brim, at }
    }

    /// The height of the lowest point of the inside, and the column that it is in.
    pub(crate) fn floor(&self) -> (f64, f64) {
        let columns = self.columns;
        let lowest = self.links.iter().map(|link| {
            let mut walk = link.walk();
            let grid = Grid::new(link.cells() + 1, columns, |s, v| -walk.height(s, v).0);
            let place = grid.greatest(|z| *z, |s, v| -walk.height(s, v).0);
            place.map_or((f64::INFINITY, 0.0), |place| (-place.value, place.v))
        });
        lowest.fold((f64::INFINITY, 0.0), |one, other| if other.0 < one.0 { other } else { one })
    }

    /// The columns from which searches begin.
    pub(crate) fn even_columns(&self) -> Vec<Column> {
        let step = TAU / self.columns as f64;
        let places: Vec<f64> = (0..self.columns).map(|j| step * j as f64).collect();
        self.columns(&places)
    }

    /// The level at which water first runs out, and where, if it does so over one crest: the lowest brim of all columns; and how far below that of the nearest of these columns it is.
    pub(crate) fn spill(&self, even: &[Column]) -> (f64, DVec3, f64) {
        let step = TAU / self.columns as f64;
        let brims: Vec<f64> = even.iter().map(|column| column.brim).collect();
        let mut best = (f64::INFINITY, 0.0);
        let mut dip = 0.0;
        for j in minima::round(&brims).into_iter().take(LOWS) {
            let v = step * j as f64;
            let (refined, value) = brent::least(v - step, v + step, 1e-9 * step, |v| self.column(v).brim);
            for (brim, v) in [(brims[j], v), (value, refined)] {
                if brim < best.0 {
                    best = (brim, v);
                    dip = brims[j] - brim;
                }
            }
        }
        let column = self.column(best.1);
        (best.0, self.position(column.at, column.v), dip)
    }

    /// The stretches of a column that are below a level.
    pub(crate) fn wet(&self, column: &Column, level: f64) -> Vec<Wet> {
        // What is level to within rounding is dry in every column, or the rim of an upright pot would be wet here and there.
        let rounding = LEVEL * self.size;
        let level = level - rounding;
        let v = column.v;
        // Just below a smooth crest that is as high as the level a column would end anywhere within a millionth: it ends on the crest.
        let is_brim = |index: usize, sample: &Sample| {
            let is_last = self.chosen.is_none() && index + 1 == column.samples.len();
            is_last && sample.z - level <= 2.0 * rounding && sample.slope.abs() * SMOOTH <= rounding
        };
        let mut wet: Vec<Wet> = Vec::with_capacity(self.links.len());
        let mut start: Option<(f64, bool)> = None;
        let mut put = |link: usize, (from, is_cut): (f64, bool), to: f64, ends: bool| {
            if to > from {
                wet.push(Wet { link, from, to, is_cut: [is_cut, ends] });
            }
        };
        for (index, sample) in column.samples.iter().enumerate() {
            let below = sample.z < level;
            if sample.s == 0.0 || index == 0 {
                start = below.then_some((sample.s, false));
            } else {
                let before = column.samples[index - 1];
                let link = &self.links[sample.link];
                let height = |s: f64| link.height(s, v).0 - level;
                let cut = |from: (f64, f64), to: (f64, f64)| illinois::root(from, to, height);
                let (s0, z0, s1, z1) = (before.s, before.z - level, sample.s, sample.z - level);
                if (z0 < 0.0) != (z1 < 0.0) {
                    let s = if z0 < 0.0 && is_brim(index, sample) { s1 } else { cut((s0, z0), (s1, z1)) };
                    match start.take() {
                        Some(from) => put(sample.link, from, s, true),
                        None => start = Some((s, true)),
                    }
                } else if (z0 < 0.0) == (before.slope > 0.0) && (before.slope > 0.0) != (sample.slope > 0.0) {
                    // An extreme between two samples on one side may lie on the other.
                    let slope = |s: f64| link.height(s, v).1;
                    let s = illinois::root((s0, before.slope), (s1, sample.slope), slope);
                    let z = height(s);
                    if (z < 0.0) != (z0 < 0.0) {
                        let (first, second) = (cut((s0, z0), (s, z)), cut((s, z), (s1, z1)));
                        match start.take() {
                            Some(from) => {
                                put(sample.link, from, first, true);
                                start = Some((second, true));
                            }
                            None => put(sample.link, (first, true), second, true),
                        }
                    }
                }
            }
            let is_last = column.samples.get(index + 1).is_none_or(|next| next.link != sample.link);
            if is_last && let Some(from) = start.take() {
                put(sample.link, from, sample.s, false);
            }
        }
        match &self.chosen {
            Some(chosen) => self.kept(wet, |whole| chosen(whole, v, level)),
            None => wet,
        }
    }

    /// The stretches that are kept: what goes on from one face to the next is judged as a whole.
    fn kept(&self, wet: Vec<Wet>, is_kept: impl Fn(&[Wet]) -> bool) -> Vec<Wet> {
        let goes_on = |one: &Wet, next: &Wet| {
            next.link == one.link + 1 && one.to == 1.0 && next.from == 0.0 && !one.is_cut[1] && !next.is_cut[0]
        };
        wet.chunk_by(goes_on).filter(|whole| is_kept(whole)).flatten().copied().collect()
    }
}

impl Column {
    pub(crate) fn v(&self) -> f64 {
        self.v
    }

    /// Where the column ends: number of the link and `s`.
    pub(crate) fn crest(&self) -> (usize, f64) {
        self.samples.last().map_or((0, 0.0), |sample| (sample.link, sample.s))
    }

    /// The same column one turn further.
    pub(crate) fn turn(&mut self, by: f64) {
        self.v += by;
    }
}
