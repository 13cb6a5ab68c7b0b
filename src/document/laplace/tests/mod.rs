//! Documents of boundary value problems from JSON to boundaries.

mod known;
mod refusals;

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

/// A change of vertices and triangles.
type Edit<'a> = &'a dyn Fn(&mut Vec<DVec3>, &mut Vec<[u32; 3]>);

#[test]
fn faults_of_meshes_are_said_and_the_rest_of_the_document_is_kept() {
    let sound = boundary(&mesh(|_, _| {}));
    assert!(sound.is_ready() && sound.diagnostics.is_empty());
    assert_eq!((sound.elements.len(), sound.exact.as_ref().map(Exact::name)), (80, Some("constant")));
    let fault = |edit: Edit| {
        let found = boundary(&mesh(|vertices, triangles| edit(vertices, triangles)));
        let [one] = &found.diagnostics[..] else { panic!("{:?}", found.diagnostics) };
        assert!(one.place.is_some() && one.element.is_some() && !one.is_remark && !found.is_ready());
        assert!(found.groups.iter().all(|group| *group == 0), "every element keeps its condition");
        one.code
    };
    assert_eq!(fault(&|_, triangles| triangles.truncate(79)), "open");
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
