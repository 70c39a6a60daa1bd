//! Whether a scene keeps the three constraints of ASB88.

use std::collections::BTreeMap;

use glam::DVec3;

use super::breach::{Breach, Constraints};
use super::budget::Budget;
use super::judged::{Judged, Known};
use super::meeting::{Meeting, Task};
use super::scenery::Scenery;
use super::space::Space;
use crate::design::{Design, Part, plain};
use crate::error::{Args, Code, Error, Result};
use crate::make::Severity;
use crate::numeric::signed_sets::SignedSets;
use crate::solution::Solution;
use crate::watch;

/// Without a slack of its own, a scene has this part of its size, or down to half of that: a power of two, so that what a part does to the size of the scene by being moved does not change what is asked of all others.
const SLACK: f64 = 1e-6;

/// All the work that a scene is worth, in pairs of tiles: about half a second.
const MOST_WORK: u64 = 130_000;

/// The most breaches that are told one by one.
const MOST_TOLD: usize = 1000;

/// The most pairs of parts of which it is found how far they are apart, for a group that touches no other part.
const MOST_HELD: usize = 8;

/// The most parts of a group that a sentence names; how many more there are is said.
const MOST_NAMED: usize = 4;

/// Whether a scene keeps the three constraints of ASB88 (J. A. D. W. Anderson, G. D. Sullivan, K. D. Baker, 1988): (1) no two discrete objects share points, (2) the parts of one object hang together, (3) no part is wholly inside another.
///
/// `slack` is a length in the unit of the design; where there is none, the power of two below a millionth of the size of the scene, from corner to corner of the box round all surfaces. Two parts *interfere* where a place of one is more than the slack beneath the surface of the other, are *apart* where all of
/// both is further from each other than it, and are *in contact* where they come as near and a plane lies between them that neither passes by more than the slack, or, of bodies of revolution about one axis, no place of one is deeper in the other than that. Contact connects, and is no interference. What is none of these within the limit
/// of work is said to be undecided.
///
/// A part without a wall that is an open surface has no inside: it may be in a solid, and be connected, but holds nothing and interferes with no other such.
///
/// # Errors
/// What is refused of a part, with its path; `overflow`; `not-finite` and `out-of-range` of a slack that is not greater than 0; `cancelled`.
///
/// ```
/// use pasu::{Design, constraints};
///
/// let ball = |x: f64, object: u32| {
///     format!(r#"{{ "object": {object}, "shape": {{ "kind": "octant", "exponents": [2, 2, 2] }}, "place": {{ "shift": [{x}, 0, 0] }} }}"#)
/// };
/// let scene = |x: f64| Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, ball(0.0, 0), ball(x, 1)));
/// assert!(constraints(&scene(1.5)?, None)?.is_kept);
/// let report = constraints(&scene(0.5)?, None)?;
/// assert_eq!(report.breaches[0].code, "interference");
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn constraints(design: &Design, slack: Option<f64>) -> Result<Constraints> {
    Solution::of(design).constraints(slack)
}

impl Solution {
    /// As [`constraints`].
    ///
    /// # Errors
    /// As [`constraints`].
    pub fn constraints(&self, slack: Option<f64>) -> Result<Constraints> {
        let scenery = self.scenery()?;
        let slack = match slack {
            Some(slack) => checked(slack)?,
            None => power_of_two_below(SLACK * scenery.sight.size()),
        };
        let parts = self.design().parts();
        let mut judge = Judge {
            solution: self,
            parts,
            scenery: &scenery,
            slack,
            budget: Budget::new(MOST_WORK),
            known: Known::new(slack),
            told: Vec::new(),
            n_left_out: 0,
            joined: SignedSets::new(parts.len()),
            doubtful: Vec::new(),
        };
        judge.pairs()?;
        judge.objects()?;
        watch::go_on()?;
        scenery.keep(core::mem::take(&mut judge.known));
        let is_kept = judge.n_left_out == 0 && judge.told.iter().all(|breach| breach.severity == Severity::Note);
        Ok(Constraints { is_kept, slack, breaches: judge.told, left_out: judge.n_left_out })
    }
}

/// Of a positive number with all its digits: what is left without them.
fn power_of_two_below(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & !((1 << (f64::MANTISSA_DIGITS - 1)) - 1))
}

