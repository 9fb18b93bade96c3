//! Involutes: gears by closed forms and brute force, tight places, and what is no involute.

use std::f64::consts::{PI, TAU};

use g41::compensation::{CornerStyle, GougePolicy, Options, Output, avoid, compensate_all};
use g41::contour::{
    Attributes, ContourBuilder, MoveCurve, Role, Shape, Side, Tool, ToolPath, TransitionKind,
};
use g41::diagnostic::{Origin, Severity};
use g41::geometry::Involute;
use g41::gouge::check;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::{at_the_radius, field_of, field_of_path, in_one_piece, same_path, samples};
use super::sketch::{Sketch, arc, line, spline};
use crate::common::random::Random;
use crate::common::{near, near_point, p};

const CASES: u32 = if cfg!(target_arch = "wasm32") { 40 } else { 300 };

/// A gear by its textbook: module [mm], teeth, a pressure angle of 20°.
struct Gear {
    teeth: u32,
    base: f64,
    tip: f64,
    root: f64,
    /// Half of the angle that a tooth has on its base circle.
    half: f64,
}

impl Gear {
    fn new(module: f64, teeth: u32) -> Self {
        let pressure = 20_f64.to_radians();
        let pitch = 0.5 * module * f64::from(teeth);
        Self {
            teeth,
            base: pitch * pressure.cos(),
            tip: pitch + module,
            root: pitch - 1.25 * module,
            half: 0.5 * PI / f64::from(teeth) + pressure.tan() - pressure,
        }
    }

    /// The roll at a distance from the centre.
    fn roll(&self, distance: f64) -> f64 {
        (distance * distance / (self.base * self.base) - 1.0).max(0.0).sqrt()
    }

    /// The point at a roll of the flank on the one or the other side of a tooth at an angle.
    fn flank(&self, tooth: f64, side: f64, roll: f64) -> DVec2 {
        let leaves = DVec2::from_angle(tooth + side * (self.half - roll));
        (leaves + leaves.perp() * (side * roll)) * self.base
    }

    /// Its outline counter-clockwise, flanks down to the base circle and radial from there.
    fn sketch(&self) -> Sketch {
        let top = self.roll(self.tip);
        let step = TAU / f64::from(self.teeth);
        let flank = |to: DVec2, clockwise: bool| Shape::Involute {
            to,
            center: DVec2::ZERO,
            radius: self.base,
            clockwise,
        };
        let at = |angle: f64, distance: f64| DVec2::from_angle(angle) * distance;
        let mut shapes = Vec::new();
        for tooth in 0..self.teeth {
            let angle = step * f64::from(tooth);
            shapes.push(line(self.flank(angle, -1.0, 0.0)));
            shapes.push(flank(self.flank(angle, -1.0, top), false));
            shapes.push(arc(self.flank(angle, 1.0, top), DVec2::ZERO, false));
            shapes.push(flank(self.flank(angle, 1.0, 0.0), false));
            shapes.push(line(at(angle + self.half, self.root)));
            shapes.push(arc(at(angle + step - self.half, self.root), DVec2::ZERO, false));
        }
        Sketch::closed(at(-self.half, self.root), shapes)
    }
}

fn involutes(path: &ToolPath) -> Vec<Involute> {
    let curves = path.moves.iter().map(|one| one.curve);
    curves.filter_map(|c| if let MoveCurve::Involute(i) = c { Some(i) } else { None }).collect()
}

fn errors(path: &ToolPath) -> Vec<&'static str> {
    let found = path.diagnostics.iter().filter(|d| d.severity == Severity::Error);
    found.map(|d| d.code).collect()
}

