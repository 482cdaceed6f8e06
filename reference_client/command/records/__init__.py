"""The commands on signed records: export, verify, upload, video."""
