//! How two parts meet: apart, touching, one through the other, or one within the other.
//!
//! Tiles of one are held against tiles of the other, the pair that may be nearest first. A pair is no nearer than its triangles are, less what the border is from them; where the nearest is further than the slack, all of both are. Meanwhile places
//! of either surface are asked how deep they are in the other.

use std::collections::BinaryHeap;

use glam::DVec3;

use super::boxes::Within;
use super::budget::Budget;
use super::coaxial::{Coaxial, Question};
use super::divided::Resting;
use super::missed::Beside;
use super::open::Open;
use super::space::Space;
use super::tile::Tile;

/// The most pairs of tiles that are held against each other for two parts at first: most need fewer, and no few pairs of parts are to take what all have,
const FIRST_PAIRS: u64 = 150;

/// and of those that are not told by then.
const MOST_PAIRS: u64 = 5000;

/// The most that are then looked at closely, one place after another.
const MOST_CLOSELY: u64 = 1500;

/// The most places that are asked for how deep they are.
const MOST_ASKED: usize = 64;

/// The most places of each of two that are asked where nothing else told.
const MOST_SCATTERED: usize = 128;

/// What is small of a part, as a share of its size.
const SMALL: f64 = 1.0 / 64.0;

/// What such a question counts for at least, in pairs of tiles,
const ASKED: u64 = 8;

/// and for each tile that is looked at to answer it: a place is brought nearer on it, step by step.
const LOOKED_AT: u64 = 4;

/// What all is that formulas are asked of two octants, but for how far they are apart.
const BY_FORMULA: u64 = 1;

/// and for whether a plane across a side of one is between them.
const CONTACT: u64 = 12;

/// The most places that are asked for one outside of the other part.
const MOST_OUTSIDE: usize = 64;

/// Directions between the normals of two surfaces that touch, of which one may be that of the plane between them.
const BETWEEN: u8 = 8;

#[cfg(test)]
std::thread_local! {
    /// How often two parts were held against each other on this thread.
    pub(super) static MET: core::cell::Cell<usize> = const { core::cell::Cell::new(0) };
}

/// How much is done for two parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Task {
    pub(super) slack: f64,
    /// Of parts that are to be connected it is enough to know where they touch.
    pub(super) is_touch_enough: bool,
    /// Of parts that are apart, whether it matters how far.
    pub(super) is_distance_sought: bool,
    pub(super) most_pairs: u64,
}

impl Task {
    /// What is done first.
    pub(super) fn first(slack: f64, is_touch_enough: bool) -> Task {
        Task { slack, is_touch_enough, is_distance_sought: false, most_pairs: FIRST_PAIRS }
    }

    /// The same as thoroughly as it is done for any two parts.
    pub(super) fn thorough(self) -> Task {
        Task { most_pairs: MOST_PAIRS, ..self }
    }
}

/// How two parts meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Meeting {
    /// They are further from each other than the slack: by this at least.
    Apart { least: f64 },
    /// They come as near as the slack there, and a plane is between them that neither passes by more, or nothing of one is deeper in the other.
    Contact { at: DVec3 },
    /// This place belongs to one and is so deep in the other at least, which is more than the slack; for each whether a place of its own was found.
    Through { at: DVec3, depth: f64, is_own: [bool; 2] },
    /// The borders are apart, and all of the first is in the second, or the other way round; this deep at least.
    Inside { is_first: bool, at: DVec3, depth: f64 },
    /// None of it could be told; `touch` is where they come as near as the slack, if that is known.
    Undecided { touch: Option<DVec3> },
}

#[derive(Clone)]
enum Item {
    Node(u32),
    Tile(Box<Tile>),
}

/// What is being found of two parts.
struct Pair<'a> {
    parts: [&'a Space; 2],
    slack: f64,
    /// Whether one place where they touch is all that is sought: then the smallest of those that are as near are looked at first, and else the largest, so that all of where they touch is seen before any of it closely.
    is_touch_enough: bool,
    /// Whether the smallest are looked at first all the same.
    is_closely: bool,
    is_distance_sought: bool,
    n_left: u64,
    /// Whether there was more to be held against each other than was allowed.
    is_cut: bool,
    n_asked: usize,
    /// At first no places are asked but those beside where borders go through each other.
    most_asked: usize,
    /// Where they come as near as the slack.
    touch: Option<DVec3>,
    n_touches: usize,
}

