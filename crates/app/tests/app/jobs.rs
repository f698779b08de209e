//! Jobs that are started, followed, stopped and resumed.

use std::{
    fs,
    io::{BufRead, BufReader, Write},
    net::TcpStream,
    path::Path,
    time::{Duration, Instant},
};

use serde_json::{Value, json};

use crate::common::{CASE, Served, link::symlink};

/// A vertical well whose dynamics take this long, with frequent checkpoints.
fn dynamic(duration: &str) -> String {
    let case = fs::read_to_string("../../cases/vertical.toml").unwrap();
    let time = format!("duration = \"{duration}\"\ncheckpoint_interval = \"1 s\"");
    case.replace(
        "[\"trip_out\", \"trip_in\", \"rotate_off_bottom\", \"drill\", \"slide\"]",
        "\"rotate_off_bottom\"",
    )
    .replace("duration = \"10 s\"", &time)
}

fn start(served: &Served, request: &Value) -> String {
    served.post("/api/jobs", request).ok()["id"].as_str().unwrap().to_owned()
}

/// Waits until a condition on a job holds.
#[track_caller]
fn until(served: &Served, id: &str, holds: impl Fn(&Value) -> bool) -> Value {
    let begin = Instant::now();
    loop {
        let job = served.get(&format!("/api/jobs/{id}")).ok();
        if holds(&job) {
            return job;
        }
        // Dynamics of a shallow well on a busy machine.
        assert!(begin.elapsed() < Duration::from_secs(120), "{job}");
        std::thread::sleep(Duration::from_millis(50));
    }
}

fn is(state: &'static str) -> impl Fn(&Value) -> bool {
    move |job| {
        let is_open = job["state"] == "waiting" || job["state"] == "running";
        assert!(is_open || job["state"] == state, "{job}");
        job["state"] == state
    }
}

/// Whether the simulation of a job has begun.
fn moves(job: &Value) -> bool {
    let bar = &job["progress"]["bars"][0];
    bar["preparing"].is_null() && bar["reached_s"].as_f64().is_some_and(|reached| reached > 0.0)
}

