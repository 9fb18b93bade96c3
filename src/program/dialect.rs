//! The dialects of programs, and telling which one a text is written in.

/// How much of a text is looked at [bytes]: signs of a dialect stand at its beginning.
const LOOKED_AT: usize = 50_000;

/// How a program is to be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dialect {
    /// The dialect that the text shows signs of; without any, what most controls have in common.
    #[default]
    Auto,
    /// RS274/NGC as `LinuxCNC` reads it: O words with names, `#<name>`.
    LinuxCnc,
    /// FANUC and its kin: `O1234`, M98, G65, `IF […] GOTO`.
    Fanuc,
    /// SINUMERIK: `R1=…`, `X=…`, ASPLINE.
    Sinumerik,
}

/// What only one dialect has, in capitals and without space.
const SIGNS: [(&str, Dialect); 32] = [
    ("#<", Dialect::LinuxCnc),
    ("EXISTS[", Dialect::LinuxCnc),
    ("GOTOF", Dialect::Sinumerik),
    ("GOTOB", Dialect::Sinumerik),
    ("GOTO", Dialect::Fanuc),
    ("IF[", Dialect::Fanuc),
    ("WHILE[", Dialect::Fanuc),
    ("G65P", Dialect::Fanuc),
    ("G66P", Dialect::Fanuc),
    ("M98P", Dialect::Fanuc),
    ("ASPLINE", Dialect::Sinumerik),
    ("BSPLINE", Dialect::Sinumerik),
    ("CSPLINE", Dialect::Sinumerik),
    ("%_N_", Dialect::Sinumerik),
    ("MSG(", Dialect::Sinumerik),
    ("DISC=", Dialect::Sinumerik),
    ("CR=", Dialect::Sinumerik),
    ("G450", Dialect::Sinumerik),
    ("G451", Dialect::Sinumerik),
    ("KONT", Dialect::Sinumerik),
    ("TRANS", Dialect::Sinumerik),
    ("CYCLE8", Dialect::Sinumerik),
    ("SUPA", Dialect::Sinumerik),
    ("ROTZ", Dialect::Sinumerik),
    ("MIRROR", Dialect::Sinumerik),
    ("FFWON", Dialect::Sinumerik),
    ("DEFREAL", Dialect::Sinumerik),
    ("DEFINT", Dialect::Sinumerik),
    ("ENDLOOP", Dialect::Sinumerik),
    ("ENDFOR", Dialect::Sinumerik),
    ("MCALL", Dialect::Sinumerik),
    ("G111X", Dialect::Sinumerik),
];

impl Dialect {
    /// This dialect or, for [`Dialect::Auto`], the one of which `text` shows the first sign: O
    /// words, names in `#<>`, `IF […] GOTO`, M98, G65, a program number after `%`, assignments to
    /// addresses. It stays [`Dialect::Auto`] where there is none.
    #[must_use]
    pub fn of(self, text: &str) -> Self {
        if self != Self::Auto {
            return self;
        }
        let mut looked_at = text.len().min(LOOKED_AT);
        while !text.is_char_boundary(looked_at) {
            looked_at -= 1;
        }
        let mut percent = false;
        for text in text.get(..looked_at).unwrap_or_default().split(['\n', '\r']) {
            let line = bare(text);
            if let Some(dialect) = sign(&line, percent) {
                return dialect;
            }
            percent |= line == "%";
        }
        Self::Auto
    }
}

/// A line in capitals, without space and comments.
fn bare(text: &str) -> String {
    let (mut line, mut comment) = (String::new(), false);
    for byte in text.bytes() {
        match byte {
            _ if comment => comment = byte != b')',
            b';' => break,
            // What MSG shows is no comment.
            b'(' if !line.ends_with("MSG") => comment = true,
            _ if byte.is_ascii_graphic() => line.push(char::from(byte.to_ascii_uppercase())),
            _ => {}
        }
    }
    line
}

/// The dialect of a line in capitals without space and comments, if it shows one.
fn sign(line: &str, percent: bool) -> Option<Dialect> {
    let unnumbered = match line.strip_prefix('N') {
        Some(rest) => rest.trim_start_matches(|c: char| c.is_ascii_digit()),
        None => line,
    };
    if let Some(rest) = unnumbered.strip_prefix(['O', ':']) {
        let after = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        let number = after.len() < rest.len();
        if after.starts_with('<') || number && after.starts_with(|c: char| c.is_ascii_alphabetic())
        {
            return Some(Dialect::LinuxCnc);
        }
        if number && percent && after.is_empty() {
            return Some(Dialect::Fanuc);
        }
    }
    for (text, dialect) in SIGNS {
        // Not `contains`: its search is made for longer texts, and takes more code than all this.
        if line.as_bytes().windows(text.len()).any(|part| part == text.as_bytes()) {
            return Some(dialect);
        }
    }
    // An address with `=`: `R1=5`, `X=R1+2`; but `#1=5` belongs to several.
    let address = unnumbered.split('=').next().unwrap_or_default();
    let assigns = address.len() < unnumbered.len()
        && !address.contains(['#', '[', '<', '>'])
        && address.ends_with(|c: char| c.is_ascii_alphanumeric());
    assigns.then_some(Dialect::Sinumerik)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_sign_decides() {
        for (text, dialect) in [
            ("G0 X0\nG1 X1 F100\n#1=5\nM30\n", Dialect::Auto),
            ("%\nG0 X0 (GOTO 5)\n; R1=5\nM30\n%\n", Dialect::Auto),
            ("O1234\nG0 X0\n", Dialect::Auto),
            ("%\nO1234 (LID)\nG0 X0\n", Dialect::Fanuc),
            ("%\n:1234\nG0 X0\n", Dialect::Fanuc),
            ("#100=1\nN10 IF [#100 GT 5] GOTO 20\n", Dialect::Fanuc),
            ("while [#1 lt 5] do1\n", Dialect::Fanuc),
            ("G65 P9100 A1\n", Dialect::Fanuc),
            ("M98 P1234\n", Dialect::Fanuc),
            ("G0 X0\no100 sub\n", Dialect::LinuxCnc),
            ("o 100 while [#1 lt 5]\n", Dialect::LinuxCnc),
            ("O<corner> CALL [1]\n", Dialect::LinuxCnc),
            ("# <depth> = 3\n", Dialect::LinuxCnc),
            ("N10 R1=5\n", Dialect::Sinumerik),
            ("N.1\nN20 G0 X=10 Y=20\n", Dialect::Sinumerik),
            ("G2 X5 Y5 CR=5 ; arc\n", Dialect::Sinumerik),
            ("N10 ASPLINE X1 Y2\n", Dialect::Sinumerik),
            ("N10 MSG(\"here\")\n", Dialect::Sinumerik),
            ("N10 TRANS X10\n", Dialect::Sinumerik),
            ("N10 CYCLE800()\nG0 SUPA Z0\n", Dialect::Sinumerik),
            ("", Dialect::Auto),
            ("(open\nO<a> sub", Dialect::LinuxCnc),
        ] {
            assert_eq!(Dialect::Auto.of(text), dialect, "{text}");
        }
        assert_eq!(Dialect::Fanuc.of("o<a> sub"), Dialect::Fanuc, "the one that is given");
    }
}
