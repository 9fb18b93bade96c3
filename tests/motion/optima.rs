//! Planned corners beside the shortest times that there are along the same curves.

use g41::contour::{Move, MoveCurve};
use g41::geometry::{Arc, Line};
use g41::motion::{CornerCurve, Limits, plan, track};
use glam::{DVec2, DVec3, dvec2};

use crate::optimum::{Law, Machine, Path};
use crate::shapes;

/// Finer samples, to begin with what was planned [s].
const FINE: f64 = 1.0e-4;

struct Case {
    name: String,
    moves: Vec<Move>,
    limits: Limits,
}

/// Lines of these lengths [mm], with turns [°] between them.
fn turning(turns: &[f64], lengths: &[f64]) -> Vec<Move> {
    let (mut at, mut angle) = (DVec3::ZERO, 0.0_f64);
    let mut points = vec![at];
    for (k, length) in lengths.iter().enumerate() {
        at += (DVec2::from_angle(angle.to_radians()) * *length).extend(0.0);
        points.push(at);
        angle += turns.get(k).unwrap_or(&0.0);
    }
    shapes::polyline(&points)
}

/// A line of 5 mm, a quarter of a circle of 4 mm, a line of 5 mm.
fn around_an_arc() -> Vec<Move> {
    let arc = Arc::from_sweep(dvec2(5.0, 0.0), dvec2(5.0, 4.0), std::f64::consts::FRAC_PI_2);
    let curves = [
        MoveCurve::Line(Line::new(dvec2(0.0, 0.0), dvec2(5.0, 0.0)).expect("a length")),
        MoveCurve::Arc(arc.expect("an arc")),
        MoveCurve::Line(Line::new(dvec2(9.0, 4.0), dvec2(9.0, 9.0)).expect("a length")),
    ];
    curves.map(shapes::along).to_vec()
}

fn cases() -> Vec<Case> {
    let slow = Limits { fit: false, ..Limits::default() };
    let fast = Limits {
        velocity: 500.0,
        acceleration: 5000.0,
        jerk: 5.0e5,
        corner_deviation: 0.02,
        ..slow
    };
    let even = |limits| Limits { corner: CornerCurve::Ph13, ..limits };
    let corners: [(&str, Limits, &[f64], &[f64]); 11] = [
        ("slow, eased", slow, &[10.0], &[5.0, 5.0]),
        ("fast, eased", fast, &[30.0], &[2.5, 2.5]),
        ("slow, degree 13", even(slow), &[45.0], &[2.5, 2.5]),
        ("fast, degree 13", even(fast), &[60.0], &[5.0, 5.0]),
        ("slow, eased", slow, &[90.0], &[2.5, 2.5]),
        ("slow, degree 13", even(slow), &[90.0], &[10.0, 10.0]),
        ("fast, eased", fast, &[120.0], &[4.0, 4.0]),
        ("slow, eased", slow, &[150.0], &[6.0, 6.0]),
        ("fast, eased", fast, &[170.0], &[5.0, 5.0]),
        ("slow, eased", slow, &[90.0, 90.0], &[5.0, 3.0, 5.0]),
        ("fast, eased", fast, &[60.0, -60.0], &[5.0, 2.0, 5.0]),
    ];
    let mut cases = Vec::new();
    for (what, limits, turns, lengths) in corners {
        let name = format!("{turns:?}° between {lengths:?} mm, {what}");
        cases.push(Case { name, moves: turning(turns, lengths), limits });
    }
    cases.push(Case { name: "around an arc".into(), moves: around_an_arc(), limits: slow });
    cases
}

impl Case {
    /// The duration that is planned [s].
    fn planned(&self, limits: &Limits) -> f64 {
        plan(&self.moves, limits).expect("limits").duration
    }

    /// With jerk that may step, or nearly.
    fn free(&self) -> Limits {
        Limits { snap: Some(20.0 * self.limits.jerk / self.limits.period), ..self.limits }
    }

    fn path(&self) -> Path {
        Path::new(track(&self.moves, &self.limits))
    }

    fn machine(&self) -> Machine {
        let Limits { velocity, acceleration, jerk, .. } = self.limits;
        Machine { velocity, acceleration, jerk, snap: None }
    }

