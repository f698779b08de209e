//! Systems and processors that can be tested on a Linux machine of x86-64.

use std::{
    env,
    ffi::OsString,
    path::{Path, PathBuf},
    process::Command,
};

use super::windows;

/// A system or a processor other than this machine's.
pub(super) struct System {
    /// Its name on the command line.
    pub(super) name: &'static str,
    /// Its description.
    pub(super) about: &'static str,
    /// Its target name in Rust, if the program must be built for it.
    pub(super) target: Option<&'static str>,
    /// Programs that it requires, and their Debian packages.
    needs: &'static [(&'static str, &'static str)],
    /// Program that runs its programs.
    runner: &'static [&'static str],
    /// Runs whose numbers may differ from this machine's in single bits.
    pub(super) may_differ: &'static [&'static str],
    /// Whether the command-line tests are run there; an emulated processor of the same system does
    /// not change the handling of files.
    pub(super) is_tested: bool,
}

const WINDOWS: &str = "x86_64-pc-windows-gnu";
const AARCH64: &str = "aarch64-unknown-linux-gnu";

pub(super) const SYSTEMS: &[System] = &[
    System {
        name: "windows",
        about: "Windows on x86-64, by Wine",
        target: Some(WINDOWS),
        needs: &[("x86_64-w64-mingw32-gcc", "gcc-mingw-w64-x86-64"), (windows::WINE, "wine64")],
        runner: &[windows::WINE],
        may_differ: &[],
        is_tested: true,
    },
    System {
        name: "avx2",
        about: "x86-64 with AVX2 and no AVX-512, by QEMU",
        target: None,
        needs: &[("qemu-x86_64", "qemu-user")],
        runner: &["qemu-x86_64", "-cpu", "Haswell"],
        may_differ: &[],
        is_tested: false,
    },
    System {
        name: "baseline",
        about: "x86-64 without AVX2 and fused multiply-add, by QEMU",
        target: None,
        needs: &[("qemu-x86_64", "qemu-user")],
        runner: &["qemu-x86_64", "-cpu", "Nehalem"],
        // Single-precision operations are fused if the processor supports it.
        may_differ: &["single"],
        is_tested: false,
    },
    System {
        name: "aarch64",
        about: "Linux on 64-bit ARM, by QEMU",
        target: Some(AARCH64),
        needs: &[
            ("aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu libc6-dev-arm64-cross"),
            ("qemu-aarch64", "qemu-user"),
        ],
        runner: &["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"],
        may_differ: &[],
        is_tested: true,
    },
];

impl System {
    pub(super) fn is_windows(&self) -> bool {
        self.target == Some(WINDOWS)
    }

    /// Commands that install missing packages, one each.
    pub(super) fn lacking(&self) -> Vec<String> {
        let mut lacking = Vec::new();
        if let Some(triple) = self.target.filter(|triple| !is_installed(triple)) {
            lacking.push(format!("rustup target add {triple}"));
        }
        let missing = self.needs.iter().filter(|(program, _)| !is_there(program));
        let packages: Vec<_> = missing.map(|(_, package)| *package).collect();
        if !packages.is_empty() {
            lacking.push(format!("apt-get install {}", packages.join(" ")));
        }
        lacking
    }

    /// The program's name there.
    pub(super) fn file_name(&self) -> &'static str {
        if self.is_windows() { "wholestring.exe" } else { "wholestring" }
    }

    /// Words before a program's path.
    pub(super) fn runner(&self) -> Vec<OsString> {
        self.runner.iter().map(OsString::from).collect()
    }

    /// Environment in which cargo builds for it.
    pub(super) fn building(&self) -> Vec<(String, OsString)> {
        let Some(triple) = self.target else { return Vec::new() };
        let name =
            |what: &str| format!("CARGO_TARGET_{}_{what}", triple.to_uppercase().replace('-', "_"));
        let (compiler, _) = self.needs[0];
        vec![(name("LINKER"), compiler.into()), (name("RUNNER"), self.runner.join(" ").into())]
    }

    /// Environment of programs that run there.
    pub(super) fn running(&self) -> Vec<(String, OsString)> {
        if self.is_windows() { windows::environment() } else { Vec::new() }
    }
}

/// Whether Rust's standard library is installed for a target.
fn is_installed(triple: &str) -> bool {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let sysroot = Command::new(rustc).args(["--print", "sysroot"]).output();
    sysroot.is_ok_and(|output| {
        let root = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        Path::new(&root).join("lib/rustlib").join(triple).is_dir()
    })
}

/// Whether a program can be started, by its path or from the folders of `PATH`.
fn is_there(program: &str) -> bool {
    let folders = env::var_os("PATH").unwrap_or_default();
    // An absolute path is unchanged.
    let places: Vec<PathBuf> = env::split_paths(&folders).map(|at| at.join(program)).collect();
    places.iter().any(|at| at.is_file())
}
