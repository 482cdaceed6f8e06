"""Several server processes over one database: membership, and requests passed on."""
