//! Random pots in random attitudes, flooded from above: what stays in the triangles of `solid`, column by column of a fine grid, is what `measure` says they hold.
//!
//! What its time buys: a judge of capacities that knows nothing of levels and brims, on pots and attitudes that nobody has thought of.
//!
//! `FLOODS=2000 cargo test -p pasu --release --test library flood` floods as many.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::PI;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::support::design;
use crate::support::random::{Random, drawn};
use glam::DVec3;
use pasu::{
    Code, Design, Face, FaceKind, Making, MeasureOptions, Pot, Product, Size, SolidMesh, Solution, measure, solid,
};
use serde_json::{Value, json};

/// How many pots are flooded when nobody says otherwise.
const FLOODS: u64 = 40;

/// Every so many are measured as a whole.
const EVERY: u64 = 10;

/// Lines of the grid along the longer side of a pot; and of the one that is asked where that one says something else: rings that were fitted may be thinner than the first.
const LINES: [f64; 2] = [90.0, 360.0];

/// Models are in centimetres, meshes in millimetres.
const MILLIMETRES: f64 = 10.0;

/// The air along one upright line: from what it stands on to what is above it.
#[derive(Clone, Copy)]
struct Air {
    floor: f64,
    ceiling: f64,
}

/// Upright lines through a closed mesh at even places.
struct Lines {
    cell: f64,
    n: [usize; 2],
    /// The air of each line, from below; the first has no floor and the last no ceiling.
    air: Vec<Vec<Air>>,
}

impl Lines {
    fn new(mesh: &SolidMesh, lines: f64) -> Lines {
        let points: Vec<DVec3> = mesh
            .positions
            .chunks_exact(3)
            .map(|p| DVec3::new(f64::from(p[0]), f64::from(p[1]), f64::from(p[2])) / MILLIMETRES)
            .collect();
        let (low, high) =
            points.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)));
        let size = high - low;
        let cell = size.x.max(size.y) / lines;
        // Off the round, so that no line passes through a corner.
        let origin = low - DVec3::splat(1.37 * cell);
        let n = [size.x, size.y].map(|extent| (extent / cell) as usize + 4);
        let mut crossings: Vec<Vec<f64>> = vec![Vec::new(); n[0] * n[1]];
        for corners in mesh.indices.chunks_exact(3) {
            let [p, q, r] = [0, 1, 2].map(|k| points[corners[k] as usize] - origin);
            let (from, to) = (p.min(q).min(r) / cell, p.max(q).max(r) / cell);
            for i in from.x.ceil() as usize..=to.x.floor() as usize {
                for j in from.y.ceil() as usize..=to.y.floor() as usize {
                    let at = DVec3::new(i as f64, j as f64, 0.0) * cell;
                    // The same number for both triangles at an edge, and never 0: a line through it meets one of them.
                    let side = |a: DVec3, b: DVec3| {
                        let is_turned = (b.x, b.y) < (a.x, a.y);
                        let (a, b) = if is_turned { (b, a) } else { (a, b) };
                        let side = (b - a).truncate().perp_dot((at - a).truncate());
                        let side = if side == 0.0 { f64::MIN_POSITIVE } else { side };
                        if is_turned { -side } else { side }
                    };
                    let sides = [side(q, r), side(r, p), side(p, q)];
                    let sum: f64 = sides.iter().sum();
                    if sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0) {
                        let z = (sides[0] * p.z + sides[1] * q.z + sides[2] * r.z) / sum;
                        crossings[i * n[1] + j].push(z + origin.z);
                    }
                }
            }
        }
        let air = crossings
            .into_iter()
            .map(|mut crossings| {
                crossings.sort_by(f64::total_cmp);
                let mut ends = vec![f64::NEG_INFINITY];
                ends.extend(crossings);
                ends.push(f64::INFINITY);
                ends.chunks_exact(2).map(|ends| Air { floor: ends[0], ceiling: ends[1] }).collect()
            })
            .collect();
        Lines { cell, n, air }
    }

    /// What stays when everything has been under water: each air is filled to the lowest level over which it is connected with the outside, whose air has no floor.
    fn held(&self) -> f64 {
        let [n, m] = self.n;
        let mut first = vec![0];
        for air in &self.air {
            first.push(first[first.len() - 1] + air.len());
        }
        let mut levels = vec![f64::INFINITY; first[n * m]];
        // The lowest first. Finite numbers of one sign keep their order as bits; heights are made positive.
        let lift = 1e6;
        let key = |z: f64| (z.max(-0.5 * lift) + lift).to_bits();
        let mut queue = BinaryHeap::new();
        for (line, first) in first.iter().enumerate().take(n * m) {
            levels[*first] = f64::NEG_INFINITY;
            queue.push(Reverse((key(f64::NEG_INFINITY), line, 0usize)));
        }
        let mut is_done = vec![false; levels.len()];
        while let Some(Reverse((_, line, index))) = queue.pop() {
            if std::mem::replace(&mut is_done[first[line] + index], true) {
                continue;
            }
            let (here, level) = (self.air[line][index], levels[first[line] + index]);
            let (i, j) = (line / m, line % m);
            let around = [
                (i > 0).then(|| line - m),
                (i + 1 < n).then_some(line + m),
                (j > 0).then(|| line - 1),
                (j + 1 < m).then_some(line + 1),
            ];
            for other in around.into_iter().flatten() {
                for (k, there) in self.air[other].iter().enumerate() {
                    if there.floor < here.ceiling && here.floor < there.ceiling {
                        let over = level.max(here.floor).max(there.floor);
                        if over < levels[first[other] + k] {
                            levels[first[other] + k] = over;
                            queue.push(Reverse((key(over), other, k)));
                        }
                    }
                }
            }
        }
        let mut sum = 0.0;
        for (line, air) in self.air.iter().enumerate() {
            for (k, air) in air.iter().enumerate().filter(|(_, air)| air.floor.is_finite()) {
                let level = levels[first[line] + k];
                // In a narrow corner of the air one line may have no other beside it.
                if !level.is_finite() {
                    continue;
                }
                sum += (level.min(air.ceiling) - air.floor).max(0.0);
            }
        }
        sum * self.cell * self.cell
    }
}

