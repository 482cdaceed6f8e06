"""The conformance kit: judges any Proctor server by its answers alone.

It imports nothing of the house and no generated client, because it must be able to
send what a client forbids. The rules stand in `spec/`; `ledger` reads them, `checks/`
judges them one by one, `story` gives the checks their verbs.
"""
