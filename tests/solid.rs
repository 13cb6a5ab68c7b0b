//! Solids end to end: closed forms, checks by a slow and independent reader, and documents that strain them.
#![cfg(feature = "solid")]

use crate::support::{list, seeded};
use directrix::document::{
    Code, Json, Outcome, Solid, SolidColor, SolidJob, SolidOptions, Solution, Solve, insert_point, read_text,
    why_no_solid, write_text,
};
use directrix::solid::{FileJob, Format, Labels, Mesh, Part};
use glam::{DQuat, DVec2, DVec3, dvec2, dvec3};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_6, PI, TAU};
use std::rc::Rc;

/// Control points whose cubic is a circle to about 1e-7: the vertices of a fine polygon just outside it, by the means of B-splines.
fn circle(radius: f64, count: usize) -> Vec<DVec2> {
    let step = TAU / count as f64;
    let outside = radius / ((2.0 + step.cos()) / 3.0);
    (0..count).map(|k| outside * DVec2::from_angle(step * k as f64)).collect()
}

fn curve(points: &[DVec2], height: f64) -> Value {
    json!({"degree": 3, "form": "periodic", "points": list(points), "height": height})
}

fn document(curves: [Value; 2], matching: &Value, counts: [usize; 2]) -> Value {
    json!({"directrix": 1, "kind": "curves", "matching": matching, "sampling": {"counts": counts}, "curves": curves})
}

fn solved(document: &Value, options: SolidOptions) -> Solid {
    let read = read_text(&document.to_string()).expect("fields in range");
    let solution = Solve::run(read).expect("curves");
    let diagnostics = solution.diagnostics.clone();
    let solid = SolidJob::run(Rc::new(solution), options).expect("within limits");
    solid.unwrap_or_else(|| panic!("no solid: {diagnostics:?}"))
}

fn with(stages: usize, color: SolidColor) -> SolidOptions {
    SolidOptions { stages: Some(stages), caps: true, color }
}

/// Reads a mesh as one who has only coordinates: every edge has to be there once in either direction. Returns the volume inside, from another point
/// than the kernel's.
fn read_again(mesh: &Mesh) -> Result<f64, String> {
    let key = |p: DVec3| p.as_vec3().to_array().map(|x| if x == 0.0 { 0 } else { x.to_bits() });
    let mut edges: HashMap<([u32; 3], [u32; 3]), usize> = HashMap::new();
    let mut volume = 0.0;
    for &triangle in &mesh.triangles {
        let corners = triangle.map(|k| mesh.positions[k as usize]);
        for k in 0..3 {
            *edges.entry((key(corners[k]), key(corners[(k + 1) % 3]))).or_default() += 1;
        }
        let [a, b, c] = corners.map(|corner| corner - mesh.positions[0]);
        volume += a.dot(b.cross(c)) / 6.0;
    }
    for ((from, to), count) in &edges {
        let back = edges.get(&(*to, *from));
        if from == to || *count != 1 || back != Some(&1) {
            return Err(format!("an edge is there {count} times, and {back:?} times back"));
        }
    }
    Ok(volume)
}

/// Area of a polygon in a horizontal plane.
fn area_of(row: &[DVec3]) -> f64 {
    let flat: Vec<DVec2> = row.iter().map(|p| p.truncate()).collect();
    (0..flat.len()).map(|k| flat[k].perp_dot(flat[(k + 1) % flat.len()])).sum::<f64>() / 2.0
}

/// Volume between two horizontal polygons whose vertices are joined by straight lines: the prismatoid formula, which is exact as areas across are
/// quadratic in the height.
fn prismatoid(first: &[DVec3], last: &[DVec3]) -> f64 {
    let middle: Vec<DVec3> = first.iter().zip(last).map(|(a, b)| (a + b) / 2.0).collect();
    let height = (last[0].z - first[0].z).abs();
    height * (area_of(first) + 4.0 * area_of(&middle) + area_of(last)) / 6.0
}

fn cone(lines: usize, heights: [f64; 2]) -> Value {
    let curves = [curve(&circle(10.0, 96), heights[0]), curve(&circle(25.0, 96), heights[1])];
    document(curves, &json!({"method": "parameter"}), [lines, lines])
}

