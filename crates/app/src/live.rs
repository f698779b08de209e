//! Live strings: one thread for each, which advances it.
//!
//! The strings themselves are in `wholestring_screens::live`; [`EngineRoom`] owns all of them, a
//! few at a time, and saves those to be continued in the folder.

use std::{
    collections::VecDeque,
    fmt,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::{Arc, Mutex, MutexGuard, PoisonError},
    thread::{self, JoinHandle},
    time::Duration,
};

use wholestring_screens::live::{
    Beginning, End, Engine, Keeps, KeptEntry, KeptString, LiveError, LiveString, Status,
};

use crate::{
    limits::Limits,
    workspace::{KeptFile, Workspace},
};

// The engine room: all live strings, a few at a time.

fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // The state behind these locks is consistent between any two lines.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Maximum number of ended strings whose reason is remembered.
const MOST_ENDED: usize = 16;

struct Running {
    string: Arc<LiveString>,
    thread: JoinHandle<()>,
}

/// A string that has ended.
#[derive(Debug, Clone)]
pub(crate) struct Ended {
    pub(crate) id: String,
    pub(crate) case: String,
    pub(crate) name: String,
    pub(crate) operation: &'static str,
    pub(crate) status: Status,
}

#[derive(Default)]
struct Strings {
    running: Vec<Running>,
    /// Number of strings that are being initialised.
    beginning: usize,
    ended: VecDeque<Ended>,
    closed: bool,
}

/// All live strings.
pub(crate) struct EngineRoom {
    limits: Limits,
    workspace: Arc<Workspace>,
    strings: Arc<Mutex<Strings>>,
}

impl fmt::Debug for EngineRoom {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "EngineRoom({} strings)", held(&self.strings).running.len())
    }
}

/// Releases the reserved place of a string that fails to start.
struct Place<'a>(&'a Mutex<Strings>);

impl Drop for Place<'_> {
    fn drop(&mut self) {
        held(self.0).beginning -= 1;
    }
}

impl EngineRoom {
    pub(crate) fn new(limits: Limits, workspace: Arc<Workspace>) -> Self {
        Self { limits, workspace, strings: Arc::default() }
    }

    /// Starts a string, initially paused, and returns its id. This takes a second or more.
    ///
    /// # Errors
    /// Too many strings, and a string that cannot be solved.
    pub(crate) fn begin(&self, from: Beginning) -> Result<String, LiveError> {
        let most = self.limits.live_strings;
        let _place = {
            let mut strings = held(&self.strings);
            if strings.closed {
                return Err(LiveError::Ended("the program is about to end".to_owned()));
            }
            if strings.running.len() + strings.beginning >= most {
                let message = format!("{most} strings are live already: end one of them first");
                return Err(LiveError::TooMany(message));
            }
            strings.beginning += 1;
            Place(&self.strings)
        };
        let mut random = [0; 8];
        getrandom::fill(&mut random).map_err(|error| LiveError::Failed(error.to_string()))?;
        let id: String = random.iter().map(|byte| format!("{byte:02x}")).collect();
        let keeps = Keeps {
            samples: self.limits.live_samples,
            checkpoint_bytes: self.limits.live_checkpoint_bytes,
        };
        let engine = Engine::begin(&id, from, &keeps)?;
        let (string, idle) = (engine.string(), self.limits.live_idle);
        let (all, workspace, own) = (self.strings.clone(), self.workspace.clone(), string.clone());
        // The string is listed before its thread may remove it.
        let mut strings = held(&self.strings);
        let thread = thread::Builder::new().name("live string".to_owned()).spawn(move || {
            let end = catch_unwind(AssertUnwindSafe(|| go_on(engine, idle)));
            ended(&all, &workspace, &own, end.ok());
        });
        let thread = thread.map_err(|error| LiveError::Failed(error.to_string()))?;
        strings.running.push(Running { string, thread });
        Ok(id)
    }

    /// Returns the string with an id.
    ///
    /// # Errors
    /// The reason of its end, or that it never existed.
    pub(crate) fn string(&self, id: &str) -> Result<Arc<LiveString>, LiveError> {
        let strings = held(&self.strings);
        let found = strings.running.iter().find(|one| one.string.layout.id == id);
        if let Some(found) = found {
            return Ok(found.string.clone());
        }
        let ended = strings.ended.iter().find(|one| one.id == id);
        match ended.and_then(|one| one.status.sentence.clone()) {
            Some(sentence) => Err(LiveError::Ended(sentence)),
            None => Err(LiveError::Nothing("live string")),
        }
    }

    /// All live strings, and those that have ended.
    pub(crate) fn all(&self) -> (Vec<Arc<LiveString>>, Vec<Ended>) {
        let strings = held(&self.strings);
        let running = strings.running.iter().map(|one| one.string.clone()).collect();
        (running, strings.ended.iter().cloned().collect())
    }

    /// Ends and saves all strings. Called once, after the last request.
    pub(crate) fn close(&self) {
        let running = {
            let mut strings = held(&self.strings);
            strings.closed = true;
            std::mem::take(&mut strings.running)
        };
        let sentence = "the program was ended; the string is kept as it was and can be continued";
        running.iter().for_each(|one| one.string.end(sentence, true));
        for one in running {
            // A panic of the thread has already been reported.
            let _ = one.thread.join();
        }
    }
}

