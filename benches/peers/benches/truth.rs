//! Pieces per type point and true errors, beside kurbo's: `cargo bench --package peers --bench truth`.
//! A number as argument leaves out curves of more type points.

fn main() {
    let largest = std::env::args().find_map(|argument| argument.parse().ok());
    peers::truth::table(largest.unwrap_or(usize::MAX));
}
