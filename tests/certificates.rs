//! What exact results certify, checked again by slow plain geometry; and that the optimum does not depend on how curves are drawn.

use crate::support::pairs::Picture;
use crate::support::{list, seeded};
use directrix::document::{Diagnostic, GapKind, Model, Outcome, Solution, Solve, read_text};
use directrix::matching::{Matching, OneToOne, Refine};
use glam::{DVec2, dvec2};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::path::Path;

fn document(curves: [&[DVec2]; 2], counts: [usize; 2], matching: &Value) -> Value {
    let curve = |points: &[DVec2]| json!({"degree": 3, "form": "periodic", "points": list(points)});
    json!({
        "directrix": 1, "kind": "curves", "matching": matching, "sampling": {"counts": counts},
        "curves": curves.map(curve),
    })
}

fn solve(document: &Value) -> Option<Solution> {
    let solution = Solve::run(read_text(&document.to_string()).expect("fields in range")).ok()?;
    matches!(solution.outcome, Outcome::Matched { .. }).then_some(solution)
}

fn parts(solution: &Solution) -> (&Matching, Option<&OneToOne>) {
    let Outcome::Matched { matching, pairs, .. } = &solution.outcome else { panic!("matched") };
    (matching, pairs.as_deref())
}

/// Checks everything that lines and pairs of a result promise.
fn check(solution: &Solution) -> Result<(), TestCaseError> {
    let (model, (matching, pairs)) = (&solution.model, parts(solution));
    if matching.totals.crossings + matching.totals.blocked == 0 {
        prop_assert_eq!(Picture::of_lines(model, &matching.lines).faults(), (vec![], vec![]), "lines");
    }
    if solution.is_complete() {
        let totals = pairs.map_or(&matching.totals, |pairs| &pairs.totals);
        prop_assert_eq!((totals.crossings, totals.blocked), (0, 0));
        prop_assert!(totals.uncovered.iter().all(Vec::is_empty));
    }
    let Some(pairs) = pairs else { return Ok(()) };
    // Ends are where their parameters say.
    for (line, &(u, v)) in pairs.lines.iter().zip(&pairs.places) {
        for (axis, (vertex, u)) in [(line.from, u), (line.to, v)].into_iter().enumerate() {
            let off = pairs.problem.outlines()[axis].points[vertex].distance(model.curves()[axis].point(u));
            prop_assert!(off < 1e-9 * model.bounds().diagonal(), "an end lies off its place by {}", off);
        }
    }
    let (crossed, blocked) = Picture::as_verified(model, pairs).faults();
    for (k, &verified) in pairs.verified.iter().enumerate() {
        let is_bad = blocked.contains(&k) || crossed.iter().any(|&(i, j)| i == k || j == k);
        prop_assert!(!(verified && is_bad), "pair {} is verified: {:?} {:?}", k, crossed, blocked);
    }
    // What they were verified against is the curves.
    for (curve, outline) in model.curves().iter().zip(pairs.problem.outlines()) {
        for &point in outline.points.iter().step_by(7) {
            let off = curve.nearest(point).at.distance(point);
            prop_assert!(off < 1e-9 * model.bounds().diagonal(), "a vertex lies off its curve by {}", off);
        }
    }
    // Strictly monotone, but for pins that share an end and lines kept in a gap, and within one lap.
    let pins = model.pins();
    let is_shared = pins.iter().any(|p| pins.iter().any(|q| (p.0 == q.0) != (p.1 == q.1)));
    let is_kept = |k: usize| pairs.failed.iter().any(|gap| gap.lines.contains(&k));
    let is_back = |(k, w): &(usize, &[(f64, f64)])| {
        let steps = [w[1].0 - w[0].0, w[1].1 - w[0].1];
        let may_share = is_shared || (is_kept(*k) && is_kept(k + 1));
        steps.iter().any(|&step| step < 0.0 || (step == 0.0 && !may_share)) || steps == [0.0, 0.0]
    };
    prop_assert_eq!(pairs.places.windows(2).enumerate().find(is_back), None);
    if let (Some(first), Some(last)) = (pairs.places.first(), pairs.places.last()) {
        let laps = [(first.0, last.0), (first.1, last.1)];
        for (curve, (first, last)) in model.curves().iter().zip(laps) {
            let (lo, hi) = curve.domain();
            let may_share = is_kept(0) && is_kept(pairs.places.len() - 1);
            prop_assert!(
                last - first < (hi - lo) * (1.0 + if may_share { 1e-9 } else { 0.0 }),
                "{first} to {last}"
            );
        }
    }
    prop_assert!(pairs.totals.eta.is_none_or(|eta| eta <= 1.0 + 1e-12));
    Ok(())
}

