//! Lists of points: lines of numbers, and JSON.

use super::outline::{LARGEST_COORDINATE, Outline};
use super::{MOST_POINTS, Shapes};
use crate::document::{Code, DocumentError, Json, Node};
use glam::DVec2;

type Read<T> = Result<T, DocumentError>;

/// Longest part of a field that a message repeats.
const LONGEST_QUOTE: usize = 40;
/// Most levels of collections within collections.
const DEEPEST: usize = 16;

/// Lists of points as they are found, counted as they grow.
#[derive(Default)]
struct Lists {
    shapes: Shapes,
    total: usize,
    found: usize,
}

impl Lists {
    /// Counts one more point, which is at a place with the given path.
    fn count(&mut self, path: impl FnOnce() -> String) -> Read<()> {
        self.total += 1;
        if self.total <= MOST_POINTS {
            return Ok(());
        }
        let message =
            format!("more than {MOST_POINTS} points were found; expected at most that many in all lists");
        Err(DocumentError::new(Code::Limit, path(), message))
    }

    fn push(&mut self, name: Option<&str>, points: Vec<DVec2>) {
        self.found += 1;
        let numbered = format!("list {}", self.found);
        let closed = points.len() > 1 && points.first() == points.last();
        let name = name.filter(|name| !name.trim().is_empty()).unwrap_or(&numbered);
        self.shapes.push(name, closed, Ok(Outline { points, corners: Vec::new() }));
    }

    fn finish(self, what: &str) -> Read<Shapes> {
        if self.found == 0 {
            let message = format!("no points were found; expected {what}");
            return Err(DocumentError::new(Code::Missing, "", message));
        }
        Ok(self.shapes)
    }
}

/// Reads lines of numbers: one point a line, an empty line between two lists.
///
/// The separator is a semicolon, a tab, a comma or space, the first of these that the first line with numbers holds. With
/// a semicolon or a tab the comma may be a decimal point. Lines above the numbers of a list may name its columns, and `x` and
/// `y` among them are then the coordinates, wherever they stand; a line of one word names the list. Else the first two
/// columns are the coordinates. Lines that begin with `#` are left out.
///
/// # Errors
/// With the line: a field that is no number, a missing field, a coordinate beyond 1e12, more than 20 000 points.
pub fn from_lines(text: &str) -> Read<Shapes> {
    let mut lists = Lists::default();
    let mut reader = Lines { separator: None, columns: [0, 1], name: None, points: Vec::new() };
    for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        reader.line(&mut lists, index + 1, line.trim())?;
    }
    reader.finish(&mut lists);
    lists.finish("lines such as `12.5, 3`")
}

/// The list that is being read.
struct Lines {
    separator: Option<char>,
    /// Places of x and y among the fields of a line.
    columns: [usize; 2],
    name: Option<String>,
    points: Vec<DVec2>,
}

impl Lines {
    fn line(&mut self, lists: &mut Lists, number: usize, line: &str) -> Read<()> {
        if line.starts_with('#') {
            return Ok(());
        }
        if line.is_empty() {
            self.finish(lists);
            return Ok(());
        }
        let separator = self.separator.unwrap_or_else(|| separator_of(line));
        let fields = split(line, separator);
        if self.points.is_empty() && fields.iter().all(|field| value(field, separator).is_none()) {
            self.header(&fields);
            return Ok(());
        }
        self.separator = Some(separator);
        lists.count(|| format!("line {number}"))?;
        let mut point = [0.0; 2];
        for (coordinate, (axis, column)) in point.iter_mut().zip(["x", "y"].iter().zip(self.columns)) {
            let path = || format!("line {number}, {axis}");
            let Some(field) = fields.get(column) else {
                let message = format!("{} fields were found; expected at least {}", fields.len(), column + 1);
                return Err(DocumentError::new(Code::Missing, path(), message));
            };
            *coordinate = value(field, separator).ok_or_else(|| {
                let quote: String = field.chars().take(LONGEST_QUOTE).collect();
                DocumentError::new(Code::Type, path(), format!("\"{quote}\" was found; expected a number"))
            })?;
            check(*coordinate, path)?;
        }
        self.points.push(DVec2::from(point));
        Ok(())
    }

    /// A line above the numbers: names of columns, or the name of the list.
    fn header(&mut self, fields: &[&str]) {
        if let [name] = fields {
            self.name = Some((*name).to_owned());
            return;
        }
        let column =
            |name: &str| fields.iter().position(|field| field.trim_matches('"').eq_ignore_ascii_case(name));
        if let (Some(x), Some(y)) = (column("x"), column("y")) {
            self.columns = [x, y];
        }
    }

