//! A place beside a part in which a higher floor keeps what it has made of it.

use core::any::Any;
use core::fmt;
use std::sync::{Arc, OnceLock};

/// One value of a type that only whoever keeps it knows: a solution knows nothing of bodies.
#[derive(Default, Clone)]
pub(crate) struct Kept(OnceLock<Arc<dyn Any + Send + Sync>>);

impl Kept {
    /// What is kept; `None` where nothing is yet.
    pub(crate) fn get<T: Any>(&self) -> Option<&T> {
        self.0.get()?.downcast_ref()
    }

    /// Whether anything is kept.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.get().is_none()
    }

    /// Keeps a value, unless another came first: whatever is asked at the same time finds the same.
    pub(crate) fn keep<T: Any + Send + Sync>(&self, value: T) {
        self.0.get_or_init(|| Arc::new(value));
    }
}

impl fmt::Debug for Kept {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.is_empty() { "nothing" } else { "kept" })
    }
}
