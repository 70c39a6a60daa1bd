//! What sampling takes from memory once its arrays are there.

use crate::support::{corpus, design_of_case, gallery, table};
use allocation_counter::{AllocationInfo, measure};
use pasu::{MeshOptions, Sampler};

/// What one more mesh of the design takes.
fn taken(design: &pasu::Design, rows: usize, columns: usize) -> AllocationInfo {
    let options = MeshOptions { rows: Some(rows), columns: Some(columns), tolerance: None };
    let mut sampler = Sampler::new();
    for _ in 0..3 {
        sampler.sample(design, &options).unwrap();
    }
    measure(|| {
        sampler.sample(design, &options).unwrap();
    })
}

#[test]
fn a_finer_mesh_takes_no_more_than_a_coarse_one() {
    let figures = corpus().into_iter().map(|case| (case.name.clone(), design_of_case(&case)));
    let exhibits = gallery().into_iter().map(|exhibit| (exhibit.name.clone(), exhibit.design()));
    for (name, design) in figures.chain(exhibits) {
        let (coarse, fine) = (taken(&design, 129, 65), taken(&design, 513, 385));
        assert_eq!((coarse.bytes_current, fine.bytes_current), (0, 0), "{name} keeps what it took");
        // What is taken is the solution. Only a row with a cusp asks for a table of second derivatives, and few rows have one.
        assert!(fine.count_total <= coarse.count_total + 40, "{name}: {coarse:?} {fine:?}");
    }
}

#[test]
fn where_single_precision_holds_every_normal_nothing_depends_on_the_grid() {
    let jar = gallery().into_iter().find(|exhibit| exhibit.name == "own-jar").expect("in the gallery");
    for exhibit in ["table-twist", "table-melon", "table-square", "table-gourd"].map(table).into_iter().chain([jar]) {
        let (coarse, fine) = (taken(&exhibit.design(), 129, 65), taken(&exhibit.design(), 513, 385));
        let sizes = |info: &AllocationInfo| (info.count_total, info.bytes_total);
        assert_eq!(sizes(&coarse), sizes(&fine), "{}", exhibit.name);
    }
}
