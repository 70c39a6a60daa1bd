//! Measuring a design, part by part.

use std::sync::Arc;

use super::accuracy::Accuracy;
use super::capacity::{Capacity, Fill};
use super::cause::Cause;
use super::curvature::{Curvature, curvature};
use super::dry::Dry;
use super::fill::Filling;
use super::finite::{refuse_infinite, refuse_infinite_part};
use super::known::Instance;
use super::measures::{
    Body, Centre, ClayMeasures, LeastThickness, MeasureOptions, Measures, Overhang, PartMeasures, ThicknessRange, Width,
};
use super::moments::{Moments, area, enclosed};
use super::moved::Moved;
use super::outside::{Outside, Spot, columns};
use super::quantity::Quantity;
use super::share::Share;
use super::standing::Standing;
use super::taken::{ACCURACY, Naked, Taken};
use super::widths::Widths;
use crate::design::{Choice, Clay, Design, Part, plain, rounded};
use crate::error::{Code, Error, Result};
use crate::face::FaceKind;
use crate::solid::Product;
use crate::solution::Solution;
use crate::watch;

/// The mass of a cubic centimetre of water in grams.
const WATER: f64 = 1.0;

impl Clay {
    /// The usual density of the fired body in g/cm3.
    ///
    /// ```
    /// assert_eq!(pasu::Clay::Terracotta.density(), 1.9);
    /// ```
    pub fn density(self) -> f64 {
        match self {
            Clay::Stoneware | Clay::Black => 2.3,
            Clay::Porcelain => 2.4,
            Clay::Terracotta => 1.9,
        }
    }
}

impl Choice<Clay> {
    /// The usual density of the fired body in g/cm3; of a clay of one's own colour, that of stoneware.
    ///
    /// ```
    /// use pasu::{Clay, Colour, Choice};
    ///
    /// let own: Choice<Clay> = Colour([120, 90, 60]).into();
    /// assert_eq!(own.density(), Clay::Stoneware.density());
    /// ```
    pub fn density(self) -> f64 {
        match self {
            Choice::Named(clay) => clay.density(),
            Choice::Own(_) => Clay::default().density(),
        }
    }
}

/// Up to this share of the time thicknesses are found,
const TAKING: f64 = 0.3;

/// and up to this one parts are measured.
const TOGETHER: f64 = 0.9;

/// The most work on measuring one part, in the units of [`watch::work`]: two seconds in WebAssembly, with what goes before it.
const MOST_WORK: u64 = 123_000_000;

/// What measuring the wall of a surface of many terms takes for each wave and each term, in the same units, as it was found on outlines of 24 to 128 waves, give or take two fifths. The base cuts it at another place of every column, and each of these takes rows of its own.
const CUT: f64 = 90_500.0;

/// Surfaces of no more terms than this are measured in time whatever their wall.
const FEW_TERMS: usize = 48;

/// Refuses beforehand what would be refused after all of [`MOST_WORK`].
fn refuse_hopeless(solution: &Solution, product: Product) -> Result<()> {
    for (index, part) in solution.design().parts().iter().enumerate() {
        let placed = solution.workable(index)?;
        let Some(surface) = placed.solved().fourier().filter(|_| part.wall.is_some() && product == Product::Pot) else {
            continue;
        };
        let waves = surface.distinct().iter().fold(0.0f64, |most, n| most.max(n.abs()));
        let n_terms = surface.n_terms();
        if n_terms > FEW_TERMS && CUT * waves * n_terms as f64 > MOST_WORK as f64 {
            return Err(too_long(solution.design(), index));
        }
    }
    Ok(())
}

/// The refusal of a part on which more of it would have to be done.
fn too_long(design: &Design, index: usize) -> Error {
    let (field, expected) = match design.parts()[index].wall {
        Some(_) => ("wall", "fewer waves, shallower ones or a thinner wall"),
        None => ("shape", "fewer waves or shallower ones"),
    };
    let message =
        format!("it is folded or waved so finely that nobody would wait until it is measured: expected {expected}");
    Error::new(Code::TooLarge, format!("parts[{index}].{field}"), message)
}

