//! Pictures end to end: golden pictures, colours by number, limits, random input, SVG.

#![cfg(feature = "curves")]

mod xml;

use std::f64::consts::TAU;

use self::xml::{elements, is_xml};
use crate::support::golden::{self, Picture, SAME_CODE, differences};
use directrix::geom::Bounds;
use directrix::material::{Color, Composition, Oklab, mix_colors};
use directrix::picture::{
    DisplayList, Item, Margins, Mesh, PaintError, Path, StrokeStyle, Theme, Viewport, paint, to_svg,
};
use glam::DVec2;
use palette::{FromColor, IntoColor, Srgb};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

const YELLOW: Color = Color::new(0xf0, 0xe4, 0x42);
const BLUE: Color = Color::new(0x00, 0x72, 0xb2);
const GREEN: Color = Color::new(0x00, 0x9e, 0x73);
const MAGENTA: Color = Color::new(0xff, 0x00, 0xff);

/// Radii of the annulus of the tests, in units.
const INNER: f64 = 20.0;
const OUTER: f64 = 50.0;

fn circle(radius: f64, count: usize) -> Vec<DVec2> {
    (0..count).map(|i| DVec2::from_angle(TAU * i as f64 / count as f64) * radius).collect()
}

/// An annulus of yellow (inside) to blue with `sectors` times `rings` cells. With `turn`, colours also change round it.
fn annulus(sectors: usize, rings: usize, turn: bool) -> Item {
    let labs = [YELLOW, BLUE, GREEN].map(Color::to_oklab);
    let mut mesh = Mesh::default();
    for i in 0..sectors {
        let direction = DVec2::from_angle(TAU * i as f64 / sectors as f64);
        let around = if turn { (1.0 + direction.y) / 2.0 } else { 0.0 };
        for j in 0..=rings {
            let s = j as f64 / rings as f64;
            mesh.vertices.push(direction * (INNER + (OUTER - INNER) * s));
            let mix = Composition::new(vec![1.0 - s, s * (1.0 - around), s * around]).unwrap();
            mesh.colors.push(mix_colors(&labs, &mix));
        }
    }
    let index = |i: usize, j: usize| ((i % sectors) * (rings + 1) + j) as u32;
    for i in 0..sectors {
        for j in 0..rings {
            let [a, b, c, d] = [index(i, j), index(i, j + 1), index(i + 1, j + 1), index(i + 1, j)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let outline = Path { rings: vec![circle(INNER, sectors), circle(OUTER, sectors)], closed: true };
    Item::Mesh { mesh, outline, opacity: 1.0 }
}

fn view(width: u32, height: u32, scale: f64) -> Viewport {
    Viewport { width, height, center: DVec2::ZERO, scale, pixel_ratio: 1.0 }
}

fn only(background: Option<Color>, item: Item) -> DisplayList {
    let mut list = DisplayList::new(background);
    list.push("test", item);
    list
}

fn picture(list: &DisplayList, view: &Viewport) -> Picture {
    let data = paint(list, view).unwrap();
    assert_eq!(data.len(), view.width as usize * view.height as usize * 4);
    Picture { width: view.width, height: view.height, data }
}

fn pixel(data: &[u8], view: &Viewport, x: u32, y: u32) -> [u8; 4] {
    let i = (y as usize * view.width as usize + x as usize) * 4;
    [data[i], data[i + 1], data[i + 2], data[i + 3]]
}

/// A figure with everything: grid, band, in-between curves, ruling lines, outlines, samples, probe and marks.
fn figure(theme: &Theme) -> DisplayList {
    let rings = |radii: &[f64]| Path { rings: radii.iter().map(|&r| circle(r, 180)).collect(), closed: true };
    let stroke = |path: Path, style| Item::Stroke { path, style };
    let mut list = DisplayList::new(Some(theme.canvas));
    list.push("grid", Item::Grid { minor: theme.grid_minor, major: theme.grid_major });
    list.push("material", annulus(88, 12, true));
    list.push("inBetweens", stroke(rings(&[26.0, 32.0, 38.0, 44.0]), theme.in_between));
    let lines = circle(1.0, 44).into_iter().map(|d| vec![d * INNER, d * OUTER]).collect();
    list.push("rulingLines", stroke(Path { rings: lines, closed: false }, theme.ruling_line));
    list.push("current", stroke(rings(&[35.0]), theme.current.halo));
    list.push("current", stroke(rings(&[35.0]), theme.current.line));
    list.push("boundary", stroke(rings(&[INNER, OUTER]), theme.boundary));
    let centers = [circle(INNER, 44), circle(OUTER, 44)].concat();
    let (radius_px, color) = (theme.sample_radius, theme.sample);
    list.push("samples", Item::Dots { centers, radius_px, color, opacity: 1.0 });
    list.push("controlPoints", stroke(Path::closed(circle(56.0, 11)), theme.control_polygon));
    let at = DVec2::new(OUTER, 0.0);
    list.push("errors", stroke(Path::open(vec![DVec2::new(0.0, INNER), at]), theme.error));
    list.push("errors", Item::Crosses { centers: vec![at], size_px: 9.0, style: theme.error });
    list.push("errors", Item::Rings { centers: vec![-at], radius_px: 6.0, style: theme.error });
    list
}

#[test]
fn golden_figures() {
    for (name, theme) in [("figure-light", Theme::light()), ("figure-dark", Theme::dark())] {
        golden::check(name, &picture(&figure(&theme), &view(360, 300, 2.4)), SAME_CODE);
    }
    let sharp = Viewport { pixel_ratio: 2.0, ..view(360, 300, 18.0) };
    let zoomed = Viewport { center: DVec2::new(44.0, 12.0), ..sharp };
    golden::check("figure-zoomed", &picture(&figure(&Theme::light().compact()), &zoomed), SAME_CODE);
}

#[test]
fn golden_strokes() {
    let mut list = DisplayList::new(Some(Color::new(255, 255, 255)));
    let corner = |y: f64| {
        [(-80.0, 0.0), (-30.0, 9.0), (-25.0, -8.0), (60.0, 3.0), (60.0, -6.0), (84.0, 8.0)]
            .map(|(x, dy)| DVec2::new(x, y + dy))
    };
    for (i, width) in [0.5_f32, 0.75, 1.0, 2.0, 4.5, 14.0].into_iter().enumerate() {
        let style = StrokeStyle::solid(width, Color::new(0x17, 0x19, 0x1d), 0.8);
        let style = if i % 2 == 1 { style.dashed(6.0, 4.0) } else { style };
        let path = Path::open(corner(60.0 - 24.0 * i as f64).to_vec());
        list.push("lines", Item::Stroke { path, style });
    }
    let ring = Path::closed(vec![DVec2::new(-90.0, 70.0), DVec2::new(90.0, 70.0), DVec2::new(0.0, -500.0)]);
    list.push("ring", Item::Stroke { path: ring, style: StrokeStyle::solid(3.0, BLUE, 0.5) });
    list.push("fill", Item::Fill { path: Path::closed(circle(12.0, 5)), color: YELLOW, opacity: 0.5 });
    let dots = vec![DVec2::new(70.0, -30.0), DVec2::new(80.0, -30.0)];
    list.push("dots", Item::Dots { centers: dots, radius_px: 9.0, color: GREEN, opacity: 0.5 });
    golden::check("strokes", &picture(&list, &view(200, 160, 1.0)), SAME_CODE);
}

#[test]
fn golden_grid() {
    let theme = Theme::light();
    let grid = Item::Grid { minor: theme.grid_minor, major: theme.grid_major };
    let near = Viewport { center: DVec2::new(3.3, -1.7), ..view(240, 160, 7.0) };
    golden::check("grid", &picture(&only(Some(theme.canvas), grid), &near), SAME_CODE);
}

/// The colour of a mixture, computed by palette alone.
fn palette_mix(parts: &[(Color, f32)]) -> [u8; 3] {
    let mut sum = palette::Oklab::new(0.0, 0.0, 0.0);
    for &(color, share) in parts {
        let srgb: Srgb<f32> = Srgb::new(color.r, color.g, color.b).into_format();
        let lab: palette::Oklab = srgb.into_color();
        sum = palette::Oklab::new(sum.l + lab.l * share, sum.a + lab.a * share, sum.b + lab.b * share);
    }
    let bytes: Srgb<u8> = Srgb::from_color(sum).into_format();
    [bytes.red, bytes.green, bytes.blue]
}

/// A square whose fractions are linear across it, in coarse and in fine triangles: every pixel within one level of palette.
#[test]
fn every_pixel_has_the_colour_of_its_fractions() {
    let side = 128;
    let viewport = Viewport { center: DVec2::splat(0.5), ..view(side, side, f64::from(side)) };
    for cells in [1_usize, 7, 40] {
        for corners in [[YELLOW, BLUE, GREEN], [BLUE, GREEN, YELLOW], [Color::new(0, 0, 0), MAGENTA, GREEN]] {
            let labs = corners.map(Color::to_oklab);
            let mut mesh = Mesh::default();
            let place = |i: usize| i as f64 / cells as f64;
            for i in 0..=cells {
                for j in 0..=cells {
                    let (x, y) = (place(i), place(j));
                    mesh.vertices.push(DVec2::new(x, y));
                    let mix = vec![1.0 - (x + y) / 2.0, x / 2.0, y / 2.0];
                    mesh.colors.push(mix_colors(&labs, &Composition::new(mix).unwrap()));
                }
            }
            let index = |i: usize, j: usize| (i * (cells + 1) + j) as u32;
            for i in 0..cells {
                for j in 0..cells {
                    let (a, c) = (index(i, j), index(i + 1, j + 1));
                    mesh.triangles.extend([[a, index(i + 1, j), c], [a, c, index(i, j + 1)]]);
                }
            }
            let outline = Path::closed(
                [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec2::new(x, y)).to_vec(),
            );
            let data = paint(&only(None, Item::Mesh { mesh, outline, opacity: 1.0 }), &viewport).unwrap();
            for py in 0..side {
                for px in 0..side {
                    let at =
                        viewport.to_units(DVec2::new(f64::from(px) + 0.5, f64::from(py) + 0.5)).as_vec2();
                    let parts = [1.0 - (at.x + at.y) / 2.0, at.x / 2.0, at.y / 2.0];
                    let expected = palette_mix(&[0, 1, 2].map(|i| (corners[i], parts[i])));
                    let found = pixel(&data, &viewport, px, py);
                    let apart = (0..3).map(|i| found[i].abs_diff(expected[i])).max().unwrap();
                    assert!(
                        apart <= 1 && found[3] == 255,
                        "{cells} cells, ({px}, {py}): {found:?}, expected {expected:?}"
                    );
                }
            }
        }
    }
}

/// Whether all of a pixel is inside the annulus as drawn, and whether all of it is outside.
fn inside(at: DVec2, sectors: usize, scale: f64) -> (bool, bool) {
    // The polygon lies between its circumscribed circle and the one inscribed; half a pixel's diagonal, and a bit.
    let flat = (TAU / (2.0 * sectors as f64)).cos();
    let reach = 0.75 / scale;
    let r = at.length();
    let within = r > INNER + reach && r < OUTER * flat - reach;
    let without = r < INNER * flat - reach || r > OUTER + reach;
    (within, without)
}

#[test]
fn no_background_shows_between_cells() {
    for (sectors, rings, scale, turn) in
        [(88, 12, 2.7, true), (44, 5, 2.31, false), (700, 60, 1.3, true), (9, 2, 2.9, false)]
    {
        let viewport = view(300, 300, scale);
        let mut item = annulus(sectors, rings, turn);
        let backgrounds = [MAGENTA, Color::new(0, 0, 0)];
        let opaque = backgrounds.map(|b| paint(&only(Some(b), item.clone()), &viewport).unwrap());
        let Item::Mesh { opacity, .. } = &mut item else { unreachable!() };
        *opacity = 0.5;
        let faint = paint(&only(None, item), &viewport).unwrap();
        let mut counted = [0; 2];
        for y in 0..300 {
            for x in 0..300 {
                let at = viewport.to_units(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5));
                let (within, without) = inside(at, sectors, scale);
                let found = opaque.each_ref().map(|data| pixel(data, &viewport, x, y));
                if within {
                    assert_eq!(found[0], found[1], "({x}, {y}) lets the background through");
                    assert_eq!(pixel(&faint, &viewport, x, y)[3], 128, "({x}, {y}) is not painted once");
                    counted[0] += 1;
                } else if without {
                    assert_eq!(found[0], [255, 0, 255, 255], "({x}, {y}) is outside");
                    assert_eq!(pixel(&faint, &viewport, x, y)[3], 0);
                    counted[1] += 1;
                }
            }
        }
        assert!(counted[0] > 9_000 && counted[1] > 2_000, "{counted:?}");
    }
}

/// The band's border has the coverage of its polygon: the alpha of the picture adds up to the area, and it is graded.
#[test]
fn the_outline_is_anti_aliased() {
    let (sectors, scale) = (88, 2.7);
    let viewport = view(300, 300, scale);
    let data = paint(&only(None, annulus(sectors, 12, false)), &viewport).unwrap();
    let sum: f64 = data.chunks_exact(4).map(|p| f64::from(p[3]) / 255.0).sum();
    let area =
        sectors as f64 / 2.0 * (TAU / sectors as f64).sin() * (OUTER * OUTER - INNER * INNER) * scale * scale;
    assert!((sum - area).abs() < 0.002 * area, "{sum}, expected {area}");
    let graded = data.chunks_exact(4).filter(|p| p[3] > 0 && p[3] < 255).count();
    // A circle crosses 4/pi pixels for each of its length; the smallest slivers escape the sixteen samples of a pixel.
    let around = TAU * (INNER + OUTER) * scale;
    assert!((graded as f64) > 0.8 * around && (graded as f64) < 1.28 * around, "{graded} on {around} pixels");
    let blue = palette_mix(&[(BLUE, 1.0)]);
    for pixel in data.chunks_exact(4).filter(|p| p[3] > 20 && p[3] < 255) {
        let near = |expected: [u8; 3]| (0..3).all(|i| pixel[i].abs_diff(expected[i]) <= 24);
        assert!(near(blue) || near([YELLOW.r, YELLOW.g, YELLOW.b]), "{pixel:?} is no colour of the border");
    }
}

/// A view moved by whole pixels shows the same pixels moved, but for rounding in the rasteriser of wide strokes and masks.
#[test]
fn a_shift_by_whole_pixels_shifts_the_picture() {
    let list = figure(&Theme::light());
    let viewport = view(256, 256, 2.0);
    let (dx, dy) = (17_usize, 9_usize);
    let shifted = Viewport { center: DVec2::new(dx as f64, -(dy as f64)) / 2.0, ..viewport };
    let (a, b) = (paint(&list, &viewport).unwrap(), paint(&list, &shifted).unwrap());
    let row = 256 * 4;
    let moved: Vec<u8> =
        (0..256 - dy).flat_map(|y| a[(y + dy) * row + dx * 4..(y + dy + 1) * row].to_vec()).collect();
    let cut: Vec<u8> = (0..256 - dy).flat_map(|y| b[y * row..(y + 1) * row - dx * 4].to_vec()).collect();
    let apart = differences(&moved, &cut);
    let count = apart.iter().filter(|&&d| d > 1).count();
    assert!(
        count <= apart.len() / 2000,
        "{count} of {} pixels, by up to {:?}",
        apart.len(),
        apart.iter().max()
    );
}

/// A closed line has no mark where it starts: turning the list of its points changes nothing.
#[test]
fn closed_lines_have_no_seam() {
    let viewport = view(160, 160, 1.0);
    let ring = circle(60.0, 97);
    for (width, pixel_ratio) in [(1.0, 1.0), (2.0, 1.0), (4.5, 2.0), (9.0, 2.0)] {
        let viewport = Viewport { pixel_ratio, ..viewport };
        let style = StrokeStyle::solid(width, BLUE, 0.6);
        let [a, b] = [0, 31].map(|turn| {
            let mut points = ring.clone();
            points.rotate_left(turn);
            paint(&only(None, Item::Stroke { path: Path::closed(points), style }), &viewport).unwrap()
        });
        assert!(differences(&a, &b).iter().all(|&d| d <= 2), "width {width}");
        // No pixel is stronger than the opacity: segments do not add up at their joints.
        assert!(a.chunks_exact(4).all(|p| p[3] <= 154), "width {width}");
    }
}

#[test]
fn strokes_grow_with_the_pixel_ratio() {
    let line = Path::open(vec![DVec2::new(-100.0, 0.0), DVec2::new(100.0, 0.0)]);
    let list = only(None, Item::Stroke { path: line, style: StrokeStyle::solid(1.5, BLUE, 1.0) });
    for pixel_ratio in [1.0, 2.0, 3.0] {
        let viewport = Viewport { pixel_ratio, ..view(50, 50, 1.0) };
        let data = paint(&list, &viewport).unwrap();
        let thick: f64 = (0..50).map(|y| f64::from(pixel(&data, &viewport, 25, y)[3]) / 255.0).sum();
        assert!((thick - 1.5 * pixel_ratio).abs() < 0.02, "{thick}");
    }
}

/// Dashes start where the line starts, also when that is far outside the picture.
#[test]
fn dashes_keep_their_place_when_the_line_is_cut() {
    let style = StrokeStyle::solid(2.0, BLUE, 1.0).dashed(6.0, 4.0);
    let dashes = |start: f64| {
        let line = Path::open(vec![DVec2::new(start, 0.5), DVec2::new(1000.0, 0.5)]);
        paint(&only(None, Item::Stroke { path: line, style }), &view(100, 11, 1.0)).unwrap()
    };
    let near = dashes(-60.0);
    assert!(differences(&near, &dashes(-60.0 - 10.0 * 4e5)).iter().all(|&d| d <= 8));
    let row: Vec<bool> = near.chunks_exact(4).skip(5 * 100).take(100).map(|p| p[3] > 127).collect();
    let expected: Vec<bool> = (0..100).map(|x| x % 10 < 6).collect();
    assert_eq!(row, expected);
}

#[test]
fn without_background_the_picture_is_straight_rgba() {
    let square = Path::closed(circle(200.0, 4));
    for opacity in [1.0, 0.5, 0.1] {
        let list = only(None, Item::Fill { path: square.clone(), color: YELLOW, opacity });
        let found = pixel(&paint(&list, &view(9, 9, 1.0)).unwrap(), &view(9, 9, 1.0), 4, 4);
        assert!((f32::from(found[3]) - 255.0 * opacity).abs() <= 1.0);
        let steps = (0.6 / opacity).ceil() as u8;
        assert!(found[0].abs_diff(YELLOW.r) <= steps && found[2].abs_diff(YELLOW.b) <= steps, "{found:?}");
    }
    assert!(paint(&DisplayList::new(None), &view(3, 2, 1.0)).unwrap().iter().all(|&v| v == 0));
}

#[test]
fn limits_are_refused_with_a_reason() {
    let empty = DisplayList::new(None);
    for (width, height) in [(0, 5), (5, 0), (4097, 1), (1, u32::MAX)] {
        assert_eq!(paint(&empty, &view(width, height, 1.0)), Err(PaintError::Size { width, height }));
    }
    assert!(paint(&empty, &view(4096, 1, 1.0)).is_ok());

    let line = |style| Item::Stroke { path: Path::open(circle(3.0, 5)), style };
    let fields = [
        (line(StrokeStyle::solid(f32::NAN, BLUE, 1.0)), "stroke width is NaN"),
        (line(StrokeStyle::solid(1001.0, BLUE, 1.0)), "stroke width is 1001"),
        (line(StrokeStyle::solid(1.0, BLUE, 1.5)), "opacity is 1.5"),
        (line(StrokeStyle::solid(1.0, BLUE, 1.0).dashed(-1.0, 1.0)), "dash is -1"),
        (Item::Fill { path: Path::closed(vec![DVec2::NAN]), color: BLUE, opacity: 1.0 }, "coordinate is NaN"),
        (
            Item::Dots { centers: vec![DVec2::INFINITY], radius_px: 1.0, color: BLUE, opacity: 1.0 },
            "coordinate is inf",
        ),
    ];
    for (item, reason) in fields {
        let list = only(None, item);
        let error = paint(&list, &view(9, 9, 1.0)).unwrap_err().to_string();
        assert!(
            error.contains(reason) && error.contains("\"test\"") && error.contains("expected"),
            "{error}"
        );
        assert!(!to_svg(&list, &view(9, 9, 1.0), "", "").contains("<path"));
    }

    let mut mesh =
        Mesh { vertices: circle(1.0, 3), colors: vec![BLUE.to_oklab(); 3], triangles: vec![[0, 1, 3]] };
    let item = |mesh: &Mesh| Item::Mesh { mesh: mesh.clone(), outline: Path::default(), opacity: 1.0 };
    let error = paint(&only(None, item(&mesh)), &view(9, 9, 1.0)).unwrap_err();
    assert_eq!(error, PaintError::MeshIndex { layer: "test".to_owned(), triangle: 0, index: 3, vertices: 3 });
    mesh.colors.pop();
    assert!(matches!(paint(&only(None, item(&mesh)), &view(9, 9, 1.0)), Err(PaintError::MeshColors { .. })));
}

fn runner(cases: u32) -> TestRunner {
    let seed = [0x5d; 32];
    println!("seed of the generator: {seed:?}");
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &seed))
}

