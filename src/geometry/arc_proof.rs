//! A proof that an arc or a line follows a piece of a cubic.
//!
//! For a cubic `C` and an arc of radius `ρ` about `M`, Bernstein coefficients bound `|C − M|²`, of
//! degree 6, and so the distance of `C` from the circle; and those of `(C − M) × C'`, of degree 5,
//! tell that `C` never turns back as seen from `M`. If it also begins and ends at the angles of the
//! arc's ends, each point of either has one of the other on the same ray, so the distance from the
//! circle bounds the Hausdorff distance. For a line it is the same with the distance from it and the
//! way along it, both of degree 3.

use glam::DVec2;

use super::{Arc, ArcOrLine, Cubic, cross, relative_to};

/// Halvings of a cubic until a proof that is not found is given up: bounds that are a quarter too
/// wide each time are then sharp to a percent.
const MAX_DEPTH: u32 = 5;

/// Distance of a point from the whole circle or straight line that `piece` is of [mm].
pub(super) fn distance_off(piece: &ArcOrLine, at: DVec2) -> f64 {
    match piece {
        ArcOrLine::Arc(arc) => (at.distance(arc.center()) - arc.radius()).abs(),
        ArcOrLine::Line(line) => cross(line.tangent(), at - line.start()).abs(),
    }
}

/// Whether `cubic` is proved to be within `tolerance` [mm] of the circle or the straight line that
/// `piece` is of, and to run along it all the way, but for parts no longer than `turning` [mm], from
/// which their length is taken.
pub(super) fn follows(cubic: &Cubic, piece: &ArcOrLine, tolerance: f64, turning: &mut f64) -> bool {
    is_proved(cubic, piece, tolerance, turning, 0)
}

fn is_proved(
    cubic: &Cubic,
    piece: &ArcOrLine,
    tolerance: f64,
    turning: &mut f64,
    depth: u32,
) -> bool {
    let ends = distance_off(piece, cubic.start()).max(distance_off(piece, cubic.end()));
    if ends > tolerance {
        return false;
    }
    let direct = match piece {
        ArcOrLine::Arc(arc) => is_round(cubic, arc, tolerance),
        ArcOrLine::Line(line) => {
            let (start, along) = (line.start(), line.tangent());
            cubic.points.iter().all(|&p| cross(along, p - start).abs() <= tolerance)
                && cubic.hodograph().iter().all(|v| v.dot(along) >= 0.0)
        }
    };
    if direct {
        return true;
    }
    let length = cubic.hull_length();
    if length <= *turning && ends + length <= tolerance {
        *turning -= length;
        return true;
    }
    let (left, right) = cubic.split(0.5);
    depth < MAX_DEPTH
        && is_proved(&left, piece, tolerance, turning, depth + 1)
        && is_proved(&right, piece, tolerance, turning, depth + 1)
}

/// The conditions for an arc, on the coefficients as they are.
fn is_round(cubic: &Cubic, arc: &Arc, tolerance: f64) -> bool {
    let p = relative_to(arc.center(), cubic.points);
    let v = cubic.hodograph();
    let side = if arc.is_clockwise() { -1.0 } else { 1.0 };
    let weights = [1.0, 3.0, 3.0, 1.0];
    let (mut squared, mut turning) = ([0.0; 7], [0.0; 6]);
    for (i, (pi, wi)) in p.iter().zip(weights).enumerate() {
        for (j, (pj, wj)) in p.iter().zip(weights).enumerate() {
            squared[i + j] += wi * wj * pi.dot(*pj);
        }
        for (j, (vj, wj)) in v.iter().zip([1.0, 2.0, 1.0]).enumerate() {
            turning[i + j] += wi * wj * side * cross(*pi, *vj);
        }
    }
    let inner = (arc.radius() - tolerance).max(0.0).powi(2);
    let outer = (arc.radius() + tolerance).powi(2);
    let near = squared.iter().zip([1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0]);
    turning.iter().all(|&turn| turn >= 0.0)
        && near.into_iter().all(|(&s, binomial)| (inner * binomial..=outer * binomial).contains(&s))
}
