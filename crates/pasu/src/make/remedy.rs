//! What would have to change of a wall that cannot be made.

use std::sync::Arc;

use super::making::Making;
use crate::answer::answers;
use crate::design::{RimForm, Side, Wall};
use crate::error::Error;
use crate::solid::{Pot, Skin, short, significant};
use crate::solution::Solution;
use crate::watch;
use crate::weave::{COARSE, Made, closed_patches, grid, meshed_once};

answers! {
    /// The nearest wall that was found to make a pot of a part that is refused.
    pub struct Remedy as "Remedy" {
        /// Where it belongs in the design, such as `parts[0].wall`.
        pub path: String,
        /// The whole wall, to be put there.
        pub wall: Wall,
        /// What is different of it, in words.
        pub message: String,
    }
}

#[cfg(feature = "typescript")]
crate::answer::known_as!(Wall, "Wall");

/// Digits of the lengths that are proposed: as many as a person would write.
const DIGITS: u32 = 2;

/// The most triangles of the surface on all meshes of walls that are tried: twenty coarse ones of an ordinary pot, and a few of the usual tolerance.
const MOST_TRIED: usize = 1_000_000;

/// What a patch of a network counts among them.
const A_PATCH: usize = 100;

/// The most work on all of them, in the units of [`watch::work`]: half a second.
const MOST_WORK: u64 = 50_000_000;

/// By how much walls are thinner.
const THINNER: [f64; 5] = [0.75, 0.5, 0.3, 0.15, 0.07];

/// By how much bases are thicker.
const THICKER: [f64; 4] = [1.5, 0.5, 2.5, 0.25];

/// The base of a pot that has none, in thicknesses of its wall.
const BASES: [f64; 4] = [1.0, 2.0, 4.0, 8.0];

/// By how much drains are wider.
const WIDER: [f64; 3] = [0.75, 0.5, 0.25];

/// The nearest wall, of those that are tried, that a part can be made with where it is refused by this error; `scale` is from model units to millimetres.
///
/// A coarse mesh decides which is worth a mesh within the tolerance asked for. Of what takes many triangles fewer walls are tried: nobody waits for a suggestion longer than for the verdict.
pub(super) fn remedy(solution: &Solution, part: usize, making: &Making, scale: f64, error: &Error) -> Option<Remedy> {
    watch::within(MOST_WORK, || sought(solution, part, making, scale, error)).flatten()
}

fn sought(solution: &Solution, part: usize, making: &Making, scale: f64, error: &Error) -> Option<Remedy> {
    let placed = solution.workable(part).ok()?;
    let asked = solution.wall(part, making.product).ok()??;
    let field = error.path().strip_prefix(&placed.path("wall."))?;
    if solution.has_shell(part, making.product).ok()? {
        let wall = of_network(solution, part, making, scale, &asked)?;
        return Some(Remedy::of(placed.path("wall"), &asked, wall));
    }
    let skin = Arc::new(solution.skin(part, making.product).ok()?);
    let n_triangles = |tolerance| grid(&skin, tolerance, None).map_or(usize::MAX, |grid| grid.n_triangles());
    let (coarse, fine) = (n_triangles(Some(COARSE * skin.size())), n_triangles(making.tolerance));
    let mut left = MOST_TRIED;
    let mut spend = |n: usize| {
        left = left.checked_sub(n)?;
        Some(())
    };
    let mut trials = Trials { skin: Arc::clone(&skin), scale, plain: Vec::new() };
    let made = |wall: Wall| Made::of(Pot::of(&skin, Some(wall))?, making.tolerance, scale);
    let mut found = None;
    for wall in tried(&asked, field) {
        spend(coarse)?;
        if trials.passes(wall) {
            spend(fine)?;
            if made(wall).is_ok() {
                found = Some(wall);
                break;
            }
        }
    }
    let wall = found?;
    Some(Remedy::of(placed.path("wall"), &asked, wall))
}

/// The same of an open network: what belongs to a foot is left out, then the clay is on the other side, then thinner. What cannot be computed costs little; the rest has to be meshed as a file would be.
fn of_network(solution: &Solution, part: usize, making: &Making, scale: f64, asked: &Wall) -> Option<Wall> {
    let plain = Wall { base: 0.0, rim: RimForm::Flat, foot: None, drain: 0.0, lining: None, ..*asked };
    let mut left = MOST_TRIED;
    let walls = [plain, across(plain)].into_iter().chain(thinner(plain)).filter(|wall| wall != asked);
    for wall in walls {
        let Ok(shell) = solution.shell_with(part, &wall) else { continue };
        left = left.checked_sub(A_PATCH * shell.solved().patches().len())?;
        if closed_patches(&shell, making.tolerance, scale).is_ok() {
            return Some(wall);
        }
    }
    None
}

