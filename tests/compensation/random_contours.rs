//! Seeded random contours of lines, arcs and splines, gouge-free by their generator's own check.
//!
//! The generator compensates by brute force: it samples the true offset of every segment, cuts
//! inside corners where the samples cross last, and rejects a contour unless every sample left, and
//! the moves of every outside corner, keep their distance from the whole contour.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use g41::compensation::{CornerStyle, Options};
use g41::contour::{Contour, Shape, Side, SplineShape};
use g41::diagnostic::Severity;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::brute::{Offset, inside_corner};
use super::judge::{at_the_radius, field_of, field_of_path, in_one_piece};
use super::sketch::{Sketch, arc, line};
use crate::common::oracle::Field;
use crate::common::random::Random;

/// Contours judged; in WebAssembly, which is slower, the first of the same.
const CASES: u32 = if cfg!(target_arch = "wasm32") { 500 } else { 10_000 };

/// Samples of each offset.
const SAMPLES: usize = 160;

/// A contour that wanders: segments of random kinds and lengths with random turns between them.
pub(crate) fn wandering(random: &mut Random) -> Sketch {
    let start = random.point(50.0);
    let (mut at, mut heading) = (start, random.within(0.0, TAU));
    let mut shapes = Vec::new();
    for i in 0..2 + random.index(5) {
        if i > 0 && random.index(6) != 0 {
            heading += random.within(0.02, 2.7) * random.sign();
        }
        let along = DVec2::from_angle(heading);
        let shape = match random.index(3) {
            0 => line(at + along * random.within(6.0, 40.0)),
            1 => {
                let bend = random.within(4.0, 40.0) * random.sign();
                let sweep = random.within(0.2, 2.6) * bend.signum();
                let center = at + along.perp() * bend;
                heading += sweep;
                arc(center + DVec2::from_angle(sweep).rotate(at - center), center, bend < 0.0)
            }
            _ => {
                let mut points = Vec::new();
                let (mut point, mut way) = (at, heading);
                for _ in 0..2 + random.index(6) {
                    way += random.within(-0.5, 0.5);
                    point += DVec2::from_angle(way) * random.within(4.0, 14.0);
                    points.push(point);
                }
                heading = way;
                let start_tangent = random.coin().then_some(along);
                Shape::Spline(SplineShape { points, start_tangent, ..SplineShape::default() })
            }
        };
        at = shape.end().expect("a shape has an end");
        shapes.push(shape);
    }
    Sketch::open(start, shapes)
}

/// A closed contour about the origin, run round it in either sense.
pub(crate) fn star(random: &mut Random) -> Sketch {
    let count = 2 + random.index(6);
    let step = random.sign() * TAU / count as f64;
    let mut corners = Vec::with_capacity(count);
    for i in 0..count {
        let ray = DVec2::from_angle(step * (i as f64 + random.within(-0.25, 0.25)));
        corners.push(ray * random.within(20.0, 60.0));
    }
    let mut shapes = Vec::new();
    for i in 0..count {
        let (from, to) = (corners[i], corners[(i + 1) % count]);
        let chord = to - from;
        shapes.push(match random.index(3) {
            0 if count > 2 => line(to),
            1 => {
                let bend = chord.length() * random.within(0.51, 3.0) * random.sign();
                let off = (bend * bend - 0.25 * chord.length_squared()).sqrt() * bend.signum();
                arc(to, from.midpoint(to) + chord.perp().normalize() * off, bend < 0.0)
            }
            _ => {
                let inner = 1 + random.index(4);
                let mut points: Vec<DVec2> = (1..=inner)
                    .map(|k| from.lerp(to, k as f64 / (inner + 1) as f64))
                    .map(|point| point + random.direction() * chord.length() * 0.08)
                    .collect();
                points.push(to);
                Shape::Spline(SplineShape { points, ..SplineShape::default() })
            }
        });
    }
    Sketch::closed(corners[0], shapes)
}

/// Why a contour is not taken.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Rejection {
    /// A bend is tighter than the tool, or nearly.
    Bend,
    /// At an inside corner the offsets do not cross, or too near to an end, or in too small an
    /// angle; or the contour doubles back.
    Corner,
    /// The tool comes too near somewhere else.
    Bottleneck,
}

