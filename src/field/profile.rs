//! Composition as a function of the distance to one feature.

use super::expression::{Expression, smoothstep};
use crate::material::Composition;
use std::error::Error;
use std::fmt;

/// Share of the band over which a profile is led to the default where it does not meet it by itself.
const TAPER: f64 = 0.1;
/// How near two compositions are the same.
const SAME: f64 = 1e-9;
/// Most keys of a piecewise profile, and most waves of a periodic one.
const MOST_KEYS: usize = 1000;
/// Places at which an expression is looked at before it is taken.
const LOOKS: usize = 257;

/// Composition as a function of the distance to one feature, on the band of distances `from` to `to` (Liu and others 2003, 3.2.1, where `from` and `to` are
/// d_u and d_p): it runs from the composition `start` at `from` to the composition `end` at `to`. Nearer and farther it keeps
/// what it has at these limits.
#[derive(Debug, Clone, PartialEq)]
pub struct DistanceProfile {
    from: f64,
    to: f64,
    start: Composition,
    end: Composition,
    course: Course,
}

/// How a profile runs; t goes from 0 at `from` to 1 at `to`.
#[derive(Debug, Clone, PartialEq)]
pub enum Course {
    /// Share of `end`: t.
    Linear,
    /// Share of `end`: t to the power, above 0.
    Power(f64),
    /// Share of `end`: (1 - exp(-k t)) / (1 - exp(-k)); with k above 0 fast at first. Not 0, up to 100 either way.
    Exponential(f64),
    /// Share of `end`: 3 t^2 - 2 t^3.
    Smoothstep,
    /// Share of `end`: (1 - cos((2 n - 1) pi t)) / 2: n times at the end composition, the last time at the end of the band.
    Periodic(usize),
    /// Compositions at places t, linear between; before the first and after the last constant. `start` and `end` have no say.
    Piecewise(Vec<(f64, Composition)>),
    /// Share of `end`, limited to 0 to 1, by an expression in the distance d and in t.
    Expression(Expression),
}

/// Why there is no such profile.
#[derive(Debug, Clone, PartialEq)]
pub enum ProfileError {
    /// A limit is not a finite number of 0 or more.
    Limit {
        /// `from` or `to`.
        name: &'static str,
        /// The limit.
        value: f64,
    },
    /// `to` is not above `from`.
    Order {
        /// The lower limit.
        from: f64,
        /// The upper limit.
        to: f64,
    },
    /// Compositions have different numbers of materials.
    Materials {
        /// That of one of them.
        found: usize,
        /// That of `start`.
        expected: usize,
    },
    /// The number of a course is out of its range.
    Number {
        /// Which one.
        name: &'static str,
        /// The number.
        value: f64,
        /// What was expected.
        expected: &'static str,
    },
    /// Places of a piecewise course are outside 0 to 1 or do not ascend.
    Key {
        /// Position in the list, from 0.
        index: usize,
        /// The place.
        at: f64,
    },
    /// An expression has no value somewhere in the band.
    Undefined {
        /// The distance.
        distance: f64,
    },
}

impl fmt::Display for ProfileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Limit { name, value } => {
                write!(f, "{name} is {value}; expected a finite number of 0 or more")
            }
            Self::Order { from, to } => write!(f, "to is {to}; expected more than from, which is {from}"),
            Self::Materials { found, expected } => {
                write!(f, "{found} fractions were found; expected {expected}")
            }
            Self::Number { name, value, expected } => write!(f, "{name} is {value}; expected {expected}"),
            Self::Key { index, at } => {
                write!(f, "keys[{index}].at is {at}; expected 0 to 1, and more than the one before")
            }
            Self::Undefined { distance } => write!(f, "the expression has no value at d = {distance}"),
        }
    }
}

impl Error for ProfileError {}

