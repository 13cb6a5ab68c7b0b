//! Triangles in STL files, binary or text (3D Systems, "StereoLithography interface specification", 1988).

use crate::document::{Code, DocumentError};
use glam::DVec3;
use std::collections::HashMap;

/// Most triangles that are read: those that boundary elements are solved with.
pub const MOST_TRIANGLES: usize = 32_000;
/// Longest file that is read, in bytes; text takes about 270 for a triangle.
pub const LONGEST_STL: usize = 16 << 20;
/// Bytes before the number of triangles of a binary file.
const HEADER: usize = 80;
/// Bytes of a triangle of a binary file: a normal and three vertices in single precision, and two bytes for attributes.
const RECORD: usize = 50;
/// Longest word that a message repeats.
const LONGEST_WORD: usize = 20;

/// A mesh as it was read.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadMesh {
    /// Vertices; those with equal coordinates are one.
    pub vertices: Vec<DVec3>,
    /// The vertices of each triangle in the order of the file, counter-clockwise from outside where the file is right.
    pub triangles: Vec<[u32; 3]>,
    /// Triangles with two equal vertices, which were left out.
    pub dropped: usize,
    /// Whether the file was binary.
    pub is_binary: bool,
}

type Read<T> = Result<T, DocumentError>;

/// Reads a file. Normals are left aside: they follow from the order of the vertices.
///
/// # Errors
/// With code `limit` beyond [`LONGEST_STL`] bytes or [`MOST_TRIANGLES`] triangles, with code `syntax` where the file is cut off, is no STL or has no triangles, and
/// with code `non-finite` where a coordinate is no number. Of text the path is the line, of binary files the triangle.
pub fn from_stl(bytes: &[u8]) -> Read<ReadMesh> {
    if bytes.len() > LONGEST_STL {
        let message = format!("the file has {} bytes; at most {LONGEST_STL} are read", bytes.len());
        return Err(DocumentError::new(Code::Limit, "", message));
    }
    let count = bytes.get(HEADER..HEADER + 4).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    let wanted = count.map(|count| HEADER + 4 + RECORD * count as usize);
    // Binary files may begin with the word of text files, but only they have just as many bytes as they announce.
    let is_text = bytes.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    let mesh = match (count, wanted) {
        (Some(count), Some(wanted)) if wanted == bytes.len() || !is_text => binary(bytes, count, wanted)?,
        _ if is_text => text(bytes)?,
        _ => {
            let message = format!(
                "{} bytes were found; expected an STL file: text that begins with `solid`, or at least {} bytes",
                bytes.len(),
                HEADER + 4
            );
            return Err(DocumentError::new(Code::Syntax, "", message));
        }
    };
    if mesh.triangles.is_empty() {
        let message = if mesh.dropped > 0 {
            "all triangles have two equal vertices; expected some with an area"
        } else {
            "the file has no triangles"
        };
        return Err(DocumentError::new(Code::Syntax, "", message));
    }
    Ok(mesh)
}

/// Gathers triangles, with one vertex for equal coordinates.
#[derive(Default)]
struct Gathering {
    mesh: ReadMesh,
    known: HashMap<[u64; 3], u32>,
}

impl Gathering {
    fn add(&mut self, corners: [DVec3; 3]) {
        let corners = corners.map(|corner| {
            // Adding 0 makes one of the two zeros.
            let key = corner.to_array().map(|x| (x + 0.0).to_bits());
            *self.known.entry(key).or_insert_with(|| {
                self.mesh.vertices.push(corner);
                self.mesh.vertices.len() as u32 - 1
            })
        });
        let [a, b, c] = corners;
        if a == b || b == c || c == a {
            self.mesh.dropped += 1;
        } else {
            self.mesh.triangles.push(corners);
        }
    }
}

fn check_count(count: usize) -> Read<()> {
    if count <= MOST_TRIANGLES {
        return Ok(());
    }
    let message = format!(
        "{count} triangles were found; expected {MOST_TRIANGLES} at most: make the mesh coarser first"
    );
    Err(DocumentError::new(Code::Limit, "", message))
}

fn binary(bytes: &[u8], count: u32, wanted: usize) -> Read<ReadMesh> {
    if bytes.len() < wanted {
        let message = format!(
            "the file is cut off, or no STL: its head announces {count} triangles in {wanted} bytes, and it has {}",
            bytes.len()
        );
        return Err(DocumentError::new(Code::Syntax, "", message));
    }
    check_count(count as usize)?;
    let mut gathering = Gathering::default();
    gathering.mesh.is_binary = true;
    for (number, record) in bytes[HEADER + 4..wanted].chunks_exact(RECORD).enumerate() {
        let number_at = |at: usize| {
            let bytes = [record[at], record[at + 1], record[at + 2], record[at + 3]];
            f64::from(f32::from_le_bytes(bytes))
        };
        let corner = |k: usize| DVec3::from_array([0, 1, 2].map(|axis| number_at(12 + 12 * k + 4 * axis)));
        let corners = [0, 1, 2].map(corner);
        if !corners.iter().all(|corner| corner.is_finite()) {
            let message = "a coordinate that is no finite number was found";
            return Err(DocumentError::new(Code::NonFinite, format!("triangles[{number}]"), message));
        }
        gathering.add(corners);
    }
    Ok(gathering.mesh)
}

