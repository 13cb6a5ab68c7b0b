//! From a document to its boundary, in steps.

use super::boundary::{BoundaryProblem, SetRow, SharedCondition};
use super::condition::{Chosen, Known};
use super::diagnostic::BoundaryDiagnostic;
use super::exact::Exact;
use super::model::Surface;
use super::schema::{GroupSpec, LaplaceDocument};
use crate::laplace::{
    Conditions, LaplaceError, LaplaceOptions, MOST_DENSE, MOST_LU, Mesh, Method, Panel, Preconditioner,
    Problem, enclosed,
};
use glam::DVec3;
use std::collections::HashMap;

/// Elements that are looked at between two looks at the clock.
const TURN: usize = 128;

/// How far fractions may be from the sum 1 and from their range, and fluxes from the sum 0 over the largest of them.
const SUM: f64 = 1e-6;

/// A boundary being made.
#[derive(Debug)]
pub struct BoundaryJob {
    boundary: BoundaryProblem,
    mesh: Result<Mesh, LaplaceError>,
    panels: Vec<Panel>,
    sets: Vec<Set>,
    /// Numbers that a set has given to a condition.
    shared: HashMap<(usize, Vec<u64>), u32>,
    /// Elements looked at.
    done: usize,
    is_checked: bool,
    missing: Tally,
}

/// A set of elements while it is gathered.
#[derive(Debug)]
struct Set {
    path: String,
    /// `None` for the rest, and where its expression cannot be read.
    chosen: Option<Chosen>,
    /// `None` where an expression cannot be read.
    known: Option<Known>,
    is_rest: bool,
    /// Elements of a later set that have another condition here.
    conflicts: HashMap<usize, Tally>,
    range: Tally,
    sum: Tally,
}

/// How many elements, the first of them, and what was found there.
#[derive(Debug, Clone, Copy, Default)]
struct Tally {
    count: usize,
    first: usize,
    found: f64,
}

impl Tally {
    fn add(&mut self, element: usize, found: f64) {
        if self.count == 0 {
            (self.first, self.found) = (element, found);
        }
        self.count += 1;
    }
}

impl BoundaryJob {
    /// Makes the elements; their conditions are found in steps.
    #[must_use]
    pub fn new(document: LaplaceDocument) -> Self {
        let Surface { space, vertices, elements, mesh } = Surface::new(&document.model);
        let panel = |corners: &[u32; 3]| space.panel(corners.map(|vertex| vertices[vertex as usize]));
        let panels: Vec<Panel> = elements.iter().map(panel).collect();
        let mut diagnostics = Vec::new();
        let mut sets: Vec<Set> = Vec::new();
        for (number, GroupSpec { selection, condition, .. }) in document.groups.iter().enumerate() {
            let path = format!("groups[{number}]");
            let chosen = Chosen::new(selection, &format!("{path}.where"));
            let known = Known::new(condition, &format!("{path}.condition"));
            sets.push(Set::new(path, chosen, known, false, &mut diagnostics));
        }
        if let Some(rest) = &document.rest {
            let nothing = Chosen::new(&super::Selection::default(), "rest");
            sets.push(Set::new("rest".to_owned(), nothing, Known::new(rest, "rest"), true, &mut diagnostics));
        }
        let rest = document.rest.as_ref().map(|spec| ("rest", spec));
        let named = document.groups.iter().map(|group| (group.name.as_str(), &group.condition)).chain(rest);
        let rows = named
            .map(|(name, spec)| SetRow {
                name: name.to_owned(),
                is_value: spec.is_value,
                count: 0,
                measure: 0.0,
            })
            .collect();
        let mut boundary = BoundaryProblem {
            space,
            vertices,
            groups: Vec::with_capacity(elements.len()),
            members: Vec::with_capacity(elements.len()),
            conditions: Vec::new(),
            sets: rows,
            exact: None,
            diagnostics,
            elements,
            document,
        };
        // Sets with the same numbers everywhere have a condition each, in their order.
        let mut shared = HashMap::new();
        for (number, set) in sets.iter().enumerate() {
            if let Some(known) = set.known.as_ref().filter(|known| known.is_constant()) {
                let data: Vec<f64> = known.at(DVec3::ZERO).collect();
                shared.insert((number, bits(&data)), boundary.conditions.len() as u32);
                boundary.conditions.push(SharedCondition {
                    set: number,
                    is_value: known.is_value,
                    data,
                    measure: 0.0,
                });
            }
        }
        Self { boundary, mesh, panels, sets, shared, done: 0, is_checked: false, missing: Tally::default() }
    }