/// Coordinates from tiny to extreme, many of them equal.
fn coordinate() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        4 => -60.0..60.0_f64,
        1 => (-8..8_i32).prop_map(f64::from),
        1 => prop::sample::select(vec![0.0, -0.0, 1e-300, 1e6, -1e6, 1e12, -1e12, 1e15, 1e300, -1e300, f64::MAX]),
    ]
}

fn points(most: usize) -> impl Strategy<Value = Vec<DVec2>> + Clone {
    prop::collection::vec((coordinate(), coordinate()).prop_map(|(x, y)| DVec2::new(x, y)), 0..most)
}

fn any_item() -> impl Strategy<Value = Item> {
    let color = any::<(u8, u8, u8)>().prop_map(|(r, g, b)| Color::new(r, g, b));
    let dash = prop::option::of((0.0..20.0_f32, 0.0..20.0_f32).prop_map(|(a, b)| [a, b]));
    let width = prop_oneof![3 => 0.0..6.0_f32, 1 => 0.0..1000.0_f32];
    let style = (width, color.clone(), 0.0..=1.0_f32, dash)
        .prop_map(|(width_px, color, opacity, dash)| StrokeStyle { width_px, color, opacity, dash });
    let path = (prop::collection::vec(points(12), 0..4), any::<bool>())
        .prop_map(|(rings, closed)| Path { rings, closed });
    let mesh = (points(30), any::<u64>(), prop::collection::vec(any::<[u32; 3]>(), 0..60)).prop_map(
        |(vertices, seed, mut triangles)| {
            let count = vertices.len() as u32;
            if count == 0 {
                triangles.clear();
            }
            triangles.iter_mut().flatten().for_each(|i| *i %= count.max(1));
            let part =
                |i: u64, k: u64| (seed.rotate_left((i * 7 + k * 13) as u32 % 64) % 1000) as f32 / 1000.0;
            let colors = (0..u64::from(count)).map(|i| Oklab {
                l: part(i, 0),
                a: part(i, 1) - 0.5,
                b: part(i, 2) - 0.5,
            });
            Mesh { colors: colors.collect(), vertices, triangles }
        },
    );
    prop_oneof![
        (mesh, path.clone(), 0.0..=1.0_f32).prop_map(|(mesh, outline, opacity)| Item::Mesh {
            mesh,
            outline,
            opacity
        }),
        (path.clone(), style.clone()).prop_map(|(path, style)| Item::Stroke { path, style }),
        (path, color.clone(), 0.0..=1.0_f32).prop_map(|(path, color, opacity)| Item::Fill {
            path,
            color,
            opacity
        }),
        (points(9), 0.0..20.0_f32, color, 0.0..=1.0_f32).prop_map(|(centers, radius_px, color, opacity)| {
            Item::Dots { centers, radius_px, color, opacity }
        }),
        (points(9), 0.0..20.0_f32, style.clone()).prop_map(|(centers, radius_px, style)| Item::Rings {
            centers,
            radius_px,
            style
        }),
        (points(9), 0.0..20.0_f32, style.clone()).prop_map(|(centers, size_px, style)| Item::Crosses {
            centers,
            size_px,
            style
        }),
        (style.clone(), style).prop_map(|(minor, major)| Item::Grid { minor, major }),
    ]
}

