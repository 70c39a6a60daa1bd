//! The union of several bodies, as a file has it.
//!
//! The union is that of the crate `boolmesh`, after E. Lalish's *Manifold*: decided by topology and not by coordinates, so that what comes of closed bodies is closed. Whether it is still so once its coordinates are rounded to those of a file is checked here, as of every body that is written.

use boolmesh::prelude::Manifold;

use super::boxes::bounds;
use super::cluster::united;
use super::labelled::Labelled;
use super::net::Net;
use super::swollen::{Swollen, swollen};
use super::turn::Turn;
use crate::check::{self, Topology};
use crate::error::{Code, Error, Result};
use crate::mesh::DEFAULT_FINENESS;
use crate::watch;

/// The most triangles of all bodies that are joined.
const MOST_TRIANGLES: usize = 2_000_000;

/// How a union is tried, until what is left survives rounding to seven digits.
#[derive(Clone, Copy)]
struct Attempt {
    /// Corners that are nearer to each other than this share of the size are drawn together.
    near: f64,
    /// Bodies are wider than they are by multiples of this share of their largest coordinate.
    wider: f64,
    /// The number of the turn in which they are joined.
    turn: usize,
}

impl Attempt {
    const fn turned(turn: usize) -> Attempt {
        Attempt { near: 1e-12, wider: 0.0, turn }
    }

    const fn of(near: f64, wider: f64) -> Attempt {
        Attempt { near, wider, turn: 0 }
    }
}

/// One after the other.
const ATTEMPTS: [Attempt; 10] = [
    Attempt::turned(0),
    Attempt::turned(1),
    Attempt::turned(2),
    Attempt::turned(3),
    Attempt::of(2e-7, 0.0),
    Attempt::of(1e-12, 4e-6),
    Attempt::of(2e-7, 2e-6),
    Attempt::of(2e-7, 8e-6),
    Attempt::of(1e-12, 1.6e-5),
    Attempt::of(2e-6, 0.0),
];

/// How far the volume of a union may lie outside what those of its bodies allow, as a share of these.
const SLACK: f64 = 1e-5;

/// No point of a union of bodies that are wider is moved by more than this share of the tolerance, all together.
const MOST_MOVED: f64 = 0.5;

/// How far the volume of a union of bodies that are wider may lie from that of these as they are, as a share of it.
const MOST_WIDER: f64 = 1e-4;

/// Of so many bodies that cannot be joined the names are told.
const MOST_NAMES: usize = 3;

/// What several bodies are together, having passed the checks of a file.
pub(crate) struct Union {
    pub(crate) points: Vec<[f32; 3]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// What each triangle was labelled, in rising order.
    pub(crate) labels: Vec<u32>,
    pub(crate) topology: Topology,
    /// No point is further from the surfaces of the bodies.
    pub(crate) moved: f64,
}

/// What a union has to be like.
#[derive(Clone, Copy)]
struct Kind {
    topology: Topology,
    volume: f64,
}

impl Kind {
    /// What triangles are like that close, whether they cross or not.
    fn of(points: &[[f32; 3]], triangles: &[[u32; 3]]) -> Option<Kind> {
        let topology = check::closed(triangles, points.len()).ok()?;
        Some(Kind { topology, volume: volume_within(points, triangles) })
    }

    fn is_about_as_large_as(&self, other: &Kind) -> bool {
        (self.volume - other.volume).abs() <= MOST_WIDER * other.volume
    }
}

/// Triangles of a union in the numbers of a file, before anything is known of them.
struct Soup {
    points: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    labels: Vec<u32>,
}

