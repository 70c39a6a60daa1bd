//! Measurements as tables, for the terminal and for Markdown.

use std::fmt::Write;

use super::machine::Machine;
use super::measurement::{Group, Ratio, Row, Target, Verdict};

/// The heads of the columns.
fn head(group: &Group) -> [String; 7] {
    ["", "median", "min", if group.tail { "p95" } else { "max" }, "ratio", "target", ""].map(str::to_owned)
}

/// The tables for the terminal.
pub(crate) fn text(machine: &Machine, groups: &[Group]) -> String {
    let mut text = machine.lines().join("\n");
    let lines: Vec<Vec<[String; 7]>> = groups.iter().map(cells).collect();
    let widths: [usize; 7] = std::array::from_fn(|column| {
        let cells = lines.iter().flatten().map(|line| line[column].chars().count());
        cells.max().unwrap_or(0).max(6)
    });
    for (group, lines) in groups.iter().zip(&lines) {
        let _ = write!(text, "\n\n{}: {} ({})", group.runner, group.name, group.unit);
        for line in [head(group)].iter().chain(lines) {
            let padded: Vec<String> = line
                .iter()
                .zip(widths)
                .enumerate()
                .map(
                    |(column, (cell, width))| {
                        if column == 0 || column > 3 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
                    },
                )
                .collect();
            let _ = write!(text, "\n  {}", padded.join("  ").trim_end());
        }
        for row in &group.rows {
            if let Some(note) = &row.note {
                let _ = write!(text, "\n  {}: {note}", row.name);
            }
        }
    }
    text
}

/// The tables for Markdown.
pub(crate) fn markdown(machine: &Machine, groups: &[Group]) -> String {
    let mut text = String::new();
    for line in machine.lines() {
        let _ = writeln!(text, "- {line}");
    }
    let mut runner = "";
    for group in groups {
        if group.runner != runner {
            runner = &group.runner;
            let _ = write!(text, "\n### {}{}\n", runner[..1].to_uppercase(), &runner[1..]);
        }
        let _ = write!(text, "\n**{}**, {}\n\n", group.name, group.unit);
        let _ = writeln!(text, "| {} |", head(group).join(" | "));
        let _ = writeln!(text, "| --- | ---: | ---: | ---: | ---: | --- | --- |");
        for line in cells(group) {
            let _ = writeln!(text, "| {} |", line.join(" | "));
        }
        for row in &group.rows {
            if let Some(note) = &row.note {
                let _ = write!(text, "\n{}: {}.\n", row.name, note.trim_end_matches('.'));
            }
        }
    }
    text
}

/// The rows of a group.
fn cells(group: &Group) -> Vec<[String; 7]> {
    let against = group.rows.iter().find_map(|row| row.ratio.as_ref()).map(|ratio| ratio.against.as_str());
    let line = |row: &Row| {
        let verdict =
            row.targets().map(|(value, target)| target.verdict(value)).map(said).collect::<Vec<_>>().join(", ");
        let most = if group.tail { row.p95() } else { row.max() };
        let [median, min, max] = [row.median(), row.min(), most].map(figure);
        let base = if Some(row.name.as_str()) == against { "1".to_owned() } else { String::new() };
        let ratio = row.ratio.as_ref().map_or(base, |ratio| figure(ratio.value));
        [row.name.clone(), median, min, max, ratio, target(row, &group.unit), verdict]
    };
    group.rows.iter().map(line).collect()
}

fn target(row: &Row, unit: &str) -> String {
    let of_median = row.median_at_most.map(|most| format!("at most {most} {unit}"));
    let of_ratio = row.ratio.as_ref().and_then(|Ratio { target, .. }| *target).map(|target| match target {
        Target::AtLeast(least) => format!("at least {least}"),
        Target::AtMost(most) => format!("at most {most}"),
    });
    of_median.into_iter().chain(of_ratio).collect::<Vec<_>>().join(", ")
}

fn said(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Met => "met",
        Verdict::Near => "near",
        Verdict::Missed => "MISSED",
    }
}

/// Three digits that count.
fn figure(value: f64) -> String {
    let digits = if value > 0.0 && value.is_finite() { 2 - value.log10().floor() as i32 } else { 0 };
    format!("{value:.*}", digits.clamp(0, 9) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_three_digits() {
        assert_eq!(
            [1234.5, 123.4, 12.34, 1.234, 0.01234, 0.0].map(figure),
            ["1234", "123", "12.3", "1.23", "0.0123", "0"]
        );
    }

    #[test]
    fn a_row_says_its_target_and_how_it_stands() {
        let line = r#"{ "runner": "Node", "group": "g", "unit": "us", "rows": [
            { "name": "Pasu", "samples": [60], "median_at_most": 50 },
            { "name": "slow", "samples": [600], "against": "Pasu", "at_least": 3 } ] }"#;
        let cells = cells(&Group::read(line).unwrap());
        assert_eq!(cells[0], ["Pasu", "60.0", "60.0", "60.0", "1", "at most 50 us", "MISSED"]);
        assert_eq!(cells[1], ["slow", "600", "600", "600", "10.0", "at least 3", "met"]);
    }
}
