//! The words of headings.

use std::{
    collections::{HashMap, HashSet},
    sync::LazyLock,
};

use crate::columns::column::Column;

/// Names of columns, in lower case without blanks, with their rank.
pub(crate) const NAMES: &[(Column, u8, &str)] = &[
    (
        Column::MeasuredDepth,
        0,
        "md measureddepth measdepth mdepth mddepth depthmd alongholedepth ahd ahdepth mdrt mdrkb \
         mdkb mdbrt mdrte dmea measureddepthmd mdmeasureddepth measuredepth",
    ),
    (Column::MeasuredDepth, 1, "depth dept"),
    (
        Column::Inclination,
        0,
        "inc incl incli inclin inclination inclangle incangle inclinationangle drift driftangle \
         dev deviation devi holeangle",
    ),
    (
        Column::Azimuth,
        1,
        "azi az azim azimuth azimut azm azmth azimuthangle hazi direction holedirection",
    ),
    (
        Column::TrueVerticalDepth,
        0,
        "tvd truevertical verticaldepth vertdepth vdepth tvdepth tvddepth tvdrt tvdrkb tvdkb \
         tvdbrt verticaldepthtvd",
    ),
    (Column::North, 0, "north ns n northsouth nsoffset northoffset"),
    (Column::North, 1, "northing northings"),
    (Column::East, 0, "east ew e eastwest ewoffset eastoffset"),
    (Column::East, 1, "easting eastings"),
    (
        Column::BitDepth,
        0,
        "bitdepth bitmd mdbit depthbit depthofbit bitmeasureddepth mdofbit bitdepthmd dbtm",
    ),
    (Column::BitDepth, 1, "md measureddepth mdepth depthmd dmea holedepth"),
    (Column::BitDepth, 2, "depth dept"),
    (
        Column::PickUp,
        0,
        "pickup pickupweight pickupload pickuphookload hookloadpickup puw pu puwt pickupwt up upweight tripout \
         tripoutweight pullout hookloadup",
    ),
    (
        Column::SlackOff,
        0,
        "slackoff slackoffweight slackoffload slackoffhookload hookloadslackoff sow so sowt slackoffwt down \
         downweight tripin tripinweight hookloaddown",
    ),
    (
        Column::Rotating,
        0,
        "rotating rotatingweight rotatingload rotatinghookload hookloadrotating rotatingoffbottom \
         rotatingoffbottomweight rob robweight rotw rotwt rotatingwt freerotating freerotatingweight frw",
    ),
    (
        Column::Torque,
        0,
        "torqueoffbottom offbottomtorque torqueoff rotatingtorque freerotatingtorque freetorque offbtmtorque \
         robtorque torquerob torqueoffbottomrotating rotatingoffbottomtorque rotatingtorqueoffbottom \
         torquerotating torquerotatingoffbottom torquefreerotating",
    ),
    (Column::Torque, 1, "torque surfacetorque tq trq"),
    (
        Column::TorqueOnBottom,
        0,
        "torqueonbottom onbottomtorque torqueon drillingtorque torquedrilling onbtmtorque \
         torquewhiledrilling drillingtorqueonbottom torqueonbottomdrilling",
    ),
    (Column::MudDensity, 0, "mud muddensity mudweight mudwt mw mudin densityofmud"),
    (Column::Case, 0, "case"),
    (Column::Use, 0, "use"),
    (
        Column::Number,
        0,
        "no nr num number item itemno itemnumber pos position order seq sequence index elementno \
         componentno jointno jtno jointnumber joint jt",
    ),
    (
        Column::Component,
        0,
        "component components description desc descr element elements itemdescription \
         componentdescription tool tooldescription toolname bhacomponent bhaelement componentname \
         elementname componenttype elementtype elementdescription name",
    ),
    (Column::Component, 1, "type designation tubular pipe"),
    (
        Column::OutsideDiameter,
        0,
        "od outsidediameter outerdiameter outsidedia outerdia outsidediam outerdiam bodyod pipeod \
         tubeod odbody nomod nominalod bodyoutsidediameter",
    ),
    (Column::OutsideDiameter, 1, "diameter dia diam size"),
    (
        Column::InsideDiameter,
        0,
        "id insidediameter innerdiameter insidedia innerdia insidediam innerdiam bodyid pipeid \
         tubeid idbody nomid nominalid bore bodyinsidediameter",
    ),
    (
        Column::Gauge,
        0,
        "gauge gaugeod gage gageod gaugediameter gaugedia gaugesize odgauge bladeod bladesod \
         bladediameter bladedia odblade odblades overblades stabod stabgauge stabiliserod \
         stabilizerod stabilisergauge stabilizergauge bitsize bladegauge",
    ),
    (
        Column::Gauge,
        1,
        "maxod odmax maximumod maxdiameter maxdia maxdiam maximumdiameter maxoutsidediameter \
         maximumoutsidediameter bladegaugeod gaugebladeod stabbladeod bladestabod",
    ),
    (
        Column::Joints,
        0,
        "jts joints jnts noofjoints nojoints numberofjoints numjoints jointcount count qty \
         quantity nojts noofjts noofitems pcs",
    ),
    (
        Column::Length,
        0,
        "length len lengths lgth itemlength componentlength elementlength toollength sectionlength",
    ),
    (Column::Length, 1, "totallength lengthtotal"),
    (
        Column::JointLength,
        0,
        "jointlength lengthperjoint lengthjoint lengthjt lengthperjt avglength averagelength \
         jtlength avgjointlength averagejointlength avgjtlength lengtheach lengthperitem unitlength \
         singlelength jointspacing",
    ),
    (
        Column::CumulativeLength,
        0,
        "cumulative cum cumul cumlength cumlen cumulativelength cumullength lengthcum \
         lengthcumulative runningtotal runninglength accumulated accumlength accumulatedlength \
         accumulativelength acclength accumulative distancefrombit distfrombit distancetobit",
    ),
    (
        Column::Mass,
        0,
        "adjweight adjwt adjustedweight approxweight approxwt approximateweight avgweight \
         averageweight actualweight weightperlength wtperlength massperlength linearweight \
         linearmass linweight unitweight unitmass weightperfoot wtperft airweight",
    ),
    (Column::Mass, 1, "weight wt wgt mass weightinair"),
    (
        Column::NominalMass,
        0,
        "nominalweight nomweight nomwt nominalwt nominalmass weightnominal wtnom",
    ),
    (
        Column::TotalMass,
        0,
        "totalweight totalmass totalwt totwt weighttotal itemweight componentweight",
    ),
    (
        Column::JointOutsideDiameter,
        0,
        "jointod tooljointod tjod odjoint odtooljoint odtj tooljointoutsidediameter \
         tooljointouterdiameter tooljointdiameter",
    ),
    (
        Column::JointInsideDiameter,
        0,
        "jointid tooljointid tjid idjoint idtooljoint idtj tooljointinsidediameter \
         tooljointinnerdiameter",
    ),
    (
        Column::Connection,
        0,
        "connection connections conn connectiontype conntype thread threads tooljoint \
         tooljointtype tooljointconnection",
    ),
    (
        Column::Connection,
        1,
        "topconnection topconn bottomconnection bottomconn upperconnection lowerconnection pinbox \
         boxpin connectionup connectiondown",
    ),
    (Column::Grade, 0, "grade steelgrade materialgrade pipegrade"),
    (Column::YieldStrength, 0, "yieldstrength minyield minimumyield minyieldstrength smys"),
    (Column::BladeLength, 0, "bladelength bladeslength lengthofblades"),
    (
        Column::MetalDensity,
        0,
        "metaldensity materialdensity steeldensity densityofmetal densityofmaterial",
    ),
    (
        Column::YoungsModulus,
        0,
        "youngsmodulus youngmodulus elasticmodulus modulusofelasticity emodulus",
    ),
    (Column::ShearModulus, 0, "shearmodulus gmodulus modulusofrigidity"),
];