fn checked(slack: f64) -> Result<f64> {
    if !slack.is_finite() {
        let message = format!("expected a finite number, found {slack}");
        return Err(Error::new(Code::NotFinite, "slack", message).with("found", slack));
    }
    if !(slack > 0.0) {
        let message = format!("expected a number greater than 0, found {}", plain(slack));
        return Err(Error::new(Code::OutOfRange, "slack", message).with("above", 0.0).with("found", slack));
    }
    Ok(slack)
}

/// Two parts that may meet.
struct Pair {
    both: [usize; 2],
    is_one_object: bool,
    /// Whether they are one body twice.
    is_same: bool,
}

struct Judge<'a> {
    solution: &'a Solution,
    parts: &'a [Part],
    scenery: &'a Scenery,
    slack: f64,
    budget: Budget,
    /// What was found of pairs.
    known: Known,
    told: Vec<Breach>,
    n_left_out: usize,
    /// Parts of one object that touch.
    joined: SignedSets,
    /// Pairs of one object of which that is not known.
    doubtful: Vec<[usize; 2]>,
}

impl<'a> Judge<'a> {
    fn space(&self, part: usize) -> Result<&'a Space> {
        self.scenery.sight.space(self.solution, part).map(|space| &**space)
    }

    fn name(&self, part: usize) -> String {
        self.parts[part]
            .name
            .clone()
            .map_or_else(|| format!("part {}", part + 1), |name| format!("\u{201c}{name}\u{201d}"))
    }

    /// Every two parts whose boxes come as near as the slack: first all of them, and then those again of which little work did not tell.
    fn pairs(&mut self) -> Result<()> {
        let pairs = self.near()?;
        let mut judged: Vec<Option<Judged>> = Vec::with_capacity(pairs.len());
        for pair in &pairs {
            let task = (!pair.is_same).then(|| Task::first(self.slack, pair.is_one_object));
            judged.push(task.map(|task| self.judged(pair.both, task)).transpose()?);
        }
        for (pair, judged) in pairs.iter().zip(&mut judged) {
            if judged.is_some_and(|judged| judged.is_cut) {
                *judged = Some(self.judged(pair.both, Task::first(self.slack, pair.is_one_object).thorough())?);
            }
        }
        pairs.iter().zip(judged).try_for_each(|(pair, judged)| self.pair(pair, judged))
    }

    fn near(&self) -> Result<Vec<Pair>> {
        let mut pairs = Vec::new();
        for [other, part] in self.scenery.sight.near(self.slack) {
            let (first, second) = (&self.parts[other], &self.parts[part]);
            let is_one_object = first.object == second.object;
            let [one, another] = [self.space(other)?, self.space(part)?];
            let is_near = one.bounds.distance(&another.bounds.wider(self.slack)) == 0.0;
            if is_near && (is_one_object || one.is_solid || another.is_solid) {
                let is_same = first.shape == second.shape && first.place == second.place && first.wall == second.wall;
                pairs.push(Pair { both: [other, part], is_one_object, is_same });
            }
        }
        Ok(pairs)
    }

    /// How two parts meet: as it is known, or else found. What is known counts for as much work, so that nothing is told otherwise for being known.
    fn judged(&mut self, both: [usize; 2], task: Task) -> Result<Judged> {
        let judged = match self.scenery.known(both, task) {
            Some(known) if known.work <= self.budget.left => {
                self.budget.left -= known.work;
                *known
            }
            _ => {
                let left = self.budget.left;
                let [one, other] = [self.space(both[0])?, self.space(both[1])?];
                let (meeting, is_cut) = one.meeting(other, task, &mut self.budget);
                let is_touch = matches!(meeting, Meeting::Undecided { touch: Some(_) });
                // How deep does not matter of parts of one object; whether one is within the other does.
                let is_own = match task.is_touch_enough && is_touch {
                    true => [[one, other], [other, one]].map(|[part, outer]| {
                        !outer.is_solid || part.own_place(outer, task.slack, &mut self.budget).is_some()
                    }),
                    false => [true; 2],
                };
                Judged { meeting, is_own, is_cut, work: left - self.budget.left }
            }
        };
        if !self.budget.is_out {
            self.known.insert(both, task, judged);
        }
        Ok(judged)
    }

    fn pair(&mut self, pair: &Pair, judged: Option<Judged>) -> Result<()> {
        let Pair { both: [one, other], is_one_object, .. } = *pair;
        let Some(Judged { meeting, is_own, .. }) = judged else {
            self.joined.join(one, other, false);
            let at = self.space(one)?.tiles().all.first().map(|tile| tile.corners[0]);
            return self.tell("same-place", Severity::Error, [other, one], at, None);
        };
        match meeting {
            Meeting::Contact { at } if !is_one_object => {
                self.tell("contact", Severity::Note, [other, one], Some(at), None)?;
            }
            Meeting::Through { at, depth, is_own } => {
                self.meet([other, one], is_one_object, at, depth)?;
                self.own_places([one, other], is_own)?;
            }
            Meeting::Inside { is_first, at, depth } => {
                let [inner, outer] = if is_first { [one, other] } else { [other, one] };
                self.meet([other, one], is_one_object, at, depth)?;
                self.tell("within", Severity::Error, [inner, outer], Some(at), Some(depth))?;
            }
            Meeting::Undecided { touch } if !is_one_object => {
                self.tell("undecided-interference", Severity::Warning, [other, one], touch, None)?;
            }
            Meeting::Undecided { touch: Some(_) } => {
                self.joined.join(one, other, false);
                self.own_places([one, other], is_own)?;
            }
            Meeting::Undecided { touch: None } => self.doubtful.push([one, other]),
            Meeting::Contact { .. } => self.joined.join(one, other, false),
            Meeting::Apart { .. } => {}
        }
        Ok(())
    }

    /// Two parts that have a place in common.
    fn meet(&mut self, [part, other]: [usize; 2], is_one_object: bool, at: DVec3, depth: f64) -> Result<()> {
        if is_one_object {
            self.joined.join(part, other, false);
            return Ok(());
        }
        self.tell("interference", Severity::Error, [part, other], Some(at), Some(depth))
    }

    /// Of two parts that meet, each of which no place of its own was found.
    fn own_places(&mut self, [one, other]: [usize; 2], is_own: [bool; 2]) -> Result<()> {
        for ([part, outer], is_own) in [[one, other], [other, one]].into_iter().zip(is_own) {
            if !is_own {
                self.tell("undecided-within", Severity::Warning, [part, outer], None, None)?;
            }
        }
        Ok(())
    }

    /// Whether the parts of every object hang together.
    fn objects(&mut self) -> Result<()> {
        let mut objects: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (index, part) in self.parts.iter().enumerate() {
            objects.entry(part.object).or_default().push(index);
        }
        for parts in objects.into_values() {
            let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
            for part in &parts {
                groups.entry(self.joined.find(*part).0).or_default().push(*part);
            }
            let groups: Vec<Vec<usize>> = groups.into_values().collect();
            // The largest, and of those as large the first, is what the others are loose from.
            let main = (0..groups.len()).rev().max_by_key(|index| groups[*index].len());
            for group in groups.iter().enumerate().filter(|(index, _)| Some(*index) != main).map(|(_, group)| group) {
                let is_in = |part: &usize| group.contains(part);
                let doubt = self.doubtful.iter().find(|pair| is_in(&pair[0]) != is_in(&pair[1])).copied();
                match doubt {
                    Some([one, other]) => {
                        let both = if is_in(&one) { [one, other] } else { [other, one] };
                        self.tell_of(group, "undecided-connection", Severity::Warning, both, None, None)?;
                    }
                    None => self.loose(group, &parts)?,
                }
            }
        }
        Ok(())
    }

    /// Tells of a group of parts that touches none of the others of its object.
    fn loose(&mut self, group: &[usize], parts: &[usize]) -> Result<()> {
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for part in group {
            for other in parts.iter().filter(|other| !group.contains(other)) {
                pairs.push((self.space(*part)?.bounds.distance(&self.space(*other)?.bounds), *part, *other));
            }
        }
        // By their boxes, which are no further apart than they are: as soon as two are found to be as near as the boxes of the next, those are the nearest.
        pairs.sort_by(|one, other| one.0.total_cmp(&other.0));
        let task = Task { is_distance_sought: true, ..Task::first(self.slack, true).thorough() };
        let mut nearest: Option<(f64, usize, usize)> = None;
        let mut next = f64::INFINITY;
        for (index, (apart, part, other)) in pairs.into_iter().enumerate() {
            if index == MOST_HELD || nearest.is_some_and(|(least, ..)| least <= apart) {
                next = apart;
                break;
            }
            let found = self.space(part)?.meeting(self.space(other)?, task, &mut self.budget).0;
            let least = if let Meeting::Apart { least } = found { least.max(apart) } else { apart };
            if nearest.is_none_or(|(nearest, ..)| least < nearest) {
                nearest = Some((least, part, other));
            }
        }
        let Some((least, part, other)) = nearest else { return Ok(()) };
        let least = Some(least.min(next)).filter(|least| *least > 0.0);
        let (one, another) = (self.space(part)?, self.space(other)?);
        let at = one.nearest(another.bounds.middle()).position;
        self.tell_of(group, "not-connected", Severity::Error, [part, other], Some(at), least)
    }

    fn tell(
        &mut self,
        code: &'static str,
        severity: Severity,
        both: [usize; 2],
        at: Option<DVec3>,
        by: Option<f64>,
    ) -> Result<()> {
        self.tell_of(&[both[0]], code, severity, both, at, by)
    }

    /// Tells something of a group of parts, of which the first of both is one.
    fn tell_of(
        &mut self,
        group: &[usize],
        code: &'static str,
        severity: Severity,
        both: [usize; 2],
        at: Option<DVec3>,
        by: Option<f64>,
    ) -> Result<()> {
        if self.told.len() >= MOST_TOLD {
            self.n_left_out += 1;
            return Ok(());
        }
        let [part, other] = both;
        let names = both.map(|part| self.name(part));
        let message = sentence(code, &self.names(group), &names, at, by);
        let mut args = Args::from([("part", names[0].as_str().into()), ("other", names[1].as_str().into())]);
        if group.len() > 1 {
            args.insert("count", group.len().into());
        }
        let is_proved = self.space(part)?.is_proved() && self.space(other)?.is_proved();
        let at = at.map(|at| at.to_array());
        let group = group.to_vec();
        self.told.push(Breach { code, severity, part, other, group, message, args, at, distance: by, is_proved });
        Ok(())
    }

    /// The names of a group in a row.
    fn names(&self, group: &[usize]) -> String {
        let n_named = if group.len() > MOST_NAMED { MOST_NAMED - 1 } else { group.len() };
        let mut names: Vec<String> = group.iter().take(n_named).map(|part| self.name(*part)).collect();
        if group.len() > n_named {
            names.push(format!("{} more", group.len() - n_named));
        }
        match names.split_last() {
            Some((last, before)) if !before.is_empty() => format!("{} and {last}", before.join(", ")),
            _ => names.concat(),
        }
    }
}

