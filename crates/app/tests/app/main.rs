//! A server over TCP, as a browser and as somebody who means no good meet it.

mod answers;
mod arrange;
#[path = "../common/mod.rs"]
mod common;

mod assets;
mod cases;
mod check;
mod document;
mod edit;
mod folder;
mod guard;
mod import;
mod jobs;
mod live;
mod lookup;
mod results;
mod strain;
