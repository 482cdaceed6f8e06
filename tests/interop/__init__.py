"""Every client against a server: its proxy, scenarios and programs.

`make interop` plays them and writes build/interop.md.
"""
