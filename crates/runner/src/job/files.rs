//! The files that a job names: on the disk, in a folder of the app, or in memory.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use wholestring_case::{Case, Override, Template};
use wholestring_study::Study;

use crate::{error::Error, study, survey};

/// Source of the files that a job names.
pub trait JobFiles {
    /// The case of this name.
    ///
    /// # Errors
    /// It cannot be read.
    fn case(&self, name: &Path) -> Result<CaseInput, Error>;

    /// The `readings` or `curves` of this name; `noun` is the word for them.
    ///
    /// # Errors
    /// They cannot be read.
    fn data(&self, name: &Path, noun: &str) -> Result<DataInput, Error>;

    /// The study of this name.
    ///
    /// # Errors
    /// It cannot be read, or has mistakes.
    fn study(&self, name: &Path) -> Result<Study, Error>;

    /// The case that a study names, relative to the study.
    ///
    /// # Errors
    /// It cannot be read.
    fn study_case(&self, study: &Path, name: &str) -> Result<Template, Error>;
}

/// A case file.
#[derive(Debug, Clone)]
pub struct CaseInput {
    /// Name of the file, without extension.
    pub file: String,
    /// The case file.
    pub template: Arc<Template>,
    /// Changes that precede those of the job.
    pub changes: Vec<Override>,
    /// The case with these changes, where it has been read already and its warnings are known.
    pub case: Option<Arc<Case>>,
}

impl CaseInput {
    /// A file whose case is still to be read.
    pub fn new(path: &Path, template: Template) -> Self {
        let file = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Self { file, template: Arc::new(template), changes: Vec::new(), case: None }
    }
}

/// Readings, or curves of another program.
#[derive(Debug, Clone)]
pub struct DataInput {
    /// Path in messages.
    pub path: PathBuf,
    /// Content.
    pub bytes: Vec<u8>,
}

/// Files on the disk, by their paths; a case can also come through a pipe.
#[derive(Debug, Clone, Copy)]
pub struct OnDisk;

impl OnDisk {
    /// Whether the path is a pipe, which can be read only once: `/dev/stdin`, `<(...)`.
    pub fn is_pipe(path: &Path) -> bool {
        path.metadata().is_ok_and(|there| !there.is_file() && !there.is_dir())
    }

    /// The text of a case, from a file or through a pipe.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn template(path: &Path) -> Result<Template, wholestring_case::Report> {
        if Self::is_pipe(path) { Template::read_pipe(path) } else { Template::read(path) }
    }
}

impl JobFiles for OnDisk {
    fn case(&self, name: &Path) -> Result<CaseInput, Error> {
        Ok(CaseInput::new(name, Self::template(name)?))
    }

    fn data(&self, name: &Path, noun: &str) -> Result<DataInput, Error> {
        let path = name.to_owned();
        let bytes = survey::bytes(&path, noun)?;
        Ok(DataInput { path, bytes })
    }

    fn study(&self, name: &Path) -> Result<Study, Error> {
        Ok(study::load(name)?)
    }

    fn study_case(&self, study: &Path, name: &str) -> Result<Template, Error> {
        Ok(Template::read(&study.parent().unwrap_or(Path::new("")).join(name))?)
    }
}
