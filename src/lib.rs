//! Tool radius compensation of contours made of lines, arcs and splines through type points.
//!
//! A mill's program describes the part; the centre of the tool must run beside it, at the distance
//! of the tool radius. G41 (tool on the left) and G42 (on the right) ask a control to compute that
//! path. This crate computes it for lines, arcs *and splines*, classifies each corner, reports
//! where the tool does not fit, and gives the path back as moves.
//!
//! ```
//! use g41::compensation::{Options, compensate};
//! use g41::contour::{Attributes, ContourBuilder, Shape, Side, SplineShape, Tool};
//! use g41::diagnostic::Origin;
//! use glam::dvec2;
//!
//! let mut builder = ContourBuilder::new(dvec2(0.0, 0.0));
//! let at = |index| Attributes::at(Origin::Segment(index));
//! builder.segment(Shape::Line { to: dvec2(10.0, 0.0) }, at(0));
//! let points = vec![dvec2(14.0, 2.0), dvec2(16.0, 8.0), dvec2(12.0, 12.0)];
//! builder.segment(Shape::Spline(SplineShape { points, ..SplineShape::default() }), at(1));
//! let contour = builder.build(false).contour.expect("every segment has a length");
//!
//! let tool = Tool::new(3.0, Side::Right).expect("3 mm is a radius");
//! let path = compensate(&contour, tool, &Options::default());
//! assert_eq!(path.moves[0].curve.start(), dvec2(0.0, -3.0));
//! ```
//!
//! # Corners
//!
//! Where two segments meet, their offsets overlap or gape. With the angle α on the workpiece side
//! there are three transitions:
//!
//! <svg viewBox="0 0 630 190" role="img" aria-label="Shortened, elongated and inserted transition"
//!  style="max-width:630px" fill="none" stroke="currentColor" stroke-width="1.5" font-size="14">
//! <g><path d="M10 130H130V20"/><path d="M10 90H90V20" stroke="#0a7d5a" stroke-width="2.5"/>
//! <circle cx="90" cy="90" r="40" stroke-dasharray="4 3"/><circle cx="90" cy="90" r="2.5" fill="#0a7d5a"/>
//! <text x="96" y="84" fill="currentColor" stroke="none">V</text><text x="134" y="146" fill="currentColor" stroke="none">P</text>
//! <text x="10" y="182" fill="currentColor" stroke="none">Shortened, π ≤ α ≤ 2π</text></g>
//! <g transform="translate(220 0)"><path d="M10 110H90L130 150"/>
//! <path d="M10 70H106.6L158.3 121.7" stroke="#0a7d5a" stroke-width="2.5"/>
//! <circle cx="106.6" cy="70" r="2.5" fill="#0a7d5a"/><path d="M90 110V70M90 110L118.3 81.7" stroke-dasharray="4 3"/>
//! <text x="112" y="64" fill="currentColor" stroke="none">V</text><text x="76" y="128" fill="currentColor" stroke="none">P</text>
//! <text x="10" y="182" fill="currentColor" stroke="none">Elongated, π/2 ≤ α &lt; π</text></g>
//! <g transform="translate(430 0)"><path d="M10 90H90L30 150"/>
//! <path d="M10 50H130L146.6 90L78.3 158.3" stroke="#0a7d5a" stroke-width="2.5"/>
//! <circle cx="130" cy="50" r="2.5" fill="#0a7d5a"/><circle cx="146.6" cy="90" r="2.5" fill="#0a7d5a"/>
//! <path d="M90 90V50M90 90L118.3 118.3" stroke-dasharray="4 3"/>
//! <text x="134" y="44" fill="currentColor" stroke="none">A1</text><text x="152" y="94" fill="currentColor" stroke="none">A2</text>
//! <text x="74" y="106" fill="currentColor" stroke="none">P</text>
//! <text x="10" y="182" fill="currentColor" stroke="none">Inserted, 0 ≤ α &lt; π/2</text></g>
//! </svg>
//!
//! [`contour::Corner`] tells which one a corner takes; `src/compensation/transition` has a file for
//! each of them, and [`geometry::intersect`] one for each pair of curves.
//!
//! # Signs and units
//!
//! Lengths are in mm, times in s, angles in rad, feeds in mm/s. Angles and sweeps are positive
//! counter-clockwise. The left normal of a unit tangent `T` is `N = (-Ty, Tx)`; curvature κ is
//! positive where a curve turns left. σ is +1 for a tool on the left and −1 on the right: the tool
//! centre of a contour point `P` is `P + σ r N`, and an offset δ is positive to the left. The turn
//! at a corner is `φ ∈ (−π, π]`, positive to the left, and `α = π + σφ`.
//!
//! # Floors
//!
//! Each module knows the ones below it and none above; modules on one floor do not know each
//! other. `tests/architecture.rs` checks it.
//!
//! | floor | modules | what they must not know |
//! | --- | --- | --- |
//! | 6 | `js` (features `js`, `contour-js`) | nothing hidden: it converts, calls, converts |
//! | 5 | [`simulation`] | the text of a program |
//! | 4 | [`program`], [`compensation`], [`gouge`], [`motion`] | each other; `compensation` knows no G-code, `gouge` judges its paths without sharing its code, and `motion` asks no path where it came from |
//! | 3 | [`contour`] | how a contour becomes a path |
//! | 2 | [`geometry`] | that tools exist |
//! | 1 | [`diagnostic`] | everything |
//!
//! Parsing and compensating never fail as a whole: they return what they could do *and*
//! [diagnostics](diagnostic::Diagnostic) with place and advice.
//!
//! # Sources
//!
//! * "Tool radius compensation algorithm of spline curve": transitions between lines, arcs and
//!   splines, lead-in and lead-out, and the type-point method of [`compensation::SplineMethod`].
//! * CN patent, Fujian University of Technology, 2013, "Numerical control system-based tool radius
//!   compensation vector calculating method": the kind of a transition from the tangents alone.
//! * C. de Boor, "A Practical Guide to Splines": the C2 cubic through points.
//! * E. T. Y. Lee, "Choosing nodes in parametric curve interpolation", 1989: centripetal spacing.
//! * N. M. Patrikalakis and T. Maekawa, "Shape Interrogation for Computer Aided Design and
//!   Manufacturing", ch. 11: offsets, their curvature and their cusps.
//! * R. T. Farouki, "Pythagorean-Hodograph Curves", 2008: curves whose arc length is a polynomial,
//!   which round corners in [`motion`].
//! * K. M. Bolton, "Biarc curves", 1975: arcs through points and tangents.
//! * S. Boyd and others, "Distributed Optimization and Statistical Learning via the Alternating
//!   Direction Method of Multipliers", 2011, section 3: the smoothest spline inside a tube.

pub mod compensation;
pub mod contour;
pub mod diagnostic;
pub mod geometry;
pub mod gouge;
#[cfg(feature = "contour-js")]
pub mod js;
pub mod motion;
pub mod program;
pub mod simulation;
