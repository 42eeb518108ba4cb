//! The Pareto frontier: what no other candidate beats in both cost and error.

/// A cost and an error: less of either is better.
pub(super) type Point = [f64; 2];

/// The places of the points on the frontier, by their cost: those that no other
/// point equals in both and betters in one. Points that are alike are on it
/// together.
pub(super) fn frontier(points: &[Point]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&one, &other| by_cost(points[one], points[other]));
    let mut best: Option<Point> = None;
    order.retain(|&index| {
        let point = points[index];
        let stays = best.is_none_or(|best| point[1] < best[1] || point == best);
        if stays {
            best = Some(point);
        }
        stays
    });
    order
}

fn by_cost(one: Point, other: Point) -> std::cmp::Ordering {
    let by = |axis: usize| one[axis].total_cmp(&other[axis]);
    by(0).then(by(1))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn what_is_beaten_is_not_on_it() {
        let table: [(&[Point], &[usize]); 6] = [
            (&[], &[]),
            (&[[1.0, 1.0]], &[0]),
            // Dearer and worse; dearer and as good; as dear and worse.
            (&[[1.0, 1.0], [2.0, 2.0], [2.0, 1.0], [1.0, 2.0]], &[0]),
            // Each is best for its price.
            (&[[3.0, 0.0], [1.0, 9.0], [2.0, 5.0]], &[1, 2, 0]),
            // Alike.
            (&[[1.0, 0.0], [1.0, 0.0], [2.0, 0.0]], &[0, 1]),
            // Zero is the least error.
            (&[[5.0, 0.0], [4.0, 1e-300]], &[1, 0]),
        ];
        for (points, expected) in table {
            assert_eq!(frontier(points), expected, "{points:?}");
        }
    }

    fn is_beaten(point: Point, by: Point) -> bool {
        by[0] <= point[0] && by[1] <= point[1] && by != point
    }

    proptest! {
        /// By the definition, point against point, where many are alike in an axis.
        #[test]
        fn it_is_what_its_definition_says(
            whole in prop::collection::vec([0_u8..6, 0_u8..6], 0..20)
        ) {
            let points: Vec<_> = whole.iter().map(|point| point.map(f64::from)).collect();
            let mut found = frontier(&points);
            let costs: Vec<_> = found.iter().map(|&index| points[index][0]).collect();
            prop_assert!(costs.is_sorted());
            found.sort_unstable();
            let stays = |&index: &usize| !points.iter().any(|&by| is_beaten(points[index], by));
            let expected: Vec<_> = (0..points.len()).filter(stays).collect();
            prop_assert_eq!(found, expected);
        }
    }
}