impl DistanceProfile {
    /// # Errors
    /// When limits are negative, not finite or in the wrong order, numbers of materials differ, a number or key of the course is
    /// out of its range, or an expression has no value at one of 257 places of the band.
    pub fn new(
        [from, to]: [f64; 2],
        [start, end]: [Composition; 2],
        course: Course,
    ) -> Result<Self, ProfileError> {
        for (name, value) in [("from", from), ("to", to)] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(ProfileError::Limit { name, value });
            }
        }
        if to <= from {
            return Err(ProfileError::Order { from, to });
        }
        let profile = Self { from, to, start, end, course };
        profile.check()?;
        Ok(profile)
    }

    fn check(&self) -> Result<(), ProfileError> {
        let expected = self.start.fractions().len();
        let keys = if let Course::Piecewise(keys) = &self.course { keys.as_slice() } else { &[] };
        let mixes = keys.iter().map(|(_, mix)| mix).chain([&self.end]);
        if let Some(found) = mixes.map(|mix| mix.fractions().len()).find(|found| *found != expected) {
            return Err(ProfileError::Materials { found, expected });
        }
        let number = |name, value, expected| Err(ProfileError::Number { name, value, expected });
        match &self.course {
            Course::Power(power) if !(*power > 0.0 && *power <= 100.0) => {
                number("power", *power, "more than 0, and 100 at most")
            }
            Course::Exponential(rate) if !(rate.abs() <= 100.0 && rate.abs() > 1e-6) => {
                number("rate", *rate, "-100 to 100, and not 0")
            }
            Course::Periodic(waves) if !(1..=MOST_KEYS).contains(waves) => {
                number("waves", *waves as f64, "1 to 1000")
            }
            Course::Piecewise(keys) if !(1..=MOST_KEYS).contains(&keys.len()) => {
                number("keys", keys.len() as f64, "1 to 1000 of them")
            }
            Course::Piecewise(keys) => {
                let before = |index: usize| index.checked_sub(1).map_or(-1.0, |last| keys[last].0);
                let is_wrong = |(index, (at, _)): &(usize, &(f64, Composition))| {
                    !((0.0..=1.0).contains(at) && *at > before(*index))
                };
                let wrong = keys.iter().enumerate().find(is_wrong);
                wrong.map_or(Ok(()), |(index, (at, _))| Err(ProfileError::Key { index, at: *at }))
            }
            Course::Expression(expression) => {
                let place = |n: usize| n as f64 / (LOOKS - 1) as f64;
                let value = |t: f64| expression.value(&[self.from + t * self.width(), t]);
                let undefined = (0..LOOKS).map(place).find(|t| value(*t).is_nan());
                undefined.map_or(Ok(()), |t| {
                    Err(ProfileError::Undefined { distance: self.from + t * self.width() })
                })
            }
            _ => Ok(()),
        }
    }

    /// The nearer limit.
    #[must_use]
    pub fn from(&self) -> f64 {
        self.from
    }

    /// The farther limit.
    #[must_use]
    pub fn to(&self) -> f64 {
        self.to
    }

    /// From the nearer to the farther limit.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.to - self.from
    }

    /// Number of materials.
    #[must_use]
    pub fn materials(&self) -> usize {
        self.start.fractions().len()
    }

    /// Whether the band holds a distance.
    #[must_use]
    pub fn holds(&self, distance: f64) -> bool {
        (self.from..=self.to).contains(&distance)
    }

    /// Writes the fractions at a distance, which is taken as the nearest one of the band.
    ///
    /// # Panics
    /// When `fractions` does not have as many numbers as there are materials.
    pub fn fractions(&self, distance: f64, fractions: &mut [f64]) {
        if let Course::Piecewise(keys) = &self.course {
            let t = (distance.clamp(self.from, self.to) - self.from) / self.width();
            return piecewise(keys, t, fractions);
        }
        blend(self.start.fractions(), self.end.fractions(), self.share(distance), fractions);
    }

    /// Share of `end` at a distance; of a piecewise course, whose keys alone have a say, 0.
    fn share(&self, distance: f64) -> f64 {
        let distance = distance.clamp(self.from, self.to);
        let t = (distance - self.from) / self.width();
        let share = match &self.course {
            Course::Linear => t,
            Course::Power(power) => t.powf(*power),
            Course::Exponential(rate) => (-rate * t).exp_m1() / (-rate).exp_m1(),
            Course::Smoothstep => smoothstep(t),
            Course::Periodic(waves) => 0.5 - 0.5 * ((2 * waves - 1) as f64 * std::f64::consts::PI * t).cos(),
            Course::Expression(expression) => expression.value(&[distance, t]),
            Course::Piecewise(_) => 0.0,
        };
        // An expression may lack a value between the places at which it was looked at.
        if share.is_nan() { 1.0 } else { share.clamp(0.0, 1.0) }
    }

    /// Whether the profile has the default composition where it ends: at `to`, and at `from` unless that is 0. Then it is continuous with what lies beyond (the
    /// invariant of 3.2.1).
    #[must_use]
    pub fn meets(&self, default: &Composition) -> [bool; 2] {
        let mut fractions = vec![0.0; self.materials()];
        let mut is_met = |distance: f64| {
            self.fractions(distance, &mut fractions);
            fractions.iter().zip(default.fractions()).all(|(a, b)| (a - b).abs() <= SAME)
        };
        [self.from == 0.0 || is_met(self.from), is_met(self.to)]
    }

    /// Writes the fractions at a distance, led to the default over a tenth of the band at the limits at which the profile does not [meet](Self::meets) it.
    ///
    /// # Panics
    /// As [`fractions`](Self::fractions).
    pub fn tapered(&self, distance: f64, default: &Composition, meets: [bool; 2], fractions: &mut [f64]) {
        self.fractions(distance, fractions);
        self.lead(distance, default.fractions(), meets, fractions);
    }

    /// Share of the default in the fractions at a distance, by those mixes of the profile that are the default: 0 to 1.
    #[must_use]
    pub fn default_share(&self, distance: f64, default: &Composition) -> f64 {
        let t = (distance.clamp(self.from, self.to) - self.from) / self.width();
        let is_default = |mix: &Composition| {
            mix.fractions().iter().zip(default.fractions()).all(|(a, b)| (a - b).abs() <= SAME)
        };
        let of = |mix: &Composition| f64::from(u8::from(is_default(mix)));
        match (&self.course, self.share(distance)) {
            (Course::Piecewise(keys), _) => {
                let next = keys.partition_point(|(at, _)| *at <= t);
                let (low, high) = (&keys[next.saturating_sub(1)], &keys[next.min(keys.len() - 1)]);
                let share = if high.0 > low.0 { (t - low.0) / (high.0 - low.0) } else { 0.0 };
                of(&low.1) + share * (of(&high.1) - of(&low.1))
            }
            (_, share) => of(&self.start) + share * (of(&self.end) - of(&self.start)),
        }
    }

    /// Whether the profile consists of nothing but the default where it ends, as [`meets`](Self::meets) says it of fractions.
    #[must_use]
    pub fn ends_in_default(&self, default: &Composition) -> [bool; 2] {
        let is_met = |distance: f64| self.default_share(distance, default) >= 1.0 - SAME;
        [self.from == 0.0 || is_met(self.from), is_met(self.to)]
    }

    /// Writes the fractions at a distance where another composition stands in for the default: in the mixes that are the default, and at the limits
    /// where the profile does not [end in it](Self::ends_in_default), to which it is led over a tenth of the band.
    ///
    /// # Panics
    /// As [`fractions`](Self::fractions).
    pub fn over(
        &self,
        distance: f64,
        default: &Composition,
        ends: [bool; 2],
        base: &[f64],
        fractions: &mut [f64],
    ) {
        self.fractions(distance, fractions);
        let share = self.default_share(distance, default);
        if share > 0.0 {
            for ((fraction, default), base) in fractions.iter_mut().zip(default.fractions()).zip(base) {
                // What is taken away is there, but for rounding.
                *fraction = (*fraction - share * default).max(0.0) + share * base;
            }
        }
        self.lead(distance, base, ends, fractions);
    }

    /// Leads fractions to a composition over a tenth of the band at the limits that do not meet it.
    fn lead(&self, distance: f64, to: &[f64], meets: [bool; 2], fractions: &mut [f64]) {
        let to_limit = [(meets[0], distance - self.from), (meets[1], self.to - distance)];
        let offending = to_limit.into_iter().filter(|(is_met, _)| !is_met).map(|(_, length)| length);
        let nearest = offending.fold(f64::INFINITY, f64::min);
        if nearest.is_finite() {
            let share = smoothstep(nearest / (TAPER * self.width()));
            for (fraction, to) in fractions.iter_mut().zip(to) {
                *fraction = to + share * (*fraction - to);
            }
        }
    }
}

