//! WITSML objects that are read.

/// A WITSML object that is read, in any version.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Trajectory,
    Tubular,
    BhaRun,
    Geometry,
    MudReport,
}

impl Kind {
    pub(crate) const ALL: [Kind; 5] =
        [Kind::Trajectory, Kind::Geometry, Kind::MudReport, Kind::Tubular, Kind::BhaRun];

    /// Its name in 1.3 and 1.4, which `--pick` also accepts, and that in 2.0 and 2.1 where it
    /// differs by more than capitals.
    fn names(self) -> [&'static str; 2] {
        match self {
            Kind::Trajectory => ["trajectory"; 2],
            Kind::Tubular => ["tubular"; 2],
            Kind::BhaRun => ["bhaRun"; 2],
            Kind::Geometry => ["wbGeometry", "WellboreGeometry"],
            Kind::MudReport => ["mudReport", "FluidsReport"],
        }
    }

    /// Its name in `--pick` and in messages.
    pub(crate) fn name(self) -> &'static str {
        self.names()[0]
    }

    /// The object of this name.
    pub(crate) fn of(name: &str) -> Option<Self> {
        let is = |kind: &Kind| kind.names().iter().any(|own| own.eq_ignore_ascii_case(name));
        Self::ALL.into_iter().find(is)
    }

    /// Returns the object whose plural element has this name: `trajectorys`.
    pub(crate) fn of_several(name: &str) -> Option<Self> {
        Self::of(name.strip_suffix('s')?)
    }

    /// Elements that it contains many of, and their name in messages.
    pub(crate) fn parts(self) -> (&'static str, &'static str) {
        match self {
            Kind::Trajectory => ("trajectoryStation", "station"),
            Kind::Tubular => ("tubularComponent", "component"),
            Kind::BhaRun => ("drillingParams", "set of drilling parameters"),
            Kind::Geometry => ("wbGeometrySection|WellboreGeometrySection", "section"),
            Kind::MudReport => ("fluid", "fluid"),
        }
    }
}