#[test]
fn work_goes_where_the_command_line_puts_it() {
    let served = Served::with(&[("wells/a.toml", CASE)]);
    let case = served.id("wells/a.toml");
    let id = start(&served, &json!({"case": case, "work": {"kind": "run"}}));
    let job = until(&served, &id, is("finished"));
    assert_eq!((&job["command"], &job["title"]), (&json!("run"), &json!("slant")));
    assert_eq!(job["folder"], "out/slant");
    assert!(served.path().join("out/slant/summary.json").is_file());
    assert!(served.path().join("out/slant/report.html").is_file());
    // A repetition uses the same folder, another case of the same name the next one.
    let again = start(&served, &json!({"case": case, "work": {"kind": "run"}}));
    assert_eq!(until(&served, &again, is("finished"))["folder"], "out/slant");
    let set = json!({"friction": "0.1"});
    let other = start(&served, &json!({"case": case, "work": {"kind": "run"}, "set": set}));
    let other = until(&served, &other, is("finished"));
    assert_eq!(other["folder"], "out/slant-2");
    let note = other["progress"]["notes"][0].as_str().unwrap();
    assert!(note.contains("holds other results and is not changed"), "{note}");
    // It equals the result of the command line: the identity in the folder is that of the case.
    let summary = fs::read_to_string(served.path().join("out/slant/summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    let file = served.path().join("wells/a.toml");
    let identity = wholestring_case::load(&file, &[]).unwrap().identity();
    assert_eq!(summary["identity"], wholestring_results::digest(&identity).as_str());
}

#[test]
fn every_command_comes_to_its_end() {
    let study = "name = \"two\"\n[[sweep]]\nname = \"friction\"\ncase = \"a.toml\"\n\
        vary = { friction = [0.1, 0.3] }\n[[figure]]\ntitle = \"Hook load\"\nx = \"friction\"\n\
        y = \"hook_load_N\"\n";
    let readings = "bit depth (m),pick-up weight (kN),slack-off weight (kN)\n\
        800,290,215\n1000,345,240\n1200,400,265\n";
    let case = fs::read_to_string("../../cases/slant.toml").unwrap();
    let served =
        Served::with(&[("a.toml", &case), ("two.toml", study), ("readings.csv", readings)]);
    let case = served.id("a.toml");
    let study = served.get("/api/studies").ok();
    assert_eq!((study[0]["path"].as_str(), study.as_array().unwrap().len()), (Some("two.toml"), 1));
    let data = served.get("/api/readings").ok()[0]["id"].clone();
    let work = [
        (json!({"kind": "run", "models": ["soft"], "csv": true}), "out/Slant well"),
        (json!({"kind": "plan"}), "out/Slant well plan"),
        (json!({"kind": "reach", "frictions": [0.2, 0.3]}), "out/Slant well reach"),
        (json!({"kind": "bha", "weight": "20kN,40kN"}), "out/Slant well bha"),
        (json!({"kind": "modes"}), "out/Slant well modes"),
        (json!({"kind": "calibrate", "data": data}), "out/Slant well calibration"),
        (json!({"kind": "sweep", "vary": ["friction=0.1,0.2"]}), "out/Slant well sweep"),
        (json!({"kind": "study", "study": study[0]["id"]}), "out/two"),
    ];
    let ids: Vec<String> = work
        .iter()
        .map(|(work, _)| {
            let is_study = work["kind"] == "study";
            let set = json!({"model": "soft"});
            match is_study {
                true => start(&served, &json!({"work": work, "set": set})),
                false => start(&served, &json!({"case": case, "work": work, "set": set})),
            }
        })
        .collect();
    for (id, (work, folder)) in ids.iter().zip(&work) {
        let job = until(&served, id, is("finished"));
        assert_eq!(job["folder"], *folder, "{work}");
        let results = served.get(&format!("/api/results/{}", job["results"].as_str().unwrap()));
        let results = results.ok();
        assert_eq!(results["has_page"], true, "{work}");
        assert!(!results["files"].as_array().unwrap().is_empty());
        assert_eq!(results["unfinished"], false, "{work}");
    }
    assert_eq!(served.get("/api/results").ok().as_array().unwrap().len(), work.len());
}

#[test]
fn what_cannot_be_is_refused_at_once() {
    let unsound = CASE.replace("friction = 0.3", "friction = -1");
    let outside = "[[sweep]]\nname = \"s\"\ncase = \"../secret.toml\"\nvary = { friction = [0.1] }\n\
        [[figure]]\ntitle = \"t\"\nx = \"friction\"\ny = \"hook_load_N\"\n";
    let served = Served::with(&[("a.toml", CASE), ("bad.toml", &unsound), ("study.toml", outside)]);
    let (case, bad) = (served.id("a.toml"), served.id("bad.toml"));
    let ask = |request: &Value| served.post("/api/jobs", request);
    let unsound = ask(&json!({"case": bad, "work": {"kind": "plan"}}));
    assert_eq!(unsound.error(422), "unsound");
    assert!(unsound.json()["error"]["diagnostics"][0]["message"].is_string());
    let study = served.get("/api/studies").ok()[0]["id"].clone();
    for (request, status) in [
        (json!({"case": "a.toml", "work": {"kind": "plan"}}), 404),
        (json!({"case": "../a.toml", "work": {"kind": "plan"}}), 404),
        (json!({"work": {"kind": "plan"}}), 422),
        (json!({"case": case, "work": {"kind": "plan", "overlay": "/etc/passwd"}}), 404),
        (json!({"case": case, "work": {"kind": "calibrate", "data": "../x.csv"}}), 404),
        (json!({"case": case, "work": {"kind": "run", "models": ["magic"]}}), 422),
        (json!({"case": case, "work": {"kind": "run", "output": "/tmp"}}), 422),
        (json!({"case": case, "work": {"kind": "reach", "operations": ["fly"]}}), 422),
        (json!({"case": case, "work": {"kind": "reach", "from": "five"}}), 422),
        (json!({"case": case, "work": {"kind": "sweep", "vary": []}}), 422),
        (json!({"case": case, "work": {"kind": "rm"}}), 422),
        (json!({"work": {"kind": "study", "study": study}}), 422),
        (
            json!({"case": case, "work": {"kind": "run"}, "set": {"well.survey": "/etc/passwd"}}),
            422,
        ),
    ] {
        assert_eq!(ask(&request).status, status, "{request}: {}", ask(&request).text());
    }
    assert_eq!(served.get("/api/jobs").ok(), json!([]));
    assert!(!served.path().join("out").exists());
}

#[test]
fn results_go_through_no_link_that_leads_out() {
    let elsewhere = tempfile::tempdir().unwrap();
    let served = Served::with(&[("a.toml", CASE)]);
    let request = json!({"case": served.id("a.toml"), "work": {"kind": "run"}});
    let out = served.path().join("out");
    symlink(elsewhere.path(), &out).unwrap();
    assert_eq!(served.post("/api/jobs", &request).error(500), "failed");
    fs::remove_file(&out).unwrap();
    fs::create_dir(&out).unwrap();
    symlink(elsewhere.path(), out.join("slant")).unwrap();
    let refused = served.post("/api/jobs", &request);
    assert_eq!(refused.error(500), "failed");
    assert!(refused.text().contains("out/slant: it is outside the folder"), "{}", refused.text());
    assert_eq!(fs::read_dir(elsewhere.path()).unwrap().count(), 0);
}

/// The events of a job until its last, as received by the page.
fn events(served: &Served, id: &str) -> Vec<Value> {
    let mut stream = TcpStream::connect(("127.0.0.1", served.port)).unwrap();
    let head = format!("GET /api/jobs/{id}/events HTTP/1.1\r\n{}\r\n", served.headers());
    stream.write_all(head.as_bytes()).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
    let mut lines = BufReader::new(stream).lines().map(Result::unwrap);
    let head: Vec<String> = lines.by_ref().take_while(|line| !line.is_empty()).collect();
    assert!(head.iter().any(|line| line == "content-type: text/event-stream"), "{head:?}");
    let data = lines.filter_map(|line| {
        Some(serde_json::from_str::<Value>(line.strip_prefix("data: ")?).unwrap())
    });
    let mut events = Vec::new();
    for event in data {
        let is_last = event["state"] != "running" && event["state"] != "waiting";
        events.push(event);
        if is_last {
            break;
        }
    }
    events
}

#[test]
fn a_job_is_followed_stopped_and_resumed() {
    let mut served = Served::with(&[("a.toml", &dynamic("15000 s"))]);
    let case = served.id("a.toml");
    let id = start(&served, &json!({"case": case, "work": {"kind": "run"}}));
    let next = start(&served, &json!({"case": case, "work": {"kind": "modes"}}));
    until(&served, &id, moves);
    assert_eq!(served.get(&format!("/api/jobs/{next}")).ok()["state"], "waiting");
    let path = format!("/api/jobs/{id}");
    assert_eq!(served.delete(&path).error(409), "conflict");
    assert_eq!(served.post(&format!("{path}/resume"), &json!({})).error(409), "conflict");
    // A follower sees the progress and the end.
    let begin = Instant::now();
    let (seen, job) = std::thread::scope(|scope| {
        let seen = scope.spawn(|| events(&served, &id));
        std::thread::sleep(Duration::from_millis(1200));
        assert_eq!(served.post(&format!("{path}/stop"), &json!({})).status, 204);
        (seen.join().unwrap(), until(&served, &id, is("stopped")))
    });
    assert_eq!(seen.last().unwrap()["state"], "stopped");
    let times = seen.iter().filter_map(|event| event["progress"]["bars"][0]["reached_s"].as_f64());
    let times: Vec<f64> = times.collect();
    assert!(times.windows(2).all(|two| two[0] <= two[1]) && times.len() > 1, "{times:?}");
    // At most one each fifth of a second, however often the progress changes.
    let most = begin.elapsed().as_secs_f64() / 0.2 + 2.0;
    assert!((seen.len() as f64) < most, "{} of {most}", seen.len());
    assert_eq!((&job["resumable"], &job["folder"]), (&json!(true), &json!("out/Vertical well")));
    // The soft string was solved before, and its checks are kept.
    assert!(served.path().join("out/Vertical well/checkpoint.bin").is_file());
    until(&served, &next, is("finished"));

    // The same work cannot replace unfinished work, as on the command line.
    let over = start(&served, &json!({"case": case, "work": {"kind": "run"}}));
    let over = until(&served, &over, is("refused"));
    assert_eq!((&over["refusal"], &over["folder"]), (&json!("unfinished"), &Value::Null));
    assert_eq!(over["message"], "out/Vertical well holds an unfinished run of this case");

    // It continues where it stopped.
    let reached = times.last().copied().unwrap();
    assert_eq!(served.post(&format!("{path}/resume"), &json!({})).status, 204);
    let job = until(&served, &id, moves);
    assert!(job["progress"]["bars"][0]["reached_s"].as_f64().unwrap() >= reached);
    // A server that ends saves it, and the next one offers to continue.
    served.restart(|_| ());
    let job = served.get(&format!("/api/jobs/{id}")).ok();
    assert_eq!((&job["state"], &job["resumable"]), (&json!("interrupted"), &json!(true)));
    let results = served.get("/api/results").ok();
    let results = results.as_array().unwrap();
    let run = results.iter().find(|row| row["path"] == "out/Vertical well").unwrap();
    assert_eq!(run["unfinished"], true);
    // It is forgotten on request; the results stay.
    assert_eq!(served.delete(&path).status, 204);
    assert_eq!(served.get(&path).error(404), "not_found");
    assert!(served.path().join("out/Vertical well/checkpoint.bin").is_file());
}

/// Turns the record of a job into the one that a killed program leaves.
fn as_if_killed(folder: &Path, id: &str) {
    let file = folder.join(format!(".wholestring/jobs/{id}.json"));
    let mut job: Value = serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    job["state"] = json!("running");
    job["message"] = Value::Null;
    fs::write(&file, job.to_string()).unwrap();
}

#[test]
fn what_a_killed_server_has_begun_comes_to_the_same_end() {
    let case = dynamic("2000 s");
    let mut served = Served::with(&[("a.toml", &case)]);
    let id = start(&served, &json!({"case": served.id("a.toml"), "work": {"kind": "run"}}));
    until(&served, &id, moves);
    served.post(&format!("/api/jobs/{id}/stop"), &json!({}));
    until(&served, &id, is("stopped"));
    served.restart(|folder| as_if_killed(folder, &id));
    let job = served.get("/api/jobs").ok()[0].clone();
    assert_eq!((&job["state"], &job["resumable"]), (&json!("interrupted"), &json!(true)));
    served.post(&format!("/api/jobs/{id}/resume"), &json!({}));
    let job = until(&served, &id, is("finished"));
    assert_eq!(job["folder"], "out/Vertical well");
    // Identical to every digit to an uninterrupted run.
    let whole = Served::with(&[("a.toml", &case)]);
    let other = start(&whole, &json!({"case": whole.id("a.toml"), "work": {"kind": "run"}}));
    until(&whole, &other, is("finished"));
    let numbers = |served: &Served| -> Vec<Value> {
        let file = served.path().join("out/Vertical well/summary.json");
        let summary: Value = serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap();
        let all = summary["operations"].as_array().unwrap().iter();
        all.flat_map(|row| [row["hook_load_N"].clone(), row["surface_torque_N_m"].clone()])
            .collect()
    };
    assert_eq!(numbers(&served), numbers(&whole));
    // A case that has changed since is not continued.
    let other = start(
        &served,
        &json!({"case": served.id("a.toml"), "work": {"kind": "run"},
        "set": {"friction": "0.1"}, "if_there": "resume"}),
    );
    assert_eq!(until(&served, &other, is("refused"))["refusal"], "not_resumable");
}

#[test]
fn only_so_many_wait_and_one_server_works() {
    let served = Served::with(&[("a.toml", &dynamic("15000 s"))]);
    let request = json!({"case": served.id("a.toml"), "work": {"kind": "run"}});
    let first = start(&served, &request);
    until(&served, &first, |job| job["state"] == "running");
    let waiting: Vec<String> = (0..20).map(|_| start(&served, &request)).collect();
    let refused = served.post("/api/jobs", &request);
    assert_eq!(refused.error(409), "conflict");
    assert!(refused.text().contains("20 jobs are waiting already"));
    assert_eq!(served.post(&format!("/api/jobs/{}/stop", waiting[3]), &json!({})).status, 204);
    assert_eq!(served.get(&format!("/api/jobs/{}", waiting[3])).ok()["state"], "stopped");
    start(&served, &request);

    // A second program on the folder shows the job and leaves it to the first.
    let address = wholestring_app::Address::Automatic;
    let options = wholestring_app::Options { folder: served.path().to_owned(), port: 0, address };
    let server = wholestring_app::Server::bind(&options).unwrap();
    let (links, stop) = (server.links(), server.stop());
    let thread = std::thread::spawn(move || server.run().unwrap());
    let (host, code) = crate::common::parts(&links.address(|| {}).unwrap());
    let port: u16 = host.rsplit(':').next().unwrap().parse().unwrap();
    let cookie = crate::common::cookie(&crate::common::enter(port, &host, &code)).unwrap();
    let ask = |method: &str, path: &str, body: &str| {
        let head = format!(
            "{method} {path} HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\n\
             Cookie: {cookie}\r\nContent-Type: application/json\r\n\
             Content-Length: {}\r\nConnection: close\r\n\r\n",
            body.len()
        );
        crate::common::exchange(port, &head, body.as_bytes())
    };
    let jobs = ask("GET", "/api/jobs", "").ok();
    assert_eq!(jobs.as_array().unwrap().len(), 22);
    assert_eq!(jobs[0]["state"], "running");
    assert_eq!(ask("POST", "/api/jobs", &request.to_string()).error(409), "conflict");
    let stopped = ask("POST", &format!("/api/jobs/{first}/stop"), "{}");
    assert_eq!(stopped.error(409), "conflict");
    stop.stop();
    thread.join().unwrap();
    assert_eq!(served.get(&format!("/api/jobs/{first}")).ok()["state"], "running");
}