/// Measures a design: by quadrature and search on the closed form, each quantity with its error.
///
/// A part that cannot be a pot has the measures of its surface, and says why.
///
/// # Errors
/// What [`Surface::solve`](crate::Surface::solve) refuses; `out-of-range` for a density that is not positive, a fill level that is not finite, or one above the spill point, whose level is in the message; `overflow` where
/// the surface leaves the range of numbers.
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// let measures = pasu::measure(&cup, &pasu::MeasureOptions::default())?;
/// let brim = measures.whole.capacity.expect("it holds water").brim;
/// // Inside, a cylinder of radius 2.5 and height 3.
/// assert!((brim.value - std::f64::consts::PI * 2.5 * 2.5 * 3.0).abs() <= brim.error);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn measure(design: &Design, options: &MeasureOptions) -> Result<Measures> {
    Solution::of(design).measure(options)
}

impl Solution {
    /// As [`measure`].
    ///
    /// # Errors
    /// As [`measure`].
    pub fn measure(&self, options: &MeasureOptions) -> Result<Measures> {
        measures(self, options)
    }
}

fn measures(solution: &Solution, options: &MeasureOptions) -> Result<Measures> {
    check(options)?;
    refuse_hopeless(solution, options.product)?;
    let design = solution.design();
    let instances = watch::between(0.0, TAKING, || instances(solution, options.product))?;
    let n = instances.len();
    let one = |(index, (instance, part)): (usize, (&Instance, &Part))| {
        let (part, share) = instance.measures(part, options, |options| {
            let part = || watch::within(MOST_WORK, || part_measures(design, index, &instance.subject.taken, options));
            let measured = watch::share(index, n, part);
            watch::go_on()?;
            let (part, share) = measured.unwrap_or_else(|| Err(too_long(design, index)))?;
            refuse_infinite_part(&part)?;
            Ok((part, share))
        })?;
        let part = PartMeasures { part: index, ..part };
        refuse_infinite_part(&part)?;
        Ok((part, share))
    };
    let measured = || instances.iter().zip(design.parts()).enumerate().map(one).collect::<Result<Vec<_>>>();
    let (parts, shares): (Vec<_>, Vec<_>) = watch::between(TAKING, TOGETHER, measured)?.into_iter().unzip();
    if let Some(fill) = options.fill {
        refuse_overflow(&parts, fill)?;
    }
    let whole = match parts.as_slice() {
        [part] => part.body.clone(),
        _ => whole(&instances, &parts, &shares),
    };
    // A sum of finite numbers need not be one.
    refuse_infinite(&whole, "parts")?;
    Ok(Measures { unit: design.unit(), product: options.product, whole, parts })
}

/// Every part of a design.
fn instances(solution: &Solution, product: Product) -> Result<Vec<Instance>> {
    let n = solution.n_parts();
    (0..n).map(|index| watch::share(index, n, || Instance::new(solution, index, product))).collect()
}

/// What a design is scaled by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Gauge {
    /// The height of the whole.
    Height,
    /// The greatest width of the whole.
    Width,
    /// What all parts together hold to the brim.
    Capacity,
}

