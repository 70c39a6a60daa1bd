//! The tests of the library on whole designs, one file a subject. One program for all of them: each program takes as long to compile as most of them take to run.

mod allocation;
mod canonical;
mod export;
mod findings;
mod fingerprint;
mod finite;
mod fitted;
mod flood;
mod hostile;
mod interface;
mod links;
mod measure;
mod mesh;
mod mode;
mod one_body;
mod placement;
mod random_pots;
mod refusals;
mod single_precision;
mod sketch;
mod solid;
mod support;
mod surfaces;
mod tolerance;
mod watch;
