//! A small picture of the bodies, drawn without a graphics card: the same pixels on every machine.

use glam::{DVec2, DVec3};

use super::contents::Body;
use super::material::{Material, srgb};
use super::png::png;
use super::shading::{Shaded, shaded};

/// Pixels along a side of the picture.
pub(super) const SIDE: usize = 256;
/// Samples along a side of a pixel.
const SAMPLES: usize = 2;
/// Samples along a side of the picture.
const FINE: usize = SIDE * SAMPLES;
/// What the bodies fill of the picture.
const FILL: f64 = 0.88;

/// From the bodies to the eye, a little from above; the light comes from the upper left, the second one from the right. None is a unit vector yet.
const TO_EYE: DVec3 = DVec3::new(0.35, -1.0, 0.42);
const TO_LIGHT: DVec3 = DVec3::new(-0.75, -0.8, 1.2);
const TO_SECOND_LIGHT: DVec3 = DVec3::new(1.0, -0.35, 0.25);

/// A PNG of `SIDE` by `SIDE` pixels, transparent round the bodies: parallel projection, two lights and the sky, a highlight as the glaze is rough.
pub(super) fn thumbnail(bodies: &[Body]) -> Vec<u8> {
    let back = TO_EYE.normalize();
    let right = DVec3::Z.cross(back).normalize();
    let up = back.cross(right);
    let seen = |p: DVec3| DVec3::new(p.dot(right), p.dot(up), p.dot(back));

    let mut low = DVec2::INFINITY;
    let mut high = DVec2::NEG_INFINITY;
    for body in bodies {
        for position in body.positions.chunks_exact(3) {
            let at = seen(DVec3::new(position[0].into(), position[1].into(), position[2].into())).truncate();
            low = low.min(at);
            high = high.max(at);
        }
    }
    let size = (high - low).max_element();
    let mut samples = vec![Sample { depth: f64::NEG_INFINITY, colour: [0.0; 3] }; FINE * FINE];
    if size > 0.0 && size.is_finite() {
        let scale = FILL * FINE as f64 / size;
        let middle = (low + high) / 2.0;
        for body in bodies {
            let lights: Vec<Light> = body.looks().into_iter().map(|look| Light::on(Material::of(look), back)).collect();
            let look_of = body.look_of();
            let light = |triangle: usize| &lights[look_of(triangle)];
            draw(&shaded(body), light, &mut samples, |p| {
                let at = seen(p);
                let half = FINE as f64 / 2.0;
                DVec3::new((at.x - middle.x) * scale + half, half - (at.y - middle.y) * scale, at.z)
            });
        }
    }
    png(SIDE, &pixels(&samples))
}

#[derive(Clone, Copy)]
struct Sample {
    /// How near, along the line of sight.
    depth: f64,
    /// Linear.
    colour: [f64; 3],
}

/// What falls on a material and comes back to the eye.
struct Light {
    material: Material,
    to_light: DVec3,
    to_second: DVec3,
    halfway: DVec3,
    /// The sharpness and the strength of the highlight.
    highlight: (f64, f64),
}

impl Light {
    fn on(material: Material, to_eye: DVec3) -> Light {
        let to_light = TO_LIGHT.normalize();
        let sharpness = 4.0 + 60.0 * (1.0 - material.roughness) * (1.0 - material.roughness);
        Light {
            material,
            to_light,
            to_second: TO_SECOND_LIGHT.normalize(),
            halfway: (to_light + to_eye).normalize(),
            highlight: (sharpness, 0.5 * (1.0 - material.roughness)),
        }
    }

    fn colour(&self, normal: DVec3) -> [f64; 3] {
        let sky = 0.22 + 0.14 * normal.z;
        let key = 0.85 * normal.dot(self.to_light).max(0.0);
        let second = 0.18 * normal.dot(self.to_second).max(0.0);
        let (sharpness, strength) = self.highlight;
        let gloss = strength * libm::pow(normal.dot(self.halfway).max(0.0), sharpness);
        self.material.colour.map(|colour| colour * (sky + key + second) + gloss)
    }
}

/// Draws triangles into samples, nearest first; `place` tells where a point is in samples, from the upper left, and how near.
fn draw<'a>(body: &Shaded, light: impl Fn(usize) -> &'a Light, samples: &mut [Sample], place: impl Fn(DVec3) -> DVec3) {
    let vector = |list: &[f32], index: usize| {
        DVec3::new(list[3 * index].into(), list[3 * index + 1].into(), list[3 * index + 2].into())
    };
    let n = body.positions.len() / 3;
    let places: Vec<DVec3> = (0..n).map(|index| place(vector(&body.positions, index))).collect();
    for (number, triangle) in body.indices.chunks_exact(3).enumerate() {
        let corners = [triangle[0] as usize, triangle[1] as usize, triangle[2] as usize];
        let [a, b, c] = corners.map(|corner| places[corner]);
        // Rows count downwards, so that what faces the eye turns clockwise.
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if !(area < 0.0) {
            continue;
        }
        let [na, nb, nc] = corners.map(|corner| vector(&body.normals, corner));
        let low = a.min(b).min(c);
        let high = a.max(b).max(c);
        let inside = |x: f64| libm::ceil(x - 0.5).clamp(0.0, FINE as f64) as usize;
        for row in inside(low.y)..inside(high.y) {
            for column in inside(low.x)..inside(high.x) {
                let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
                let to_a = ((b.x - x) * (c.y - y) - (b.y - y) * (c.x - x)) / area;
                let to_b = ((c.x - x) * (a.y - y) - (c.y - y) * (a.x - x)) / area;
                let to_c = 1.0 - to_a - to_b;
                if to_a < 0.0 || to_b < 0.0 || to_c < 0.0 {
                    continue;
                }
                let depth = to_a * a.z + to_b * b.z + to_c * c.z;
                let sample = &mut samples[row * FINE + column];
                if depth > sample.depth {
                    let normal = (to_a * na + to_b * nb + to_c * nc).normalize_or_zero();
                    *sample = Sample { depth, colour: light(number).colour(normal) };
                }
            }
        }
    }
}

/// Means of samples, as sRGB and coverage.
fn pixels(samples: &[Sample]) -> Vec<[u8; 4]> {
    let mut pixels = Vec::with_capacity(SIDE * SIDE);
    for row in 0..SIDE {
        for column in 0..SIDE {
            let mut sum = [0.0; 3];
            let mut n_covered = 0;
            for i in 0..SAMPLES {
                for j in 0..SAMPLES {
                    let sample = samples[(row * SAMPLES + i) * FINE + column * SAMPLES + j];
                    if sample.depth > f64::NEG_INFINITY {
                        n_covered += 1;
                        for (sum, colour) in sum.iter_mut().zip(sample.colour) {
                            *sum += colour;
                        }
                    }
                }
            }
            let [red, green, blue] = sum.map(|sum| if n_covered > 0 { srgb(sum / f64::from(n_covered)) } else { 0 });
            pixels.push([red, green, blue, (255 * n_covered / (SAMPLES * SAMPLES) as i32) as u8]);
        }
    }
    pixels
}
