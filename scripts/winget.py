"""Manifests with which Windows' package manager installs a release, in version 1.10 of its schema.

    python scripts/winget.py SHA256  # the checksum of the archive for Windows

Writes the templates of `.github/winget` into `target/winget`, with the version and the texts of
the command's crate. Tools that make manifests download the archive, which a draft of a release
does not offer yet.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[1]
FOLDER = ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "winget"
# The crate of the command, after which dist names archives.
COMMAND = "wholestring-cli"

# Keys that the schema requires; those of an installer may be anywhere in its manifest.
COMMON = ["PackageIdentifier", "PackageVersion", "ManifestType", "ManifestVersion"]
REQUIRED = {
    "version": ["DefaultLocale"],
    "installer": ["InstallerType", "Installers", "Architecture", "InstallerUrl", "InstallerSha256"],
    "locale.en-US": ["PackageLocale", "Publisher", "PackageName", "License", "ShortDescription"],
}


def manifest(name: str, values: dict[str, str]) -> str:
    """Fill in a template: each value of a line is a text in quotes."""

    def filled(match: re.Match[str]) -> str:
        # A text in JSON is one in YAML.
        return match[1] + json.dumps(match[2].format(**values), ensure_ascii=False)

    template = (ROOT / ".github/winget" / f"{name}.yaml").read_text(encoding="utf-8")
    text = re.sub(r"^([ -]*\w+: )(.*\{.*)$", filled, template, flags=re.MULTILINE)
    for key in COMMON + REQUIRED[name]:
        if not re.search(rf"^[ -]*{key}:( .+|\n +-.+)$", text, flags=re.MULTILINE):
            raise SystemExit(f"the manifest {name} has no {key}")
    return text


def main() -> None:
    """Write the manifests."""
    sha256 = sys.argv[1]
    if not re.fullmatch("[0-9a-fA-F]{64}", sha256):
        reason = "SHA-256 of the archive for Windows has 64 digits of 0-9 and a-f"
        raise SystemExit(f"`{sha256}` is not a checksum: {reason}")
    metadata = ["cargo", "metadata", "--format-version", "1", "--no-deps", "--locked"]
    packages = json.loads(subprocess.check_output(metadata, cwd=ROOT))["packages"]
    package = next(package for package in packages if package["name"] == COMMAND)
    host, owner, _ = package["repository"].rsplit("/", 2)
    values = {key: package[key] for key in ("version", "repository", "license", "description")}
    values |= {
        "identifier": f"{owner}.wholestring",
        "host": host,
        "owner": owner,
        "sha256": sha256.upper(),
    }
    values["archive"] = f"{COMMAND}-x86_64-pc-windows-msvc.zip"
    # Files of another version would be mistaken for those of this one.
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    for name in REQUIRED:
        end = "" if name == "version" else f".{name}"
        path = FOLDER / f"{values['identifier']}{end}.yaml"
        path.write_text(manifest(name, values), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
