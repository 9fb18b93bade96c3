//! Writes JSON: just what the reports need.

use std::fmt::Write as _;

use glam::DVec2;

use crate::geometry::Decimal;

/// An object being written.
#[derive(Debug)]
pub(super) struct Object<'a> {
    out: &'a mut String,
    empty: bool,
}

/// The JSON text of a list, with an object for each item.
pub(super) fn list<T>(
    items: impl IntoIterator<Item = T>,
    write: impl FnMut(&mut Object<'_>, T),
) -> String {
    let mut out = String::new();
    push_list(&mut out, items, write);
    out
}

impl Object<'_> {
    /// Adds a field that is a text.
    pub(super) fn text(&mut self, name: &str, value: &str) {
        self.name(name);
        push_text(self.out, value);
    }

    /// Adds a field that is a number.
    pub(super) fn number(&mut self, name: &str, value: f64) {
        self.name(name);
        push_number(self.out, value);
    }

    /// Adds a field that is a truth.
    pub(super) fn truth(&mut self, name: &str, value: bool) {
        self.name(name);
        self.out.push_str(if value { "true" } else { "false" });
    }

    /// Adds a field that is a point or a vector.
    pub(super) fn point(&mut self, name: &str, value: DVec2) {
        self.name(name);
        push_point(self.out, value);
    }

    /// Adds a field that is a list of points.
    pub(super) fn points(&mut self, name: &str, values: &[DVec2]) {
        self.name(name);
        push_items(self.out, values, |out, &value| push_point(out, value));
    }

    /// Adds a field that is a list of numbers.
    pub(super) fn numbers(&mut self, name: &str, values: impl IntoIterator<Item = f64>) {
        self.name(name);
        push_items(self.out, values, push_number);
    }

    /// Adds a field that is an object.
    pub(super) fn object(&mut self, name: &str, write: impl FnOnce(&mut Object<'_>)) {
        self.name(name);
        push_object(self.out, write);
    }

    /// Adds a field that is a list of objects.
    pub(super) fn list<T>(
        &mut self,
        name: &str,
        items: impl IntoIterator<Item = T>,
        write: impl FnMut(&mut Object<'_>, T),
    ) {
        self.name(name);
        push_list(self.out, items, write);
    }

    fn name(&mut self, name: &str) {
        if !self.empty {
            self.out.push(',');
        }
        self.empty = false;
        // Names have nothing that must be written otherwise.
        self.out.push('"');
        self.out.push_str(name);
        self.out.push_str("\":");
    }
}

fn push_object(out: &mut String, write: impl FnOnce(&mut Object<'_>)) {
    out.push('{');
    write(&mut Object { out, empty: true });
    out.push('}');
}

fn push_list<T>(
    out: &mut String,
    items: impl IntoIterator<Item = T>,
    mut write: impl FnMut(&mut Object<'_>, T),
) {
    push_items(out, items, |out, item| push_object(out, |object| write(object, item)));
}

fn push_items<T>(
    out: &mut String,
    items: impl IntoIterator<Item = T>,
    mut push: impl FnMut(&mut String, T),
) {
    out.push('[');
    for (i, item) in items.into_iter().enumerate() {
        if i > 0 {
            out.push(',');
        }
        push(out, item);
    }
    out.push(']');
}

fn push_point(out: &mut String, value: DVec2) {
    push_items(out, value.to_array(), push_number);
}

/// JSON has no NaN and no infinity; they become null.
fn push_number(out: &mut String, value: f64) {
    if value.is_finite() {
        // To a thousandth of a picometre.
        Decimal::new(value, 12).push_to(out);
    } else {
        out.push_str("null");
    }
}

fn push_text(out: &mut String, text: &str) {
    out.push('"');
    for letter in text.chars() {
        match letter {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\0'..='\u{1f}' => {
                // Writing to a string cannot fail.
                let _ = write!(out, "\\u{:04x}", u32::from(letter));
            }
            _ => out.push(letter),
        }
    }
    out.push('"');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_of_every_type_are_written() {
        let json = list([1, 2], |object, i| {
            object.number("number", f64::from(i) / 10.0);
            if i == 2 {
                object.text("text", "a \"b\" \\ \n ü");
                object.point("point", DVec2::new(1e-9, -2e10));
                object.object("object", |inner| inner.number("nan", f64::NAN));
                object.list("none", [0; 0], |_, _| {});
            }
        });
        let expected = concat!(
            r#"[{"number":0.1},"#,
            r#"{"number":0.2,"text":"a \"b\" \\ \u000a ü","#,
            r#""point":[0.000000001,-20000000000],"#,
            r#""object":{"nan":null},"none":[]}]"#
        );
        assert_eq!(json, expected, "JSON");
    }
}