impl Space {
    /// How this part meets another, and whether more work might say more.
    pub(super) fn meeting(&self, other: &Space, task: Task, budget: &mut Budget) -> (Meeting, bool) {
        #[cfg(test)]
        MET.set(MET.get() + 1);
        let Task { slack, is_touch_enough, is_distance_sought, most_pairs } = task;
        let is_thorough = most_pairs == MOST_PAIRS;
        let apart = self.bounds.distance(&other.bounds);
        if apart > slack {
            return (Meeting::Apart { least: apart }, false);
        }
        let are_octants = self.octant().is_some() && other.octant().is_some();
        if !budget.take(if are_octants { BY_FORMULA } else { 2 * ASKED }) {
            return (Meeting::Undecided { touch: None }, true);
        }
        let mut pair = Pair {
            parts: [self, other],
            slack,
            is_touch_enough,
            is_closely: false,
            is_distance_sought,
            n_left: most_pairs,
            is_cut: false,
            n_asked: 0,
            most_asked: if is_thorough { MOST_ASKED } else { 0 },
            touch: None,
            n_touches: 0,
        };
        if !are_octants
            && !is_distance_sought
            && let Some(least) = self.divided_at_once(other, slack, budget)
        {
            return (Meeting::Apart { least }, false);
        }
        let both = [(self, other), (other, self)];
        let cores = both.into_iter().find_map(|(one, outer)| {
            let at = one.core()?;
            Some((at, outer.depth_beyond(at, slack, budget)?))
        });
        let known = cores.or_else(|| {
            both.into_iter().find_map(|(one, outer)| {
                one.places_by_formula().find_map(|at| Some((at, outer.depth_by_formula(at, slack)?)))
            })
        });
        let known = known.map(|known| pair.through(known, budget));
        if let Some(all @ Meeting::Through { is_own: [true, true], .. }) = known {
            return (all, false);
        }
        if known.is_none() {
            let (apart, n_steps) = self.apart_by_formula(other, slack, is_distance_sought);
            budget.take(n_steps);
            if let Some(least) = apart {
                return (Meeting::Apart { least }, false);
            }
            if are_octants
                && budget.take(CONTACT)
                && let Some(at) = self.contact_by_formula(other, slack)
            {
                return (Meeting::Contact { at }, false);
            }
        }
        // It may be all of one.
        if let Some(meeting) = pair.round(known, budget) {
            return (meeting, pair.is_cut);
        }
        if known.is_none()
            && !is_distance_sought
            && !are_octants
            && let Some(deep) = self.crossed(other, slack, budget)
        {
            return (pair.through(deep, budget), false);
        }
        if known.is_none()
            && !is_distance_sought
            && let Some(least) = self.divided(other, slack, budget)
        {
            return (Meeting::Apart { least }, false);
        }
        if known.is_none()
            && is_thorough
            && let Some(resting) = self.resting(other, slack, budget)
        {
            let meeting = match resting {
                Resting::Apart { least } => Meeting::Apart { least },
                Resting::Contact { at } => Meeting::Contact { at },
                Resting::Deep { at, depth } => pair.through((at, depth), budget),
            };
            return (meeting, false);
        }
        let mut meeting = pair.borders(known, budget);
        let is_open = match meeting {
            Meeting::Undecided { touch } => known.is_none() && (touch.is_none() || !is_touch_enough),
            _ => false,
        };
        if is_open && !is_thorough {
            // Of no place but those beside where borders go through each other was it asked how deep it is.
            return (meeting, true);
        }
        if is_open && !is_touch_enough {
            if let Some(deep) = pair.somewhere(budget) {
                return (pair.through(deep, budget), false);
            }
            if pair.is_cut {
                let beside = both
                    .into_iter()
                    .find_map(|(of, outer)| outer.octant().and_then(|_| of.beside_octant(outer, slack, budget)));
                match beside {
                    Some(Beside::Missed) => meeting = pair.apart(slack, known),
                    Some(Beside::Deep { at, depth }) => return (pair.through((at, depth), budget), false),
                    None => {}
                }
            }
            if pair.is_cut && matches!(meeting, Meeting::Undecided { .. }) {
                meeting = pair.closely(budget);
            }
        }
        // Pairs end as soon as they tell that the parts are apart; a plane often leaves more between them.
        if is_distance_sought && let Meeting::Apart { .. } | Meeting::Undecided { .. } = meeting {
            let cells = if let Meeting::Apart { least } = meeting { least } else { 0.0 };
            if let Some(least) = self.divided(other, slack.max(cells), budget) {
                meeting = Meeting::Apart { least };
            }
        }
        (meeting, pair.is_cut)
    }

