//! Text around the numbers and between them.

use insta::assert_snapshot;

use crate::{PLAIN, imported, notes, string};

#[test]
fn titles_footnotes_empty_rows_and_repeated_headings_are_passed_over() {
    let imported = imported(
        "Rig 7,,,,\nBHA no. 3,,,,\n,,,,\nItem,Component,OD,ID,Length\n,,[in],[in],[m]\n,,,,\n\
         1,Bit,8.5,2.25,0.3\nBottom-hole assembly,,,,\n2,DC,6.5,2.25,\"1,009.1\"\nItem,Component,OD,\
         ID,Length\n,,[in],[in],[m]\n3,DP,5,4.276,TO SURFACE\nSub-total,,,,1009.4\n,,,,\n* all from \
         the maker,,,,\n",
    );
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2.25 in"
    length = "0.3 m"

    [[string]]
    component = "DC"
    od = "6.5 in"
    id = "2.25 in"
    length = "1009.1 m"

    [[string]]
    component = "DP"
    od = "5 in"
    id = "4.276 in"
    length = "to surface"
    "#);
    assert_snapshot!(notes(&imported), @r"
    read: the tally is read as listed, from the bit up: the bit, 'Bit', is in line 7
    checked: the total agrees with the lengths below the topmost component: 1009.4 m (line 13, column 'Length')
    assumed: 'DP': no weight; computed from the diameters as steel, WITHOUT TOOL JOINTS, which make pipe a tenth heavier or more: give mass_per_length, or catalogue
    assumed: 'Bit', 'DC': no weight; computed from the diameters as steel
    read: header in line 4, columns separated by commas
    read: component from 'Component'
    read: outside diameter from 'OD' in in
    read: length from 'Length' in m
    read: inside diameter from 'ID' in in
    read: number from 'Item'
    left out: line 8: 'Bottom-hole assembly'
    left out: line 10: 'Item'
    left out: line 11: '[in]'
    left out: line 15: '* all from the maker'
    ");
}

#[test]
fn tabs_semicolons_and_columns_of_blanks_part_the_cells() {
    let tabs = imported(&PLAIN.replace(',', "\t"));
    let semicolons = imported(&PLAIN.replace(',', ";").replace('.', ","));
    let fixed = imported(
        "BHA 7                       page 1\n\n\
         Component     OD     ID      Length       Weight\n\
        \x20             in     in      ft           lb/ft\n\
         -----------------------------------------------\n\
         PDC bit       8.5    2.25    0.85\n\
         Collar        6.5    2.25    30           99.5\n\
         DP            5      4.276   TO SURFACE   21\n",
    );
    let plain = string(&imported(PLAIN));
    assert_eq!(string(&tabs), plain);
    assert_eq!(string(&semicolons), plain);
    assert_eq!(string(&fixed), plain);
}
