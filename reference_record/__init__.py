"""Records: the signed, re-executable bundle of a finished run (spec/record.md).

Reads, writes, signs and verifies. It knows neither HTTP nor SQL nor simulators.
"""