/// Two closed shapes, one inside the other: stars, or a thick open arc in a ring.
fn shapes() -> impl Strategy<Value = [Vec<DVec2>; 2]> {
    let star = |radii: &[f64]| -> Vec<DVec2> {
        let turn = TAU / radii.len() as f64;
        radii.iter().enumerate().map(|(k, r)| r * DVec2::from_angle(turn * k as f64)).collect()
    };
    let radii = |range: std::ops::Range<f64>| prop::collection::vec(range, 4..12);
    let stars =
        (radii(4.0..16.0), radii(20.0..40.0)).prop_map(move |(inner, outer)| [star(&inner), star(&outer)]);
    let arcs = (10.0..24.0, 1.5..6.0, 0.15..1.6, 5_usize..12, 30.0..60.0, -4.0..4.0).prop_map(
        |(radius, half, gap, count, outer, shift)| {
            let angle = |k: usize| gap + (TAU - 2.0 * gap) * k as f64 / (count - 1) as f64;
            let side = |radius: f64, k: usize| radius * DVec2::from_angle(angle(k)) + dvec2(shift, -shift);
            let there = (0..count).map(|k| side(radius + half, k));
            let inner = there.chain((0..count).rev().map(|k| side(radius - half, k))).collect();
            let ring = (0..9).map(|k| outer * DVec2::from_angle(gap + TAU * f64::from(k) / 9.0)).collect();
            [inner, ring]
        },
    );
    prop_oneof![stars, arcs]
}

#[test]
fn refined_pairs_of_random_shapes_are_what_they_certify() {
    let (mut refined, mut infeasible) = (0, 0);
    let cases = (shapes(), 8_usize..60, 8_usize..60, 3_usize..90);
    seeded(150, &cases, |([inner, outer], a, b, lines)| {
        let matching = json!({"method": "exact", "oneToOne": true, "lines": lines});
        let Some(solution) = solve(&document([&inner, &outer], [a, b], &matching)) else { return Ok(()) };
        check(&solution)?;
        let Outcome::Matched { pairs, gap, .. } = &solution.outcome else { panic!("matched") };
        if solution.is_complete() {
            // Lines make way in gaps that keep those of the matching.
            let (count, kept) =
                pairs.as_ref().map_or((0, 0), |pairs| (pairs.lines.len(), pairs.failed.len()));
            prop_assert!(
                count == lines || (kept > 0 && count < lines),
                "{} of {}, {} gaps",
                count,
                lines,
                kept
            );
            refined += usize::from(gap.is_some_and(|gap| gap.kind != GapKind::Lattice));
        } else {
            infeasible += 1;
        }
        Ok(())
    });
    assert!(refined > 60 && infeasible > 10, "{refined} refined, {infeasible} infeasible");
}

#[test]
fn every_objective_and_policy_certifies_what_is_so() {
    let mut complete = [0; 4];
    let matchings = [
        json!({"method": "exact", "objective": "sum", "oneToOne": true}),
        json!({"method": "exact", "objective": "sum-less-price", "linePrice": 0.001, "oneToOne": true}),
        json!({"method": "exact", "policy": "repair"}),
        json!({"method": "one-per-vertex", "oneToOne": true}),
    ];
    seeded(150, &(shapes(), 8_usize..60, 8_usize..60), |([inner, outer], a, b)| {
        for (k, matching) in matchings.iter().enumerate() {
            let Some(solution) = solve(&document([&inner, &outer], [a, b], matching)) else { return Ok(()) };
            complete[k] += usize::from(solution.is_complete());
            let Outcome::Matched { occluded, .. } = &solution.outcome else { panic!("matched") };
            if occluded.is_empty() {
                check(&solution)?;
            } else {
                // Lines that were added are marked; the others are free.
                let lines = &parts(&solution).0.lines;
                let seen = (0..lines.len()).filter(|k| !occluded.contains(k)).map(|k| lines[k]);
                let picture = Picture::of_lines(&solution.model, &seen.collect::<Vec<_>>());
                prop_assert_eq!(picture.faults().1, Vec::<usize>::new(), "visible lines");
            }
        }
        Ok(())
    });
    assert!(complete.iter().all(|&count| count > 50), "{complete:?}");
}