fn any_view() -> impl Strategy<Value = Viewport> {
    let scale = prop_oneof![3 => -1.0..2.0_f64, 1 => -15.0..15.0_f64].prop_map(|e| 10.0_f64.powf(e));
    let center = prop_oneof![3 => -50.0..50.0_f64, 1 => prop::sample::select(vec![0.0, 1e12, -1e15])];
    (1..90_u32, 1..90_u32, center.clone(), center, scale, 0.5..3.0_f64).prop_map(
        |(width, height, x, y, scale, pixel_ratio)| Viewport {
            width,
            height,
            center: DVec2::new(x, y),
            scale,
            pixel_ratio,
        },
    )
}

/// Whatever is drawn, wherever: no panic, the same bytes twice, and finite numbers in well-formed SVG.
#[test]
fn random_pictures_are_painted_without_panic() {
    let list = (prop::collection::vec(any_item(), 1..5), any::<bool>());
    runner(600)
        .run(&(list, any_view()), |((items, opaque), viewport)| {
            let mut list = DisplayList::new(opaque.then_some(YELLOW));
            items.into_iter().for_each(|item| list.push("random", item));
            let data = paint(&list, &viewport).map_err(|e| TestCaseError::fail(e.to_string()))?;
            prop_assert_eq!(&data, &paint(&list, &viewport).unwrap());
            if opaque {
                prop_assert!(data.chunks_exact(4).all(|p| p[3] == 255));
            }
            let svg = to_svg(&list, &viewport, "random", "");
            prop_assert!(!svg.contains("NaN") && !svg.contains("inf"));
            elements(&svg).map_err(TestCaseError::fail)?;
            Ok(())
        })
        .unwrap();
}

