//! The waters that stand in a body, each with the level at which it runs over.

use std::rc::Rc;

use glam::DVec3;

use super::accuracy::Accuracy;
use super::column::{Column, Inside, Wet};
use super::dry::Dry;
use super::fill::Level;
use super::ground::{Basin, Ground, Shortcut, turn};
use super::quantity::Quantity;
use super::saddle::{Bank, Saddle, saddle};
use crate::numeric::climb::{Place, climb};
use crate::numeric::trapezoid::round;

/// Water that stays in one place, to its brim.
pub(crate) struct Pond<'a> {
    /// The faces that it touches.
    pub(crate) inside: Inside<'a>,
    /// The level at which it runs over, how far that may be off, and where it does.
    pub(crate) spill: Quantity,
    pub(crate) at: DVec3,
    /// The height of its lowest point, and the column that this is in.
    pub(crate) floor: f64,
    deepest: f64,
}

impl<'a> Pond<'a> {
    /// What is wet of it at a level, seen at so many columns and at that of its lowest point: water may stand between all others.
    pub(crate) fn level(&self, z: f64, n: usize) -> Level<'_> {
        Level::new(&self.inside, z, round(n).chain([self.deepest]))
    }

    /// Whether there is water at all. What is no deeper than the gaps of a grid may be none: its lowest point may be that of a rim that hangs over, with the clay above it.
    fn is_water(&self) -> bool {
        let size = self.inside.size();
        if self.spill.value - self.floor > SHALLOW * size {
            return true;
        }
        let water = self.level(self.spill.value, self.inside.n_columns()).filling(&Accuracy::new(ROUGH, 1.0));
        water.moments.volume.value > LEAST * size * size * size
    }

    /// Whether its surface is one at every level: that of a body turned inside out is less than nothing.
    fn has_inside(&self) -> bool {
        let area = |level: usize| {
            let z = self.floor + (self.spill.value - self.floor) * level as f64 / LEVELS as f64;
            self.level(z, self.inside.n_columns()).filling(&Accuracy::new(ROUGH, 1.0)).area.value
        };
        (1..=LEVELS).all(|level| area(level) > 0.0)
    }
}

/// What is deeper than this part of the size is believed to hold water.
const SHALLOW: f64 = 1e-3;

/// How accurately the water is looked at that may be none.
const ROUGH: f64 = 1e-4;

/// What holds less than this part of the cube of the body's size is no water: dents of the grid.
const LEAST: f64 = 1e-9;

/// At how many levels a body that runs through itself is asked for its inside.
const LEVELS: usize = 8;

/// Why a body that runs through itself holds nothing.
fn crossed() -> Dry {
    Dry::new("crosses-itself", "the surface runs through itself so far that it has no inside")
}

/// Hollows whose lowest point is looked at: of more, which only a body of many equal waves has, the smaller ones are believed.
const LOOKED_AT: usize = 24;

/// How often hollows of the grid alone are joined with where they run to.
const ROUNDS: usize = 3;

/// A lowest point that is further than this from where it was on the grid, in cells, is not there.
const AWAY: usize = 2;

/// Ways over of about the same height that are compared, and how many cells apart they are.
const WAYS: usize = 6;

/// How much lower than the columns of the grid on either side a way over may be between them, as a part of the depth.
const DIP: f64 = 0.01;

/// Less than this part of what the columns of an upright body hold is not what a flood leaves in a body that does not run through itself.
const NEXT_TO_NOTHING: f64 = 0.3;

/// Levels found in two ways are one if they differ by no more than this part of the size.
const SAME: f64 = 1e-9;

/// How far below the spill the faces under water are compared, as a part of the size.
const BELOW: f64 = 1e-6;