#[test]
fn pinned_pairs_of_random_shapes_are_what_they_certify() {
    let (mut kept, mut refused) = (0, 0);
    let pins = prop::collection::vec((0.0..1.0, -0.08..0.08), 1..4);
    seeded(400, &(shapes(), 16_usize..64, 16_usize..64, pins), |([inner, outer], a, b, wanted)| {
        let solved = |matching: Value| solve(&document([&inner, &outer], [a, b], &matching));
        let Some(free) = solved(json!({"method": "exact"})) else { return Ok(()) };
        let lines = &parts(&free).0.lines;
        if !free.is_complete() {
            return Ok(());
        }
        // Some way off the free optimum; the curves run from 0 to 1, and reversed ones are drawn backwards.
        let drawn = |axis: usize, u: f64| {
            let u = if free.model.reversed()[axis] { 1.0 - u } else { u };
            u.rem_euclid(1.0)
        };
        let pins: Vec<(f64, f64)> = wanted
            .iter()
            .map(|&(at, by)| {
                let line = lines[(at * lines.len() as f64) as usize];
                let [u, v] =
                    [(0, line.from), (1, line.to)].map(|(axis, k)| free.model.samples()[axis].parameters[k]);
                (drawn(0, u), drawn(1, v + by))
            })
            .collect();
        let listed: Value = pins.iter().map(|(u, v)| json!({"u": u, "v": v})).collect();
        let matching = json!({"method": "exact", "oneToOne": true, "lines": 64, "pins": listed});
        let Some(solution) = solved(matching) else { return Ok(()) };
        check(&solution)?;
        let is_refused = solution.diagnostics.iter().any(|d| matches!(d, Diagnostic::Pins { .. }));
        if is_refused {
            prop_assert!(!solution.is_complete(), "pins that cannot be kept are not kept quietly");
            refused += 1;
        }
        if let (true, Some(found)) = (solution.is_complete(), parts(&solution).1) {
            let is_near = |x: f64, y: f64| (x - y - (x - y).round()).abs() < 1e-6;
            for &(u, v) in &pins {
                let joined =
                    found.places.iter().any(|&(x, y)| is_near(x, drawn(0, u)) && is_near(y, drawn(1, v)));
                prop_assert!(joined, "{} {} of {:?}", u, v, pins);
            }
            kept += 1;
        }
        Ok(())
    });
    assert!(kept > 100 && refused > 15, "{kept} kept, {refused} refused");
}

/// J* of a document's curves on the curves themselves, and its last change.
fn optimum(document: &Value) -> Option<(f64, f64)> {
    let model = Model::new(read_text(&document.to_string()).expect("a document")).expect("curves");
    let curves = [0, 1].map(|axis| model.curves()[axis].clone());
    let mut job = Refine::new(curves, model.weights(), model.gap());
    let refined = job.step(&mut || true).expect("it is not interrupted")?;
    Some((refined.integral, refined.change.expect("more than one level")))
}

#[test]
fn on_every_preset_the_optimum_knows_no_seam_no_order_no_direction_and_no_side() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets");
    let mut compared = 0;
    for entry in std::fs::read_dir(folder).expect("presets") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|e| e != "json") || path.ends_with("index.json") {
            continue;
        }
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let text = std::fs::read_to_string(&path).expect("a file");
        let given: Value = serde_json::from_str(&text).expect("JSON");
        if given["curves"][0]["form"] == "open" {
            // Without a seam there is none to move; `tests/open.rs` turns open curves round.
            continue;
        }
        if given["curves"].as_array().is_none_or(|curves| curves.len() != 2) {
            // The optimum of a stack is that of its pairs.
            continue;
        }
        let expected = optimum(&given);
        // The samples of the open C are matched; much finer ones within its pocket cannot all have lines at once.
        let is_open = matches!(name.as_str(), "closed-pocket" | "open-c");
        assert_eq!(expected.is_none(), is_open, "{name}");
        assert!(expected.is_none_or(|(_, change)| change < 1e-4), "{name}: {expected:?}");
        let points = |document: &mut Value, change: &dyn Fn(&mut Vec<Value>, usize)| {
            for axis in 0..2 {
                change(document["curves"][axis]["points"].as_array_mut().expect("points"), axis);
            }
        };
        let changed = |change: &dyn Fn(&mut Value)| {
            let mut document = given.clone();
            change(&mut document);
            optimum(&document)
        };
        let is_periodic = given["curves"].as_array().expect("curves").iter().all(|c| c["form"] == "periodic");
        let other_seams = |document: &mut Value| {
            points(document, &|points, axis| points.rotate_left([2, 5][axis]));
        };
        let backwards = |document: &mut Value| {
            points(document, &|points, axis| {
                if axis == 0 {
                    points.reverse();
                }
            });
        };
        let mirrored = |document: &mut Value| {
            points(document, &|points, _| {
                for point in points {
                    point[0] = json!(-point[0].as_f64().expect("a number"));
                }
            });
        };
        let swapped = |document: &mut Value| document["curves"].as_array_mut().expect("curves").reverse();
        let mut found = vec![
            ("order", changed(&swapped)),
            ("direction", changed(&backwards)),
            ("side", changed(&mirrored)),
        ];
        if is_periodic {
            found.push(("seam", changed(&other_seams)));
        }
        for (what, other) in found {
            assert_eq!(expected.is_some(), other.is_some(), "{name}, {what}");
            if let (Some((expected, _)), Some((other, change))) = (expected, other) {
                assert!(change < 1e-4, "{name}, {what}: refined to {change:.1e}");
                let off = (other / expected - 1.0).abs();
                assert!(off <= 1e-4, "{name}, {what}: {expected} and {other}, off by {off:.1e}");
                compared += 1;
            }
        }
    }
    assert!(compared > 75, "{compared}");
}
