//! Rings through a scan: triangles of a pot that stands upright.

mod handle;
mod levels;
mod off;
mod section;

use glam::DVec3;

use self::handle::without_handle;
pub use self::levels::Levels;
use self::levels::of_triangles;
use self::off::off;
use self::section::{DIRECTIONS, Section, middle};
use super::contract::check_tolerance;
use super::digits::{decimal, to_multiple};
use super::profile::{Profile, fit};
use super::series::series;
use crate::answer::answers;
use crate::design::{Design, Hoop, Placement, Rings, Shape, plain};
use crate::error::{Code, Error, Result};
use crate::surface::Surface;
use crate::watch;

/// Each time the outline is followed twice as closely, which takes more rings: waves between rings are followed more closely by that, too.
const ROUNDS: i32 = 5;

/// The most work on all but the first of them, in the units of [`watch::work`]: somewhat more than half a second.
const MOST_WORK: u64 = 45_000_000;

/// Waves of a ring that are left out, as a part of how far off it may be.
const UNSEEN: f64 = 0.15;

/// Waves go round at most so often: finer ones are the texture of the clay.
const FINEST: usize = 16;

/// The most triangles of a scan.
const MOST_TRIANGLES: usize = 4_000_000;

answers! {
    /// A pot of rings through a scan.
    pub struct Scanned as "Scanned" {
        /// The design, where the scan stands.
        pub design: Design,
        /// How far the scan is from it at most. An estimate: it is looked for at some ten thousand points of the outside.
        pub distance: f64,
        /// The root of the mean of the squares of these distances.
        pub rms: f64,
        /// The same where what stands out at one side like a handle is left out of account, which no ring goes round; null where nothing does.
        pub without_handle: Option<Apart>,
    }

    /// How far a scan is from a pot.
    pub struct Apart as "Apart" {
        /// At most.
        pub distance: f64,
        /// The root of the mean of the squares.
        pub rms: f64,
    }
}

/// Triangles of a pot that stands upright.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Scan {
    /// `[x, y, z, x, y, z, ..]`: points, or the corners of one triangle after the other.
    pub positions: Vec<f32>,
    /// The numbers of three points for each triangle; without them every three points are one.
    pub indices: Option<Vec<u32>>,
}

impl Scan {
    /// Triangles that are given corner by corner, nine numbers each.
    ///
    /// ```
    /// assert!(pasu::Scan::new(vec![0.0; 9]).indices.is_none());
    /// ```
    pub fn new(positions: Vec<f32>) -> Scan {
        Scan { positions, indices: None }
    }
}

/// A pot of `rings` through the outside of a scan, with as few rings and waves as keep all points within a tolerance in the unit of the scan.
///
/// The axis is where level sections have their middle. The profile of the middle radii is fitted as [`fit`] does, and each ring gets the waves of the section at its height, up to 16. The inside is not looked at; nor is what is not closed all round, such as a broken or slanting rim, where the pot ends.
/// Where rings cannot come so near as is asked for, those are given that come nearest, and [`Scanned::distance`] says how near that is.
///
/// ```
/// use pasu::{Design, MeshOptions, Scan, fit_scan, mesh};
///
/// let vase = Design::parse("#1/fourth-order?r0=2&r1=2&rm=3&h1=6")?;
/// let mesh = mesh(&vase, &MeshOptions { rows: Some(80), columns: Some(120), ..MeshOptions::default() })?;
/// let mut scan = Scan::new(mesh.positions);
/// scan.indices = Some(mesh.indices);
/// let scanned = fit_scan(&scan, 0.02)?;
/// assert!(scanned.distance < 0.02 && scanned.without_handle.is_none());
/// # Ok::<(), pasu::Error>(())
/// ```
///
/// # Errors
/// `wrong-type` for a number of coordinates that is not that of triangles, `too-large` for more than 4,000,000 triangles, `not-finite` for a coordinate that is none, `out-of-range` for the number of a point that does not exist and for a tolerance that is not above 0, `unsupported-shape` where too few levels are closed round an axis, and what [`fit`] refuses.
pub fn fit_scan(scan: &Scan, tolerance: f64) -> Result<Scanned> {
    check_tolerance(tolerance)?;
    Ok(fit_levels(&levels(scan)?, tolerance)?.scanned)
}

