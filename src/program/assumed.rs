//! Where a control is whose origins, reference points and lengths of tools were all zero when the
//! program began, as they are in a fresh `LinuxCNC`.
//!
//! The numbers of places are as certain as that; what the machine has to be told again, since its
//! zeros are elsewhere, is decided apart from them.

use glam::{DVec2, DVec3};

use crate::geometry::rotate;

/// The numbers between the machine's coordinates and those of the program.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Assumed {
    /// The origins of G54 to G59.3 [mm], and by how much their axes are turned in x and y [rad].
    pub(super) origins: [(DVec3, f64); 9],
    /// What G92 takes off, and what G92.3 would [mm].
    pub(super) shift: DVec3,
    pub(super) kept: DVec3,
    /// The length of the tool, as G43.1 gave it [mm].
    pub(super) tool: DVec3,
    /// Where G28 and G30 lead [mm].
    pub(super) homes: [DVec3; 2],
}

impl Assumed {
    fn origin(&self, system: Option<usize>) -> (DVec3, f64) {
        self.origins.get(system.unwrap_or(0)).copied().unwrap_or_default()
    }

    /// The machine's coordinates of a place in a system.
    pub(super) fn machine(&self, system: Option<usize>, place: DVec3) -> DVec3 {
        let (origin, angle) = self.origin(system);
        turned(place + self.shift, angle) + origin + self.tool
    }

    /// The coordinates in a system of a place of the machine.
    pub(super) fn place(&self, system: Option<usize>, machine: DVec3) -> DVec3 {
        let (origin, angle) = self.origin(system);
        turned(machine - self.tool - origin, -angle) - self.shift
    }

    /// G10 L20: the origin of a system by the numbers that a place of the machine is to have in it.
    pub(super) fn set_by_place(&mut self, system: usize, machine: DVec3, given: [Option<f64>; 3]) {
        let mut numbers = self.place(Some(system), machine);
        for (number, given) in numbers.as_mut().iter_mut().zip(given) {
            *number = given.unwrap_or(*number);
        }
        let moved = machine - self.machine(Some(system), numbers);
        if let Some((origin, _)) = self.origins.get_mut(system) {
            *origin += moved;
        }
    }
}

pub(super) fn turned(place: DVec3, angle: f64) -> DVec3 {
    if angle == 0.0 {
        return place;
    }
    rotate(DVec2::new(place.x, place.y), angle).extend(place.z)
}