/// Every pond of a body. `inside` are the faces from the middle of the floor to the rim, and `whole` these and all others, to the middle of the foot; of a tube both are the wall once round.
///
/// Mostly there is one, which fills every column of the inside up to its crest and runs over the lowest of these: that is seen from the [flood](Ground::basins) of the grid, and then the column says the rest. Anything else (gutters, funnels, a body
/// that lies or is upside down) is what the flood says, with its ways over refined.
///
/// A surface that runs through itself, as one without a wall may, has no one side that a flood could come from. Where it stands upright and the flood leaves next to nothing in it, it is taken by its columns too; where these have no
/// inside either, the reason is said.
pub(crate) fn ponds<'a>(
    inside: Inside<'a>,
    whole: impl Fn() -> Inside<'a>,
    is_upright: bool,
) -> Result<Vec<Pond<'a>>, Dry> {
    let body = whole();
    let ground = Rc::new(Ground::new(&body));
    let (basins, shortcuts) = basins(&body, &ground);
    // The columns of a tube have no crest that water would have to rise to: they go round.
    if !ground.is_ring() {
        let columns = inside.even_columns();
        let (level, at, dip) = inside.spill(&columns);
        let is_plain = match basins.as_slice() {
            [basin] => {
                let way = saddle(&body, &ground, basin.spill, banks(&ground, basin));
                is_plain(&ground, basin, &way, &columns, (level, dip))
            }
            _ => false,
        };
        if is_plain || is_upright && is_crossed(&ground, &basins, &columns, level) {
            let spill = Quantity::rounded(level, inside.size());
            let (floor, deepest) = inside.floor();
            let pond = Pond { inside, spill, at, floor, deepest };
            if !(level > floor && pond.is_water()) {
                return Ok(Vec::new());
            }
            return if is_plain || pond.has_inside() { Ok(vec![pond]) } else { Err(crossed()) };
        }
    }
    let of_basin = |basin: &Basin| {
        let all = whole();
        let way = lowest_way(&all, &ground, basin, &shortcuts);
        let at = all.position(way.at.0, way.at.1);
        let (settled, _, deepest) = settled(&all, &ground, basin.lowest);
        let floor = settled.min(ground.point(basin.lowest).z);
        let rounding = Quantity::rounded(way.z, all.size()).error;
        let spill = Quantity::new(way.z, rounding + 2.0 * way.change);
        let members = Members::new(&ground, basin);
        let links = members.links();
        let inside = all.only(&links, Box::new(move |wet: &[Wet], v: f64, level: f64| members.hold(wet, v, level)));
        Pond { inside, spill, at, floor, deepest }
    };
    Ok(basins.iter().map(of_basin).filter(|pond| pond.spill.value > pond.floor && pond.is_water()).collect())
}

/// Basins that are worth it, those that hold most first, and what connects hollows of the grid alone.
fn basins(whole: &Inside, ground: &Ground) -> (Vec<Basin>, Vec<Shortcut>) {
    let points = || (0..ground.n_points()).map(|vertex| ground.point(vertex));
    let (low, high) = points().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    let size = (high - low).length();
    let least = LEAST * size * size * size;
    let mut shortcuts: Vec<Shortcut> = Vec::new();
    let mut found = Vec::new();
    for round in 0..=ROUNDS {
        let all = ground.basins(&shortcuts, &[]);
        let volumes = volumes(ground, &all);
        let mut held: Vec<(f64, Basin)> = volumes.into_iter().zip(all).filter(|(volume, _)| *volume > least).collect();
        held.sort_by(|x, y| y.0.total_cmp(&x.0));
        let basins: Vec<Basin> = held.into_iter().map(|(_, basin)| basin).collect();
        let before = shortcuts.len();
        if round < ROUNDS {
            shortcuts.extend(basins.iter().take(LOOKED_AT).filter_map(|basin| runs_off(whole, ground, basin.lowest)));
        }
        found = basins;
        if shortcuts.len() == before {
            break;
        }
    }
    (found, shortcuts)
}

/// About how much each basin holds.
fn volumes(ground: &Ground, basins: &[Basin]) -> Vec<f64> {
    let mut of = vec![None; ground.n_points()];
    for (number, basin) in basins.iter().enumerate() {
        basin.members.iter().for_each(|&member| of[member] = Some(number));
    }
    let levels: Vec<f64> = basins.iter().map(|basin| ground.point(basin.spill).z).collect();
    ground.volumes(&levels, &of)
}