/// One measure of the whole design, without the others.
///
/// # Errors
/// As [`measure`]; `no-room` for the capacity of a design that holds nothing, with the reason.
pub(crate) fn gauge(solution: &Solution, product: Product, gauge: Gauge) -> Result<f64> {
    let instances = watch::between(0.0, TAKING, || instances(solution, product))?;
    let moved: Vec<Vec<Moved>> = instances.iter().map(Instance::faces).collect();
    match gauge {
        Gauge::Height => {
            let all = Instance::outsides(&instances, &moved);
            let heights = all.iter().map(Outside::heights);
            let [low, high] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [bottom, top]| {
                [low.min(bottom), high.max(top)]
            });
            Ok(high - low)
        }
        Gauge::Width => Ok(Outside::widths_of(&Instance::outsides(&instances, &moved)).greatest.value),
        Gauge::Capacity => {
            let (mut found, mut reason) = (Vec::new(), None);
            // Copies hold as much as the first of them.
            let mut known: Vec<(&Instance, f64)> = Vec::new();
            for (instance, part) in instances.iter().zip(solution.design().parts()) {
                if let Some((_, brim)) = known.iter().find(|(other, _)| Arc::ptr_eq(&other.subject, &instance.subject))
                {
                    found.push(*brim);
                    continue;
                }
                let taken = &instance.subject.taken;
                let vessel = taken.vessel(part.wall.is_some(), product);
                match vessel.and_then(|vessel| vessel.capacity(&taken.accuracy(), None)) {
                    Ok((capacity, _)) => {
                        known.push((instance, capacity.brim.value));
                        found.push(capacity.brim.value);
                    }
                    Err(why) => {
                        reason.get_or_insert(why);
                    }
                }
            }
            // The least first: the same sum to the bit in whichever order the parts stand.
            found.sort_unstable_by(f64::total_cmp);
            found.into_iter().reduce(|sum, next| sum + next).ok_or_else(|| {
                let message = reason.as_ref().map_or("", |dry: &Dry| &dry.message);
                let error = Error::new(Code::NoRoom, "size.capacity", message);
                reason.iter().fold(error, |error, dry| error.with("what", dry.cause.code))
            })
        }
    }
}

/// How many waves go round any part at most.
fn waves(instances: &[Instance]) -> f64 {
    instances.iter().map(|instance| instance.subject.taken.waves()).fold(0.0, f64::max)
}

fn check(options: &MeasureOptions) -> Result<()> {
    if let Some(density) = options.density.filter(|density| !(*density > 0.0 && density.is_finite())) {
        let message = format!("expected a density in g/cm3 greater than 0, found {}", plain(density));
        return Err(Error::new(Code::OutOfRange, "density", message).with("above", 0.0).with("found", density));
    }
    if let Some(fill) = options.fill.filter(|fill| !fill.is_finite()) {
        let message = format!("expected a level, found {}", plain(fill));
        return Err(Error::new(Code::OutOfRange, "fill", message).with("found", fill));
    }
    Ok(())
}

fn refuse_overflow(parts: &[PartMeasures], fill: f64) -> Result<()> {
    let spills = parts.iter().filter_map(|part| part.body.capacity).map(|capacity| capacity.spill.level);
    let highest = spills.max_by(|x, y| x.value.total_cmp(&y.value));
    match highest {
        Some(spill) if fill > spill.value + spill.error => Err(above_spill("fill", fill, spill.value)),
        _ => Ok(()),
    }
}

/// The refusal of a level at which water runs out.
pub(crate) fn above_spill(path: &str, level: f64, spill: f64) -> Error {
    let message = format!(
        "water runs out at the level {}: expected no more than that, found {}",
        plain(rounded(spill)),
        plain(level)
    );
    Error::new(Code::OutOfRange, path, message).with("greatest", rounded(spill)).with("found", level)
}

