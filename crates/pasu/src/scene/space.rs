//! What a part is in space: its border in pieces, each enclosed, and whether that goes round an inside.

use std::collections::VecDeque;
use std::sync::{Arc, OnceLock};

use glam::{DMat3, DVec3};

use super::border::Border;
use super::bounds::Bounds;
use super::boxes::Boxes;
use super::halvings::Halvings;
use super::isometry::Isometry;
use super::meridian::Meridian;
use super::tile::Tile;
use crate::design::Placement;
use crate::error::{Code, Error, Result};
use crate::octant::Supersphere;
use crate::solid::Product;
use crate::solution::{Placed, Solution};
use crate::watch;

/// Tiles are halved until none is further from its triangles than this part of the size of the part, or there are so many.
const COARSE: f64 = 1.0 / 48.0;

/// The most tiles that are kept; more are made where they are needed, and forgotten.
const MOST_TILES: usize = 512;

/// What a tile counts for, in units of [`watch::work`].
pub(super) const TILE: u64 = 100;

/// Coordinates beyond this, and parts smaller than its inverse, have squares that are no numbers.
const LARGEST: f64 = 1e100;

/// A part where it stands, as all that is asked of a scene sees it.
#[derive(Debug)]
pub(super) struct Space {
    pub(super) part: usize,
    pub(super) borders: Vec<Border>,
    /// Whether the border goes round an inside.
    pub(super) is_solid: bool,
    placed: Arc<Placed>,
    /// What it is before it is turned and moved, and how it is; `None` of what is not.
    still: Option<(Arc<Space>, Isometry)>,
    /// Of an octant, its frame.
    inverse: Option<DMat3>,
    pub(super) bounds: Bounds,
    /// Round the corners of its tiles alone; all of an octant.
    pub(super) corners: Bounds,
    tiles: OnceLock<Tiles>,
    pub(super) halvings: Halvings,
    core: OnceLock<Option<DVec3>>,
    /// Places of the border of an octant, far from each other.
    pub(super) places: OnceLock<Vec<DVec3>>,
    meridian: OnceLock<Option<Box<Meridian>>>,
}

/// Tiles with the tree of their boxes.
#[derive(Debug)]
pub(super) struct Tiles {
    pub(super) all: Vec<Tile>,
    pub(super) boxes: Boxes,
}

impl Tiles {
    pub(super) fn new(all: Vec<Tile>) -> Tiles {
        let bounds: Vec<Bounds> = all.iter().map(Tile::bounds).collect();
        Tiles { boxes: Boxes::new(&bounds), all }
    }
}

impl Space {
    fn new(solution: &Solution, part: usize) -> Result<Space> {
        let placed = Arc::clone(solution.part(part)?);
        let (_, of) = solution.existing(part)?;
        let still = solution.space_before(part)?.map(|still| (still, Isometry::of(&of.place)));
        watch::go_on()?;
        let (borders, is_solid) = match &still {
            Some((still, motion)) => (still.moved_borders(&placed, &of.place, motion), still.is_solid),
            None => bordered(solution, part, &placed, of.wall.is_some()),
        };
        watch::go_on()?;
        let mut space = Space {
            part,
            borders,
            is_solid,
            inverse: placed.solved().octant().map(|_| placed.matrix().inverse()),
            placed,
            still,
            bounds: Bounds::NOTHING,
            corners: Bounds::NOTHING,
            tiles: OnceLock::new(),
            halvings: Halvings::default(),
            core: OnceLock::new(),
            places: OnceLock::new(),
            meridian: OnceLock::new(),
        };
        [space.bounds, space.corners] = match space.inverse {
            Some(_) => {
                let unit = Bounds { low: DVec3::ZERO, high: DVec3::ONE };
                let bounds = Bounds::of(&unit.corners().map(|corner| space.placed_point(corner)));
                [bounds.wider(1e-15 * bounds.far()); 2]
            }
            None => space.tiles().all.iter().fold([Bounds::NOTHING; 2], |[all, corners], tile| {
                [all.with(tile.bounds()), corners.with(Bounds::of(&tile.corners))]
            }),
        };
        let (size, most) = (space.bounds.size(), space.bounds.far());
        if !(size > 1.0 / LARGEST && most < LARGEST) {
            let told = |x: f64| if x.is_finite() { format!("{x:e}") } else { "more than 1.7e308".to_owned() };
            let message = format!(
                "this part is {} across and {} from the origin at most, which cannot be computed with in space: expected sizes and places between {:e} and {LARGEST:e}",
                told(size),
                told(most),
                1.0 / LARGEST
            );
            let error = Error::new(Code::Overflow, space.placed.own_path(), message);
            let error = error.with("least", 1.0 / LARGEST).with("greatest", LARGEST);
            return Err(if size.is_finite() { error.with("found", size) } else { error });
        }
        Ok(space)
    }

