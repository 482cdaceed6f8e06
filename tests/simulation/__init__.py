"""The server's parts in a world of virtual time, faults and lost messages.

One seed makes one schedule: clients, a network that loses, repeats and reorders, a
database whose writes fail or are in doubt, simulators that break, and a server that is
killed and started again. What the clients were answered is compared with what the
simulators executed and what the database has.
"""