/// A random pot without a drain, turned any way: its document. One in so many is a tube.
fn turned(seed: u64) -> String {
    let mut random = Random::new(seed);
    let mut document: Value = serde_json::from_str(&random.design()).unwrap();
    let part = &mut document["parts"][0];
    part["wall"].as_object_mut().unwrap().remove("drain");
    let angle = match random.whole(0, 5) {
        0 => 0.0,
        1 => PI,
        2 => random.between(0.0, 0.6),
        _ => random.between(0.0, PI),
    };
    let [x, y] = [0; 2].map(|_| random.between(-1.0, 1.0));
    part["place"] = json!({ "axis": [x, y, 0.001], "angle": angle, "shift": [x, y, 0.3] });
    document.to_string()
}

/// One pot: what is held by lines and by what pots are scaled by, and the difference that the grid accounts for; `None` for a pot that cannot be made or is too thin for the grid.
fn flooded(json: &str) -> Option<(f64, f64, f64)> {
    let design = design(json);
    let tolerance = 0.04;
    let meshes =
        solid(&design, &Making { product: Product::Pot, tolerance: Some(tolerance), ..Making::default() }).ok()?;
    let coarse = Lines::new(&meshes[0], LINES[0]);
    // A step from one line to the next must not pass through a wall.
    if Pot::new(&design, 0, Product::Pot).unwrap().thickness().0 < 1.2 * coarse.cell {
        return None;
    }
    let found = match (Making { size: Some(Size::Capacity(1.0)), ..Making::default() }).scale(&design) {
        Ok(scale) => 1.0 / scale.size.powi(3),
        Err(error) => {
            assert_eq!((error.code(), error.path()), (Code::NoRoom, "size.capacity"), "{error}\n{json}");
            0.0
        }
    };
    let compared = |lines: &Lines| {
        let [width, depth] = lines.n.map(|n| lines.cell * n as f64);
        // The lines meet a crest beside its top, and a wide water is off by as much all over; the triangles of the outside and of the lining are off by the tolerance.
        let off = width * depth * (tolerance + 0.2 * lines.cell) + 0.01 * found;
        (lines.held(), found, off)
    };
    let (held, found, off) = compared(&coarse);
    let agrees = (held - found).abs() <= off;
    Some(if agrees { (held, found, off) } else { compared(&Lines::new(&meshes[0], LINES[1])) })
}