/// Handles the end of an engine; without an `end` it has panicked.
fn ended(strings: &Mutex<Strings>, workspace: &Workspace, string: &LiveString, end: Option<End>) {
    let sentence = match end {
        None => "internal error of the program; the string has ended".to_owned(),
        Some(End { mut sentence, checkpoint }) => {
            if let Some(checkpoint) = checkpoint {
                let whole = KeptString { checkpoint, ..string.as_kept() };
                if let Err(error) = keep_string(&whole, workspace) {
                    sentence = format!("{sentence} ({error})");
                }
            }
            sentence
        }
    };
    let status = string.ended(sentence);
    let mut strings = held(strings);
    let layout = &string.layout;
    strings.running.retain(|one| one.string.layout.id != layout.id);
    strings.ended.push_front(Ended {
        id: layout.id.clone(),
        case: layout.case.clone(),
        name: layout.name.clone(),
        operation: layout.operation,
        status,
    });
    strings.ended.truncate(MOST_ENDED);
}

// The thread that advances a live string.

/// Advances the string until it is stopped, or has had no viewer for this time.
fn go_on(mut engine: Engine, idle: Duration) -> End {
    let string = engine.string();
    let mut wait = Duration::ZERO;
    loop {
        let mut requests = string.wanted_within(wait);
        if let Some(end) = requests.end.take() {
            return engine.end(end.sentence, end.keeps);
        }
        wait = engine.turn(requests);
        if string.unseen() > idle {
            let minutes = idle.as_secs() / 60;
            let sentence = format!(
                "without a viewer for {minutes} min, this string was ended; it is saved and can be \
                 continued"
            );
            return engine.end(sentence, true);
        }
    }
}

// Strings that are saved in the workspace, to be continued.

/// Saves a string in the folder, and returns its identifier in requests.
///
/// # Errors
/// Errors of the system.
pub(crate) fn keep_string(string: &KeptString, workspace: &Workspace) -> Result<String, LiveError> {
    let failed = |error: &dyn std::fmt::Display| LiveError::Failed(error.to_string());
    let bytes = string.bytes().map_err(|error| failed(&error))?;
    workspace.keep(&bytes).map_err(|error| failed(&error))
}

/// The saved strings of the folder, the latest first; damaged files are skipped.
pub(crate) fn kept_strings(workspace: &Workspace) -> Vec<KeptEntry> {
    let entry = |file: KeptFile| {
        let string = KeptString::of_bytes(&file.read().ok()?)?;
        Some(KeptEntry {
            name: file.name,
            case: string.case_id,
            title: string.name,
            operation: string.operation,
            time_s: string.time_s,
            modified_ms: file.modified_ms,
        })
    };
    workspace.kept().into_iter().filter_map(entry).collect()
}

/// Returns the saved string with a name.
///
/// # Errors
/// No string has it, or its file is damaged.
pub(crate) fn kept_string(workspace: &Workspace, name: &str) -> Result<KeptString, LiveError> {
    let file = workspace.kept_file(name).map_err(|_| LiveError::Nothing("kept string"))?;
    let bytes = file.read().map_err(|error| LiveError::Failed(error.to_string()))?;
    let damaged = || LiveError::Refused("the string that was kept is damaged".to_owned());
    KeptString::of_bytes(&bytes).ok_or_else(damaged)
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use wholestring_case::{InMemory, parse};
    use wholestring_screens::live::Start;

    use super::*;

    const TEXT: &str = wholestring_cases::SLANT.text;

    fn room(live_idle: Duration) -> (tempfile::TempDir, EngineRoom, String) {
        let folder = tempfile::tempdir().expect("a folder");
        let workspace = Workspace::open(folder.path()).expect("a workspace");
        let limits = Limits { live_idle, ..Limits::default() };
        let room = EngineRoom::new(limits, Arc::new(workspace));
        let case = parse("slant.toml", TEXT.as_bytes(), &InMemory::default(), &[]);
        let case = Arc::new(case.unwrap_or_else(|report| panic!("{}", report.render(false))));
        let operation = Some(case.operations[0].kind.name().to_owned());
        let start = Start::New { operation };
        let text = TEXT.to_owned();
        let from = Beginning { case_id: "0".to_owned(), text, case, start };
        let id = room.begin(from).expect("a live string");
        (folder, room, id)
    }

    /// A string without a viewer ends, reports it and is saved; one with a viewer continues.
    #[test]
    fn what_nobody_looks_at_ends_and_is_kept() {
        let (_folder, room, id) = room(Duration::from_millis(400));
        let string = room.string(&id).expect("it is there");
        let viewer = string.view();
        thread::sleep(Duration::from_millis(1200));
        assert!(!string.has_ended() && room.string(&id).is_ok());
        drop(viewer);
        let since = Instant::now();
        while !string.has_ended() {
            assert!(since.elapsed() < Duration::from_secs(20), "it goes on");
            thread::sleep(Duration::from_millis(20));
        }
        assert_eq!(kept_strings(&room.workspace).len(), 1);
        // The list is updated shortly after.
        thread::sleep(Duration::from_millis(100));
        let Err(LiveError::Ended(sentence)) = room.string(&id) else { panic!("it has ended") };
        assert!(sentence.starts_with("without a viewer"), "{sentence}");
        assert!(room.all().0.is_empty() && room.all().1.len() == 1);
    }

    #[test]
    fn a_room_that_closes_keeps_what_is_live() {
        let (_folder, room, id) = room(Duration::from_secs(60));
        room.string(&id).expect("it is there").run(true);
        room.close();
        assert_eq!(kept_strings(&room.workspace).len(), 1);
        assert!(matches!(room.string(&id), Err(LiveError::Ended(_))));
    }
}