/// Chords of n rulings lack the share 1 - sin(2 pi / n) / (2 pi / n) of the volume, which falls with the square of n.
#[test]
fn a_cone_frustum_has_its_volume_and_area() {
    let exact = PI * 30.0 / 3.0 * (100.0 + 250.0 + 625.0);
    let slant = 15.0_f64.hypot(30.0);
    let surface = PI * (100.0 + 625.0 + 35.0 * slant);
    for lines in [180, 360, 720] {
        let solid = solved(&cone(lines, [0.0, 30.0]), with(3, SolidColor::Material));
        let volume = solid.volume.expect("watertight");
        let step = TAU / lines as f64;
        let lack = 1.0 - volume / exact;
        assert!((lack / (1.0 - step.sin() / step) - 1.0).abs() < 1e-2, "{lines}: {lack}");
        assert!((volume / prismatoid(&solid.stages[0], &solid.stages[3]) - 1.0).abs() < 1e-12);
        assert!((volume / read_again(&solid.mesh).expect("watertight") - 1.0).abs() < 1e-12);
        assert!((1.0 - solid.area / surface).abs() < step * step / 4.0, "{lines}");
    }
}

#[test]
fn the_outside_is_outside_whichever_curve_is_higher() {
    for heights in [[0.0, 30.0], [30.0, 0.0], [-7.0, -37.0]] {
        let solid = solved(&cone(200, heights), with(5, SolidColor::Material));
        let volume = read_again(&solid.mesh).expect("watertight");
        assert!(volume > 0.0 && solid.volume.is_some_and(|v| (v / volume - 1.0).abs() < 1e-12));
        let parts: Vec<Part> = solid.mesh.groups.iter().map(|group| group.part).collect();
        assert_eq!(parts, [Part::Surface, Part::Cap(0), Part::Cap(1)]);
        for (k, group) in solid.mesh.groups[1..].iter().enumerate() {
            let up = if heights[k] > heights[1 - k] { 1.0 } else { -1.0 };
            for &triangle in &solid.mesh.triangles[group.triangles.clone()] {
                let [a, b, c] = solid.mesh.corners(triangle);
                assert!((b - a).cross(c - a).z * up > 0.0);
            }
        }
    }
}

/// A straight-edged square inside another, with a ruling at every corner: a frustum of a pyramid, exactly, although no sample lies at a corner.
#[test]
fn corners_are_kept() {
    let square = |half: f64, height: f64| {
        let corners = [dvec2(half, half), dvec2(-half, half), dvec2(-half, -half), dvec2(half, -half)];
        let points: Vec<DVec2> =
            (0..=8).map(|k| corners[k / 2 % 4].midpoint(corners[k.div_ceil(2) % 4])).collect();
        json!({"degree": 2, "form": "clamped", "points": list(&points), "height": height,
            "knots": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]})
    };
    let mut document = document([square(3.0, 1.0), square(7.0, 9.0)], &json!({"method": "exact"}), [37, 37]);
    document["sampling"]["scheme"] = json!("arc-length");
    let solid = solved(&document, with(4, SolidColor::Material));
    let exact = 8.0 / 3.0 * (36.0 + 84.0 + 196.0);
    let volume = solid.volume.expect("watertight");
    assert!((area_of(&solid.stages[0]) - 36.0).abs() < 1e-9);
    assert!((area_of(&solid.stages[4]) - 196.0).abs() < 1e-9);
    assert!((volume / exact - 1.0).abs() < 0.01, "{volume}, {exact}");
}

/// Two coaxial circles whose rulings are turned by an angle: a hyperboloid. The formulas are the definitions, for one ruling.
fn turned(lines: usize, shift: usize) -> Value {
    let curves = [curve(&circle(10.0, 96), 0.0), curve(&circle(25.0, 96), 30.0)];
    document(curves, &json!({"method": "shift", "shift": shift}), [lines, lines])
}

#[test]
fn a_twisted_frustum_tends_to_its_volume() {
    let errors: Vec<f64> = [4, 8, 16, 32]
        .into_iter()
        .map(|stages| {
            let solid = solved(&turned(192, 16), with(stages, SolidColor::Material));
            let exact = prismatoid(&solid.stages[0], &solid.stages[stages]);
            let volume = solid.volume.expect("watertight");
            assert!((volume / read_again(&solid.mesh).expect("watertight") - 1.0).abs() < 1e-12);
            (volume / exact - 1.0).abs()
        })
        .collect();
    assert!(errors[0] < 1e-2 && errors[3] < 3e-4, "{errors:?}");
    assert!(errors.windows(2).all(|pair| pair[1] < 0.65 * pair[0]), "{errors:?}");
}

