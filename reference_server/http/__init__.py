"""The only place that knows HTTP: requests in, views and problems out."""