    /// The border of a part that is this one, turned and moved.
    fn moved_borders(&self, placed: &Arc<Placed>, place: &Placement, motion: &Isometry) -> Vec<Border> {
        let mut shell: Option<Arc<Placed>> = None;
        let moved = self.borders.iter().map(|border| match border {
            Border::Face { pot, face, .. } => Border::Face { pot: Arc::clone(pot), face: *face, motion: *motion },
            Border::Patch { placed: still, patch, stretch } => {
                let placed = match Arc::ptr_eq(still, &self.placed) {
                    true => placed,
                    // Of an open network with a thickness the patches are those of a network of its own.
                    false => shell.get_or_insert_with(|| Arc::new(still.elsewhere(place, placed.index()))),
                };
                Border::Patch { placed: Arc::clone(placed), patch: *patch, stretch: *stretch }
            }
        });
        moved.collect()
    }

    /// What it is before it is turned and moved, and how it is; `None` of what is not.
    pub(super) fn still(&self) -> Option<(&Space, &Isometry)> {
        self.still.as_ref().map(|(still, motion)| (&**still, motion))
    }

    /// The octant that it is, if it is one.
    pub(super) fn octant(&self) -> Option<&Supersphere> {
        self.placed.solved().octant()
    }

    /// The part as it was solved.
    pub(super) fn placed(&self) -> &Placed {
        &self.placed
    }

    pub(super) fn placed_point(&self, at: DVec3) -> DVec3 {
        self.placed.matrix() * at + self.placed.shift()
    }

    /// What brings a point into the frame of an octant, but for its shift.
    pub(super) fn inverse(&self) -> Option<DMat3> {
        self.inverse
    }

    /// A point in the frame of an octant.
    pub(super) fn own(&self, at: DVec3) -> DVec3 {
        self.own_direction(at - self.placed.shift())
    }

    pub(super) fn own_direction(&self, direction: DVec3) -> DVec3 {
        self.inverse.map_or(direction, |inverse| inverse * direction)
    }

    /// A normal in the frame of an octant, placed.
    pub(super) fn placed_normal(&self, normal: DVec3) -> DVec3 {
        self.inverse.map_or(normal, |inverse| inverse.transpose() * normal).normalize_or(DVec3::Z)
    }

    /// From corner to corner of its box.
    pub(super) fn size(&self) -> f64 {
        self.bounds.size()
    }

    /// Whether what encloses it is proved, and not measured.
    pub(super) fn is_proved(&self) -> bool {
        self.borders.iter().all(Border::is_proved)
    }

    /// The tiles of its border, made when they are first asked for.
    pub(super) fn tiles(&self) -> &Tiles {
        self.tiles.get_or_init(|| {
            let all = match &self.still {
                Some((still, motion)) => still.tiles().all.iter().map(|tile| tile.moved(motion)).collect(),
                None => tiled(&self.borders, MOST_TILES),
            };
            Tiles::new(all)
        })
    }

