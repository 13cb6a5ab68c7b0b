//! Solutions that are known: where they are named, what they are, and that boundary elements meet them.

use super::*;

fn solved(found: &BoundaryProblem) -> Solution {
    let mesh = match found.space {
        Space::Plane => {
            let vertices: Vec<DVec2> = found.vertices.iter().map(|vertex| vertex.truncate()).collect();
            let segments: Vec<[u32; 2]> = found.elements.iter().map(|[a, b, _]| [*a, *b]).collect();
            Mesh::plane(&vertices, &segments)
        }
        Space::Solid => Mesh::solid(found.vertices.clone(), found.elements.clone()),
    };
    let of = |group: &u32| &found.conditions[*group as usize];
    let materials = found.document.materials.len();
    let conditions = Conditions {
        is_value: found.groups.iter().map(|group| of(group).is_value).collect(),
        data: (0..materials).map(|k| found.groups.iter().map(|group| of(group).data[k]).collect()).collect(),
        are_fractions: true,
    };
    solve(Problem::new(mesh.unwrap(), conditions).unwrap(), found.document.options).unwrap()
}

/// Largest error of the solution against the known one, at points.
fn worst(found: &BoundaryProblem, points: impl IntoIterator<Item = DVec3>) -> f64 {
    let solution = solved(found);
    let exact = found.exact.as_ref().expect("a known solution");
    let error = |point: DVec3| {
        let values = solution.at(point).expect("inside").values;
        let known = exact.at(point).expect("inside");
        assert!((known.iter().sum::<f64>() - 1.0).abs() < 1e-9);
        values.iter().zip(known).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    points.into_iter().map(error).fold(0.0, f64::max)
}

/// Points spread over a box.
fn spread(low: f64, high: f64) -> impl Iterator<Item = DVec3> {
    let place = move |k: usize, step: f64| low + (high - low) * (k as f64 * step).fract();
    (0..40).map(move |k| DVec3::new(place(k, 0.7549), place(k, 0.5698), place(k, 0.3819)))
}

/// Points between two distances from the origin, in the plane or in space.
fn around(inner: f64, outer: f64, space: Space) -> impl Iterator<Item = DVec3> {
    spread(0.0, 1.0).map(move |p| {
        let turn = DVec2::from_angle(TAU * p.x);
        let z = if space == Space::Plane { 0.0 } else { 2.0 * p.y - 1.0 };
        (turn * (1.0 - z * z).sqrt()).extend(z) * (inner + (outer - inner) * p.z)
    })
}

#[test]
fn known_solutions_are_named_only_where_the_conditions_match() {
    let name = |value: &Value| boundary(value).exact.as_ref().map(Exact::name);
    let with = |path: &str, new: Value| edited(|d| *d.pointer_mut(path).expect("a field") = new);
    assert_eq!(name(&cube()), Some("cube"));
    assert_eq!(name(&with("/model", json!({"kind": "sliver-cube", "divisions": 4}))), Some("cube"));
    assert_eq!(name(&with("/model", json!({"kind": "hollow-box"}))), None);
    assert_eq!(name(&with("/rest", json!({"flux": [0, 0]}))), Some("linear"), "one half above another");
    assert_eq!(name(&with("/rest", json!({"flux": [0.1, -0.1]}))), None);
    assert_eq!(name(&with("/rest", json!({"value": ["0.5 + 0.5 * z", "0.5 - 0.5 * z"]}))), Some("linear"));
    assert_eq!(name(&with("/rest", json!({"value": ["0.5 + 0.5 * z^2", "0.5 - 0.5 * z^2"]}))), None);
    let alone = |rest: Value| {
        edited(|d| {
            d["groups"] = json!([]);
            d["rest"] = rest;
        })
    };
    assert_eq!(name(&alone(json!({"value": [0.25, 0.75]}))), Some("constant"));
    assert_eq!(name(&alone(json!({"flux": [0, 0]}))), None, "a constant is left free");
    // A coarse cube has a centroid on either side of the middle of each face alone: values that jump are no linear function.
    let coarse = edited(|d| {
        d["model"]["divisions"] = json!(1);
        d["rest"] = json!({"value": [0.75, 0.25]});
    });
    assert_eq!(name(&coarse), Some("cube"));
}

#[test]
fn solutions_meet_the_known_ones() {
    // Bounds are those of the method at these sizes.
    assert!(worst(&boundary(&edited(|d| d["model"]["divisions"] = json!(8))), spread(0.15, 0.85)) < 4e-3);
    let faces = edited(|d| {
        d["groups"][0]["condition"] = json!({"value": [0.2, 0.8]});
        d["groups"][1]["where"] = json!({"direction": [1, 0, 0]});
        d["model"]["divisions"] = json!(8);
    });
    assert!(worst(&boundary(&faces), spread(0.15, 0.85)) < 4e-3);
    let linear = edited(|d| d["rest"] = json!({"flux": [0, 0]}));
    assert!(worst(&boundary(&linear), spread(0.1, 0.9)) < 2e-2);
    let radial = |model: Value, inner: Value, outer: Value| {
        edited(|d| {
            d["model"] = model;
            d["groups"] = json!([{"name": "inside", "where": {"positive": "0.5 - x^2 - y^2 - z^2"}, "condition": inner}]);
            d["rest"] = outer;
        })
    };
    let value = |x: f64| json!({"value": [x, 1.0 - x]});
    let flux = |x: f64| json!({"flux": [x, -x]});
    let sides = [(value(1.0), value(0.0)), (flux(0.4), value(0.25)), (value(0.75), flux(-0.2))];
    for (inner, outer) in sides {
        let shell = radial(json!({"kind": "shell", "inner": 0.5, "level": 2}), inner.clone(), outer.clone());
        let found = boundary(&shell);
        assert_eq!(found.exact.as_ref().map(Exact::name), Some("shell"));
        assert!(worst(&found, around(0.6, 0.9, Space::Solid)) < 3e-2);
        let ring = radial(json!({"kind": "annulus", "inner": 0.5}), inner, outer);
        let found = boundary(&ring);
        assert_eq!(found.exact.as_ref().map(Exact::name), Some("annulus"));
        assert!(worst(&found, around(0.55, 0.95, Space::Plane)) < 2e-3);
    }
}

#[test]
fn points_are_answered_in_steps_and_refused_outside() {
    let found = Rc::new(boundary(&cube()));
    let points: Vec<DVec3> = spread(0.0, 1.0).collect();
    let mut job = ExactJob::new(Rc::clone(&found), points.clone()).unwrap();
    let mut steps = 1;
    while !job.step(&mut || false).unwrap() {
        assert!(job.progress() < 1.0);
        steps += 1;
    }
    let numbers = job.numbers();
    assert_eq!((steps, numbers.len()), (40, 80));
    for (point, pair) in points.iter().zip(numbers.chunks(2)) {
        assert_eq!(found.exact.as_ref().unwrap().at(*point).unwrap(), pair);
    }
    let outside = vec![DVec3::splat(0.5), DVec3::new(0.5, 1.5, 0.5)];
    let error = ExactJob::new(Rc::clone(&found), outside).unwrap().step(&mut || true).unwrap_err();
    assert_eq!((error.fault, error.index), (crate::laplace::Fault::Outside, Some(1)));
    let error = ExactJob::new(found, vec![DVec3::NAN]).unwrap_err();
    assert_eq!((error.fault, error.index), (crate::laplace::Fault::Points, Some(0)));
}

/// All presets can be solved, and those with a known solution meet it.
#[test]
fn presets_are_solved() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets/laplace");
    let mut known = Vec::new();
    for file in std::fs::read_dir(&folder).expect("the folder of presets") {
        let path = file.expect("a file").path();
        let id = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let text = std::fs::read_to_string(&path).expect("a preset");
        let document = Json::parse(&text).and_then(|json| read_laplace(&json)).expect("a valid document");
        assert_ne!(document.title, "Untitled", "{id}");
        let found = BoundaryJob::new(document).run();
        assert!(found.is_ready() && found.diagnostics.is_empty(), "{id}: {:?}", found.diagnostics);
        let error = match found.exact.as_ref().map(Exact::name) {
            Some("cube") => worst(&found, spread(0.15, 0.85)),
            Some("square") => worst(&found, spread(0.1, 0.9).map(|p| p.truncate().extend(0.0))),
            Some("shell") => worst(&found, around(0.5, 0.9, Space::Solid)),
            Some("annulus") => worst(&found, around(0.45, 0.95, Space::Plane)),
            Some(other) => panic!("{id}: {other}"),
            None => {
                let solution = solved(&found);
                assert!(solution.convergences().iter().all(|found| found.is_converged), "{id}");
                continue;
            }
        };
        let bound = match id.as_str() {
            "cube" => 4e-3,
            "square" | "annulus" => 1e-3,
            _ => 2e-2,
        };
        assert!(error < bound, "{id}: {error}");
        known.push(id);
    }
    known.sort();
    assert_eq!(known, ["annulus", "cube", "shell", "square"]);
}
