"""Clients of policy servers: WebSocket, HTTP, ZeroMQ, and policy.yaml.

A client has `infer(request)`, `begin_episode(message)` and `close()`. Every wait has a
limit, and every failure is a ProctorError that repeats the server's own error text.
"""
