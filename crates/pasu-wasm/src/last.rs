//! The solution that was used last: a series of calls on one design solves it once, though every call stands by itself.

use std::cell::RefCell;
use std::rc::Rc;

use pasu::{Design, Solution};

thread_local! {
    static LAST: RefCell<Option<Rc<Solution>>> = const { RefCell::new(None) };
}

/// The solution of a design: that of the last call where it was of an equal design, and otherwise one that takes over from it what is the same. Equal designs have the same canonical link, and so the same answers.
pub(crate) fn solution(design: &Design) -> Rc<Solution> {
    LAST.with_borrow_mut(|last| match last {
        Some(known) if known.design() == design => Rc::clone(known),
        _ => {
            let next = last.as_ref().map_or_else(|| Solution::of(design), |known| known.after(design));
            Rc::clone(last.insert(Rc::new(next)))
        }
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
}