/// The union of bodies whose triangles keep a tolerance, in their own unit; a share of the largest body when left out. Where their surfaces cannot be told apart as they are, bodies are joined that are wider by half of that at most, if this gives as many solids with as many handles.
///
/// # Errors
/// `crosses-itself` at `union` where none passes the checks of a file, `too-large`.
pub(crate) fn union(bodies: &[&Labelled], tolerance: Option<f64>) -> Result<Union> {
    let n_triangles = bodies.iter().map(|body| body.indices.len() / 3).sum::<usize>();
    if n_triangles > MOST_TRIANGLES {
        let message = format!(
            "expected at most {MOST_TRIANGLES} triangles to be joined, found {n_triangles}; a larger tolerance takes fewer"
        );
        let error = Error::new(Code::TooLarge, "tolerance", message).with("greatest", MOST_TRIANGLES);
        return Err(error.with("found", n_triangles));
    }
    let largest = bodies.iter().flat_map(|body| body.positions).fold(0.0f32, |most, x| most.max(x.abs()));
    let usual = || DEFAULT_FINENESS * bodies.iter().map(|body| size(body.positions)).fold(0.0, f64::max);
    let most_moved = MOST_MOVED * tolerance.unwrap_or_else(usual);
    // Of bodies as they are, whether their triangles cross or not.
    let mut kinds: Vec<Kind> = Vec::new();
    // Corners or edges that are there twice may be where bodies touch in no more than that. What hangs together only when it is wider does.
    let mut is_double = false;
    let mut is_pinched = None;
    for (index, Attempt { near, wider, turn }) in ATTEMPTS.into_iter().enumerate() {
        watch::go_on()?;
        let is_wider = wider > 0.0;
        let Swollen { positions, moved } = swollen(bodies, wider * f64::from(largest));
        if is_wider && (moved > most_moved || kinds.is_empty() || is_pinched == Some(true)) {
            continue;
        }
        let turn = Turn::number(turn, f64::from(largest));
        let found = watch::share(index, ATTEMPTS.len(), || united(bodies, &positions, near, turn))?;
        let Some((solid, n_double)) = found else { continue };
        let Some(soup) = Soup::of(&solid, bodies) else { continue };
        if !is_wider {
            let kind = Kind::of(&soup.points, &soup.triangles);
            is_double |= kind.is_none() || bodies.len() == 2 && index == 0 && n_double > 0;
            kinds.extend(kind);
        }
        let is_right = |union: &Union| is_wider || is_volume_of(&union.points, &union.triangles, bodies);
        let Some(union) = sound(&soup, is_right) else { continue };
        // Corners that were drawn together as a matter of course are in one place in the numbers of a file.
        let drawn = if index > 0 { near * f64::from(largest) } else { 0.0 };
        let moved = moved + drawn + union.moved;
        if !is_wider {
            return Ok(Union { moved, ..union });
        }
        let alike: Vec<&Kind> = kinds.iter().filter(|kind| kind.topology == union.topology).collect();
        is_pinched = Some(alike.is_empty());
        let own = Kind::of(&union.points, &union.triangles);
        if moved <= most_moved && own.is_some_and(|own| alike.iter().any(|kind| own.is_about_as_large_as(kind))) {
            return Ok(Union { moved, ..union });
        }
    }
    let names: Vec<&str> = bodies.iter().map(|body| body.name).take(MOST_NAMES).collect();
    let names = names.join(", ");
    let refused = |message: String| Error::new(Code::CrossesItself, "union", message);
    if is_pinched.unwrap_or(is_double) {
        let message = format!(
            "these parts cannot be joined into one solid, which would be pinched where they touch along an edge or at a point alone: {names}; expected parts that meet in a face or run into each other, or to be written as they are"
        );
        return Err(refused(message).with("what", "pinched-joint"));
    }
    let message = format!(
        "these parts cannot be joined into one solid, because numbers of seven digits do not tell their surfaces apart where they meet: {names}; expected parts that run into each other, or to be written as they are"
    );
    Err(refused(message).with("what", "not-joined"))
}

impl Soup {
    fn of(union: &Manifold, bodies: &[&Labelled]) -> Option<Soup> {
        let most = bodies.iter().flat_map(|body| &body.labels).copied().max()?;
        let corner = |half: usize| union.hs.get(half).map(|half| half.tail as u32);
        let (mut triangles, mut labels) = (Vec::new(), Vec::new());
        for triangle in 0..union.hs.len() / 3 {
            let [a, b, c] =
                [0, 1, 2].map(|k| corner(3 * triangle + k).filter(|vertex| (*vertex as usize) < union.ps.len()));
            let label = union.vals.get(3 * triangle).map(|label| libm::round(*label))?;
            if !(0.0..=f64::from(most)).contains(&label) {
                return None;
            }
            triangles.push([a?, b?, c?]);
            labels.push(label as u32);
        }
        let points = union.ps.iter().map(|point| point.to_array().map(|x| x as f32)).collect();
        Some(Soup { points, triangles, labels })
    }
}

