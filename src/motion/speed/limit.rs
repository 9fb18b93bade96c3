//! Limits at knots, and what they cost.

/// The weight of the barriers of limits that are broken: it draws `b` away from them.
pub(super) const DRAWN: f64 = 5.0;

/// What prices may differ by from those that the weight and the room ask for.
const PRICES: f64 = 10.0;

/// A limit: what it is, the most that it may be, and the price of that.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limit {
    pub(super) value: f64,
    pub(super) slack: f64,
    pub(super) price: f64,
}

impl Limit {
    /// The price after a step of a size by which the limit changed as it did: Newton's.
    pub(super) fn price(&self, weight: f64, size: f64, change: f64, even: f64) -> f64 {
        let room = self.slack - self.value;
        let next = self.price + size * (weight / room - self.price) + self.price / room * change;
        next.max(even / PRICES).min(PRICES * even.max(self.price))
    }
}

/// The weight of a limit's barrier.
pub(super) fn weight_of(slack: f64, weight: f64) -> f64 {
    if slack > 1.0 { weight.max(DRAWN) } else { weight }
}

/// Widens limits that are broken, and draws in those that were; `true` where none is wide.
pub(super) fn widen(limits: &mut [Limit], weight: f64) -> bool {
    let mut feasible = true;
    for limit in limits {
        let Limit { value, slack, price } = *limit;
        let wide = (1.1 * value).max(1.0 + 1.0e-6);
        limit.slack = if value < 1.0 {
            1.0
        } else if value < slack {
            slack.min(wide)
        } else {
            wide
        };
        if limit.slack != slack || price == 0.0 {
            limit.price = weight_of(limit.slack, weight) / (limit.slack - value);
        }
        feasible &= limit.slack <= 1.0;
    }
    feasible
}