#[test]
fn a_gear_is_gone_round_at_the_radius_on_involutes_of_its_base_circle() {
    let gear = Gear::new(4.0, 17);
    let sketch = gear.sketch();
    let contour = sketch.contour();
    let field = field_of(&contour);
    let radius = 0.8;
    for corner in [CornerStyle::Linear, CornerStyle::Arc] {
        let options = Options { corner, ..Options::default() };
        for (sketch, side) in [(sketch.clone(), Side::Right), (sketch.reversed(), Side::Left)] {
            let path = sketch.compensated(side, radius, &options);
            let what = format!("{corner:?}, {side:?}");
            assert!(errors(&path).is_empty(), "{what}: {:?}", path.diagnostics);
            in_one_piece(&path, &what);
            at_the_radius(&path, &field, radius, corner, 1e-8, &what);
            assert!(check(&contour, &path, radius, 1e-6).is_empty(), "{what}: judged");
            let found = involutes(&path);
            assert_eq!(found.len(), 34, "{what}: two flanks a tooth");
            for flank in found {
                // Where a flank goes on from a radial line its start is moved by a rounding.
                near(flank.base_radius(), gear.base, 1e-6, &what);
                near_point(flank.center(), DVec2::ZERO, 1e-6, &what);
                // Outside, a thread is longer by the radius than that of the part.
                let [low, high] = [
                    flank.rolls()[0].min(flank.rolls()[1]),
                    flank.rolls()[0].max(flank.rolls()[1]),
                ];
                near(high, gear.roll(gear.tip) + radius / gear.base, 1e-7, &what);
                assert!(low >= radius / gear.base - 1e-7, "{what}: {low}");
            }
        }
    }
}

#[test]
fn a_gear_has_one_path_through_every_symmetry() {
    let sketch = Gear::new(3.0, 11).sketch();
    let options = Options::default();
    let path = sketch.compensated(Side::Right, 0.5, &options);
    for first in [1, 2, 4, 9] {
        let other = sketch.starting_at(first).compensated(Side::Right, 0.5, &options);
        same_path(&path, &other, 1e-8, &format!("from {first}"));
    }
    let other = sketch.reversed().compensated(Side::Left, 0.5, &options);
    same_path(&path, &other, 1e-8, "reversed");
    for index in [1, 3] {
        let split = sketch.split(index, 0.3).expect("an involute can be cut");
        same_path(&path, &split.compensated(Side::Right, 0.5, &options), 1e-8, "split");
    }
    let agree = |map: &dyn Fn(DVec2) -> DVec2, other: &ToolPath, what: &str| {
        let field = field_of_path(other);
        for point in samples(&path, 5) {
            near(field.distance(map(point)), 0.0, 1e-7, what);
        }
    };
    let mirror = |v: DVec2| p(v.x, -v.y);
    agree(&mirror, &sketch.mapped(true, mirror).compensated(Side::Left, 0.5, &options), "mirrored");
    let turned = |v: DVec2| DVec2::from_angle(0.7).rotate(v) * 4.0 + p(500.0, -200.0);
    let other = sketch.mapped(false, turned).compensated(Side::Right, 2.0, &options);
    agree(&turned, &other, "turned, moved and scaled");
}

#[test]
fn a_flank_has_the_offset_of_its_closed_form_on_both_sides() {
    let gear = Gear::new(5.0, 20);
    let (low, high) = (gear.roll(gear.base + 3.0), gear.roll(gear.tip));
    let [foot, top] = [low, high].map(|roll| gear.flank(0.0, -1.0, roll));
    let shape =
        Shape::Involute { to: top, center: DVec2::ZERO, radius: gear.base, clockwise: false };
    let sketch = Sketch::open(foot, [shape]);
    for (side, sign) in [(Side::Right, 1.0), (Side::Left, -1.0)] {
        let path = sketch.compensated(side, 2.0, &Options::default());
        let [flank] = involutes(&path)[..] else { panic!("{:?}", path.moves) };
        // Away from the centre of curvature the thread grows by r, along the same line.
        let beside = |roll: f64| {
            let leaves = DVec2::from_angle(roll - gear.half);
            (leaves - leaves.perp() * (roll + sign * 2.0 / gear.base)) * gear.base
        };
        near_point(flank.start(), beside(low), 1e-12, "start");
        near_point(flank.end(), beside(high), 1e-12, "end");
        let length = |from: f64, to: f64| 0.5 * gear.base * (to * to - from * from);
        let moved = |roll: f64| roll + sign * 2.0 / gear.base;
        near(flank.length(), length(moved(low), moved(high)), 1e-11, "R φ² / 2");
        assert_eq!(path.moves.len(), 1, "{side:?}: {:?}", path.moves);
    }
}

