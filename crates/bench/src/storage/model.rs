//! A network of the gallery.

use pasu::{Design, Result, Solution};
use serde_json::{Value, json};

use super::point::{Point, minus, plus};

/// A network as it stands in the gallery.
pub(super) struct Model {
    pub(super) name: String,
    pub(super) vertices: Vec<Point>,
    pub(super) frames: Vec<[usize; 8]>,
    shape: Value,
    solved: Solution,
    /// The same without what sculpts it.
    plain: Solution,
    hills: Vec<Hill>,
    /// By how much a hill of the ground truth is fuller than one of sines, in parts of what is missing up to the crest; less than 0 where it is sharper.
    pub(super) fuller: f64,
}

/// What one force adds.
struct Hill {
    /// The network with this force alone.
    solved: Solution,
    /// On its crest.
    height: Point,
    /// For each patch, whether anything of it lies there.
    is_on: Vec<bool>,
}

/// Parts of a patch along either side in which a hill is looked for.
const LOOKED: usize = 16;

impl Model {
    /// All models of a file: a list of `{ id, shape }`.
    ///
    /// # Errors
    /// When one is no design.
    pub(super) fn all(text: &str) -> Result<Vec<Model>> {
        let list: Vec<Value> = serde_json::from_str(text).unwrap_or_default();
        list.iter().map(|entry| Model::of(entry["id"].as_str().unwrap_or_default(), &entry["shape"])).collect()
    }

    pub(super) fn of(name: &str, shape: &Value) -> Result<Model> {
        let plain = with_forces(shape, |_, _| false);
        let patches = shape["patches"].as_array().map(Vec::as_slice).unwrap_or_default();
        let mut model = Model {
            name: name.to_owned(),
            vertices: serde_json::from_value(shape["vertices"].clone()).unwrap_or_default(),
            frames: patches.iter().filter_map(|patch| serde_json::from_value(patch["frame"].clone()).ok()).collect(),
            solved: solution(shape)?,
            plain: solution(&plain)?,
            shape: shape.clone(),
            hills: Vec::new(),
            fuller: 0.0,
        };
        for (number, patch) in patches.iter().enumerate() {
            for (place, force) in patch["forces"].as_array().into_iter().flatten().enumerate() {
                let hill = Hill {
                    solved: solution(&with_forces(shape, |patch, force| (patch, force) == (number, place)))?,
                    height: core::array::from_fn(|k| {
                        let parameter = |name: &str| patch[name][k].as_f64().unwrap_or(1.0);
                        let by = std::f64::consts::PI.powi(2) * (parameter("a1") + parameter("a2"));
                        -force["f0"][k].as_f64().unwrap_or_default() / by
                    }),
                    is_on: Vec::new(),
                };
                model.hills.push(hill);
            }
        }
        let cells: Vec<[f64; 2]> =
            (0..LOOKED * LOOKED).map(|k| [k / LOOKED, k % LOOKED].map(|i| (i as f64 + 0.5) / LOOKED as f64)).collect();
        for number in 0..model.hills.len() {
            for patch in 0..model.frames.len() {
                let shares = model.shares(&model.hills[number], patch, &cells)?;
                model.hills[number].is_on.push(shares.iter().any(|share| *share != 0.0));
            }
        }
        Ok(model)
    }

    /// Whether forces sculpt it.
    pub(super) fn is_sculpted(&self) -> bool {
        !self.hills.is_empty()
    }

    /// The points that a frame goes through.
    pub(super) fn used_points(&self) -> Vec<Point> {
        let mut used = vec![false; self.vertices.len()];
        self.frames.iter().flatten().for_each(|vertex| used[*vertex] = true);
        self.vertices.iter().zip(used).filter_map(|(at, is_used)| is_used.then_some(*at)).collect()
    }

