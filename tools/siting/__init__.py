"""The site: the documents with a search, the examples, the API reference and the playground, as static files.

    from siting import make_site
    folder = make_site()

`pages` puts together what Zensical reads, `reference` has doxygen write the API reference, `links` looks for links that
lead nowhere. `tools/site` is the command line of it.
"""

from .links import dead_links
from .site import SITE, NotMade, make_site

__all__ = ["SITE", "NotMade", "dead_links", "make_site"]
