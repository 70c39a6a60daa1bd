//! Random designs with walls: what a person could ask for, and some of what nobody would.

use std::f64::consts::PI;

/// How many are drawn: so many as a rule, and so many where nobody waits for the answer, as before a release, which is said by `POTS=400`.
pub(crate) fn drawn(by_hand: u64, unattended: u64) -> u64 {
    if std::env::var_os("POTS").is_some() { unattended } else { by_hand }
}

/// Marsaglia's xorshift: the same numbers on every machine.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub(crate) fn between(&mut self, from: f64, to: f64) -> f64 {
        let x = from + (to - from) * (self.next() >> 11) as f64 / (1u64 << 53) as f64;
        // Few digits, as people write them.
        (x * 1e4).round() / 1e4
    }

    pub(crate) fn whole(&mut self, from: u64, to: u64) -> u64 {
        from + self.next() % (to - from + 1)
    }

    pub(crate) fn chance(&mut self, one_in: u64) -> bool {
        self.next().is_multiple_of(one_in)
    }

    /// A design of one part of about ten units.
    pub(crate) fn design(&mut self) -> String {
        let shape = match self.whole(0, 5) {
            0 => self.second_order(),
            1 => self.mixed_order(),
            2 | 3 => self.fourth_order(),
            4 => self.bloor_wilson(),
            _ => self.boundary_value(),
        };
        let (wall, place) = (self.wall(), self.place());
        format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall}, "place": {place} }}] }}"#)
    }

    fn wall(&mut self) -> String {
        let thickness = self.between(0.1, 0.6);
        let base = if self.chance(6) { 0.0 } else { self.between(0.15, 0.8) };
        let mut wall = format!(r#"{{ "thickness": {thickness}, "base": {base}"#);
        if self.chance(3) {
            wall += r#", "side": "outside""#;
        }
        if self.chance(3) {
            wall += r#", "rim": "rounded""#;
        }
        if base > 0.0 && self.chance(4) {
            wall += &format!(r#", "foot": [{}, {}]"#, self.between(0.2, 0.8), self.between(0.1, 0.6));
        }
        if base > 0.0 && self.chance(4) {
            wall += &format!(r#", "drain": {}"#, self.between(0.4, 1.5));
        }
        wall + " }"
    }

    fn place(&mut self) -> String {
        if self.chance(2) {
            return "{}".into();
        }
        let [x, y, z] = [0; 3].map(|_| self.between(0.7, 1.5));
        let y = if self.chance(4) { -y } else { y };
        let [h, k, l] = [0; 3].map(|_| self.between(-1.0, 1.0));
        let [dx, dy, dz] = [0; 3].map(|_| self.between(-20.0, 20.0));
        let angle = self.between(-PI, PI);
        format!(
            r#"{{ "scale": [{x}, {y}, {z}], "axis": [{h}, {k}, {l}], "angle": {angle}, "shift": [{dx}, {dy}, {dz}] }}"#
        )
    }

    fn second_order(&mut self) -> String {
        let (rim, foot) = (self.between(2.0, 6.0), self.between(2.0, 5.0));
        let petals = self.whole(2, 12);
        let [a, b] = [rim, foot].map(|r| self.between(0.0, 0.5 / petals as f64) * r);
        let (height, t) = (self.between(5.0, 14.0), self.between(0.0, 0.15));
        format!(
            r#"{{ "kind": "second-order", "r": [{rim}, {a}, {foot}, {b}], "n": [1, {}], "t": [{t}, {t}], "height": {height} }}"#,
            petals + 1
        )
    }

    fn mixed_order(&mut self) -> String {
        let (rim, foot) = (self.between(2.0, 6.0), self.between(2.0, 5.0));
        let petals = self.whole(2, 8);
        let [a, b] = [rim, foot].map(|r| self.between(0.0, 0.4 / petals as f64) * r);
        let (height, t) = (self.between(5.0, 14.0), self.between(0.0, 0.1));
        let rise = -height * self.between(0.4, 2.0);
        format!(
            r#"{{ "kind": "mixed-order", "r": [{rim}, {a}, {foot}, {b}], "n": [1, {}], "t": [{t}, {t}], "height": {height}, "rise": {rise} }}"#,
            petals + 1
        )
    }

    fn fourth_order(&mut self) -> String {
        let [r0, r1] = [0; 2].map(|_| self.between(2.0, 5.0));
        let (rm, h1) = (self.between(2.0, 7.0), self.between(6.0, 14.0));
        let [e0, e1] = [0; 2].map(|_| self.between(-0.4, 1.2));
        let [d0, d1] = [0; 2].map(|_| h1 * self.between(0.4, 2.5));
        let [t, w] = [self.between(0.0, 4.0), self.between(0.0, 3.0)];
        format!(
            r#"{{ "kind": "fourth-order", "r0": {r0}, "r1": {r1}, "rm": {rm}, "h1": {h1}, "eta": [{e0}, {}], "dz": [{d0}, {d1}], "s": [1, 1], "t": [{t}, {t}], "w": [{w}, {w}] }}"#,
            -e1
        )
    }

    fn bloor_wilson(&mut self) -> String {
        let a = self.between(0.01, 2.5);
        let [r1, r4] = [0; 2].map(|_| self.between(2.0, 5.0));
        let [r2, r3] = [0; 2].map(|_| r1 * self.between(-0.15, 0.15));
        let [s1, s4] = [0; 2].map(|_| self.between(-6.0, 6.0));
        let h = self.between(6.0, 14.0);
        let (wave, n1) = (self.between(0.0, 0.6), self.whole(1, 6));
        let (up, slope) = (-h * self.between(0.5, 1.5), -self.between(0.0, 1.0));
        format!(
            r#"{{ "kind": "bloor-wilson", "a": {a}, "r": [{r1}, {r2}, {r3}, {r4}], "R": [{s1}, {}, {}, {s4}], "h": [{h}, {wave}], "H": [{up}, {slope}], "n1": {n1} }}"#,
            0.5 * s1,
            0.5 * s1
        )
    }

    /// A profile with petals, that may lean, wave, or begin at a point.
    fn boundary_value(&mut self) -> String {
        let (t, w) = if self.chance(2) { (0.0, 0.0) } else { (self.between(0.0, 2.0), self.between(0.0, 1.0)) };
        let foot = if self.chance(3) { 0.0 } else { self.between(2.0, 4.0) };
        let rim = self.between(2.5, 6.0);
        let (leave, arrive) = (self.between(2.0, 16.0), self.between(-6.0, 8.0));
        let petals = self.whole(2, 9);
        let depth = self.between(0.0, 0.3 / petals as f64) * rim;
        let at_foot = if foot == 0.0 { 0.0 } else { self.between(0.0, 0.2 / petals as f64) * foot };
        let lean = if self.chance(4) { self.between(-2.0, 2.0) } else { 0.0 };
        let round = |part: &str| {
            let data = |sign: f64| format!(r#"{{ "start": {}, "end": {} }}"#, sign * at_foot / 2.0, sign * depth / 2.0);
            // Petals across the outline: cos((n + 1) v) and cos((n - 1) v) for x, with a sign for y.
            let sign = if part == "cos" { 1.0 } else { -1.0 };
            format!(
                r#"{{ "n": 1, "{part}": {{ "start": {foot}, "end": {rim}, "start_u": {leave}, "end_u": {arrive} }} }},
                   {{ "n": {}, "{part}": {} }}, {{ "n": {}, "{part}": {} }}"#,
                petals - 1,
                data(sign),
                petals + 1,
                data(1.0)
            )
        };
        let height = self.between(5.0, 12.0);
        let rise = if foot == 0.0 && self.chance(2) { 0.0 } else { self.between(0.2, 2.0) * height };
        let (waves, wave) = (self.whole(2, 6), if self.chance(3) { self.between(0.0, 0.5) } else { 0.0 });
        let component = |modes: String| format!(r#"{{ "order": 4, "s": 1, "t": {t}, "w": {w}, "modes": [{modes}] }}"#);
        let x = component(format!(r#"{{ "n": 0, "cos": {{ "end": {lean} }} }}, {}"#, round("cos")));
        let y = component(round("sin"));
        let z = component(format!(
            r#"{{ "n": 0, "cos": {{ "end": {height}, "start_u": {rise}, "end_u": {height} }} }}, {{ "n": {waves}, "cos": {{ "end": {wave} }} }}"#
        ));
        format!(r#"{{ "kind": "boundary-value", "span": "2pi", "x": {x}, "y": {y}, "z": {z} }}"#)
    }
}
