//! The driller's seat: live strings over requests and a socket.

use std::{collections::BTreeMap, fs, mem, time::Duration};

use futures_util::{SinkExt, StreamExt};
use serde_json::{Value, json};
use tokio::{
    net::TcpStream,
    runtime::{Builder, Runtime},
    time::timeout,
};
use tokio_tungstenite::{
    WebSocketStream, client_async,
    tungstenite::{Message, client::IntoClientRequest, http::HeaderValue},
};

use crate::common::{CASE, Served};

/// A drilling string, under a drive with a controller.
fn drilling() -> String {
    CASE.replace(
        "[operation]\nkind = \"trip_out\"\n",
        "[bit]\ntorque = \"1 kN.m\"\n\n[operation]\nkind = \"drill\"\nrpm = 90\nwob = \"30 kN\"\n\
         rop = \"10 m/h\"\n\n[top_drive]\ncontrol = \"pi\"\n\n[dynamics]\nsettle = \"5 s\"\n",
    )
}

/// A page that views a string.
struct Page {
    runtime: Runtime,
    socket: WebSocketStream<TcpStream>,
    layout: Value,
    status: Value,
    refused: Vec<String>,
    /// Rows by their numbers.
    samples: BTreeMap<u64, Vec<f32>>,
    epoch: u32,
    /// Times and nodes of the frames.
    frames: Vec<(f64, u32)>,
}