#[test]
fn a_tool_too_large_for_a_bend_is_told_as_deep_as_it_cuts() {
    let mut random = Random::new(931);
    let mut told = 0;
    for case in 0..CASES {
        let base = random.within(5.0, 50.0);
        let inner = if random.coin() { 0.0 } else { random.within(0.0, 0.5) };
        let outer = inner + random.within(0.1, 1.0);
        let radius = base * random.within(inner.max(0.02), outer + 0.3);
        let sense = random.sign();
        let at = |roll: f64| {
            let leaves = DVec2::from_angle(sense * roll);
            (leaves - leaves.perp() * (sense * roll)) * base
        };
        let outward = random.coin();
        let [from, to] = if outward { [inner, outer] } else { [outer, inner] };
        let clockwise = outward == (sense < 0.0);
        let shape = Shape::Involute { to: at(to), center: DVec2::ZERO, radius: base, clockwise };
        let sketch = Sketch::open(at(from), [shape]);
        // The tool on the side to which it bends.
        let side = if clockwise { Side::Right } else { Side::Left };
        let path = sketch.compensated(side, radius, &Options::default());
        let what = format!("case {case}: r {radius}, {sketch:?}");
        in_one_piece(&path, &what);
        let contour = sketch.contour();
        let field = field_of(&contour);
        let deepest = samples(&path, 400)
            .into_iter()
            .map(|at| radius - field.distance(at))
            .fold(0.0, f64::max);
        let reported = path.gouges.iter().map(|gouge| gouge.depth).fold(0.0, f64::max);
        near(reported, deepest, 2e-3 + 0.01 * deepest, &what);
        let judged = check(&contour, &path, radius, 1e-3);
        let depth = judged.iter().map(|gouge| gouge.depth).fold(0.0, f64::max);
        near(depth, deepest, 2e-3 + 0.01 * deepest, &format!("{what}: judged"));
        told += u32::from(reported > 0.0);
        // Without what does not fit it is nowhere too near, and reaches what can be reached.
        let tool = Tool::new(radius, side).expect("a radius");
        let path = avoid(&contour, tool, &Options::default());
        for point in samples(&path, 9) {
            let off = radius - field.distance(point);
            assert!(off <= 1e-3, "{what}: avoided, {off} too near at {point}");
        }
        assert!(check(&contour, &path, radius, 1e-3).is_empty(), "{what}: avoided, judged");
        let reached = field_of_path(&path);
        for k in 0..24 {
            let t = (f64::from(k) + 0.5) / 24.0;
            let curve = &contour.segments()[0].curve;
            let center = curve.point(t) + curve.tangent(t).perp() * (side.sign() * radius);
            if field.distance(center) >= radius + 5e-4 && path.moves.len() > 1 {
                let off = reached.distance(center);
                assert!(off <= 3e-3, "{what}: {center} is left out by {off}");
            }
        }
    }
    assert!(told > CASES / 4, "{told} of {CASES} told");
}