    /// Goes on while it may; `true` once everything is found.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        while self.done < self.panels.len() {
            let end = (self.done + TURN).min(self.panels.len());
            for element in self.done..end {
                self.assign(element);
            }
            self.done = end;
            if !may_go_on() {
                return false;
            }
        }
        if !self.is_checked {
            self.check();
            self.is_checked = true;
            if !may_go_on() {
                return false;
            }
        }
        if self.boundary.is_ready() {
            self.boundary.exact = Exact::of(&self.boundary, &self.panels, |element, point| {
                let set = self.boundary.members[element] as usize;
                self.sets[set].known.as_ref().map(|known| known.at(point).collect())
            });
        }
        true
    }

    /// Share of the elements that were looked at, below 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        0.9 * self.done as f64 / self.panels.len().max(1) as f64
    }

    /// The boundary, once [`step`](Self::step) has returned `true`.
    #[must_use]
    pub fn boundary(self) -> BoundaryProblem {
        self.boundary
    }

    /// The boundary at once.
    #[must_use]
    pub fn run(mut self) -> BoundaryProblem {
        self.step(&mut || true);
        self.boundary
    }

    fn assign(&mut self, element: usize) {
        let panel = &self.panels[element];
        let in_group = |set: &Set| set.chosen.as_ref().is_some_and(|chosen| chosen.holds(element, panel));
        let groups = self.sets.iter().take_while(|set| !set.is_rest);
        let mut holding: Vec<usize> =
            groups.enumerate().filter(|(_, set)| in_group(set)).map(|(number, _)| number).collect();
        if holding.is_empty() {
            holding.extend(self.sets.iter().position(|set| set.is_rest));
        }
        let Some((&first, others)) = holding.split_first() else {
            // A group whose selection cannot be read may have had it.
            if self.sets.iter().all(|set| set.chosen.is_some()) {
                self.missing.add(element, 0.0);
            }
            self.boundary.groups.push(u32::MAX);
            self.boundary.members.push(self.sets.len() as u32);
            return;
        };
        let data = |set: &Set| {
            set.known.as_ref().map(|known| (known.is_value, known.at(panel.centre).collect::<Vec<f64>>()))
        };
        let own = data(&self.sets[first]);
        let differs = |other: &usize| {
            let other = data(&self.sets[*other]);
            own.as_ref().zip(other.as_ref()).is_some_and(|(own, other)| own != other)
        };
        let conflicting = others.iter().copied().find(differs);
        let set = &mut self.sets[first];
        if let Some(other) = conflicting {
            set.conflicts.entry(other).or_default().add(element, 0.0);
        }
        let row = &mut self.boundary.sets[first];
        row.count += 1;
        row.measure += panel.size;
        self.boundary.members.push(first as u32);
        let Some((is_value, data)) = own else {
            self.boundary.groups.push(u32::MAX);
            return;
        };
        set.check(element, is_value, &data);
        let conditions = &mut self.boundary.conditions;
        let number = *self.shared.entry((first, bits(&data))).or_insert_with(|| {
            conditions.push(SharedCondition { set: first, is_value, data, measure: 0.0 });
            conditions.len() as u32 - 1
        });
        conditions[number as usize].measure += panel.size;
        self.boundary.groups.push(number);
    }

    fn check(&mut self) {
        let none = self.boundary.conditions.len() as u32;
        self.boundary.groups.iter_mut().filter(|group| **group == u32::MAX).for_each(|group| *group = none);
        self.say_of_sets();
        if self.missing.count > 0 {
            let Tally { count, first, .. } = self.missing;
            let message = format!(
                "{count} elements are in no group, and there is no `rest`; expected a condition for each"
            );
            let missing = BoundaryDiagnostic::new("missing", "rest", message);
            self.boundary.diagnostics.push(missing.about(count, first, self.panels[first].centre));
        }
        let is_given = self.boundary.is_ready();
        let mesh = match &self.mesh {
            Ok(mesh) => mesh,
            Err(error) => {
                self.boundary.diagnostics.push(BoundaryDiagnostic::of(error.clone()));
                return;
            }
        };
        if !is_given {
            if let Err(error) = enclosed(mesh) {
                self.boundary.diagnostics.push(BoundaryDiagnostic::of(error));
            }
            return;
        }
        match Problem::new(mesh.clone(), self.conditions()) {
            Err(error) => self.boundary.diagnostics.push(BoundaryDiagnostic::of(error)),
            Ok(_) => {
                let options = self.boundary.document.options;
                self.boundary.diagnostics.extend(method(self.panels.len(), options));
            }
        }
    }

    /// The conditions as the solver takes them, when each element has one.
    fn conditions(&self) -> Conditions {
        let of = |group: &u32| &self.boundary.conditions[*group as usize];
        let groups = &self.boundary.groups;
        let materials = self.boundary.document.materials.len();
        Conditions {
            is_value: groups.iter().map(|group| of(group).is_value).collect(),
            data: (0..materials).map(|k| groups.iter().map(|group| of(group).data[k]).collect()).collect(),
            are_fractions: true,
        }
    }

    fn say_of_sets(&mut self) {
        let BoundaryProblem { diagnostics, sets: rows, elements, document, .. } = &mut self.boundary;
        let place = |element: usize| self.panels[element].centre;
        for (number, set) in self.sets.iter().enumerate() {
            let at =
                |field: &str| if set.is_rest { "rest".to_owned() } else { format!("{}{field}", set.path) };
            let mut others: Vec<_> = set.conflicts.iter().collect();
            others.sort_unstable_by_key(|(other, _)| **other);
            for (other, Tally { count, first, .. }) in others {
                let [a, b] = [number, *other].map(|set| &rows[set].name);
                let message = format!(
                    "{count} elements are in \"{a}\" and in \"{b}\", whose conditions differ; expected one condition for each"
                );
                let conflict = BoundaryDiagnostic::new("conflict", format!("groups[{other}].where"), message);
                diagnostics.push(conflict.about(*count, *first, place(*first)));
            }
            let of_values = [
                ("value", set.range, "a fraction from 0 to 1", "a finite number"),
                ("sum", set.sum, "the sum 1", "the sum 0"),
            ];
            for (code, Tally { count, first, found }, value, flux) in of_values {
                if count == 0 {
                    continue;
                }
                let expected = if rows[number].is_value { value } else { flux };
                let message = format!(
                    "{found} was found on element {first}, and the like on {count} in all; expected {expected}"
                );
                let fault = BoundaryDiagnostic::new(code, at(".condition"), message);
                diagnostics.push(fault.about(count, first, place(first)));
            }
            if rows[number].count == 0 && !set.is_rest && set.chosen.is_some() {
                let message = "no element is in this group, or all of them are in groups before it";
                diagnostics.push(BoundaryDiagnostic::new("empty", at(".where"), message).remark());
            }
        }
        for (number, group) in document.groups.iter().enumerate() {
            let last = group.selection.elements.iter().flatten().map(|[_, last]| *last).max();
            if let Some(last) = last.filter(|last| *last >= elements.len()) {
                let message = format!(
                    "{last} was found as the last element; the boundary has those up to {}",
                    elements.len() - 1
                );
                let path = format!("groups[{number}].where.elements");
                diagnostics.push(BoundaryDiagnostic::new("elements", path, message).remark());
            }
        }
    }
}

