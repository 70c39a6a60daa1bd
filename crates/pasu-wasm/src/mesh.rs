//! A mesh as an object of typed arrays, which are the caller's own copies.

#[cfg(feature = "making")]
use core::ops::Range;
use std::cell::RefCell;
use std::rc::Rc;
#[cfg(feature = "making")]
use std::rc::Weak;

use js_sys::{Object, Reflect};
use pasu::{Mesh, MeshOptions, Result, Sampler, Solution};
use wasm_bindgen::JsValue;

use crate::into::{Room, floats, integers};

/// A mesh of more vertices than this is not kept to be overwritten: its memory would never be free for anything else.
const KEPT: usize = 1 << 20;

/// As many are kept: who shows a fine mesh and a coarse one of every design asks for both in turn.
const SAMPLERS: usize = 2;

/// A sampler with the options of its mesh, and the solution that this is of, as long as that is there.
struct Kept {
    options: MeshOptions,
    sampler: Sampler,
    #[cfg(feature = "making")]
    of: Weak<Solution>,
}

thread_local! {
    /// Their arrays are overwritten by every mesh of the same options, so that a drag allocates nothing. The one used last comes last.
    static KEPT_SAMPLERS: RefCell<Vec<Kept>> = RefCell::default();
}

/// Samples a design and writes the mesh into `into`, as [`object`] does.
pub(crate) fn sampled(
    solution: &Rc<Solution>,
    options: &MeshOptions,
    into: &JsValue,
) -> Result<core::result::Result<Object, JsValue>> {
    KEPT_SAMPLERS.with_borrow_mut(|kept| {
        let found = kept.iter().position(|kept| kept.options == *options);
        let mut sampler = found.map_or_else(Sampler::new, |index| kept.remove(index).sampler);
        let mesh = sampler.sample_solution(solution, options)?;
        let object = object(mesh, into);
        if mesh.n_vertices() <= KEPT {
            kept.push(Kept {
                options: *options,
                sampler,
                #[cfg(feature = "making")]
                of: Rc::downgrade(solution),
            });
            if kept.len() > SAMPLERS {
                kept.remove(0);
            }
        }
        Ok(object)
    })
}

/// Samples the solution of a design after that of another, and shows what is made together with the vertices that are others then; `None`, and nothing is solved, where the mesh of the design before is not kept.
#[cfg(feature = "making")]
pub(crate) fn sampled_after<T>(
    before: &Rc<Solution>,
    after: impl FnOnce() -> Rc<Solution>,
    options: &MeshOptions,
    show: impl FnOnce(&Mesh, &[Range<usize>]) -> T,
) -> Result<Option<T>> {
    KEPT_SAMPLERS.with_borrow_mut(|kept| {
        let is_of = |kept: &Kept| kept.options == *options && core::ptr::eq(kept.of.as_ptr(), Rc::as_ptr(before));
        let Some(index) = kept.iter().position(is_of) else { return Ok(None) };
        let mut own = kept.remove(index);
        let solution = after();
        let written = {
            own.sampler.sample_solution(&solution, options)?;
            own.sampler.written().to_vec()
        };
        let shown = show(own.sampler.mesh(), &written);
        own.of = Rc::downgrade(&solution);
        kept.push(own);
        Ok(Some(shown))
    })
}

/// `{ positions, normals, uvs, indices, groups, topology, bound }`, in the arrays of `into` where these are long enough.
///
/// Where `into` already is of this topology, what depends on it alone is not written again: it is handed back where it is given, and left out where not.
fn object(mesh: &Mesh, into: &JsValue) -> core::result::Result<Object, JsValue> {
    let object = Object::new();
    for (key, values) in [("positions", &mesh.positions), ("normals", &mesh.normals)] {
        set(&object, key, floats(values, &field(into, key), Room::None).into())?;
    }
    set(&object, "topology", mesh.topology.as_str().into())?;
    set(&object, "bound", mesh.bound.map_or(JsValue::NULL, JsValue::from))?;
    if field(into, "topology").as_string().is_some_and(|topology| topology == mesh.topology) {
        for key in ["uvs", "indices", "groups"] {
            let given = field(into, key);
            if !given.is_undefined() {
                set(&object, key, given)?;
            }
        }
    } else {
        set(&object, "uvs", floats(&mesh.uvs, &field(into, "uvs"), Room::None).into())?;
        for (key, values) in [("indices", &mesh.indices), ("groups", &mesh.groups)] {
            set(&object, key, integers(values, &field(into, key), Room::None).into())?;
        }
    }
    Ok(object)
}

/// A field of whatever this is; `undefined` where it has none.
pub(crate) fn field(of: &JsValue, key: &str) -> JsValue {
    Reflect::get(of, &key.into()).unwrap_or(JsValue::UNDEFINED)
}

/// Sets a field of an object.
pub(crate) fn set(object: &Object, key: &str, value: JsValue) -> core::result::Result<(), JsValue> {
    Reflect::set(object, &key.into(), &value).map(|_| ())
}