/// A contour that wanders along involutes of either hand, lines, arcs and splines.
fn wandering(random: &mut Random) -> Sketch {
    let (mut at, mut along) = (DVec2::ZERO, DVec2::X);
    let mut shapes = Vec::new();
    let start = at;
    for _ in 0..3 + random.index(6) {
        along = DVec2::from_angle(random.within(-1.0, 1.0)).rotate(along);
        let size = random.within(4.0, 15.0);
        let shape = match random.index(5) {
            0 => line(at + along * size),
            1 => {
                let bend = random.within(6.0, 30.0) * random.sign();
                let center = at + along.perp() * bend;
                let turn = DVec2::from_angle(size / bend);
                arc(center + turn.rotate(at - center), center, bend < 0.0)
            }
            2 => {
                let turn = DVec2::from_angle(random.within(-0.3, 0.3));
                let (mut here, mut way, mut points) = (at, along, Vec::new());
                for _ in 0..3 {
                    here += way * size / 3.0;
                    way = turn.rotate(way);
                    points.push(here);
                }
                spline(&points)
            }
            _ => {
                let (base, sense) = (random.within(5.0, 30.0), random.sign());
                let outward = random.coin();
                let direction = if outward { along } else { -along };
                let first = if random.index(4) == 0 { 0.0 } else { random.within(0.3, 1.2) };
                let first = if outward { first } else { first + 0.7 };
                let thread = direction.perp() * (sense * base * first);
                let center = at + thread - direction * base;
                let last = if outward { first + random.within(0.2, 0.8) } else { first - 0.5 };
                let leaves = DVec2::from_angle((last - first) * sense).rotate(direction);
                let to = center + leaves * base - leaves.perp() * (base * last * sense);
                let clockwise = outward == (sense < 0.0);
                Shape::Involute { to, center, radius: base, clockwise }
            }
        };
        shapes.push(shape);
        let contour = Sketch::open(start, shapes.clone()).contour();
        let last = &contour.segments()[shapes.len() - 1].curve;
        (at, along) = (last.end(), last.tangent(1.0));
    }
    Sketch::open(start, shapes)
}

#[test]
fn contours_with_involutes_are_never_cut_without_a_word_and_never_where_gouges_are_avoided() {
    let mut random = Random::new(932);
    let (mut clear, mut told) = (0, 0);
    for case in 0..CASES {
        let sketch = wandering(&mut random);
        let radius = 10.0_f64.powf(random.within(-0.5, 1.2));
        let side = if random.coin() { Side::Left } else { Side::Right };
        let corner = if random.coin() { CornerStyle::Linear } else { CornerStyle::Arc };
        let options = Options { corner, ..Options::default() };
        let contour = sketch.contour();
        let field = field_of(&contour);
        let what = format!("case {case}, r {radius}, {side:?}, {corner:?}: {sketch:?}");
        let path = sketch.compensated(side, radius, &options);
        in_one_piece(&path, &what);
        let deepest = samples(&path, 30)
            .into_iter()
            .map(|at| radius - field.distance(at))
            .fold(0.0, f64::max);
        if deepest < 2e-3 {
            clear += 1;
        } else {
            told += 1;
            assert!(!path.gouges.is_empty(), "{what}: {deepest} mm deep and not a word");
        }
        let judged = check(&contour, &path, radius, 1e-3);
        assert_eq!(judged.is_empty(), deepest < 1e-3, "{what}: {deepest} and {judged:?}");
        for output in [Output::Cubics, Output::Arcs] {
            let tool = Tool::new(radius, side).expect("a radius");
            let options = Options { gouge: GougePolicy::Avoid, output, ..options };
            let path = compensate_all(&[(&contour, tool)], &options);
            for point in samples(&path, 9) {
                let off = radius - field.distance(point);
                assert!(off <= 1e-3, "{what}, {output:?}: {off} too near at {point}");
            }
            assert!(check(&contour, &path, radius, 1e-3).is_empty(), "{what}, {output:?}: judged");
            let told = path.diagnostics.iter().any(|d| d.code == "involutes-as-splines");
            let has = sketch.shapes.iter().any(|s| matches!(s, Shape::Involute { .. }));
            assert_eq!(told, has, "{what}: what stands for involutes is told");
        }
    }
    assert!(clear > CASES / 5 && told > CASES / 8, "{clear} clear and {told} told of {CASES}");
}

