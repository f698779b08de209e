//! Carries out what fronts ask for: runs, sweeps, studies and bit tests, and their pages.