/// What is said of a group of parts, whose `part` it is that is next to the other.
fn sentence(code: &str, group: &str, [part, other]: &[String; 2], at: Option<DVec3>, by: Option<f64>) -> String {
    let place = at.map_or_else(String::new, |at| format!(" at {}", crate::solid::place(at)));
    let by = by.map_or_else(String::new, |by| format!(" by {} at least", crate::solid::short(by)));
    let are_several = group != part;
    match code {
        "interference" => format!(
            "{part} runs into {other}{place}, beneath the surface{by}: expected separate objects to share no point"
        ),
        "same-place" => format!("{part} is the same body in the same place as {other}"),
        "within" => {
            format!("all of {part} is inside {other}{place}{by}: expected every part to have a place of its own")
        }
        "not-connected" if are_several => format!(
            "{group} touch no other part of their object; the nearest, {other}, is away from {part}{by}{place}: expected the parts of an object to be connected"
        ),
        "not-connected" => format!(
            "{part} touches no other part of its object; the nearest, {other}, is away{by}{place}: expected the parts of an object to be connected"
        ),
        "contact" => format!("{part} touches {other}{place}"),
        "undecided-within" => format!(
            "whether all of {part} is inside {other} could not be told: every place of it that was looked at is"
        ),
        "undecided-connection" if are_several => {
            format!("whether {group} touch {other}, to which they are to be connected, could not be told")
        }
        "undecided-connection" => {
            format!("whether {part} touches {other}, to which it is to be connected, could not be told")
        }
        _ => format!("whether {part} runs into {other} could not be told{place}"),
    }
}