#[test]
fn twist_and_flank_are_those_of_a_hyperboloid() {
    for (shift, turn) in [(0, 0.0), (16, FRAC_PI_6), (8, FRAC_PI_6 / 2.0)] {
        let first = DVec3::Y;
        let second = dvec3(-turn.sin(), turn.cos(), 0.0);
        let ruling = dvec3(25.0 * turn.cos() - 10.0, 25.0 * turn.sin(), 30.0);
        let flank = first.cross(ruling).angle_between(second.cross(ruling)).to_degrees();
        let twist = solved(&turned(192, shift), with(2, SolidColor::Twist));
        assert!(twist.mesh.scalars.iter().all(|angle| (angle - turn.to_degrees()).abs() < 1e-4), "{shift}");
        let solid = solved(&turned(192, shift), with(2, SolidColor::Flank));
        let largest = solid.mesh.scalars.iter().map(|angle| (angle - flank).abs()).fold(0.0, f64::max);
        assert!(largest < 1e-4, "{shift}: {largest} of {flank}");
        assert_eq!(solid.range, Some((0.0, solid.mesh.scalars.iter().copied().fold(1.0, f64::max))));
        let limit = turn.to_degrees().max(1.0);
        assert!(twist.range.is_some_and(|(low, high)| low == -high && (high - limit).abs() < 1e-4));
    }
}

/// Turned the other way, or seen from below, an angle between normals stays; the twist changes its sign with the direction of the turn alone.
#[test]
fn the_twist_has_a_sign_and_the_flank_has_none() {
    let angles = |document: &Value| {
        [SolidColor::Twist, SolidColor::Flank].map(|color| solved(document, with(1, color)).mesh.scalars[0])
    };
    let [twist, flank] = angles(&turned(192, 16));
    let [back, same] = angles(&turned(192, 176));
    assert!((twist + back).abs() < 1e-4 && (flank - same).abs() < 1e-4);
    let mut below = turned(192, 16);
    below["curves"][1]["height"] = json!(-30.0);
    let [twist_below, flank_below] = angles(&below);
    assert!((twist - twist_below).abs() < 1e-9 && (flank - flank_below).abs() < 1e-9);
    assert!(flank > 10.0 && twist > 29.9);
}

/// Any pair of lobed curves at different heights, with fans: watertight for another reader, of the volume that the stages say, and fractions
/// stay in the simplex.
#[test]
fn solids_of_random_curves_are_watertight() {
    let lobed = |radius: f64, lobes: f64, depth: f64| {
        let point = move |k: u32| {
            let angle = TAU * f64::from(k) / 40.0;
            radius * (1.0 + depth * (lobes * angle).cos()) * DVec2::from_angle(angle)
        };
        (0..40).map(point).collect::<Vec<_>>()
    };
    let strategy = (2..9_u8, 2..9_u8, 0.0..0.35, 0.0..0.35, -50.0..50.0, 1..12_usize, any::<[bool; 2]>());
    seeded(24, &strategy, |(a, b, depth_a, depth_b, height, stages, [greedy, one_to_one])| {
        let method = if greedy { "greedy" } else { "exact" };
        let curves = [
            curve(&lobed(10.0, f64::from(a), depth_a), 0.0),
            curve(&lobed(30.0, f64::from(b), depth_b), height),
        ];
        let document = document(
            curves,
            &json!({"method": method, "oneToOne": one_to_one, "policy": "repair"}),
            [40, 64],
        );
        let read = read_text(&document.to_string()).expect("fields in range");
        let solution = Rc::new(Solve::run(read).expect("curves"));
        let built = SolidJob::run(solution, with(stages, SolidColor::Material)).expect("within limits");
        let Some(solid) = built else { return Ok(()) };
        let volume = read_again(&solid.mesh).map_err(TestCaseError::fail)?;
        prop_assert!(solid.volume.is_some_and(|known| (known / volume - 1.0).abs() < 1e-9));
        prop_assert!(volume > 0.0);
        let slabs: f64 = solid.stages.windows(2).map(|pair| prismatoid(&pair[0], &pair[1])).sum();
        prop_assert!((volume / slabs - 1.0).abs() < 0.03, "{volume}, {slabs}");
        for mix in solid.mesh.fractions.chunks(2) {
            prop_assert!(mix.iter().all(|&part| part >= 0.0) && (mix[0] + mix[1] - 1.0).abs() < 1e-12);
        }
        Ok(())
    });
}

