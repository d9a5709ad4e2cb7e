"""tools/refresh: what in the repository is generated, and is it up to date?"""