/// Words of a text with their lines.
struct Words<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    words: std::str::SplitWhitespace<'a>,
    line: usize,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a str> {
        loop {
            if let Some(word) = self.words.next() {
                return Some(word);
            }
            let (line, text) = self.lines.next()?;
            self.line = line + 1;
            self.words = text.split_whitespace();
        }
    }

    fn fault(&self, found: Option<&str>, expected: &str) -> DocumentError {
        let found = found.map_or("the end of the file was found".to_owned(), |word| {
            let word: String = word.chars().take(LONGEST_WORD).collect();
            format!("\"{word}\" was found")
        });
        DocumentError::new(
            Code::Syntax,
            format!("line {}", self.line),
            format!("{found}; expected {expected}"),
        )
    }

    fn expect(&mut self, wanted: &str) -> Read<()> {
        let found = self.next();
        if found.is_some_and(|word| word.eq_ignore_ascii_case(wanted)) {
            return Ok(());
        }
        Err(self.fault(found, &format!("`{wanted}`")))
    }

    fn number(&mut self) -> Read<f64> {
        let word = self.next();
        match word.map(str::parse::<f64>) {
            Some(Ok(number)) if number.is_finite() => Ok(number),
            Some(Ok(number)) => {
                let message = format!("{number} was found; expected a finite number");
                Err(DocumentError::new(Code::NonFinite, format!("line {}", self.line), message))
            }
            _ => Err(self.fault(word, "a number")),
        }
    }
}

