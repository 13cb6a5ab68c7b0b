//! Documents of boundary value problems from JSON to boundaries and known solutions.

use super::*;
use crate::document::{Code, DocumentError, Json};
use crate::laplace::{
    Conditions, LaplaceOptions, MOST_ELEMENTS, Mesh, Problem, Solution, Space, enclosed, solve,
};
use glam::{DVec2, DVec3};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::rc::Rc;

/// The cube of the paper's Fig. 13.
fn cube() -> Value {
    json!({
        "directrix": 1, "kind": "laplace",
        "model": {"kind": "cube", "divisions": 4},
        "groups": [
            {"name": "top", "where": {"direction": [0, 0, 2]}, "condition": {"value": [1, 0]}},
            {"name": "bottom", "where": {"direction": [0, 0, -1]}, "condition": {"value": [0.5, 0.5]}},
        ],
        "rest": {"value": [0, 1]},
    })
}

fn read(value: &Value) -> Result<LaplaceDocument, DocumentError> {
    read_laplace(&Json::from(value.clone()))
}

fn boundary(value: &Value) -> BoundaryProblem {
    BoundaryJob::new(read(value).expect("a valid document")).run()
}

fn edited(edit: impl FnOnce(&mut Value)) -> Value {
    let mut value = cube();
    edit(&mut value);
    value
}

fn refused(edit: impl FnOnce(&mut Value)) -> (Code, String) {
    let error = read(&edited(edit)).expect_err("refused");
    assert!(!error.message.is_empty());
    (error.code, error.path)
}

/// Code, path, number of elements and whether it can be solved all the same, of each diagnostic.
fn said(value: &Value) -> Vec<(&'static str, String, usize, bool)> {
    let of = |one: &BoundaryDiagnostic| {
        assert!(!one.message.is_empty());
        (one.code, one.path.clone(), one.count.unwrap_or(0), one.is_remark)
    };
    boundary(value).diagnostics.iter().map(of).collect()
}

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
fn every_element_gets_its_condition_and_sets_their_sizes() {
    let found = boundary(&cube());
    assert!(found.is_ready() && found.diagnostics.is_empty());
    assert_eq!((found.elements.len(), found.conditions.len()), (192, 3));
    let sets: Vec<_> = found.sets.iter().map(|set| (set.name.as_str(), set.count)).collect();
    assert_eq!(sets, [("top", 32), ("bottom", 32), ("rest", 128)]);
    for (set, area) in found.sets.iter().zip([1.0, 1.0, 4.0]) {
        assert!((set.measure - area).abs() < 1e-12);
    }
    for (element, corners) in found.elements.iter().enumerate() {
        let z = corners.iter().map(|vertex| found.vertices[*vertex as usize].z).sum::<f64>() / 3.0;
        let expected = if z == 1.0 {
            0
        } else if z == 0.0 {
            1
        } else {
            2
        };
        assert_eq!((found.groups[element], found.members[element]), (expected, expected));
    }
    let document = &found.document;
    assert_eq!(
        (document.title.as_str(), document.unit.as_str(), document.options),
        ("Untitled", "mm", LaplaceOptions::default())
    );
}

#[test]
fn selections_hold_where_everything_given_holds() {
    let count = |selection: Value| {
        let document = edited(|d| {
            d["groups"] = json!([{"name": "a", "where": selection, "condition": {"value": [1, 0]}}]);
        });
        boundary(&document).sets[0].count
    };
    assert_eq!(count(json!({"direction": [0, 0, 1], "angle": 90})), 160, "but for the face below");
    assert_eq!(count(json!({"direction": [1, 1, 0], "angle": 46})), 64);
    assert_eq!(count(json!({"box": [[-1, -1, 2], [2, 2, 0.5]]})), 96, "corners in any order");
    assert_eq!(count(json!({"direction": [0, 0, 1], "box": [[0, 0, 0], [0.5, 1, 1]]})), 16);
    assert_eq!(count(json!({"positive": "z - 0.999"})), 32);
    assert_eq!(
        count(json!({"positive": "0.5 - r", "direction": [0, 0, 1]})),
        count(json!({"positive": "0.25 - x^2 - y^2", "direction": [0, 0, 1]}))
    );
    assert_eq!(count(json!({"elements": [[3, 4], [100, 191], [100, 101]]})), 94);
    assert_eq!(count(json!({"elements": []})), 0);
    assert_eq!(count(json!({"elements": [[190, 500]]})), 2);
}

