//! G05 and its namesakes: type points of a spline here, other curves and settings on controls.

use super::words::Words;

/// What a word of the G05 and G06 families means by the words beside it.
pub(super) enum SplineWord {
    /// G05: the block's axis words are a type point; without them only the mode begins.
    TypePoint,
    /// G05 I J P Q: a cubic Bézier curve of `LinuxCNC`.
    Cubic,
    /// G05.1 I J: a quadratic Bézier curve of `LinuxCNC`.
    Quadratic,
    /// G05.2: control points of a NURBS curve of `LinuxCNC`, until G05.3.
    Controls,
    /// G05.3.
    ControlsEnd,
    /// G06.1: FANUC's spline through points.
    Through,
    /// G06.2: a NURBS curve with its knots.
    Knots,
    /// A setting of the control without motion; what it is.
    Setting(&'static str),
    /// Smoothing by the control that changes the path; what it is.
    Smoothing(&'static str),
    /// It has no meaning.
    NotSupported(&'static str),
}

/// Tells the family apart by ten times the number of the word, and the words not used yet.
pub(super) fn spline_word(tenths: u32, words: &Words) -> SplineWord {
    let axes = words.has_any("XYZ");
    match tenths {
        50 => match (axes, words.has_any("P"), words.has_any("Q"), words.has_any("IJK")) {
            (_, false, false, false) => SplineWord::TypePoint,
            (false, true, false, false) => SplineWord::Setting("FANUC's high-speed mode (G05 P)"),
            (true, true, true, _) => SplineWord::Cubic,
            _ => SplineWord::NotSupported(
                "G05 with I, J, P or Q that is neither a type point, LinuxCNC's Bézier curve nor \
                 FANUC's high-speed mode",
            ),
        },
        51 if words.has_any("Q") && !words.has_any("IJK") => {
            if words.find('Q').is_some_and(|word| word.value == 2.0) {
                SplineWord::Smoothing("FANUC's smooth interpolation (G05.1 Q2)")
            } else {
                SplineWord::Setting("FANUC's contour control (G05.1 Q)")
            }
        }
        51 if axes => SplineWord::Quadratic,
        52 => SplineWord::Controls,
        53 => SplineWord::ControlsEnd,
        61 => SplineWord::Through,
        62 => SplineWord::Knots,
        _ => SplineWord::NotSupported("this form of G05"),
    }
}
