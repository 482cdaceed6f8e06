"""HTTP requests and responses as data: log entries, answers, curl scripts."""
