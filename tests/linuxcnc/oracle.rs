//! Random programs against the rules of `LinuxCNC`, each stated for itself.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::fmt::Write as _;

use g41::contour::{Move, MoveCurve, Role};
use glam::DVec2;

use super::common::random::Random;
use super::run::{errors, run};

const CASES: u32 = if cfg!(target_arch = "wasm32") { 500 } else { 5_000 };

/// What the control takes for no corner [rad].
const BAND: f64 = 0.05;

/// A programmed line, or an arc about a centre.
struct Element {
    from: DVec2,
    to: DVec2,
    center: Option<DVec2>,
    clockwise: bool,
}

impl Element {
    /// Unit tangent at a point of it.
    fn tangent(&self, at: DVec2) -> DVec2 {
        match self.center {
            None => (self.to - self.from).normalize(),
            Some(center) if self.clockwise => -(at - center).perp().normalize(),
            Some(center) => (at - center).perp().normalize(),
        }
    }

    /// How far a point is to the left of the whole line or circle [mm].
    fn left(&self, point: DVec2) -> f64 {
        match self.center {
            None => self.tangent(self.from).perp_dot(point - self.from),
            Some(center) => {
                let inwards = center.distance(self.to) - center.distance(point);
                if self.clockwise { -inwards } else { inwards }
            }
        }
    }
}

struct Case {
    text: String,
    start: DVec2,
    elements: Vec<Element>,
    exit: DVec2,
    /// σ r [mm].
    offset: f64,
}

fn case(random: &mut Random) -> Case {
    let diameter = [0.5, 1.0, 2.0, 3.0][random.index(4)];
    let left = random.coin();
    let start = random.point(5.0);
    let mut text = format!("G21 G90 G0 X{} Y{} F100\n", start.x, start.y);
    // A negative diameter swaps the side.
    let sign = random.sign();
    let word = if left == (sign > 0.0) { 41 } else { 42 };
    let _ = writeln!(text, "G{word}.1 D{}", sign * diameter);
    let (mut at, mut angle) = (start, random.within(-3.0, 3.0));
    let mut elements = Vec::new();
    for _ in 0..2 + random.index(5) {
        angle += match random.index(4) {
            0 => 0.0,
            1 => random.within(-0.1, 0.1),
            _ => random.within(-2.5, 2.5),
        };
        let along = DVec2::from_angle(angle);
        let straight = elements.is_empty() || random.coin();
        let (to, center, clockwise) = if straight {
            (at + along * random.within(2.0, 9.0), None, false)
        } else {
            let clockwise = random.coin();
            let side = if clockwise { -1.0 } else { 1.0 };
            let center = at + along.perp() * (side * random.within(1.0, 6.0));
            let sweep = side * random.within(0.3, 4.0);
            angle += sweep;
            (center + DVec2::from_angle(sweep).rotate(at - center), Some(center), clockwise)
        };
        let _ = match center {
            None => writeln!(text, "G1 X{} Y{}", to.x, to.y),
            Some(center) => {
                let (word, from) = (if clockwise { 2 } else { 3 }, center - at);
                writeln!(text, "G{word} X{} Y{} I{} J{}", to.x, to.y, from.x, from.y)
            }
        };
        elements.push(Element { from: at, to, center, clockwise });
        at = to;
    }
    let exit = at + random.point(9.0);
    let _ = write!(text, "G40 G1 X{} Y{}\nM2\n", exit.x, exit.y);
    let offset = 0.5 * diameter * if left { 1.0 } else { -1.0 };
    Case { text, start, elements, exit, offset }
}

/// Where the tool is beside the start (0) or the end (1) of an element.
fn beside(case: &Case, element: &Element, end: usize) -> DVec2 {
    let at = [element.from, element.to][end];
    at + element.tangent(at).perp() * case.offset
}

#[test]
fn every_move_keeps_the_rules() {
    let mut random = Random::new(41);
    let (mut finished, mut kinds) = (0, [0_u32; 3]);
    for number in 0..CASES {
        let case = case(&mut random);
        let path = run(&case.text, &[]);
        if !errors(&path).is_empty() {
            continue;
        }
        finished += 1;
        let what = |rule: &str| format!("case {number}: {rule}\n{}{:#?}", case.text, path.moves);
        let mut moves = path.moves.iter().skip(1).peekable();
        let mut at = case.start;
        for (i, element) in case.elements.iter().enumerate() {
            // How far the corner before the element turns away from the tool.
            let away = case.elements[..i].last().map(|before| {
                let incoming = before.tangent(before.to);
                -case.offset.signum() * incoming.angle_to(element.tangent(element.from))
            });
            if let Some(away) = away.filter(|away| *away > BAND) {
                let arc = moves.next().expect("a move round the corner");
                assert_round(&case, arc, element, away, &what("an arc goes round the corner"));
                kinds[0] += 1;
                at = beside(&case, element, 0);
            } else if away.is_some_and(|away| away.abs() < BAND) {
                kinds[1] += 1;
                let before = &case.elements[i - 1];
                assert!(at.distance(beside(&case, before, 1)) < 1e-6, "{}", what("not cut short"));
            } else if away.is_some() {
                kinds[2] += 1;
                assert!(
                    (element.left(at) - case.offset).abs() < 1e-6,
                    "{}",
                    what("on both offsets")
                );
            }
            let own = moves.next().expect("a move along the element");
            let role = if i == 0 { Role::LeadIn } else { Role::Segment };
            assert_eq!(own.role, role, "{}", what("in order"));
            assert!(own.curve.start().distance(at) < 1e-6, "{}", what("without a gap"));
            at = own.curve.end();
            assert!((element.left(at) - case.offset).abs() < 1e-6, "{}", what("beside at its end"));
            if let (MoveCurve::Arc(arc), Some(center)) = (&own.curve, element.center) {
                assert!(arc.center().distance(center) < 1e-6, "{}", what("about its centre"));
            }
        }
        let last = case.elements.last().expect("elements");
        assert!(at.distance(beside(&case, last, 1)) < 1e-6, "{}", what("to its end before G40"));
        let exit = moves.next().expect("a lead-out");
        assert!(exit.curve.end().distance(case.exit) < 1e-6, "{}", what("out to the point itself"));
        assert!(moves.next().is_none(), "{}", what("nothing more"));
    }
    let least = CASES / 10;
    assert!(finished > least && kinds.iter().all(|kind| *kind > least), "{finished} {kinds:?}");
}

fn assert_round(case: &Case, step: &Move, next: &Element, away: f64, what: &str) {
    let MoveCurve::Arc(arc) = &step.curve else { panic!("{what}") };
    assert!(arc.center().distance(next.from) < 1e-6, "{what}");
    assert!((arc.radius() - case.offset.abs()).abs() < 1e-6, "{what}");
    assert!((arc.sweep() + case.offset.signum() * away).abs() < 1e-6, "{what}");
    assert!(arc.end().distance(beside(case, next, 0)) < 1e-6, "{what}");
    assert_eq!(step.role, Role::Transition, "{what}");
}