#[test]
fn arcs_and_lines_along_an_involute_are_within_the_tolerance() {
    let sketch = Gear::new(6.0, 13).sketch();
    let contour = sketch.contour();
    let field = field_of(&contour);
    let mut counts = Vec::new();
    for tolerance in [1e-1, 1e-2, 1e-3, 1e-4] {
        let tool = Tool::new(1.0, Side::Right).expect("a radius");
        let options = Options {
            tolerance,
            output: Output::Arcs,
            corner: CornerStyle::Arc,
            ..Options::default()
        };
        let path = compensate_all(&[(&contour, tool)], &options);
        let what = format!("tolerance {tolerance}");
        assert!(involutes(&path).is_empty(), "{what}: none is left");
        in_one_piece(&path, &what);
        at_the_radius(&path, &field, 1.0, CornerStyle::Arc, tolerance, &what);
        counts.push(path.moves.len());
    }
    // An arc is off by the third power of its length: a tenth of the tolerance takes 2.2 times as
    // many, of which 4 a tooth are none along flanks.
    assert!(counts[0] < 26 * 6 && counts[3] < 26 * 30, "{counts:?} moves");
}

#[test]
fn leads_and_corners_of_an_involute_are_those_of_any_curve() {
    let gear = Gear::new(5.0, 20);
    let [foot, top] = [0.3, 0.6].map(|roll| gear.flank(0.0, -1.0, roll));
    let shape =
        Shape::Involute { to: top, center: DVec2::ZERO, radius: gear.base, clockwise: false };
    let tangent = DVec2::from_angle(0.3 - gear.half);
    let sketch = Sketch::open(foot, [shape]).led(foot - tangent * 10.0, top + p(3.0, -20.0));
    let path = sketch.compensated(Side::Right, 1.5, &Options::default());
    in_one_piece(&path, "led");
    let roles: Vec<Role> = path.moves.iter().map(|one| one.role).collect();
    assert_eq!(roles.first(), Some(&Role::LeadIn), "{roles:?}");
    assert_eq!(roles.last(), Some(&Role::LeadOut), "{roles:?}");
    // Tangent to the lead-in, the flank begins beside its start.
    near_point(path.moves[1].curve.start(), foot - tangent.perp() * 1.5, 1e-9, "beside the foot");
    assert_eq!(path.transitions.len(), 1, "only the lead-out turns");
    assert!(path.transitions[0].kind != TransitionKind::Inserted, "{:?}", path.transitions);
}

#[test]
fn what_is_no_involute_is_told_and_a_line_stands_in_its_place() {
    let build = |to: DVec2, center: DVec2, radius: f64| {
        let mut builder = ContourBuilder::new(p(12.0, 0.0));
        let shape = Shape::Involute { to, center, radius, clockwise: false };
        builder.segment(shape, Attributes::at(Origin::Segment(0)));
        builder.build(false)
    };
    let gear_end = {
        // The point at twice the roll of (12, 0) about the origin, radius 10.
        let roll = 0.44_f64.sqrt();
        let first = roll.atan() - roll;
        let leaves = DVec2::from_angle(first + 2.0 * roll);
        (leaves - leaves.perp() * (2.0 * roll)) * 10.0
    };
    assert!(build(gear_end, DVec2::ZERO, 10.0).diagnostics.is_empty(), "the right one");
    for (to, center, radius, code) in [
        (gear_end, DVec2::ZERO, 0.0, "no-base-circle"),
        (gear_end, DVec2::ZERO, -10.0, "no-base-circle"),
        (gear_end, DVec2::ZERO, 0.01, "no-base-circle"),
        (gear_end, DVec2::ZERO, 12.1, "inside-base-circle"),
        (p(9.9, 3.0) * 0.9, DVec2::ZERO, 10.0, "inside-base-circle"),
        (gear_end + p(0.0, 0.5), DVec2::ZERO, 10.0, "off-involute"),
        (gear_end, p(1.0, 0.0), 10.0, "off-involute"),
        (p(1e8, 0.0), DVec2::ZERO, 10.0, "out-of-range"),
        (p(12.0, 0.0), DVec2::ZERO, 10.0, "zero-length"),
    ] {
        let built = build(to, center, radius);
        let codes: Vec<_> = built.diagnostics.iter().map(|d| d.code).collect();
        assert_eq!(codes.first(), Some(&code), "{to} {center} {radius}: {codes:?}");
        let stands = built.contour.is_some();
        assert_eq!(stands, !["zero-length", "out-of-range"].contains(&code), "{code}");
    }
}
