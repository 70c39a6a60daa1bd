//! One side of the skin of a blend.

use glam::DVec3;

use super::function::Function;
use crate::patch::{Breaks, Cell, Patch, Row, Side, Suprema, SurfaceJet};
use crate::surface::{most_of_many, multiples};

/// `X(u, v) = sum by f(u) g(v)`: what a volume is where one of its parameters is held.
#[derive(Debug, Clone)]
pub(super) struct Sheet {
    terms: Vec<(DVec3, [usize; 2])>,
    functions: [Vec<Function>; 2],
    sides: [Side; 4],
    /// Whether all of it lies in one plane.
    is_level: bool,
    /// Where many functions of `v` are waves that go round whole times: how often the fastest does.
    most_turns: Option<usize>,
}

impl Sheet {
    /// The sum of these. Polynomials of one axis that are multiplied by the same are added up first: what cancels between the sections would else count twice in every bound.
    pub(super) fn new(sum: impl IntoIterator<Item = (DVec3, [Function; 2])>) -> Sheet {
        let mut sheet = Sheet {
            terms: Vec::new(),
            functions: Default::default(),
            sides: [Side::Free; 4],
            is_level: false,
            most_turns: None,
        };
        let terms: Vec<(DVec3, [Function; 2])> = sum.into_iter().collect();
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            let of_axis = terms.iter().map(|(by, functions)| (by.dot(axis), functions.clone()));
            let used = of_axis.filter(|(by, [along, across])| *by != 0.0 && !along.is_zero() && !across.is_zero());
            for (by, [along, across]) in added(added(used.collect(), 1), 0) {
                if !along.is_zero() && !across.is_zero() {
                    let of = [sheet.number(0, along), sheet.number(1, across)];
                    sheet.terms.push((axis * by, of));
                }
            }
        }
        sheet.most_turns = most_of_many(sheet.functions[1].iter().filter_map(Function::whole_turns));
        sheet
    }

    fn number(&mut self, parameter: usize, function: Function) -> usize {
        let functions = &mut self.functions[parameter];
        functions.iter().position(|known| *known == function).unwrap_or_else(|| {
            functions.push(function);
            functions.len() - 1
        })
    }

    /// The same with what its sides meet.
    pub(super) fn between(self, sides: [Side; 4]) -> Sheet {
        Sheet { sides, ..self }
    }

    /// The same as one that lies in a plane.
    pub(super) fn level(self) -> Sheet {
        Sheet { is_level: true, ..self }
    }

    /// Whether the corners of a cell, seen along the axis, go round a convex quadrilateral; some of them may be one point.
    fn is_convex(&self, Cell { u, v }: Cell) -> bool {
        let corners = [(u[0], v[0]), (u[1], v[0]), (u[1], v[1]), (u[0], v[1])];
        let corners = corners.map(|(u, v)| self.jet(u, v).position.truncate());
        let turn = |i: usize| {
            let [from, at, to] = [0, 1, 2].map(|step| corners[(i + step) % 4]);
            (at - from).perp_dot(to - at)
        };
        let turns = [0, 1, 2, 3].map(turn);
        turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
    }

    /// The largest coordinate that the terms can add up to.
    pub(super) fn size(&self) -> f64 {
        self.terms.iter().map(|(by, _)| by.abs().max_element()).sum()
    }

    /// How far it is from the same all along one parameter, where the other has this value; all over where it has none.
    pub(super) fn extent(&self, along: usize, at: Option<f64>) -> f64 {
        let other = 1 - along;
        let mut sums = vec![DVec3::ZERO; self.functions[along].len()];
        for (by, of) in &self.terms {
            let function = &self.functions[other][of[other]];
            match at {
                Some(x) => sums[of[along]] += *by * function.jet::<1>(x)[0],
                None => sums[of[along]] += by.abs() * function.suprema::<1>([0.0, 1.0])[0],
            }
        }
        let moves = sums.iter().zip(&self.functions[along]).filter(|(_, function)| !function.is_constant());
        moves.map(|(sum, _)| sum.abs().max_element()).sum()
    }
}

