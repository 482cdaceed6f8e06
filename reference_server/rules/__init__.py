"""The rules, pure: no clock, no disk, no socket, no HTTP, no SQL."""
