//! Several files in one, as ZIP without compression (PKWARE, "APPNOTE.TXT: .ZIP File Format Specification", 6.3).

use super::png::crc;

/// Names are UTF-8.
const FLAGS: u16 = 1 << 11;
/// The first of January 1980: the same content is the same file.
const DATE: u16 = 0x21;
/// Version of the specification that a reader needs.
const VERSION: u16 = 10;

/// An archive that is written file by file.
#[derive(Debug, Default)]
pub(super) struct Archive {
    entries: Vec<Entry>,
}

#[derive(Debug)]
struct Entry {
    name: String,
    /// Where its header stands.
    start: usize,
    /// Where its content stands, and how much of it is in the sum.
    content: usize,
    summed: usize,
    sum: u32,
}

impl Archive {
    /// Appends the start of a file, whose content is what is appended from then on.
    pub(super) fn start(&mut self, name: String, bytes: &mut Vec<u8>) {
        let start = bytes.len();
        bytes.extend(*b"PK\x03\x04");
        // What is not known yet is put in its place at the end of the file.
        header(&name, [0; 3], bytes);
        bytes.extend_from_slice(name.as_bytes());
        self.entries.push(Entry { name, start, content: bytes.len(), summed: bytes.len(), sum: u32::MAX });
    }

    /// Takes what was appended into the sum of the file.
    pub(super) fn sum(&mut self, bytes: &[u8]) {
        if let Some(entry) = self.entries.last_mut() {
            entry.sum = crc(entry.sum, &bytes[entry.summed..]);
            entry.summed = bytes.len();
        }
    }

    /// Ends a file.
    pub(super) fn end(&mut self, bytes: &mut [u8]) {
        self.sum(bytes);
        if let Some(entry) = self.entries.last() {
            for (n, value) in entry.numbers().into_iter().enumerate() {
                bytes[entry.start + 14 + 4 * n..][..4].copy_from_slice(&value.to_le_bytes());
            }
        }
    }

    /// Appends the directory of all files.
    pub(super) fn finish(&self, bytes: &mut Vec<u8>) {
        let start = bytes.len();
        for entry in &self.entries {
            bytes.extend(*b"PK\x01\x02");
            bytes.extend(VERSION.to_le_bytes());
            header(&entry.name, entry.numbers(), bytes);
            // No comment, on the first disk, no attributes.
            bytes.extend([0; 10]);
            bytes.extend((entry.start as u32).to_le_bytes());
            bytes.extend_from_slice(entry.name.as_bytes());
        }
        let length = bytes.len() - start;
        let count = (self.entries.len() as u16).to_le_bytes();
        bytes.extend(*b"PK\x05\x06\0\0\0\0");
        bytes.extend([count, count].concat());
        bytes.extend((length as u32).to_le_bytes());
        bytes.extend((start as u32).to_le_bytes());
        bytes.extend([0, 0]);
    }
}

impl Entry {
    /// Sum, and twice the length, which is that of the content packed and unpacked.
    fn numbers(&self) -> [u32; 3] {
        let length = (self.summed - self.content) as u32;
        [!self.sum, length, length]
    }
}

/// What a file has both before its content and in the directory.
fn header(name: &str, numbers: [u32; 3], bytes: &mut Vec<u8>) {
    // Stored, at midnight.
    for value in [VERSION, FLAGS, 0, 0, DATE] {
        bytes.extend(value.to_le_bytes());
    }
    bytes.extend(numbers.into_iter().flat_map(u32::to_le_bytes));
    bytes.extend((name.len() as u16).to_le_bytes());
    // No extra field.
    bytes.extend([0, 0]);
}
