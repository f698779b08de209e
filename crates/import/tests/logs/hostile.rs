//! Malicious and damaged files.

use std::io::Read;

use proptest::prelude::*;
use wholestring_import::{Choices, Input, contents, import, log};

/// Text without an end.
struct Endless {
    head: &'static [u8],
    body: &'static [u8],
    at: usize,
}

impl Read for Endless {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        for byte in &mut *into {
            *byte = match self.head.get(self.at) {
                Some(byte) => *byte,
                None => self.body[(self.at - self.head.len()) % self.body.len()],
            };
            self.at += 1;
        }
        Ok(into.len())
    }
}

/// Reads until the file is refused.
fn endless(head: &'static [u8], body: &'static [u8]) -> String {
    let input = Input::new("endless", Endless { head, body, at: 0 });
    let choices = Choices::default();
    let log = match log(input, &choices) {
        Ok(log) => log,
        Err(error) => return error.to_string(),
    };
    for row in log {
        if let Err(error) = row {
            return error.to_string();
        }
    }
    unreachable!("it has no end");
}

const LAS: &[u8] = b"~V\nVERS. 2.0:\n~C\nTIME.s:\nHKLA.kN:\n~A\n";
const WRAPPED: &[u8] = b"~V\nVERS. 2.0:\nWRAP. YES:\n~C\nTIME.s:\nHKLA.kN:\n~A\n0\n";
const CSV: &[u8] = b"Time (s),Hook load (kN),Bit depth (m)\n";

#[test]
fn lines_without_an_end_are_refused() {
    let heads = [LAS, WRAPPED, CSV, b"~V\n", b"~C\n"];
    for (head, body) in
        heads.into_iter().flat_map(|head| [(head, &b"1234567 "[..]), (head, b"1,2,\"")])
    {
        let error = endless(head, body);
        let wide = error.contains("a line of more than 1 MB") || error.contains("4096 columns");
        assert!(wide, "{error}");
    }
}

/// Tables are read whole, up to a limit, which applies to `check` as well as to `import`.
#[test]
fn tables_without_an_end_are_refused() {
    for (head, body) in [
        (&b""[..], &b"1234567 "[..]),
        (b"MD (m),Inc (deg),Azi (deg)\n", b"1,"),
        (b"MD (m),Inc (deg),Azi (deg)\n", b"1,2,3\n"),
        (b"Component,OD (in)\n", b"\""),
        (b"PK\x03\x04", b"\0"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", b"\0"),
    ] {
        let input = || Input::new("endless", Endless { head, body, at: 0 });
        let check = contents(input()).unwrap_err().to_string();
        let import = import(vec![input()], &Choices::default()).unwrap_err().to_string();
        assert!(check.contains("more than") && check.contains(" MB"), "{check}");
        assert_eq!(check, import);
    }
}

#[test]
fn heads_without_an_end_are_refused() {
    assert!(endless(b"~V\n~C\n", b"HKLA.kN:\n").contains("more than 4096 curves"));
    assert!(endless(b"~V\n~P\n", b"X.m 5 :\n").contains("more than 200000 lines"));
    assert!(endless(b"~V\n", b"\n").contains("more than 200000 lines"));
    let curves = endless(b"<logs><log>", b"<logCurveInfo><mnemonic>A</mnemonic></logCurveInfo>");
    assert!(curves.contains("more than 4096 curves"), "{curves}");
    let channels = endless(b"<Log><ChannelSet>", b"<Channel><Mnemonic>A</Mnemonic></Channel>");
    assert!(channels.contains("more than 4096 channels"), "{channels}");
}

/// Rows of WITSML 2 are one text, which is read whole: the error names the remedy, for any form of
/// the quotes in it.
#[test]
fn rows_of_witsml_2_without_an_end_are_refused() {
    const HEAD: &[u8] =
        b"<Log><ChannelSet><Index><IndexType>date time</IndexType><Mnemonic>T</Mnemonic>\
        </Index><Channel><Mnemonic>HKLA</Mnemonic><Uom>kN</Uom></Channel><Data><Data>[";
    for body in [&b"[[\"2021-03-24T10:00:00Z\"],[5]],"[..], b"[[&quot;2021-03-24&quot;],[5]],"] {
        let error = endless(HEAD, body);
        assert!(error.contains("rows of more than 64 MB"), "{error}");
        assert!(error.contains("save the log as WITSML 1.4.1.1, LAS or CSV"), "{error}");
    }
}

#[test]
fn a_million_columns_are_refused() {
    let names = "HKLA (kN),".repeat(1_000_000);
    let wide = format!("Time (s),{names}\n");
    assert!(contents(Input::of_bytes("wide.csv", wide.as_bytes())).is_err());
    let rows = format!("{}0 {}\n", String::from_utf8_lossy(LAS), "1 ".repeat(100_000));
    assert!(
        import(vec![Input::of_bytes("wide.las", rows.as_bytes())], &Choices::default()).is_err()
    );
}

const SAMPLES: [&[u8]; 5] = [
    include_bytes!("../samples/own/surface-log.las"),
    include_bytes!("../samples/las/lasio-sample_wrapped_1.2.las"),
    include_bytes!("../samples/witsml-1.4.1.1/welleng-time_log.xml"),
    b"Date,Time,Hook load,Block position\n,,klbs,ft\n03/14/2021,10:00:00,\"1,251.5\",62.1\n\
      03/14/2021,10:00:05,252,-999.25\n",
    b"<Log><ChannelSet><Index><IndexType>date time</IndexType><Mnemonic>T</Mnemonic></Index>\
      <Channel><Mnemonic>HKLA</Mnemonic><Uom>kN</Uom></Channel>\
      <Data><Data>[[[\"2021-03-24T10:00:00Z\"],[5]],[[\"2021-03-24T10:00:01Z\"],[null]]]</Data></Data>\
      </ChannelSet></Log>",
];

/// Separators and quotation marks.
const MARKS: &[u8] = b"\n~.:,;\"\t-0[]<>&";

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_are_read_or_refused(
        sample in 0..SAMPLES.len(),
        changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4u8), 1..12),
    ) {
        let mut bytes = SAMPLES[sample].to_vec();
        for (at, byte, how) in changes {
            let at = at.index(bytes.len().max(1)).min(bytes.len().saturating_sub(1));
            match how {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, MARKS[usize::from(byte) % MARKS.len()]),
                2 => { bytes.remove(at); }
                _ => bytes.truncate(at.max(1)),
            }
            if bytes.is_empty() { bytes.push(b'~'); }
        }
        let choices = Choices::default().unit("hookload", "kN").pick("date", "dmy");
        let _ = contents(Input::of_bytes("damaged", &bytes));
        let _ = import(vec![Input::of_bytes("damaged", &bytes)], &choices);
    }
}