fn blend(start: &[f64], end: &[f64], share: f64, fractions: &mut [f64]) {
    for ((fraction, start), end) in fractions.iter_mut().zip(start).zip(end) {
        *fraction = start * (1.0 - share) + end * share;
    }
}

fn piecewise(keys: &[(f64, Composition)], t: f64, fractions: &mut [f64]) {
    let next = keys.partition_point(|(at, _)| *at <= t);
    let (Some((_, first)), Some((_, last))) =
        (keys.get(next.saturating_sub(1)), keys.get(next.min(keys.len() - 1)))
    else {
        return;
    };
    let share = match (next.checked_sub(1).map(|before| keys[before].0), keys.get(next)) {
        (Some(from), Some((to, _))) => (t - from) / (to - from),
        _ => 0.0,
    };
    blend(first.fractions(), last.fractions(), share, fractions);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair() -> [Composition; 2] {
        [Composition::pure(0, 2), Composition::pure(1, 2)]
    }

    /// The fraction of the second material.
    fn second(profile: &DistanceProfile, distance: f64) -> f64 {
        let mut fractions = [0.0; 2];
        profile.fractions(distance, &mut fractions);
        assert!(
            (fractions[0] + fractions[1] - 1.0).abs() < 1e-15 && fractions[0] >= 0.0 && fractions[1] >= 0.0
        );
        fractions[1]
    }

    #[test]
    fn courses_run_from_the_start_to_the_end_as_they_are_named() {
        let half = |mix: [f64; 2]| Composition::new(mix.to_vec()).unwrap();
        let keys = vec![(0.25, half([1.0, 0.0])), (0.75, half([0.0, 1.0]))];
        let expression = Expression::new("((d - 2) / 4) ^ 2", &["d", "t"]).unwrap();
        let rate = 2.0_f64;
        let expected: [(Course, f64); 7] = [
            (Course::Linear, 0.25),
            (Course::Power(2.0), 0.0625),
            (Course::Exponential(rate), (1.0 - (-rate / 4.0).exp()) / (1.0 - (-rate).exp())),
            (Course::Smoothstep, 3.0 / 16.0 - 2.0 / 64.0),
            (Course::Periodic(2), 0.5 - 0.5 * (0.75 * std::f64::consts::PI).cos()),
            (Course::Piecewise(keys), 0.0),
            (Course::Expression(expression), 0.0625),
        ];
        for (course, quarter) in expected {
            let profile = DistanceProfile::new([2.0, 6.0], pair(), course).unwrap();
            let shown = format!("{:?}", profile.course);
            assert!((second(&profile, 3.0) - quarter).abs() < 1e-14, "{shown}");
            assert!(
                second(&profile, 2.0).abs() < 1e-14 && (second(&profile, 6.0) - 1.0).abs() < 1e-14,
                "{shown}"
            );
            assert_eq!(second(&profile, 0.0), second(&profile, 2.0), "{shown}");
            assert_eq!(second(&profile, f64::INFINITY), second(&profile, 6.0), "{shown}");
        }
    }

    #[test]
    fn a_periodic_course_is_at_the_end_composition_as_often_as_it_says() {
        let profile = DistanceProfile::new([0.0, 5.0], pair(), Course::Periodic(3)).unwrap();
        let tops = (0..=5).filter(|n| (second(&profile, f64::from(*n)) - 1.0).abs() < 1e-12).count();
        assert_eq!(tops, 3);
    }

    #[test]
    fn a_shell_has_two_limits_to_meet_and_a_coating_one() {
        let [first, other] = pair();
        let profile = |from| DistanceProfile::new([from, 2.0], pair(), Course::Linear).unwrap();
        assert_eq!((profile(0.0).meets(&other), profile(1.0).meets(&other)), ([true, true], [false, true]));
        assert_eq!(profile(0.0).meets(&first), [true, false]);
    }

    #[test]
    fn a_profile_that_does_not_meet_the_default_is_led_to_it() {
        let default = Composition::pure(0, 2);
        let profile = DistanceProfile::new([0.0, 2.0], pair(), Course::Linear).unwrap();
        let meets = profile.meets(&default);
        let tapered = |distance: f64| {
            let mut fractions = [0.0; 2];
            profile.tapered(distance, &default, meets, &mut fractions);
            fractions[1]
        };
        assert_eq!((tapered(1.0), tapered(1.8), tapered(2.0)), (0.5, 0.9, 0.0));
        assert!((tapered(1.9) - 0.95 * 0.5).abs() < 1e-12);
    }

    #[test]
    fn wrong_profiles_are_refused_by_name() {
        let refused = |limits, course| DistanceProfile::new(limits, pair(), course).unwrap_err().to_string();
        assert_eq!(refused([-1.0, 2.0], Course::Linear), "from is -1; expected a finite number of 0 or more");
        assert_eq!(
            refused([0.0, f64::NAN], Course::Linear),
            "to is NaN; expected a finite number of 0 or more"
        );
        assert_eq!(refused([3.0, 2.0], Course::Linear), "to is 2; expected more than from, which is 3");
        assert_eq!(
            refused([0.0, 1.0], Course::Power(0.0)),
            "power is 0; expected more than 0, and 100 at most"
        );
        assert_eq!(
            refused([0.0, 1.0], Course::Exponential(0.0)),
            "rate is 0; expected -100 to 100, and not 0"
        );
        assert_eq!(refused([0.0, 1.0], Course::Periodic(0)), "waves is 0; expected 1 to 1000");
        let key = |at| (at, Composition::pure(0, 2));
        let keys = Course::Piecewise(vec![key(0.5), key(0.5)]);
        assert_eq!(
            refused([0.0, 1.0], keys),
            "keys[1].at is 0.5; expected 0 to 1, and more than the one before"
        );
        assert_eq!(refused([0.0, 1.0], Course::Piecewise(vec![])), "keys is 0; expected 1 to 1000 of them");
        let root = Expression::new("sqrt(d - 1)", &["d", "t"]).unwrap();
        assert_eq!(refused([0.0, 2.0], Course::Expression(root)), "the expression has no value at d = 0");
        let mixes = [Composition::pure(0, 2), Composition::pure(0, 3)];
        let error = DistanceProfile::new([0.0, 1.0], mixes, Course::Linear).unwrap_err();
        assert_eq!(error.to_string(), "3 fractions were found; expected 2");
    }
}
