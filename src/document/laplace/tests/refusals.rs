//! Bad input: every field by its path, and no value whatever that makes the reader or the job panic.

use super::*;

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
