//! The tool: its radius, and the side of the contour on which it runs.

/// The side of the contour on which the tool runs, seen along the direction of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// To the left of the contour: G41.
    Left,
    /// To the right of the contour: G42.
    Right,
}

impl Side {
    /// σ: +1 for left, −1 for right. The tool centre of a contour point `P` with left normal `N`
    /// is `P + σ r N`.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// The other side.
    #[must_use]
    pub fn opposite(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// A cylindrical tool on one side of the contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tool {
    radius: f64,
    side: Side,
}

impl Tool {
    /// A tool of `radius` [mm] on `side`. A negative radius means the other side, as on every
    /// control; `None` for a radius that is not a number of at most
    /// [`MAX_COORDINATE`](crate::geometry::MAX_COORDINATE).
    #[must_use]
    pub fn new(radius: f64, side: Side) -> Option<Self> {
        if radius.is_nan() || radius.abs() > crate::geometry::MAX_COORDINATE {
            return None;
        }
        let side = if radius < 0.0 { side.opposite() } else { side };
        Some(Self { radius: radius.abs(), side })
    }

    /// The same side with radius zero: the path is the contour.
    #[must_use]
    pub fn without_radius(&self) -> Self {
        Self { radius: 0.0, side: self.side }
    }

    /// Tool radius [mm]: zero or positive.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The side on which it runs.
    #[must_use]
    pub fn side(&self) -> Side {
        self.side
    }

    /// σ r: the offset of the tool centre from the contour [mm], positive to the left.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.side.sign() * self.radius
    }
}
