//! What a hand can drag: each handle moves what it says by as much as it says, and the data of no other.

use pasu::{Design, End, Handle, HandleId, Restraint, Shape, Step, derivatives, evaluate};
use serde_json::{Map, Value, json};

const GALLERY: &str = include_str!("../reference/gallery.json");

fn shape(json: &Value) -> Shape {
    Shape::parse(&json.to_string()).unwrap()
}

fn handle(shape: &Shape, id: HandleId) -> Handle {
    shape.handles().list.iter().find(|handle| handle.id == id).unwrap().clone()
}

fn paths(steps: &[Step]) -> Vec<&str> {
    steps.iter().map(|step| step.path.as_str()).collect()
}

/// The document of a shape with the numbers of a handle moved.
fn moved(json: &Value, steps: &[Step], by: f64) -> Value {
    let mut json = json.clone();
    for step in steps {
        let number = place(&mut json, &step.path);
        // What is left out of a family has its default; that of boundary data is 0.
        let before = number.as_f64().unwrap_or(if step.path == "height" { 3.6 } else { 0.0 });
        *number = (before + by * step.by).into();
    }
    json
}

/// Where a number stands in a document, made where it is missing.
fn place<'a>(json: &'a mut Value, path: &str) -> &'a mut Value {
    path.split(['.', '[', ']']).filter(|key| !key.is_empty()).fold(json, |here, key| match key.parse::<usize>() {
        Ok(index) => {
            let list = here.as_array_mut().unwrap();
            if index == list.len() {
                list.push(Value::Object(Map::new()));
            }
            &mut list[index]
        }
        Err(_) => here
            .as_object_mut()
            .map(|record| record.entry(key).or_insert(Value::Null))
            .map(|value| {
                if value.is_null() && matches!(key, "cos" | "sin") {
                    *value = json!({});
                }
                value
            })
            .unwrap(),
    })
}

/// `x` and `z` of the position at `u = 0` and `u = 1`, then of `X_u`.
fn data(json: &Value) -> [[f64; 2]; 4] {
    let design = Design::parse(&json!({ "pasu": 1, "parts": [{ "shape": json }] }).to_string()).unwrap();
    let at = [0.0, 0.0, 1.0, 0.0];
    let position = evaluate(&design, 0, &at).unwrap();
    let slope = derivatives(&design, 0, &at).unwrap().du;
    [[position[0], position[2]], [position[3], position[5]], [slope[0], slope[2]], [slope[3], slope[5]]]
}

/// Its place in [`data`].
fn index(id: HandleId, rim: End) -> usize {
    let is_start = matches!(id, HandleId::Rim | HandleId::RimSlope) == (rim == End::Start);
    usize::from(!is_start) + if matches!(id, HandleId::RimSlope | HandleId::FootSlope) { 2 } else { 0 }
}

#[test]
fn a_handle_moves_its_own_point_by_what_it_says_and_no_other_that_is_prescribed() {
    let exhibits: Vec<Value> = serde_json::from_str(GALLERY).unwrap();
    let mut n_moves = 0;
    for exhibit in &exhibits {
        let (name, json) = (&exhibit["name"], &exhibit["shape"]);
        let handles = shape(json).handles();
        let before = data(json);
        for moving in &handles.list {
            for (axis, steps) in [&moving.radial, &moving.axial].into_iter().enumerate() {
                if steps.is_empty() {
                    assert!(!moving.restraints.is_empty(), "{name} {:?}", moving.id);
                    continue;
                }
                let after = data(&moved(json, steps, 0.25));
                let own = index(moving.id, handles.rim);
                let size = before.iter().flatten().fold(1.0, |most: f64, x| most.max(x.abs()));
                for other in &handles.list {
                    for (which, prescribed) in [&other.radial, &other.axial].into_iter().enumerate() {
                        let at = index(other.id, handles.rim);
                        let wanted = if at == own && which == axis { 0.25 } else { 0.0 };
                        let found = after[at][which] - before[at][which];
                        let is_told = !prescribed.is_empty() || at < 2;
                        assert!(!is_told || (found - wanted).abs() < 1e-9 * size, "{name} {:?} {found}", moving.id);
                    }
                }
                n_moves += 1;
            }
        }
    }
    assert!(n_moves > 200, "{n_moves}");
}

#[test]
fn one_answer_is_good_for_a_whole_drag() {
    let exhibits: Vec<Value> = serde_json::from_str(GALLERY).unwrap();
    for exhibit in &exhibits {
        let json = &exhibit["shape"];
        let handles = shape(json).handles();
        for moving in &handles.list {
            let later = moved(&moved(json, &moving.radial, 0.375), &moving.axial, 0.25);
            assert_eq!(handle(&shape(&later), moving.id).axial, moving.axial, "{}", exhibit["name"]);
            for (before, after) in moving.radial.iter().zip(&handle(&shape(&later), moving.id).radial) {
                assert_eq!(before.path, after.path, "{}", exhibit["name"]);
                assert!((before.by - after.by).abs() <= 1e-12 * before.by.abs(), "{}", exhibit["name"]);
            }
        }
    }
}