/// The same sum with the polynomials of one parameter added up that are multiplied by the same function of the other.
fn added(terms: Vec<(f64, [Function; 2])>, parameter: usize) -> Vec<(f64, [Function; 2])> {
    let mut sums: Vec<(f64, [Function; 2])> = Vec::with_capacity(terms.len());
    for (by, functions) in terms {
        let Function::Cubic(more) = &functions[parameter] else {
            sums.push((by, functions));
            continue;
        };
        let more = more.map(|c| by * c);
        let other = &functions[1 - parameter];
        let is_same = |(_, known): &&mut (f64, [Function; 2])| {
            matches!(known[parameter], Function::Cubic(_)) && known[1 - parameter] == *other
        };
        match sums.iter_mut().find(is_same) {
            Some((_, known)) => {
                if let Function::Cubic(sum) = &mut known[parameter] {
                    sum.iter_mut().zip(more).for_each(|(sum, c)| *sum += c);
                }
            }
            None => {
                let mut functions = functions;
                functions[parameter] = Function::Cubic(more);
                sums.push((1.0, functions));
            }
        }
    }
    sums
}

/// A row of a sheet.
struct SheetRow<'a> {
    sheet: &'a Sheet,
    /// What each function of `v` is multiplied by, with its derivatives in `u`.
    by: Vec<[DVec3; 3]>,
}

impl Row for SheetRow<'_> {
    fn length(&self) -> f64 {
        1.0
    }

    fn jet(&self, v: f64) -> SurfaceJet {
        let mut jet = SurfaceJet::default();
        let turns = self.sheet.most_turns.map_or_else(Vec::new, |most| multiples(v, most));
        for ([value, u, uu], function) in self.by.iter().zip(&self.sheet.functions[1]) {
            let [g, g_v, g_vv] = function.jet_by::<3>(v, &turns);
            jet.position += *value * g;
            jet.du += *u * g;
            jet.dv += *value * g_v;
            jet.duu += *uu * g;
            jet.duv += *u * g_v;
            jet.dvv += *value * g_vv;
        }
        jet
    }
}

impl Patch for Sheet {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        self.row(u).jet(v)
    }

    fn row(&self, u: f64) -> Box<dyn Row + '_> {
        let along: Vec<[f64; 3]> = self.functions[0].iter().map(|function| function.jet(u)).collect();
        let mut by = vec![[DVec3::ZERO; 3]; self.functions[1].len()];
        for (factor, [f, g]) in &self.terms {
            for (sum, value) in by[*g].iter_mut().zip(along[*f]) {
                *sum += *factor * value;
            }
        }
        Box::new(SheetRow { sheet: self, by })
    }

    /// The suprema of all terms added up, axis by axis.
    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        let of = |parameter: usize, interval: [f64; 2]| -> Vec<[f64; 3]> {
            self.functions[parameter].iter().map(|function| function.suprema(interval)).collect()
        };
        let (along, across) = (of(0, cell.u), of(1, cell.v));
        let mut sums = [DVec3::ZERO; 4];
        for (by, [f, g]) in &self.terms {
            let (u, v) = (along[*f], across[*g]);
            for (sum, bound) in sums.iter_mut().zip([u[0] * v[0], u[2] * v[0], u[1] * v[1], u[0] * v[2]]) {
                // A term whose bound is 0 adds nothing, however large it is.
                if bound != 0.0 {
                    *sum += by.abs() * bound;
                }
            }
        }
        let stretch = DVec3::from_array(stretch);
        let [size, uu, uv, vv] = sums.map(|sum| (sum * stretch).length());
        Suprema { size, uu, uv, vv }
    }

    /// In a plane the two triangles of a cell are all of the quadrilateral of its corners, if that is convex, and so are the chords of one parameter for every value of the other, in which the sheet is straight: what matters is how far
    /// arcs are from these, not where on a chord a point is.
    fn deviation_by(&self, cell: Cell, suprema: &Suprema) -> f64 {
        let is_straight = suprema.uu == 0.0 || suprema.vv == 0.0;
        if !(self.is_level && is_straight && self.is_convex(cell)) {
            return suprema.deviation(cell.lengths());
        }
        Suprema { uv: 0.0, ..*suprema }.deviation(cell.lengths())
    }

    fn is_alike_round(&self) -> bool {
        let is_wave = |function: &Function| matches!(function, Function::Cosine(_) | Function::Sine(_));
        self.functions[1].iter().all(|function| is_wave(function) || function.is_constant())
    }

    fn n_terms(&self) -> usize {
        self.functions[1].len()
    }

    fn breaks(&self) -> [Breaks; 2] {
        [0, 1].map(|parameter| {
            let waves = self.functions[parameter].iter().map(Function::waves);
            let (waves, rate) = waves.fold((0.5f64, 0.0f64), |most, next| (most.0.max(next.0), most.1.max(next.1)));
            Breaks { rate, ..Breaks::smooth(waves) }
        })
    }

    fn sides(&self) -> [Side; 4] {
        self.sides
    }
}
