"""One file per area, one check per requirement; each tells a short story."""
