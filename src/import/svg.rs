//! Shapes of SVG.

use super::outline::Outline;
use super::svg_path::{parse, subpaths};
use super::svg_transform::{fitted, length, transform, view_box};
use super::{Shapes, Skipped};
use crate::document::{Code, DocumentError};
use kurbo::{Affine, BezPath, Ellipse, Rect, RoundedRect, RoundedRectRadii, Shape as _, Vec2};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::HashMap;
use svgtypes::PointsParser;

/// Most nodes of the tree, and most elements that are visited, those in uses counted each time.
const MOST_NODES: u32 = 100_000;
/// Most segments of all paths.
pub(super) const MOST_SEGMENTS: usize = 20_000;
/// Most elements and uses in each other.
const DEEPEST: usize = 100;
/// Size of a viewport that does not tell it, as browsers have it.
const VIEWPORT: Vec2 = Vec2::new(300.0, 150.0);
/// Precision of circles and ellipses, relative to their size.
const ROUND: f64 = 1e-7;

/// Reads the closed shapes of an SVG text, in user units of its root, with y turned up.
///
/// Paths with all their commands, rectangles, circles, ellipses, polygons and polylines count, with the transforms of their
/// elements, of nested views and of uses. What is not shown by itself (definitions, clips, masks, markers, patterns,
/// `display: none`) does not. Every part of a path between two moves is a shape of its own. An open part whose ends
/// are within 1 % of its size is closed by a straight edge; another one is skipped. Names are the `id`, the title,
/// or what the element is and the how manieth. Strokes, texts, images and style sheets are not looked at.
///
/// # Errors
/// With the line: text that is not XML. With code `limit`: more than 100 000 nodes, 20 000 segments or 100 levels. With code
/// `type`: another root than `svg`. With code `missing`: no shape, not even one that would be skipped.
pub fn from_svg(text: &str) -> Result<Shapes, DocumentError> {
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let document = Document::parse_with_options(text, options).map_err(|error| {
        if matches!(error, roxmltree::Error::NodesLimitReached) {
            let message = format!("more than {MOST_NODES} nodes were found; expected at most that many");
            return DocumentError::new(Code::Limit, "", message);
        }
        let message = format!("the text is not SVG that can be read: {error}");
        DocumentError::new(Code::Syntax, format!("line {}", error.pos().row), message)
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let message = format!("a root element `{}` was found; expected `svg`", root.tag_name().name());
        return Err(DocumentError::new(Code::Type, "", message));
    }
    let mut reader =
        Reader { ids: HashMap::new(), shapes: Shapes::default(), segments: 0, visited: 0, drawn: 0 };
    for node in document.descendants() {
        if let Some(id) = node.attribute("id") {
            reader.ids.entry(id).or_insert(node);
        }
    }
    let size = view_box(root).map_or_else(
        || {
            Vec2::new(
                length(root, "width", VIEWPORT.x).unwrap_or(VIEWPORT.x),
                length(root, "height", VIEWPORT.y).unwrap_or(VIEWPORT.y),
            )
        },
        |view| Vec2::new(view.w, view.h),
    );
    reader.children(root, Affine::IDENTITY, size, 0)?;
    let Shapes { shapes, skipped } = &reader.shapes;
    if shapes.is_empty() && skipped.is_empty() {
        let message = "no shape was found; expected a path, a polygon, a rectangle, a circle or an ellipse";
        return Err(DocumentError::new(Code::Missing, "", message));
    }
    Ok(reader.shapes)
}

struct Reader<'a, 'text> {
    ids: HashMap<&'a str, Node<'a, 'text>>,
    shapes: Shapes,
    segments: usize,
    visited: u32,
    /// Number of elements that draw, for names.
    drawn: usize,
}

impl<'a, 'text> Reader<'a, 'text> {
    fn children(
        &mut self,
        node: Node<'a, 'text>,
        to_root: Affine,
        size: Vec2,
        depth: usize,
    ) -> Result<(), DocumentError> {
        for child in node.children().filter(Node::is_element) {
            self.element(child, to_root, size, depth + 1)?;
        }
        Ok(())
    }

    /// Reads an element in a viewport of the given size.
    fn element(
        &mut self,
        node: Node<'a, 'text>,
        to_root: Affine,
        size: Vec2,
        depth: usize,
    ) -> Result<(), DocumentError> {
        self.visited += 1;
        if depth > DEEPEST || self.visited > MOST_NODES {
            let message = format!(
                "expected at most {DEEPEST} levels and {MOST_NODES} elements, uses counted each time"
            );
            return Err(DocumentError::new(Code::Limit, place(node), message));
        }
        if is_hidden(node) {
            return Ok(());
        }
        let name = node.tag_name().name();
        let group = matches!(name, "g" | "a" | "switch" | "svg" | "use");
        if !group && !DRAWN.contains(&name) {
            return Ok(());
        }
        let Some(own) = transform(node) else {
            let reason = "its transform cannot be read".to_owned();
            self.shapes.skipped.push(Skipped { name: self.name(node), reason });
            return Ok(());
        };
        let to_root = to_root * own;
        match name {
            "g" | "a" | "switch" => self.children(node, to_root, size, depth),
            "svg" => self.view(node, node, to_root, size, depth),
            "use" => self.used(node, to_root, size, depth),
            _ => self.drawn(node, to_root, size),
        }
    }

    /// Reads a nested view or a symbol; `frame` has its place and size.
    fn view(
        &mut self,
        node: Node<'a, 'text>,
        frame: Node<'a, 'text>,
        to_root: Affine,
        size: Vec2,
        depth: usize,
    ) -> Result<(), DocumentError> {
        let own = |name: &str, whole: f64| length(frame, name, whole).or_else(|| length(node, name, whole));
        let inner =
            Vec2::new(own("width", size.x).unwrap_or(size.x), own("height", size.y).unwrap_or(size.y));
        if !(inner.x > 0.0 && inner.y > 0.0) {
            return Ok(());
        }
        // The place of a use is in its own transform already.
        let to_root = if node == frame {
            let at = (length(node, "x", size.x).unwrap_or(0.0), length(node, "y", size.y).unwrap_or(0.0));
            to_root * Affine::translate(at)
        } else {
            to_root
        };
        match view_box(node) {
            Some(view) => {
                self.children(node, to_root * fitted(node, view, inner), Vec2::new(view.w, view.h), depth)
            }
            None => self.children(node, to_root, inner, depth),
        }
    }

    fn used(
        &mut self,
        node: Node<'a, 'text>,
        to_root: Affine,
        size: Vec2,
        depth: usize,
    ) -> Result<(), DocumentError> {
        let link =
            node.attribute("href").or_else(|| node.attribute(("http://www.w3.org/1999/xlink", "href")));
        let target = link.and_then(|link| link.strip_prefix('#')).and_then(|id| self.ids.get(id).copied());
        let Some(target) = target else {
            let reason = format!("it uses \"{}\", which is not in the text", link.unwrap_or_default());
            self.shapes.skipped.push(Skipped { name: self.name(node), reason });
            return Ok(());
        };
        let at = (length(node, "x", size.x).unwrap_or(0.0), length(node, "y", size.y).unwrap_or(0.0));
        let to_root = to_root * Affine::translate(at);
        match target.tag_name().name() {
            "symbol" | "svg" if !is_hidden(target) => {
                self.visited += 1;
                if depth >= DEEPEST {
                    let message = format!("expected at most {DEEPEST} levels, uses counted each time");
                    return Err(DocumentError::new(Code::Limit, place(node), message));
                }
                let Some(own) = transform(target) else { return Ok(()) };
                self.view(target, node, to_root * own, size, depth + 1)
            }
            _ => self.element(target, to_root, size, depth + 1),
        }
    }

    /// Reads an element that draws.
    fn drawn(&mut self, node: Node<'a, 'text>, to_root: Affine, size: Vec2) -> Result<(), DocumentError> {
        self.drawn += 1;
        let name = self.name(node);
        let path = match path(node, size) {
            Ok(path) => path,
            Err(reason) => {
                self.shapes.skipped.push(Skipped { name, reason });
                return Ok(());
            }
        };
        let parts = subpaths(&path, to_root);
        self.segments += parts.iter().map(|part| part.count()).sum::<usize>();
        if self.segments > MOST_SEGMENTS {
            let message =
                format!("more than {MOST_SEGMENTS} segments were found; expected at most that many in all");
            return Err(DocumentError::new(Code::Limit, place(node), message));
        }
        if parts.is_empty() {
            self.shapes.push(&name, false, Ok(Outline::default()));
        }
        for (index, part) in parts.iter().enumerate() {
            let name = if parts.len() == 1 { name.clone() } else { format!("{name}, part {}", index + 1) };
            let (outline, closed) = match part.outline() {
                Ok((outline, closed)) => (Ok(outline), closed),
                Err(reason) => (Err(reason), false),
            };
            self.shapes.push(&name, closed, outline);
        }
        Ok(())
    }

    fn name(&self, node: Node<'_, '_>) -> String {
        let title = || {
            node.children().find(|child| child.tag_name().name() == "title").and_then(|title| title.text())
        };
        let named = node.attribute("id").or_else(title).map(str::trim).filter(|name| !name.is_empty());
        named.map_or_else(|| format!("{} {}", node.tag_name().name(), self.drawn.max(1)), str::to_owned)
    }
}

/// Elements that draw an outline.
const DRAWN: [&str; 7] = ["path", "rect", "circle", "ellipse", "polygon", "polyline", "line"];

/// Where an element stands in the text.
fn place(node: Node<'_, '_>) -> String {
    format!("line {}", node.document().text_pos_at(node.range().start).row)
}

fn is_hidden(node: Node<'_, '_>) -> bool {
    let declared =
        node.attribute("style").into_iter().flat_map(|style| style.split(';')).any(|declaration| {
            let (property, value) = declaration.split_once(':').unwrap_or_default();
            property.trim() == "display" && value.trim() == "none"
        });
    declared || node.attribute("display").map(str::trim) == Some("none")
}

/// The path that an element draws.
fn path(node: Node<'_, '_>, size: Vec2) -> Result<BezPath, String> {
    // Per cent of radii refer to the diagonal.
    let diagonal = size.hypot() / std::f64::consts::SQRT_2;
    let number = |name: &str, whole: f64| length(node, name, whole).unwrap_or(0.0);
    match node.tag_name().name() {
        "path" => parse(node.attribute("d").unwrap_or_default()),
        "rect" => {
            let (width, height) = (number("width", size.x), number("height", size.y));
            if !(width > 0.0 && height > 0.0) {
                return Err("it has no width or no height".to_owned());
            }
            let (x, y) = (number("x", size.x), number("y", size.y));
            let rect = Rect::new(x, y, x + width, y + height);
            let radii = (length(node, "rx", size.x), length(node, "ry", size.y));
            let (rx, ry) = match radii {
                (Some(rx), Some(ry)) => (rx, ry),
                (Some(r), None) | (None, Some(r)) => (r, r),
                (None, None) => (0.0, 0.0),
            };
            Ok(rounded(rect, rx.clamp(0.0, width / 2.0), ry.clamp(0.0, height / 2.0)))
        }
        "circle" | "ellipse" => {
            let center = (number("cx", size.x), number("cy", size.y));
            let (rx, ry) = if node.tag_name().name() == "circle" {
                (number("r", diagonal), number("r", diagonal))
            } else {
                let (rx, ry) = (length(node, "rx", size.x), length(node, "ry", size.y));
                (rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0))
            };
            if !(rx > 0.0 && ry > 0.0) {
                return Err("it has no radius".to_owned());
            }
            Ok(Ellipse::new(center, (rx, ry), 0.0).to_path(ROUND * rx.max(ry)))
        }
        "polygon" | "polyline" => {
            let mut path = BezPath::new();
            for point in PointsParser::from(node.attribute("points").unwrap_or_default()) {
                if path.elements().is_empty() { path.move_to(point) } else { path.line_to(point) }
            }
            if node.tag_name().name() == "polygon" && !path.elements().is_empty() {
                path.close_path();
            }
            Ok(path)
        }
        _ => Err("a line encloses no area".to_owned()),
    }
}

/// A rectangle with elliptic corners: one with round corners, stretched.
fn rounded(rect: Rect, rx: f64, ry: f64) -> BezPath {
    if rx <= 0.0 || ry <= 0.0 {
        return rect.to_path(0.0);
    }
    let stretch = rx / ry;
    let (width, height) = (rect.width(), rect.height() * stretch);
    let round =
        RoundedRect::from_rect(Rect::new(0.0, 0.0, width, height), RoundedRectRadii::from_single_radius(rx));
    let place = Affine::translate((rect.x0, rect.y0)) * Affine::scale_non_uniform(1.0, 1.0 / stretch);
    place * round.to_path(ROUND * rx)
}
