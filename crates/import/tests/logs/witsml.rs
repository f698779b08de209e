//! Logs of WITSML.

use wholestring_import::{Choices, ImportErrorKind};

use crate::{notes, read, refused, rows};

fn log1(name: &str, rows: &str) -> String {
    format!(
        "<log uid=\"{name}-uid\"><nameWell>A</nameWell><name>{name}</name>\
         <indexType>date time</indexType><indexCurve>TIME</indexCurve>\
         <nullValue>-999.25</nullValue>\
         <logCurveInfo><mnemonic>TIME</mnemonic><unit>s</unit></logCurveInfo>\
         <logCurveInfo><mnemonic>CH7</mnemonic><mnemAlias>HKLA</mnemAlias><unit>kN</unit>\
         <nullValue>-1</nullValue></logCurveInfo>\
         <logData><mnemonicList>TIME,CH7</mnemonicList><unitList>s,kN</unitList>{rows}</logData></log>"
    )
}

fn logs(logs: &[String]) -> String {
    format!("<logs version=\"1.4.1.1\">{}</logs>", logs.concat())
}

const TWO_ROWS: &str = "<data>2021-03-24T10:00:00Z,5</data>\n<data>2021-03-24T10:00:02Z,6</data>";

#[test]
fn rows_of_series_1_are_read() {
    let text = logs(&[log1("surface", TWO_ROWS)]);
    let (rows, log) = read(&text);
    assert_eq!((rows[1].time_s, rows[1].hook_load_N), (2.0, 6000.0));
    assert_eq!(log.what, "WITSML 1.4.1.1, log 'surface'");
    assert_eq!(log.start.as_deref(), Some("2021-03-24 10:00:00 UTC"));
}

#[test]
fn each_curve_has_its_own_null() {
    let text = logs(&[log1(
        "surface",
        "<data>2021-03-24T10:00:00Z,-1</data><data>2021-03-24T10:00:02Z,-999.25</data>\
         <data>2021-03-24T10:00:04Z,</data><data>2021-03-24T10:00:06Z</data>",
    )]);
    let (rows, log) = read(&text);
    assert!(rows.len() == 4 && rows.iter().all(|row| row.hook_load_N.is_nan()));
    assert_eq!(notes(&log), "");
}

#[test]
fn one_of_several_logs_is_picked() {
    let text = logs(&[
        log1("one", TWO_ROWS),
        log1("two", "<data>2021-03-24T10:00:00Z,7</data>"),
        log1("three", ""),
    ]);
    assert_eq!(
        refused(&text),
        "a log: it holds 3 of the kind 'log': 'one', 'two', 'three'; pick one: --pick log=NAME"
    );
    for name in ["two", "two-uid"] {
        let (rows, log) =
            rows("a.xml", text.as_bytes(), &Choices::default().pick("log", name)).unwrap();
        assert_eq!(rows[0].hook_load_N, 7000.0);
        assert_eq!(
            notes(&log),
            "left out: the logs before 'two': one\nleft out: the logs after 'two': three\n"
        );
    }
    let error =
        rows("a.xml", text.as_bytes(), &Choices::default().pick("log", "four")).unwrap_err();
    assert_eq!(
        error.to_string().split("there").nth(1),
        Some(" is no log 'four'; it holds: 'one', 'two', 'three'")
    );
}

#[test]
fn the_unit_list_comes_before_the_curve() {
    let text = logs(&[log1("surface", TWO_ROWS)]).replace("<unitList>s,kN", "<unitList>s,t");
    let (rows, log) = read(&text);
    assert_eq!(rows[0].hook_load_N, 5.0 * 9806.65);
    assert!(
        notes(&log).contains("CH7 has the unit 'kN' in its logCurveInfo and 't' in the unitList")
    );
}

#[test]
fn older_files_have_no_list_of_names() {
    let text = logs(&[log1("surface", TWO_ROWS)])
        .replace("<mnemonicList>TIME,CH7</mnemonicList><unitList>s,kN</unitList>", "");
    assert_eq!(read(&text).0[1].hook_load_N, 6000.0);
}

#[test]
fn rows_of_too_many_values_are_refused() {
    let text = logs(&[log1("surface", "\n<data>2021-03-24T10:00:00Z,5,6</data>")]);
    assert_eq!(refused(&text), "a log, line 2: the row has 3 values; 2 were expected");
}

fn log2(rows: &str) -> String {
    format!(
        "<Log schemaVersion=\"2.0\"><Citation><Title>L</Title></Citation><ChannelSet>\
         <Citation><Title>surface</Title></Citation>\
         <Index><IndexType>date time</IndexType><Uom>s</Uom><Mnemonic>Time</Mnemonic></Index>\
         <Channel><Mnemonic>HKLA</Mnemonic><Uom>kN</Uom><DataType>double</DataType></Channel>\
         <Channel><Mnemonic>BPOS</Mnemonic><Uom>m</Uom></Channel>\
         <Data><Data>{rows}</Data></Data></ChannelSet></Log>"
    )
}

