//! Removal of redundant lines.

use super::RulingLine;

/// Returns the lines without the redundant ones, in the order given.
///
/// `growth` holds lines from the best to the worst, among outlines of `a` and `b` vertices. A line is redundant when both
/// its ends have two lines or more (Figs. 4 and 5 of the paper). The lowest redundant line goes first; as degrees only
/// fall, one pass from the worst line to the best finds them all. The paper's loop as printed removes the lowest line of
/// all, which can strand a vertex; this one never does.
#[must_use]
pub fn prune(growth: &[RulingLine], a: usize, b: usize) -> Vec<RulingLine> {
    let mut degrees = [vec![0_u32; a], vec![0_u32; b]];
    for line in growth {
        degrees[0][line.from] += 1;
        degrees[1][line.to] += 1;
    }
    let mut kept: Vec<RulingLine> = growth
        .iter()
        .rev()
        .filter(|line| {
            let redundant = degrees[0][line.from] >= 2 && degrees[1][line.to] >= 2;
            if redundant {
                degrees[0][line.from] -= 1;
                degrees[1][line.to] -= 1;
            }
            !redundant
        })
        .copied()
        .collect();
    kept.reverse();
    kept
}

/// Returns the lines that the loop printed in the paper leaves, in the order given: while any line is redundant it drops the lowest of
/// all, redundant or not.
#[must_use]
pub fn prune_as_printed(growth: &[RulingLine], a: usize, b: usize) -> Vec<RulingLine> {
    let mut degrees = [vec![0_u32; a], vec![0_u32; b]];
    for line in growth {
        degrees[0][line.from] += 1;
        degrees[1][line.to] += 1;
    }
    let mut kept = growth.to_vec();
    let is_redundant =
        |line: &RulingLine, degrees: &[Vec<u32>; 2]| degrees[0][line.from] >= 2 && degrees[1][line.to] >= 2;
    while kept.iter().any(|line| is_redundant(line, &degrees)) {
        let Some(line) = kept.pop() else { break };
        degrees[0][line.from] -= 1;
        degrees[1][line.to] -= 1;
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(from: usize, to: usize) -> RulingLine {
        RulingLine { from, to, lifted: to as i64, value: 1.0 }
    }

    #[test]
    fn the_worst_redundant_line_goes_first() {
        // A path 0-0, 0-1, 1-1: only the middle line is redundant.
        let growth = [line(0, 0), line(0, 1), line(1, 1)];
        assert_eq!(prune(&growth, 2, 2), [line(0, 0), line(1, 1)]);
        // A path of four lines from the best to the worst: the worse one of the two inner lines goes, the other stays.
        let growth = [line(0, 0), line(1, 1), line(1, 0), line(2, 1)];
        assert_eq!(prune(&growth, 3, 2), [line(0, 0), line(1, 1), line(2, 1)]);
    }

    #[test]
    fn the_printed_loop_strands_a_vertex() {
        // The lowest line is the only one of vertex 2; the redundant line stands above it.
        let growth = [line(0, 0), line(0, 1), line(1, 1), line(2, 2)];
        assert_eq!(prune(&growth, 3, 3), [line(0, 0), line(1, 1), line(2, 2)]);
        assert_eq!(prune_as_printed(&growth, 3, 3), [line(0, 0), line(0, 1)]);
    }

    #[test]
    fn a_star_keeps_all_its_lines() {
        let growth = [line(0, 0), line(0, 1), line(0, 2)];
        assert_eq!(prune(&growth, 1, 3), growth);
    }
}
