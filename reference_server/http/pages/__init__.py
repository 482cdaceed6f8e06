"""Pages for people: what the API answers to a reader's token, as HTML.

A page is made from answers of this server's own operations, which are called as any
client calls them; nothing here knows a run, a table of the database or a rule.
"""
