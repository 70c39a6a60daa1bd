//! The inside of a solid for analysis: hexahedra or tetrahedra as text, in millimetres.

mod inp;
mod listed;
mod msh;
mod vtu;

use crate::design::Design;
use crate::error::Result;
use crate::interior::CellsOptions;
use crate::solution::Solution;

/// A kind of file for cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum CellsFormat {
    /// VTK's XML of an unstructured grid, with the scaled Jacobian of every cell.
    Vtu,
    /// Gmsh 2.2, with the scaled Jacobian of every cell.
    Msh,
    /// Abaqus: nodes and elements C3D8 or C3D4.
    Inp,
}

impl CellsFormat {
    /// All of them.
    pub const ALL: [CellsFormat; 3] = [CellsFormat::Vtu, CellsFormat::Msh, CellsFormat::Inp];

    /// The ending of its files, which is also its name: `vtu`, `msh`, `inp`.
    ///
    /// ```
    /// assert_eq!(pasu::CellsFormat::Vtu.name(), "vtu");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            CellsFormat::Vtu => "vtu",
            CellsFormat::Msh => "msh",
            CellsFormat::Inp => "inp",
        }
    }

    /// The format of a [name](CellsFormat::name); `None` if there is none.
    ///
    /// ```
    /// assert_eq!(pasu::CellsFormat::from_name("inp"), Some(pasu::CellsFormat::Inp));
    /// ```
    pub fn from_name(name: &str) -> Option<CellsFormat> {
        CellsFormat::ALL.into_iter().find(|format| format.name() == name)
    }
}

/// The inside of part number `part` as a file, in millimetres.
///
/// # Errors
/// As [`cells`](crate::cells()).
///
/// ```
/// # let text = r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "blend",
/// #   "start": { "form": "disc", "radius": [1, 1], "z": 0, "taper": 0, "dz": 2 }, "end": { "form": "disc", "radius": [2, 2], "z": 2, "taper": 0, "dz": 2 } } }] }"#;
/// let cone = pasu::Design::parse(text)?;
/// let file = pasu::cells_file(&cone, 0, &pasu::CellsOptions::default(), pasu::CellsFormat::Inp)?;
/// assert!(String::from_utf8_lossy(&file).contains("*ELEMENT, TYPE=C3D8"));
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn cells_file(design: &Design, part: usize, options: &CellsOptions, format: CellsFormat) -> Result<Vec<u8>> {
    Solution::of(design).cells_file(part, options, format)
}

impl Solution {
    /// As [`cells_file`].
    ///
    /// # Errors
    /// As [`cells_file`].
    pub fn cells_file(&self, part: usize, options: &CellsOptions, format: CellsFormat) -> Result<Vec<u8>> {
        let mut cells = self.cells(part, options)?;
        let millimetres = self.design().unit().millimetres();
        cells.positions.iter_mut().for_each(|x| *x *= millimetres);
        let title = self.design().title().unwrap_or("Pasu");
        let text = match format {
            CellsFormat::Vtu => vtu::write(&cells),
            CellsFormat::Msh => msh::write(&cells),
            CellsFormat::Inp => inp::write(&cells, title),
        };
        Ok(text.into_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interior::{CellShape, Cells};

    const CONE: &str = r#"{ "pasu": 1, "title": "Cone\n*ELEMENT", "parts": [{ "shape": { "kind": "blend", "start": { "form": "disc", "radius": [1, 1], "z": 0, "taper": 1, "dz": 2 },
        "end": { "form": "disc", "radius": [2, 2], "z": 2, "taper": 0.5, "dz": 2 } } }] }"#;

    fn file(shape: CellShape, format: CellsFormat) -> (Cells, String) {
        let design = Design::parse(&CONE.replace("\\n", " ")).unwrap();
        let options = CellsOptions { counts: [2, 8, 3], shape };
        let file = cells_file(&design, 0, &options, format).unwrap();
        (crate::interior::cells(&design, 0, &options).unwrap(), String::from_utf8(file).unwrap())
    }

    #[test]
    fn every_format_has_all_points_and_cells() {
        for shape in [CellShape::Hexahedron, CellShape::Tetrahedron] {
            let n = shape.n_corners();
            let (cells, text) = file(shape, CellsFormat::Vtu);
            assert!(text.contains(&format!(
                "NumberOfPoints=\"{}\" NumberOfCells=\"{}\"",
                cells.n_points(),
                cells.n_cells()
            )));
            let array = |name: &str| {
                let from = text.split(&format!("Name=\"{name}\"")).nth(1).unwrap();
                let from = from.split_once('>').unwrap().1;
                from.split("</DataArray>")
                    .next()
                    .unwrap()
                    .split_whitespace()
                    .map(|x| x.parse().unwrap())
                    .collect::<Vec<f64>>()
            };
            let expected: Vec<f64> = cells.positions.iter().map(|x| 10.0 * x).collect();
            assert_eq!(array("points"), expected);
            assert_eq!(array("connectivity"), cells.corners.iter().map(|x| f64::from(*x)).collect::<Vec<f64>>());
            assert_eq!(array("offsets").last(), Some(&((n * cells.n_cells()) as f64)));
            assert_eq!(array("scaled_jacobian"), cells.quality);

            let (_, text) = file(shape, CellsFormat::Msh);
            let section = |name: &str| {
                let from = text.split(&format!("${name}\n")).nth(1).unwrap();
                from.split(&format!("$End{name}")).next().unwrap().lines().map(str::to_owned).collect::<Vec<String>>()
            };
            assert_eq!(section("Nodes").len(), cells.n_points() + 1);
            let elements = section("Elements");
            assert_eq!((elements[0].clone(), elements.len()), (cells.n_cells().to_string(), cells.n_cells() + 1));
            let first: Vec<u32> = elements[1].split(' ').skip(5).map(|x| x.parse().unwrap()).collect();
            assert_eq!(first, cells.cell(0).iter().map(|x| x + 1).collect::<Vec<u32>>());

            let (_, text) = file(shape, CellsFormat::Inp);
            assert_eq!(text.lines().filter(|line| line.starts_with('*')).count(), 3);
            assert_eq!(text.lines().count(), 4 + cells.n_points() + cells.n_cells());
            assert!(text.contains(&format!("TYPE=C3D{n}")));
        }
    }
}
