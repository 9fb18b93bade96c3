//! Offsets of glyphs and icons beside Clipper2's, by area: `node scripts/outlines.mjs`.
//!
//! Arguments: a file of icons, a name and an SVG outline on each line; then files of fonts. A number
//! takes only every so-manieth outline.

use std::collections::BTreeMap;
use std::fs;

use kurbo::{BezPath, Point};
use peers::outlines::{Outline, Refused, counted};
use peers::race::now;
use ttf_parser::{Face, OutlineBuilder};

/// Extent of every outline, and radii [mm]: from a fine engraver to a tool that fits nowhere.
const SIZE: f64 = 100.0;
const RADII: [f64; 4] = [0.5, 2.0, 5.0, 12.0];

#[derive(Default)]
struct Pen(BezPath);

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to((f64::from(x), f64::from(y)));
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to((f64::from(x), f64::from(y)));
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let at = |x, y| Point::new(f64::from(x), f64::from(y));
        self.0.quad_to(at(x1, y1), at(x, y));
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let at = |x, y| Point::new(f64::from(x), f64::from(y));
        self.0.curve_to(at(x1, y1), at(x2, y2), at(x, y));
    }
    fn close(&mut self) {
        self.0.close_path();
    }
}

/// The printable characters of ASCII in a font.
fn glyphs(file: &str) -> Vec<(String, BezPath)> {
    let data = fs::read(file).expect("a font");
    let face = Face::parse(&data, 0).expect("a font");
    let name = file.rsplit('/').next().unwrap_or(file).trim_end_matches(".ttf");
    ('!'..='~')
        .filter_map(|letter| {
            let mut pen = Pen::default();
            face.outline_glyph(face.glyph_index(letter)?, &mut pen)?;
            Some((format!("{name} {letter}"), pen.0))
        })
        .collect()
}

fn icons(file: &str) -> Vec<(String, BezPath)> {
    let text = fs::read_to_string(file).expect("a list of icons");
    text.lines()
        .filter_map(|line| {
            let (name, outline) = line.split_once(' ')?;
            Some((name.into(), BezPath::from_svg(outline).ok()?))
        })
        .collect()
}

/// Counts of one radius.
#[derive(Default)]
struct Row {
    compared: u32,
    differing: u32,
    gouged: u32,
    worst: f64,
    mean: f64,
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    let step = arguments.iter().find_map(|a| a.parse().ok()).unwrap_or(1);
    let files = arguments.iter().filter(|a| a.parse::<usize>().is_err());
    let mut rows: BTreeMap<(&str, i64), Row> = BTreeMap::new();
    let mut refused: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    let mut taken = [0.0; 2];
    let mut listed = Vec::new();
    for file in files {
        let (kind, outlines) =
            if file.ends_with(".ttf") { ("glyphs", glyphs(file)) } else { ("icons", icons(file)) };
        for (name, path) in outlines.into_iter().step_by(step) {
            let outline = match Outline::new(&name, &path, SIZE) {
                Ok(outline) => outline,
                Err(Refused::Empty) => continue,
                Err(Refused::Overlapping) => {
                    refused.entry(kind).or_default().push(name);
                    continue;
                }
            };
            for radius in RADII {
                for distance in [radius, -radius] {
                    let start = now();
                    let compared = outline.compared(distance);
                    taken[0] += now() - start;
                    let [ours, theirs] = compared.areas;
                    let off = (ours - theirs).abs() / compared.allowed;
                    #[expect(clippy::cast_possible_truncation, reason = "tenths of a millimetre")]
                    let row = rows.entry((kind, (10.0 * distance) as i64)).or_default();
                    row.compared += 1;
                    row.mean += off;
                    row.worst = row.worst.max(off);
                    row.gouged += u32::from(compared.gouge > 0.0);
                    row.differing += u32::from(off > 1.0);
                    if off > 1.0 || compared.gouge > 0.0 {
                        listed.push(format!(
                            "| {name} | {distance} | {ours:.3} | {theirs:.3} | {:.4} | {:.1} | {} | {:.1e} |",
                            ours - theirs,
                            counted(&outline, distance),
                            compared.open,
                            compared.gouge
                        ));
                    }
                }
            }
        }
    }
    println!("areas of offset regions, g41 against Clipper2; differences in what tolerances allow");
    println!("| outlines | offset | compared | mean difference | worst | differing | gouged |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for ((kind, tenths), row) in &rows {
        println!(
            "| {kind} | {:.1} | {} | {:.3} | {:.3} | {} | {} |",
            *tenths as f64 / 10.0,
            row.compared,
            row.mean / f64::from(row.compared),
            row.worst,
            row.differing,
            row.gouged
        );
    }
    for (kind, names) in &refused {
        println!("\n{} {kind} whose contours overlap: {}", names.len(), names.join(", "));
    }
    println!(
        "\n{} differences\n| outline | offset | g41 mm² | Clipper2 mm² | difference | by a grid of 0.1 mm | open pieces | gouge |",
        listed.len()
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    listed.iter().for_each(|line| println!("{line}"));
    println!("\n{:.0} s", taken[0] * 1e-9);
}
