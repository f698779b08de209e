"""The problems, made of the files of `verification/`."""