/// What is written of a union, if it passes what every body has to as it is, or without triangles that are too narrow, or mended where it crosses itself.
fn sound(Soup { points, triangles, labels }: &Soup, is_right: impl Fn(&Union) -> bool) -> Option<Union> {
    written(points, triangles, labels).filter(&is_right).or_else(|| {
        let mut net = Net::of(points, triangles, labels);
        let mended = |net: &Net| {
            let (triangles, labels) = net.kept().into_iter().map(|of| net.labelled(of)).unzip::<_, _, Vec<_>, Vec<_>>();
            written(points, &triangles, &labels).filter(&is_right).map(|union| Union { moved: net.moved(), ..union })
        };
        let widened = net.widen().then(|| mended(&net)).flatten();
        widened.or_else(|| net.uncross().then(|| mended(&net)).flatten())
    })
}

/// Triangles in the order of their labels, and points in the order in which they come then, if they pass.
fn written(points: &[[f32; 3]], triangles: &[[u32; 3]], labels: &[u32]) -> Option<Union> {
    let mut order: Vec<usize> = (0..triangles.len()).collect();
    order.sort_by_key(|number| labels[*number]);
    let mut number = vec![u32::MAX; points.len()];
    let (mut kept, mut renumbered): (Vec<[f32; 3]>, Vec<[u32; 3]>) = (Vec::new(), Vec::with_capacity(triangles.len()));
    for triangle in &order {
        renumbered.push(triangles[*triangle].map(|vertex| {
            let number = &mut number[vertex as usize];
            if *number == u32::MAX {
                *number = kept.len() as u32;
                kept.push(points[vertex as usize]);
            }
            *number
        }));
    }
    let topology = passes(&kept, &renumbered)?;
    let labels = order.into_iter().map(|triangle| labels[triangle]).collect();
    Some(Union { points: kept, triangles: renumbered, labels, topology, moved: 0.0 })
}

/// Closed, without triangles that cross or have no area, on the very numbers of the file.
fn passes(points: &[[f32; 3]], triangles: &[[u32; 3]]) -> Option<Topology> {
    let at = |triangle: &[u32; 3]| triangle.map(|vertex| points[vertex as usize]);
    let is_plain = !triangles.is_empty()
        && points.iter().flatten().all(|x| x.is_finite())
        && !triangles.iter().any(|triangle| check::is_degenerate(at(triangle)));
    let topology = is_plain.then(|| check::closed(triangles, points.len()).ok()).flatten()?;
    (check::crossings_soon(points, triangles, |_| None, 1) == (Vec::new(), None)).then_some(topology)
}

/// Whether a union is no less than the largest of its bodies, and no more than all of them.
fn is_volume_of(points: &[[f32; 3]], triangles: &[[u32; 3]], bodies: &[&Labelled]) -> bool {
    let (origin, own) = (origin(points), volume_within(points, triangles));
    let volumes = bodies.iter().map(|body| {
        let point = |vertex: u32| [0, 1, 2].map(|axis| f64::from(body.positions[3 * vertex as usize + axis]));
        volume(body.indices.chunks_exact(3).map(|t| [point(t[0]), point(t[1]), point(t[2])]), origin)
    });
    let (most, all) = volumes.fold((0.0f64, 0.0), |(most, all), volume| (most.max(volume), all + volume));
    (most - SLACK * all..=all + SLACK * all).contains(&own)
}

/// The longest side of the box round points.
fn size(positions: &[f32]) -> f64 {
    let [low, high] = bounds(positions);
    (high - low).max_element()
}

/// Volumes are summed up from there.
fn origin(points: &[[f32; 3]]) -> [f64; 3] {
    points.first().map_or([0.0; 3], |point| point.map(f64::from))
}

/// Six times the volume within triangles of these points.
fn volume_within(points: &[[f32; 3]], triangles: &[[u32; 3]]) -> f64 {
    volume(triangles.iter().map(|t| t.map(|vertex| points[vertex as usize].map(f64::from))), origin(points))
}

/// Six times the volume within triangles.
fn volume(triangles: impl Iterator<Item = [[f64; 3]; 3]>, origin: [f64; 3]) -> f64 {
    let six = triangles.map(|triangle| {
        let [a, b, c] = triangle.map(|p| [p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]]);
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    });
    six.sum()
}
