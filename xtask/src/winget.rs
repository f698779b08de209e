//! Manifests for Windows' package manager to install a release, in version 1.10 of its schema: a
//! release sets its version and the checksum of the archive.

use std::fs;

use serde_json::Value;

use crate::{
    command::Failure,
    finding::Finding,
    folders::target,
    metadata::{self, list, text},
};

/// The crate of the command, after which dist names archives.
const COMMAND: &str = "wholestring-cli";

/// Suffixes of the identifier in the names of the files, and their texts.
const TEMPLATES: [(&str, &str); 3] = [
    (".yaml", include_str!("winget/version.yaml")),
    (".installer.yaml", include_str!("winget/installer.yaml")),
    (".locale.en-US.yaml", include_str!("winget/locale.en-US.yaml")),
];

/// Writes the manifests of this version into `target/winget`.
pub(crate) fn write(sha256: &str) -> Result<Finding, Failure> {
    let folder = target().join("winget");
    let cannot = |error| Failure::new(format!("{}: {error}", folder.display()));
    let manifests = manifests(&metadata::of_members()?, sha256)?;
    // Files of another version would be mistaken for those of this one.
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(cannot)?;
    }
    fs::create_dir_all(&folder).map_err(cannot)?;
    for (name, manifest) in manifests {
        fs::write(folder.join(name), manifest).map_err(cannot)?;
    }
    Ok(Finding::Done)
}

/// Names and texts of the files.
fn manifests(metadata: &Value, sha256: &str) -> Result<Vec<(String, String)>, Failure> {
    if sha256.len() != 64 || !sha256.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return Err(Failure::new(format!(
            "`{sha256}` is not a checksum: SHA-256 of the archive for Windows has 64 digits of \
             0-9 and a-f"
        )));
    }
    let package = list(&metadata["packages"]).find(|package| package["name"] == COMMAND);
    let package = package.ok_or_else(|| Failure::new(format!("there is no crate {COMMAND}")))?;
    let repository = text(&package["repository"]);
    let mut parts = repository.rsplitn(3, '/').skip(1);
    let (Some(owner), Some(host)) = (parts.next(), parts.next()) else {
        let reason = format!("`{repository}` names no owner: HOST/OWNER/NAME is expected");
        return Err(Failure::new(reason));
    };
    let identifier = format!("{owner}.wholestring");
    let archive = format!("{COMMAND}-x86_64-pc-windows-msvc.zip");
    let values = [
        ("{identifier}", identifier.as_str()),
        ("{version}", text(&package["version"])),
        ("{repository}", repository),
        ("{host}", host),
        ("{owner}", owner),
        ("{archive}", &archive),
        ("{sha256}", &sha256.to_ascii_uppercase()),
        ("{license}", text(&package["license"])),
        ("{description}", text(&package["description"])),
    ];
    let filled = |template: &str| {
        let all = values.iter();
        all.fold(template.to_owned(), |text, (place, value)| text.replace(place, value))
    };
    let files = TEMPLATES.iter();
    Ok(files.map(|(end, template)| (format!("{identifier}{end}"), filled(template))).collect())
}

#[cfg(test)]
mod tests {
    use saphyr_parser::{Event, Parser};
    use serde_json::Map;

    use super::*;

    const SUM: &str = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";

    /// Required keys of each kind of manifest in the schema.
    const REQUIRED: [(&str, &[&str]); 3] = [
        ("version", &["DefaultLocale"]),
        ("installer", &["Installers"]),
        (
            "defaultLocale",
            &["PackageLocale", "Publisher", "PackageName", "License", "ShortDescription"],
        ),
    ];

    /// Required keys of each installer; the schema allows the types here or above.
    const OF_INSTALLER: [&str; 3] = ["Architecture", "InstallerUrl", "InstallerSha256"];

    /// A YAML document with its scalars as texts.
    fn parsed(yaml: &str) -> Value {
        let mut events = Parser::new_from_str(yaml).map(|event| event.expect("YAML").0);
        let begin = events.by_ref().find(|event| matches!(event, Event::DocumentStart(_)));
        assert!(begin.is_some(), "{yaml}");
        let value = next(&mut events).expect("a value");
        assert!(matches!(events.next(), Some(Event::DocumentEnd)), "{yaml}");
        assert!(matches!(events.next(), Some(Event::StreamEnd)), "{yaml}");
        value
    }

    fn next<'a>(events: &mut impl Iterator<Item = Event<'a>>) -> Option<Value> {
        match events.next()? {
            Event::Scalar(text, ..) => Some(Value::String(text.into_owned())),
            Event::SequenceStart(..) => {
                let mut all = Vec::new();
                while let Some(value) = next(events) {
                    all.push(value);
                }
                Some(Value::Array(all))
            }
            Event::MappingStart(..) => {
                let mut all = Map::new();
                while let Some(key) = next(events) {
                    let twice = all.insert(text(&key).to_owned(), next(events)?);
                    assert!(twice.is_none(), "{key} stands twice");
                }
                Some(Value::Object(all))
            }
            _ => None,
        }
    }

    fn of_the_workspace() -> Value {
        metadata::of_members().unwrap_or_else(|failure| panic!("{}", failure.reason))
    }

    fn refused(sha256: &str) -> String {
        manifests(&of_the_workspace(), sha256).map_or_else(|failure| failure.reason, |_| panic!())
    }

    #[test]
    fn manifests_have_what_the_schema_requires() {
        let metadata = of_the_workspace();
        let command = list(&metadata["packages"]).find(|package| package["name"] == COMMAND);
        let version = &command.expect("the crate of the command")["version"];
        let files =
            manifests(&metadata, SUM).unwrap_or_else(|failure| panic!("{}", failure.reason));
        for ((name, yaml), (kind, required)) in files.iter().zip(REQUIRED) {
            let manifest = parsed(yaml);
            let identifier = text(&manifest["PackageIdentifier"]);
            assert!(name.starts_with(&format!("{identifier}.")), "{name}");
            assert_eq!(manifest["ManifestType"], kind, "{name}");
            assert_eq!(manifest["ManifestVersion"], "1.10.0", "{name}");
            assert_eq!(&manifest["PackageVersion"], version, "{name}");
            for key in required {
                let value = &manifest[key];
                assert!(value.is_array() || text(value).len() >= 2, "{name}: {key}");
            }
            for installer in list(&manifest["Installers"]) {
                let has = |key: &&str| !text(&installer[key]).is_empty();
                assert!(OF_INSTALLER.iter().all(has), "{name}");
                assert_eq!(text(&installer["InstallerSha256"]), SUM.to_uppercase());
            }
            assert!(!yaml.contains(['{', '}']), "{name} is not filled in: {yaml}");
        }
    }

    #[test]
    fn a_sum_that_is_none_is_refused() {
        assert!(refused("12ab").starts_with("`12ab` is not a checksum"));
        assert!(refused(&SUM.replace('0', "g")).contains("is not a checksum"));
    }
}
