"""Two runs beside each other: what their episodes show, and when that is enough."""
