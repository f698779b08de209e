//! The program as a user meets it: what it prints, what it writes and how it ends.

mod bench;
mod bha;
mod bit_test;
mod catalogue;
mod check;
mod columns;
mod contract;
mod damage;
mod desk;
mod documentation;
mod endings;
mod findings;
mod folders;
mod frames;
mod modes;
mod new_case;
mod plot;
mod reach;
mod remarks;
mod report;
mod resume;
mod run;
mod shipped;
mod study;
mod survey;
mod sweep;
