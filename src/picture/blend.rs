//! Arithmetic of pixels: RGBA of eight bits each, premultiplied.

/// Lays an opaque colour over a pixel, as strong as `alpha` (0 to 255).
pub(super) fn blend(target: &mut [u8], source: [u8; 4], alpha: u32) {
    let [t0, t1, t2, t3] = [target[0], target[1], target[2], target[3]];
    let (below, above) = (u32::from_le_bytes([t0, t1, t2, t3]), u32::from_le_bytes(source));
    let even = mix_pair(below & PAIR, above & PAIR, alpha);
    let odd = mix_pair(below >> 8 & PAIR, above >> 8 & PAIR, alpha);
    target.copy_from_slice(&(even | odd << 8).to_le_bytes());
}

/// Lays a few pixels over others, each as strong as its coverage times the opacity (0 to 255); a block that is wholly covered goes
/// without arithmetic.
pub(super) fn compose_block(targets: &mut [u8], pixels: &[[u8; 4]], covers: &[u8], opacity: u32) {
    if opacity == 255
        && covers.iter().fold(255, |all, cover| all & cover) == 255
        && pixels.iter().fold(255, |all, p| all & p[3]) == 255
    {
        targets.copy_from_slice(pixels.as_flattened());
        return;
    }
    for ((target, source), &cover) in targets.chunks_exact_mut(4).zip(pixels).zip(covers) {
        if source[3] != 0 {
            blend(target, *source, (u32::from(cover) * opacity + 127) / 255);
        }
    }
}

/// Turns premultiplied pixels into straight ones.
pub(super) fn straighten(data: &mut [u8]) {
    for pixel in data.chunks_exact_mut(4) {
        let alpha = u32::from(pixel[3]);
        if alpha != 0 && alpha != 255 {
            for value in &mut pixel[..3] {
                *value = ((u32::from(*value) * 255 + alpha / 2) / alpha).min(255) as u8;
            }
        }
    }
}

/// Two channels of eight bits in a word, each with eight bits free above it.
const PAIR: u32 = 0x00ff_00ff;

/// Mixes two channels at once, each rounded to the nearest: x / 255 is (y + y / 256) / 256 with y = x + 128, for all products x of
/// two bytes.
fn mix_pair(below: u32, above: u32, alpha: u32) -> u32 {
    let y = above * alpha + below * (255 - alpha) + 0x0080_0080;
    (y + (y >> 8 & PAIR)) >> 8 & PAIR
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_of_channels_mix_to_the_nearest_level() {
        for alpha in 0..=255_u32 {
            for (below, above) in (0..=255).step_by(5).flat_map(|b| (0..=255).step_by(3).map(move |a| (b, a)))
            {
                let exact =
                    |b: u32, a: u32| (f64::from(a * alpha + b * (255 - alpha)) / 255.0).round() as u32;
                let found = mix_pair(below << 16 | above, above << 16 | below, alpha);
                assert_eq!(found, exact(below, above) << 16 | exact(above, below), "{below} {above} {alpha}");
            }
        }
    }
}
