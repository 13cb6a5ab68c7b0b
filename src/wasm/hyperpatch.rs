//! Bodies of hyperpatches: documents come in and questions are answered, in steps.

use super::answers;
use super::clock;
use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use super::reading::Reading;
use crate::document::{Answer, BodyAsk, BodyJob, BodyMemory, DocumentError, DocumentKey, KnownBody, Replay};
use js_sys::Array;
use std::rc::Rc;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// An answer under way.
#[wasm_bindgen]
pub struct Asking {
    key: DocumentKey,
    /// The name of the question and what belongs to it.
    question: [String; 2],
    state: State,
    known: Option<Rc<KnownBody>>,
    answer: Option<Answer>,
}

enum State {
    /// The operations of a document are read.
    Reading(Reading),
    /// They are carried out.
    Replaying(Box<Replay>),
    /// The body is there.
    Known,
    Answering(Box<BodyJob>),
    Done,
}

#[wasm_bindgen]
impl Engine {
    /// A question about a hyperpatch document by its name, to be answered in steps; what belongs to it comes as JSON. The document comes as
    /// the text of all but its operations with a key for each of these, the same for the same operation alone; or, with `is_apart` false, as one
    /// text with all of it. Operations that are [`Asking::missing`] have to be supplied.
    pub fn hyperpatch(&mut self, head: &str, keys: &[u32], is_apart: bool, name: &str, rest: &str) -> Asking {
        let key = DocumentKey { head: head.to_owned(), operations: keys.to_vec() };
        let known = self.bodies.find(&key);
        let state = match known {
            Some(_) => State::Known,
            None => State::Reading(Reading::new(&self.bodies, &key, is_apart)),
        };
        Asking { key, question: [name, rest].map(str::to_owned), state, known, answer: None }
    }

    /// Goes on with an answer for about `budget` milliseconds; returns the share done, 1 when it is there.
    #[wasm_bindgen(js_name = answer)]
    pub fn advance_answer(&mut self, asking: &mut Asking, budget: f64) -> Result<f64, JsValue> {
        let clock = clock();
        let start = clock.now();
        let mut may_go_on = || clock.now() - start < budget;
        loop {
            let share = asking.advance(&mut self.bodies, &mut may_go_on).map_err(|error| to_js(&error))?;
            if share == 1.0 || !may_go_on() {
                return Ok(share);
            }
        }
    }
}

impl Asking {
    /// Goes on with the present part of the work; returns the share done.
    fn advance(
        &mut self,
        memory: &mut BodyMemory,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Result<f64, DocumentError> {
        match std::mem::replace(&mut self.state, State::Done) {
            State::Reading(mut reading) => {
                let Some(document) = reading.step(may_go_on)? else {
                    let share = reading.progress() / 4.0;
                    self.state = State::Reading(reading);
                    return Ok(share);
                };
                self.state = State::Replaying(Box::new(Replay::new(document, memory.models())?));
                Ok(0.25)
            }
            State::Replaying(mut replay) => {
                if replay.step(may_go_on) {
                    self.known = Some(memory.keep(self.key.clone(), replay.finish()));
                    self.state = State::Known;
                    return Ok(0.5);
                }
                let share = 0.25 + replay.progress() / 4.0;
                self.state = State::Replaying(replay);
                Ok(share)
            }
            State::Known => {
                let Some(known) = &self.known else { return Ok(1.0) };
                let [name, rest] = &self.question;
                let ask = BodyAsk::read(name, &parse(rest)?, known.model())?;
                self.state = State::Answering(Box::new(BodyJob::new(Rc::clone(known), ask)));
                Ok(0.5)
            }
            State::Answering(mut job) => {
                self.answer = job.step(may_go_on);
                if self.answer.is_some() {
                    return Ok(1.0);
                }
                let share = job.progress();
                self.state = State::Answering(job);
                Ok(share)
            }
            State::Done => Ok(1.0),
        }
    }
}

#[wasm_bindgen]
impl Asking {
    /// Places in the list of the operations that are not known and have to be supplied.
    pub fn missing(&self) -> Vec<u32> {
        if let State::Reading(reading) = &self.state { reading.missing() } else { Vec::new() }
    }

    /// Supplies an operation that is missing as JSON. The cells of one that has some come apart, and their number beside them: where it passes the
    /// limit they may be left out.
    pub fn supply(&mut self, place: usize, text: &str, cells: Option<Array>, count: usize) {
        if let State::Reading(reading) = &mut self.state {
            reading.supply(place, text, cells, count);
        }
    }

    /// The answer, which is there when [`Engine::advance_answer`] has returned 1.
    pub fn result(self) -> Result<JsValue, JsValue> {
        let (Some(answer), Some(known)) = (&self.answer, &self.known) else { return Ok(JsValue::UNDEFINED) };
        answers::written(answer, known)
    }
}
