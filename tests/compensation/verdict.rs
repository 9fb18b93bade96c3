//! What an avoided path is held against: the judge, brute force, and everything it must reach.

use std::f64::consts::SQRT_2;
use std::fmt;

use g41::compensation::{CornerStyle, Options, avoid};
use g41::contour::{Contour, Role, Segment, ToolPath};
use g41::geometry::Curve;
use g41::gouge::check;
use glam::DVec2;

use super::families::Case;
use super::judge::{field_of, field_of_path, samples};

/// How far from the path a reachable centre may be, in tolerances: the path is within one of the
/// true offset, and where it bends sharply a second is left for the ends.
const REACH: f64 = 2.0;

/// Part of the tolerance that a reachable place along splines has to spare: their offsets are as far
/// off, and where two walls are nearly parallel that moves the place where a tool fits no more.
const SPARE: f64 = 0.25;

/// Segments and spans shorter than this part of the tolerance are points: which side of them the
/// tool is on nobody can tell.
const POINT: f64 = 0.1;

/// Chords nearer than this touch, in mm: twice their sagitta.
const CLEAR: f64 = 2e-3;

/// Flanks of a corner nearer than this are looked at closely, in mm.
const NEAR: f64 = 0.02;

/// What is wrong with a path.
#[derive(Debug, Clone)]
pub(crate) enum Fault {
    /// The judge found a place nearer than `r − tolerance`.
    Judged { at: DVec2, depth: f64 },
    /// A sample of the path is so much nearer than `r − tolerance`.
    Near { at: DVec2, by: f64 },
    /// A sample of the path is so much farther than a tool beside the contour ever is.
    Far { at: DVec2, by: f64 },
    /// A number is not finite.
    NotFinite,
    /// A piece of the path along a closed contour ends so far from where it starts.
    Open { at: DVec2, gap: f64 },
    /// A reachable tool centre is so far from the path.
    LeftOut { at: DVec2, off: f64 },
}

impl Fault {
    /// One word for a table.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Judged { .. } => "judged",
            Self::Near { .. } => "near",
            Self::Far { .. } => "far",
            Self::NotFinite => "not finite",
            Self::Open { .. } => "open",
            Self::LeftOut { .. } => "left out",
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Judged { at, depth } => write!(f, "judged: {depth:.3e} deep at {at}"),
            Self::Near { at, by } => write!(f, "near: {by:.3e} at {at}"),
            Self::Far { at, by } => write!(f, "far: {by:.3e} at {at}"),
            Self::NotFinite => write!(f, "not finite"),
            Self::Open { at, gap } => write!(f, "open: a gap of {gap:.3e} at {at}"),
            Self::LeftOut { at, off } => write!(f, "left out: {off:.3e} off the path at {at}"),
        }
    }
}

/// How thoroughly a path is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Depth {
    /// By the judge, and by its pieces.
    Judged,
    /// By brute force too: distances of samples, and whether everything reachable is reached.
    Brute,
}

/// The path of a case.
pub(crate) fn path_of(case: &Case, contour: &Contour) -> ToolPath {
    let options = Options { tolerance: case.tolerance, corner: case.corner, ..Options::default() };
    avoid(contour, case.tool(), &options)
}

/// The worst of every kind of fault of the path of a case.
pub(crate) fn faults(case: &Case, contour: &Contour, path: &ToolPath, depth: Depth) -> Vec<Fault> {
    let mut faults = Vec::new();
    let points =
        |one: &g41::contour::Move| [one.curve.start(), one.curve.point(0.5), one.curve.end()];
    if path.moves.iter().flat_map(points).any(|point| !point.is_finite()) {
        return vec![Fault::NotFinite];
    }
    let gouges = check(contour, path, case.radius, case.tolerance);
    let deepest = gouges.iter().max_by(|a, b| a.depth.total_cmp(&b.depth));
    faults.extend(deepest.map(|gouge| Fault::Judged { at: gouge.at, depth: gouge.depth }));
    if contour.is_closed() {
        // Where a contour crosses itself one side of a wall meets the other, and the path ends.
        let open = open_piece(path, case.tolerance);
        faults.extend(open.filter(|_| is_simple(contour)));
    }
    if depth == Depth::Brute {
        by_brute_force(case, contour, path, &mut faults);
    }
    faults
}

