"""The history of a service: each exchange is compared with all that were seen before.

A request has its effect at some moment between being sent and being answered. So one
exchange is *surely before* another when its answer came before the other was sent; in
any other case the order is unknown, and both orders are allowed. Pure: the times are
those of the client.
"""
