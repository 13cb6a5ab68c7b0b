//! The SVG writer.

use std::fmt::Write;

use glam::DVec2;

use super::clip::Frame;
use super::grid::{GridLine, grid_lines};
use super::svg_hatch::hatch;
use super::svg_shade::{Patch, Shade, mean_color, patches};
use super::{DisplayList, Item, Mesh, Path, StrokeStyle, Viewport};
use crate::material::Color;

/// Room round the picture in which geometry is kept, in device pixels on top of the width of the line.
const MARGIN: f64 = 16.0;

/// Width of the line in its own shade round each patch of a mesh, in CSS pixels. Renderers anti-alias each patch by
/// itself, so that patches that only touch would let the background through. With a pixel of overlap on both sides none shows,
/// down to half the size; the neighbours hardly differ in colour, so that the overlap does not show either.
const PATCH_OVERLAP: &str = "2";

/// Writes a picture as an SVG document of `width / pixel_ratio` by `height / pixel_ratio` CSS pixels.
///
/// Each layer is a group whose id is made from its name. A mesh, which SVG cannot shade as such, is written as
/// patches with a linear gradient each, clipped by its outline. Title and description are text for
/// readers and screen readers, and are escaped.
///
/// An item that [`paint`](super::paint) would refuse is left out, and a viewport that it would refuse gives an empty picture.
#[must_use]
pub fn to_svg(list: &DisplayList, viewport: &Viewport, title: &str, description: &str) -> String {
    let mut writer = Writer::new(viewport);
    writer.open(title, description);
    if viewport.check().is_ok() {
        writer.layers(list);
    }
    writer.out.push_str("</svg>\n");
    writer.out
}

/// Stops that are written, with the id of the gradient that holds them.
struct Ramp {
    stops: Vec<Color>,
    id: String,
}

struct Writer<'a> {
    out: String,
    viewport: &'a Viewport,
    /// CSS pixels per device pixel.
    unit: f64,
}

impl<'a> Writer<'a> {
    fn new(viewport: &'a Viewport) -> Self {
        let good = viewport.check().is_ok();
        let unit = if good { 1.0 / viewport.pixel_ratio } else { 1.0 };
        Self { out: String::new(), viewport, unit }
    }

