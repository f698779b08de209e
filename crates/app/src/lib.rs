//! The local web app: a server on the loopback address, and the page that it serves.
