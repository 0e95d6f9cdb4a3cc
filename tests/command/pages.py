# SPDX-License-Identifier: Apache-2.0
"""Pages of clouds of points, read back."""
import base64
import json
import struct

from command import CommandTest


class PageTest(CommandTest):
    def page(self, *words, stdin):
        """The header of a page, and a function that gives the numbers of an array in it."""
        done = self.run_quoin(*words, "-o", "p.html", stdin=stdin, code=None)
        if "was not built" in done.stderr:
            self.skipTest("without the view")
        self.assertEqual(done.returncode, 0, done.stderr)
        text = self.read("p.html").decode()
        header = json.loads(text.split('id="quoin-layers">')[1].split("</script>")[0])

        def array(told):
            data = text.split(f'id="quoin-block-{told["block"]}">')[1].split("</script>")[0]
            code = {"u8": "B", "u16": "H", "u32": "I", "f32": "f", "f64": "d"}[told["type"]]
            return struct.unpack(f"<{told['length']}{code}", base64.b64decode(data))
        return header, array
