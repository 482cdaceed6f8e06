"""The clients of a check: requests, runs, workers, events. Every exchange is logged."""