#[test]
fn a_flood_leaves_what_is_measured() {
    let floods = std::env::var("FLOODS").ok().and_then(|count| count.parse().ok()).unwrap_or(FLOODS);
    let next = AtomicU64::new(1);
    let n_flooded = AtomicU64::new(0);
    let wrong: Mutex<Vec<String>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed > floods {
                        break;
                    }
                    let json = turned(seed);
                    let Some((held, found, off)) = flooded(&json) else { continue };
                    n_flooded.fetch_add(1, Ordering::Relaxed);
                    let told = || format!("seed {seed}: {held} flooded, {found} measured, {off} expected\n{json}");
                    if !((held - found).abs() <= off) {
                        wrong.lock().unwrap().push(told());
                    }
                    // Which is what `measure` says.
                    if seed.is_multiple_of(EVERY) {
                        let capacity = measure(&design(&json), &MeasureOptions::default()).unwrap().whole.capacity;
                        let brim = capacity.map_or(0.0, |capacity| capacity.brim.value);
                        assert!((brim - found).abs() <= 1e-9 * brim, "{brim}, {}", told());
                    }
                }
            });
        }
    });
    let (wrong, n_flooded) = (wrong.into_inner().unwrap(), n_flooded.into_inner());
    println!("{n_flooded} of {floods} were flooded");
    assert!(wrong.is_empty(), "{} of {n_flooded} are wrong:\n{}", wrong.len(), wrong.join("\n"));
    assert!(2 * n_flooded > floods, "only {n_flooded}");
}

/// Upside down, tilted by 95 degrees, and with a rim that turns in and down below a funnel.
#[test]
fn attitudes_that_were_measured_wrongly() {
    for link in [
        "#1~eNo9jtEOgjAMRf-lz4WswFT2K4aHCdMRJpBtBCPZv9sZ41PPbXvbe8CqwwaKkMHHAOp6QLB6NaAOmMZ5AAX3ZfPRFosfjAcEL0A1XAhUzeUJSiJYVlQhmKj5higlirLpEIY3Sx5QxSKfJySm-Kf9R4kTON1__-rXmFcFEgpe0fPDcb-oS2pIttVJ1vLSntuaPbt2LluiHftpNoF9ouRYNx1MxialLn0AQ4pAQQ",
        "#1~eNo9jtEOgjAMRf-lz3XZEBD2K4aHCtMRJpBtBCPZv9sZ41PPbW_be8BKYQOtkMHHAPp6QLC0GtAHTOM8gIb7svloT4sfjAcEL0GXXBToM5cn6ArBslIFgonEN6SoUIqyQxjeLHmgChb5vELFFP-0_yhxAkf99y-9xmyVqFCyheaH474SddXIurg07bll-07OZXe0Yz_NJvCKFJzoRsFkLFPq0gcdpj9E",
        "#1~eNqVj9EOwiAMRf-lz2hQF7PwK8YYNkhGNoFQ5pzL_t0WHzS-7QXK7e25ZYGocQR1EFSkjKAuC2CnowW1QO-8AQVNGL3Rad499DBaEIBRe9KP0dHjyc6QjE2gKuoVWAYlBUzlvAdjP2Bfem1AHsFMgaBOAiyn0F2UG29TFZHLXb2u11XAvDUFnd-e8tqUIv__Uv_S5Zd-ZjrhJz0MbM-da3tvkWblnlZqNFouK_a9Afw5eF4",
    ] {
        let (held, found, off) = flooded(link).expect("a pot that can be made");
        assert!((held - found).abs() <= off, "{held} flooded, {found} measured, {off} expected: {link}");
    }
}

/// Of the columns of a pot that stands, from the floor to the crest, water runs out over the lowest at the latest; `None` where it holds none, and lies or has no floor.
fn runs_out(name: &str, design: &Design) -> Option<()> {
    const PLACES: (usize, usize) = (200, 900);
    let solution = Solution::of(design);
    let pot = solution.pot(0, Product::Pot).ok()?;
    let found = solution.measure(&MeasureOptions::default()).expect("measures").parts.swap_remove(0).body;
    let spill = found.capacity?.spill.level;
    let is_there = |kind| pot.faces().iter().any(|face| face.kind() == kind);
    if !(is_there(FaceKind::Floor) && is_there(FaceKind::Rim)) {
        return None;
    }
    let mut crests = vec![f64::MIN; PLACES.1];
    for face in pot.faces().iter().filter(|face| matches!(face.kind(), FaceKind::Lining | FaceKind::Rim)) {
        let mut walk = face.walk();
        for a in (0..=PLACES.0).map(|i| i as f64 / PLACES.0 as f64) {
            for (j, crest) in crests.iter_mut().enumerate() {
                *crest = crest.max(walk.jet(a, 2.0 * PI * j as f64 / PLACES.1 as f64).position.z);
            }
        }
    }
    let lowest = crests.into_iter().fold(f64::MAX, f64::min);
    // Between the places of a column its crest is a little higher.
    assert!(spill.value <= lowest + spill.error + 1e-5 * found.height.value, "{name}: {spill:?}, {lowest}");
    Some(())
}

