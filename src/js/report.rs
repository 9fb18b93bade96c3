//! Reports as JSON: diagnostics, transitions, gouges and what is uncut.
//!
//! Each is taken apart field by field and matched variant by variant, so that what is added to the
//! core does not compile here until it is passed on.

use super::json::{Object, list};
use super::numbering::{Numbering, Place};
use crate::contour::{Gouge, GougeKind, PathLoop, Transition, TransitionKind, Uncut};
use crate::diagnostic::{Diagnostic, Origin, Severity};
use crate::motion::{Peak, Violations};

/// `Diagnostic[]` of `types.d.ts` as JSON.
#[must_use]
pub fn diagnostics_json(diagnostics: &[Diagnostic], numbering: &Numbering) -> String {
    list(diagnostics, |object, diagnostic| {
        let Diagnostic { severity, code, message, hint, at, origin, depth, segments } = diagnostic;
        object.text(
            "severity",
            match severity {
                Severity::Info => "info",
                Severity::Warning => "warning",
                Severity::Error => "error",
            },
        );
        object.text("code", code);
        object.text("message", message);
        if let Some(hint) = hint {
            object.text("hint", hint);
        }
        if let Some(at) = at {
            object.point("at", *at);
        }
        if let Some(origin) = origin {
            object.object("origin", |inner| write_origin(inner, *origin, numbering));
        }
        if let Some(depth) = depth {
            object.number("depth", *depth);
        }
        if !segments.is_empty() {
            write_segments(object, segments, numbering);
        }
    })
}

/// `Transition[]` of `types.d.ts` as JSON.
#[must_use]
pub fn transitions_json(transitions: &[Transition], numbering: &Numbering) -> String {
    list(transitions, |object, transition| {
        let Transition { kind, angle, corner, construction, origin } = transition;
        object.text(
            "kind",
            match kind {
                TransitionKind::Shortened => "shortened",
                TransitionKind::Elongated => "elongated",
                TransitionKind::Inserted => "inserted",
            },
        );
        object.number("angle", *angle);
        object.point("corner", *corner);
        object.object("construction", |inner| {
            for (name, point) in construction {
                inner.point(name, *point);
            }
        });
        object.object("origin", |inner| write_origin(inner, *origin, numbering));
    })
}

/// `Gouge[]` of `types.d.ts` as JSON.
#[must_use]
pub fn gouges_json(gouges: &[Gouge], numbering: &Numbering) -> String {
    list(gouges, |object, gouge| {
        let Gouge { kind, at, depth, segments } = gouge;
        object.text(
            "kind",
            match kind {
                GougeKind::Curvature => "curvature",
                GougeKind::Bottleneck => "bottleneck",
            },
        );
        object.point("at", *at);
        object.number("depth", *depth);
        write_segments(object, segments, numbering);
    })
}

/// `Uncut[]` of `types.d.ts` as JSON, with the number of vertices in the place of each outline.
#[must_use]
pub fn uncut_json(uncut: &[Uncut], numbering: &Numbering) -> String {
    list(uncut, |object, region| {
        let Uncut { outline, area, segments } = region;
        object.number("vertices", outline.len() as f64);
        object.number("area", *area);
        write_segments(object, segments, numbering);
    })
}

/// `PathLoop[]` of `types.d.ts` as JSON.
#[must_use]
pub fn loops_json(loops: &[PathLoop]) -> String {
    list(loops, |object, one| {
        let PathLoop { first_move, moves_end, pass, parent } = one;
        object.number("from", *first_move as f64);
        object.number("to", *moves_end as f64);
        object.number("pass", (*pass).into());
        if let Some(parent) = parent {
            object.number("parent", *parent as f64);
        }
    })
}

/// A limit counts as broken where more than this part is beyond it: 1.000 of it is allowed.
const SLACK: f64 = 5.0e-4;

/// The end counts as missed from here on [mm].
const MISSED: f64 = 1.0e-9;

/// `Violation[]` of `types.d.ts` as JSON, of a motion that ends at `duration` [s].
#[must_use]
pub fn violations_json(violations: &Violations, duration: f64) -> String {
    let Violations {
        velocity,
        feed,
        acceleration,
        jerk,
        jerk_change,
        axes,
        deviation,
        chord_error,
        end,
    } = violations;
    let end = Peak { value: *end, limit: MISSED, time: duration };
    let mut peaks = vec![
        ("velocity", velocity),
        ("feed", feed),
        ("acceleration", acceleration),
        ("jerk", jerk),
        ("snap", jerk_change),
        ("cornerDeviation", deviation),
        ("chordError", chord_error),
        ("end", &end),
    ];
    for of_axis in axes {
        let names = ["axes.velocity", "axes.acceleration", "axes.jerk"];
        peaks.extend(names.into_iter().zip(of_axis));
    }
    // What is not a number is broken too.
    peaks.retain(|(_, peak)| peak.value.is_nan() || peak.ratio() > 1.0 + SLACK);
    list(peaks, |object, (name, Peak { value, limit, time })| {
        object.text("limit", name);
        object.number("value", if value.is_finite() { *value } else { f64::MAX });
        object.number("allowed", *limit);
        object.number("time", *time);
    })
}

fn write_segments(object: &mut Object<'_>, segments: &[Origin], numbering: &Numbering) {
    object.list("segments", segments, |inner, origin| write_origin(inner, *origin, numbering));
}

/// The fields of an `Origin` of `types.d.ts`.
pub(super) fn write_origin(object: &mut Object<'_>, origin: Origin, numbering: &Numbering) {
    match origin {
        Origin::Block { line, number, column } => {
            object.number("block", line.into());
            if let Some(number) = number {
                object.number("number", number.into());
            }
            if let Some(column) = column {
                object.number("column", column.into());
            }
        }
        Origin::Segment(number) => {
            let Place { contour, segment } = numbering.place(number);
            object.number("segment", segment.into());
            if let Some(contour) = contour {
                object.number("contour", contour.into());
            }
        }
    }
}
