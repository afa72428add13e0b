//! The crate four-bar on one path: reads points, a line "x y" each, from standard input; prints the evaluations, then its best linkage's
//! coupler curve, a line "x y" each.
//!
//! usage: four-bar-peer closed|open|partial GENERATIONS POPULATION SEED
use four_bar::mech::CurveGen;
use four_bar::{mh, syn, FourBar};
use std::io::Read;
use std::sync::atomic::{AtomicUsize, Ordering};

const PLACES: usize = 7200;

/// The crate's task, with a counter.
struct Counted<'a>(syn::FbSyn, &'a AtomicUsize);

impl mh::Bounded for Counted<'_> {
    fn bound(&self) -> &[[f64; 2]] {
        self.0.bound()
    }
}

impl mh::ObjFunc for Counted<'_> {
    type Ys = mh::WithProduct<f64, FourBar>;
    fn fitness(&self, xs: &[f64]) -> Self::Ys {
        self.1.fetch_add(1, Ordering::Relaxed);
        self.0.fitness(xs)
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mode = match arguments[0].as_str() {
        "closed" => syn::Mode::Closed,
        "open" => syn::Mode::Open,
        _ => syn::Mode::Partial,
    };
    let generations: u64 = arguments[1].parse().expect("generations");
    let population: usize = arguments[2].parse().expect("population");
    let seed: u64 = arguments[3].parse().expect("seed");
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).expect("points");
    let points: Vec<[f64; 2]> = text
        .lines()
        .map(|line| {
            let mut figures = line.split_whitespace().map(|word| word.parse().expect("a number"));
            [figures.next().expect("x"), figures.next().expect("y")]
        })
        .collect();
    let looked = AtomicUsize::new(0);
    let solver = mh::Solver::build(
        mh::De::default(),
        Counted(syn::FbSyn::from_curve(points, mode), &looked),
    )
    .task(|ctx| ctx.gen >= generations)
    .pop_num(population)
    .seed(seed)
    .solve();
    let best: FourBar = solver.into_result();
    println!("{}", looked.load(Ordering::Relaxed));
    for [x, y] in CurveGen::curve(&best, PLACES) {
        println!("{x} {y}");
    }
}
