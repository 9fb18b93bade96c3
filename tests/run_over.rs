//! Programs whose contours run in and out: along arcs that touch the part, or past its corners. What
//! runs in or out is air, and the part is made to its size.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::{GougePolicy, Options};
use g41::contour::{Role, ToolPath};
use g41::diagnostic::Severity;
use g41::program::{Dialect, Interpretation, Program, Rules, interpret};
use g41::simulation::{Profile, Tools, check_program, compensate_program};
use glam::{DVec2, dvec2};

/// A plate of 80 by 60 mm, begun before a corner and ended behind it.
const PLATE: &str =
    "G21 G90\nG0 X-30 Y-20\nG1 G41 D1 X0 Y-5 F400\nY60\nX80\nY0\nX-10\nG40 X-30 Y-20\n";

/// A pocket of 50 by 30 mm with round corners, come to and left along arcs that touch its lower wall.
const POCKET: &str = "G21 G90\nG0 X25 Y15\nG1 G41 D1 X20 Y5 F600\nG3 X25 Y0 I5\nG1 X45\nG3 X50 Y5 J5\n\
    G1 Y25\nG3 X45 Y30 I-5\nG1 X5\nG3 X0 Y25 J-5\nG1 Y5\nG3 X5 Y0 I5\nG1 X25\nG3 X30 Y5 J5\nG1 G40 X25 Y15\n";

/// The same, left 4 mm behind where it was come to, with coordinates that are rounded.
const OVERLAP: &str = "G21 G90\nG0 X25 Y15\nG1 G41 D1 X20.0005 Y5 F600\nG3 X25 Y0.001 I5\nG1 X45 Y0\n\
    G3 X50 Y5 J5\nG1 Y25\nG3 X45 Y30 I-5\nG1 X5\nG3 X0 Y25 J-5\nG1 Y5\nG3 X5 Y0 I5\nG1 X29\n\
    G3 X34 Y5 J5\nG1 G40 X25 Y15\n";

fn read(text: &str) -> Interpretation {
    interpret(&Program::parse(text, Dialect::Auto), Rules::default())
}

fn path_of(text: &str, radius: f64, gouge: GougePolicy) -> ToolPath {
    let options = Options { gouge, ..Options::default() };
    compensate_program(&read(text), &Tools::all(radius), &options)
}

/// The greatest distance of points of the walls of a rectangle, corners rounded off, from a path.
fn farthest_from_wall(path: &ToolPath, points: &[DVec2]) -> f64 {
    let mut farthest: f64 = 0.0;
    for &point in points {
        let mut nearest = f64::INFINITY;
        for step in &path.moves {
            if step.role != Role::Free {
                nearest = nearest.min(step.curve.nearest(point).distance);
            }
        }
        farthest = farthest.max(nearest);
    }
    farthest
}

#[test]
fn what_runs_in_and_out_is_no_wall() {
    for text in [PLATE, POCKET, OVERLAP] {
        for gouge in [GougePolicy::Report, GougePolicy::Stop, GougePolicy::Avoid] {
            let tools = Tools::all(2.0);
            let path = path_of(text, 2.0, gouge);
            assert_eq!(path.diagnostics, [], "{gouge:?} of {text}");
            assert_eq!(path.gouges, [], "{gouge:?} of {text}");
            assert_eq!(check_program(&read(text), &path, &tools, 1e-3), [], "{gouge:?} of {text}");
        }
    }
}

#[test]
fn avoiding_leaves_nothing_of_the_walls_beside_the_ways_in_and_out() {
    let mut plate = Vec::new();
    let mut pocket = Vec::new();
    for k in 0..=40 {
        let share = f64::from(k) / 40.0;
        plate.extend([dvec2(0.0, 60.0 * share), dvec2(80.0 * share, 0.0)]);
        pocket.extend([dvec2(5.0 + 40.0 * share, 0.0), dvec2(0.0, 5.0 + 20.0 * share)]);
    }
    for (text, points) in [(PLATE, &plate), (POCKET, &pocket), (OVERLAP, &pocket)] {
        let path = path_of(text, 2.0, GougePolicy::Avoid);
        let farthest = farthest_from_wall(&path, points);
        assert!(farthest <= 2.0 + 2e-3, "{farthest} mm of {text}");
        assert!(path.uncut.is_empty(), "{text}: {:?}", path.uncut);
    }
}

