//! Trajectories: the order of the stations and the position of the first one.

use crate::{refusal, station, text_of, trajectory, values};

#[test]
fn stations_are_ordered_by_depth_and_stand_once() {
    let twice = |extra: &str, other: &str| {
        let one = station("1000", "3", "45").replace("</traj", &format!("{extra}</traj"));
        let two = station("1000", "4", "45").replace("</traj", &format!("{other}</traj"));
        trajectory(&(station("2000", "5", "45") + &one + &two + &station("0", "0", "0")))
    };
    let early = "<dTimStn>2024-01-01T00:00:00Z</dTimStn>";
    let late = "<dTimStn>2024-01-02T00:00:00Z</dTimStn>";
    let in_use = "<statusTrajStation>position</statusTrajStation>";
    for (one, two, inclination) in [(early, late, 4), (late, early, 3), (in_use, late, 3)] {
        let text = text_of(&twice(one, two));
        assert!(
            text.contains(&format!("[1000, {inclination}, 45],\n    [2000, 5, 45],")),
            "{text}"
        );
        assert!(text.contains("of two stations at 1000 m that in line 1: the other, in line 1,"));
    }
    let message = refusal(&twice(early, early));
    assert!(message.contains("two stations at 1000 m differ"), "{message}");
    let same = station("1000", "3", "45");
    let text = text_of(&trajectory(&(station("0", "0", "0") + &same + &same)));
    assert!(text.contains("1 station of the same depth as another and identical"), "{text}");
}

#[test]
fn what_is_no_station_is_left_out_or_refused() {
    let good = station("0", "0", "0") + &station("1000", "3", "45");
    let marker = "<trajectoryStation><md uom='m'>500</md></trajectoryStation>";
    let text = text_of(&trajectory(&(good.clone() + marker)));
    assert!(text.contains("1 station without inclination and azimuth, of no survey"));
    let vertical = station("0", "0", "").replace("<azi uom='dega'></azi>", "");
    let text = text_of(&trajectory(&(vertical + &station("1000", "3", "45"))));
    assert!(text.contains("the azi of 1 station, vertical and without one: 0"), "{text}");
    for (stations, reason) in [
        (station("0", "0", "0"), "has 1 station with inclination and azimuth"),
        (good.clone() + &station("2000", "3", ""), "the azi of this station is missing"),
        (good.clone() + &station("", "3", "4"), "the md of this station is missing"),
        (good.clone() + &station("-999.25", "3", "4"), "the md -999.25 m is out of range"),
        (good.clone() + &station("2000", "-999.25", "4"), "the incl -999.25 dega is out of range"),
        (good.clone() + &station("2000", "3", "1e9"), "the azi 1e9 dega is out of range"),
        (good.clone() + &station("NaN", "3", "4"), "'NaN' is not a number; the md"),
        (good.clone() + &station("INF", "3", "4"), "'INF' is not a number"),
        (good.clone() + &station("1e400", "3", "4"), "'1e400' is not a number"),
        (good.clone() + &station("1,000", "3", "4"), "'1,000' is not a number"),
        (good.clone() + &station("1001", "177", "225"), "its stations make no path"),
    ] {
        let message = refusal(&trajectory(&stations));
        assert!(message.contains(reason), "{message}");
    }
}

#[test]
fn an_azimuth_of_more_than_a_turn_is_reduced() {
    let text = text_of(&trajectory(&(station("0", "0", "0") + &station("1000", "3", "405"))));
    assert!(text.contains("[1000, 3, 45],"), "{text}");
    let note = "the azi of 1 station, more than 360 deg, is reduced by 360 deg";
    assert!(text.contains(note), "{text}");
}

#[test]
fn a_path_without_a_hole_from_the_surface_is_warned_of() {
    let text = text_of(&trajectory(&(station("1500", "60", "30") + &station("3000", "60", "30"))));
    assert!(text.contains("the survey begins at 1500 m with an inclination of 60 deg"), "{text}");
    let up = station("0", "0", "0") + &station("600", "140", "30") + &station("3000", "140", "30");
    let text = text_of(&trajectory(&up));
    assert!(text.contains("the hole comes out of the ground"), "{text}");
}

#[test]
fn the_first_station_says_where_it_lies() {
    let tied = "<trajectoryStation><md uom='ft'>1000</md><tvd uom='ft'>990</tvd>\
                <incl uom='dega'>5</incl><azi uom='dega'>45</azi><dispNs uom='ft'>10</dispNs>\
                <dispEw uom='ft'>-20</dispEw></trajectoryStation>";
    let text = text_of(&trajectory(&(tied.to_owned() + &station("1000", "5", "45"))));
    assert_eq!(values(&text, "tvd"), ["\"301.752 m\""]);
    assert_eq!(values(&text, "east"), ["\"-6.096 m\""]);
    let untied = trajectory(&(station("500", "0", "0") + &station("1000", "5", "45")));
    assert!(text_of(&untied).contains("the first station, at 500 m, has no tvd"));
}

/// Positions stated at stations are compared with those of the path, each column on its own, and
/// turns that no pipe endures are reported with the station's line.
#[test]
fn stations_are_checked_against_their_own_positions_and_by_what_pipe_endures() {
    let stated = |md: &str, inclination: &str, more: &str| {
        station(md, inclination, "0").replace("<incl", &format!("{more}<incl"))
    };
    let deep = stated("1000", "0", "<tvd uom='m'>900</tvd>");
    let text = text_of(&trajectory(
        &(station("0", "0", "0") + &stated("500", "0", "<tvd uom='m'>500</tvd>") + &deep),
    ));
    let warning = "true vertical depth of the file is 100.00 m less than computed from its angles \
         by minimum curvature, at 1000 m";
    assert!(text.contains(warning), "{text}");
    // A quarter of a circle of 1200/π m ends as far north as it ends below its beginning.
    let north = |north: &str| {
        let end = format!("<tvd uom='m'>381.97</tvd><dispNs uom='m'>{north}</dispNs>");
        let begin = "<tvd uom='m'>0</tvd><dispNs uom='m'>0</dispNs>";
        text_of(&trajectory(&(stated("0", "0", begin) + &stated("600", "90", &end))))
    };
    let agreeing = north("381.97");
    assert!(agreeing.contains("agree with those of the file within rounding"), "{agreeing}");
    let text = north("400");
    assert!(text.contains("north of the file is 18.03 m more than computed"), "{text}");
    let slip = station("0", "0", "0") + &station("1000", "40", "0") + &station("1030", "4", "0");
    let text =
        text_of(&trajectory(&(slip + &station("1060", "41", "0") + &station("2000", "41", "0"))));
    assert!(text.contains("deg/30 m") || text.contains("deg/30m"), "{text}");
    assert!(text.contains("is 4 a typing error for 4"), "{text}");
}
