"""The connection to a database, what may use it, and its transactions."""