/// Random texts as title, description and layer names come back as text, and add no element.
#[test]
fn hostile_texts_stay_texts() {
    let text = prop_oneof![
        any::<String>(),
        "[<>&\"'/;#x0-9a-z!\\[\\]\\- ]{0,40}",
        prop::sample::select(vec![
            "</title><script>alert(1)</script>".to_owned(),
            "]]>".to_owned(),
            "\" onload=\"alert(1)".to_owned(),
            "<!--".to_owned(),
            "&lt;b&gt;".to_owned(),
        ]),
    ];
    let plain = elements(&hostile("", "x", "")).unwrap().len();
    runner(400)
        .run(&(text.clone(), text.clone(), text), |(title, description, name)| {
            let description = format!("{description}.");
            let found = elements(&hostile(&title, &description, &name)).map_err(TestCaseError::fail)?;
            prop_assert_eq!(found.len(), plain);
            let readable =
                |t: &str| t.chars().map(|c| if is_xml(c) { c } else { '\u{fffd}' }).collect::<String>();
            prop_assert_eq!(&found[1], &("title".to_owned(), readable(&title)));
            prop_assert_eq!(&found[2], &("desc".to_owned(), readable(&description)));
            Ok(())
        })
        .unwrap();
}

fn hostile(title: &str, description: &str, layer: &str) -> String {
    let mut list = DisplayList::new(None);
    list.push(layer, Item::Dots { centers: vec![DVec2::ZERO], radius_px: 1.0, color: BLUE, opacity: 1.0 });
    to_svg(&list, &view(9, 9, 1.0), title, description)
}

