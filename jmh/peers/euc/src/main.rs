//! Draws a file of triangles with euc on one thread, and prints one line of JSON.
//!
//!     euc-peer FILE [--side N] [--warm-up SECONDS] [--measure SECONDS] [--picture FILE]
//!
//! Options and output are those of `llvmpipe.c`. euc does not clip, so scenes under perspective are refused.

use euc::rasterizer::{BackfaceCullingDisabled, Triangles};
use euc::{buffer::Buffer2d, Pipeline, Target};
use std::io::Write;
use std::time::{Duration, Instant};

const LEAST_FRAMES: usize = 5;
const ROUNDS: i32 = 2;

type Color = (f32, f32, f32);

struct Scene {
    rounds: bool,
    to_clip: [f32; 16],
    positions: Vec<[f32; 3]>,
    colors: Vec<Color>,
    indices: Vec<u32>,
}

/// The scene with linear colours, or, to compare pictures, with sRGB ones.
struct Drawing<'a, const SRGB: bool>(&'a Scene);

impl<'a, const SRGB: bool> Pipeline for Drawing<'a, SRGB> {
    type Vertex = u32;
    type VsOut = Color;
    type Pixel = u32;

    #[inline(always)]
    fn vert(&self, vertex: &u32) -> ([f32; 4], Color) {
        let [x, y, z] = self.0.positions[*vertex as usize];
        let m = &self.0.to_clip;
        let row = |i: usize| m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i];
        ([row(0), row(1), row(2), row(3)], self.0.colors[*vertex as usize])
    }

    #[inline(always)]
    fn frag(&self, color: &Color) -> u32 {
        let (red, green, blue) = if self.0.rounds { rounds(*color) } else { *color };
        let byte = |c: f32| {
            let c = if SRGB { encode(c) } else { c };
            (c.max(0.0).min(1.0) * 255.0 + 0.5) as u32
        };
        0xFF00_0000 | byte(blue) << 16 | byte(green) << 8 | byte(red)
    }
}

/// The formula of `RoundsShader.java`.
#[inline(always)]
fn rounds((red, green, blue): Color) -> Color {
    let (mut x, mut y) = (red, green);
    for _ in 0..64 {
        let s = 0.5 * x + 0.3 * y - 0.4 * blue;
        let t = 0.4 * y - 0.5 * x + 0.3 * blue;
        x = 0.5 * red + 0.5 * wave(s);
        y = 0.5 * green + 0.5 * wave(t);
    }
    (0.25 + 0.75 * x, 0.25 + 0.75 * y, blue)
}

#[inline(always)]
fn wave(t: f32) -> f32 {
    let q = t * t;
    t * (1.0 - q * (0.16666667 - q * (0.008333333 - q * 0.0001984127)))
}

fn encode(linear: f32) -> f32 {
    if linear <= 0.0031308 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

fn read(file: &str) -> Scene {
    let bytes = std::fs::read(file).expect("the file of triangles cannot be read");
    assert!(bytes.starts_with(b"LZTRI001"), "not a file of triangles");
    let int = |at: usize| i32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let float = |at: usize| f32::from_bits(int(at) as u32);
    assert_eq!(int(12), 0, "euc does not clip: a scene without perspective is needed");
    let (vertices, indices) = (int(16) as usize, int(20) as usize);
    let mut to_clip = [0.0; 16];
    for i in 0..16 {
        to_clip[i] = float(24 + 4 * i);
    }
    let at = |vertex: usize| 88 + 16 * vertex;
    let color = |byte: u8| byte as f32 / 255.0;
    Scene {
        rounds: int(8) == ROUNDS,
        to_clip,
        positions: (0..vertices).map(|v| [float(at(v)), float(at(v) + 4), float(at(v) + 8)]).collect(),
        colors: (0..vertices)
            .map(|v| (color(bytes[at(v) + 12]), color(bytes[at(v) + 13]), color(bytes[at(v) + 14])))
            .collect(),
        indices: match indices {
            0 => (0..vertices as u32).collect(),
            n => (0..n).map(|i| int(at(vertices) + 4 * i) as u32).collect(),
        },
    }
}

fn draw<const SRGB: bool>(scene: &Scene, color: &mut Buffer2d<u32>, depth: &mut Buffer2d<f32>) -> f64 {
    let start = Instant::now();
    color.clear(0);
    depth.clear(1.0);
    Drawing::<SRGB>(scene).draw::<Triangles<_, BackfaceCullingDisabled>, _>(&scene.indices, color, Some(depth));
    start.elapsed().as_secs_f64() * 1e3
}

fn main() {
    let mut options = std::collections::HashMap::new();
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().expect("give a file of triangles");
    while let Some(name) = arguments.next() {
        options.insert(name, arguments.next().expect("an option has no value"));
    }
    let number = |name: &str, otherwise: f64| options.get(name).map_or(otherwise, |v| v.parse().expect("a number"));
    let side = number("--side", 1024.0) as usize;
    let scene = read(&file);
    let mut color = Buffer2d::new([side, side], 0u32);
    let mut depth = Buffer2d::new([side, side], 1.0f32);

    if let Some(picture) = options.get("--picture") {
        draw::<true>(&scene, &mut color, &mut depth);
        let mut out = std::io::BufWriter::new(std::fs::File::create(picture).expect("the picture cannot be written"));
        for pixel in color.as_ref() {
            out.write_all(&pixel.to_le_bytes()).expect("the picture cannot be written");
        }
        println!("{{\"covered\":{}}}", color.as_ref().iter().filter(|pixel| **pixel != 0).count());
        return;
    }

    let first = draw::<false>(&scene, &mut color, &mut depth);
    let warm = Instant::now() + Duration::from_secs_f64(number("--warm-up", 1.0));
    while Instant::now() < warm {
        draw::<false>(&scene, &mut color, &mut depth);
    }
    let mut times = Vec::new();
    let end = Instant::now() + Duration::from_secs_f64(number("--measure", 4.0));
    while times.len() < LEAST_FRAMES || Instant::now() < end {
        times.push(draw::<false>(&scene, &mut color, &mut depth));
    }
    times.sort_by(f64::total_cmp);
    let n = times.len();
    println!(
        "{{\"median\":{:.4},\"q1\":{:.4},\"q3\":{:.4},\"min\":{:.4},\"max\":{:.4},\"first\":{first:.2},\"frames\":{n},\"version\":\"0.5.3\"}}",
        times[n / 2], times[n / 4], times[3 * n / 4], times[0], times[n - 1]
    );
}
