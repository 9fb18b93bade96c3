//! For whom a program is written, and what each of them knows: a table of facts.
//!
//! Facts are those of the controllers' own manuals and sources: grbl 1.1 and `grblHAL` (their
//! parsers), `LinuxCNC` (its G-code reference), Smoothieware in its CNC build, Marlin 2 with its
//! options as delivered, and the preparatory functions of FANUC's 0M, 6M and 30i, and the iTNC 530. A
//! word that is not in a table is never written for that target.

/// A controller that programs are written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Target {
    /// grbl 1.1, and with it every controller that reads plain G-code in millimetres.
    #[default]
    Grbl,
    /// `grblHAL`.
    GrblHal,
    /// `LinuxCNC`.
    LinuxCnc,
    /// Smoothieware, its CNC build.
    Smoothieware,
    /// Marlin 2.
    Marlin,
    /// FANUC 0M.
    Fanuc0M,
    /// FANUC 6M.
    Fanuc6M,
    /// FANUC 30i.
    Fanuc30I,
    /// Heidenhain's TNC controls, in their conversational language.
    Heidenhain,
}

impl Target {
    /// All of them, in the order in which they are offered.
    pub const ALL: [Self; 9] = [
        Self::Grbl,
        Self::GrblHal,
        Self::LinuxCnc,
        Self::Smoothieware,
        Self::Marlin,
        Self::Fanuc0M,
        Self::Fanuc6M,
        Self::Fanuc30I,
        Self::Heidenhain,
    ];

    pub(super) fn facts(self) -> &'static Facts {
        match self {
            Self::Grbl => &GRBL,
            Self::GrblHal => &GRBL_HAL,
            Self::LinuxCnc => &LINUX_CNC,
            Self::Smoothieware => &SMOOTHIEWARE,
            Self::Marlin => &MARLIN,
            Self::Fanuc0M => &FANUC_0M,
            Self::Fanuc6M => &FANUC_6M,
            Self::Fanuc30I => &FANUC_30I,
            Self::Heidenhain => &HEIDENHAIN,
        }
    }
}

/// What a controller knows, beside G0 to G3 and absolute millimetres, which all of them do.
#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is a fact of its own")]
pub(super) struct Facts {
    /// The blocks before the program: its modes.
    pub(super) header: &'static [&'static str],
    /// The block that chooses the coordinate system where the program says nothing about it.
    pub(super) frame: &'static str,
    /// Decimals of a coordinate in millimetres.
    pub(super) decimals: u32,
    /// Decimals of a feed in mm/min.
    pub(super) feed_decimals: u32,
    /// Whether a coordinate without a decimal point means thousandths.
    pub(super) point: bool,
    /// Whether a program stands between `%`, has a number (O) and numbers its blocks (N).
    pub(super) tape: bool,
    /// Whether a program that neither M2 nor M30 ends has to stand between `%`.
    pub(super) must_end: bool,
    /// Whether it speaks Heidenhain's language in place of G-code.
    pub(super) klartext: bool,
    /// Whether a motion word stays in effect; else each block repeats it.
    pub(super) modal: bool,
    /// Whether a block holds one command only.
    pub(super) single: bool,
    /// Whether it knows arcs in the planes G18 and G19.
    pub(super) planes: bool,
    /// Whether G5 is a cubic with I J from its start and P Q from its end.
    pub(super) splines: bool,
    /// Whether G2.2 and G3.2 are involutes with I J from their start and R.
    pub(super) involutes: bool,
    /// How it knows comments.
    pub(super) comments: Comments,
    /// The letter beside G4 that counts in seconds.
    pub(super) dwell: char,
    /// Whether it knows axes besides x, y and z: A, B, C, U, V and W, as its builder has them.
    pub(super) axes: bool,
    /// Whether it takes T words.
    pub(super) tools: bool,
    /// What stands for M6 where that is not known: the operator changes the tool and goes on.
    pub(super) pause: &'static str,
    /// Ten times the number of the other G words that it knows.
    pub(super) g: &'static [u16],
    /// The number of the M words that it knows; none means that the machine's builder says so.
    pub(super) m: &'static [u16],
}

/// How comments are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Comments {
    /// `(…)`, and `;…` to the end of the line.
    Both,
    /// `(…)` in capitals; `;` ends a block.
    Parentheses,
    /// `;…` alone.
    Semicolon,
}

impl Facts {
    pub(super) fn knows_g(&self, tenths: u32) -> bool {
        // What is written is absolute; G91 and G90 stand around G28 alone.
        let tenths = if matches!(tenths, 900 | 910) { 280 } else { tenths };
        self.g.iter().any(|&known| u32::from(known) == tenths)
    }

    pub(super) fn knows_m(&self, tenths: u32) -> bool {
        let knows = |number: u32| self.m.iter().any(|&known| u32::from(known) == number);
        self.m.is_empty() || tenths.is_multiple_of(10) && knows(tenths / 10)
    }
}