    fn open(&mut self, title: &str, description: &str) {
        let (width, height) = self.size();
        let (width, height) = (number(width), number(height));
        self.add(&format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\">\n<title>{}</title>\n",
            escape(title)
        ));
        if !description.is_empty() {
            self.add(&format!("<desc>{}</desc>\n", escape(description)));
        }
    }

    fn layers(&mut self, list: &DisplayList) {
        if let Some(color) = list.background {
            self.add(&format!("<rect width=\"100%\" height=\"100%\" fill=\"{color}\"/>\n"));
        }
        let mut ids = Vec::new();
        for layer in &list.layers {
            self.add(&format!("<g id=\"{}\">\n", fresh_id(&layer.name, &mut ids)));
            for item in layer.items.iter().filter(|item| item.check(&layer.name).is_ok()) {
                self.item(item);
            }
            self.add("</g>\n");
        }
    }

    fn item(&mut self, item: &Item) {
        match item {
            Item::Grid { minor, major } => {
                let lines = grid_lines(self.viewport);
                self.grid(&lines, minor, false);
                self.grid(&lines, major, true);
            }
            Item::Mesh { mesh, outline, opacity } => self.mesh(mesh, outline, *opacity),
            Item::Stroke { path, style } => self.stroke(path, style),
            Item::Fill { path, color, opacity } => {
                let data = self.polygons(path);
                if !data.is_empty() {
                    let opacity = attribute("fill-opacity", *opacity);
                    self.add(&format!(
                        "<path fill=\"{color}\" fill-rule=\"evenodd\"{opacity} d=\"{data}\"/>\n"
                    ));
                }
            }
            Item::Hatch { blends, materials, color, .. } => {
                for &material in materials {
                    let data = self.polygons(&hatch(blends, material, self.viewport));
                    if !data.is_empty() {
                        self.add(&format!("<path fill=\"{color}\" fill-rule=\"evenodd\" d=\"{data}\"/>\n"));
                    }
                }
            }
            Item::Dots { centers, radius_px, color, opacity } => {
                let opacity = attribute("opacity", *opacity);
                self.marks(&format!("<g fill=\"{color}\"{opacity}>\n"), centers, *radius_px, circle);
            }
            Item::Rings { centers, radius_px, style } => {
                let open = format!("<g fill=\"none\"{}>\n", stroke_attributes(style, false));
                self.marks(&open, centers, *radius_px, circle);
            }
            Item::Crosses { centers, size_px, style } => {
                let open = format!("<g fill=\"none\"{}>\n", stroke_attributes(style, false));
                self.marks(&open, centers, *size_px, cross);
            }
        }
    }

    fn grid(&mut self, [columns, rows]: &[Vec<GridLine>; 2], style: &StrokeStyle, major: bool) {
        let (width, height) = self.size();
        let (width, height) = (number(width), number(height));
        let snap = |line: &&GridLine| line.major == major;
        let mut data = String::new();
        for line in columns.iter().filter(snap) {
            data += &format!("M{} 0V{height}", number(self.crisp(line.at)));
        }
        for line in rows.iter().filter(snap) {
            data += &format!("M0 {}H{width}", number(self.crisp(line.at)));
        }
        self.line(&data, style, true);
    }

    fn stroke(&mut self, path: &Path, style: &StrokeStyle) {
        let dashed = style.dash.is_some();
        let margin = MARGIN + f64::from(style.width_px) / self.unit;
        let pieces = Frame::around(self.viewport, margin).pieces(path, self.viewport, dashed);
        let mut data = String::new();
        for piece in &pieces {
            self.push_line(&mut data, &piece.points, piece.closed);
            if let Some([on, off]) = style.dash.filter(|[on, off]| on + off > 0.0) {
                let offset = (piece.start * self.unit) % f64::from(on + off);
                let attributes = stroke_attributes(style, true);
                let offset = if offset > 0.0 {
                    format!(" stroke-dashoffset=\"{}\"", number(offset))
                } else {
                    String::new()
                };
                self.add(&format!("<path fill=\"none\"{attributes}{offset} d=\"{data}\"/>\n"));
                data.clear();
            }
        }
        self.line(&data, style, false);
    }

    fn line(&mut self, data: &str, style: &StrokeStyle, flat: bool) {
        if !data.is_empty() && style.width_px > 0.0 {
            let style = StrokeStyle { dash: None, ..*style };
            self.add(&format!("<path fill=\"none\"{} d=\"{data}\"/>\n", stroke_attributes(&style, flat)));
        }
    }

    fn marks(&mut self, open: &str, centers: &[DVec2], size_px: f32, mark: fn([f64; 2], f64) -> String) {
        let frame = Frame::around(self.viewport, MARGIN + f64::from(size_px) / self.unit);
        self.add(open);
        for place in centers.iter().map(|&p| self.viewport.place(p)).filter(|&p| frame.contains(p)) {
            self.add(&mark((place * self.unit).to_array(), size_px.into()));
        }
        self.add("</g>\n");
    }

    /// The mesh as shaded patches over its mean colour, all inside the outline.
    fn mesh(&mut self, mesh: &Mesh, outline: &Path, opacity: f32) {
        let patches = patches(mesh, self.viewport, &Frame::around(self.viewport, MARGIN));
        let clip = self.polygons(outline);
        let hidden = !outline.rings.is_empty() && clip.is_empty();
        if patches.is_empty() || hidden {
            return;
        }
        // Equal ids then mean equal clips and equal shades, so pictures in one page cannot disturb each other.
        let name = format!("{:016x}", fingerprint(&clip, &patches));
        let mut reference = String::new();
        if !clip.is_empty() {
            self.add(&format!(
                "<clipPath id=\"clip-{name}\"><path clip-rule=\"evenodd\" d=\"{clip}\"/></clipPath>\n"
            ));
            reference = format!(" clip-path=\"url(#clip-{name})\"");
        }
        let opacity = attribute("opacity", opacity);
        self.add(&format!(
            "<g{reference}{opacity} stroke-width=\"{PATCH_OVERLAP}\" stroke-linejoin=\"round\">\n"
        ));
        if !clip.is_empty() {
            let below = mean_color(mesh);
            self.add(&format!("<path fill=\"{below}\" fill-rule=\"evenodd\" d=\"{clip}\"/>\n"));
        }
        let mut ramps = Vec::new();
        for (k, patch) in patches.iter().enumerate() {
            self.patch(patch, &format!("{name}-{k}"), &mut ramps);
        }
        self.add("</g>\n");
    }

    /// One patch. Later gradients refer to the stops written so far, `ramps`.
    fn patch(&mut self, patch: &Patch, name: &str, ramps: &mut Vec<Ramp>) {
        let paint = match &patch.shade {
            Shade::Flat(color) => color.to_string(),
            Shade::Linear { from, to, stops } => {
                let ramp = self.ramp(stops, name, ramps);
                let [x1, y1, x2, y2] = [from.x, from.y, to.x, to.y].map(|at| number(at * self.unit));
                self.add(&format!(
                    "<linearGradient id=\"g-{name}\" href=\"#{ramp}\" gradientUnits=\"userSpaceOnUse\" \
                     x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"/>"
                ));
                format!("url(#g-{name})")
            }
        };
        let mut data = String::new();
        self.push_line(&mut data, &patch.ring, true);
        self.add(&format!("<path fill=\"{paint}\" stroke=\"{paint}\" d=\"{data}\"/>\n"));
    }

    /// The id of a gradient that holds the stops.
    fn ramp(&mut self, stops: &[Color], name: &str, ramps: &mut Vec<Ramp>) -> String {
        if let Some(ramp) = ramps.iter().find(|ramp| ramp.stops == stops) {
            return ramp.id.clone();
        }
        let last = stops.len().saturating_sub(1).max(1) as f64;
        let mut text = String::new();
        for (k, color) in stops.iter().enumerate() {
            let offset = number(k as f64 / last);
            text += &format!("<stop offset=\"{offset}\" stop-color=\"{color}\"/>");
        }
        let id = format!("r-{name}");
        self.add(&format!("<linearGradient id=\"{id}\">{text}</linearGradient>\n"));
        ramps.push(Ramp { stops: stops.to_vec(), id: id.clone() });
        id
    }

    fn polygons(&self, path: &Path) -> String {
        let mut data = String::new();
        for ring in Frame::around(self.viewport, MARGIN).polygons(path, self.viewport) {
            self.push_line(&mut data, &ring, true);
        }
        data
    }

    /// Path data of a line. Points after the first are written relative to the rounded one before, which is shorter and
    /// lets no rounding add up.
    fn push_line(&self, data: &mut String, points: &[DVec2], closed: bool) {
        let rounded = |p: &DVec2| (*p * self.unit * 100.0).round() / 100.0;
        let mut before = DVec2::ZERO;
        for (i, point) in points.iter().map(rounded).enumerate() {
            let offset = point - before;
            let (x, y) = (number(offset.x), number(offset.y));
            let command = match i {
                0 => "M",
                1 => "l",
                _ if x.starts_with('-') => "",
                _ => " ",
            };
            let gap = if y.starts_with('-') { "" } else { " " };
            *data += command;
            *data += &x;
            *data += gap;
            *data += &y;
            before = point;
        }
        if closed {
            data.push('z');
        }
    }

    /// The middle of the pixel that a grid line is painted on, in CSS pixels.
    fn crisp(&self, at: f64) -> f64 {
        ((at - 0.5).round() + 0.5) * self.unit
    }

    fn size(&self) -> (f64, f64) {
        (f64::from(self.viewport.width) * self.unit, f64::from(self.viewport.height) * self.unit)
    }

    fn add(&mut self, text: &str) {
        self.out.push_str(text);
    }
}

