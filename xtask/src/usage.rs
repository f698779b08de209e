//! How the chores are asked for.

pub(crate) const USAGE: &str = "\
usage: cargo xtask test [--keep-going] [STEP...]
                             run everything that CI runs, or the steps of those titles; with
                             --keep-going past steps that fail
       cargo xtask cycles    name the circles between files
       cargo xtask changes [--only NAME] [--tests] [--record NAME]
                             apply the examples of changes in docs/changes to a copy and compile \
       it; with their
                             tests; or write the working tree's changes as the one of a name
       cargo xtask verify    run all tests, those that take minutes too, and write the book's \
       table of them
       cargo xtask fuzz [SECONDS | --inputs N] [--seed S] [READER...]
                             read damaged inputs with every reader, for an hour where nothing is \
                             said
       cargo xtask peers [--write]
                             measure other programs beside this one; write the tables into the \
       book
       cargo xtask accuracy [--write | WORD...]
                             measure what each accuracy of the mesh errs by, of all cases or of \
       those whose
                             titles hold a word; write the table into the book
       cargo xtask dependencies --write
                             write what the crates and pages depend on into the book
       cargo xtask architecture
                             draw the crates and what they use for ARCHITECTURE.md
       cargo xtask book      build the book into target/book, with the app of target/playground \
       where it is
       cargo xtask site      make that app, and build the book with it
       cargo xtask equations --write
                             set the book's equations that the documentation of the code shows
       cargo xtask bundles   check that the bundles of the pages are what their sources make
       cargo xtask playground
                             make the app that runs in a browser alone, in target/playground
       cargo xtask packages
                             pack what is published and build each crate of its package
       cargo xtask paper     write the paper to target/paper/paper.pdf
       cargo xtask shown [--all]
                             run the commands that the README and the book's first pages show; \
       those that
                             take minutes, too
       cargo xtask clean-root [SUITE...]
                             run program and wheel in an empty root of Debian's packages, by \
       debootstrap
       cargo xtask winget SHA256
                             write the manifests for Windows' package manager, of the archive with \
                             that sum
       cargo xtask portability [windows | avx2 | baseline | aarch64]
                             run program and command-line tests as on other systems and \
       processors, and compare
                             their numbers with those of this machine
       cargo xtask workflows check the workflows in .github";
