//! A ring and a drain that are not those that were asked for.

use super::made::Finished;
use super::remedy::Remedy;
use super::report::{Finding, Severity};
use crate::design::Design;
use crate::error::Args;
use crate::solid::{Pot, short};

/// What of a wall was fitted to what there is room for, with the wall that says so.
pub(super) fn findings(made: &Finished, design: &Design) -> Vec<Finding> {
    let part = made.mesh.part;
    let asked = design.parts().get(part).and_then(|part| part.wall);
    let Some((asked, wall)) = asked.zip(made.pot.as_ref().and_then(Pot::wall)) else { return Vec::new() };
    let path = made.path("wall");
    let found = |code, field, message, args| {
        let path = Some(format!("{path}.{field}"));
        let remedy = Some(Remedy::of(made.path("wall"), &asked, wall));
        Finding { code, severity: Severity::Warning, part, path, message, args, at: None, remedy }
    };
    let ring = asked.foot.zip(wall.foot).filter(|(asked, made)| asked != made).map(|(asked, made)| {
        let names = ["askedWidth", "askedHeight", "width", "height"];
        let args = names.into_iter().zip(asked.into_iter().chain(made)).map(|(name, length)| (name, length.into()));
        let args = Args::from_iter(args);
        let [[asked_width, asked_height], [width, height]] = [asked, made].map(|ring| ring.map(short));
        let message = format!(
            "the foot ring is made {width} wide and {height} high: one {asked_width} wide and {asked_height} high, as asked for, has no room"
        );
        found("fitted-foot", "foot", message, args)
    });
    let drain = (wall.drain != asked.drain).then(|| {
        let args = Args::from([("asked", asked.drain.into()), ("drain", wall.drain.into())]);
        let [asked, made] = [asked.drain, wall.drain].map(short);
        found(
            "fitted-drain",
            "drain",
            format!("the drain is made {made} wide: one of {asked}, as asked for, has no room"),
            args,
        )
    });
    ring.into_iter().chain(drain).collect()
}
