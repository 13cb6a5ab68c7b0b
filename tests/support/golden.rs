//! Golden pictures: a painted picture is compared with a stored one.
//!
//! A reference that is missing fails the test. `DIRECTRIX_BLESS=1` writes the references anew. When a picture differs, reference,
//! picture and difference are written side by side to `tests/golden/out/`.

use std::fs;
use std::io::BufReader;
use std::path::PathBuf;

/// How much a picture may differ from its reference.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Threshold {
    /// Largest difference of a channel that does not count, in levels of 255.
    pub(crate) levels: u8,
    /// Share of the pixels that may differ by more.
    pub(crate) share: f64,
}

/// For pictures painted by the same code on another processor: sums in another order may round one level apart, and a coordinate
/// rounded the other way moves single pixels of an edge.
pub(crate) const SAME_CODE: Threshold = Threshold { levels: 2, share: 0.0005 };

/// A picture of straight RGBA.
pub(crate) struct Picture {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) data: Vec<u8>,
}

/// Compares a picture with the reference of that name.
///
/// # Panics
/// When they differ by more than the threshold, or the reference is missing.
pub(crate) fn check(name: &str, picture: &Picture, threshold: Threshold) {
    let path = folder().join(format!("{name}.png"));
    if std::env::var("DIRECTRIX_BLESS").is_ok_and(|value| value == "1") {
        write(&path, picture);
        return;
    }
    assert!(
        path.exists(),
        "reference {name}.png is missing; look at the picture and run with DIRECTRIX_BLESS=1"
    );
    let reference = read(&path);
    let sizes = [(reference.width, reference.height), (picture.width, picture.height)];
    assert_eq!(sizes[0], sizes[1], "{name}: sizes of reference and picture");
    let differences = differences(&reference.data, &picture.data);
    let beyond = differences.iter().filter(|&&d| d > threshold.levels).count();
    let share = beyond as f64 / differences.len() as f64;
    if share > threshold.share {
        let out = folder().join("out");
        fs::create_dir_all(&out).expect("tests/golden/out can be made");
        write(&out.join(format!("{name}.png")), &side_by_side(&reference, picture, &differences));
        let most = differences.iter().max().copied().unwrap_or(0);
        panic!(
            "{name}: {beyond} pixels ({share:.5}) differ by more than {} levels, at most {most}; allowed {}; see tests/golden/out/{name}.png",
            threshold.levels, threshold.share
        );
    }
}

/// The largest difference of a channel, for each pixel.
pub(crate) fn differences(a: &[u8], b: &[u8]) -> Vec<u8> {
    let pixels = a.chunks_exact(4).zip(b.chunks_exact(4));
    pixels.map(|(a, b)| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)).collect()
}

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests").join("golden")
}

/// Reference, picture, and the difference enlarged sixteen times in white on black.
fn side_by_side(reference: &Picture, picture: &Picture, differences: &[u8]) -> Picture {
    let row = picture.width as usize;
    let mut data = Vec::new();
    for y in 0..picture.height as usize {
        data.extend_from_slice(&reference.data[y * row * 4..(y + 1) * row * 4]);
        data.extend_from_slice(&picture.data[y * row * 4..(y + 1) * row * 4]);
        for difference in &differences[y * row..(y + 1) * row] {
            let grey = difference.saturating_mul(16);
            data.extend_from_slice(&[grey, grey, grey, 255]);
        }
    }
    Picture { width: picture.width * 3, height: picture.height, data }
}

fn write(path: &PathBuf, picture: &Picture) {
    let file = fs::File::create(path).expect("the picture file can be made");
    let mut encoder = png::Encoder::new(file, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().expect("a PNG header");
    writer.write_image_data(&picture.data).expect("PNG data");
}

fn read(path: &PathBuf) -> Picture {
    let file = BufReader::new(fs::File::open(path).expect("the reference can be opened"));
    let mut reader = png::Decoder::new(file).read_info().expect("the reference is a PNG file");
    let mut data = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut data).expect("the reference can be decoded");
    assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgba, png::BitDepth::Eight));
    Picture { width: info.width, height: info.height, data }
}
