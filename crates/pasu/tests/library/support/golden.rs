//! Files that keep what was found once, by name.

use std::collections::BTreeMap;

/// A file of the folder `goldens`, as it was when the tests were compiled: nothing is looked for when they run, so that a package without it shows at once.
macro_rules! golden {
    ($name:literal) => {
        crate::support::golden::Golden { name: $name, text: include_str!(concat!("../goldens/", $name)) }
    };
}
pub(crate) use golden;

/// A golden file.
pub(crate) struct Golden {
    pub(crate) name: &'static str,
    pub(crate) text: &'static str,
}

impl Golden {
    /// What it has. With `PASU_BLESS=1` it is written anew first, with what was found now.
    pub(crate) fn beside(&self, found: &BTreeMap<String, String>) -> BTreeMap<String, String> {
        if std::env::var_os("PASU_BLESS").is_none() {
            return serde_json::from_str(self.text).unwrap();
        }
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/goldens");
        std::fs::write(folder.join(self.name), serde_json::to_string_pretty(found).unwrap() + "\n").unwrap();
        found.clone()
    }
}