fn word(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

impl Page {
    fn open(served: &Served, id: &str) -> Self {
        let runtime = Builder::new_current_thread().enable_all().build().unwrap();
        let host = served.host();
        let mut request =
            format!("ws://{host}/api/live/{id}/socket").into_client_request().unwrap();
        let headers = request.headers_mut();
        headers.insert("cookie", HeaderValue::from_str(&served.cookie).unwrap());
        headers.insert("origin", HeaderValue::from_str(&format!("http://{host}")).unwrap());
        let socket = runtime.block_on(async {
            let stream = TcpStream::connect(("127.0.0.1", served.port)).await.unwrap();
            client_async(request, stream).await.unwrap().0
        });
        let mut page = Self {
            runtime,
            socket,
            layout: Value::Null,
            status: Value::Null,
            refused: Vec::new(),
            samples: BTreeMap::new(),
            epoch: u32::MAX,
            frames: Vec::new(),
        };
        page.until(|page| !page.layout.is_null() && !page.status.is_null());
        page
    }

    fn say(&mut self, request: &Value) {
        let message = Message::Text(request.to_string().into());
        self.runtime.block_on(self.socket.send(message)).unwrap();
    }

    /// Receives the next message; false if there are no more.
    fn hear(&mut self) -> bool {
        let next = async { timeout(Duration::from_secs(60), self.socket.next()).await };
        match self.runtime.block_on(next).expect("a message within a minute") {
            Some(Ok(Message::Text(text))) => {
                let message: Value = serde_json::from_str(&text).unwrap();
                match message["type"].as_str().unwrap() {
                    "layout" => self.layout = message,
                    "status" => self.status = message,
                    "refused" => self.refused.push(message["message"].as_str().unwrap().to_owned()),
                    other => panic!("{other}"),
                }
            }
            Some(Ok(Message::Binary(bytes))) => self.take(&bytes),
            Some(Ok(_)) => {}
            Some(Err(_)) | None => return false,
        }
        true
    }

    fn take(&mut self, bytes: &[u8]) {
        let (kind, count, epoch) = (word(bytes, 0), word(bytes, 4), word(bytes, 8));
        let place = f64::from_le_bytes(bytes[16..24].try_into().unwrap());
        let numbers = bytes[24..].chunks_exact(4);
        let values: Vec<f32> =
            numbers.map(|four| f32::from_le_bytes(four.try_into().unwrap())).collect();
        let columns = |kind: &str| self.layout[kind].as_array().unwrap().len();
        match kind {
            1 => {
                if mem::replace(&mut self.epoch, epoch) != epoch {
                    self.samples.clear();
                }
                assert_eq!(values.len(), count as usize * columns("samples"));
                for (row, values) in values.chunks_exact(columns("samples")).enumerate() {
                    self.samples.insert(place as u64 + row as u64, values.to_vec());
                }
            }
            2 => {
                assert_eq!(values.len(), count as usize * columns("frame"));
                self.frames.push((place, count));
            }
            other => panic!("{other}"),
        }
    }

    #[track_caller]
    fn until(&mut self, is_so: impl Fn(&Self) -> bool) {
        while !is_so(self) {
            assert!(self.hear(), "the socket was closed: {}", self.status);
        }
    }

    fn column(&self, name: &str) -> usize {
        let channels = self.layout["samples"].as_array().unwrap();
        channels.iter().position(|channel| channel["name"] == name).unwrap()
    }

    fn last(&self, name: &str) -> f64 {
        f64::from(self.samples.last_key_value().unwrap().1[self.column(name)])
    }

    /// Advances until the string has reached a time, s.
    #[track_caller]
    fn step_to(&mut self, time_s: f64) {
        let now = self.status["time_s"].as_f64().unwrap();
        self.say(&json!({"step": time_s - now}));
        let sample_s = self.layout["sample_interval_s"].as_f64().unwrap();
        let there = (time_s / sample_s).round() as u64;
        self.until(|page| {
            page.samples.last_key_value().is_some_and(|(number, _)| number + 1 >= there)
                && page.status["state"] == "paused"
                && page.status["time_s"].as_f64().unwrap() >= time_s - 0.6 * sample_s
        });
    }
}

fn live() -> (Served, String, String) {
    let served = Served::with(&[("drill.toml", &drilling())]);
    let case = served.id("drill.toml");
    let begun = served.post("/api/live", &json!({"case": case})).ok();
    (served, case, begun["id"].as_str().unwrap().to_owned())
}

#[test]
fn a_string_waits_runs_and_stops() {
    let (served, case, id) = live();
    let listed = served.get("/api/live").ok();
    assert_eq!((&listed[0]["id"], &listed[0]["case"]), (&json!(id), &json!(case)));
    assert_eq!((&listed[0]["state"], &listed[0]["operation"]), (&json!("paused"), &json!("drill")));
    let mut page = Page::open(&served, &id);
    assert_eq!(page.layout["id"], json!(id));
    assert_eq!(served.get(&format!("/api/live/{id}")).ok()["samples"], page.layout["samples"]);
    page.until(|page| !page.frames.is_empty());
    assert_eq!(page.frames[0].0, 0.0);
    page.say(&json!({"pace": 5}));
    page.say(&json!({"run": true}));
    page.until(|page| page.samples.len() > 200);
    // No sample is missing, and frames cover the whole string.
    let numbers: Vec<u64> = page.samples.keys().copied().collect();
    assert!(numbers.windows(2).all(|two| two[1] == two[0] + 1) && numbers[0] == 0);
    let nodes = page.layout["contact_radius_m"].as_array().unwrap().len() as u32;
    assert!(page.frames.iter().all(|(_, count)| *count == nodes));
    assert!(page.last("hook_load_N") > 1e5);
    page.until(|page| page.status["state"] == "running" && page.status["pace"] == 5.0);
    page.say(&json!({"run": false}));
    page.until(|page| page.status["state"] == "paused");
    // Another page sees the same, and everything from before it joined.
    let mut other = Page::open(&served, &id);
    let first = *page.samples.keys().next().unwrap();
    other.until(|other| other.samples.contains_key(&first));
    let bits = |page: &Page| {
        page.samples[&first].iter().map(|sample| sample.to_bits()).collect::<Vec<_>>()
    };
    assert_eq!(bits(&other), bits(&page));
    let ended = served.delete(&format!("/api/live/{id}"));
    assert_eq!(ended.status, 204);
    page.until(|page| page.status["state"] == "ended");
    while page.hear() {}
    assert_eq!(served.get(&format!("/api/live/{id}")).error(410), "ended");
    assert_eq!(served.get("/api/live/0").error(404), "not_found");
    assert!(!served.path().join(".wholestring").exists());
}

/// The engine follows the set points from the next sample on.
#[test]
fn set_points_reach_the_engine() {
    let (served, _, id) = live();
    let mut page = Page::open(&served, &id);
    page.step_to(0.5);
    let set = json!({
        "rotary_speed_rad_per_s": 14.0, "block_velocity_m_per_s": -0.05, "friction": 0.1,
        "controller": "soft-torque"
    });
    page.say(&json!({"set": set}));
    page.step_to(1.0);
    assert_eq!(page.last("rotary_speed_set_rad_per_s"), 14.0);
    assert_eq!(page.last("block_velocity_set_m_per_s"), f64::from(-0.05_f32));
    assert_eq!(page.last("block_velocity_m_per_s"), f64::from(-0.05_f32));
    assert!(page.last("weight_on_bit_set_N").is_nan());
    assert!(page.last("rotary_speed_rad_per_s") > 9.5);
    assert_eq!(page.status["friction"], json!([0.1]));
    assert_eq!(page.status["controller"], "soft-torque");
    page.say(&json!({"set": {"weight_on_bit_N": 20e3, "ramp_s": 1.0}}));
    page.step_to(1.6);
    let (weight, speed) =
        (page.last("weight_on_bit_set_N"), page.last("rotary_speed_set_rad_per_s"));
    assert!(weight.is_finite() && speed == 14.0);
    assert_eq!(page.status["events"], 2);
    let recorded = served.get(&format!("/api/live/{id}/recording")).ok();
    assert_eq!(recorded[1]["set"], json!({"weight_on_bit_N": 20e3, "ramp_s": 1.0}));
    // Impossible requests are reported, and change nothing.
    for (request, words) in [
        (
            json!({"set": {"rotary_speed_rad_per_s": -1.0}}),
            "The rotary speed of -9.549 rpm is out of range: expected 0 rpm to 1000 rpm",
        ),
        (
            json!({"set": {"friction": 7}}),
            "The friction coefficient of 7 is out of range: expected 0 to",
        ),
        (json!({"set": {"weight_on_bit_N": 1, "block_velocity_m_per_s": 1}}), "at the same time"),
        (json!({"set": {"depth": 7}}), "unknown field"),
        (json!({"pace": 0}), "a pace is"),
        (json!({"step": 1e9}), "a step is"),
        (json!({"jump": 1}), "unknown variant"),
    ] {
        page.say(&request);
        let before = page.refused.len();
        page.until(|page| page.refused.len() > before);
        assert!(page.refused[before].contains(words), "{}", page.refused[before]);
    }
    page.say(&json!({"set": {"controller": "none"}}));
    page.until(|page| page.status["sentence"].is_string());
    assert!(page.status["sentence"].as_str().unwrap().contains("pi, soft-torque, z-torque"));
    assert_eq!(page.status["events"], 2);
}

/// A weight that the string does not have is refused with the judge's sentence, in the units of the
/// page; limits of the rig are in the layout, and exceeded ones among the alarms.
#[test]
fn limits_of_string_and_rig_are_alarms() {
    let text = drilling() + "\n[rig]\ntop_drive_torque = \"0.5 kN.m\"\nhoist_capacity = \"2 MN\"\n";
    let served = Served::with(&[("drill.toml", &text)]);
    let case = served.id("drill.toml");
    let id = served.post("/api/live", &json!({"case": case})).ok()["id"].clone();
    let mut page = Page::open(&served, id.as_str().unwrap());
    let limits = page.layout["limits"].as_array().unwrap();
    let value = |column: &str| {
        let limit = limits.iter().find(|limit| limit["column"] == column).unwrap();
        limit["value"].as_f64().unwrap()
    };
    assert!((value("hook_load_N") - 1.8e6).abs() < 1.0 && value("surface_torque_N_m") == 500.0);
    let too_heavy = json!({"set": {"weight_on_bit_N": 5e6}});
    for (units, words) in [("si", "5000 kN requested"), ("field", "1124 klbf requested")] {
        page.say(&json!({"units": units}));
        page.say(&too_heavy);
        let before = page.refused.len();
        page.until(|page| page.refused.len() > before);
        let sentence = &page.refused[before];
        assert!(sentence.starts_with("The string is too light"), "{sentence}");
        assert!(sentence.contains(words) && sentence.ends_with("It was not set"), "{sentence}");
    }
    page.say(&json!({"units": "yards"}));
    page.until(|page| page.refused.len() > 2);
    page.step_to(4.0);
    assert_eq!(page.status["events"], 0);
    page.until(|page| {
        let alarms = page.status["alarms"].as_array().unwrap();
        alarms.iter().any(|alarm| {
            let sentence = alarm["sentence"].as_str().unwrap();
            alarm["kind"] == "top_drive"
                && alarm["severity"] == "error"
                && sentence.contains("capacity 368.8 ft-lbf")
        })
    });
    let lamp = |page: &Page, name: &str| {
        let lamps = page.status["lamps"].as_array().unwrap();
        lamps.iter().find(|lamp| lamp["name"] == name).unwrap()["severity"].clone()
    };
    assert_eq!((lamp(&page, "Top drive"), lamp(&page, "Whirl")), (json!("error"), json!("ok")));
    let bit_depth_m = page.last("bit_depth_m");
    assert!((page.status["hole_depth_m"].as_f64().unwrap() - bit_depth_m).abs() < 1e-3);
    // After a rewind nothing is measured: all lamps are dark, and no alarm remains.
    let epoch = page.epoch;
    let first = page.status["checkpoints"][0]["number"].as_u64().unwrap();
    let path = format!("/api/live/{}/rewind", id.as_str().unwrap());
    assert_eq!(served.post(&path, &json!({"checkpoint": first})).status, 204);
    page.until(|page| page.epoch != epoch && page.status["time_s"] == 0.0);
    for name in ["Stick-slip", "Whirl", "Top drive"] {
        assert_eq!(lamp(&page, name), Value::Null, "{name}");
    }
    assert_eq!(page.status["alarms"], json!([]));
}

/// A string that is rewound and replayed moves to the same bits; a branch does so, too.
#[test]
fn a_rewind_gives_the_same_bits() {
    let (served, _, id) = live();
    let mut page = Page::open(&served, &id);
    page.step_to(0.5);
    page.say(&json!({"set": {"rotary_speed_rad_per_s": 12.0, "ramp_s": 0.3}}));
    page.step_to(1.0);
    page.say(&json!({"set": {"friction": 0.2, "controller": "z-torque"}}));
    page.step_to(2.0);
    let (before, epoch) = (page.samples.clone(), page.epoch);
    let first = page.status["checkpoints"][0]["number"].as_u64().unwrap();
    let branch = served.post(&format!("/api/live/{id}/branch"), &json!({})).ok();
    let back = json!({"checkpoint": first, "replay": true});
    assert_eq!(served.post(&format!("/api/live/{id}/rewind"), &back).status, 204);
    page.until(|page| page.epoch != epoch && page.status["replaying"] == 2);
    assert!(page.samples.is_empty());
    page.step_to(2.0);
    let bits = |rows: &BTreeMap<u64, Vec<f32>>| -> Vec<Vec<u32>> {
        rows.values().map(|row| row.iter().map(|value| value.to_bits()).collect()).collect()
    };
    let least = before.len().min(page.samples.len());
    assert!(least > 150);
    assert_eq!(bits(&before)[..least], bits(&page.samples)[..least]);
    assert_eq!((&page.status["events"], &page.status["replaying"]), (&json!(2), &json!(0)));
    assert_eq!(page.status["controller"], "z-torque");
    // Both continue alike from there.
    let mut other = Page::open(&served, branch["id"].as_str().unwrap());
    assert_eq!(other.status["time_s"], json!(page.status["time_s"].as_f64().unwrap()));
    assert_eq!(other.status["events"], 2);
    for page in [&mut page, &mut other] {
        page.step_to(2.5);
    }
    for (number, row) in &other.samples {
        let same = row.iter().zip(&page.samples[number]);
        assert!(same.clone().all(|(one, other)| one.to_bits() == other.to_bits()), "{number}");
    }
    assert!(other.samples.len() > 40);
    // Without `replay` the later part is discarded.
    let back = json!({"checkpoint": first});
    assert_eq!(served.post(&format!("/api/live/{id}/rewind"), &back).status, 204);
    page.until(|page| page.status["events"] == 0);
    let gone = json!({"checkpoint": 999});
    assert_eq!(served.post(&format!("/api/live/{id}/rewind"), &gone).error(404), "not_found");
}

#[test]
fn there_are_no_more_strings_than_may_be() {
    let (served, case, id) = live();
    for _ in 0..3 {
        served.post(&format!("/api/live/{id}/branch"), &json!({})).ok();
    }
    let more = served.post("/api/live", &json!({"case": case}));
    assert_eq!(more.error(429), "too_many");
    assert!(more.text().contains("4 strings are live already"));
    assert_eq!(served.delete(&format!("/api/live/{id}")).status, 204);
    // It ends shortly after.
    let begun = (0..100).any(|_| {
        std::thread::sleep(Duration::from_millis(50));
        served.post("/api/live", &json!({"case": case})).status == 200
    });
    assert!(begun);
    let unsound = json!({"case": case, "text": "name = 1"});
    served.get("/api/live").ok();
    assert_ne!(served.post("/api/live", &unsound).status, 200);
}

#[test]
fn what_cannot_be_begun_is_said() {
    let served = Served::with(&[("drill.toml", &drilling())]);
    let case = served.id("drill.toml");
    let begin = |body: Value| served.post("/api/live", &body);
    assert_eq!(begin(json!({"case": "0"})).error(404), "not_found");
    assert_eq!(begin(json!({"case": case, "text": "name = 1"})).error(422), "unsound");
    let several = drilling().replace("kind = \"drill\"", "kind = [\"drill\", \"slide\"]");
    let answer = begin(json!({"case": case, "text": several}));
    assert_eq!(answer.error(422), "bad_input");
    assert!(answer.text().contains("name one of drill, slide"));
    begin(json!({"case": case, "text": several, "operation": "slide"})).ok();
    assert_eq!(begin(json!({"case": case, "operation": "fly"})).error(422), "bad_input");
}

/// A page of another origin gets no socket, with the cookie or without; nor does the app's own page
/// without it.
#[test]
fn a_foreign_page_gets_no_socket() {
    let (served, _, id) = live();
    let host = served.host();
    let cookie = format!("Cookie: {}\r\n", served.cookie);
    let upgrade = |origin: &str, cookie: &str| {
        let head = format!(
            "GET /api/live/{id}/socket HTTP/1.1\r\nHost: {host}\r\nConnection: Upgrade\r\n\
             Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n\
             Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n{origin}{cookie}\r\n"
        );
        served.send(&head, b"").status
    };
    assert_eq!(upgrade(&format!("Origin: http://{host}\r\n"), &cookie), 101);
    for origin in ["", "Origin: http://evil.example\r\n", "Origin: http://127.0.0.1:1\r\n"] {
        assert_eq!(upgrade(origin, &cookie), 403, "{origin}");
    }
    assert_eq!(upgrade(&format!("Origin: http://{host}\r\n"), ""), 401);
}

/// Memory of this process, bytes.
fn resident() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<u64>().ok()? << 10)
}

