//! A server over TCP, with the requests of browsers and of attackers.

mod answers;
mod arrange;
#[path = "../common/mod.rs"]
mod common;

mod assets;
mod cases;
mod check;
mod conformance;
mod document;
mod edit;
mod entrance;
mod folder;
mod guard;
mod import;
mod jobs;
mod leftovers;
mod live;
mod lookup;
mod results;
mod strain;
mod typescript;