    /// The profile of which it is the turned image; `None` of what is no body of revolution.
    pub(super) fn meridian(&self) -> Option<&Meridian> {
        let of = || Meridian::of(&self.borders, &self.placed, self.bounds.middle(), self.size()).map(Box::new);
        self.meridian.get_or_init(of).as_deref()
    }

    /// A point well inside; `None` of what has no inside, or none that was found.
    pub(super) fn core(&self) -> Option<DVec3> {
        *self.core.get_or_init(|| {
            if !self.is_solid {
                return None;
            }
            let at = match self.octant() {
                Some(octant) => self.placed_point(octant.core()),
                None => match &self.still {
                    Some((still, motion)) => motion.point(still.core()?),
                    None => self.deep()?,
                },
            };
            (self.holds(at) == Some(true)).then_some(at)
        })
    }

    /// A point half of the way through, from some tiles inwards: the deepest of a few.
    fn deep(&self) -> Option<DVec3> {
        const TRIED: usize = 8;
        let tiles = &self.tiles().all;
        let step = tiles.len().div_ceil(TRIED).max(1);
        let through = tiles.iter().step_by(step).filter_map(|tile| {
            let [u, v] = tile.middle();
            let border = &self.borders[tile.border];
            let (at, inwards) = (border.jet(u, v).position, -border.normal(u, v));
            let start = at + inwards * (1e-7 * self.size());
            let out = self.crossings(start, inwards).found.first()?.t;
            Some((out, at + inwards * (0.5 * out)))
        });
        let deepest = through.fold(None, |best: Option<(f64, DVec3)>, next| match best {
            Some((depth, _)) if depth >= next.0 => best,
            _ => Some(next),
        });
        deepest.map(|(_, at)| at)
    }
}

/// The border of a part where it stands, and whether that goes round an inside.
fn bordered(solution: &Solution, part: usize, placed: &Arc<Placed>, has_wall: bool) -> (Vec<Border>, bool) {
    let shell = match solution.has_shell(part, Product::Pot) {
        Ok(true) => solution.patched(part, Product::Pot).ok(),
        _ => None,
    };
    // What cannot be made is there all the same: as the surface that is seen of it.
    let pot = (has_wall && shell.is_none()).then(|| solution.pot(part, Product::Pot).ok()).flatten();
    if let Some(pot) = pot {
        return (Border::faces(&Arc::new(pot)), true);
    }
    let patches = shell.as_ref().unwrap_or(placed);
    (Border::patches(patches), patches.solved().is_closed())
}

/// The tiles of a border, halved until they are near enough, or there are as many as there may be.
pub(super) fn tiled(borders: &[Border], most: usize) -> Vec<Tile> {
    let cells = borders
        .iter()
        .enumerate()
        .flat_map(|(index, border)| border.cells().into_iter().map(move |cell| Tile::of(borders, index, cell)));
    let mut open: VecDeque<Tile> = cells.collect();
    let corners = open.iter().fold(Bounds::NOTHING, |all, tile| all.with(Bounds::of(&tile.corners)));
    let enough = COARSE * corners.size();
    let mut all = Vec::with_capacity(open.len());
    // Generation by generation.
    while let Some(tile) = open.pop_front() {
        let is_halved = tile.deviation > enough && all.len() + open.len() < most && !watch::is_stopped();
        match is_halved.then(|| tile.halves(borders)).flatten() {
            Some(halves) => open.extend(halves),
            None => all.push(tile),
        }
        watch::work(TILE);
    }
    all
}

impl Solution {
    /// What a part is in space, found once.
    ///
    /// # Errors
    /// As [`Solution::part`]; `overflow`; `cancelled`.
    pub(super) fn in_space(&self, part: usize) -> Result<Arc<Space>> {
        let kept = self.space(part)?;
        if let Some(space) = kept.get::<Result<Arc<Space>>>() {
            return space.clone();
        }
        let space = Space::new(self, part).map(Arc::new);
        watch::go_on()?;
        kept.keep(space.clone());
        space
    }
}
