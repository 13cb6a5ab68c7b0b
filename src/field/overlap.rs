//! Several profiles on one body.

use super::DistanceProfile;
use crate::material::Composition;

/// Shares of the size of the body below which a distance counts as none.
const NONE: f64 = 1e-9;

/// How profiles that overlap share.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rule {
    /// Weights by the inverse of distance that end at the limits (R. Franke and G. Nielson, "Smooth interpolation of large sets of scattered data", 1980, with
    /// the power 1): full strength on the own feature, whatever else is near. The order of the profiles has no say.
    #[default]
    Repaired,
    /// Weights by the depth within the band: Eq. 2 where the nearest boundary of a leaf is a limit of a profile. Long bands beat short ones, so that a thin
    /// coating under a deep gradient is lost.
    Depth,
}

/// Profiles on one body, with the composition that holds where none of them acts.
///
/// [`printed`](super::printed) carries out Eq. 2 literally, which needs a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlap {
    rule: Rule,
    size: f64,
    default: Composition,
    profiles: Vec<Entry>,
}

/// A profile, at which limits it meets the default, and at which it consists of nothing but it.
type Entry = (DistanceProfile, [bool; 2], [bool; 2]);

impl Overlap {
    /// Profiles in the order of their queue (3.2.2), at most 32; `size` is the diagonal of the body's box, above 0. Profiles that do not meet the default where they
    /// end are led to it over a tenth of their band.
    ///
    /// # Panics
    /// When there are more than 32 profiles, or one has another number of materials than the default.
    #[must_use]
    pub fn new(rule: Rule, size: f64, default: Composition, profiles: Vec<DistanceProfile>) -> Self {
        assert!(profiles.len() <= 32, "{} profiles", profiles.len());
        let materials = default.fractions().len();
        assert!(
            profiles.iter().all(|profile| profile.materials() == materials),
            "numbers of materials differ"
        );
        let profiles = profiles.into_iter().map(|profile| {
            let (meets, ends) = (profile.meets(&default), profile.ends_in_default(&default));
            (profile, meets, ends)
        });
        Self { rule, size, profiles: profiles.collect(), default }
    }

    /// The composition where none of the profiles acts.
    #[must_use]
    pub fn default_composition(&self) -> &Composition {
        &self.default
    }

    /// The profiles, in the order of their queue.
    pub fn profiles(&self) -> impl ExactSizeIterator<Item = &DistanceProfile> + DoubleEndedIterator {
        self.profiles.iter().map(|(profile, ..)| profile)
    }

    /// Writes the fractions of a point from its distances to the features of the profiles, and returns the leaf of the subdivision tree (Fig. 7) in which it lies: bit k
    /// says that the band of profile k holds it.
    ///
    /// # Panics
    /// When there are not as many distances as profiles, or not as many fractions as materials.
    pub fn fractions(&self, distances: &[f64], fractions: &mut [f64]) -> u32 {
        let tapered = |(profile, meets, _): &Entry, distance: f64, to: &mut [f64]| {
            profile.tapered(distance, &self.default, *meets, to);
        };
        self.compose(self.default.fractions(), &tapered, distances, fractions)
    }

    /// The same over a composition of the point that stands in for the default, in the mixes of the profiles as well.
    ///
    /// # Panics
    /// As [`fractions`](Self::fractions).
    pub fn over(&self, base: &[f64], distances: &[f64], fractions: &mut [f64]) -> u32 {
        let over = |(profile, _, ends): &Entry, distance: f64, to: &mut [f64]| {
            profile.over(distance, &self.default, *ends, base, to);
        };
        self.compose(base, &over, distances, fractions)
    }

