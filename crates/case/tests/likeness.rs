//! Texts that are intended as a case file.

use wholestring_case::is_case;

#[test]
fn cases_are_known_by_their_keys() {
    for text in [
        "[well]",
        "\u{feff}  [[string]] # from the bit up",
        "[well.tie_in]\n",
        "[ \"bad",
        "# only a name\nname = 'A'",
        "model = [\"soft\"",
        "\"units\" = \"si\"\r\n",
    ] {
        assert_eq!(is_case(text), !text.contains("bad"), "{text}");
    }
    for text in [
        "",
        "Well = S-1\nMD Inc Azi\n",
        "name = S-1\nMD,Inc,Azi\n",
        "~V\n VERS. 2.0 :\n",
        "<well>\n[well\n",
        "[[1,2],[3]]",
        "[pipes]\nname = \"5 in\"",
        "case = \"well.toml\"\n[[vary]]",
    ] {
        assert!(!is_case(text), "{text}");
    }
}