/// Where the water of a hollow really runs, if its lowest vertex is not beside a lowest point of the faces.
fn runs_off(whole: &Inside, ground: &Ground, lowest: usize) -> Option<Shortcut> {
    let (_, (link, s), v) = settled(whole, ground, lowest);
    let rows = ground.rows_of(link);
    let row = *rows.get(libm::round(s * (rows.len() - 1) as f64) as usize)?;
    let n = ground.n_columns();
    let column = libm::round(v / turn(1, n)).rem_euclid(n as f64) as usize;
    let (from_row, from_column) = ground.place(lowest);
    let apart = column.abs_diff(from_column);
    let rows_apart = row.abs_diff(from_row);
    let rows_apart = if ground.is_ring() { rows_apart.min(ground.n_rows() - 1 - rows_apart) } else { rows_apart };
    let is_near = rows_apart <= AWAY && apart.min(n - apart) <= AWAY;
    let landed = ground.vertex(row, column);
    let around = ground.neighbours(landed).into_iter().chain([landed]);
    let to = around.reduce(|best, other| if ground.is_below(other, best) { other } else { best })?;
    (!is_near && ground.is_below(to, lowest)).then_some((lowest, to))
}

/// Down from a vertex to a lowest point of the faces: its height, link and `s`, and `v`.
fn settled(whole: &Inside, ground: &Ground, vertex: usize) -> (f64, (usize, f64), f64) {
    const FACES: usize = 4;
    let (row, column) = ground.place(vertex);
    let (mut link, s) = ground.row(row);
    let v = turn(column, ground.n_columns());
    let mut best = Place { a: s, v, value: -ground.point(vertex).z };
    for _ in 0..FACES {
        let face = &whole.links()[link];
        let mut walk = face.walk();
        let step = 1.0 / face.cells() as f64;
        best = climb(best, step, turn(1, ground.n_columns()), |a, v| -walk.jet(a.clamp(0.0, 1.0), v).position.z);
        // At an end it may go on down the next face.
        let next = if best.a >= 1.0 {
            whole.link_beyond(link, 1).map(|after| (after, 0.0))
        } else if best.a <= 0.0 {
            whole.link_beyond(link, -1).map(|before| (before, 1.0))
        } else {
            None
        };
        let Some((next, start)) = next else { break };
        let other = &whole.links()[next];
        let mut walk = other.walk();
        let begin = Place { a: start, v: best.v, value: best.value };
        let step = 1.0 / other.cells() as f64;
        let on = climb(begin, step, turn(1, ground.n_columns()), |a, v| -walk.jet(a.clamp(0.0, 1.0), v).position.z);
        if !(on.value > best.value + SAME * ground.size()) {
            break;
        }
        (link, best) = (next, on);
    }
    (-best.value, (link, best.a), best.v)
}

/// On which side of its spill vertices are.
fn banks(ground: &Ground, basin: &Basin) -> impl Fn(usize) -> Bank {
    let is_member = ground.members(basin);
    move |vertex| if is_member[vertex] { Bank::Basin } else { Bank::Beyond }
}

/// Whether what is under water is every column of the inside up to its crest, and the way over is the lowest of these: at a level that is so far below the nearest column of the grid.
fn is_plain(ground: &Ground, basin: &Basin, way: &Saddle, columns: &[Column], (level, dip): (f64, f64)) -> bool {
    let coarse = ground.point(basin.spill).z;
    // The way of the flood is the lowest at the columns of the grid, and another may be lower between them.
    let slack = 4.0 * (way.z - coarse).abs().max(dip) + SAME * ground.size();
    if !(level <= way.z + 2.0 * way.change + SAME * ground.size() && level >= way.z.min(coarse) - slack) {
        return false;
    }
    let below = level.min(coarse) - BELOW * ground.size();
    let is_member = ground.members(basin);
    (0..ground.n_rows()).all(|row| {
        columns.iter().enumerate().all(|(column, of)| {
            let vertex = ground.vertex(row, column);
            ground.point(vertex).z >= below || is_member[vertex] == (ground.row(row) <= of.crest())
        })
    })
}

/// Whether the flood finds less than a part of what the columns hold up to their crests.
fn is_crossed(ground: &Ground, basins: &[Basin], columns: &[Column], level: f64) -> bool {
    let mut of = vec![None; ground.n_points()];
    for row in 0..ground.n_rows() {
        for (column, this) in columns.iter().enumerate() {
            let vertex = ground.vertex(row, column);
            if ground.row(row) <= this.crest() && ground.point(vertex).z < level {
                of[vertex] = Some(0);
            }
        }
    }
    let found: f64 = volumes(ground, basins).into_iter().sum();
    found < NEXT_TO_NOTHING * ground.volumes(&[level], &of)[0]
}