#[test]
fn expressions_make_conditions_of_their_own() {
    let document = edited(|d| d["groups"][0]["condition"] = json!({"value": ["x", "1 - x"]}));
    let found = boundary(&document);
    assert!(found.is_ready() && found.exact.is_none());
    let own: Vec<_> = found.conditions.iter().filter(|condition| condition.set == 0).collect();
    assert!(own.len() > 2 && own.len() <= 32, "centroids with one x share a condition");
    assert!((own.iter().map(|condition| condition.measure).sum::<f64>() - 1.0).abs() < 1e-12);
    for (element, group) in
        found.groups.iter().enumerate().filter(|(element, _)| found.members[*element] == 0)
    {
        let x = found.elements[element].iter().map(|v| found.vertices[*v as usize].x).sum::<f64>() / 3.0;
        assert!((found.conditions[*group as usize].data[0] - x).abs() < 1e-12);
    }
}

#[test]
fn what_keeps_a_problem_from_being_solved_is_said_with_its_place() {
    let none = edited(|d| drop(d.as_object_mut().map(|d| d.remove("rest"))));
    assert_eq!(said(&none), [("missing", "rest".into(), 128, false)]);
    let found = boundary(&none);
    let missing = &found.diagnostics[0];
    let first = missing.element.expect("an element");
    assert_eq!(found.groups[first], found.conditions.len() as u32);
    assert_eq!(found.members[first], 2);
    assert!(missing.place.is_some());

    let twice = edited(|d| {
        d["groups"][1] =
            json!({"name": "b", "where": {"positive": "z - 0.999"}, "condition": {"value": [0, 1]}});
    });
    assert_eq!(
        said(&twice),
        [("conflict", "groups[1].where".into(), 32, false), ("empty", "groups[1].where".into(), 0, true)]
    );
    let alike = edited(|d| {
        d["groups"][1] =
            json!({"name": "b", "where": {"positive": "z - 0.5"}, "condition": {"value": [1, 0]}});
    });
    assert_eq!(said(&alike), []);

    let at = |path: &str, value: Value| said(&edited(|d| *d.pointer_mut(path).expect("a field") = value));
    let condition = "groups[0].condition".to_owned();
    assert_eq!(
        at("/groups/0/condition", json!({"value": ["x", "0.5"]})),
        [("sum", condition.clone(), 32, false)]
    );
    assert_eq!(
        at("/groups/0/condition", json!({"value": ["ln(x - 0.5)", "0"]})),
        [("value", condition.clone(), 32, false)]
    );
    assert_eq!(at("/groups/0/condition", json!({"flux": ["x", "y"]})), [("sum", condition, 32, false)]);
    let text = "groups[0].condition.value[1]".to_owned();
    assert_eq!(at("/groups/0/condition", json!({"value": [1, "2 +"]})), [("expression", text, 0, false)]);
    let unread = edited(|d| d["groups"][0]["where"] = json!({"positive": "w"}));
    assert_eq!(said(&unread), [("expression", "groups[0].where.positive".into(), 0, false)]);
    assert_eq!(boundary(&unread).diagnostics[0].character, Some(0));
    let beyond = edited(|d| d["groups"][0]["where"] = json!({"elements": [[0, 192]]}));
    assert!(said(&beyond).contains(&("elements", "groups[0].where.elements".into(), 0, true)));

    let flows = edited(|d| {
        d["groups"] =
            json!([{"name": "top", "where": {"direction": [0, 0, 1]}, "condition": {"flux": [1, -1]}}]);
        d["rest"] = json!({"flux": [0, 0]});
    });
    assert_eq!(said(&flows), [("imbalance", "groups".into(), 0, false)]);
    let large = |solver: Value, divisions: usize| {
        said(&edited(|d| {
            d["solver"] = solver;
            d["model"]["divisions"] = json!(divisions);
        }))
    };
    for (solver, divisions) in [
        (json!({"method": "lu"}), 13),
        (json!({"condition": true}), 13),
        (json!({"preconditioner": "ssor"}), 26),
    ] {
        assert_eq!(large(solver.clone(), divisions), [("method", "solver".into(), 0, false)]);
        assert_eq!(large(solver, divisions - 1), []);
    }
}

