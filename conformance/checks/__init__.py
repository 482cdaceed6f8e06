"""One file per area, one check per rule: what is done, then "Expect ..."."""
