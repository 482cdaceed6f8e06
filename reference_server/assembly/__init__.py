"""The parts of one server, each made from its settings and the parts below it."""
