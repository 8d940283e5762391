//! The link: rows become packets, packets become bytes, and back.