fn text(bytes: &[u8]) -> Read<ReadMesh> {
    // Names of solids may be in any encoding; nothing else has letters beyond ASCII.
    let text = String::from_utf8_lossy(bytes);
    let mut words = Words { lines: text.lines().enumerate(), words: "".split_whitespace(), line: 0 };
    let mut gathering = Gathering::default();
    let mut count = 0;
    while let Some(word) = words.next() {
        if !word.eq_ignore_ascii_case("solid") {
            return Err(words.fault(Some(word), "`solid`"));
        }
        // The name is the rest of the line.
        words.words = "".split_whitespace();
        loop {
            let word = words.next();
            match word.map(str::to_ascii_lowercase).as_deref() {
                Some("facet") => {}
                Some("endsolid") => break,
                _ => return Err(words.fault(word, "`facet` or `endsolid`")),
            }
            words.expect("normal")?;
            // Some writers give no number for the normal of a triangle without area.
            for _ in 0..3 {
                let word = words.next();
                if word.is_none_or(|word| word.parse::<f64>().is_err()) {
                    return Err(words.fault(word, "a number"));
                }
            }
            words.expect("outer")?;
            words.expect("loop")?;
            let mut corners = [DVec3::ZERO; 3];
            for corner in &mut corners {
                words.expect("vertex")?;
                *corner = DVec3::new(words.number()?, words.number()?, words.number()?);
            }
            words.expect("endloop")?;
            words.expect("endfacet")?;
            count += 1;
            check_count(count)?;
            gathering.add(corners);
        }
        words.words = "".split_whitespace();
    }
    Ok(gathering.mesh)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fmt::Write;

    const CORNERS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.5, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, -0.0, 1e-3]];
    const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

    fn binary_file(faces: &[[usize; 3]]) -> Vec<u8> {
        let mut bytes = b"solid in name only".to_vec();
        bytes.resize(HEADER, 0);
        bytes.extend((faces.len() as u32).to_le_bytes());
        for face in faces {
            bytes.extend([0; 12]);
            bytes.extend(face.iter().flat_map(|k| CORNERS[*k]).flat_map(f32::to_le_bytes));
            bytes.extend([0; 2]);
        }
        bytes
    }

    fn text_file(faces: &[[usize; 3]]) -> String {
        let mut text = "solid a part\n".to_owned();
        for face in faces {
            text.push_str("  facet normal 0 0 nan\n    outer loop\n");
            for [x, y, z] in face.map(|k| CORNERS[k]) {
                writeln!(text, "      vertex {x} {y:e} {z}").unwrap();
            }
            text.push_str("    endloop\n  endfacet\n");
        }
        text + "endsolid a part\n"
    }

    fn expected(is_binary: bool) -> ReadMesh {
        // In the order in which they come.
        let vertices = [0, 2, 1, 3].map(|k| DVec3::from_array(CORNERS[k].map(f64::from)));
        let triangles = vec![[0, 1, 2], [0, 2, 3], [2, 1, 3], [1, 0, 3]];
        ReadMesh { vertices: vertices.to_vec(), triangles, dropped: 0, is_binary }
    }

    #[test]
    fn both_kinds_of_files_are_read_alike() {
        assert_eq!(from_stl(&binary_file(&FACES)), Ok(expected(true)));
        let found = from_stl(text_file(&FACES).as_bytes()).unwrap();
        assert_eq!((found.triangles, found.vertices.len()), (expected(false).triangles, 4));
        for (a, b) in found.vertices.iter().zip(expected(false).vertices) {
            assert!(a.distance(b) < 1e-9, "text has its own digits");
        }
        let two = text_file(&FACES[..2]).replace('\n', "\r\n") + &text_file(&FACES[2..]).to_uppercase();
        assert_eq!(from_stl(two.as_bytes()).unwrap().triangles.len(), 4, "two solids, with capitals");
        let flat = [FACES[0], [1, 1, 2], FACES[1]];
        let found = from_stl(&binary_file(&flat)).unwrap();
        assert_eq!((found.triangles.len(), found.dropped), (2, 1));
        let mut trailing = binary_file(&FACES);
        trailing[0] = b'S' - 1;
        trailing.extend(*b"colours");
        assert_eq!(from_stl(&trailing), Ok(expected(true)));
    }

    #[test]
    fn what_is_wrong_is_named() {
        let refused = |bytes: &[u8]| {
            let error = from_stl(bytes).unwrap_err();
            assert!(!error.message.is_empty());
            (error.code, error.path, error.message)
        };
        let at = |bytes: &[u8]| (refused(bytes).0, refused(bytes).1);
        assert_eq!(at(b""), (Code::Syntax, "".into()));
        assert_eq!(at(b"ply\nformat ascii 1.0"), (Code::Syntax, "".into()));
        assert_eq!(at(&[b'x'; 200]), (Code::Syntax, "".into()));
        let whole = binary_file(&FACES);
        let mut cut = whole[..whole.len() - 1].to_vec();
        cut[..5].copy_from_slice(b"Direc");
        assert!(refused(&cut).2.contains("announces 4 triangles in 284 bytes, and it has 283"));
        assert!(refused(&binary_file(&[])).2.contains("no triangles"));
        assert!(refused(&binary_file(&[[1, 1, 1]])).2.contains("two equal vertices"));
        let mut odd = whole.clone();
        odd[HEADER + 4 + 50 + 12..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
        assert_eq!(at(&odd), (Code::NonFinite, "triangles[1]".into()));
        let mut many = vec![0; HEADER + 4 + RECORD * (MOST_TRIANGLES + 1)];
        many[HEADER..HEADER + 4].copy_from_slice(&(MOST_TRIANGLES as u32 + 1).to_le_bytes());
        assert_eq!(at(&many), (Code::Limit, "".into()));
        assert_eq!(at(&vec![0; LONGEST_STL + 1]), (Code::Limit, "".into()));
        let text = text_file(&FACES);
        let with = |from: &str, to: &str| at(text.replacen(from, to, 1).as_bytes());
        assert_eq!(with("vertex 0 0e0", "vertex 0 x"), (Code::Syntax, "line 4".into()));
        assert_eq!(with("vertex 0 0e0", "vertex 0 inf"), (Code::NonFinite, "line 4".into()));
        assert_eq!(with("endloop", "vertex"), (Code::Syntax, "line 7".into()));
        assert_eq!(with("normal 0 0 nan", "normal 0 0"), (Code::Syntax, "line 3".into()));
        assert_eq!(with("  facet", "  face"), (Code::Syntax, "line 2".into()));
        assert_eq!(at(&text.as_bytes()[..text.len() - 20]), (Code::Syntax, "line 29".into()));
        assert_eq!(at(b"solid nothing\nendsolid"), (Code::Syntax, "".into()));
    }

    /// Whatever is cut out of files or changed in them, they are read or refused.
    #[test]
    fn damaged_files_never_panic() {
        let files = [binary_file(&FACES), text_file(&FACES).into_bytes()];
        let mut state = 26_u64;
        let mut random = move |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below
        };
        for _ in 0..2000 {
            let mut bytes = files[random(2)].clone();
            for _ in 0..random(4) {
                let at = random(bytes.len());
                bytes[at] = random(256) as u8;
            }
            bytes.truncate(random(bytes.len()) + 1);
            if let Ok(found) = from_stl(&bytes) {
                assert!(found.triangles.iter().flatten().all(|k| (*k as usize) < found.vertices.len()));
            }
        }
    }

    /// Meshes of others, where their folder is there.
    #[test]
    fn meshes_of_others_are_read() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/stl");
        if !folder.exists() {
            println!("skipped: there is no folder of meshes beside the project");
            return;
        }
        for name in ["fandisk", "femur"] {
            let bytes = std::fs::read(folder.join(format!("{name}.stl"))).expect("a mesh");
            match from_stl(&bytes) {
                // A closed surface has half as many edges again as triangles, and Euler's number 2 for each handle less.
                Ok(found) => assert!(found.vertices.len() * 2 <= found.triangles.len() + 4, "{name}"),
                Err(error) => assert_eq!(error.code, Code::Limit, "{name}: {error}"),
            }
        }
    }
}