    fn finish(&mut self, lists: &mut Lists) {
        if !self.points.is_empty() {
            let points = std::mem::take(&mut self.points);
            lists.push(self.name.take().as_deref(), points);
        }
    }
}

fn separator_of(line: &str) -> char {
    [';', '\t', ','].into_iter().find(|&separator| line.contains(separator)).unwrap_or(' ')
}

fn split(line: &str, separator: char) -> Vec<&str> {
    if separator == ' ' {
        line.split_whitespace().collect()
    } else {
        line.split(separator).map(str::trim).collect()
    }
}

/// The number that a field holds.
fn value(field: &str, separator: char) -> Option<f64> {
    let field = field.trim_matches('"').trim();
    // The parser of the language takes words such as "infinity" too.
    if field.contains(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E')) {
        return None;
    }
    if matches!(separator, ';' | '\t') {
        field.replacen(',', ".", 1).parse().ok()
    } else {
        field.parse().ok()
    }
}

/// Refuses a coordinate that a curve cannot have.
fn check(coordinate: f64, path: impl FnOnce() -> String) -> Read<()> {
    if coordinate.abs() <= LARGEST_COORDINATE {
        return Ok(());
    }
    let message = format!("{coordinate} was found; expected a number from -1e12 to 1e12");
    Err(DocumentError::new(Code::Range, path(), message))
}

/// Reads JSON: a list of points `[x, y]` or `{"x", "y"}`, a list of such lists, an object with such a list as `points` (and a
/// `name`), or GeoJSON of polygons.
///
/// More numbers than two in a point are left out. A feature of GeoJSON gives its `properties.name` to its rings.
///
/// # Errors
/// With the path of the value: another type, a missing field, a coordinate beyond 1e12, more than 20 000 points.
pub fn from_json(json: &Json) -> Read<Shapes> {
    let mut lists = Lists::default();
    let root = Node::root(json, "");
    value_of(&mut lists, &root, None, 0)?;
    lists.finish("points such as `[[0, 0], [10, 0], [10, 10]]`")
}

/// Reads whatever holds points.
fn value_of(lists: &mut Lists, node: &Node<'_>, name: Option<&str>, depth: usize) -> Read<()> {
    if depth > DEEPEST {
        return Err(node.error(Code::Limit, format!("expected at most {DEEPEST} lists in each other")));
    }
    if node.is_list() {
        return list_of(lists, node, name, depth);
    }
    let own = node.get("name")?.and_then(|name| name.text(usize::MAX).ok());
    let name = own.as_deref().or(name);
    if let Some(kind) = node.get("type")? {
        let kinds = ["Polygon", "MultiPolygon", "Feature", "FeatureCollection", "GeometryCollection"];
        return match kind.choice(&kinds)? {
            0 => rings_of(lists, &node.need("coordinates")?, name),
            1 => {
                let polygons = node.need("coordinates")?;
                polygons.items()?.iter().try_for_each(|polygon| rings_of(lists, polygon, name))
            }
            2 => {
                let geometry = node.need("geometry")?;
                let properties = node.get("properties")?.filter(|properties| !properties.is_null());
                let title = match &properties {
                    Some(properties) => properties.get("name")?.and_then(|name| name.text(usize::MAX).ok()),
                    None => None,
                };
                value_of(lists, &geometry, title.as_deref().or(name), depth + 1)
            }
            3 => each_of(lists, &node.need("features")?, name, depth),
            _ => each_of(lists, &node.need("geometries")?, name, depth),
        };
    }
    if let Some(shapes) = node.get("shapes")? {
        return each_of(lists, &shapes, name, depth);
    }
    list_of(lists, &node.need("points")?, name, depth)
}

fn each_of(lists: &mut Lists, node: &Node<'_>, name: Option<&str>, depth: usize) -> Read<()> {
    node.items()?.iter().try_for_each(|item| value_of(lists, item, name, depth + 1))
}

/// Reads a list of points, or a list of what holds points.
fn list_of(lists: &mut Lists, node: &Node<'_>, name: Option<&str>, depth: usize) -> Read<()> {
    let items = node.items()?;
    let Some(first) = items.first() else { return Ok(()) };
    if is_point(first)? { points_of(lists, &items, name) } else { each_of(lists, node, name, depth) }
}