fn circle([x, y]: [f64; 2], radius: f64) -> String {
    format!("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", number(x), number(y), number(radius))
}

fn cross([x, y]: [f64; 2], size: f64) -> String {
    let (left, top, low) = (number(x - size / 2.0), number(y - size / 2.0), number(y + size / 2.0));
    let (size, back) = (number(size), number(-size));
    format!("<path d=\"M{left} {top}l{size} {size}M{left} {low}l{size} {back}\"/>\n")
}

fn stroke_attributes(style: &StrokeStyle, flat: bool) -> String {
    let width = number(style.width_px.into());
    let mut text = format!(" stroke=\"{}\" stroke-width=\"{width}\"", style.color);
    text += &attribute("stroke-opacity", style.opacity);
    if let Some([on, off]) = style.dash.filter(|_| flat) {
        text += &format!(" stroke-dasharray=\"{} {}\"", number(on.into()), number(off.into()));
    }
    if !flat {
        text += " stroke-linecap=\"round\"";
    }
    text += " stroke-linejoin=\"round\"";
    text
}

/// An attribute for an opacity, left out when it is 1.
fn attribute(name: &str, opacity: f32) -> String {
    if opacity >= 1.0 { String::new() } else { format!(" {name}=\"{}\"", number(opacity.into())) }
}

