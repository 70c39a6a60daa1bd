//! What a runner measured: groups of contenders that took turns, and the ratios between them.

use anyhow::{Context, Result, bail};
use serde_json::{Value, json};

/// By how much a target may be missed before `--check` fails: other programs run on the same machine.
pub(crate) const LEEWAY: f64 = 0.15;

/// Contenders that took turns within one run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Group {
    pub(crate) runner: String,
    pub(crate) name: String,
    /// What the samples are: `ns per vertex`, `us`, `ms`.
    pub(crate) unit: String,
    /// Whether it is the slow turns that matter: the 95th of a hundred is shown in place of the slowest.
    pub(crate) tail: bool,
    pub(crate) rows: Vec<Row>,
}

/// One contender.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    pub(crate) name: String,
    /// One number for each turn.
    samples: Vec<f64>,
    pub(crate) ratio: Option<Ratio>,
    /// The target for the row's own median.
    pub(crate) median_at_most: Option<f64>,
    /// Something to say beside the numbers.
    pub(crate) note: Option<String>,
}

/// How many times longer than another contender.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ratio {
    pub(crate) against: String,
    /// The median over the turns of the ratio within a turn.
    pub(crate) value: f64,
    pub(crate) target: Option<Target>,
}

/// A bound on a ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Target {
    AtLeast(f64),
    AtMost(f64),
}

/// How a figure stands beside its target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verdict {
    Met,
    /// Missed, but within the leeway.
    Near,
    Missed,
}

impl Target {
    pub(crate) fn verdict(self, value: f64) -> Verdict {
        // How many times better than the target; written so that NaN misses.
        let margin = match self {
            Target::AtLeast(least) => value / least,
            Target::AtMost(most) => most / value,
        };
        if margin >= 1.0 {
            Verdict::Met
        } else if margin >= 1.0 - LEEWAY {
            Verdict::Near
        } else {
            Verdict::Missed
        }
    }
}

impl Group {
    /// Reads a line of a runner:
    ///
    /// ```json
    /// { "runner": "Node", "group": "..", "unit": "ms", "tail": false, "rows": [ { "name": "..", "samples": [..],
    ///   "against": "name of another row", "at_least": 3, "at_most": 5, "median_at_most": 50, "note": ".." } ] }
    /// ```
    pub(crate) fn read(line: &str) -> Result<Group> {
        let value: Value = serde_json::from_str(line).context("a runner's line is not JSON")?;
        let text = |key: &str| value[key].as_str().map(str::to_owned).with_context(|| format!("a group has no {key}"));
        let given = value["rows"].as_array().context("a group has no rows")?;
        let mut rows: Vec<Row> = given.iter().map(Row::read).collect::<Result<_>>()?;
        for (index, given) in given.iter().enumerate() {
            if let Some(against) = given["against"].as_str() {
                let other = rows
                    .iter()
                    .find(|row| row.name == against)
                    .with_context(|| format!("there is no row {against} to compare with"))?;
                let value = paired(&rows[index].samples, &other.samples)?;
                let bound = |key: &str| given[key].as_f64();
                let target = bound("at_least").map(Target::AtLeast).or(bound("at_most").map(Target::AtMost));
                rows[index].ratio = Some(Ratio { against: against.to_owned(), value, target });
            }
        }
        let tail = value["tail"] == true;
        Ok(Group { runner: text("runner")?, name: text("group")?, unit: text("unit")?, tail, rows })
    }

    /// Each target of the group that is missed beyond the leeway, in words.
    pub(crate) fn missed(&self) -> Vec<String> {
        let said = |row: &Row| {
            row.targets()
                .filter(|(value, target)| target.verdict(*value) == Verdict::Missed)
                .map(|(value, target)| {
                    let (bound, least) = match target {
                        Target::AtLeast(bound) => (bound, "at least"),
                        Target::AtMost(bound) => (bound, "at most"),
                    };
                    format!("{}, {}, {}: {value:.3}, {least} {bound} is asked for", self.runner, self.name, row.name)
                })
                .collect::<Vec<_>>()
        };
        self.rows.iter().flat_map(said).collect()
    }

    /// The group with its samples and what follows from them.
    pub(crate) fn to_json(&self) -> Value {
        let rows: Vec<Value> = self.rows.iter().map(Row::to_json).collect();
        json!({ "runner": self.runner, "group": self.name, "unit": self.unit, "rows": rows })
    }
}

impl Row {
    fn read(value: &Value) -> Result<Row> {
        let name = value["name"].as_str().context("a row has no name")?.to_owned();
        let given = value["samples"].as_array().into_iter().flatten();
        // JavaScript writes what is not a number as null.
        let samples: Option<Vec<f64>> = given.map(Value::as_f64).collect();
        let samples = samples.with_context(|| format!("{name} has a sample that is not a number"))?;
        if samples.is_empty() {
            bail!("{name} has no samples");
        }
        let note = value["note"].as_str().map(str::to_owned);
        Ok(Row { name, samples, ratio: None, median_at_most: value["median_at_most"].as_f64(), note })
    }