fn mesh(edit: impl FnOnce(&mut Vec<DVec3>, &mut Vec<[u32; 3]>)) -> Value {
    let sphere = crate::laplace::samples::sphere(1.0, 1);
    let (mut vertices, mut triangles) = (sphere.vertices().to_vec(), sphere.elements().to_vec());
    edit(&mut vertices, &mut triangles);
    edited(|d| {
        let vertices: Vec<_> = vertices.iter().map(|vertex| vertex.to_array()).collect();
        d["model"] = json!({"kind": "mesh", "vertices": vertices, "triangles": triangles});
        d["groups"] = json!([]);
    })
}

#[test]
fn faults_of_meshes_are_said_and_the_rest_of_the_document_is_kept() {
    let sound = boundary(&mesh(|_, _| {}));
    assert!(sound.is_ready() && sound.diagnostics.is_empty());
    assert_eq!((sound.elements.len(), sound.exact.as_ref().map(Exact::name)), (80, Some("constant")));
    let fault = |edit: &dyn Fn(&mut Vec<DVec3>, &mut Vec<[u32; 3]>)| {
        let found = boundary(&mesh(|vertices, triangles| edit(vertices, triangles)));
        let [one] = &found.diagnostics[..] else { panic!("{:?}", found.diagnostics) };
        assert!(one.place.is_some() && one.element.is_some() && !one.is_remark && !found.is_ready());
        assert!(found.groups.iter().all(|group| *group == 0), "every element keeps its condition");
        one.code
    };
    assert_eq!(fault(&|_, triangles| drop(triangles.pop())), "open");
    assert_eq!(fault(&|_, triangles| triangles[7].swap(0, 1)), "open");
    assert_eq!(fault(&|_, triangles| triangles.iter_mut().for_each(|t| t.swap(0, 1))), "inverted");
    assert_eq!(fault(&|_, triangles| triangles[3][0] = triangles[3][1]), "degenerate");
    let apart = |vertices: &mut Vec<DVec3>, triangles: &mut Vec<[u32; 3]>| {
        let count = vertices.len() as u32;
        vertices.extend(vertices.clone().iter().map(|vertex| *vertex + DVec3::X * 5.0));
        triangles.extend(triangles.clone().iter().map(|t| t.map(|vertex| vertex + count)));
    };
    assert_eq!(fault(&apart), "apart");
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

#[test]
fn every_model_is_made_within_its_limits_and_closed() {
    let model = |model: Value| {
        let found = read(&edited(|d| {
            d["model"] = model.clone();
            d["groups"] = json!([]);
        }))
        .unwrap_or_else(|error| panic!("{model}: {error}"));
        super::model::Surface::new(&found.model)
    };
    let sound = |value: Value| {
        let surface = model(value.clone());
        assert!(enclosed(&surface.mesh.unwrap_or_else(|e| panic!("{value}: {e}"))).is_ok(), "{value}");
    };
    for kind in ["cube", "sliver-cube", "hollow-box", "shell", "sphere", "mug", "cylinder", "fillet-block"] {
        sound(json!({"kind": kind}));
    }
    sound(json!({"kind": "mug", "sectors": 18, "sliver": 1e-6}));
    sound(json!({"kind": "mug", "sectors": 6, "sliver": 1e-2}));
    sound(json!({"kind": "annulus", "inner": 0.5, "segments": 6}));
    sound(json!({"kind": "annulus", "inner": 0.99e9, "outer": 1e9, "segments": 200}));
    sound(json!({"kind": "shell", "inner": 9.98e-7, "outer": 1e-6, "level": 0}));
    let greatest = [
        json!({"kind": "cube", "divisions": 51}),
        json!({"kind": "sliver-cube", "divisions": 50, "width": 1e-8}),
        json!({"kind": "hollow-box", "divisions": 36}),
        json!({"kind": "shell", "level": 4}),
        json!({"kind": "sphere", "level": 5}),
        json!({"kind": "mug", "sectors": 120, "sliver": 1e-2}),
        json!({"kind": "cylinder", "divisions": 29}),
        json!({"kind": "fillet-block", "divisions": 40}),
        json!({"kind": "square", "divisions": 8000}),
        json!({"kind": "annulus", "segments": 20_000}),
    ];
    for value in greatest {
        let surface = model(value.clone());
        assert!(surface.mesh.is_ok() && surface.elements.len() <= MOST_ELEMENTS, "{value}");
    }
    // Profiles of revolution end on the axis exactly.
    for sectors in 6..=40 {
        assert!(model(json!({"kind": "mug", "sectors": sectors, "sliver": 1e-6})).mesh.is_ok(), "{sectors}");
        assert!(model(json!({"kind": "cylinder", "divisions": sectors.min(29)})).mesh.is_ok());
    }
}

#[test]
fn errors_name_the_field() {
    let at = |path: &'static str, value: Value| refused(|d| *d.pointer_mut(path).expect("a field") = value);
    assert_eq!(at("/kind", json!("part")), (Code::Kind, "kind".into()));
    assert_eq!(at("/kind", json!("heat")), (Code::Range, "kind".into()));
    assert_eq!(at("/directrix", json!(2)), (Code::Version, "directrix".into()));
    assert_eq!(refused(|d| d["speed"] = json!(1)), (Code::UnknownField, "speed".into()));
    assert_eq!(
        refused(|d| d["materials"] = json!([{"name": "a", "color": "#000000"}])),
        (Code::Range, "materials".into())
    );
    assert_eq!(at("/model", json!({"kind": "ball"})), (Code::Range, "model.kind".into()));
    assert_eq!(at("/model/divisions", json!(52)), (Code::Limit, "model.divisions".into()));
    assert_eq!(at("/model/divisions", json!(0)), (Code::Range, "model.divisions".into()));
    assert_eq!(at("/model/divisions", json!(2.5)), (Code::Type, "model.divisions".into()));
    assert_eq!(refused(|d| d["model"]["wall"] = json!(0.1)), (Code::UnknownField, "model.wall".into()));
    assert_eq!(
        at("/model", json!({"kind": "sliver-cube", "divisions": 10, "width": 0.06})),
        (Code::Range, "model.width".into())
    );
    assert_eq!(at("/model", json!({"kind": "shell", "inner": 2})), (Code::Range, "model.inner".into()));
    assert_eq!(
        at("/model", json!({"kind": "annulus", "segments": 6, "inner": 0.9})),
        (Code::Range, "model.inner".into())
    );
    let mesh = |vertices: Value, triangles: Value| {
        at("/model", json!({"kind": "mesh", "vertices": vertices, "triangles": triangles}))
    };
    let four = json!([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    assert_eq!(mesh(json!([]), json!([])), (Code::Range, "model.vertices".into()));
    assert_eq!(mesh(four.clone(), json!([[0, 1, 2]])), (Code::Range, "model.triangles".into()));
    assert_eq!(
        mesh(four.clone(), json!([[0, 1, 2], [0, 1, 4], [0, 1, 2], [0, 1, 2]])),
        (Code::Range, "model.triangles[1][2]".into())
    );
    assert_eq!(
        mesh(json!([[0, 0, 0], [1, 0, "0"], [0, 1, 0], [0, 0, 1]]), json!([])),
        (Code::Type, "model.vertices[1][2]".into())
    );
    assert_eq!(
        mesh(four, json!(vec![[0, 1, 2]; MOST_ELEMENTS + 1])),
        (Code::Limit, "model.triangles".into())
    );
    assert_eq!(at("/groups/0/where", json!({})), (Code::Missing, "groups[0].where".into()));
    assert_eq!(at("/groups/0/where", json!({"angle": 5})), (Code::Range, "groups[0].where.angle".into()));
    assert_eq!(
        at("/groups/0/where", json!({"direction": [0, 0, 0]})),
        (Code::Range, "groups[0].where.direction".into())
    );
    assert_eq!(
        at("/groups/0/where", json!({"direction": [0, 1]})),
        (Code::Range, "groups[0].where.direction".into())
    );
    assert_eq!(
        at("/groups/0/where", json!({"box": [[0, 0, 0]]})),
        (Code::Range, "groups[0].where.box".into())
    );
    assert_eq!(
        at("/groups/0/where", json!({"elements": [[5, 4]]})),
        (Code::Range, "groups[0].where.elements[0][1]".into())
    );
    assert_eq!(at("/groups/0/condition", json!({})), (Code::Missing, "groups[0].condition".into()));
    assert_eq!(
        at("/groups/0/condition", json!({"value": [1]})),
        (Code::Range, "groups[0].condition.value".into())
    );
    assert_eq!(
        at("/groups/0/condition", json!({"value": [1, 0.5]})),
        (Code::Range, "groups[0].condition.value".into())
    );
    assert_eq!(
        at("/groups/0/condition", json!({"value": [2, -1]})),
        (Code::Range, "groups[0].condition.value[0]".into())
    );
    assert_eq!(at("/rest", json!({"flux": [1, 1]})), (Code::Range, "rest.flux".into()));
    assert_eq!(at("/rest", json!({"value": [1, 0], "flux": [0, 0]})), (Code::Range, "rest".into()));
    assert_eq!(refused(|d| d["solver"] = json!({"omega": 0.5})), (Code::Range, "solver.omega".into()));
    assert_eq!(
        refused(|d| d["section"] = json!({"origin": [0, 0, 0]})),
        (Code::Missing, "section.normal".into())
    );
    let plane = refused(|d| {
        d["model"] = json!({"kind": "square"});
        d["groups"] = json!([]);
        d["section"] = json!({"origin": [0, 0], "normal": [0, 1]});
    });
    assert_eq!(plane, (Code::Range, "section".into()));
    assert_eq!(
        refused(|d| d["groups"] = json!(vec![d["groups"][0].clone(); MOST_GROUPS + 1])),
        (Code::Limit, "groups".into())
    );
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

/// Whatever single value is put anywhere, the document is refused by path or made.
#[test]
fn mutated_documents_never_panic() {
    let base = edited(|d| {
        d["model"]["divisions"] = json!(2);
        d["groups"][0]["condition"] = json!({"value": ["x", "1 - x"]});
        d["groups"][1]["where"] = json!({"direction": [0, 0, -1], "angle": 20, "box": [[0, 0, 0], [1, 1, 1]], "positive": "0.5 - z", "elements": [[0, 40]]});
        d["solver"] = json!({"preconditioner": "ssor", "omega": 1, "restart": 20});
        d["section"] = json!({"origin": [0, 0, 0], "normal": [0, 1, 0]});
    });
    let mut paths = Vec::new();
    collect(&base, String::new(), &mut paths);
    assert!(paths.len() > 50);
    let values = [
        json!(null),
        json!(true),
        json!(-1),
        json!(0),
        json!(1e300),
        json!(1e-300),
        json!(7.5),
        json!("x"),
        json!("1/0"),
        json!(""),
        json!([]),
        json!([[0]]),
        json!({}),
        json!("annulus"),
        json!("mesh"),
        json!({"kind": "annulus"}),
        json!({"flux": [0, 0]}),
        json!([0, 0]),
    ];
    let (mut refused, mut made) = (0, 0);
    for path in &paths {
        for value in &values {
            let mut document = base.clone();
            *document.pointer_mut(path).expect("a field") = value.clone();
            match read(&document) {
                Err(error) => {
                    assert!(!error.message.is_empty());
                    refused += 1;
                }
                Ok(document) => {
                    let found = BoundaryJob::new(document).run();
                    assert_eq!(found.groups.len(), found.elements.len());
                    if found.is_ready() {
                        assert!(found.groups.iter().all(|group| (*group as usize) < found.conditions.len()));
                    }
                    made += 1;
                }
            }
        }
    }
    assert!(refused > 500 && made > 100, "{refused} refused, {made} made");
}

/// Paths of every value.
fn collect(value: &Value, path: String, paths: &mut Vec<String>) {
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(name, value)| collect(value, format!("{path}/{name}"), paths))
        }
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(k, value)| collect(value, format!("{path}/{k}"), paths))
        }
        _ => {}
    }
    if !path.is_empty() {
        paths.push(path);
    }
}