impl Set {
    fn new(
        path: String,
        chosen: Result<Chosen, BoundaryDiagnostic>,
        known: Result<Known, BoundaryDiagnostic>,
        is_rest: bool,
        diagnostics: &mut Vec<BoundaryDiagnostic>,
    ) -> Self {
        // Both are looked at, so that all that is wrong with a group is said at once.
        let chosen = chosen.map_err(|fault| diagnostics.push(fault)).ok();
        let known = known.map_err(|fault| diagnostics.push(fault)).ok();
        let [range, sum] = [Tally::default(); 2];
        Self { path, chosen, known, is_rest, conflicts: HashMap::new(), range, sum }
    }

    /// Whether the numbers are fractions, or fluxes of fractions.
    fn check(&mut self, element: usize, is_value: bool, data: &[f64]) {
        let is_fine = |x: &f64| if is_value { (-SUM..=1.0 + SUM).contains(x) } else { x.is_finite() };
        if let Some(wrong) = data.iter().find(|x| !is_fine(x)) {
            self.range.add(element, *wrong);
            return;
        }
        let sum: f64 = data.iter().sum();
        let largest = data.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let [expected, scale] = if is_value { [1.0, 1.0] } else { [0.0, largest] };
        if (sum - expected).abs() > SUM * scale {
            self.sum.add(element, sum);
        }
    }
}

/// Why the method cannot be used for so many elements.
fn method(count: usize, options: LaplaceOptions) -> Option<BoundaryDiagnostic> {
    let most = options.most_dense.min(MOST_DENSE);
    let (what, most) = match options.method {
        Method::Lu => ("the method `lu`", most.min(MOST_LU)),
        Method::Gmres(_) if options.with_condition => ("the condition number", most.min(MOST_LU)),
        Method::Gmres(gmres) if matches!(gmres.preconditioner, Preconditioner::Ssor(_)) => {
            ("the preconditioner `ssor`", most)
        }
        Method::Gmres(_) => return None,
    };
    let message = format!("{what} was asked for with {count} elements; expected {most} at most");
    (count > most).then(|| BoundaryDiagnostic::new("method", "solver", message))
}

/// Numbers as a key.
fn bits(data: &[f64]) -> Vec<u64> {
    // Adding 0 makes one of the two zeros.
    data.iter().map(|x| (x + 0.0).to_bits()).collect()
}
