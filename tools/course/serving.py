"""Serves a folder to the browser of this computer."""
import functools
import http.server
import webbrowser

from base.talk import faint

FIRST = 8808  # of the ports that are tried


class Handler(http.server.SimpleHTTPRequestHandler):
    """Without a line for every file, and never from a cache: a new version is seen at once."""
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map,
                      ".js": "text/javascript", ".json": "application/json",
                      ".xz": "application/octet-stream"}

    def log_message(self, *_):
        pass

    def end_headers(self):
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()


class Server(http.server.ThreadingHTTPServer):
    """For a page that asks for twenty files at once."""
    request_queue_size = 64


def server_of(folder, first=FIRST):
    """A server at the first free port."""
    handler = functools.partial(Handler, directory=str(folder))
    for port in range(first, first + 100):
        try:
            return Server(("127.0.0.1", port), handler)
        except OSError:
            continue
    raise OSError("no free port")


def serve(folder, page="chapters_01_distance_README.html"):
    """Until it is interrupted."""
    with server_of(folder) as server:
        address = f"http://127.0.0.1:{server.server_port}/{page}"
        print(f"open {address}", flush=True)
        print(faint("serving it; Ctrl-C ends"), flush=True)
        webbrowser.open(address)
        server.serve_forever()
    return 0