/// A number with at most two decimals and nothing superfluous. Coordinates are clipped long before they leave its range.
fn number(value: f64) -> String {
    let hundredths = (value * 100.0).round() as i64;
    let (whole, rest) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    let sign = if hundredths < 0 { "-" } else { "" };
    match rest {
        0 => format!("{sign}{whole}"),
        _ if rest % 10 == 0 => format!("{sign}{whole}.{}", rest / 10),
        _ => format!("{sign}{whole}.{rest:02}"),
    }
}

/// Text that XML reads back as the same text, except characters that XML cannot hold, which become U+FFFD.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&apos;"),
            '\t' | '\n' => escaped.push(character),
            '\r' => escaped.push_str("&#13;"),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            _ => escaped.push(character),
        }
    }
    escaped
}

/// An id of letters, digits and hyphens made from a name, different from those given out before.
fn fresh_id(name: &str, used: &mut Vec<String>) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
    let base = format!("layer-{}", name.chars().take(64).map(plain).collect::<String>());
    let mut id = base.clone();
    let mut count = 1;
    while used.contains(&id) {
        count += 1;
        id.truncate(base.len());
        // Writing to a string cannot fail.
        let _ = write!(id, "-{count}");
    }
    used.push(id.clone());
    id
}

/// The hash FNV-1a of a clip and the patches inside it.
fn fingerprint(clip: &str, patches: &[Patch]) -> u64 {
    let bits = |p: DVec2| [p.x.to_bits(), p.y.to_bits()];
    let bytes = |c: &Color| [c.r, c.g, c.b].map(u64::from);
    let shade = |shade: &Shade| match shade {
        Shade::Flat(color) => bytes(color).to_vec(),
        Shade::Linear { from, to, stops } => {
            stops.iter().flat_map(bytes).chain(bits(*from)).chain(bits(*to)).collect()
        }
    };
    let of_patch = |patch: &Patch| {
        patch.ring.iter().copied().flat_map(bits).chain(shade(&patch.shade)).collect::<Vec<_>>()
    };
    let words = clip.bytes().map(u64::from).chain(patches.iter().flat_map(of_patch));
    words.fold(0xcbf2_9ce4_8422_2325, |h, word| (h ^ word).wrapping_mul(0x0000_0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (0.0, "0"),
            (-0.001, "0"),
            (1.0, "1"),
            (100.0, "100"),
            (0.5, "0.5"),
            (-12.346, "-12.35"),
            (1e-9, "0"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn escaping() {
        assert_eq!(escape("a<b & \"c\" > 'd'"), "a&lt;b &amp; &quot;c&quot; &gt; &apos;d&apos;");
        assert_eq!(escape("\u{0}\u{1b}\u{ffff}\t\n ß 梯"), "\u{fffd}\u{fffd}\u{fffd}\t\n ß 梯");
    }

    #[test]
    fn ids_are_plain_and_differ() {
        let mut used = Vec::new();
        assert_eq!(fresh_id("rulingLines", &mut used), "layer-rulingLines");
        assert_eq!(fresh_id("rulingLines", &mut used), "layer-rulingLines-2");
        assert_eq!(fresh_id("\"><script>", &mut used), "layer----script-");
    }
}
