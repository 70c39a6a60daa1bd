//! Calls that are watched: what is told, and that one that is ended leaves nothing behind.

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;

use pasu::{
    Code, Design, Error, Format, Making, Map, MeasureOptions, MeshOptions, Result, SketchOptions, Solution, watched,
};

/// Petals that the wall has to be thinned in, a ring and a drain: whatever takes long is asked of it.
const POT: &str = r#"{ "shape": { "kind": "second-order", "r": [5, 0.4, 3, 0.24], "n": [1, 8], "t": [0, 0], "height": 9 },
    "wall": { "thickness": 0.5, "base": 0.5, "rim": "rounded", "foot": [0.5, 0.4], "drain": 0.8 }, "place": { "shift": [SHIFT, 0, 0] } }"#;

fn pots(n: usize) -> Design {
    let parts: Vec<String> = (0..n).map(|index| POT.replace("SHIFT", &(20 * index).to_string())).collect();
    Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}] }}"#, parts.join(","))).expect("a design")
}

/// Everything that may take long, each as text or bytes of its answer.
type Call = (&'static str, fn(&Solution) -> Result<Vec<u8>>);

const CALLS: [Call; 9] = [
    ("mesh", |of| of.mesh(&within(1e-5)).map(|mesh| mesh.positions.iter().flat_map(|x| x.to_le_bytes()).collect())),
    ("measure", |of| of.measure(&MeasureOptions::default()).map(|measures| format!("{measures:?}").into_bytes())),
    ("check", |of| of.check(&coarse()).map(|report| format!("{report:?}").into_bytes())),
    ("drawn", |of| of.drawn(&coarse()).map(|drawn| drawn.positions.iter().flat_map(|x| x.to_le_bytes()).collect())),
    ("sketch", |of| of.sketch(&SketchOptions::default()).map(|sketch| format!("{sketch:?}").into_bytes())),
    ("paint", |of| {
        of.paint(Map::Thickness, &within(2e-3)).map(|values| values.iter().flat_map(|x| x.to_le_bytes()).collect())
    }),
    ("step", |of| of.write(Format::Step, &coarse())),
    ("3mf", |of| of.write(Format::ThreeMf, &coarse())),
    ("svg", |of| of.write(Format::SvgA4, &coarse())),
];

fn within(tolerance: f64) -> MeshOptions {
    MeshOptions { tolerance: Some(tolerance), ..MeshOptions::default() }
}

fn coarse() -> Making {
    making(0.04)
}

fn making(tolerance: f64) -> Making {
    Making { tolerance: Some(tolerance), ..Making::default() }
}

/// What is told during a call, which may be ended at some number of it.
fn told<T>(end: Option<usize>, call: impl FnOnce() -> Result<T>) -> (Vec<f64>, Result<T>) {
    let all = Rc::new(RefCell::new(Vec::new()));
    let heard = Rc::clone(&all);
    let answer = watched(
        move |done| {
            heard.borrow_mut().push(done);
            if Some(heard.borrow().len()) == end { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        },
        call,
    );
    let all = all.borrow().clone();
    (all, answer)
}

#[test]
fn what_is_told_grows_from_nothing_to_all() {
    for (name, call) in CALLS {
        let (told, answer) = told(None, || call(&Solution::of(&pots(1))));
        assert!(answer.is_ok(), "{name}");
        assert_eq!((told[0], told[told.len() - 1]), (0.0, 1.0), "{name}");
        assert!(told.windows(2).all(|pair| pair[0] <= pair[1]), "{name}: {told:?}");
        assert!(told.len() > 2, "{name}: {told:?}");
    }
}

#[test]
fn to_be_watched_changes_no_bit() {
    for (name, call) in CALLS {
        let alone = call(&Solution::of(&pots(1)));
        assert_eq!(told(None, || call(&Solution::of(&pots(1)))).1, alone, "{name}");
    }
}

#[test]
fn a_call_that_is_ended_leaves_nothing_behind() {
    for (name, call) in CALLS {
        let (told_of_all, expected) = told(None, || call(&Solution::of(&pots(1))));
        let n = told_of_all.len();
        assert!(n >= 4, "{name}: {n}");
        // Ended again and again at another place, as by a hand that goes on moving, and then left to end.
        let pot = Solution::of(&pots(1));
        for end in [1, 2, n / 4, n / 2, 3 * n / 4, n - 1] {
            // What was settled by an earlier call is not done again, so that one may end before it is to be ended.
            let (told, answer) = told(Some(end), || call(&pot));
            let is_ended = told.len() == end;
            let code = answer.map(drop).map_err(|error| error.code());
            assert_eq!(code, if is_ended { Err(Code::Cancelled) } else { Ok(()) }, "{name}, {end} of {n}");
            assert!(told.len() <= end, "{name}: who has ended a call hears no more of it");
            assert!(is_ended || end > 2, "{name}, {end} of {n}");
        }
        assert!(call(&pot) == expected, "{name}");
        for end in [1, n / 2] {
            let pot = Solution::of(&pots(1));
            let (_, answer) = told(Some(end), || call(&pot));
            assert_eq!(answer.map(drop).map_err(|error| error.code()), Err(Code::Cancelled), "{name}, {end} of {n}");
            assert!(call(&pot) == expected, "{name}, {end} of {n}");
        }
    }
}

/// It is told by what was done, not by a clock: about every millisecond, so that a tenth of a second is a hundred of these.
#[test]
fn more_work_is_told_more_often() {
    let pot = Solution::of(&pots(1));
    let n = |tolerance: f64| told(None, || pot.solid(&making(tolerance))).0.len();
    let (coarse, fine) = (n(0.02), n(0.001));
    assert!(coarse > 10 && fine > 2 * coarse, "{coarse}, {fine}");
}

#[test]
fn parts_take_their_share() {
    let pots = Solution::of(&pots(4));
    let (told, report) = told(None, || pots.check(&coarse()));
    assert!(report.is_ok());
    for share in [0.25, 0.5, 0.75] {
        assert!(told.iter().any(|done| (done - share).abs() < 0.1), "{share}: {told:?}");
    }
}

#[test]
fn who_listens_may_ask_something_else() {
    let other = Design::parse("#1/bloor-wilson?n1=5").expect("a link");
    let expected = pasu::measure(&other, &MeasureOptions::default());
    let pot = Solution::of(&pots(1));
    let alone = pasu::check(pot.design(), &coarse());
    let answers = Rc::new(RefCell::new(Vec::new()));
    let heard = Rc::clone(&answers);
    let answer = watched(
        move |_| {
            if heard.borrow().len() < 3 {
                let inner =
                    watched(|_| ControlFlow::Continue(()), || pasu::measure(&other, &MeasureOptions::default()));
                heard.borrow_mut().push(inner);
            }
            ControlFlow::Continue(())
        },
        || pot.check(&coarse()),
    );
    assert_eq!(answer, alone);
    assert!(answers.borrow().len() == 3 && answers.borrow().iter().all(|answer| *answer == expected));
}

#[test]
fn a_watched_call_within_another_is_told_by_itself() {
    let pot = Solution::of(&pots(1));
    let both = || {
        let (inner, answer) = told(Some(3), || pot.check(&coarse()));
        assert_eq!((inner.len(), answer.map_err(|error| error.code())), (3, Err(Code::Cancelled)));
        pot.check(&coarse())
    };
    let (outer, answer) = told(None, both);
    assert_eq!(answer, pot.check(&coarse()));
    assert!(outer.len() > 5 && outer[outer.len() - 1] == 1.0, "{outer:?}");
}

#[test]
fn a_listener_that_panics_is_heard_no_more() {
    let pot = Solution::of(&pots(1));
    let expected = pasu::check(pot.design(), &coarse());
    let mut n = 0;
    let listener = move |_| {
        n += 1;
        assert!(n < 4, "enough");
        ControlFlow::Continue(())
    };
    let caught = catch_unwind(AssertUnwindSafe(|| watched(listener, || pot.check(&coarse()))));
    assert!(caught.is_err());
    assert_eq!(pot.check(&coarse()), expected);
}

#[test]
fn a_refusal_is_that_of_the_call() {
    let refused = || Err::<(), Error>(Error::new(Code::NoRoom, "parts[0]", "no room"));
    let (told, answer) = told(None, refused);
    assert_eq!((told, answer), (vec![0.0], refused()));
}

/// A ring that would come out of the cone, and gives way to a wider one.
const CONE: &str = r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [1, 0, 4, 0], "t": [0, 0], "n": [1, 2], "height": 3 },
    "wall": { "thickness": 0.2, "base": 0.3, "foot": [0.3, 0.6] } }] }"#;

#[test]
fn a_ring_is_fitted_after_a_call_that_was_ended_while_it_was_sought() {
    let design = Design::parse(CONE).unwrap();
    let check = |of: &Solution| of.check(&coarse());
    let (heard, whole) = told(None, || check(&Solution::of(&design)));
    let whole = format!("{:?}", whole.unwrap());
    assert!(whole.contains("fitted-foot"), "{whole}");
    for end in (1..heard.len()).step_by(heard.len().div_ceil(12)) {
        let solution = Solution::of(&design);
        let (_, ended) = told(Some(end), || check(&solution));
        assert_eq!(ended.unwrap_err().code(), Code::Cancelled, "{end} of {}", heard.len());
        assert_eq!(format!("{:?}", check(&solution).unwrap()), whole, "{end} of {}", heard.len());
    }
}