    fn compose(
        &self,
        base: &[f64],
        of: &dyn Fn(&Entry, f64, &mut [f64]),
        distances: &[f64],
        fractions: &mut [f64],
    ) -> u32 {
        assert_eq!(distances.len(), self.profiles.len(), "one distance for each profile");
        let materials = base.len();
        let mut own = [0.0; 16];
        let mut long = Vec::new();
        let own = if materials <= own.len() {
            &mut own[..materials]
        } else {
            long.resize(materials, 0.0);
            long.as_mut_slice()
        };
        let holds = |(k, (profile, ..)): (usize, &Entry)| u32::from(profile.holds(distances[k])) << k;
        let leaf = self.profiles.iter().enumerate().map(holds).fold(0, |leaf, bit| leaf | bit);
        if leaf == 0 {
            fractions.copy_from_slice(base);
            return 0;
        }
        if leaf.is_power_of_two() {
            // One profile alone is its function: its weight cancels.
            let k = leaf.trailing_zeros() as usize;
            of(&self.profiles[k], distances[k], fractions);
            return leaf;
        }
        let mut sum = 0.0;
        fractions.fill(0.0);
        for (k, (entry, &distance)) in self.profiles.iter().zip(distances).enumerate() {
            if (leaf >> k) & 1 == 0 {
                continue;
            }
            let weight = self.weight(&entry.0, distance);
            if weight > 0.0 {
                of(entry, distance, own);
                fractions.iter_mut().zip(own.iter()).for_each(|(all, one)| *all += weight * one);
                sum += weight;
            }
        }
        if sum > 0.0 {
            fractions.iter_mut().for_each(|fraction| *fraction /= sum);
        } else {
            fractions.copy_from_slice(base);
        }
        leaf
    }

