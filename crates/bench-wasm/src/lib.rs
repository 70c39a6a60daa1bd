//! The solver inside WebAssembly, called so many times in a row that a call from JavaScript costs nothing. Never shipped.

#![cfg_attr(target_arch = "wasm32", warn(missing_docs))]

use std::hint::black_box;

use bench::designs;
use bench::finite_difference::{Fourier, Problem};
use js_sys::Float32Array;
use pasu::{BoundaryValue, Design, Hand, MeshOptions, Sampler, Solution, Surface};
use wasm_bindgen::prelude::*;

/// A design, parsed once, with the arrays that its samples are written to.
#[wasm_bindgen]
pub struct Subject {
    design: Design,
    shape: BoundaryValue,
    sampler: Sampler,
    positions: Float32Array,
    normals: Float32Array,
}

#[wasm_bindgen]
impl Subject {
    /// Reads a design.
    ///
    /// # Errors
    /// When it is none.
    #[wasm_bindgen(constructor)]
    pub fn new(design: &str) -> Result<Subject, JsError> {
        let design = Design::parse(design)?;
        let shape = designs::shape(&design);
        let empty = || Float32Array::new_with_length(0);
        Ok(Subject { design, shape, sampler: Sampler::new(), positions: empty(), normals: empty() })
    }

    /// Solves and samples so many times, into the same memory.
    ///
    /// # Errors
    /// When the design cannot be solved or sampled.
    pub fn sample(&mut self, rows: usize, columns: usize, times: usize) -> Result<(), JsError> {
        let options = MeshOptions { rows: Some(rows), columns: Some(columns), ..MeshOptions::default() };
        for _ in 0..times {
            black_box(self.sampler.sample(&self.design, &options)?);
        }
        Ok(())
    }

    /// Samples once and keeps copies of what came out.
    ///
    /// # Errors
    /// As [`Subject::sample`].
    pub fn show(&mut self, rows: usize, columns: usize) -> Result<(), JsError> {
        let options = MeshOptions { rows: Some(rows), columns: Some(columns), ..MeshOptions::default() };
        let mesh = self.sampler.sample(&self.design, &options)?;
        self.positions = Float32Array::from(mesh.positions.as_slice());
        self.normals = Float32Array::from(mesh.normals.as_slice());
        Ok(())
    }

    /// The positions that were shown.
    #[wasm_bindgen(getter)]
    pub fn positions(&self) -> Float32Array {
        self.positions.clone()
    }

    /// The normals that were shown.
    #[wasm_bindgen(getter)]
    pub fn normals(&self) -> Float32Array {
        self.normals.clone()
    }

    /// Solves so many times.
    ///
    /// # Errors
    /// When the design cannot be solved.
    pub fn solve(&self, times: usize) -> Result<(), JsError> {
        for _ in 0..times {
            black_box(Surface::solve(&self.shape, "shape")?);
        }
        Ok(())
    }
}

/// A network of 10,000 patches with its middle here or there, which the other one is each time.
#[wasm_bindgen]
pub struct Network {
    designs: [Design; 2],
    next: usize,
    last: Option<Solution>,
    sampler: Sampler,
}

#[wasm_bindgen]
impl Network {
    /// Makes it.
    ///
    /// # Errors
    /// When it is no design.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Result<Network, JsError> {
        let design = |lift| designs::network(designs::NETWORK, lift);
        Ok(Network { designs: [design(0.0)?, design(0.01)?], next: 0, last: None, sampler: Sampler::new() })
    }

    /// Solves it so many times, as a whole or the strips that have to be alone, and samples it or not.
    ///
    /// # Errors
    /// When it cannot be solved or sampled.
    pub fn run(&mut self, after: bool, sample: bool, times: usize) -> Result<(), JsError> {
        let options = MeshOptions { tolerance: Some(designs::NETWORK_TOLERANCE), ..MeshOptions::default() };
        for _ in 0..times {
            self.next = 1 - self.next;
            let design = &self.designs[self.next];
            let solution = match &self.last {
                Some(last) if after => last.after(design),
                _ => Solution::of(design),
            };
            let solution = self.last.insert(designs::solved(solution)?);
            if sample {
                black_box(self.sampler.sample_solution(solution, &options)?);
            }
        }
        Ok(())
    }
}

/// A hand that pulls a point of a design's first part by a fifth of a unit along `x`.
#[wasm_bindgen]
pub struct Pulled {
    design: Design,
    hand: Hand,
}

#[wasm_bindgen]
impl Pulled {
    /// Reads a design, and takes hold of its point at `u`.
    ///
    /// # Errors
    /// When it is none.
    #[wasm_bindgen(constructor)]
    pub fn new(design: &str, u: f64) -> Result<Pulled, JsError> {
        const V: f64 = 0.3;
        let design = Design::parse(design)?;
        let from = pasu::evaluate(&design, 0, &[u, V])?;
        let hand = Hand { width: Some(1.0), ..Hand::new([u, V], [from[0] + 0.2, from[1], from[2]]) };
        Ok(Pulled { design, hand })
    }

    /// Pulls so many times.
    ///
    /// # Errors
    /// When it cannot be pulled.
    pub fn pull(&self, times: usize) -> Result<(), JsError> {
        for _ in 0..times {
            black_box(pasu::pull(&self.design, 0, &self.hand)?);
        }
        Ok(())
    }
}

/// Finite differences of a design's problem: a Fourier transform round the axis and band matrices along the profile.
#[wasm_bindgen]
pub struct Baseline {
    shape: BoundaryValue,
    problem: Problem,
    fourier: Fourier,
}

#[wasm_bindgen]
impl Baseline {
    /// Prepares a grid.
    ///
    /// # Errors
    /// When the text is no design.
    #[wasm_bindgen(constructor)]
    pub fn new(design: &str, rows: usize, columns: usize) -> Result<Baseline, JsError> {
        let shape = designs::shape(&Design::parse(design)?);
        let (problem, fourier) = (Problem::new(&shape, rows, columns), Fourier::new(rows, columns));
        Ok(Baseline { shape, problem, fourier })
    }

    /// How far the solution is from the closed form, in any coordinate.
    ///
    /// # Errors
    /// When the design cannot be solved.
    pub fn error(&mut self) -> Result<f64, JsError> {
        let surface = Surface::solve(&self.shape, "shape")?;
        Ok(self.problem.error(&surface, self.fourier.solve(&self.problem)))
    }

    /// Solves so many times.
    pub fn solve(&mut self, times: usize) {
        for _ in 0..times {
            black_box(self.fourier.solve(&self.problem));
        }
    }
}

/// Memory to be filled.
#[wasm_bindgen]
pub struct Memory {
    bytes: Vec<u8>,
}

#[wasm_bindgen]
impl Memory {
    /// So many bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: usize) -> Memory {
        Memory { bytes: vec![1; bytes] }
    }

    /// Fills all of it so many times, by the instruction `memory.fill`.
    pub fn fill(&mut self, times: usize) {
        for _ in 0..times {
            black_box(self.bytes.as_mut_slice()).fill(0);
        }
    }
}