/// No length offset from a table, no tool change: T is read and M6 refused.
static GRBL: Facts = Facts {
    header: &["G21 G90 G17 G94"],
    frame: "",
    decimals: 4,
    feed_decimals: 3,
    point: false,
    tape: false,
    must_end: false,
    klartext: false,
    modal: true,
    single: false,
    planes: true,
    splines: false,
    involutes: false,
    comments: Comments::Both,
    dwell: 'P',
    axes: false,
    tools: true,
    pause: "M0",
    g: &[
        40, 100, 280, 281, 300, 301, 382, 383, 384, 385, 431, 490, 530, 540, 550, 560, 570, 580,
        590, 610, 920, 921,
    ],
    m: &[0, 1, 2, 3, 4, 5, 8, 9, 30],
};

static GRBL_HAL: Facts = Facts {
    header: &["G21 G90 G91.1 G17 G40 G94"],
    splines: true,
    axes: true,
    g: &[
        40, 100, 280, 281, 300, 301, 330, 382, 383, 384, 385, 430, 431, 432, 490, 530, 540, 550,
        560, 570, 580, 590, 591, 592, 593, 610, 760, 920, 921, 922, 923,
    ],
    m: &[
        0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 30, 48, 49, 50, 51, 53, 56, 60, 61, 62, 63, 64, 65, 66, 67,
        68, 70, 71, 72, 73,
    ],
    ..GRBL
};

static LINUX_CNC: Facts = Facts {
    must_end: true,
    header: &["G21 G90 G91.1 G17 G40 G94"],
    splines: true,
    axes: true,
    g: &[
        40, 70, 80, 100, 280, 281, 300, 301, 330, 331, 382, 383, 384, 385, 760, 400, 410, 411, 420,
        421, 430, 431, 432, 490, 530, 540, 550, 560, 570, 580, 590, 591, 592, 593, 610, 611, 640,
        920, 921, 922, 923, 960, 970,
    ],
    // With the user's own M100 to M199.
    m: &[],
    ..GRBL
};

/// In its CNC build, which counts P of G4 in seconds and takes G28 for a place; S is seconds in
/// every build. G30 probes, M30 outside that build deletes a file, M600 waits for the operator.
static SMOOTHIEWARE: Facts = Facts {
    header: &["G21 G90 G17"],
    dwell: 'S',
    tools: false,
    pause: "M600",
    axes: true,
    g: &[40, 100, 280, 382, 383, 530, 540, 550, 560, 570, 580, 590, 591, 592, 593, 920, 921, 923],
    m: &[2, 3, 5, 7, 8, 9, 600],
    ..GRBL
};

/// As delivered: planes, coordinate systems and G5 are options of its build. G28 seeks the end
/// switches, G30 probes, G61 returns to a stored place, M30 deletes a file: none of them is meant.
static MARLIN: Facts = Facts {
    header: &["G21", "G90"],
    modal: false,
    single: true,
    planes: false,
    splines: true,
    comments: Comments::Semicolon,
    dwell: 'S',
    tools: false,
    g: &[40, 920],
    m: &[0, 1, 3, 4, 5, 7, 8, 9],
    ..GRBL
};

/// Least increment 0.001 mm, feeds in whole mm/min; work coordinate systems G54 to G59.
static FANUC_0M: Facts = Facts {
    header: &["G21 G17 G40 G49 G80 G90"],
    frame: "G54",
    decimals: 3,
    feed_decimals: 0,
    point: true,
    tape: true,
    comments: Comments::Parentheses,
    dwell: 'X',
    axes: true,
    g: &[
        40, 90, 100, 270, 280, 290, 300, 310, 330, 390, 400, 410, 420, 430, 440, 490, 530, 540,
        550, 560, 570, 580, 590, 610, 630, 640, 920,
    ],
    m: &[],
    ..GRBL
};

/// The older control: its origin is set where the tool stands, by G92; G54 to G59 are an option.
static FANUC_6M: Facts = Facts {
    frame: "G92 X0. Y0. Z0.",
    g: &[
        40, 90, 100, 270, 280, 290, 300, 390, 400, 410, 420, 430, 440, 490, 540, 550, 560, 570,
        580, 590, 610, 640, 920,
    ],
    ..FANUC_0M
};

/// Involutes are what it is here for; its other words are those of the 0M.
static FANUC_30I: Facts = Facts { involutes: true, ..FANUC_0M };

/// As the iTNC 530 knows them. Its place of work is chosen on the machine, lengths come with the tool,
/// and the last radius of a tool is that of its call.
static HEIDENHAIN: Facts = Facts {
    header: &[],
    klartext: true,
    splines: true,
    comments: Comments::Semicolon,
    axes: true,
    g: &[40, 400, 410, 420, 530],
    m: &[],
    ..GRBL
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_known_by_their_whole_number() {
        assert!(GRBL.knows_g(540) && !GRBL.knows_g(541), "G54, not G54.1");
        assert!(
            GRBL.knows_m(30) && !GRBL.knows_m(60) && !GRBL.knows_m(35),
            "M3, neither M6 nor M3.5"
        );
        assert!(FANUC_0M.knows_m(60) && LINUX_CNC.knows_m(1230), "what the builder says");
    }
}
