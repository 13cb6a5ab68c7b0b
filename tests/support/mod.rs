//! Helpers shared by the end-to-end tests.

pub mod golden;
pub mod outlines;
pub mod pairs;

use glam::DVec2;
use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngSeed, TestCaseResult, TestRunner};
use serde_json::{Value, json};

/// The seed of every property test; a failing run prints it with the smallest case.
pub const SEED: u64 = 20_261_123;

/// Runs a property on `cases` values of a strategy, always the same ones.
pub fn seeded<S: Strategy>(cases: u32, strategy: &S, property: impl FnMut(S::Value) -> TestCaseResult) {
    let property = std::cell::RefCell::new(property);
    let config =
        Config { cases, rng_seed: RngSeed::Fixed(SEED), failure_persistence: None, ..Config::default() };
    TestRunner::new(config)
        .run(strategy, |value| (property.borrow_mut())(value))
        .unwrap_or_else(|failure| panic!("seed {SEED}: {failure}"));
}

/// Points as a document has them.
pub fn list(points: &[DVec2]) -> Value {
    points.iter().map(|p| json!(p.to_array())).collect()
}