fn part_measures(
    design: &Design,
    index: usize,
    taken: &Taken,
    options: &MeasureOptions,
) -> Result<(PartMeasures, Share)> {
    let part = &design.parts()[index];
    let outside = &taken.outside();
    let accuracy = taken.accuracy();
    let [bottom, top] = outside.heights();
    let naked = taken.naked_faces();
    let sum = |areas: Vec<Quantity>| areas.into_iter().reduce(|sum, area| sum + area).unwrap_or_default();
    // Closed patches are their own body: its area is theirs.
    let bare = taken.is_its_own_body().then(|| enclosed(&naked, &accuracy));
    let open = taken.open_faces();
    let surface = match &bare {
        _ if !open.is_empty() => sum(open.iter().map(|face| area(*face, &accuracy)).collect()),
        Some((areas, _)) => sum(areas.clone()),
        None => sum(naked.iter().map(|face| area(*face, &accuracy)).collect()),
    };
    let (height, width) = (outside.height(), width(outside.widths()));
    let mut body = Body { height, bottom, top, width, area: surface, ..Body::default() };
    // Before all that would take long on a surface without an end.
    refuse_infinite(&body, &format!("parts[{index}]"))?;
    let centimetres = design.unit().millimetres() / 10.0;
    let cubic_centimetre = centimetres * centimetres * centimetres;
    watch::go_on()?;
    let mut share = Share { clay: None, water: None };
    let mut thickness = None;
    if let Some(faces) = taken.body() {
        let (areas, all) = bare.unwrap_or_else(|| enclosed(&faces, &accuracy));
        let clay = taken.known().unwrap_or(all);
        let density = options.density.unwrap_or(part.look.clay.density()) * cubic_centimetre;
        let mass = clay.scaled(density);
        body.clay = Some(ClayMeasures { area: sum(areas), volume: clay.volume, mass: mass.volume });
        share.clay = Some(mass);
        if let (Some(wall), Product::Pot, Ok(pot)) = (&part.wall, options.product, &taken.pot) {
            let (least, greatest) = pot.thickness();
            let thinned = pot.thinned();
            let [of_least, of_greatest, of_share] = pot.thickness_errors();
            thickness = Some(ThicknessRange {
                asked: wall.thickness,
                least: LeastThickness { value: least, error: of_least, at: thinned.map(|(_, at)| at.to_array()) },
                greatest: Quantity::new(greatest, of_greatest),
                thinned: Quantity::new(thinned.map_or(0.0, |(share, _)| share), of_share),
            });
        }
    }
    watch::go_on()?;
    let mut dry = None;
    let vessel = taken.vessel(part.wall.is_some(), options.product);
    match vessel.and_then(|vessel| vessel.capacity(&accuracy, options.fill)) {
        Ok((capacity, Filling { moments, .. })) => {
            body.capacity = Some(capacity);
            share.water = Some(moments.scaled(WATER * cubic_centimetre));
        }
        Err(reason) => dry = Some(reason),
    }
    watch::go_on()?;
    stand(&mut body, &share, || Standing::new(&[outside], columns(taken.waves())), &accuracy);
    // Patches with a thickness have the wall that was asked for, though they are no pot.
    let refusal = taken.pot.as_ref().err().filter(|_| open.is_empty());
    let is_wall = |kind: FaceKind| matches!(kind, FaceKind::Outer | FaceKind::Rim);
    let lining = outside.overhang(|kind| kind == FaceKind::Lining);
    Ok((
        PartMeasures {
            part: index,
            name: part.name.clone(),
            body,
            is_pot: refusal.is_none(),
            reason: refusal.map(|why| why.message().to_owned()),
            capacity_reason: dry.as_ref().map(|dry| dry.message.clone()),
            cause: refusal.map(Cause::from),
            capacity_cause: dry.map(|dry| dry.cause),
            thickness,
            overhang: outside.overhang(is_wall).and_then(overhang),
            overhang_inside: lining.and_then(overhang),
            curvature: match &taken.surface {
                Naked::Upright { bare, .. } => curvature(bare),
                Naked::Patches { .. } => Curvature::default(),
            },
        },
        share,
    ))
}

impl PartMeasures {
    /// Says why it has no wall; and if it was to have one, that this is why it holds nothing.
    pub(super) fn is_refused(&mut self, why: &Error, is_to_be_hollow: bool) {
        (self.reason, self.cause) = (Some(why.message().to_owned()), Some(Cause::from(why)));
        if is_to_be_hollow {
            (self.capacity_reason, self.capacity_cause) = (self.reason.clone(), self.cause.clone());
        }
    }
}