    /// A law as planned, to begin with.
    fn begun(&self, path: &Path, machine: &Machine, intervals: usize) -> Law {
        let snap = Some(self.limits.snap());
        let motion = plan(&self.moves, &Limits { period: FINE, snap, ..self.limits });
        Law::through(&path.ways(&motion.expect("limits")), FINE, machine, intervals)
    }

    /// The optimum of third order, from two beginnings.
    fn third(&self, intervals: usize) -> [Law; 2] {
        let (path, machine) = (self.path(), self.machine());
        [Law::gentle(&path, &machine, intervals), self.begun(&path, &machine, intervals)]
            .map(|law| law.shortest(&path, &machine, 1e-4))
    }

    /// An optimum of fourth order: from what is planned, and from the optimum of third order by
    /// bounds of the change of jerk that fall by the `factor`.
    fn fourth(&self, intervals: usize, factor: f64) -> [Law; 2] {
        let path = self.path();
        let snap = self.limits.snap();
        let mut machine = Machine { snap: Some(snap), ..self.machine() };
        let planned = self.begun(&path, &machine, intervals).shortest(&path, &machine, 1e-4);
        let [third, _] = self.third(intervals);
        let mut law = third.smoothed();
        let mut wide = 64.0;
        while wide > 1.0 {
            wide = (wide * factor).max(1.0);
            machine.snap = Some(snap * wide);
            law = law.shortest(&path, &machine, if wide > 1.0 { 1e-2 } else { 1e-4 });
        }
        [planned, law]
    }
}

fn shorter([one, other]: &[Law; 2]) -> &Law {
    if one.duration() < other.duration() { one } else { other }
}

#[test]
fn the_optimum_along_a_line_is_the_closed_form() {
    let moves = shapes::polyline(&[DVec3::ZERO, DVec3::X * 100.0]);
    let case = Case { name: "line".into(), moves, limits: Limits::default() };
    let Machine { velocity, acceleration, jerk, .. } = case.machine();
    // The jerk takes A/J to bring the acceleration, and J/S to come itself.
    let third = 100.0 / velocity + velocity / acceleration + acceleration / jerk;
    for law in case.third(400) {
        let found = law.duration();
        assert!((found / third - 1.0).abs() < 2e-4, "{found} s, {third} in closed form");
    }
    let fourth = third + jerk / case.limits.snap();
    for law in case.fourth(400, 0.5) {
        let found = law.duration();
        assert!((found / fourth - 1.0).abs() < 2e-4, "{found} s, {fourth} in closed form");
    }
}

#[test]
fn corners_are_within_a_twentieth_of_the_optimum_of_third_order_where_jerk_may_step() {
    for case in cases() {
        let (path, machine) = (case.path(), case.machine());
        let optimum = case.begun(&path, &machine, 400).shortest(&path, &machine, 1e-4).duration();
        let free = case.planned(&case.free());
        assert!(free < 1.05 * optimum, "{}: {free} s for {optimum} s", case.name);
        assert!(free > 0.998 * optimum, "{}: {free} s, and {optimum} s at best", case.name);
    }
}

#[test]
#[ignore = "takes minutes: cargo test --test motion optima -- --ignored --nocapture"]
fn corners_beside_optima_of_both_orders() {
    let mut slow = Vec::new();
    for case in cases() {
        let path = case.path();
        let machine = Machine { snap: Some(case.limits.snap()), ..case.machine() };
        let planned = [case.planned(&case.free()), case.planned(&case.limits)];
        println!("{}", case.name);
        for (order, planned) in [3, 4].into_iter().zip(planned) {
            let mut best = f64::INFINITY;
            print!("  order {order}:");
            for intervals in [100, 200, 400] {
                let laws =
                    if order == 3 { case.third(intervals) } else { case.fourth(intervals, 0.8) };
                let machine = if order == 3 { case.machine() } else { machine };
                let law = shorter(&laws);
                // What is broken between the places of the grid, as a factor on time.
                let excess = law.excess(&path, &machine, 21);
                best = best.min(law.duration() * excess);
                print!(" {:.2} (× {excess:.3})", 1e3 * law.duration());
            }
            let (share, planned) = (100.0 * (planned / best - 1.0), 1e3 * planned);
            println!(" ms; planned {planned:.2}, {share:+.1} %");
            if share >= 5.0 {
                slow.push(format!("{}, order {order}: {share:.1} %", case.name));
            }
        }
    }
    assert!(slow.is_empty(), "a twentieth or more over the optimum: {slow:#?}");
}
