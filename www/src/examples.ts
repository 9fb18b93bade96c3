// The examples of the gallery: programs with the settings they are shown with.

import type { Settings } from "./parameters";

/** One program of the gallery. */
export interface Example {
  readonly id: string;
  readonly name: string;
  readonly note: string;
  readonly text: string;
  readonly settings: Partial<Settings>;
}

/** The gallery; the page opens with the first. */
export const EXAMPLES: readonly Example[] = [
  {
    id: "rocker",
    name: "Rocker plate",
    note: "Lines, arcs and a spline; all three transitions",
    settings: { radius: 5 },
    text: `%
O0041 (ROCKER PLATE)
N10 G17 G21 G90
N20 G0 X-20 Y8
N30 G1 G41 D1 X0 Y18 F400 (LEAD-IN)
N40 Y42
N50 G2 X14 Y56 I14 J0
N60 G1 X26
N70 X35 Y40
N80 X44 Y56
N90 G05 X56 Y64 (TYPE POINTS)
N100 X70 Y57
N110 X80 Y39
N120 X102 Y34
N130 G1 X76 Y10
N140 X54 Y0
N150 G3 X26 Y0 I-14 J-4
N160 G1 X0
N170 Y18
N180 G40 X-20 Y28 (LEAD-OUT)
N190 M30
%
`,
  },
  {
    id: "cam",
    name: "Cam",
    note: "A lobe through type points on a base circle",
    settings: { radius: 5 },
    text: `%
O0020 (CAM WITH SPLINE LOBE)
N10 G17 G21 G90
N20 G0 X10 Y-44
N30 G1 G41 D1 X0 Y-20 F400
N40 G2 X-17.321 Y10 I0 J20
N50 G05 X-13.5 Y19.5
N60 X-7.5 Y31
N70 X0 Y36
N80 X7.5 Y31
N90 X13.5 Y19.5
N100 X17.321 Y10
N110 G2 X0 Y-20 I-17.321 J-10
N120 G1 G40 X-10 Y-44
N130 M30
%
`,
  },
  {
    id: "pocket",
    name: "Pocket",
    note: "Inside, with the tool on the right of the contour",
    settings: { radius: 4 },
    text: `%
O0042 (POCKET, TOOL ON THE RIGHT)
N10 G17 G21 G90
N20 G0 X72 Y24
N30 G1 G42 D1 X66 Y0 F300
N40 X56
N50 X48 Y24
N60 X40 Y0
N70 X10
N80 G2 X0 Y10 I0 J10
N90 G1 Y46
N100 G2 X10 Y56 I10 J0
N110 G05 X28 Y50
N120 X45 Y56
N130 X62 Y50
N140 X80 Y56
N150 G2 X90 Y46 I0 J-10
N160 G1 Y10
N170 G2 X80 Y0 I-10 J0
N180 G1 X66
N190 G40 X62 Y24
N200 M30
%
`,
  },
  {
    id: "star",
    name: "Star",
    note: "Acute corners, where moves are inserted",
    settings: { radius: 3 },
    text: `%
O0005 (STAR)
N10 G17 G21 G90
N20 G0 X-1 Y-38
N30 G1 G41 D1 X5.29 Y-18.531 F400
N40 X0 Y-15
N50 X-10.58 Y-22.062
N60 X-17.713 Y-16.88
N70 X-14.266 Y-4.635
N80 X-34.238 Y11.125
N90 X-8.817 Y12.135
N100 X0 Y36
N110 X8.817 Y12.135
N120 X34.238 Y11.125
N130 X14.266 Y-4.635
N140 X17.713 Y-16.88
N150 X10.58 Y-22.062
N160 X5.29 Y-18.531
N170 G40 X-8 Y-33.5
N180 M30
%
`,
  },
  {
    id: "ellipse",
    name: "Ellipse",
    note: "16 type points: compare both spline methods",
    settings: { radius: 8 },
    text: `%
O0016 (ELLIPSE THROUGH 16 TYPE POINTS)
N10 G17 G21 G90
N20 G0 X-66 Y-8
N30 G1 G41 D1 X-40 Y0 F400
N40 G05 X-36.955 Y9.184
N50 X-28.284 Y16.971
N60 X-15.307 Y22.173
N70 X0 Y24
N80 X15.307 Y22.173
N90 X28.284 Y16.971
N100 X36.955 Y9.184
N110 X40 Y0
N120 X36.955 Y-9.184
N130 X28.284 Y-16.971
N140 X15.307 Y-22.173
N150 X0 Y-24
N160 X-15.307 Y-22.173
N170 X-28.284 Y-16.971
N180 X-36.955 Y-9.184
N190 X-40 Y0
N200 G1 G40 X-66 Y8
N210 M30
%
`,
  },
  {
    id: "letter",
    name: "Letter",
    note: "An open contour",
    settings: { radius: 2 },
    text: `%
O0019 (LETTER S, OPEN CONTOUR)
N10 G17 G21 G90
N20 G0 X58 Y52
N30 G1 G41 D1 X44 Y54 F300
N40 Y46
N50 G05 X34 Y56
N60 X18 Y55
N70 X10 Y44
N80 X22 Y33
N90 X38 Y25
N100 X43 Y12
N110 X31 Y1
N120 X14 Y3
N130 X6 Y14
N140 G1 Y4
N150 G40 X-8 Y6
N160 M30
%
`,
  },
  {
    id: "slots",
    name: "Two slots",
    note: "Two contours in one program",
    settings: { radius: 4 },
    text: `%
O0012 (TWO SLOTS)
N10 G17 G21 G90
N20 G0 X30 Y10
N30 G1 G41 D1 Y0 F300
N40 X60
N50 G3 X60 Y20 I0 J10
N60 G1 X0
N70 G3 X0 Y0 I0 J-10
N80 G1 X30
N90 G40 Y10
N100 G0 X30 Y42
N110 G1 G41 D1 Y32
N120 X38
N130 G05 X50 Y34
N140 X62 Y31
N150 G3 X62 Y53 I0 J11
N160 G05 X45 Y57
N170 X30 Y54
N180 X15 Y57
N190 X0 Y53
N200 G3 X0 Y31 I0 J-11
N210 G05 X11 Y34
N220 X22 Y32
N230 G1 X30
N240 G40 Y42
N250 M30
%
`,
  },
  {
    id: "rooms",
    name: "Two rooms",
    note: "A corridor that the tool does not fit through: gouges, or what avoiding them leaves",
    settings: { radius: 5, gouge: "avoid" },
    text: `%
O0043 (TWO ROOMS AND A CORRIDOR)
N10 G17 G21 G90
N20 G0 X22 Y26 Z5
N30 G1 Z-2 F120
N40 G1 G41 D1 Y0 F400
N50 X34
N60 G3 X44 Y10 I0 J10
N70 G1 X42 Y22
N80 X64 Y21
N90 X62 Y0
N100 X92
N110 G05 X104 Y10
N120 X101 Y27
N130 X106 Y42
N140 X94 Y54
N150 G1 X60
N160 X63 Y29
N170 X43 Y30
N180 X46 Y44
N190 G3 X34 Y54 I-11 J-1
N200 G1 X28
N210 G3 X16 Y54 I-6 J0
N220 G1 X0
N230 Y0
N240 X22
N250 G40 Y26
N260 G0 Z5
N270 M30
%
`,
  },
];