/// Whether a value is a point rather than something that holds points.
fn is_point(node: &Node<'_>) -> Read<bool> {
    if node.is_list() {
        return Ok(node.items()?.first().is_none_or(|item| !item.is_list() && !item.is_object()));
    }
    if node.is_object() {
        let holds = |field: &str| node.get(field).map(|found| found.is_some());
        return Ok(!(holds("points")? || holds("type")? || holds("shapes")?));
    }
    // Neither: reading it as a point says what was expected.
    Ok(true)
}

fn points_of(lists: &mut Lists, items: &[Node<'_>], name: Option<&str>) -> Read<()> {
    let mut points = Vec::with_capacity(items.len().min(MOST_POINTS));
    for item in items {
        lists.count(|| item.error(Code::Limit, String::new()).path)?;
        points.push(point_of(item)?);
    }
    lists.push(name, points);
    Ok(())
}

fn rings_of(lists: &mut Lists, polygon: &Node<'_>, name: Option<&str>) -> Read<()> {
    polygon.items()?.iter().try_for_each(|ring| points_of(lists, &ring.items()?, name))
}

fn point_of(node: &Node<'_>) -> Read<DVec2> {
    let range = -LARGEST_COORDINATE..=LARGEST_COORDINATE;
    if node.is_object() {
        return Ok(DVec2::new(node.need("x")?.within(range.clone())?, node.need("y")?.within(range)?));
    }
    let numbers = node.items()?;
    let [x, y, ..] = numbers.as_slice() else {
        return Err(
            node.error(Code::Type, format!("a list of {} was found; expected two numbers", numbers.len()))
        );
    };
    Ok(DVec2::new(x.within(range.clone())?, y.within(range)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lists(text: &str) -> Vec<(String, Vec<[f64; 2]>)> {
        let shapes = from_lines(text).unwrap_or_else(|error| panic!("{error}")).shapes;
        shapes.into_iter().map(|s| (s.name, s.points.iter().map(|p| p.to_array()).collect())).collect()
    }

    #[test]
    fn separators_and_decimal_commas_are_told_apart() {
        let expected = vec![("list 1".to_owned(), vec![[0.5, 0.0], [10.0, -2.5], [3.0, 7e1]])];
        for text in [
            "0.5,0\n10, -2.5\n3,7e1",
            "0,5;0\n10;-2,5\n3;7e1\n",
            "0.5\t0\r\n10\t-2.5\r\n3\t70",
            "  0.5   0\n10 -2.5\n3 70",
            "\u{feff}x,y\n# a remark\n0.5,0\n10,-2.5\n3,70\n\n",
            "id;Y;note;X\n1;0;a;0.5\n2;-2,5;b;10\n3;70;c;3",
            "\"x\",\"y\",\"z\"\n0.5,0,9\n10,-2.5,9\n\"3\",70,9",
        ] {
            assert_eq!(lists(text), expected, "{text:?}");
        }
    }

    #[test]
    fn empty_lines_separate_lists_and_single_words_name_them() {
        let found = lists("Inner\n0 0\n1 0\n1 1\n\n\nx y\n0 0\n2 0\n2 2\n0 0\n");
        assert_eq!((found[0].0.as_str(), found[1].0.as_str(), found.len()), ("Inner", "list 2", 2));
        assert_eq!(found[1].1.len(), 3, "the point that closes the list is not repeated");
    }

    #[test]
    fn what_is_wrong_in_a_line_is_named() {
        for (text, code, path, message) in [
            ("0 0\n1 x\n", Code::Type, "line 2, y", "\"x\" was found; expected a number"),
            ("0 0\n1", Code::Missing, "line 2, y", "1 fields were found; expected at least 2"),
            ("0,0\n1,inf\n", Code::Type, "line 2, y", "\"inf\" was found; expected a number"),
            ("0,0\n1e300,0\n", Code::Range, "line 2, x", "expected a number from -1e12 to 1e12"),
            ("just words", Code::Missing, "", "no points were found; expected lines such as"),
        ] {
            let error = from_lines(text).unwrap_err();
            assert_eq!((error.code, error.path.as_str()), (code, path));
            assert!(error.message.contains(message), "{}", error.message);
        }
        let many = "1 2\n".repeat(MOST_POINTS + 1);
        let error = from_lines(&many).unwrap_err();
        assert_eq!((error.code, error.path.as_str()), (Code::Limit, "line 20001"));
    }
}