/// The widest gap between end and start of a piece.
fn open_piece(path: &ToolPath, tolerance: f64) -> Option<Fault> {
    let mut worst: Option<Fault> = None;
    let mut widest = tolerance;
    let mut start = path.moves.first()?.curve.start();
    let mut pairs = path.moves.iter().zip(path.moves[1..].iter().map(Some).chain([None]));
    pairs.by_ref().for_each(|(one, next)| {
        let end = one.curve.end();
        if next.is_none_or(|next| next.curve.start().distance(end) > 1e-6) {
            let gap = end.distance(start);
            if gap > widest {
                widest = gap;
                worst = Some(Fault::Open { at: end, gap });
            }
            start = next.map_or(end, |next| next.curve.start());
        }
    });
    worst
}

/// Whether a contour keeps clear of itself, by brute force on chords.
fn is_simple(contour: &Contour) -> bool {
    let mut points = vec![contour.start()];
    for segment in contour.segments() {
        segment.curve.flatten(1e-3, &mut |point| points.push(point));
    }
    let chords: Vec<[DVec2; 2]> = points
        .windows(2)
        .map(|pair| [pair[0], pair[1]])
        .filter(|[a, b]| a.distance(*b) > 1e-6)
        .collect();
    let apart = |[a, b]: [DVec2; 2], [c, d]: [DVec2; 2]| {
        let low = a.min(b).cmpgt(c.max(d) + CLEAR) | c.min(d).cmpgt(a.max(b) + CLEAR);
        low.any() || {
            let line_apart = |a: DVec2, b: DVec2, c: DVec2, d: DVec2| {
                let along = (b - a).normalize_or_zero();
                let (c, d) = (along.perp_dot(c - a), along.perp_dot(d - a));
                c.min(d) > CLEAR || c.max(d) < -CLEAR
            };
            line_apart(a, b, c, d) || line_apart(c, d, a, b)
        }
    };
    let count = chords.len();
    let segments = contour.segments();
    (0..segments.len()).all(|i| {
        let next = (i + 1) % segments.len();
        !flanks_cross(&segments[i].curve, &segments[next].curve)
    }) && (0..count).all(|i| {
        (i + 2..count).filter(|&j| i > 0 || j + 1 < count).all(|j| apart(chords[i], chords[j]))
    })
}

/// Whether two segments that follow each other cross again near their corner, nearer than chords
/// tell or the coarsest tolerance of the families.
fn flanks_cross(incoming: &Curve, outgoing: &Curve) -> bool {
    let mut side = 0.0;
    for k in 1..=400 {
        let point = outgoing.point((f64::from(k) / 400.0).powi(3));
        let foot = incoming.nearest(point);
        let off = point - foot.point;
        if foot.t == 1.0 || foot.t == 0.0 || off.length() > NEAR {
            return false;
        }
        let now = incoming.tangent(foot.t).perp_dot(off);
        if now.abs() > 1e-9 {
            if now * side < 0.0 {
                return true;
            }
            side = now;
        }
    }
    false
}

/// Length of a segment, or of the span at the end of a spline.
fn end_length(curve: &Curve, last: bool) -> f64 {
    match curve {
        Curve::Spline(spline) => {
            spline.pieces()[if last { spline.pieces().len() - 1 } else { 0 }].length()
        }
        Curve::Line(_) | Curve::Arc(_) | Curve::Involute(_) => curve.length(),
    }
}