/// The outside of a scan, level by level: what [`fit_scan`] fits rings to. Levels that are not closed all round at foot and rim are left out, holes in the wall between are bridged; what stands out like a handle is taken for the outermost there is.
///
/// ```
/// use pasu::{Design, MeshOptions, Scan, fit_levels, levels, mesh};
///
/// let vase = Design::parse("#1/fourth-order?r0=2&r1=2&rm=3&h1=6")?;
/// let mesh = mesh(&vase, &MeshOptions { rows: Some(80), columns: Some(120), ..MeshOptions::default() })?;
/// let mut scan = Scan::new(mesh.positions);
/// scan.indices = Some(mesh.indices);
/// let levels = levels(&scan)?;
/// let fitted = fit_levels(&levels, 0.02)?;
/// assert!(fitted.scanned.distance < 0.02);
/// assert_eq!(fitted.away.len() % levels.heights.len(), 0);
/// # Ok::<(), pasu::Error>(())
/// ```
///
/// # Errors
/// As [`fit_scan`] has them of the scan.
pub fn levels(scan: &Scan) -> Result<Levels> {
    of_triangles(&triangles(scan)?).ok_or_else(|| unable("positions"))
}

fn unable(path: &str) -> Error {
    let message = "too few levels of the scan are closed round an axis: expected a pot that stands upright";
    Error::new(Code::UnsupportedShape, path, message)
}

/// Rings through the levels of a scan, and how far each place of its outside is from them.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct FittedLevels {
    /// The pot of rings, about the axis of the levels and above their bottom.
    pub scanned: Scanned,
    /// How far the outside is from the pot, level by level from the foot, in directions of equal angles from that of x: above 0 where it is outside of the pot, below 0 inside. What stands out like a handle is looked at too.
    pub away: Vec<f32>,
}

/// As [`fit_scan`], of levels that were read before: another tolerance, or another size, needs no triangles.
///
/// # Errors
/// `wrong-type` for fewer than two levels, or levels that do not have 180 distances each, `too-large` for more than 1000 levels, `not-finite` and `out-of-range` for numbers that are no heights from below and no distances, `out-of-range` for a tolerance that is not above 0, and what [`fit`] refuses.
pub fn fit_levels(levels: &Levels, tolerance: f64) -> Result<FittedLevels> {
    check_tolerance(tolerance)?;
    levels.check()?;
    let bridged = without_handle(&levels.radii);
    let sections = bridged.as_ref().unwrap_or(&levels.radii);
    let profile = Profile::new(outline(levels, sections));
    let round = |round: i32| {
        let closely = tolerance * libm::exp2(-f64::from(round));
        let fitted = fit(&profile, closely)?;
        let Shape::Rings(rings) = &fitted.design.parts()[0].shape else { return Err(unable("heights")) };
        let rings = with_waves(rings, levels, sections, UNSEEN * closely);
        let surface = Surface::solve(&rings.boundary_value(), "")?;
        let found = off(levels, sections, &surface);
        Ok((rings, surface, found))
    };
    let mut best = round(0)?;
    let closer = || {
        for number in 1..ROUNDS {
            if best.2.most <= tolerance {
                return;
            }
            // Closer than rings can follow: what was found before is the best there is.
            let Ok(next) = round(number) else { return };
            if next.2.most <= tolerance || next.2.rms < best.2.rms {
                best = next;
            }
        }
    };
    watch::within(MOST_WORK, closer);
    watch::go_on()?;
    let (rings, surface, found) = best;
    let without = Apart { distance: found.most, rms: found.rms };
    let whole = if bridged.is_some() { off(levels, &levels.radii, &surface) } else { found };
    let [x, y] = levels.axis;
    let design = Design::parse("#1/rings")?.with_shape(0, Shape::Rings(rings))?;
    let scanned = Scanned {
        design: design.placed(0, Placement { shift: [x, y, levels.bottom], ..Placement::default() })?,
        distance: whole.most,
        rms: whole.rms,
        without_handle: bridged.map(|_| without),
    };
    Ok(FittedLevels { scanned, away: whole.away })
}

