"""The result of a kit run as HTML, JSON, JUnit XML and a badge."""