#[test]
fn where_nothing_is_in_the_way_avoiding_follows_the_same_path() {
    for text in [PLATE, POCKET] {
        let report = path_of(text, 2.0, GougePolicy::Report);
        let avoid = path_of(text, 2.0, GougePolicy::Avoid);
        for step in report.moves.iter().chain(&avoid.moves) {
            for (k, others) in [&report, &avoid].into_iter().enumerate() {
                let at = step.curve.point(0.5);
                let distance = |other: &g41::contour::Move| other.curve.nearest(at).distance;
                let nearest = others.moves.iter().map(distance).fold(f64::INFINITY, f64::min);
                // Round outside corners avoidance may take an arc.
                assert!(nearest < 0.9, "{k}: {nearest} mm at {at} of {text}");
            }
        }
        let pieces = |path: &ToolPath| {
            let gaps = path.moves.windows(2);
            gaps.filter(|pair| pair[0].curve.end().distance(pair[1].curve.start()) > 1e-6).count()
        };
        assert_eq!([pieces(&report), pieces(&avoid)], [0, 0], "{text} in one piece");
    }
}

#[test]
fn ends_that_cross_in_the_part_still_cut_it() {
    // The tool inside the plate's outline: before and behind the crossing lies the part.
    let inside = PLATE.replace("G41", "G42");
    let tools = Tools::all(4.0);
    let path = path_of(&inside, 4.0, GougePolicy::Report);
    assert!(!path.gouges.is_empty(), "the ways in and out cut the walls");
    assert!(
        !check_program(&read(&inside), &path, &tools, 1e-3).is_empty(),
        "and so says the judge"
    );
}

#[test]
fn what_cuts_elsewhere_is_told_beside_what_runs_over() {
    // A notch of 6 mm in the upper edge.
    let notch = PLATE.replace("X80\nY0", "X37\nY50\nX43\nY60\nX80\nY0");
    let path = path_of(&notch, 4.0, GougePolicy::Report);
    assert!(!path.gouges.is_empty(), "the notch is too narrow");
    for gouge in &path.gouges {
        assert!(gouge.at.y >= 40.0, "nothing at the ends: {gouge:?}");
    }
    assert!(path.diagnostics.iter().any(|found| found.severity == Severity::Error), "as an error");
    let avoided = path_of(&notch, 4.0, GougePolicy::Avoid);
    assert!(!avoided.uncut.is_empty(), "the notch stays uncut");
    assert_eq!(check_program(&read(&notch), &avoided, &Tools::all(4.0), 1e-3), [], "and whole");
}

#[test]
fn a_control_with_one_block_of_look_ahead_warns_of_no_more() {
    for text in [PLATE, POCKET, OVERLAP] {
        let read = interpret(&Program::parse(text, Dialect::Auto), Profile::LinuxCnc.rules());
        let path = compensate_program(&read, &Tools::all(2.0), &Profile::LinuxCnc.options());
        assert_eq!(path.diagnostics, [], "{text}");
    }
}

#[test]
fn a_way_in_beside_the_last_wall_takes_nothing_of_it() {
    // In inches, rounded: the lead-out's arc is a hair off the tangent. The lead-in is nearer to where
    // the last wall is cut than the tool's radius, and air.
    let text = "G20 G90\nG0 X-.80709 Y-.01969\nG1 G41 D1 Y.09843 F20\nG3 X-.98425 Y.27559 I-.17716\n\
        G1 X-1.5748\nY1.85039\nX0\nY.27559\nX-.98425\nG3 X-1.16142 Y.09843 J-.17716\nG40 G1 Y-.01969\n";
    let points: Vec<DVec2> = (0..=40).map(|k| dvec2(-f64::from(k), 7.0)).collect();
    for radius in [1.0, 2.0, 3.0, 4.0] {
        let path = path_of(text, radius, GougePolicy::Avoid);
        let farthest = farthest_from_wall(&path, &points);
        assert!(farthest <= radius + 2e-3, "{farthest} mm by {radius}");
        let gap = |pair: &[g41::contour::Move]| pair[0].curve.end().distance(pair[1].curve.start());
        assert!(path.moves.windows(2).all(|pair| gap(pair) < 1e-6), "one piece by {radius}");
    }
}