/// The triangles of a scan by their corners.
fn triangles(Scan { positions, indices }: &Scan) -> Result<Vec<[DVec3; 3]>> {
    let (path, numbers, each) = match indices {
        Some(indices) => ("indices", indices.len(), 3),
        None => ("positions", positions.len(), 9),
    };
    if numbers == 0 || !numbers.is_multiple_of(each) || !positions.len().is_multiple_of(3) {
        let message = format!(
            "expected {each} numbers for each triangle and three for each point, found {numbers} numbers for {} coordinates",
            positions.len()
        );
        return Err(Error::new(Code::WrongType, path, message));
    }
    let found = numbers / each;
    if found > MOST_TRIANGLES || positions.len() > 9 * MOST_TRIANGLES {
        let message = format!("expected at most {MOST_TRIANGLES} triangles, found {found}");
        let error = Error::new(Code::TooLarge, path, message);
        return Err(error.with("greatest", MOST_TRIANGLES).with("found", found));
    }
    if let Some(index) = positions.iter().position(|number| !number.is_finite()) {
        let message = format!("expected a finite number, found {}", plain(f64::from(positions[index])));
        return Err(Error::new(Code::NotFinite, format!("positions[{index}]"), message));
    }
    let points: Vec<DVec3> =
        positions.as_chunks::<3>().0.iter().map(|at| DVec3::from_array(at.map(f64::from))).collect();
    let Some(indices) = indices else { return Ok(points.as_chunks::<3>().0.to_vec()) };
    if let Some(index) = indices.iter().position(|vertex| *vertex as usize >= points.len()) {
        let message = format!("expected the number of one of {} points, found {}", points.len(), indices[index]);
        let error = Error::new(Code::OutOfRange, format!("indices[{index}]"), message);
        return Err(error.with("greatest", points.len() - 1).with("found", indices[index] as usize));
    }
    Ok(indices.as_chunks::<3>().0.iter().map(|corners| corners.map(|vertex| points[vertex as usize])).collect())
}

/// The middles of the radii of each level with its height, from the foot to the rim: half of what is around is further out.
fn outline(levels: &Levels, sections: &[Section]) -> Vec<f64> {
    levels.heights.iter().zip(sections).flat_map(|(height, section)| [middle(section), *height]).collect()
}

/// The rings of a round pot with the waves of the scan at their heights, without those that are lower than is seen.
fn with_waves(round: &Rings, levels: &Levels, sections: &[Section], unseen: f64) -> Rings {
    let unit = decimal(0.1 * unseen);
    let ring = |ring: &Hoop| {
        let section = section_at(levels, sections, ring.z.mean);
        let mut found = series(&section, FINEST, unseen, |_| 1.0);
        for wave in &mut found.waves {
            (wave.cos, wave.sin) = (to_multiple(wave.cos, unit), to_multiple(wave.sin, unit));
        }
        found.mean = to_multiple(ring.r.mean + found.mean - middle(&section), unit);
        Hoop { r: found, ..ring.clone() }
    };
    Rings { rings: round.rings.iter().map(ring).collect(), ..round.clone() }
}

/// The section at a height, between those that were taken.
fn section_at(levels: &Levels, sections: &[Section], height: f64) -> Section {
    let last = levels.heights.len() - 1;
    let next = levels.heights.partition_point(|known| *known < height).clamp(1, last);
    let (low, high) = (levels.heights[next - 1], levels.heights[next]);
    let share = ((height - low) / (high - low)).clamp(0.0, 1.0);
    (0..DIRECTIONS).map(|k| (1.0 - share) * sections[next - 1][k] + share * sections[next][k]).collect()
}