#[test]
fn svg_holds_the_layers_and_the_styles() {
    let theme = Theme::light();
    let svg = to_svg(
        &figure(&theme),
        &Viewport { pixel_ratio: 2.0, ..view(720, 600, 4.8) },
        "Amoeba",
        "Two curves",
    );
    let found = elements(&svg).unwrap();
    assert_eq!(found[0].0, "svg");
    for part in [
        "width=\"360\" height=\"300\" viewBox=\"0 0 360 300\"",
        "<title>Amoeba</title>",
        "<desc>Two curves</desc>",
        "id=\"layer-material\"",
        "id=\"layer-rulingLines\"",
        "stroke-dasharray=\"4 3\"",
        "stroke-dasharray=\"2 4\"",
        "stroke=\"#101216\" stroke-width=\"0.75\" stroke-opacity=\"0.5\"",
        "clip-path=\"url(#clip-",
        "clip-rule=\"evenodd\"",
    ] {
        assert!(svg.contains(part), "{part} is missing");
    }
    assert_eq!(svg.matches("<circle").count(), 89);
    // y is turned: the cross at the right end of the annulus, above nothing, in the middle of the height.
    assert!(svg.contains("M295.5 145.5l9 9M295.5 154.5l9 -9"), "the cross is elsewhere");
}

