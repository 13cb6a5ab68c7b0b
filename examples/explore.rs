//! Explore.
use directrix::document::*;
use directrix::matching::*;
use std::time::Instant;
fn main() {
    for name in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&name).unwrap();
        let name = name.rsplit('/').next().unwrap();
        let Ok(document) = read_text(&text) else {
            println!("{name}: refused");
            continue;
        };
        let Ok(model) = Model::new(document) else {
            println!("{name}: no model");
            continue;
        };
        let Ok(curves) = <[_; 2]>::try_from(model.curves().to_vec()) else { continue };
        let t = Instant::now();
        let mut job = Refine::new(curves.clone(), model.weights(), model.gap());
        let mut worst = 0.0_f64;
        let mut last = Instant::now();
        let r = loop {
            if let Some(r) = job.step(&mut || {
                worst = worst.max(last.elapsed().as_secs_f64());
                last = Instant::now();
                false
            }) {
                break r;
            }
        };
        let t1 = t.elapsed();
        println!(
            "{name}: {:?} in {:.1} ms, worst step {:.1} ms",
            r.as_ref().map(|r| (r.integral, r.change, r.count)),
            t1.as_secs_f64() * 1e3,
            worst * 1e3
        );
        let Some(r) = r else { continue };
        for n in [3, 44usize, 200, 1000] {
            let t = Instant::now();
            let places = even_places(&curves, &r.problem, &r.places, n, 1.0 / r.count as f64);
            let t1 = t.elapsed();
            let mut job = Placing::new(&curves, &r.problem, &places);
            let o = loop {
                if let Some(o) = job.step(&mut || true) {
                    break o;
                }
            };
            println!(
                "   {n}: J {:.7} gap {:.2e} eta {:?} crossings {} blocked {} failed {:?} in {:.1} + {:.1} ms",
                o.totals.integral.unwrap(),
                1.0 - o.totals.integral.unwrap() / r.integral,
                o.totals.eta,
                o.totals.crossings,
                o.totals.blocked,
                o.verified.iter().enumerate().filter(|v| !v.1).map(|v| v.0).take(12).collect::<Vec<_>>(),
                t1.as_secs_f64() * 1e3,
                (t.elapsed() - t1).as_secs_f64() * 1e3
            );
        }
    }
}
