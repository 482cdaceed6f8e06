"""Every client against a server: proxy, scenarios and programs; see docs/interop.md."""
