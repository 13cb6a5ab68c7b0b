//! Pictures as PNG, row by row and without compression (W3C, "Portable Network Graphics (PNG) Specification", third edition; RFC 1950 and 1951 for its
//! stored blocks).

/// Longest row in bytes, with the number of its filter: a stored block holds no more.
pub(super) const LONGEST_ROW: usize = 65_535;

/// A picture that is written row by row.
#[derive(Debug)]
pub(super) struct PngRows {
    rows: usize,
    adler: [u32; 2],
}

impl PngRows {
    /// Appends the start of a picture: 1 channel for grey, 4 for red, green, blue and alpha, of 8 bits each.
    pub(super) fn start([width, height]: [usize; 2], channels: usize, bytes: &mut Vec<u8>) -> Self {
        bytes.extend(*b"\x89PNG\r\n\x1a\n");
        let mut header = Vec::with_capacity(13);
        header.extend((width as u32).to_be_bytes());
        header.extend((height as u32).to_be_bytes());
        header.extend([8, if channels == 4 { 6 } else { 0 }, 0, 0, 0]);
        chunk(b"IHDR", &header, bytes);
        chunk(b"IDAT", &[0x78, 0x01], bytes);
        Self { rows: height, adler: [1, 0] }
    }

    /// Appends a row from the top, and what ends the picture after the last one.
    pub(super) fn row(&mut self, row: &[u8], bytes: &mut Vec<u8>) {
        self.rows = self.rows.saturating_sub(1);
        let is_last = self.rows == 0;
        let length = row.len() as u16 + 1;
        let mut block = vec![u8::from(is_last)];
        block.extend(length.to_le_bytes());
        block.extend((!length).to_le_bytes());
        block.push(0);
        block.extend_from_slice(row);
        for byte in std::iter::once(&0).chain(row) {
            self.adler[0] = (self.adler[0] + u32::from(*byte)) % 65_521;
            self.adler[1] = (self.adler[1] + self.adler[0]) % 65_521;
        }
        if is_last {
            block.extend((self.adler[1] << 16 | self.adler[0]).to_be_bytes());
        }
        chunk(b"IDAT", &block, bytes);
        if is_last {
            chunk(b"IEND", &[], bytes);
        }
    }
}

fn chunk(name: &[u8; 4], data: &[u8], bytes: &mut Vec<u8>) {
    bytes.extend((data.len() as u32).to_be_bytes());
    let start = bytes.len();
    bytes.extend(name);
    bytes.extend_from_slice(data);
    let sum = crc(u32::MAX, &bytes[start..]);
    bytes.extend((!sum).to_be_bytes());
}

/// Goes on with a cyclic redundancy check, which starts with all bits set and is read with all bits turned.
pub(super) fn crc(sum: u32, bytes: &[u8]) -> u32 {
    bytes.iter().fold(sum, |sum, byte| TABLE[((sum ^ u32::from(*byte)) & 0xff) as usize] ^ (sum >> 8))
}

/// Remainders of single bytes.
const TABLE: [u32; 256] = {
    let mut table = [0; 256];
    let mut n = 0;
    while n < 256 {
        let mut value = n as u32;
        let mut bit = 0;
        while bit < 8 {
            value = if value & 1 == 1 { 0xedb8_8320 ^ (value >> 1) } else { value >> 1 };
            bit += 1;
        }
        table[n] = value;
        n += 1;
    }
    table
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_reader_finds_the_same_pixels() {
        for (channels, color) in [(1, png::ColorType::Grayscale), (4, png::ColorType::Rgba)] {
            let (width, height) = (37, 11);
            let rows: Vec<Vec<u8>> = (0..height)
                .map(|j| (0..width * channels).map(|i| (i * 7 + j * 31) as u8).collect())
                .collect();
            let mut bytes = Vec::new();
            let mut picture = PngRows::start([width, height], channels, &mut bytes);
            rows.iter().for_each(|row| picture.row(row, &mut bytes));
            let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a header");
            let mut found = vec![0; reader.output_buffer_size().expect("a size")];
            let info = reader.next_frame(&mut found).expect("pixels");
            assert_eq!((info.width, info.height, info.color_type), (37, 11, color));
            assert_eq!(found, rows.concat());
        }
    }
}