    pub(crate) fn median(&self) -> f64 {
        quantile(&self.samples, 0.5)
    }

    pub(crate) fn min(&self) -> f64 {
        quantile(&self.samples, 0.0)
    }

    pub(crate) fn max(&self) -> f64 {
        quantile(&self.samples, 1.0)
    }

    pub(crate) fn p95(&self) -> f64 {
        quantile(&self.samples, 0.95)
    }

    /// Every figure of the row that has a target.
    pub(crate) fn targets(&self) -> impl Iterator<Item = (f64, Target)> {
        let median = self.median_at_most.map(|most| (self.median(), Target::AtMost(most)));
        let ratio = self.ratio.as_ref().and_then(|ratio| Some((ratio.value, ratio.target?)));
        median.into_iter().chain(ratio)
    }

    fn to_json(&self) -> Value {
        let mut value = json!({
            "name": self.name, "median": self.median(), "min": self.min(), "max": self.max(), "p95": self.p95(),
            "samples": self.samples,
        });
        if let Some(ratio) = &self.ratio {
            value["against"] = json!(ratio.against);
            value["ratio"] = json!(ratio.value);
            match ratio.target {
                Some(Target::AtLeast(least)) => value["at_least"] = json!(least),
                Some(Target::AtMost(most)) => value["at_most"] = json!(most),
                None => {}
            }
        }
        if let Some(most) = self.median_at_most {
            value["median_at_most"] = json!(most);
        }
        if let Some(note) = &self.note {
            value["note"] = json!(note);
        }
        value
    }
}

/// The median of the ratios within each turn.
fn paired(samples: &[f64], others: &[f64]) -> Result<f64> {
    if samples.len() != others.len() {
        bail!("{} turns cannot be compared with {}", samples.len(), others.len());
    }
    let ratios: Vec<f64> = samples.iter().zip(others).map(|(sample, other)| sample / other).collect();
    Ok(quantile(&ratios, 0.5))
}

/// The quantile of a list that is not empty, between neighbours by proportion.
fn quantile(samples: &[f64], part: f64) -> f64 {
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = part * (sorted.len() - 1) as f64;
    let (low, high) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    low + (high - low) * place.fract()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missed_target_fails_and_a_near_one_does_not() {
        assert_eq!(Target::AtLeast(4.0).verdict(4.0), Verdict::Met);
        assert_eq!(Target::AtLeast(4.0).verdict(3.5), Verdict::Near);
        assert_eq!(Target::AtLeast(4.0).verdict(3.3), Verdict::Missed);
        assert_eq!(Target::AtMost(2.0).verdict(1.9), Verdict::Met);
        assert_eq!(Target::AtMost(2.0).verdict(2.3), Verdict::Near);
        assert_eq!(Target::AtMost(2.0).verdict(2.5), Verdict::Missed);
        assert_eq!(Target::AtMost(2.0).verdict(f64::NAN), Verdict::Missed);
    }

    #[test]
    fn ratios_are_taken_within_a_turn() {
        // The machine was ten times slower in the second turn; the ratio does not know it.
        let line = r#"{ "runner": "Node", "group": "g", "unit": "ms", "rows": [
            { "name": "Pasu", "samples": [1, 10, 1], "median_at_most": 0.5 },
            { "name": "slow", "samples": [5, 50, 5], "against": "Pasu", "at_least": 5 },
            { "name": "fast", "samples": [2, 20, 2], "against": "Pasu", "at_least": 3 } ] }"#;
        let group = Group::read(line).unwrap();
        assert_eq!(group.rows[1].ratio.as_ref().unwrap().value, 5.0);
        assert_eq!((group.rows[1].median(), group.rows[1].min(), group.rows[1].max()), (5.0, 5.0, 50.0));
        let missed = group.missed();
        assert!(
            missed.len() == 2 && missed[0].contains("Pasu: 1.000") && missed[1].contains("fast: 2.000"),
            "{missed:?}"
        );
        assert_eq!(group.to_json()["rows"][1]["ratio"], 5.0);
    }

    #[test]
    fn a_line_that_makes_no_sense_is_refused() {
        for rows in [
            r#"[{ "name": "a", "samples": [] }]"#,
            r#"[{ "name": "a", "samples": [1, null] }]"#,
            r#"[{ "name": "a", "samples": [1], "against": "b" }]"#,
            r#"[{ "name": "a", "samples": [1, 2], "against": "b" }, { "name": "b", "samples": [1] }]"#,
        ] {
            let line = format!(r#"{{ "runner": "r", "group": "g", "unit": "ms", "rows": {rows} }}"#);
            assert!(Group::read(&line).is_err(), "{line}");
        }
    }

    #[test]
    fn quantiles_lie_between_neighbours() {
        assert_eq!(quantile(&[3.0, 1.0, 2.0], 0.5), 2.0);
        assert_eq!(quantile(&[4.0, 1.0, 2.0, 3.0], 0.5), 2.5);
        assert_eq!(quantile(&[7.0], 0.95), 7.0);
    }
}
