//! The document format: reading, checking, defaults.
