"""The process of the server: start and end, memory, limits, work of each hour."""
