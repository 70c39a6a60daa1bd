//! Whether a step has anything to do: a stamp remembers what its inputs were when it last succeeded.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::workspace::Workspace;

/// Folders that are products or caches, never inputs.
const NOT_INPUTS: [&str; 5] = ["node_modules", "dist", "pkg", "target", ".git"];

/// The remembered inputs of one step. They are judged by their contents, not by dates, which a checkout changes.
pub(crate) struct Stamp {
    file: PathBuf,
    now: String,
}

impl Stamp {
    /// The stamp of the step `name` for these files and folders and `settings`.
    pub(crate) fn of(workspace: &Workspace, name: &str, settings: &str, inputs: &[PathBuf]) -> Result<Stamp> {
        let mut hasher = DefaultHasher::new();
        settings.hash(&mut hasher);
        for input in inputs {
            hash_tree(input, &mut hasher)?;
        }
        // Several checkouts may share one target folder.
        let mut checkout = DefaultHasher::new();
        workspace.root().hash(&mut checkout);
        let folder = workspace.target().join("xtask").join(format!("{:016x}", checkout.finish()));
        Ok(Stamp { file: folder.join(name), now: format!("{:016x}", hasher.finish()) })
    }

    /// Where a file of this name can be kept for this checkout alone.
    pub(crate) fn beside(&self, name: &str) -> PathBuf {
        self.file.with_file_name(name)
    }

    /// Whether the step succeeded before with the same inputs.
    pub(crate) fn is_fresh(&self) -> bool {
        fs::read_to_string(&self.file).is_ok_and(|then| then == self.now)
    }

    /// Forgets the last success: call it before the products are touched.
    pub(crate) fn clear(&self) {
        // A stamp that was never there is as good as removed.
        let _ = fs::remove_file(&self.file);
    }

    /// Remembers the success.
    pub(crate) fn save(&self) -> Result<()> {
        if let Some(folder) = self.file.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(&self.file, &self.now).with_context(|| format!("cannot write {}", self.file.display()))
    }
}

fn hash_tree(path: &Path, hasher: &mut DefaultHasher) -> Result<()> {
    path.hash(hasher);
    if path.is_dir() {
        for entry in sorted_entries(path)? {
            if !NOT_INPUTS.iter().any(|name| entry.ends_with(name)) {
                hash_tree(&entry, hasher)?;
            }
        }
    } else if path.exists() {
        fs::read(path).with_context(|| format!("cannot read {}", path.display()))?.hash(hasher);
    }
    Ok(())
}

/// What is in a folder, by name.
pub(crate) fn sorted_entries(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut entries = fs::read_dir(folder)
        .and_then(|entries| entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<Vec<_>, _>>())
        .with_context(|| format!("cannot read the folder {}", folder.display()))?;
    entries.sort();
    Ok(entries)
}