fn by_brute_force(case: &Case, contour: &Contour, path: &ToolPath, faults: &mut Vec<Fault>) {
    let (radius, tolerance) = (case.radius, case.tolerance);
    let field = field_of(contour);
    let most = if case.corner == CornerStyle::Arc { radius } else { SQRT_2 * radius };
    let (mut near, mut far): (Option<Fault>, Option<Fault>) = (None, None);
    let (mut nearest, mut farthest) = (tolerance, tolerance);
    for at in samples(path, 9) {
        let distance = field.distance(at);
        if radius - distance > nearest {
            nearest = radius - distance;
            near = Some(Fault::Near { at, by: nearest });
        }
        if distance - most > farthest {
            // The oracle's samples may miss a sharp bend, where another way finds the foot.
            let found = contour.segments().iter().map(|s| s.curve.nearest(at).distance);
            let distance = found.fold(distance, f64::min);
            if distance - most <= farthest {
                continue;
            }
            farthest = distance - most;
            far = Some(Fault::Far { at, by: farthest });
        }
    }
    faults.extend(near.into_iter().chain(far));
    faults.extend(left_out(case, contour, path, &field));
}

/// The reachable tool centre that is farthest from the path.
///
/// Centres are tried beside points all along the contour, and round outside corners. A single one
/// that can be reached between others that cannot is a place where the tool fits exactly and goes
/// nowhere from: no path need visit it.
fn left_out(
    case: &Case,
    contour: &Contour,
    path: &ToolPath,
    field: &crate::common::oracle::Field,
) -> Option<Fault> {
    let (tolerance, sign) = (case.tolerance, case.side.sign());
    let is_spline = |segment: &Segment| matches!(segment.curve, Curve::Spline(_));
    let spare = if contour.segments().iter().any(is_spline) { SPARE * tolerance } else { 0.0 };
    let radius = case.radius + spare;
    let on_path = field_of_path(path);
    let moves = path.moves.iter().any(|one| one.role != Role::Free);
    let mut worst: Option<Fault> = None;
    let mut farthest = REACH * tolerance + spare;
    let mut try_centers = |centers: &[DVec2]| {
        // Coordinates of some hundred millimetres hold fourteen digits after all these steps.
        let reachable: Vec<bool> = centers
            .iter()
            .map(|center| field.distance(*center) >= radius - 1e-9 * (1.0 + radius))
            .collect();
        for (i, &center) in centers.iter().enumerate() {
            let goes_on = |j: usize| {
                reachable.get(j) == Some(&true) && centers[j].distance(center) > 20.0 * tolerance
            };
            if !reachable[i] || !(goes_on(i + 1) || i > 0 && goes_on(i - 1)) {
                continue;
            }
            let off = if moves { on_path.distance(center) } else { f64::INFINITY };
            if off > farthest {
                farthest = off;
                worst = Some(Fault::LeftOut { at: center, off });
            }
        }
    };
    let segments = contour.segments();
    for (i, segment) in segments.iter().enumerate() {
        let spans = if let Curve::Spline(s) = &segment.curve { s.pieces().len() } else { 1 };
        let count = (12 * spans).min(240);
        let beside = |k: usize| {
            let t = (k as f64 + 0.5) / count as f64;
            segment.curve.point(t) + segment.curve.tangent(t).perp() * (sign * radius)
        };
        try_centers(&(0..count).map(beside).collect::<Vec<_>>());
        if case.corner != CornerStyle::Arc || i + 1 == segments.len() && !contour.is_closed() {
            continue;
        }
        let next = &segments[(i + 1) % segments.len()];
        // Where flanks cross again a spike is a slit but for its tip.
        let shorter = end_length(&segment.curve, true).min(end_length(&next.curve, false));
        if shorter < POINT * tolerance || flanks_cross(&segment.curve, &next.curve) {
            continue;
        }
        let (t1, t2) = (segment.curve.tangent(1.0), next.curve.tangent(0.0));
        let turn = t1.angle_to(t2);
        // A reversal may be an inside corner just as well; which, only the bends beside it tell.
        if sign * turn < 0.0 && turn.abs() < std::f64::consts::PI - 1e-6 {
            let around = |k: u32| {
                let normal = t1.perp() * (sign * radius);
                let turned = DVec2::from_angle(turn * (f64::from(k) + 0.5) / 8.0).rotate(normal);
                segment.curve.end() + turned
            };
            try_centers(&(0..8).map(around).collect::<Vec<_>>());
        }
    }
    worst
}
