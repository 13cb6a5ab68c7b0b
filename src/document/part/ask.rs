//! Questions about a part, as they arrive in JSON.

use super::super::node::Node;
use super::super::{Code, DocumentError, Json};
use super::PartModel;
use crate::geom::Bounds;
use crate::part::{Dither, Frame, FrameError, MOST_PIXELS, PartFormat};
use glam::DVec2;

/// Pixels along the longer side of a raster that is not told a size.
const PIXELS: usize = 256;
/// Most pixels between which isolines are drawn.
const MOST_TRACED: usize = 1 << 20;
/// Most levels of isolines.
const MOST_LEVELS: usize = 100;
/// Most places along a line.
const MOST_ALONG: usize = 10_000;
/// Greatest coordinate.
const LARGEST: f64 = 1e9;

/// A question about a part.
#[derive(Debug, Clone, PartialEq)]
pub enum PartAsk {
    /// Bodies, diagnostics and the box.
    Summary,
    /// The document with all defaults spelt out.
    Defaults,
    /// What there is on pixels.
    Evaluate {
        /// The pixels.
        frame: Frame,
        /// Whether colours are wanted.
        has_colors: bool,
    },
    /// What there is at a point.
    Probe(DVec2),
    /// What there is along a line.
    Along {
        /// Its ends.
        ends: [DVec2; 2],
        /// Number of places, the ends among them.
        count: usize,
    },
    /// Where design rules are broken.
    Violations(Frame),
    /// Area and amount of each material.
    Amounts(Frame),
    /// Lines of equal composition.
    Isolines {
        /// The pixels between which they are drawn.
        frame: Frame,
        /// The material.
        material: usize,
        /// The fractions.
        levels: Vec<f64>,
    },
    /// The leaves of the subdivision.
    Leaves(Frame),
    /// A file.
    File {
        /// The pixels.
        frame: Frame,
        /// Its format.
        format: PartFormat,
    },
}

impl PartAsk {
    /// Reads a question by its name with what belongs to it.
    ///
    /// # Errors
    /// The first thing that is wrong, with its path: such as `options.size`, `point` or `count`.
    pub fn read(name: &str, rest: &Json, model: &PartModel) -> Result<Self, DocumentError> {
        let root = Node::root(rest, "");
        let empty = Json::Object(Vec::new());
        let options = root.get("options")?.unwrap_or_else(|| Node::root(&empty, "options"));
        let frame = |known: &[&str], most: usize| {
            options.only(&[&["box", "size", "pitch"], known].concat())?;
            read_frame(&options, model, most)
        };
        Ok(match name {
            "part" => Self::Summary,
            "defaults" => Self::Defaults,
            "evaluate" => Self::Evaluate {
                frame: frame(&["colors"], MOST_PIXELS)?,
                has_colors: options.get("colors")?.map_or(Ok(false), |node| node.flag())?,
            },
            "probe" => Self::Probe(place(&root.need("point")?)?),
            "along" => {
                let ends = root.need("ends")?;
                let items = ends.items()?;
                ends.check_count(items.len(), " points", 2..=2)?;
                let count = root.need("count")?.count_within(2..=MOST_ALONG)?;
                Self::Along { ends: [place(&items[0])?, place(&items[1])?], count }
            }
            "violations" => Self::Violations(frame(&[], MOST_PIXELS)?),
            "amounts" => Self::Amounts(frame(&[], MOST_PIXELS)?),
            "leaves" => Self::Leaves(frame(&[], MOST_PIXELS)?),
            "isolines" => Self::Isolines {
                frame: frame(&["material", "levels"], MOST_TRACED)?,
                material: material(&options, model)?.unwrap_or(0),
                levels: levels(&options)?,
            },
            "file" => {
                let frame = frame(&["format", "material", "dither"], MOST_PIXELS)?;
                Self::File { frame, format: format(&options, model, &frame)? }
            }
            _ => return Err(root.error(Code::Range, format!("\"{name}\" is no question about a part"))),
        })
    }

    /// The pixels that the question needs.
    pub(super) fn frame(&self) -> Option<Frame> {
        match self {
            Self::Evaluate { frame, .. }
            | Self::Violations(frame)
            | Self::Amounts(frame)
            | Self::Leaves(frame)
            | Self::Isolines { frame, .. }
            | Self::File { frame, .. } => Some(*frame),
            _ => None,
        }
    }
}

fn place(node: &Node<'_>) -> Result<DVec2, DocumentError> {
    let pair = node.pair()?;
    for item in node.items()? {
        item.within(-LARGEST..=LARGEST)?;
    }
    Ok(DVec2::from_array(pair))
}

