//! Wine with its own folders.

use std::{ffi::OsString, fs, path::PathBuf, process::Command};

use crate::{
    command::{Failure, run},
    folders::{root, target},
};

/// Debian's path that avoids a conflict with the 32-bit version.
pub(super) const WINE: &str = "/usr/lib/wine/wine64";

/// Server process of its programs.
const SERVER: &str = "/usr/lib/wine/wineserver64";

/// Library of random numbers that Rust requires and Wine 8 lacks.
const RANDOM: &str = "bcryptprimitives.dll";

/// It forwards the call. For tests only.
const SOURCE: &str = "\
#include <windows.h>
#include <ntsecapi.h>
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE data, SIZE_T length) {
    return RtlGenRandom(data, (ULONG)length);
}
";

/// Wine's folder of the emulated system.
pub(super) fn prefix() -> PathBuf {
    target().join("portability/wine")
}

/// Environment of Wine and its programs.
pub(super) fn environment() -> Vec<(String, OsString)> {
    // Temporary files on the Linux disk, because the tests use its paths.
    let temporary = format!("Z:{}", temporary().to_string_lossy().replace('/', "\\"));
    vec![
        ("WINEPREFIX".into(), prefix().into()),
        ("WINEDEBUG".into(), "-all".into()),
        ("WINEDLLOVERRIDES".into(), "mscoree,mshtml,winemenubuilder.exe=".into()),
        // Tests would call cargo, which is not a Windows program here.
        ("INSTA_WORKSPACE_ROOT".into(), root().into()),
        ("TMP".into(), temporary.clone().into()),
        ("TEMP".into(), temporary.into()),
    ]
}

fn temporary() -> PathBuf {
    target().join("portability/temporary")
}

/// Creates the system if it does not exist.
pub(super) fn prepare(prefix: &std::path::Path) -> Result<(), Failure> {
    let failed = |what: &str, error: std::io::Error| Failure::new(format!("{what}: {error}"));
    fs::create_dir_all(temporary()).map_err(|error| failed("temporary files", error))?;
    let system = prefix.join("drive_c/windows/system32");
    if !system.is_dir() {
        fs::create_dir_all(prefix).map_err(|error| failed("Wine's folder", error))?;
        let mut boot = Command::new(WINE);
        run(boot.envs(environment()).args(["wineboot", "--init"]), "Wine must start")?;
    }
    let library = system.join(RANDOM);
    if !library.is_file() {
        let source = prefix.join("random.c");
        fs::write(&source, SOURCE).map_err(|error| failed("the library's source", error))?;
        let mut compiler = Command::new("x86_64-w64-mingw32-gcc");
        compiler.args(["-shared", "-O1", "-o"]).arg(&library).arg(&source).arg("-ladvapi32");
        run(&mut compiler, "the library must compile")?;
    }
    // A server ends three seconds after its last program, and a program that starts at that moment
    // fails. Starting a second server reports the first one.
    let mut server = Command::new(SERVER);
    let started = server.envs(environment()).arg("--persistent=600").status();
    started.map(|_| ()).map_err(|error| failed(SERVER, error))
}