    /// What a profile weighs at a distance within its band. Only ratios count.
    fn weight(&self, profile: &DistanceProfile, distance: f64) -> f64 {
        let [inner, outer] = [distance - profile.from(), profile.to() - distance];
        let is_shell = profile.from() > 0.0;
        match self.rule {
            Rule::Repaired if is_shell => self.size / profile.width() * inner.min(outer) / inner.max(outer),
            Rule::Repaired => self.size / profile.width() * outer / inner.max(NONE * self.size),
            Rule::Depth if is_shell => inner.min(outer),
            Rule::Depth => outer,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Course;
    use super::*;

    /// A profile that runs from one material to the default, which is the last of three.
    fn profile(material: usize, from: f64, to: f64, course: Course) -> DistanceProfile {
        DistanceProfile::new([from, to], [Composition::pure(material, 3), Composition::pure(2, 3)], course)
            .unwrap()
    }

    /// Constant inside its band; the taper leads it to the default.
    fn constant(material: usize, to: f64) -> DistanceProfile {
        let mixes = [Composition::pure(material, 3), Composition::pure(material, 3)];
        DistanceProfile::new([0.0, to], mixes, Course::Linear).unwrap()
    }

    fn of(rule: Rule, profiles: Vec<DistanceProfile>) -> Overlap {
        Overlap::new(rule, 100.0, Composition::pure(2, 3), profiles)
    }

    fn mixed(overlap: &Overlap, distances: &[f64]) -> [f64; 3] {
        let mut fractions = [0.0; 3];
        overlap.fractions(distances, &mut fractions);
        assert!((fractions.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{fractions:?}");
        assert!(fractions.iter().all(|fraction| (0.0..=1.0 + 1e-15).contains(fraction)), "{fractions:?}");
        fractions
    }

    #[test]
    fn one_profile_alone_is_its_function_and_beyond_it_is_the_default() {
        let profile = profile(0, 0.0, 4.0, Course::Smoothstep);
        for rule in [Rule::Repaired, Rule::Depth] {
            let overlap = of(rule, vec![profile.clone()]);
            for n in 0..100 {
                let distance = f64::from(n) * 0.05;
                let mut expected = [0.0; 3];
                profile.fractions(distance, &mut expected);
                assert!(
                    mixed(&overlap, &[distance]).iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14)
                );
            }
            assert_eq!(mixed(&overlap, &[4.1]), [0.0, 0.0, 1.0]);
        }
    }

    /// The table of a coating of width 1 under a gradient of width 50 at distance 5, and of a rectangle with limits .3 at distance .1.
    #[test]
    fn a_coating_keeps_its_strength_by_the_repaired_rule_and_loses_it_by_depth() {
        let share = |rule, to: [f64; 2], other: f64, part: f64| {
            // Compositions that stay what they are inside: the weights show. No taper, which would lead them to the default.
            let overlap =
                Overlap::new(rule, 100.0, Composition::pure(2, 3), to.map(|_| constant(0, 1.0)).to_vec());
            let [a, b] = [0, 1].map(|k| constant(k, to[k]));
            let weights = [overlap.weight(&a, part * to[0]), overlap.weight(&b, other)];
            weights[0] / (weights[0] + weights[1])
        };
        let parts = [0.0, 0.05, 0.25, 0.5, 0.9];
        let rows = [
            (Rule::Repaired, [1.0, 50.0], 5.0, [1.0, 0.99, 0.94, 0.85, 0.38]),
            (Rule::Depth, [1.0, 50.0], 5.0, [0.02, 0.02, 0.02, 0.01, 0.002]),
            (Rule::Repaired, [0.3, 0.3], 0.1, [1.0, 0.90, 0.60, 0.33, 0.05]),
            (Rule::Depth, [0.3, 0.3], 0.1, [0.60, 0.59, 0.53, 0.43, 0.13]),
        ];
        for (rule, to, other, expected) in rows {
            for (part, expected) in parts.into_iter().zip(expected) {
                let found = share(rule, to, other, part);
                assert!(
                    (found - expected).abs() <= 0.0051,
                    "{rule:?} {to:?} at {part}: {found}, not {expected}"
                );
            }
        }
    }

    #[test]
    fn on_its_own_feature_a_profile_has_full_strength_and_features_that_meet_share_evenly() {
        let profiles = vec![profile(0, 0.0, 50.0, Course::Linear), profile(1, 0.0, 1.0, Course::Linear)];
        let overlap = of(Rule::Repaired, profiles);
        let on_first = mixed(&overlap, &[0.0, 0.1]);
        assert!((on_first[0] - 1.0).abs() < 1e-5, "{on_first:?}");
        let on_second = mixed(&overlap, &[5.0, 0.0]);
        assert!((on_second[1] - 1.0).abs() < 1e-6, "{on_second:?}");
        let both = mixed(&overlap, &[0.0, 0.0]);
        assert!((both[0] - 0.5).abs() < 1e-12 && (both[1] - 0.5).abs() < 1e-12, "{both:?}");
    }

    /// What stands in for the default is what there is where no profile acts, where bands end, and in mixes that are the default.
    #[test]
    fn over_another_composition_profiles_are_continuous_and_sum_to_one() {
        let base = [0.3, 0.2, 0.5];
        let keys = vec![(0.0, Composition::pure(1, 3)), (0.6, Composition::pure(2, 3))];
        let periodic = profile(0, 1.0, 4.0, Course::Periodic(3));
        let courses = [profile(0, 0.0, 4.0, Course::Smoothstep), constant(0, 4.0), periodic];
        let piecewise = profile(0, 0.0, 4.0, Course::Piecewise(keys));
        for profile in courses.into_iter().chain([piecewise]) {
            let overlap = of(Rule::Repaired, vec![profile]);
            let mut last = base;
            for n in (0..=5000).rev() {
                let mut found = [0.0; 3];
                overlap.over(&base, &[f64::from(n) * 1e-3], &mut found);
                assert!((found.iter().sum::<f64>() - 1.0).abs() < 1e-12 && found.iter().all(|f| *f >= 0.0));
                let step = found.iter().zip(last).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(step < 6e-3, "{n}: {last:?} to {found:?}");
                last = found;
            }
        }
        // Half way the profile is half of its own and half of what stands in.
        let overlap = of(Rule::Repaired, vec![profile(0, 0.0, 4.0, Course::Linear)]);
        let mut found = [0.0; 3];
        overlap.over(&base, &[2.0], &mut found);
        assert!(found.iter().zip([0.65, 0.1, 0.25]).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
        // Over the default itself nothing changes.
        let profiles = || vec![constant(0, 3.0), profile(1, 1.0, 4.0, Course::Linear)];
        let overlap = of(Rule::Depth, profiles());
        let mut same = [0.0; 3];
        for n in 0..50 {
            let distances = [f64::from(n) * 0.1, f64::from(n % 7)];
            overlap.over(&[0.0, 0.0, 1.0], &distances, &mut same);
            assert!(mixed(&overlap, &distances).iter().zip(same).all(|(a, b)| (a - b).abs() < 1e-14));
        }
    }

    #[test]
    fn neither_the_order_nor_the_unit_matters() {
        let profiles = [
            profile(0, 0.0, 3.0, Course::Linear),
            profile(1, 1.0, 2.0, Course::Smoothstep),
            profile(0, 0.0, 0.5, Course::Power(2.0)),
        ];
        for rule in [Rule::Repaired, Rule::Depth] {
            let forth = of(rule, profiles.to_vec());
            let back = of(rule, profiles.iter().rev().cloned().collect());
            let scaled = profiles.iter().map(|each| {
                let material = usize::from(each.from() > 0.0);
                profile(material, each.from() * 7.0, each.to() * 7.0, each_course(each))
            });
            let scaled = Overlap::new(rule, 700.0, Composition::pure(2, 3), scaled.collect());
            for (a, b, c) in [(0.2, 1.5, 0.1), (2.9, 1.01, 0.49), (0.0, 1.99, 0.3), (1.0, 5.0, 0.0)] {
                let found = mixed(&forth, &[a, b, c]);
                for other in [mixed(&back, &[c, b, a]), mixed(&scaled, &[7.0 * a, 7.0 * b, 7.0 * c])] {
                    assert!(found.iter().zip(other).all(|(x, y)| (x - y).abs() < 1e-12), "{rule:?}");
                }
            }
        }
    }

    fn each_course(profile: &DistanceProfile) -> Course {
        match (profile.from() > 0.0, profile.to() < 1.0) {
            (true, _) => Course::Smoothstep,
            (_, true) => Course::Power(2.0),
            _ => Course::Linear,
        }
    }

    /// A barrier of 1 to 2 inside a gradient of 0 to 50 of the same feature.
    #[test]
    fn a_shell_shares_in_the_middle_and_vanishes_at_its_limits() {
        let shell = profile(1, 1.0, 2.0, Course::Linear);
        let overlap = of(Rule::Repaired, vec![constant(0, 50.0), shell.clone()]);
        let gradient = constant(0, 50.0);
        let weights = [overlap.weight(&gradient, 1.5), overlap.weight(&shell, 1.5)];
        assert!((weights[1] / (weights[0] + weights[1]) - 0.61).abs() < 0.01);
        for limit in [1.0, 2.0] {
            assert!((mixed(&overlap, &[limit, limit])[0] - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_whole_profile_is_unchanged_beside_one_that_is_led_to_the_default() {
        let whole = profile(0, 0.0, 4.0, Course::Linear);
        let overlap = of(Rule::Repaired, vec![whole.clone(), constant(1, 1.0)]);
        let mut expected = [0.0; 3];
        whole.fractions(1.2, &mut expected);
        assert!(mixed(&overlap, &[1.2, 1.1]).iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15));
    }

    /// Over profiles and distances at random: what holds everywhere.
    #[test]
    fn any_profiles_share_convexly_in_any_order_and_are_whole_on_their_own_features() {
        let mut state = 362_436_069_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for round in 0..400 {
            let count = 2 + round % 4;
            let made: Vec<DistanceProfile> = (0..count)
                .map(|k| {
                    let from = if random() < 0.3 { 5.0 * random() } else { 0.0 };
                    let to = from + 0.5 + 30.0 * random();
                    if random() < 0.3 {
                        constant(k % 2, to)
                    } else {
                        profile(
                            k % 2,
                            from,
                            to,
                            [Course::Linear, Course::Smoothstep, Course::Power(0.5 + random())][k % 3]
                                .clone(),
                        )
                    }
                })
                .collect();
            let mut distances: Vec<f64> = (0..count).map(|_| 0.2 + 12.0 * random()).collect();
            let turned: Vec<DistanceProfile> = made.iter().rev().cloned().collect();
            for rule in [Rule::Repaired, Rule::Depth] {
                let found = mixed(&of(rule, made.clone()), &distances);
                let back: Vec<f64> = distances.iter().rev().copied().collect();
                let other = mixed(&of(rule, turned.clone()), &back);
                assert!(found.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-12), "{rule:?}, {round}");
            }
            let own = round % count;
            if made[own].from() == 0.0 {
                distances[own] = 0.0;
                let found = mixed(&of(Rule::Repaired, made.clone()), &distances);
                let mut expected = [0.0; 3];
                made[own].fractions(0.0, &mut expected);
                assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-5), "{round}: {found:?}");
            }
        }
    }

    #[test]
    fn the_leaf_names_the_bands_that_hold_the_point() {
        let overlap = of(
            Rule::Repaired,
            vec![profile(0, 0.0, 1.0, Course::Linear), profile(1, 0.0, 1.0, Course::Linear)],
        );
        let leaf = |distances: [f64; 2]| overlap.fractions(&distances, &mut [0.0; 3]);
        assert_eq!([leaf([2.0, 2.0]), leaf([0.5, 2.0]), leaf([2.0, 0.5]), leaf([0.5, 0.5])], [0, 1, 2, 3]);
    }
}