/// The lowest of the ways over that are about as low on the grid.
fn lowest_way(whole: &Inside, ground: &Ground, basin: &Basin, shortcuts: &[Shortcut]) -> Saddle {
    let coarse = ground.point(basin.spill).z;
    let mut best = saddle(whole, ground, basin.spill, banks(ground, basin));
    let mut slack = (4.0 * (best.z - coarse).abs()).max(DIP * (coarse - ground.point(basin.lowest).z));
    let mut barred = Vec::new();
    let mut last = basin.spill;
    for _ in 1..WAYS {
        let (row, column) = ground.place(last);
        let away = AWAY as isize;
        for row in (-away..=away).filter_map(|by| ground.row_beyond(row, by)) {
            for step in 0..=2 * AWAY {
                let vertex = ground.vertex(row, column + ground.n_columns() + step - AWAY);
                if !ground.is_below(vertex, basin.spill) && !barred.contains(&vertex) {
                    barred.push(vertex);
                }
            }
        }
        let again = ground.basins(shortcuts, &barred).into_iter().find(|other| other.members.contains(&basin.lowest));
        let Some(next) = again else { break };
        let next_coarse = ground.point(next.spill).z;
        if next_coarse > best.z.max(coarse) + slack || barred.contains(&next.spill) {
            break;
        }
        let way = saddle(whole, ground, next.spill, banks(ground, &next));
        slack = slack.max(4.0 * (way.z - next_coarse).abs());
        if way.z < best.z {
            best = way;
        }
        last = next.spill;
    }
    best
}

/// The points of the grid that are in a basin: by them it is told which stretches of a column are.
struct Members {
    ground: Rc<Ground>,
    is_member: Vec<bool>,
    /// Up to here the grid knows of each point whether it is.
    known: f64,
}

impl Members {
    fn new(ground: &Rc<Ground>, basin: &Basin) -> Members {
        Members { ground: Rc::clone(ground), is_member: ground.members(basin), known: ground.point(basin.spill).z }
    }

    /// The links on which there are any.
    fn links(&self) -> Vec<usize> {
        let rows = |link: usize| self.ground.rows_of(link);
        let is_wet =
            |row: usize| (0..self.ground.n_columns()).any(|column| self.is_member[self.ground.vertex(row, column)]);
        (0..self.ground.n_links()).filter(|&link| rows(link).iter().any(|&row| is_wet(row))).collect()
    }

    /// Whether a stretch of a column below a level is in the basin: by the points of the columns on either side that are in the stretch, or, if none of them is under water, by those next to it.
    fn hold(&self, wet: &[Wet], v: f64, level: f64) -> bool {
        let n = self.ground.n_columns();
        let at = v / turn(1, n);
        let first = libm::floor(at);
        let nearer = usize::from(at - first > 0.5);
        let columns = [0.0, 1.0].map(|more| (first + more).rem_euclid(n as f64) as usize);
        let level = level.min(self.known);
        for more in [0, 1, 2] {
            // Votes for and against, of the nearer column and of the other.
            let mut votes = [[0usize; 2]; 2];
            for stretch in wet {
                let rows = self.ground.rows_of(stretch.link);
                let cells = (rows.len().max(2) - 1) as f64;
                let from = (libm::ceil(stretch.from * cells) as usize).saturating_sub(more);
                let to = (libm::floor(stretch.to * cells) as usize + more).min(rows.len().saturating_sub(1));
                for &row in rows.get(from..=to).unwrap_or_default() {
                    for (side, column) in columns.into_iter().enumerate() {
                        let vertex = self.ground.vertex(row, column);
                        if self.ground.point(vertex).z < level {
                            votes[usize::from(side != nearer)][usize::from(self.is_member[vertex])] += 1;
                        }
                    }
                }
            }
            for [against, favour] in votes {
                if against != favour {
                    return favour > against;
                }
            }
        }
        false
    }
}
