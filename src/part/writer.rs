//! Rasters as files.

use super::archive::Archive;
use super::dither::{Dithering, EMPTY};
use super::png::{LONGEST_ROW, PngRows};
use super::{Dither, Palette, Raster};
use std::fmt::Write;

/// What a raster is written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartFormat {
    /// Comma-separated values: place, body, leaf and fractions of each pixel of a body.
    Csv,
    /// A uniform grid of VTK in XML, with the fractions at the centres of the pixels.
    Vti,
    /// "Nearly raw raster data" (teem): x, y, material.
    Nrrd,
    /// A picture of the colours.
    Png {
        /// Whether each pixel has the colour of one material, and how.
        dither: Option<Dither>,
    },
    /// A grey picture of the fraction of one material, from 0 to 255.
    Slice {
        /// Index of the material.
        material: usize,
        /// Whether each pixel has all of it or nothing. Slices of all materials together have every pixel of a body once.
        dither: Option<Dither>,
    },
    /// A ZIP archive with such a picture of each material.
    Slices {
        /// As of a slice.
        dither: Option<Dither>,
    },
}

impl PartFormat {
    /// Most pixels in a row.
    #[must_use]
    pub fn widest(self) -> usize {
        match self {
            Self::Png { .. } => (LONGEST_ROW - 1) / 4,
            _ => LONGEST_ROW - 1,
        }
    }

    fn dither(self) -> Option<Dither> {
        match self {
            Self::Png { dither } | Self::Slice { dither, .. } | Self::Slices { dither } => dither,
            _ => None,
        }
    }
}

/// The writing of a raster, row by row.
#[derive(Debug)]
pub struct Writer {
    format: PartFormat,
    names: Vec<String>,
    palette: Palette,
    bytes: Vec<u8>,
    /// Rows that are written; of formats with a block for each material, one block after the other.
    next: usize,
    /// The picture that is under way, and its dithering.
    rows: Option<PngRows>,
    dithering: Option<Dithering>,
    archive: Archive,
}

impl Writer {
    /// Starts a file; `names` are those of the materials.
    #[must_use]
    pub fn new(format: PartFormat, raster: &Raster, names: Vec<String>, palette: Palette) -> Self {
        let mut bytes = Vec::new();
        match format {
            PartFormat::Csv => {
                bytes.extend(format!("x,y,body,leaf,{}\n", quoted(&names).join(",")).bytes());
            }
            PartFormat::Vti => bytes.extend(vti_header(raster, &names).bytes()),
            PartFormat::Nrrd => bytes.extend(nrrd_header(raster, &names).bytes()),
            PartFormat::Png { .. } | PartFormat::Slice { .. } | PartFormat::Slices { .. } => {}
        }
        let archive = Archive::default();
        Self { format, names, palette, bytes, next: 0, rows: None, dithering: None, archive }
    }

    /// Rows of all blocks.
    fn count(&self, raster: &Raster) -> usize {
        let blocks = match self.format {
            PartFormat::Vti => self.names.len() + 1,
            PartFormat::Nrrd | PartFormat::Slices { .. } => self.names.len(),
            _ => 1,
        };
        blocks * raster.frame.size()[1]
    }

    /// Advances while `may_go_on` says so, by one row at least; returns the bytes when all are written.
    pub fn step(&mut self, raster: &Raster, may_go_on: &mut dyn FnMut() -> bool) -> Option<Vec<u8>> {
        let count = self.count(raster);
        while self.next < count {
            self.row(raster);
            self.next += 1;
            if !may_go_on() {
                break;
            }
        }
        if self.next < count {
            return None;
        }
        match self.format {
            PartFormat::Vti => self.bytes.extend(*b"\n</AppendedData>\n</VTKFile>\n"),
            PartFormat::Slices { .. } => self.archive.finish(&mut self.bytes),
            _ => {}
        }
        Some(std::mem::take(&mut self.bytes))
    }

    /// Share that is written, from 0 to 1.
    #[must_use]
    pub fn progress(&self, raster: &Raster) -> f64 {
        self.next as f64 / self.count(raster) as f64
    }

