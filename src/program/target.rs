//! For whom a program is written.

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
    /// Smoothieware.
    Smoothieware,
    /// Marlin 2.
    Marlin,
    /// FANUC 0M.
    Fanuc0M,
    /// FANUC 6M.
    Fanuc6M,
    /// Heidenhain, in its conversational language.
    Heidenhain,
}

impl Target {
    /// All of them, in the order in which they are offered.
    pub const ALL: [Self; 8] = [
        Self::Grbl,
        Self::GrblHal,
        Self::LinuxCnc,
        Self::Smoothieware,
        Self::Marlin,
        Self::Fanuc0M,
        Self::Fanuc6M,
        Self::Heidenhain,
    ];

    /// Its name as an option.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Grbl => "grbl",
            Self::GrblHal => "grblhal",
            Self::LinuxCnc => "linuxcnc",
            Self::Smoothieware => "smoothieware",
            Self::Marlin => "marlin",
            Self::Fanuc0M => "fanuc-0m",
            Self::Fanuc6M => "fanuc-6m",
            Self::Heidenhain => "heidenhain",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_target_has_a_name_of_its_own() {
        for (i, target) in Target::ALL.into_iter().enumerate() {
            assert!(Target::ALL[..i].iter().all(|t| t.name() != target.name()), "{target:?}");
        }
    }
}