    /// How deep a point is beneath the surface at least, if it is in the part and deeper than this.
    pub(super) fn depth_beyond(&self, at: DVec3, slack: f64, budget: &mut Budget) -> Option<f64> {
        if !self.is_solid || !self.bounds.holds(at) {
            return None;
        }
        if let Some(depth) = self.depth_by_formula(at, slack) {
            return Some(depth);
        }
        if self.holds_within(at, budget) != Some(true) {
            return None;
        }
        Some(self.away(at, slack, budget)).filter(|depth| *depth > slack)
    }

    /// What it counts for to ask whether a place is in it.
    pub(super) fn asked_for(&self) -> u64 {
        if self.octant().is_some() { 1 } else { ASKED }
    }

    /// How far the surface is from a point at least, as far as it has to be known whether that is more than the slack.
    fn away(&self, at: DVec3, slack: f64, budget: &mut Budget) -> f64 {
        let nearest = self.nearest_within(at, slack);
        budget.take(LOOKED_AT * nearest.n_looked_at);
        nearest.least
    }

    /// A place of the surface that is further from another part than the slack; `None` where none was found.
    pub(super) fn own_place(&self, other: &Space, slack: f64, budget: &mut Budget) -> Option<DVec3> {
        let wide = other.bounds.wider(slack);
        let is_clear = |at: &DVec3| !wide.holds(*at) || other.is_clear_by_formula(*at, slack);
        if let Some(at) = self.places_by_formula().find(is_clear) {
            return Some(at);
        }
        let tiles = &self.tiles().all;
        let corners = || tiles.iter().flat_map(|tile| tile.corners);
        if let Some(at) = corners().find(|corner| !wide.holds(*corner)) {
            return Some(at);
        }
        if !other.is_solid {
            return corners().next();
        }
        let step = (4 * tiles.len()).div_ceil(MOST_OUTSIDE).max(1);
        corners().step_by(step).find(|corner| {
            budget.take(other.asked_for())
                && other.holds_within(*corner, budget) == Some(false)
                && (other.is_clear_by_formula(*corner, slack) || other.away(*corner, slack, budget) > slack)
        })
    }

    /// The unit normal in the middle of a tile.
    fn normal_of(&self, tile: &Tile) -> DVec3 {
        let [u, v] = tile.middle();
        self.borders[tile.border].normal(u, v)
    }
}