/// A page that does not read receives the latest frame when it does, and nothing is queued for it:
/// the progress of the string meanwhile, a hundred and fifty frames and their samples, would take
/// 30 MB.
#[test]
fn who_reads_slowly_gets_the_latest_and_costs_nothing() {
    let (served, _, id) = live();
    let mut slow = Page::open(&served, &id);
    let mut page = Page::open(&served, &id);
    page.say(&json!({"pace": "max"}));
    page.say(&json!({"run": true}));
    page.until(|page| page.frames.len() > 20);
    let (begin, before) = (page.frames.len(), resident());
    let from_s = page.frames.last().unwrap().0;
    page.until(|page| page.frames.len() > begin + 150);
    let after = resident();
    if let (Some(before), Some(after)) = (before, after) {
        // The samples of the page itself are in this process, too: some 600 bytes each.
        let own = page.samples.len() as u64 * 600;
        assert!(after < before + own + (24 << 20), "{before} {after} {own}");
    }
    let (made, to_s) = (page.frames.len() - begin, page.frames.last().unwrap().0);
    page.say(&json!({"run": false}));
    page.until(|page| page.status["state"] == "paused");
    slow.until(|slow| {
        slow.status["state"] == "paused" && slow.frames.last().is_some_and(|frame| frame.0 >= to_s)
    });
    // The contents of the system's own buffers arrived, and the frames skipped between did not.
    assert!(slow.frames.len() < made, "{} of {made}", slow.frames.len());
    assert!(to_s > from_s);
}