/// Of five waves of a rim the lowest lies between two columns of the grid, and that at whose lowest place there is a column is two thousandths higher.
#[test]
fn water_runs_out_over_the_lowest_of_the_waves_of_a_rim() {
    let waves = design(
        r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "bloor-wilson", "a": 0.0363, "r": [4.2064, -0.46354528000000006, 0.1514304, 3.9653], "R": [0.7621, 0.38105, 0.38105, -2.6506], "h": [13.3541, 0.4254], "H": [-17.10927292, -0.938], "n1": 5 },
        "wall": { "thickness": 0.2652, "base": 0.7592, "drain": 1.2762, "rim": "rounded" } }] }"#,
    );
    let capacity = measure(&waves, &MeasureOptions::default()).unwrap().whole.capacity.unwrap();
    assert!((capacity.spill.level.value - 13.049_120_5).abs() < 1e-6, "{capacity:?}");
    runs_out("waves", &waves).expect("a pot that stands");
    let n = drawn(20, 100);
    let pots = (7000..7000 + n).filter_map(|seed| {
        let mut pot: Value = serde_json::from_str(&Random::new(seed).design()).unwrap();
        // Tilted less than those that are flooded: they stand.
        if let Some(angle) = pot["parts"][0]["place"].get_mut("angle") {
            *angle = json!(0.2 * angle.as_f64().unwrap());
        }
        runs_out(&format!("seed {seed}"), &design(&pot.to_string()))
    });
    let n_held = pots.count() as u64;
    assert!(2 * n_held > n, "only {n_held} of {n} hold water");
}

/// A pot that lies with its mouth a little down: the lowest point of its inside is that of the rim, below which there is no clay. The recess of its foot, which opens upwards as little, keeps a puddle: a hoof 0.0144 deep.
#[test]
fn beneath_a_rim_no_water_stands() {
    let json = r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "fourth-order", "r0": 2.7989, "r1": 3.8084, "rm": 3.0032, "h1": 7.0725, "eta": [0.9597, -0.5985],
        "dz": [12.4207245, 13.0515915], "s": [1, 1], "t": [2.3738, 2.3738], "w": [0.9392, 0.9392] },
        "wall": { "thickness": 0.384, "base": 0.4148, "foot": [0.408, 0.4715], "rim": "rounded" }, "place": { "axis": [0.9214, 0.3876, 0.001], "angle": 1.6013 } }] }"#;
    let capacity = measure(&design(json), &MeasureOptions::default()).unwrap().whole.capacity.expect("a puddle");
    let (slope, long, radius) = (1.6013f64 - PI / 2.0, 0.4715, 2.7989f64 - 0.408);
    let deep = long * slope.sin();
    // Of a segment of a circle that is no higher than that the area is four thirds of its height and its half chord.
    let puddle = 4.0 / 3.0 * (2.0 * radius).sqrt() * deep.powf(1.5) * 0.4 * long;
    assert!((capacity.brim.value - puddle).abs() < 0.01 * puddle, "{capacity:?} {puddle}");
    assert!((capacity.spill.level.value - capacity.floor - deep).abs() < 0.01 * deep, "{capacity:?} {deep}");
    let (held, found, off) = flooded(json).expect("a pot that can be made");
    assert!(
        (found - puddle).abs() < 0.01 * puddle && held > 0.0 && (held - found).abs() <= off,
        "{held} flooded, {found} measured, {off} expected"
    );
}

/// A tube with a belly holds nothing where it stands; where it lies, water stands in the belly up to the lower of its two ends.
#[test]
fn a_tube_that_lies_holds_water_in_its_belly() {
    let tube = |place: Value| {
        let part = json!({
            "shape": { "kind": "fourth-order", "r0": 2, "r1": 2.2, "rm": 4, "h1": 8, "eta": [1, -1], "dz": [8, 8], "s": [1, 1], "t": [0, 0], "w": [0, 0] },
            "wall": { "thickness": 0.4, "base": 0 }, "place": place,
        });
        json!({ "pasu": 1, "parts": [part] }).to_string()
    };
    let capacity = |json: &str| measure(&design(json), &MeasureOptions::default()).unwrap().whole.capacity;
    assert!(capacity(&tube(json!({}))).is_none());
    for (angle, least) in [(PI / 2.0, 10.0), (1.4, 1.0), (PI / 2.0 + 0.1, 1.0)] {
        let lying = tube(json!({ "axis": [1, 0, 0], "angle": angle, "shift": [1, 2, 3] }));
        let brim = capacity(&lying).expect("water in the belly").brim;
        let (held, found, off) = flooded(&lying).expect("a tube that can be made");
        assert!(
            found > least && (held - found).abs() <= off,
            "{angle}: {held} flooded, {found} measured, {off} expected"
        );
        assert!((brim.value - found).abs() <= 1e-9 * found && brim.error < 1e-6 * found, "{angle}: {brim:?}");
    }
}