    /// The numbers beside the points: shape control parameters that are given, and forces with the rectangles that are.
    pub(super) fn parameters(&self) -> Vec<f64> {
        fn numbers(value: &Value, into: &mut Vec<f64>) {
            match value {
                Value::Number(number) => into.extend(number.as_f64()),
                Value::Array(list) => list.iter().for_each(|value| numbers(value, into)),
                Value::Object(fields) => fields.values().for_each(|value| numbers(value, into)),
                _ => {}
            }
        }
        let mut found = Vec::new();
        for patch in self.shape["patches"].as_array().into_iter().flatten() {
            ["a1", "a2", "forces"].iter().for_each(|field| numbers(&patch[*field], &mut found));
        }
        found
    }

    /// Points of a patch.
    ///
    /// # Errors
    /// When there is no such point.
    pub(super) fn points(&self, patch: usize, at: &[[f64; 2]]) -> Result<Vec<Point>> {
        evaluated(&self.solved, patch, at)
    }

    /// What sculpts the ground truth there: hills of the same crests, rims and level lines as those of the forces, but fuller or sharper.
    ///
    /// # Errors
    /// As [`Model::points`].
    pub(super) fn sculpted(&self, patch: usize, at: &[[f64; 2]]) -> Result<Vec<Point>> {
        let mut sculpted = vec![[0.0; 3]; at.len()];
        for hill in self.hills.iter().filter(|hill| hill.is_on[patch]) {
            for (sculpted, share) in sculpted.iter_mut().zip(self.shares(hill, patch, at)?) {
                *sculpted = plus(*sculpted, hill.height, share * (1.0 + self.fuller * (1.0 - share)));
            }
        }
        Ok(sculpted)
    }

    /// What a force adds, in parts of what it adds on its crest.
    fn shares(&self, hill: &Hill, patch: usize, at: &[[f64; 2]]) -> Result<Vec<f64>> {
        let axis = (0..3).fold(0, |most, k| if hill.height[k].abs() > hill.height[most].abs() { k } else { most });
        let (with, without) = (evaluated(&hill.solved, patch, at)?, evaluated(&self.plain, patch, at)?);
        Ok(with.iter().zip(without).map(|(with, without)| minus(*with, without)[axis] / hill.height[axis]).collect())
    }
}

/// The shape with those forces alone that are told by the number of their patch and their own.
fn with_forces(shape: &Value, is_kept: impl Fn(usize, usize) -> bool) -> Value {
    let mut shape = shape.clone();
    for (number, patch) in shape["patches"].as_array_mut().into_iter().flatten().enumerate() {
        let mut place = 0..;
        if let Some(forces) = patch.get_mut("forces").and_then(Value::as_array_mut) {
            forces.retain(|_| place.next().is_some_and(|place| is_kept(number, place)));
        }
    }
    shape
}

fn solution(shape: &Value) -> Result<Solution> {
    Ok(Solution::of(&Design::parse(&json!({ "pasu": 1, "parts": [{ "shape": shape }] }).to_string())?))
}

fn evaluated(solution: &Solution, patch: usize, at: &[[f64; 2]]) -> Result<Vec<Point>> {
    let triples: Vec<f64> = at.iter().flat_map(|[u, v]| [patch as f64, *u, *v]).collect();
    Ok(solution.evaluate(0, &triples)?.as_chunks::<3>().0.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hills_of_the_truth_have_the_crests_and_rims_of_their_forces() {
        let mut models = Model::all(super::super::MODELS).unwrap();
        let leaf = models.iter_mut().find(|model| model.name == "own-leaf-pushed").unwrap();
        leaf.fuller = 0.3;
        let at = [[0.5, 0.5], [0.0, 0.3], [0.5, 1.0], [0.5, 1.0 / 6.0]];
        let [crest, rim, other, half] = leaf.sculpted(0, &at).unwrap().try_into().unwrap();
        // The force is -78.9568, eight times the square of pi, and a1 + a2 is 2.
        assert!((crest[2] - 4.0).abs() < 1e-5 && rim[2].abs() < 1e-9 && other[2].abs() < 1e-9, "{crest:?} {rim:?}");
        // A sine is one half there, and the hill 0.3 of a quarter more.
        assert!((half[2] - 4.0 * (0.5 + 0.3 * 0.25)).abs() < 1e-5, "{half:?}");
        assert_eq!(leaf.parameters(), [0.0, 0.0, -78.9568]);
        assert_eq!(leaf.used_points().len(), 8);
    }
}
