//! The normal equations of least squares.

use nalgebra::{DMatrix, DVector};

/// How strongly a solution is drawn to 0 where samples leave it open, in parts of what they say.
const RIDGE: f64 = 1e-12;

/// What is known of some numbers by rows that are given one after the other.
pub(super) struct Normal {
    len: usize,
    /// Row by row, up to the diagonal.
    products: Vec<f64>,
    right: Vec<f64>,
}

impl Normal {
    pub(super) fn new(len: usize) -> Normal {
        Normal { len, products: vec![0.0; len * (len + 1) / 2], right: vec![0.0; len] }
    }

    /// The sum of the numbers, each times its factor in the row, is to be the goal.
    pub(super) fn add(&mut self, row: &[f64], goal: f64) {
        let mut products = &mut self.products[..];
        for (index, (&one, right)) in row.iter().zip(&mut self.right).enumerate() {
            let (here, below) = products.split_at_mut(index + 1);
            products = below;
            *right += one * goal;
            if one != 0.0 {
                here.iter_mut().zip(row).for_each(|(product, other)| *product += one * other);
            }
        }
    }

    /// The numbers with the least sum of squares, some of them given.
    pub(super) fn least(&self, given: &[Option<f64>]) -> Vec<f64> {
        let open: Vec<usize> = (0..self.len).filter(|&number| given[number].is_none()).collect();
        let mut reduced = DMatrix::<f64>::zeros(open.len(), open.len());
        let mut goal = DVector::<f64>::zeros(open.len());
        let scale = open.iter().fold(0.0f64, |most, &i| most.max(self.product(i, i)));
        for (row, &i) in open.iter().enumerate() {
            let known = given.iter().enumerate().filter_map(|(j, given)| given.map(|given| self.product(i, j) * given));
            goal[row] = self.right[i] - known.sum::<f64>();
            for (column, &j) in open.iter().enumerate() {
                reduced[(row, column)] = self.product(i, j);
            }
            reduced[(row, row)] += RIDGE * scale;
        }
        let found = reduced.cholesky().map(|factors| factors.solve(&goal));
        let mut numbers: Vec<f64> = given.iter().map(|given| given.unwrap_or(0.0)).collect();
        if let Some(found) = found {
            for (number, found) in open.iter().zip(found.iter()) {
                numbers[*number] = *found;
            }
        }
        numbers
    }

    fn product(&self, i: usize, j: usize) -> f64 {
        let (row, column) = (i.max(j), i.min(j));
        self.products[row * (row + 1) / 2 + column]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_through_points_is_found_and_keeps_what_is_given() {
        let of = |given: &[Option<f64>]| {
            let mut normal = Normal::new(2);
            for (x, y) in [(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)] {
                normal.add(&[1.0, x], y);
            }
            normal.least(given)
        };
        let [free, held] = [of(&[None, None]), of(&[Some(0.0), None])];
        assert!((free[0] - 1.0).abs() < 1e-9 && (free[1] - 2.0).abs() < 1e-9, "{free:?}");
        // Through the origin: the sum of x y over that of x x.
        assert!(held[0] == 0.0 && (held[1] - 13.0 / 5.0).abs() < 1e-9, "{held:?}");
    }
}
