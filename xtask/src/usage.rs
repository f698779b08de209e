//! Usage of the chores.

pub(crate) const USAGE: &str = "\
usage: cargo xtask test [--keep-going] [STEP...]
                             run everything that CI runs, or the steps with these titles; with
                             --keep-going continue after steps that fail
       cargo xtask cycles    list the circles between files
       cargo xtask changes [--only NAME] [--tests] [--record NAME]
                             apply the examples of changes in docs/changes to a copy and compile
                             it, with --tests run their tests; or record the working tree's
                             changes as the one of a name
       cargo xtask verify    run all tests, including those that take minutes, and write the
                             book's table of them
       cargo xtask fuzz [SECONDS | --inputs N] [--seed S] [READER...]
                             read damaged inputs with every reader [default: for an hour]
       cargo xtask peers [--write]
                             measure other programs and this one; write the tables into the book
       cargo xtask accuracy [--write | WORD...]
                             measure the errors of each accuracy of the mesh, for all cases or
                             those whose titles contain a word; write the table into the book
       cargo xtask dependencies --write
                             write the dependencies of crates and pages into the book
       cargo xtask architecture
                             draw the crates and their dependencies for ARCHITECTURE.md
       cargo xtask book      build the book into target/book, with the app of target/playground
                             if it exists
       cargo xtask site      build that app, and the book with it
       cargo xtask equations --write
                             convert the book's equations for the documentation of the code
       cargo xtask bundles   check that the bundles of the pages match their sources
       cargo xtask playground
                             build the app that runs in a browser alone, in target/playground
       cargo xtask packages
                             pack the published crates and build each from its package
       cargo xtask paper     write the paper to target/paper/paper.pdf
       cargo xtask shown [--all]
                             run the commands in the README and the book's first pages, with
                             --all also those that take minutes
       cargo xtask clean-root [SUITE...]
                             run program and wheel in a minimal Debian root, by debootstrap
       cargo xtask winget SHA256
                             write the manifests for Windows' package manager, for the archive
                             with this checksum
       cargo xtask portability [windows | avx2 | baseline | aarch64]
                             run program and command-line tests as on other systems and
                             processors, and compare their numbers with those of this machine
       cargo xtask workflows check the workflows in .github";