    fn row(&mut self, raster: &Raster) {
        let [nx, ny] = raster.frame.size();
        let (block, row) = (self.next / ny, self.next % ny);
        // Grids of VTK and NRRD have y upwards.
        let upwards = (ny - 1 - row) * nx..(ny - row) * nx;
        match self.format {
            PartFormat::Csv => self.csv_row(raster, row),
            PartFormat::Vti => {
                if row == 0 {
                    let each = if block == 0 { 1 } else { 4 };
                    self.bytes.extend(((nx * ny * each) as u64).to_le_bytes());
                }
                match block.checked_sub(1) {
                    None => self.bytes.extend_from_slice(&raster.body[upwards]),
                    Some(material) => self.floats(&raster.fractions[material][upwards]),
                }
            }
            PartFormat::Nrrd => self.floats(&raster.fractions[block][upwards]),
            PartFormat::Png { .. } => {
                self.start_picture(raster, row, 4);
                let row = self.colors(raster, row);
                self.picture_row(&row);
            }
            PartFormat::Slice { material, .. } => {
                self.start_picture(raster, row, 1);
                let row = self.slice(raster, row, material);
                self.picture_row(&row);
            }
            PartFormat::Slices { .. } => {
                if row == 0 {
                    let name = format!("{} {}.png", block + 1, file_name(&self.names[block]));
                    self.archive.start(name, &mut self.bytes);
                }
                self.start_picture(raster, row, 1);
                let bytes = self.slice(raster, row, block);
                self.picture_row(&bytes);
                self.archive.sum(&self.bytes);
                if row + 1 == ny {
                    self.archive.end(&mut self.bytes);
                }
            }
        }
    }

    /// Before its first row.
    fn start_picture(&mut self, raster: &Raster, row: usize, channels: usize) {
        if row == 0 {
            let size = raster.frame.size();
            self.rows = Some(PngRows::start(size, channels, &mut self.bytes));
            self.dithering = self.format.dither().map(|kind| Dithering::new(kind, self.names.len(), size[0]));
        }
    }

    fn picture_row(&mut self, row: &[u8]) {
        if let Some(rows) = &mut self.rows {
            rows.row(row, &mut self.bytes);
        }
    }

    /// Red, green, blue and alpha of a row.
    fn colors(&mut self, raster: &Raster, row: usize) -> Vec<u8> {
        let nx = raster.frame.size()[0];
        if let Some(dithering) = &mut self.dithering {
            let pure = |material: usize| {
                let fractions = (0..self.names.len()).map(|k| if k == material { 1.0 } else { 0.0 });
                self.palette.color(fractions)
            };
            let pures: Vec<[u8; 3]> = (0..self.names.len()).map(pure).collect();
            let pixel = |material: u8| {
                let color = pures.get(usize::from(material));
                color.map_or([0; 4], |[r, g, b]| [*r, *g, *b, u8::MAX])
            };
            return dithering.row(raster, row).into_iter().flat_map(pixel).collect();
        }
        let pixel = |at: usize| {
            if raster.body[at] == 0 {
                return [0; 4];
            }
            let [r, g, b] = self.palette.color(raster.fractions.iter().map(|list| list[at]));
            [r, g, b, u8::MAX]
        };
        (row * nx..(row + 1) * nx).flat_map(pixel).collect()
    }

    /// How much there is of a material in a row.
    fn slice(&mut self, raster: &Raster, row: usize, material: usize) -> Vec<u8> {
        if let Some(dithering) = &mut self.dithering {
            let is_on = |found: u8| found != EMPTY && usize::from(found) == material;
            return dithering
                .row(raster, row)
                .into_iter()
                .map(|found| if is_on(found) { u8::MAX } else { 0 })
                .collect();
        }
        let nx = raster.frame.size()[0];
        let fractions = &raster.fractions[material][row * nx..(row + 1) * nx];
        fractions.iter().map(|fraction| (255.0 * fraction).round() as u8).collect()
    }

    fn floats(&mut self, values: &[f32]) {
        self.bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    }

    fn csv_row(&mut self, raster: &Raster, row: usize) {
        let nx = raster.frame.size()[0];
        let mut text = String::new();
        for column in 0..nx {
            let at = row * nx + column;
            if raster.body[at] == 0 {
                continue;
            }
            let place = raster.frame.center(column, row);
            // Writing to a string cannot fail.
            let _ = write!(text, "{},{},{},{}", place.x, place.y, raster.body[at] - 1, raster.leaves[at]);
            for list in &raster.fractions {
                let _ = write!(text, ",{}", list[at]);
            }
            text.push('\n');
        }
        self.bytes.extend(text.bytes());
    }
}

/// Names as fields of comma-separated values (RFC 4180).
fn quoted(names: &[String]) -> Vec<String> {
    let quote = |name: &String| {
        if name.contains([',', '"', '\n', '\r']) {
            format!("\"{}\"", name.replace('"', "\"\""))
        } else {
            name.clone()
        }
    };
    names.iter().map(quote).collect()
}

/// A name without what names of files must not have.
fn file_name(name: &str) -> String {
    let is_taken = |sign: char| sign.is_control() || "/\\:*?\"<>|".contains(sign);
    name.chars().map(|sign| if is_taken(sign) { '_' } else { sign }).collect()
}