/// The parts of the true offsets that remain, as samples, if the contour is gouge-free.
pub(crate) fn check(
    contour: &Contour,
    field: &Field,
    side: Side,
    radius: f64,
) -> Result<Vec<DVec2>, Rejection> {
    let segments = contour.segments();
    let offsets: Vec<Offset> =
        segments.iter().map(|s| Offset::new(&s.curve, side, radius, SAMPLES)).collect();
    if offsets.iter().any(|offset| offset.bend > 0.97 / radius) {
        return Err(Rejection::Bend);
    }
    let count = segments.len();
    let whole = SAMPLES as f64;
    let mut cuts = vec![[0.0, whole]; count];
    let mut judged = Vec::new();
    for i in 0..if contour.is_closed() { count } else { count - 1 } {
        let next = (i + 1) % count;
        let (t1, t2) = (segments[i].curve.tangent(1.0), segments[next].curve.tangent(0.0));
        let turn = side.sign() * t1.angle_to(t2);
        if turn.abs() > PI - 0.05 {
            return Err(Rejection::Corner);
        }
        if turn > 1e-9 {
            let crossing = inside_corner(&offsets[i], &offsets[next], side)
                .filter(|c| c.sine > 0.02 && c.incoming > 2.0 && c.outgoing < whole - 2.0);
            let Some(crossing) = crossing else { return Err(Rejection::Corner) };
            cuts[i][1] = crossing.incoming;
            cuts[next][0] = crossing.outgoing;
        } else if turn < -1e-9 {
            let corner = segments[i].curve.end();
            let [n1, n2] = [t1, t2].map(|t| t.perp() * side.sign() * radius);
            let (v, a1, a2);
            let moves = if turn >= -FRAC_PI_2 {
                v = corner + (n1 + n2) / (1.0 + n1.dot(n2) / (radius * radius));
                vec![corner + n1, v, corner + n2]
            } else {
                (a1, a2) = (corner + n1 + t1 * radius, corner + n2 - t2 * radius);
                vec![corner + n1, a1, a2, corner + n2]
            };
            for pair in moves.windows(2) {
                judged.extend((0..=8).map(|k| pair[0].lerp(pair[1], f64::from(k) / 8.0)));
            }
        }
    }
    let mut kept = Vec::new();
    for (offset, [from, to]) in offsets.iter().zip(&cuts) {
        if to - from < 4.0 {
            return Err(Rejection::Corner);
        }
        // Where the samples cross is known to a sample or so: stay clear of it. Ends are sure.
        let low = if *from > 0.0 { from + 1.0 } else { 0.0 };
        let high = if *to < whole { to - 1.0 } else { whole };
        let samples = offset.points.iter().enumerate();
        let sure = samples.filter(|(k, _)| (low..=high).contains(&(*k as f64)));
        kept.extend(sure.map(|(_, point)| *point));
    }
    let near = |point: &DVec2| field.distance(*point) < radius * (1.0 - 1e-9);
    if kept.iter().step_by(2).chain(&judged).any(near) {
        return Err(Rejection::Bottleneck);
    }
    Ok(kept)
}

#[test]
fn the_path_of_every_gouge_free_contour_is_at_the_radius() {
    let mut random = Random::new(0x6734_3100);
    let mut rejected = [0_u32; 3];
    let mut judged = 0_u32;
    let (mut transitions, mut moves) = (0, 0);
    while judged < CASES {
        let sketch = if random.coin() { wandering(&mut random) } else { star(&mut random) };
        let radius = random.within(0.3, 5.0);
        let side = if random.coin() { Side::Left } else { Side::Right };
        let corner = if random.coin() { CornerStyle::Linear } else { CornerStyle::Arc };
        let tolerance = [1e-2, 1e-3, 1e-4][random.index(3)];
        let contour = sketch.contour();
        let field = field_of(&contour);
        let kept = match check(&contour, &field, side, radius) {
            Ok(kept) => kept,
            Err(reason) => {
                rejected[reason as usize] += 1;
                continue;
            }
        };
        judged += 1;
        let options = Options { corner, tolerance, ..Options::default() };
        let path = sketch.compensated(side, radius, &options);
        let what =
            format!("contour {judged}, {side:?}, r {radius}, {corner:?}, {tolerance}: {sketch:?}");
        in_one_piece(&path, &what);
        let faults: Vec<_> =
            path.diagnostics.iter().filter(|d| d.severity > Severity::Info).collect();
        assert!(faults.is_empty() && path.gouges.is_empty(), "{what}: {faults:?}");
        at_the_radius(&path, &field, radius, corner, tolerance, &what);
        if contour.is_closed() {
            let (first, last) = (&path.moves[0], &path.moves[path.moves.len() - 1]);
            let gap = first.curve.start().distance(last.curve.end());
            assert!(gap < 1e-8, "{what}: not closed by {gap:e}");
        }
        // The path leaves nothing out: what remains of the true offsets is on it.
        let on_path = field_of_path(&path);
        for point in kept.iter().step_by(29) {
            let off = on_path.distance(*point);
            assert!(off <= tolerance, "{what}: {point} is {off:e} off the path");
        }
        transitions += path.transitions.len();
        moves += path.moves.len();
    }
    println!(
        "{judged} contours judged, {transitions} transitions, {moves} moves; rejected: {} for a \
         bend, {} for an inside corner, {} for a bottleneck",
        rejected[0], rejected[1], rejected[2]
    );
}
