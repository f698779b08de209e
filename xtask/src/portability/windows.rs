//! Wine, with folders of its own.

use std::{ffi::OsString, fs, path::PathBuf, process::Command};

use crate::{
    command::{Failure, run},
    folders::{root, target},
};

/// Debian keeps it out of the way of its 32-bit twin.
pub(super) const WINE: &str = "/usr/lib/wine/wine64";

/// What its programs talk to.
const SERVER: &str = "/usr/lib/wine/wineserver64";

/// Rust asks this library for random numbers, and Wine 8 has none of it.
const RANDOM: &str = "bcryptprimitives.dll";

/// It hands the question on. For tests alone.
const SOURCE: &str = "\
#include <windows.h>
#include <ntsecapi.h>
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE data, SIZE_T length) {
    return RtlGenRandom(data, (ULONG)length);
}
";

/// Where Wine keeps the system that it shows to programs.
pub(super) fn prefix() -> PathBuf {
    target().join("portability/wine")
}

/// What programs under Wine, and Wine itself, are told.
pub(super) fn environment() -> Vec<(String, OsString)> {
    // Temporary files on the disk that Linux has, for the tests' paths are its own.
    let temporary = format!("Z:{}", temporary().to_string_lossy().replace('/', "\\"));
    vec![
        ("WINEPREFIX".into(), prefix().into()),
        ("WINEDEBUG".into(), "-all".into()),
        ("WINEDLLOVERRIDES".into(), "mscoree,mshtml,winemenubuilder.exe=".into()),
        // Tests would ask cargo, which is none of Windows' here.
        ("INSTA_WORKSPACE_ROOT".into(), root().into()),
        ("TMP".into(), temporary.clone().into()),
        ("TEMP".into(), temporary.into()),
    ]
}

fn temporary() -> PathBuf {
    target().join("portability/temporary")
}

/// Makes the system where it is not there from another time.
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
    // A server that ends three seconds after its last program breaks off with one that begins just
    // then. It says so where there is one already.
    let mut server = Command::new(SERVER);
    let started = server.envs(environment()).arg("--persistent=600").status();
    started.map(|_| ()).map_err(|error| failed(SERVER, error))
}