#[test]
fn the_rim_is_where_the_height_is() {
    let of = |link: &str| Design::parse(link).unwrap().parts()[0].shape.handles().rim;
    assert_eq!([of("#1/second-order"), of("#1/second-order?height=-2")], [End::Start, End::End]);
    assert_eq!([of("#1/mixed-order"), of("#1/bloor-wilson")], [End::Start, End::Start]);
    assert_eq!([of("#1/fourth-order"), of("#1/fourth-order?h1=-2")], [End::End, End::Start]);
    assert_eq!(of("#1/bloor-wilson?h=-3,.3"), End::End);
}

#[test]
fn a_pot_upside_down_leans_at_the_end_that_is_up() {
    let upside_down = json!({ "kind": "fourth-order", "r0": 0.4, "r1": 0.3, "rm": 0.8, "h1": -2, "eta": [0.5, 0.5], "dz": [6, 6],
        "s": [1, 1], "t": [3, 3], "w": [1, 1] });
    assert_eq!(paths(&handle(&shape(&upside_down), HandleId::RimSlope).axial), ["dz[0]"]);
}

#[test]
fn without_a_swell_there_is_no_lean() {
    for rm in [1.0, 1.0 + 1e-320] {
        let flat = json!({ "kind": "fourth-order", "r0": 1, "r1": 1, "rm": rm, "h1": 2, "eta": [0.5, 0.5], "dz": [6, 6], "s": [1, 1],
            "t": [3, 3], "w": [1, 1] });
        let slope = handle(&shape(&flat), HandleId::RimSlope);
        assert!(slope.radial.is_empty());
        assert_eq!(slope.restraints, [Restraint::NoSwell]);
        assert_eq!(paths(&slope.axial), ["dz[1]"]);
    }
}

/// A round pot of boundary data, with these orders of `x` and `y` and of `z`, and these modes of `z`.
fn free(round: u8, level: u8, z: Value) -> Value {
    let component = |order: u8, modes: Value| match order {
        2 => json!({ "order": 2, "s": 1, "t": 1, "modes": modes }),
        _ => json!({ "order": 4, "s": 1, "t": 2, "w": 1, "modes": modes }),
    };
    json!({
        "kind": "boundary-value",
        "span": "2pi",
        "x": component(round, json!([{ "n": 3, "cos": { "start": 0.1 } }, { "n": 1, "cos": { "start": 1, "end": 0.5 } }])),
        "y": component(round, json!([{ "n": 1, "sin": { "end": -0.5 } }])),
        "z": component(level, z),
    })
}

#[test]
fn in_boundary_data_x_and_y_move_together_and_y_the_way_that_it_runs() {
    let steps = |id| handle(&shape(&free(4, 4, json!([{ "n": 0, "cos": { "start": 3 } }]))), id);
    let rim = steps(HandleId::Rim);
    assert_eq!(paths(&rim.radial), ["x.modes[1].cos.start", "y.modes[0].sin.start"]);
    assert_eq!((rim.radial[0].by, rim.radial[1].by), (1.0, -1.0));
    assert_eq!(paths(&rim.axial), ["z.modes[0].cos.start"]);
    assert_eq!(paths(&steps(HandleId::FootSlope).radial), ["x.modes[1].cos.end_u", "y.modes[0].sin.end_u"]);
    assert!(rim.restraints.is_empty());
}

#[test]
fn a_level_that_no_mode_has_is_a_new_mode() {
    let wavy = free(4, 4, json!([{ "n": 2, "cos": { "start": 0.3 } }]));
    let foot = handle(&shape(&wavy), HandleId::Foot);
    assert_eq!(paths(&foot.axial), ["z.modes[1].n", "z.modes[1].cos.end"]);
    let later = moved(&wavy, &foot.axial, -1.0);
    assert_eq!(later["z"]["modes"][1], json!({ "n": 0.0, "cos": { "end": -1.0 } }));
    assert_eq!(data(&later)[1][1], data(&wavy)[1][1] - 1.0);
}

#[test]
fn what_boundary_data_cannot_prescribe_is_said() {
    let level = json!([{ "n": 0, "cos": { "start": 3 } }]);
    let slope = |json: &Value| handle(&shape(json), HandleId::RimSlope);
    let both = slope(&free(2, 2, level.clone()));
    assert!(both.radial.is_empty() && both.axial.is_empty());
    assert_eq!(both.restraints, [Restraint::LeanOrder, Restraint::RiseOrder]);
    assert_eq!(slope(&free(4, 2, level.clone())).restraints, [Restraint::RiseOrder]);
    assert_eq!(slope(&free(2, 4, level.clone())).restraints, [Restraint::LeanOrder]);
    let mut no_radius = free(4, 4, level);
    no_radius["y"]["modes"] = json!([{ "n": 2, "sin": { "start": 1 } }]);
    assert_eq!(handle(&shape(&no_radius), HandleId::Rim).restraints, [Restraint::NoRadius]);
    assert_eq!(slope(&no_radius).restraints, [Restraint::NoRadius]);
}