#[test]
fn what_was_done_becomes_the_schedule_of_the_case() {
    let (served, case, id) = live();
    let mut page = Page::open(&served, &id);
    page.step_to(0.5);
    page.say(&json!({"set": {"rotary_speed_rad_per_s": 12.0, "friction": 0.25}}));
    page.step_to(1.0);
    let path = format!("/api/live/{id}/schedule");
    let made = served.post(&path, &json!({"text": drilling()})).ok();
    assert_eq!((&made["lines"], made["left_out"].as_array().unwrap().len()), (&json!(1), 1));
    let text = made["text"].as_str().unwrap();
    assert!(text.contains("friction = 0.3  # a guess"), "{text}");
    let checked = served.post(&format!("/api/cases/{case}/check"), &json!({"text": text})).ok();
    let lines = &checked["values"]["operation"]["schedule"];
    assert_eq!(lines.as_array().unwrap().len(), 1);
    assert!((lines[0]["rpm"].as_f64().unwrap() - 114.591_559).abs() < 1e-5);
    let several = drilling().replace("kind = \"drill\"", "kind = [\"drill\", \"slide\"]");
    assert_eq!(served.post(&path, &json!({"text": several})).error(422), "unsound");
}

/// A string is saved on request and when the program ends; another program continues it to the same
/// bits.
#[test]
fn a_kept_string_is_continued_by_another_program() {
    let (mut served, case, id) = live();
    let mut page = Page::open(&served, &id);
    page.step_to(0.5);
    page.say(&json!({"set": {"rotary_speed_rad_per_s": 12.0}}));
    page.step_to(1.0);
    served.post(&format!("/api/live/{id}/keep"), &json!({})).ok();
    page.step_to(1.5);
    let rows = page.samples.clone();
    drop(page);
    let folder = mem::replace(&mut served.folder, tempfile::tempdir().unwrap());
    drop(served);
    let served = Served::of(folder);
    let strings = served.get("/api/kept-strings").ok();
    let strings = strings.as_array().unwrap();
    // The requested one, and the one from the end of the program.
    assert_eq!(strings.len(), 2);
    assert!(strings.iter().all(|one| one["case"] == json!(case) && one["operation"] == "drill"));
    let time_s = |one: &&Value| one["time_s"].as_f64().unwrap();
    let early = strings.iter().find(|one| time_s(one) < 1.2).unwrap();
    assert!(strings.iter().any(|one| time_s(&one) > 1.4));
    let path = format!("/api/kept-strings/{}", early["name"].as_str().unwrap());
    let again = served.ask("POST", &path, "application/json", b"").ok();
    let mut page = Page::open(&served, again["id"].as_str().unwrap());
    assert_eq!(page.status["events"], 1);
    page.step_to(1.5);
    assert!(page.samples.len() > 40);
    for (number, row) in &page.samples {
        let same = row.iter().zip(&rows[number]);
        assert!(same.clone().all(|(one, other)| one.to_bits() == other.to_bits()), "{number}");
    }
    assert_eq!(served.delete(&path).status, 204);
    assert_eq!(served.ask("POST", &path, "application/json", b"").error(404), "not_found");
    for name in ["..%2f..%2fdrill", "%2fetc%2fpasswd", "..", "0"] {
        let path = format!("/api/kept-strings/{name}");
        assert_eq!(served.ask("POST", &path, "application/json", b"").status, 404, "{name}");
    }
}
