//! End-to-end tests, by topic. They are one program, because each one would be compiled and linked with the whole crate again.

mod amounts;
mod certificates;
mod curve;
mod documents;
mod fitting;
mod hostile;
mod import;
mod insertion;
mod matching;
mod methods;
mod open;
mod picture;
mod solid;
mod stack;
mod support;
