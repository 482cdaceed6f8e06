"""A finished judgement as HTML, JSON, JUnit XML and a badge."""
