//! The laws of the bit, each with its keys.

mod detournay_defourny;
mod law_keys;
mod rate;
mod regenerative;
mod rock;
mod table;

use wholestring_config::{
    rule::Choice,
    table::default,
    tagged::{Variant, tagged},
};

use self::{
    detournay_defourny::DetournayDefournyKeys, rate::RateKeys, regenerative::RegenerativeKeys,
    rock::RockKeys, table::TableKeys,
};
use super::kind::KindKeys;

pub(crate) use self::law_keys::LawKeys;

/// The law whose keys a bit test uses with any law.
pub(crate) const ROCK: &str = <RockKeys as Variant>::WORD;

tagged! {
    /// The law of the bit and the keys of all laws.
    Laws as dyn LawKeys {
        /// Only the dynamic model lets the bit move; the soft string uses the law's steady torque.
        law: Law = default(Choice { noun: "a bit law", words: Law::WORDS }, Law::Rate);
        ..kind: KindKeys;
        Rate => rate: RateKeys;
        Regenerative => regenerative: RegenerativeKeys;
        DetournayDefourny => detournay_defourny: DetournayDefournyKeys;
        Table => table: TableKeys;
        Rock => rock: RockKeys;
    }
}