/// Centres of mass, footprint and tipping.
fn stand<'a>(body: &mut Body, share: &Share, standing: impl FnOnce() -> Standing<'a>, accuracy: &Accuracy) {
    let Some(clay) = &share.clay else { return };
    let standing = standing();
    body.footprint = Some(standing.footprint(accuracy));
    let full = share.water.as_ref().map(|water| clay.plus(water));
    if let Some((centre, error)) = clay.centre() {
        body.centre.empty = Some(Centre { at: centre.to_array(), error });
        body.tipping.empty = Some(standing.tipping(centre, error));
    }
    if let Some((centre, error)) = full.and_then(|full| full.centre()) {
        body.centre.full = Some(Centre { at: centre.to_array(), error });
        body.tipping.full = Some(standing.tipping(centre, error));
    }
}

fn width(widths: Widths) -> Width {
    Width {
        least: widths.least,
        greatest: widths.greatest,
        least_direction: widths.least_direction.to_degrees(),
        greatest_direction: widths.greatest_direction.to_degrees(),
    }
}

/// `None` where the face is too large or too small for its normal to be known.
fn overhang(Spot { value, error, at, face }: Spot) -> Option<Overhang> {
    let degrees = value.to_degrees();
    // No wall leans by more than a quarter of a turn to either side: where normals jump, as at the needles of an octant, nothing closer may be known.
    let most = 90.0 + degrees.abs();
    let error = error.to_degrees();
    let error = if error <= most { error } else { most };
    value.is_finite().then_some(Overhang { degrees, error, at: at.to_array(), face })
}

/// The measures of several parts together.
fn whole(instances: &[Instance], parts: &[PartMeasures], shares: &[Share]) -> Body {
    let highest = waves(instances);
    let accuracy = Accuracy::new(ACCURACY, highest);
    let moved: Vec<Vec<Moved>> = instances.iter().map(Instance::faces).collect();
    let bodies = Instance::outsides(instances, &moved);
    let bottom = parts.iter().fold(f64::INFINITY, |bottom, part| bottom.min(part.body.bottom));
    let top = parts.iter().fold(f64::NEG_INFINITY, |top, part| top.max(part.body.top));
    let error = parts.iter().fold(0.0f64, |error, part| error.max(part.body.height.error));
    let clays = parts.iter().filter_map(|part| part.body.clay);
    let clay = clays.reduce(|sum, clay| ClayMeasures {
        area: sum.area + clay.area,
        volume: sum.volume + clay.volume,
        mass: sum.mass + clay.mass,
    });
    let capacities = parts.iter().filter_map(|part| part.body.capacity);
    let capacity = capacities.reduce(|sum, next| {
        let last = if next.spill.level.value > sum.spill.level.value { next } else { sum };
        Capacity {
            brim: sum.brim + next.brim,
            spill: last.spill,
            floor: sum.floor.min(next.floor),
            fill: sum
                .fill
                .zip(next.fill)
                .map(|(sum, next)| Fill { level: sum.level.max(next.level), volume: sum.volume + next.volume }),
            stopped: sum.stopped || next.stopped,
        }
    });
    let sum = |of: fn(&Share) -> Option<Moments>| shares.iter().filter_map(of).reduce(|sum, next| sum.plus(&next));
    let share = Share { clay: sum(|share| share.clay), water: sum(|share| share.water) };
    let mut body = Body {
        height: Quantity::new(top - bottom, error),
        bottom,
        top,
        width: width(Outside::widths_of(&bodies)),
        area: parts.iter().fold(Quantity::default(), |sum, part| sum + part.body.area),
        clay,
        capacity,
        ..Body::default()
    };
    let outsides: Vec<&Outside> = bodies.iter().collect();
    stand(&mut body, &share, || Standing::new(&outsides, columns(highest)), &accuracy);
    body
}