impl Remedy {
    /// A wall in place of the one that is asked for.
    pub(super) fn of(path: String, asked: &Wall, wall: Wall) -> Remedy {
        Remedy { path, wall, message: words(asked, &wall) }
    }
}

/// Coarse meshes of walls.
struct Trials {
    skin: Arc<Skin>,
    scale: f64,
    /// Walls without ring and drain, with the pot where it passes: where it does not, none with them will.
    plain: Vec<(Wall, Option<Pot>)>,
}

impl Trials {
    fn passes(&mut self, wall: Wall) -> bool {
        let plain = Wall { foot: None, drain: 0.0, ..wall };
        if !self.plain.iter().any(|(known, _)| *known == plain) {
            let pot = Pot::looked_at(&self.skin, Some(plain), false).ok().filter(|pot| self.is_meshed(pot));
            self.plain.push((plain, pot));
        }
        let pot = self.plain.iter().find(|(known, _)| *known == plain).and_then(|(_, pot)| pot.as_ref());
        pot.is_some_and(|pot| wall == plain || pot.with_foot_of(wall).is_ok_and(|pot| self.is_meshed(&pot)))
    }

    fn is_meshed(&self, pot: &Pot) -> bool {
        meshed_once(pot, Some(COARSE * self.skin.size()), 1.0, self.scale).is_ok()
    }
}

fn thinner(wall: Wall) -> [Wall; THINNER.len()] {
    THINNER.map(|factor| Wall { thickness: significant(wall.thickness * factor, DIGITS), ..wall })
}

/// With the clay on the other side of the surface.
fn across(wall: Wall) -> Wall {
    let side = if wall.side == Side::Inside { Side::Outside } else { Side::Inside };
    Wall { side, lining: None, ..wall }
}

/// What there is to try where a field asks too much, the smaller change first.
fn tried(wall: &Wall, field: &str) -> Vec<Wall> {
    let scaled = |length: f64, factor: f64| significant(length * factor, DIGITS);
    let plain = Wall { foot: None, drain: 0.0, ..*wall };
    let mut tried = Vec::new();
    if wall.lining.is_some() {
        tried.push(Wall { lining: None, ..*wall });
    }
    match field {
        // No other ring would do, or the part would have been made with it.
        "foot" => tried.extend([Wall { foot: None, ..*wall }, across(*wall)]),
        "drain" => {
            tried.extend(WIDER.map(|factor| Wall { drain: scaled(wall.drain, factor), ..*wall }));
            tried.push(Wall { drain: 0.0, ..*wall });
        }
        "rim" => tried.push(Wall { rim: RimForm::Flat, ..*wall }),
        "base" if wall.base > 0.0 => {
            tried.extend(THICKER.map(|factor| Wall { base: scaled(wall.base, factor), ..*wall }))
        }
        _ => {}
    }
    if !matches!(field, "foot" | "drain") {
        tried.push(across(*wall));
        if wall.base == 0.0 {
            let bases = BASES.map(|factor| Wall { base: scaled(wall.thickness, factor), ..*wall });
            tried.extend(bases.into_iter().flat_map(|based| [based, across(based)]));
        }
        tried.extend(thinner(*wall));
    }
    if plain != *wall {
        tried.extend([plain, across(plain)]);
        tried.extend(thinner(plain));
    }
    tried
}

/// What one wall has that another has not.
fn words(asked: &Wall, wall: &Wall) -> String {
    let mut with = Vec::new();
    if wall.side != asked.side {
        let side = if wall.side == Side::Inside { "inside" } else { "outside" };
        with.push(format!("the clay {side} of the surface"));
    }
    if wall.lining.is_none() && asked.lining.is_some() {
        with.push("an inside that follows the outside".to_owned());
    }
    if wall.thickness != asked.thickness {
        with.push(format!("a wall of {}", short(wall.thickness)));
    }
    if wall.base != asked.base {
        with.push(format!("a base of {}", short(wall.base)));
    }
    if wall.rim != asked.rim {
        with.push("a flat rim".to_owned());
    }
    match wall.foot {
        Some([width, height]) if wall.foot != asked.foot => {
            with.push(format!("a ring {} wide and {} high", short(width), short(height)));
        }
        None if asked.foot.is_some() => with.push("no ring".to_owned()),
        _ => {}
    }
    if wall.drain != asked.drain {
        with.push(if wall.drain > 0.0 { format!("a drain of {}", short(wall.drain)) } else { "no drain".to_owned() });
    }
    format!("it can be made with {}", with.join(" and "))
}