#[test]
fn composition_and_colour_at_a_vertex_are_those_of_the_blend() {
    let mut document = cone(180, [0.0, 30.0]);
    document["materials"] = json!([{"name": "a", "color": "#000000"}, {"name": "b", "color": "#ffffff"}, {"name": "c", "color": "#ff0000"}]);
    document["curves"][0]["composition"] =
        json!([{"at": 0, "mix": [1, 0, 0]}, {"at": 0.5, "mix": [0, 0.5, 0.5]}]);
    let solid = solved(&document, with(4, SolidColor::Material));
    for (position, mix) in solid.mesh.positions.iter().zip(solid.mesh.fractions.chunks(3)) {
        let s = position.z / 30.0;
        // The curve starts at its second control point.
        let around = (position.y.atan2(position.x) / TAU - 1.0 / 96.0).rem_euclid(1.0);
        let first = (1.0 - 2.0 * around).abs();
        let expected =
            [(1.0 - s) * first, (1.0 - s) * (1.0 - first) / 2.0 + s, (1.0 - s) * (1.0 - first) / 2.0];
        assert!(mix.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-5), "{mix:?}, {expected:?}");
    }
    let top = solid.mesh.positions.iter().position(|p| p.z == 30.0).expect("a vertex of the second curve");
    assert_eq!(solid.colors[top].to_string(), "#ffffff");
    let fraction = solved(&document, with(4, SolidColor::Fraction(1)));
    assert_eq!((fraction.range, fraction.colors[top].to_string()), (Some((0.0, 1.0)), "#fde725".to_owned()));
}

#[test]
fn flat_curves_open_curves_and_missing_caps_are_told() {
    let flat = cone(44, [5.0, 5.0]);
    let solution = Rc::new(Solve::run(read_text(&flat.to_string()).expect("valid")).expect("curves"));
    assert_eq!(SolidJob::run(Rc::clone(&solution), SolidOptions::default()), Ok(None));
    let reason = why_no_solid(&solution);
    assert_eq!((reason.code, reason.path.as_str()), (Code::NoSolid, "curves[1].height"));
    assert!(
        reason.message.contains("both are at 5") && reason.message.contains("`height`"),
        "{}",
        reason.message
    );

    let open = |y: f64, height: f64| {
        let points: Vec<DVec2> = (0..8).map(|k| dvec2(f64::from(k), y)).collect();
        json!({"degree": 3, "form": "open", "points": list(&points), "height": height})
    };
    let sheet = solved(
        &document([open(0.0, 0.0), open(2.0, 5.0)], &json!({"method": "greedy"}), [20, 20]),
        with(3, SolidColor::Material),
    );
    assert_eq!((sheet.is_watertight, sheet.volume, sheet.mesh.groups.len()), (false, None, 1));
    assert_eq!(sheet.remarks.iter().map(|remark| remark.code()).collect::<Vec<_>>(), ["open-sheet"]);
    assert!((sheet.area - 7.0 * 2.0_f64.hypot(5.0)).abs() < 1e-9, "{}", sheet.area);

    let tube = solved(&cone(60, [0.0, 3.0]), SolidOptions { caps: false, ..SolidOptions::default() });
    assert_eq!((tube.is_watertight, tube.volume, tube.mesh.groups.len()), (false, None, 1));
    assert!(tube.remarks.is_empty(), "as asked for");
}

/// Far from the origin 32 bits hold vertices apart no more; huge heights are nothing special.
#[test]
fn extreme_documents_are_told_or_built() {
    for height in [1e12, -1e12, 1e-9, 1e-300] {
        let solid = solved(&cone(44, [0.0, height]), with(7, SolidColor::Flank));
        assert!(solid.mesh.positions.iter().all(|position| position.is_finite()));
        assert!(solid.volume.is_none_or(|volume| volume.is_finite() && volume >= 0.0), "{height}");
        assert_eq!(solid.is_watertight, read_again(&solid.mesh).is_ok(), "{height}");
        assert_eq!(solid.is_whole(), height != 1e-300, "32 bits hold no such height");
    }
    let mut far = cone(44, [0.0, 30.0]);
    for curve in far["curves"].as_array_mut().expect("curves") {
        for point in curve["points"].as_array_mut().expect("points") {
            point[0] = json!(point[0].as_f64().expect("a number") + 1e9);
        }
    }
    let solid = solved(&far, with(3, SolidColor::Material));
    assert!(!solid.is_whole() && solid.remarks.iter().any(|remark| remark.code() == "rounded"));
}

