"""Every client against a server: its proxy, scenarios and programs.

docs/implement/interop.md is what they wrote.
"""