/// Columns by name, in the order of [`NAMES`]: a table of numbers with a hundred columns needs a
/// million look-ups.
static COLUMNS: LazyLock<HashMap<&'static str, Vec<(Column, u8)>>> = LazyLock::new(|| {
    let mut columns: HashMap<&str, Vec<(Column, u8)>> = HashMap::new();
    for &(column, rank, names) in NAMES {
        for name in names.split(' ') {
            columns.entry(name).or_default().push((column, rank));
        }
    }
    columns
});

/// The length of the longest name, bytes.
static LONGEST: LazyLock<usize> =
    LazyLock::new(|| COLUMNS.keys().map(|name| name.len()).max().unwrap_or(0));

/// Columns that a name in lower case without blanks may denote, the most likely first.
pub(crate) fn columns_named(name: &str) -> &'static [(Column, u8)] {
    if name.len() > *LONGEST {
        return &[];
    }
    COLUMNS.get(name).map_or(&[], Vec::as_slice)
}

/// Words that a heading may contain in addition to its name.
static BESIDE: LazyLock<HashSet<&'static str>> = LazyLock::new(|| {
    let words = "the of from at in survey station hole well wellbore borehole rkb kb rt rte brt ref \
                 reference grid true mag magnetic corr corrected map local gyro mwd value data calc \
                 calculated computed final tn gn mn";
    words.split(' ').collect()
});

/// Whether a word in lower case may accompany a name.
pub(crate) fn is_beside(word: &str) -> bool {
    BESIDE.contains(word)
}

/// The full form of an abbreviated word in a heading of readings, in lower case.
pub(crate) fn written_out(word: &str) -> &str {
    match word {
        "tq" | "trq" | "trque" | "torq" | "tor" => "torque",
        "btm" | "bot" | "bttm" | "btom" | "bott" => "bottom",
        "wt" | "wgt" | "wght" | "weights" => "weight",
        "hkld" | "hkl" | "hookld" | "hkload" => "hookload",
        "rot" | "rotn" | "rotg" | "rotate" | "rotation" => "rotating",
        "dn" | "dwn" => "down",
        "drlg" | "drl" | "drill" | "drlng" => "drilling",
        "pickingup" => "pickup",
        "slackingoff" => "slackoff",
        other => other,
    }
}

/// Whether a word in lower case means that depths are below the sea instead of the rig floor, which
/// is another column.
pub(crate) fn is_subsea(word: &str) -> bool {
    matches!(word, "ss" | "subsea" | "msl" | "sea" | "tvdss" | "sstvd")
}

// The sorts of tables that are read.

/// A sort of table: its possible columns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sort {
    /// Every column, the required ones first.
    pub(crate) columns: &'static [Column],
    /// The required columns.
    pub(crate) needed: &'static [Column],
}

/// Stations of a path.
pub(crate) const SURVEY: Sort = Sort { columns: &Column::ALL, needed: &Column::NEEDED };

/// Weights and torques that were read at the surface.
pub(crate) const READINGS: Sort = Sort { columns: &Column::READINGS, needed: &[Column::BitDepth] };

/// The components of a string.
pub(crate) const TALLY: Sort = Sort {
    columns: &Column::TALLY,
    needed: &[Column::Component, Column::OutsideDiameter, Column::Length],
};
