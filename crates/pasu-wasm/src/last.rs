//! The solution that was used last: a series of calls on one design solves it once, though every call stands by itself.

use std::cell::RefCell;
use std::rc::Rc;

use pasu::{Design, Result, Solution};

use crate::room;

thread_local! {
    static LAST: RefCell<Option<Last>> = const { RefCell::new(None) };
}

struct Last {
    solution: Rc<Solution>,
    /// What its design was read from, where that was text.
    text: Option<String>,
    /// By what a caller knows it again.
    #[cfg(feature = "making")]
    mark: Option<f64>,
}

impl Last {
    fn of(solution: Rc<Solution>) -> Last {
        Last {
            solution,
            text: None,
            #[cfg(feature = "making")]
            mark: None,
        }
    }
}

/// The solution of a design: that of the last call where it was of an equal design, and otherwise one that takes over from it what is the same. Equal designs have the same canonical link, and so the same answers.
pub(crate) fn solution(design: &Design) -> Rc<Solution> {
    LAST.with_borrow_mut(|last| match last {
        Some(known) if known.solution.design() == design => Rc::clone(&known.solution),
        _ => {
            room::keep();
            let next = last.as_ref().map_or_else(|| Solution::of(design), |known| known.solution.after(design));
            let solution = Rc::new(next);
            *last = Some(Last::of(Rc::clone(&solution)));
            solution
        }
    })
}

/// The solution of the design that a text says; of the text of the last call it is not even read again, which for hundreds of parts takes longer than most answers.
///
/// # Errors
/// As [`Design::parse`].
pub(crate) fn solution_of(text: &str) -> Result<Rc<Solution>> {
    let known = LAST.with_borrow(|last| {
        let same = last.as_ref().filter(|known| known.text.as_deref() == Some(text));
        same.map(|known| Rc::clone(&known.solution))
    });
    if let Some(solution) = known {
        return Ok(solution);
    }
    let solution = solution(&Design::parse(text)?);
    LAST.with_borrow_mut(|last| {
        if let Some(known) = last {
            known.text = Some(text.to_owned());
        }
    });
    Ok(solution)
}

/// Marks the solution that is kept, so that a caller who knows a design to be the one of before can have it by that.
#[cfg(feature = "making")]
pub(crate) fn mark(mark: f64) {
    LAST.with_borrow_mut(|last| {
        if let Some(known) = last {
            known.mark = Some(mark);
        }
    });
}

/// The solution that is kept, if it has this mark.
#[cfg(feature = "making")]
pub(crate) fn marked(mark: f64) -> Option<Rc<Solution>> {
    LAST.with_borrow(|last| {
        last.as_ref().filter(|known| known.mark == Some(mark)).map(|known| Rc::clone(&known.solution))
    })
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;

    fn design(link: &str) -> Design {
        Design::parse(link).unwrap()
    }

    #[test]
    fn an_equal_design_is_not_solved_again() {
        let first = solution(&design("#1/bloor-wilson?n1=5"));
        // The default written out is the same design.
        let again = solution(&design("#1/bloor-wilson?n1=5&a=0.01"));
        assert!(Rc::ptr_eq(&first, &again));
        let other = solution(&design("#1/bloor-wilson?n1=6"));
        assert!(!Rc::ptr_eq(&first, &other));
        assert_eq!(other.fingerprint().unwrap(), pasu::fingerprint(&design("#1/bloor-wilson?n1=6")).unwrap());
        assert!(!Rc::ptr_eq(&first, &solution(&design("#1/bloor-wilson?n1=5"))));
    }
    #[test]
    fn the_same_text_is_not_read_again() {
        let (five, six) = ("#1/bloor-wilson?n1=5", "#1/bloor-wilson?n1=6");
        let first = solution_of(five).unwrap();
        assert!(Rc::ptr_eq(&first, &solution_of(five).unwrap()));
        assert!(Rc::ptr_eq(&first, &solution(&design(five))));
        // Another text of the same design, and the first one again.
        assert!(Rc::ptr_eq(&first, &solution_of("#1/bloor-wilson?n1=5&a=0.01").unwrap()));
        assert!(Rc::ptr_eq(&first, &solution_of(five).unwrap()));
        // A text stands for no other design than its own, whatever was asked in between.
        let other = solution(&design(six));
        assert!(Rc::ptr_eq(&other, &solution_of(six).unwrap()));
        assert_eq!(solution_of(five).unwrap().design(), &design(five));
        // What is refused leaves everything as it was.
        assert!(solution_of("#1/bloor-wilson?n1=x").is_err());
        assert_eq!(solution_of(five).unwrap().design(), &design(five));
        assert_eq!(solution_of(five).unwrap().design(), &design(five));
    }

    #[cfg(feature = "making")]
    #[test]
    fn a_mark_is_of_one_solution_and_goes_with_it() {
        mark(1.0);
        assert!(marked(1.0).is_none(), "there is nothing to mark");
        let first = solution(&design("#1/bloor-wilson?n1=5"));
        assert!(marked(1.0).is_none());
        mark(1.0);
        assert!(marked(1.0).is_some_and(|again| Rc::ptr_eq(&first, &again)) && marked(2.0).is_none());
        // An equal design keeps it, and one that is refused.
        solution(&design("#1/bloor-wilson?n1=5&a=0.01"));
        assert!(solution_of("#1/bloor-wilson?n1=x").is_err());
        assert!(marked(1.0).is_some());
        solution(&design("#1/bloor-wilson?n1=6"));
        assert!(marked(1.0).is_none());
        solution(&design("#1/bloor-wilson?n1=5"));
        assert!(marked(1.0).is_none());
    }
}