/// The box, by default that of all bodies, and the number of pixels: as asked for, by the width of a pixel, or 256 along its longer side.
fn read_frame(options: &Node<'_>, model: &PartModel, most: usize) -> Result<Frame, DocumentError> {
    let bounds = match options.get("box")? {
        Some(node) => {
            let items = node.items()?;
            node.check_count(items.len(), " corners", 2..=2)?;
            let (a, b) = (place(&items[0])?, place(&items[1])?);
            Bounds { min: a.min(b), max: a.max(b) }
        }
        None => model.part().bounds().ok_or_else(|| {
            let message = "the part has no body that can be made; expected a box";
            DocumentError::new(Code::Range, "options.box", message)
        })?,
    };
    let (bounds, size) = match (options.get("size")?, options.get("pitch")?) {
        (Some(_), Some(node)) => {
            let message = "expected none, because `size` says how many pixels there are";
            return Err(node.error(Code::Range, message.to_owned()));
        }
        (None, Some(node)) => pitched(bounds, &node, most)?,
        (Some(node), None) => {
            let items = node.items()?;
            node.check_count(items.len(), " numbers", 2..=2)?;
            let size = [items[0].count_within(1..=most)?, items[1].count_within(1..=most)?];
            if size[0].checked_mul(size[1]).is_none_or(|count| count > most) {
                let message = format!("{} x {} pixels were found; expected {most} at most", size[0], size[1]);
                return Err(node.error(Code::Limit, message));
            }
            (bounds, size)
        }
        (None, None) => {
            let extent = bounds.max - bounds.min;
            let longest = extent.max_element().max(f64::MIN_POSITIVE);
            let count = |along: f64| ((PIXELS as f64 * along / longest).round() as usize).max(1);
            (bounds, extent.to_array().map(count))
        }
    };
    let frame = Frame::new(bounds, size).and_then(|frame| frame.check(model.part()).map(|()| frame));
    frame.map_err(|error| match error {
        FrameError::Empty => DocumentError::new(Code::Range, "options.box", error.to_string()),
        _ => DocumentError::new(Code::Limit, "options.size", error.to_string()),
    })
}

/// Square pixels of a width, as many as the box needs, which grows evenly on both sides to whole pixels.
fn pitched(bounds: Bounds, node: &Node<'_>, most: usize) -> Result<(Bounds, [usize; 2]), DocumentError> {
    let pitch = node.within(f64::MIN_POSITIVE..=LARGEST)?;
    let extent = bounds.max - bounds.min;
    // A box of whole pixels up to rounding stays as it is.
    let counts = (extent / pitch - 1e-9).ceil().max(DVec2::ONE);
    if counts.x * counts.y > most as f64 {
        let message = format!("{} x {} pixels would be needed; expected {most} at most", counts.x, counts.y);
        return Err(node.error(Code::Limit, message));
    }
    let (center, half) = ((bounds.min + bounds.max) / 2.0, counts * (pitch / 2.0));
    let size = counts.to_array().map(|count| count as usize);
    Ok((Bounds { min: center - half, max: center + half }, size))
}

fn material(options: &Node<'_>, model: &PartModel) -> Result<Option<usize>, DocumentError> {
    options.get("material")?.map(|node| node.index(model.materials().len(), "material")).transpose()
}

fn levels(options: &Node<'_>) -> Result<Vec<f64>, DocumentError> {
    let Some(list) = options.get("levels")? else {
        return Ok((1..10).map(|tenth| f64::from(tenth) / 10.0).collect());
    };
    let items = list.items()?;
    list.check_count(items.len(), " levels", 1..=MOST_LEVELS)?;
    items.iter().map(|item| item.within(0.0..=1.0)).collect()
}

fn format(options: &Node<'_>, model: &PartModel, frame: &Frame) -> Result<PartFormat, DocumentError> {
    let node = options.need("format")?;
    let refused = |field: &str, message: &str| match options.get(field)? {
        Some(node) => Err(node.error(Code::Range, message.to_owned())),
        None => Ok(()),
    };
    let dither = || match options.get("dither")? {
        Some(node) => {
            let kinds = [None, Some(Dither::Diffusion), Some(Dither::BlueNoise)];
            Ok(kinds[node.choice(&["none", "diffusion", "blue-noise"])?])
        }
        None => Ok(None),
    };
    let choice = node.choice(&["csv", "vti", "nrrd", "png", "slices"])?;
    if choice != 3 {
        refused("material", "expected none, because only a `png` is of one material")?;
    }
    if choice < 3 {
        refused("dither", "expected none, because only `png` and `slices` have it")?;
    }
    let format = match choice {
        0 => PartFormat::Csv,
        1 => PartFormat::Vti,
        2 => PartFormat::Nrrd,
        3 => match material(options, model)? {
            None => PartFormat::Png { dither: dither()? },
            Some(material) => PartFormat::Slice { material, dither: dither()? },
        },
        _ => PartFormat::Slices { dither: dither()? },
    };
    checked(format, frame)
}

/// Refuses rows that are too long for a format.
fn checked(format: PartFormat, frame: &Frame) -> Result<PartFormat, DocumentError> {
    if frame.size()[0] <= format.widest() {
        return Ok(format);
    }
    let message =
        format!("{} pixels in a row were found; expected {} at most", frame.size()[0], format.widest());
    Err(DocumentError::new(Code::Limit, "options.size[0]", message))
}