#[test]
fn the_largest_mesh_is_bounded() {
    let many = cone(1000, [0.0, 30.0]);
    let solid = solved(&many, with(200, SolidColor::Material));
    assert!(solid.is_watertight && solid.mesh.positions.len() == 201_000);
    let mut fans = many.clone();
    fans["matching"] = json!({"method": "greedy"});
    fans["sampling"]["counts"] = json!([1000, 997]);
    let solution = Solve::run(read_text(&fans.to_string()).expect("valid")).expect("curves");
    let count = solution.band().expect("complete").lines().count();
    let built = SolidJob::run(Rc::new(solution), with(200, SolidColor::Material));
    if count * 201 <= directrix::document::MOST_VERTICES {
        assert!(built.is_ok_and(|solid| solid.is_some_and(|solid| solid.is_watertight)));
    } else {
        let error = built.expect_err("too many");
        assert_eq!((error.code, error.path.as_str()), (Code::Limit, "options.stages"));
        assert!(error.message.contains("expected at most"), "{}", error.message);
    }
}

/// A tiny reader of binary STL: the count, and each triangle with its normal.
fn read_stl(bytes: &[u8]) -> Vec<[DVec3; 4]> {
    assert!(!bytes.starts_with(b"solid"));
    let count = u32::from_le_bytes(bytes[80..84].try_into().expect("four bytes")) as usize;
    assert_eq!(bytes.len(), 84 + 50 * count);
    let number = |at: usize| f64::from(f32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")));
    let vector = |at: usize| dvec3(number(at), number(at + 4), number(at + 8));
    (0..count).map(|k| [0, 1, 2, 3].map(|part| vector(84 + 50 * k + 12 * part))).collect()
}

#[test]
fn stl_is_read_back_with_its_normals() {
    let solid = solved(&turned(192, 16), with(40, SolidColor::Material));
    let mesh = solid.mesh.clone();
    let labels = Labels { title: "Größe\n2".to_owned(), unit: "mm".to_owned(), ..Labels::default() };
    let mut job = FileJob::new(Format::Stl, solid.mesh, solid.colors, &labels);
    assert!(job.step(&mut || false).is_none() && job.progress() > 0.0, "in steps");
    let bytes = job.step(&mut || true).expect("written");
    let head = std::str::from_utf8(&bytes[..80]).expect("ASCII");
    assert_eq!(head.trim_end(), "Directrix binary STL, unit mm, Gr??e?2");
    let triangles = read_stl(&bytes);
    assert_eq!(triangles.len(), mesh.triangles.len());
    let mut volume = 0.0;
    for [normal, a, b, c] in triangles {
        assert!(normal.angle_between((b - a).cross(c - a)) < 1e-6);
        volume += a.dot(b.cross(c)) / 6.0;
    }
    assert!((volume / solid.volume.expect("watertight") - 1.0).abs() < 1e-5);
}

#[test]
fn options_of_files_need_a_format() {
    let read = |text: &str| SolidOptions::read_file(&Json::parse(text).expect("JSON"), 2);
    assert!(read(r#"{"format": "ply", "stages": 3}"#).is_ok_and(|(format, _)| format == Format::Ply));
    for (text, code, path) in [
        ("{}", Code::Missing, "options.format"),
        (r#"{"format": "3mf"}"#, Code::Range, "options.format"),
        (r#"{"format": "stl", "colour": 1}"#, Code::UnknownField, "options.colour"),
    ] {
        let error = read(text).expect_err("refused");
        assert_eq!((error.code, error.path.as_str()), (code, path));
    }
}

/// Control points of a ring round the z axis whose height rises and falls with three times the angle, turned and moved in space.
fn wavy(radius: f64, wave: f64, height: f64, pose: DQuat) -> Value {
    let count = 96;
    let step = TAU / f64::from(count);
    let point = |k: u32, at: DVec2| {
        let rise = 3.0 * wave * (3.0 * step * f64::from(k)).sin() / (2.0 + (3.0 * step).cos());
        (pose * at.extend(height + rise)).to_array()
    };
    let points: Vec<[f64; 3]> = (0..count).zip(circle(radius, 96)).map(|(k, at)| point(k, at)).collect();
    json!({"degree": 3, "form": "periodic", "points": points})
}

fn in_space(waves: [f64; 2], heights: [f64; 2], pose: DQuat) -> Value {
    let curves = [wavy(10.0, waves[0], heights[0], pose), wavy(25.0, waves[1], heights[1], pose)];
    document(curves, &json!({"method": "shift", "shift": 16}), [192, 192])
}

fn solution_of(document: &Value) -> Solution {
    Solve::run(read_text(&document.to_string()).expect("fields in range")).expect("curves")
}

/// Points with a z of their own that lie level are plane curves at those heights, and say what was assumed.
#[test]
fn level_curves_in_space_are_plane_curves() {
    let space = in_space([0.0, 0.0], [-3.0, 27.0], DQuat::IDENTITY);
    let solution = solution_of(&space);
    let projection = solution.model.projection().expect("curves in space");
    assert!(
        (projection.axes[2] - DVec3::Z).length() < 1e-9 && (projection.axes[0] - DVec3::X).length() < 1e-9
    );
    assert!(projection.deviation < 1e-9 && (projection.origin - dvec3(0.0, 0.0, -3.0)).length() < 1e-9);
    assert!(projection.assumed().contains("mean height"));
    let plane = turned(192, 16);
    for color in [SolidColor::Twist, SolidColor::Flank] {
        let [here, there] = [&space, &plane].map(|document| solved(document, with(5, color)));
        assert!((here.volume.expect("watertight") / there.volume.expect("watertight") - 1.0).abs() < 1e-9);
        let pairs = here.mesh.scalars.iter().zip(&there.mesh.scalars);
        assert!(pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-6);
        assert!(solution_of(&plane).model.projection().is_none());
    }
}

/// However curves lie in space, the surface between them is the same, as long as they are seen from the same side: a shift depends on it.
#[test]
fn a_pose_changes_nothing_of_a_solid() {
    let at_rest = in_space([1.5, 2.0], [0.0, 30.0], DQuat::IDENTITY);
    let lines = |solution: &Solution| -> Vec<f64> {
        let (_, lines, _) = solution.lines().expect("lines");
        lines.iter().map(|line| line.value).collect()
    };
    let expected = lines(&solution_of(&at_rest));
    let surface = |solid: &Solid| {
        let triangles = &solid.mesh.triangles[solid.mesh.groups[0].triangles.clone()];
        triangles
            .iter()
            .map(|&t| solid.mesh.corners(t))
            .map(|[a, b, c]| (b - a).cross(c - a).length())
            .sum::<f64>()
    };
    let at_rest = solved(&at_rest, with(8, SolidColor::Flank));
    for (axis, angle) in [(DVec3::X, 0.7), (dvec3(1.0, -2.0, 0.5), 1.0), (DVec3::Y, PI / 2.0)] {
        let pose = DQuat::from_axis_angle(axis.normalize(), angle);
        let moved = in_space([1.5, 2.0], [0.0, 30.0], pose);
        let solution = solution_of(&moved);
        let axes = solution.model.projection().expect("curves in space").axes;
        assert!((axes[2].dot(pose * DVec3::Z).abs() - 1.0).abs() < 1e-9);
        let found = lines(&solution);
        assert!(found.len() == expected.len() && solution.is_complete());
        assert!(found.iter().zip(&expected).all(|(a, b)| (a / b - 1.0).abs() < 1e-6), "{angle}");
        let solid = solved(&moved, with(8, SolidColor::Flank));
        assert!((surface(&solid) / surface(&at_rest) - 1.0).abs() < 1e-9, "{angle}");
        let volume = read_again(&solid.mesh).expect("watertight");
        assert!((volume / at_rest.volume.expect("watertight") - 1.0).abs() < 1e-6, "{angle}: {volume}");
        for position in &solid.mesh.positions {
            let back = pose.inverse() * *position;
            assert!(back.truncate().length() > 8.0 && (-2.1..=32.1).contains(&back.z), "{back}");
        }
    }
}

/// The rims of the solid are the curves in space, not their projections; the map of flanks knows their slope.
#[test]
fn rims_and_angles_are_those_in_space() {
    let solid = solved(&in_space([1.5, 2.0], [0.0, 30.0], DQuat::IDENTITY), with(6, SolidColor::Flank));
    for (stage, [wave, height, radius]) in [(0, [1.5, 0.0, 10.0]), (6, [2.0, 30.0, 25.0])] {
        for point in &solid.stages[stage] {
            let angle = point.y.atan2(point.x);
            assert!((point.z - height - wave * (3.0 * angle).sin()).abs() < 1e-5, "{point}");
            assert!((point.truncate().length() - radius).abs() < 1e-5);
        }
    }
    let deviation = solution_of(&in_space([1.5, 2.0], [0.0, 30.0], DQuat::IDENTITY));
    assert!((deviation.model.projection().expect("curves in space").deviation - 2.0).abs() < 1e-3);
    // By differences of the exact curves, at the first ruling.
    let at = |radius: f64, wave: f64, height: f64, angle: f64| {
        (radius * DVec2::from_angle(angle)).extend(height + wave * (3.0 * angle).sin())
    };
    let start = TAU / 96.0;
    let tangent = |radius: f64, wave: f64, angle: f64| {
        at(radius, wave, 0.0, angle + 1e-5) - at(radius, wave, 0.0, angle - 1e-5)
    };
    let ruling = at(25.0, 2.0, 30.0, start + FRAC_PI_6) - at(10.0, 1.5, 0.0, start);
    let normals = [tangent(10.0, 1.5, start), tangent(25.0, 2.0, start + FRAC_PI_6)].map(|t| t.cross(ruling));
    let flank = normals[0].angle_between(normals[1]).to_degrees();
    assert!((solid.mesh.scalars[0] - flank).abs() < 1e-2, "{}, {flank}", solid.mesh.scalars[0]);
}

#[test]
fn wrong_curves_in_space_are_refused_by_path() {
    let refused = |edit: &dyn Fn(&mut Value)| {
        let mut document = in_space([1.0, 1.0], [0.0, 30.0], DQuat::IDENTITY);
        edit(&mut document);
        match read_text(&document.to_string()).and_then(Solve::run) {
            Err(error) => (error.code, error.path, error.message),
            Ok(Solution { outcome: Outcome::Refused(error), .. }) => (error.code, error.path, error.message),
            Ok(_) => panic!("accepted"),
        }
    };
    let is = |edit: &dyn Fn(&mut Value), code: Code, path: &str| {
        let (found, at, message) = refused(edit);
        assert_eq!((found, at.as_str()), (code, path), "{message}");
        message
    };
    is(&|d| d["curves"][1]["points"][4] = json!([1, 2]), Code::Type, "curves[1].points[4]");
    is(&|d| d["curves"][0]["points"][4] = json!([1, 2, 3, 4]), Code::Type, "curves[0].points[4]");
    is(&|d| d["curves"][0]["points"][4][2] = json!(1e13), Code::Range, "curves[0].points[4][2]");
    is(&|d| d["curves"][1] = curve(&circle(25.0, 96), 0.0), Code::Type, "curves[1].points");
    is(&|d| d["curves"][0]["height"] = json!(2), Code::Range, "curves[0].height");
    let straight: Vec<[f64; 3]> = (0..6).map(|k| [f64::from(k), 2.0 * f64::from(k), 3.0]).collect();
    let line = json!({"degree": 3, "form": "periodic", "points": straight});
    is(&|d| d["curves"] = json!([line, line]), Code::ZeroLength, "curves");
    let point = json!({"degree": 3, "form": "periodic", "points": vec![[1, 1, 1]; 6]});
    is(&|d| d["curves"][0] = point.clone(), Code::ZeroLength, "curves[0].points");
    let clamped = json!({"degree": 2, "form": "clamped",
        "points": [[20, 0, 0], [0, 20, 0], [-20, 0, 0], [0, -20, 0], [20, 0, 1e-3]]});
    is(&|d| d["curves"][0] = clamped.clone(), Code::Points, "curves[0].points[4]");
    // Loops that pass each other in space, one above the other.
    let eight: Vec<[f64; 3]> = (0..24)
        .map(|k| TAU * f64::from(k) / 24.0)
        .map(|t| [20.0 * t.sin(), 10.0 * (2.0 * t).sin(), 3.0 * t.cos()])
        .collect();
    let eight = json!({"degree": 3, "form": "periodic", "points": eight});
    let message = is(&|d| d["curves"][0] = eight.clone(), Code::SelfIntersection, "curves[0].points");
    assert!(message.starts_with("as they are seen on the plane"), "{message}");
}

#[test]
fn documents_in_space_are_written_as_they_were_read_and_take_points() {
    let text = in_space([1.0, 2.0], [0.0, 30.0], DQuat::from_rotation_x(0.3)).to_string();
    let document = read_text(&text).expect("valid");
    let written = write_text(&document).expect("finite");
    assert_eq!(read_text(&written), Ok(document.clone()));
    let points =
        |text: &str| serde_json::from_str::<Value>(text).expect("JSON")["curves"][1]["points"].clone();
    assert_eq!(points(&written), points(&text));
    let more = insert_point(document.clone(), 1, 0.3).expect("inserted");
    assert_eq!(more.curves[1].points.len(), 97);
    let solids = [document, more].map(|document| {
        let solution = Rc::new(Solve::run(document).expect("curves"));
        SolidJob::run(solution, with(3, SolidColor::Material)).expect("within limits").expect("a solid")
    });
    let pairs = solids[0].stages.iter().flatten().zip(solids[1].stages.iter().flatten());
    assert!(pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) < 1e-6, "the shape stays");

    let level = in_space([0.0, 0.0], [5.0, 5.0], DQuat::from_rotation_y(1.0));
    let reason = why_no_solid(&solution_of(&level));
    assert_eq!((reason.code, reason.path.as_str()), (Code::NoSolid, "curves[1].points"));
}

/// Whatever single coordinates, heights and compositions become, solids and files are built or refused, with finite numbers.
#[test]
fn wild_documents_are_built_or_refused() {
    const WILD: [f64; 9] = [0.0, -0.0, 1.0, 1e12, -1e12, 1e-12, 1e-300, 17.0, -3e5];
    let wild = || proptest::sample::select(WILD.to_vec());
    let edits = proptest::collection::vec((0..2_usize, 0..16_usize, 0..3_usize, wild()), 0..4);
    let strategy = (edits, wild(), any::<[bool; 3]>(), 1..4_usize, 0..3_usize);
    seeded(250, &strategy, |(edits, height, [space, open, caps], stages, format)| {
        let ring = |radius: f64, z: f64| {
            let points = (0..16)
                .map(|k| radius * DVec2::from_angle(f64::from(k) * if open { 0.2 } else { TAU / 16.0 }));
            let points: Value =
                points.map(|p| if space { json!([p.x, p.y, z]) } else { json!([p.x, p.y]) }).collect();
            let height = if space { 0.0 } else { z };
            json!({"degree": 3, "form": if open { "open" } else { "periodic" }, "points": points, "height": height})
        };
        let mut document = document(
            [ring(10.0, 0.0), ring(25.0, height)],
            &json!({"method": "greedy", "policy": "repair"}),
            [12, 16],
        );
        for (curve, point, axis, value) in edits {
            document["curves"][curve]["points"][point][axis.min(if space { 2 } else { 1 })] = json!(value);
        }
        let Ok(solution) = read_text(&document.to_string()).and_then(Solve::run) else { return Ok(()) };
        let options = SolidOptions { stages: Some(stages), caps, color: SolidColor::Flank };
        let built = SolidJob::run(Rc::new(solution), options);
        prop_assert!(built.is_ok());
        let Ok(Some(solid)) = built else { return Ok(()) };
        prop_assert!(solid.mesh.positions.iter().all(|position| position.is_finite()));
        prop_assert!(solid.area.is_finite() && solid.volume.is_none_or(f64::is_finite));
        prop_assert_eq!(
            solid.is_watertight,
            read_again(&solid.mesh).is_ok() && !solid.mesh.triangles.is_empty()
        );
        let format = [Format::Stl, Format::Ply, Format::Obj][format];
        let bytes = FileJob::new(format, solid.mesh, solid.colors, &Labels::default()).step(&mut || true);
        prop_assert!(bytes.is_some_and(|bytes| !bytes.is_empty()));
        Ok(())
    });
}