impl Pair<'_> {
    /// What can be told of bodies of revolution about one axis; `known` as for [`Pair::borders`].
    fn round(&mut self, known: Option<Meeting>, budget: &mut Budget) -> Option<Meeting> {
        let [one, other] = self.parts;
        let question = Question {
            slack: self.slack,
            is_touch_enough: self.is_touch_enough || known.is_some(),
            is_distance_sought: self.is_distance_sought,
            most: self.n_left,
        };
        let (found, is_cut) = one.coaxial(other, question, budget);
        self.is_cut |= is_cut;
        Some(match found? {
            Coaxial::Apart { least } => self.apart(least, known),
            Coaxial::Touch { at, is_contact: true } => Meeting::Contact { at },
            Coaxial::Touch { at, is_contact: false } => known.unwrap_or(Meeting::Undecided { touch: Some(at) }),
            Coaxial::Deep { at, depth } => self.through((at, depth), budget),
            Coaxial::Near { places } => {
                let deep = places.into_iter().zip([other, one]).find_map(|(places, outer)| {
                    places.into_iter().find_map(|at| Some((at, outer.depth_beyond(at, self.slack, budget)?)))
                });
                self.through(deep?, budget)
            }
        })
    }

    /// Holds the borders against each other; `known` is what is known beforehand, but for whether one part is wholly within the other.
    fn borders(&mut self, known: Option<Meeting>, budget: &mut Budget) -> Meeting {
        let undecided = |pair: &Self| known.unwrap_or(Meeting::Undecided { touch: pair.touch });
        let mut open = BinaryHeap::new();
        if let [Some(one), Some(other)] = self.parts.map(|part| part.tiles().boxes.root()) {
            open.push(self.open([Item::Node(one), Item::Node(other)], 0.0));
        }
        let mut least = f64::INFINITY;
        // Whether there are tiles that come as near as the slack, or nearer than can be told.
        let mut is_near = false;
        while let Some(pair) = open.pop() {
            if pair.least > self.slack {
                least = pair.least;
                break;
            }
            if self.n_left == 0 || !budget.take(1) {
                self.is_cut = true;
                return undecided(self);
            }
            self.n_left -= 1;
            if let [Item::Tile(one), Item::Tile(other)] = &pair.of {
                let tiles = [**one, **other];
                if self.is_touch(&tiles) {
                    is_near = true;
                    if self.is_touch_enough || known.is_some() {
                        return undecided(self);
                    }
                    if self.n_touches.is_power_of_two()
                        && let Some(contact) = self.contact(&tiles, budget)
                    {
                        return contact;
                    }
                }
                if known.is_none()
                    && let Some(deep) = self.asked(&tiles, budget)
                {
                    return self.through(deep, budget);
                }
                if tiles.iter().all(|tile| tile.size() <= 0.25 * self.slack) {
                    is_near = true;
                    continue;
                }
            }
            self.halve(pair, &mut open);
        }
        if is_near { undecided(self) } else { self.apart(least, known) }
    }

    /// Holds the borders against each other once more where that took too long: of pairs that may be as near the smallest first. Where two large borders go through each other along a curve, or one stands on the other, pairs are used up before any is small; this goes down to one place of it after another,
    /// and asks on the way.
    fn closely(&mut self, budget: &mut Budget) -> Meeting {
        (self.is_closely, self.n_left, self.n_asked, self.n_touches) = (true, MOST_CLOSELY, 0, 0);
        self.borders(None, budget)
    }

    /// Of parts of which a place of one is deep in the other.
    fn through(&self, (at, depth): (DVec3, f64), budget: &mut Budget) -> Meeting {
        let [one, other] = self.parts;
        let is_own = [(one, other), (other, one)].map(|(part, of)| part.own_place(of, self.slack, budget).is_some());
        Meeting::Through { at, depth, is_own }
    }

    /// What is to be said of borders that are so far from each other at least.
    fn apart(&self, least: f64, known: Option<Meeting>) -> Meeting {
        let [one, other] = self.parts;
        for (is_first, inner, outer) in [(true, one, other), (false, other, one)] {
            let Some(at) = inner.tiles().all.first().map(|tile| tile.corners[0]) else { continue };
            match outer.holds(at) {
                Some(true) => return Meeting::Inside { is_first, at, depth: least },
                Some(false) => {}
                None => return known.unwrap_or(Meeting::Undecided { touch: None }),
            }
        }
        known.unwrap_or(Meeting::Apart { least })
    }

    fn open(&self, of: [Item; 2], least: f64) -> Open<[Item; 2]> {
        let bounds = |part: usize| match &of[part] {
            Item::Node(node) => self.parts[part].tiles().boxes.bounds(*node),
            Item::Tile(tile) => tile.bounds(),
        };
        let [one, other] = [bounds(0), bounds(1)];
        let apart = match &of {
            [Item::Tile(one), Item::Tile(other)] => {
                let [p, q] = nearest(one, other);
                (p - q).length() - one.deviation - other.deviation
            }
            _ => one.distance(&other),
        };
        let size = one.size().max(other.size());
        Open { least: apart.max(least), rank: if self.is_touch_enough || self.is_closely { -size } else { size }, of }
    }

    /// Takes apart the larger of two things.
    fn halve(&self, pair: Open<[Item; 2]>, open: &mut BinaryHeap<Open<[Item; 2]>>) {
        let size = |part: usize| match &pair.of[part] {
            Item::Node(node) => self.parts[part].tiles().boxes.bounds(*node).size(),
            Item::Tile(tile) => tile.size(),
        };
        let first = usize::from(size(1) > size(0));
        for part in [first, 1 - first] {
            let space = self.parts[part];
            let halves: Vec<Item> = match &pair.of[part] {
                Item::Node(node) => match space.tiles().boxes.within(*node) {
                    Within::Thing(tile) => vec![Item::Tile(Box::new(space.tiles().all[tile]))],
                    Within::Halves(halves) => halves.into_iter().map(Item::Node).collect(),
                },
                Item::Tile(tile) => match tile.halves(&space.borders) {
                    Some(halves) => halves.into_iter().map(|half| Item::Tile(Box::new(half))).collect(),
                    None => continue,
                },
            };
            for half in halves {
                let mut of = pair.of.clone();
                of[part] = half;
                let next = self.open(of, pair.least);
                open.push(next);
            }
            return;
        }
    }

    /// A place of one of two tiles that is deep in the other part: those are asked that lie beneath the tangent plane in the middle of the other tile.
    fn asked(&mut self, tiles: &[Tile; 2], budget: &mut Budget) -> Option<(DVec3, f64)> {
        // Closely, places of small tiles alone: of large ones the tangent plane tells little, and places all over were asked before.
        let small = SMALL * self.parts[0].size().min(self.parts[1].size());
        if self.is_closely && tiles.iter().any(|tile| tile.size() > small) {
            return None;
        }
        for (part, tile) in tiles.iter().enumerate() {
            let (outer, beyond) = (self.parts[1 - part], &tiles[1 - part]);
            if !outer.is_solid {
                continue;
            }
            let foot = beyond.middle_jet(&outer.borders).position;
            let normal = outer.normal_of(beyond);
            let middle = tile.middle_jet(&self.parts[part].borders).position;
            for at in core::iter::once(middle).chain(tile.corners) {
                let is_beneath = (at - foot).dot(normal) < -self.slack;
                if self.n_asked >= self.most_asked || !is_beneath || !outer.bounds.holds(at) {
                    continue;
                }
                if !budget.take(outer.asked_for()) {
                    return None;
                }
                self.n_asked += 1;
                if let Some(depth) = outer.depth_beyond(at, self.slack, budget) {
                    return Some((at, depth));
                }
            }
        }
        None
    }

    /// A place of one that is deep in the other, of some all over each that are in the box of the other.
    fn somewhere(&self, budget: &mut Budget) -> Option<(DVec3, f64)> {
        let [one, other] = self.parts;
        [(one, other), (other, one)].into_iter().find_map(|(of, outer)| {
            if !outer.is_solid {
                return None;
            }
            let corners = of.tiles().all.iter().map(|tile| tile.corners[0]);
            let places: Vec<DVec3> = corners.filter(|corner| outer.bounds.holds(*corner)).collect();
            let step = places.len().div_ceil(MOST_SCATTERED).max(1);
            places.into_iter().step_by(step).find_map(|at| {
                budget
                    .take(outer.asked_for())
                    .then(|| outer.depth_beyond(at, self.slack, budget))
                    .flatten()
                    .map(|depth| (at, depth))
            })
        })
    }

    /// Whether the borders of two tiles are known to come as near to each other as the slack.
    fn is_touch(&mut self, tiles: &[Tile; 2]) -> bool {
        let [p, q] = nearest(&tiles[0], &tiles[1]);
        let is_touch = (p - q).length() + tiles[0].deviation + tiles[1].deviation <= self.slack;
        if is_touch {
            self.n_touches += 1;
            self.touch.get_or_insert(0.5 * p + 0.5 * q);
        }
        is_touch
    }

    /// Of parts that touch at two tiles: contact, if a plane is between them.
    fn contact(&self, tiles: &[Tile; 2], budget: &mut Budget) -> Option<Meeting> {
        let [one, other] = self.parts;
        let normals = [0, 1].map(|part| self.parts[part].normal_of(&tiles[part]));
        (0..=BETWEEN).find_map(|k| {
            let share = f64::from(k) / f64::from(BETWEEN);
            let direction = (normals[0] * share - normals[1] * (1.0 - share)).normalize_or_zero();
            if direction == DVec3::ZERO {
                return None;
            }
            // Corners are places of the borders: of most directions they tell that no plane across is between.
            if one.corners_reach(direction) + other.corners_reach(-direction) > self.slack {
                return None;
            }
            let enough = 0.125 * self.slack;
            let reach = one.reach(direction, enough, budget).0 + other.reach(-direction, enough, budget).0;
            (reach <= self.slack).then_some(Meeting::Contact { at: self.touch? })
        })
    }
}

/// The nearest points of the triangles of two tiles.
fn nearest(one: &Tile, other: &Tile) -> [DVec3; 2] {
    let mut best = [one.corners[0], other.corners[0]];
    for p in one.triangles() {
        for q in other.triangles() {
            let next = p.between(&q);
            if (next[0] - next[1]).length_squared() < (best[0] - best[1]).length_squared() {
                best = next;
            }
        }
    }
    best
}