fn vti_header(raster: &Raster, names: &[String]) -> String {
    let frame = raster.frame;
    let [nx, ny] = frame.size();
    let (origin, step) = (frame.center(0, ny - 1), frame.step());
    let extent = format!("0 {} 0 {} 0 0", nx - 1, ny - 1);
    let mut offset = 0;
    let mut arrays = String::new();
    let mut array = |kind: &str, name: &str, bytes: usize| {
        let _ = writeln!(
            arrays,
            "<DataArray type=\"{kind}\" Name=\"{}\" format=\"appended\" offset=\"{offset}\"/>",
            escaped(name)
        );
        offset += 8 + bytes * nx * ny;
    };
    array("UInt8", "body", 1);
    for (k, name) in names.iter().enumerate() {
        array("Float32", &format!("{k} {name}"), 4);
    }
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <ImageData WholeExtent=\"{extent}\" Origin=\"{} {} 0\" Spacing=\"{} {} 1\">\n<Piece Extent=\"{extent}\">\n\
         <PointData>\n{arrays}</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_",
        origin.x, origin.y, step.x, step.y
    )
}

fn escaped(name: &str) -> String {
    let plain: String = name.chars().filter(|c| !c.is_control()).collect();
    plain.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn nrrd_header(raster: &Raster, names: &[String]) -> String {
    let frame = raster.frame;
    let [nx, ny] = frame.size();
    let (origin, step) = (frame.center(0, ny - 1), frame.step());
    let mut header = format!(
        "NRRD0004\n# Volume fractions of materials\ntype: float\ndimension: 3\nspace dimension: 2\nsizes: {nx} {ny} {}\n\
         space directions: ({},0) (0,{}) none\nkinds: domain domain list\nendian: little\nencoding: raw\nspace origin: ({},{})\n",
        names.len(),
        step.x,
        step.y,
        origin.x,
        origin.y
    );
    for (k, name) in names.iter().enumerate() {
        let plain: String = name.chars().filter(|c| !c.is_control()).collect();
        let _ = writeln!(header, "material {k}:={plain}");
    }
    header.push('\n');
    header
}

#[cfg(test)]
mod tests {
    use super::super::Frame;
    use super::*;
    use crate::geom::Bounds;
    use crate::material::Color;
    use glam::dvec2;

    /// 4 x 3 pixels of one unit; the first of the top row is empty.
    fn raster() -> Raster {
        let frame = Frame::new(Bounds { min: dvec2(10.0, 20.0), max: dvec2(14.0, 23.0) }, [4, 3]).unwrap();
        let body: Vec<u8> = (0..12).map(|n| u8::from(n > 0)).collect();
        let first: Vec<f32> = (0..12).map(|n| n as f32 / 16.0).collect();
        let other = (0..12).map(|n| if n > 0 { 1.0 - n as f32 / 16.0 } else { 0.0 }).collect();
        Raster { frame, body, fractions: vec![first, other], leaves: vec![2; 12] }
    }

    fn written(format: PartFormat, raster: &Raster) -> Vec<u8> {
        let names = vec!["a<b".to_owned(), "x, y".to_owned()];
        let palette = Palette::new(&[Color::new(0, 0, 0).to_oklab(), Color::new(255, 255, 255).to_oklab()]);
        let mut writer = Writer::new(format, raster, names.clone(), palette.clone());
        let mut steps = 0;
        let bytes = loop {
            if let Some(bytes) = writer.step(raster, &mut || false) {
                break bytes;
            }
            steps += 1;
            assert!((0.0..1.0).contains(&writer.progress(raster)) && steps < 100);
        };
        let whole = Writer::new(format, raster, names, palette).step(raster, &mut || true);
        assert_eq!(whole.as_ref(), Some(&bytes));
        bytes
    }

    #[test]
    fn csv_has_a_line_for_each_pixel_of_a_body() {
        let text = String::from_utf8(written(PartFormat::Csv, &raster())).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 12);
        assert_eq!(lines[..2], ["x,y,body,leaf,a<b,\"x, y\"", "11.5,22.5,0,2,0.0625,0.9375"]);
    }

    /// Both have the lower left pixel first.
    #[test]
    fn grids_have_y_upwards_and_exact_numbers() {
        let number = |bytes: &[u8], at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        let bytes = written(PartFormat::Nrrd, &raster());
        let start = bytes.windows(2).position(|pair| pair == b"\n\n").unwrap() + 2;
        assert_eq!(bytes.len() - start, 4 * 24);
        assert_eq!((number(&bytes, start), number(&bytes, start + 48)), (0.5, 0.5));
        let header = String::from_utf8_lossy(&bytes[..start]).into_owned();
        assert!(
            header.contains("sizes: 4 3 2\n") && header.contains("space origin: (10.5,20.5)\n"),
            "{header}"
        );
        let bytes = written(PartFormat::Vti, &raster());
        let start = bytes.windows(3).position(|three| three == b">\n_").unwrap() + 3;
        let header = String::from_utf8_lossy(&bytes[..start]).into_owned();
        assert!(header.contains("WholeExtent=\"0 3 0 2 0 0\" Origin=\"10.5 20.5 0\""), "{header}");
        assert!(header.contains("Name=\"0 a&lt;b\" format=\"appended\" offset=\"20\""), "{header}");
        let length = |at: usize| u64::from_le_bytes(bytes[start + at..start + at + 8].try_into().unwrap());
        assert_eq!([length(0), length(20), length(76)], [12, 48, 48]);
        assert_eq!((bytes[start + 8 + 8], number(&bytes, start + 28)), (0, 0.5));
        assert!(bytes.ends_with(b"</VTKFile>\n"));
    }

    #[test]
    fn pictures_start_at_the_top() {
        let read = |format: PartFormat, raster: &Raster| {
            let bytes = written(format, raster);
            let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a header");
            let mut found = vec![0; reader.output_buffer_size().expect("a size")];
            reader.next_frame(&mut found).expect("pixels");
            found
        };
        let colors = read(PartFormat::Png { dither: None }, &raster());
        assert_eq!((colors.len(), colors[3], colors[7]), (48, 0, 255));
        let slice = read(PartFormat::Slice { material: 0, dither: None }, &raster());
        assert_eq!((slice[0], slice[11]), (0, 175));
        let frame = Frame::new(Bounds { min: dvec2(0.0, 0.0), max: dvec2(1.0, 1.0) }, [64, 64]).unwrap();
        for (fraction, kind) in
            [(0.1_f32, Dither::Diffusion), (0.5, Dither::BlueNoise), (0.83, Dither::Diffusion)]
        {
            let fractions = vec![vec![fraction; 4096], vec![1.0 - fraction; 4096]];
            let even = Raster { frame, body: vec![1; 4096], fractions, leaves: vec![0; 4096] };
            let slice = read(PartFormat::Slice { material: 0, dither: Some(kind) }, &even);
            assert!(slice.iter().all(|value| [0, 255].contains(value)));
            let mean = slice.iter().filter(|value| **value == 255).count() as f32 / 4096.0;
            assert!((mean - fraction).abs() < 0.01, "{mean} of {fraction}");
        }
    }

    /// Every pixel of a body is in one slice, and the dithered picture has its colour.
    #[test]
    fn slices_of_all_materials_have_every_pixel_once() {
        let decoded = |bytes: &[u8]| {
            let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a header");
            let mut found = vec![0; reader.output_buffer_size().expect("a size")];
            reader.next_frame(&mut found).expect("pixels");
            found
        };
        for kind in [Dither::Diffusion, Dither::BlueNoise] {
            let archive = written(PartFormat::Slices { dither: Some(kind) }, &raster());
            let colors = decoded(&written(PartFormat::Png { dither: Some(kind) }, &raster()));
            let slices: Vec<Vec<u8>> = (0..2)
                .map(|material| written(PartFormat::Slice { material, dither: Some(kind) }, &raster()))
                .collect();
            for slice in &slices {
                assert!(archive.windows(slice.len()).any(|part| part == slice.as_slice()), "{kind:?}");
            }
            let slices: Vec<Vec<u8>> = slices.iter().map(|bytes| decoded(bytes)).collect();
            for at in 0..12 {
                let held: Vec<u8> = slices.iter().map(|slice| slice[at]).collect();
                let expected: &[u8] = if held[0] == 255 { &[0, 0, 0, 255] } else { &[255; 4] };
                match at {
                    0 => assert_eq!((held, &colors[..4]), (vec![0, 0], &[0; 4][..])),
                    _ => {
                        assert_eq!(held.iter().map(|value| u32::from(*value)).sum::<u32>(), 255);
                        assert_eq!(&colors[4 * at..4 * at + 4], expected);
                    }
                }
            }
        }
    }

    #[test]
    fn an_archive_has_a_directory_with_names_lengths_and_sums() {
        let bytes = written(PartFormat::Slices { dither: None }, &raster());
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        let end = bytes.len() - 22;
        assert_eq!((&bytes[end..end + 4], bytes[end + 10]), (&b"PK\x05\x06"[..], 2));
        let mut at = number(end + 16);
        assert_eq!(at + number(end + 12), end);
        for (k, name) in ["1 a_b.png", "2 x, y.png"].into_iter().enumerate() {
            assert_eq!(&bytes[at + 46..at + 46 + name.len()], name.as_bytes());
            let (start, length) = (number(at + 42) + 30 + name.len(), number(at + 20));
            let slice = written(PartFormat::Slice { material: k, dither: None }, &raster());
            assert_eq!(bytes[start..start + length], slice[..]);
            assert_eq!(number(at + 16) as u32, !crate::part::png::crc(u32::MAX, &slice));
            assert_eq!(bytes[number(at + 42) + 6..start - name.len()], bytes[at + 8..at + 34][..24]);
            at += 46 + name.len();
        }
    }
}