/// Pictures written into one page share its ids: those of one band must not shade another band of the same outline.
#[test]
fn svg_ids_of_differently_coloured_bands_differ() {
    let ids = |item: Item| {
        let svg = to_svg(&only(None, item), &view(90, 90, 0.8), "t", "");
        let parts = svg.split(" id=\"").skip(1).filter_map(|part| part.split_once('"'));
        let ids = parts.map(|(id, _)| id.to_owned()).filter(|id| !id.starts_with("layer-"));
        ids.collect::<std::collections::BTreeSet<_>>()
    };
    let yellow = annulus(24, 4, false);
    let mut green = yellow.clone();
    let Item::Mesh { mesh, .. } = &mut green else { unreachable!() };
    mesh.colors.iter_mut().for_each(|color| color.a -= 0.1);
    let (yellow, green, again) = (ids(yellow.clone()), ids(green), ids(yellow));
    assert!(yellow.len() > 24 && yellow == again);
    assert!(yellow.is_disjoint(&green));
}

#[test]
fn svg_of_an_unusable_view_is_an_empty_picture() {
    let svg = to_svg(&figure(&Theme::dark()), &view(0, 0, f64::NAN), "t", "");
    assert_eq!(elements(&svg).unwrap().len(), 2);
}

#[test]
fn fit_shows_the_whole_figure() {
    let bounds = Bounds::of(circle(OUTER, 90)).unwrap();
    let viewport = Viewport::fit(bounds, 200, 120, 1.0, Margins::all(8.0));
    let data = paint(&only(None, annulus(90, 4, false)), &viewport).unwrap();
    let rows: Vec<usize> = (0..120).filter(|y| data[y * 800..(y + 1) * 800].iter().any(|&v| v > 0)).collect();
    assert_eq!((rows[0], rows[rows.len() - 1]), (8, 111));
}
