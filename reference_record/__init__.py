"""Records: the signed, re-executable bundle of a run (spec/profiles/record.md).

Reads, writes, signs and verifies. It knows neither HTTP nor SQL nor simulators.
"""