#[test]
fn rows_of_series_2_are_read() {
    let text = log2(
        "[[[&quot;2021-03-24T10:00:00Z&quot;],[5,1.5]],\n[[\"2021-03-24T10:00:02Z\"],[null]],\n\
         [[\"2021-03-24T10:00:03Z\"],[[6, true],2]]]",
    );
    let (rows, log) = read(&text);
    assert_eq!((rows[0].hook_load_N, rows[0].block_position_m), (5000.0, 1.5));
    assert!(rows[1].hook_load_N.is_nan() && rows[1].block_position_m.is_nan());
    assert_eq!((rows[2].time_s, rows[2].hook_load_N), (3.0, 6000.0));
    assert_eq!(log.what, "WITSML 2.0, log 'surface'");
}

#[test]
fn rows_may_be_character_data_and_names_of_version_2_1() {
    let text = log2("<![CDATA[[[[0],[5,1]],[[60],[6,2]]]]]>")
        .replace("IndexType", "IndexKind")
        .replace("date time", "elapsed time");
    let (rows, _) = read(&text);
    assert_eq!((rows[1].time_s, rows[1].hook_load_N), (60.0, 6000.0));
}

/// A whole file of version 2.1: prefixes, changed names, channels with their own index.
#[test]
fn a_log_of_version_2_1_is_read() {
    let channel = |mnemonic: &str, unit: &str| {
        format!(
            "<Channel schemaVersion=\"2.1\" uuid=\"{mnemonic}\"><eml:Citation><eml:Title>{mnemonic} of \
             the rig</eml:Title></eml:Citation><Mnemonic>{mnemonic}</Mnemonic><DataKind>double</DataKind>\
             <Uom>{unit}</Uom><GrowingStatus>inactive</GrowingStatus><Index><IndexKind>date time\
             </IndexKind><Uom>s</Uom><Direction>increasing</Direction><Mnemonic>TIME</Mnemonic></Index>\
             </Channel>"
        )
    };
    let text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Log xmlns=\"http://www.energistics.org/energyml/data/\
         witsmlv2\" xmlns:eml=\"http://www.energistics.org/energyml/data/commonv2\" schemaVersion=\"2.1\" \
         uuid=\"1\"><eml:Citation><eml:Title>Surface</eml:Title></eml:Citation><ChannelSet \
         schemaVersion=\"2.1\" uuid=\"2\"><eml:Citation><eml:Title>Time</eml:Title></eml:Citation><Index>\
         <IndexKind>date time</IndexKind><Uom>s</Uom><Direction>increasing</Direction><Mnemonic>TIME\
         </Mnemonic></Index>{}{}{}<Data><Data>[[[\"2026-11-21T06:00:00Z\"],[3663.5,1118,null]],\
         [[\"2026-11-21T06:00:05Z\"],[3662.0,1196,11250]]]</Data></Data></ChannelSet></Log>",
        channel("DBTM", "m"),
        channel("HKLA", "kN"),
        channel("TQA", "1000 lbf.ft"),
    );
    let (rows, log) = read(&text);
    assert_eq!(log.what, "WITSML 2.1, log 'Time'");
    assert_eq!(log.start.as_deref(), Some("2026-11-21 06:00:00 UTC"));
    assert_eq!(rows.len(), 2);
    assert_eq!((rows[1].time_s, rows[1].bit_depth_m, rows[1].hook_load_N), (5.0, 3662.0, 1.196e6));
    assert!(rows[0].torque_N_m.is_nan());
    assert!((rows[1].torque_N_m / (11250.0 * 1_355.817_948_331_4) - 1.0).abs() < 1e-12);
    assert_eq!(log.channels[1].description, "DBTM of the rig");
    assert_eq!(notes(&log), "");
}

#[test]
fn rows_that_are_not_json_are_refused_with_their_line() {
    assert_eq!(
        refused(&log2("[[[\"2021-03-24T10:00:00Z\"],[5,1]],\n[[\"2021-03-24T10:00:02Z\"] 5]]")),
        "a log, line 2: the rows are not JSON as WITSML defines it: ']' after a row was expected"
    );
    assert!(
        refused(&log2("[[[\"2021-03-24T10:00:00Z\"],[5,1,2]]]"))
            .contains("the row has 1 indexes and 3 values; 1 and at most 2 were expected")
    );
}

#[test]
fn one_of_several_sets_is_picked() {
    let one = log2("[[[\"2021-03-24T10:00:00Z\"],[5,1]]]");
    let set = &one[one.find("<ChannelSet>").unwrap()..one.find("</Log>").unwrap()];
    let second = set.replace("surface", "second").replace("[5,1]", "[7,1]");
    let text = one.replace("</Log>", &format!("{second}</Log>"));
    let error = rows("a.xml", text.as_bytes(), &Choices::default()).unwrap_err();
    assert!(matches!(error.kind(), ImportErrorKind::Ambiguous { .. }), "{error}");
    let choices = Choices::default().pick("log", "second");
    let (rows, log) = rows("a.xml", text.as_bytes(), &choices).unwrap();
    assert_eq!(rows[0].hook_load_N, 7000.0);
    assert_eq!(notes(&log), "left out: the other sets of channels: surface\n");
}

#[test]
fn a_document_type_is_refused() {
    let text = format!("<!DOCTYPE logs [<!ENTITY a \"b\">]>{}", logs(&[log1("x", TWO_ROWS)]));
    assert!(rows("a.xml", text.as_bytes(), &Choices::default()).is_err());
}
