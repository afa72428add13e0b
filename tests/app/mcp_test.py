#!/usr/bin/env python3
"""kempe mcp from outside: a client of the Model Context Protocol by its public messages, and hostile ones.

usage: mcp_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import json
import os
import pathlib
import random
import re
import select
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import EXAMPLES, KEMPE, SOURCE, kempe

TEN = {"copy": {"scale": 1.4, "rotation_deg": 90}, "region": {"rectangle_mm": {"at": [60, -5], "size": [10, 10]}},
       "links": {"width_mm": 6, "pin_diameter_mm": 3}}
GIVEN = dict(TEN, mechanism={"vertex": "tracer", "VA_mm": 57, "VB_mm": 26})
NEWEST = "2025-11-25"
PATIENCE = 120  # s, for an answer


class Client:
    """A server and what is said to it; every line that it prints must be a message."""

    def __init__(self, folder, *options):
        self.server = subprocess.Popen([KEMPE, "mcp", "--folder", folder, *map(str, options)], stdin=subprocess.PIPE,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.rest, self.last = b"", 0

    def write(self, data):
        self.server.stdin.write(data)
        self.server.stdin.flush()

    def tell(self, message):
        self.write(json.dumps(message).encode() + b"\n")

    def line(self):
        end = time.monotonic() + PATIENCE
        while b"\n" not in self.rest:
            ready, _, _ = select.select([self.server.stdout], [], [], max(0, end - time.monotonic()))
            piece = os.read(self.server.stdout.fileno(), 1 << 16) if ready else b""
            if not piece:
                raise AssertionError("no answer")
            self.rest += piece
        line, self.rest = self.rest.split(b"\n", 1)
        return line

    def hear(self):
        message = json.loads(self.line())
        for one in message if isinstance(message, list) else [message]:
            assert one["jsonrpc"] == "2.0" and ("result" in one) != ("error" in one), one
        return message

    def ask(self, method, params=None):
        self.last += 1
        self.tell({"jsonrpc": "2.0", "id": self.last, "method": method} | ({} if params is None else {"params": params}))
        answer = self.hear()
        assert answer["id"] == self.last, answer
        return answer

    def begin(self, version=NEWEST):
        answer = self.ask("initialize", {"protocolVersion": version, "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}})
        self.tell({"jsonrpc": "2.0", "method": "notifications/initialized"})
        return answer["result"]

    def call(self, tool, **arguments):
        return self.ask("tools/call", {"name": tool, "arguments": arguments})["result"]

    def end(self):
        """What it says and how it ends once nothing more comes."""
        self.server.stdin.close()
        rest = self.rest + self.server.stdout.read()
        code = self.server.wait(PATIENCE)
        return [json.loads(line) for line in rest.splitlines()], code


class Case(program.Case):
    OPTIONS = ("-j", 1)

    def setUp(self):
        super().setUp()
        self.served = self.scratch / "served"
        self.served.mkdir()
        self.client = self.open(*self.OPTIONS)

    def open(self, *options, begin=True):
        client = Client(self.served, *options)

        def close():
            client.server.kill()
            client.server.wait()
            for stream in (client.server.stdin, client.server.stdout, client.server.stderr):
                try:
                    stream.close()
                except OSError:
                    pass  # what was still to be written
        self.addCleanup(close)
        if begin:
            client.begin()
        return client

    def assertCode(self, answer, code, id_is="same"):
        self.assertEqual(answer["error"]["code"], code, answer)
        if id_is != "same":
            self.assertEqual(answer["id"], id_is)

    def refused(self, result):
        """The keys of the faults of a call, each with what was found and what is allowed."""
        self.assertIs(result["isError"], True)
        faults = result["structuredContent"]["error"]["faults"]
        for fault in faults:
            self.assertTrue(fault["found"] and fault["allowed"], fault)
            self.assertIn(fault["found"], result["content"][0]["text"])
            self.assertIn(fault["allowed"], result["content"][0]["text"])
        return [fault["key"] for fault in faults]


class Protocol(Case):
    def test_versions_are_agreed(self):
        for wish, agreed in [(v, v) for v in ("2024-11-05", "2025-03-26", "2025-06-18", NEWEST)] + [("1999-01-01", NEWEST), ("", NEWEST)]:
            said = self.open(begin=False).begin(wish)
            self.assertEqual(said["protocolVersion"], agreed)
            self.assertIn("tools", said["capabilities"])
            self.assertEqual(said["serverInfo"]["name"], "kempe")
        client = self.open(begin=False)
        self.assertEqual(client.ask("ping")["result"], {})
        self.assertCode(client.ask("tools/list"), -32600)
        self.assertCode(client.ask("tools/call", {"name": "verify"}), -32600)
        for params in (None, {}, {"protocolVersion": 1}, {"protocolVersion": None}):
            self.assertCode(client.ask("initialize", params), -32602)
        client.begin()
        self.assertCode(client.ask("initialize", {"protocolVersion": NEWEST}), -32600)

    def test_it_waits_with_one_thread(self):
        """No BLAS behind it keeps threads of its own busy."""
        status = pathlib.Path(f"/proc/{self.client.server.pid}/status").read_text()
        self.assertIn("Threads:\t1\n", status)

    def test_every_tool_has_a_schema_made_of_the_keys(self):
        answer = self.client.ask("tools/list")
        tools = {tool["name"]: tool for tool in answer["result"]["tools"]}
        self.assertEqual(list(tools), ["design", "map", "explain", "verify", "trace", "calibrate"])
        self.assertLess(len(json.dumps(answer)), 50_000)  # a model reads all of it
        for tool in tools.values():
            schema = tool["inputSchema"]
            self.assertEqual((schema["type"], schema["additionalProperties"]), ("object", False))
            self.assertFalse({"anyOf", "oneOf", "allOf"} & set(schema))  # many clients take none at the top
            self.assertLessEqual(set(schema["required"]), set(schema["properties"]))
            for name, value in schema["properties"].items():
                self.assertRegex(name, r"^\w{1,64}$")
                self.assertTrue(value["description"] and not value["description"].startswith(";"), name)
        spec = json.loads((SOURCE / "docs/spec.schema.json").read_text())
        self.assertEqual(tools["design"]["inputSchema"]["properties"]["spec"]["properties"], spec["properties"])
        for name in ("map", "explain"):
            given = tools[name]["inputSchema"]["properties"]["spec"]["properties"]
            self.assertEqual(set(given), set(spec["properties"]))
            self.assertEqual(given["mechanism"], spec["properties"]["mechanism"])
        self.assertCode(self.client.ask("tools/list", {"cursor": "x"}), -32602)

    def test_ids_of_every_kind(self):
        for good in (0, -5, 2**62, 2**63, "", "x", "ünïcode \u0000 雕", "x" * 1000):
            self.client.tell({"jsonrpc": "2.0", "id": good, "method": "ping"})
            self.assertEqual(self.client.hear(), {"jsonrpc": "2.0", "id": good, "result": {}})
        for bad in (None, True, 1.5, 10**30, [], [1], {}, {"a": 1}):
            self.client.tell({"jsonrpc": "2.0", "id": bad, "method": "ping"})
            self.assertCode(self.client.hear(), -32600, None)

    def test_bad_messages_have_their_codes(self):
        request = {"jsonrpc": "2.0", "id": 7, "method": "ping"}
        for change, code, id_is in (({"jsonrpc": "1.0"}, -32600, 7), ({"jsonrpc": 2.0}, -32600, 7), ({"method": 3}, -32600, 7),
                                    ({"method": "tools/frobnicate"}, -32601, 7), ({"method": "resources/list"}, -32601, 7),
                                    ({"method": "x" * 5000}, -32601, 7), ({"params": [1]}, -32602, 7), ({"params": None}, -32602, 7),
                                    ({"method": "tools/call"}, -32602, 7), ({"method": "tools/call", "params": {"name": 1}}, -32602, 7),
                                    ({"method": "tools/call", "params": {"name": "frobnicate"}}, -32602, 7),
                                    ({"method": "tools/call", "params": {"name": "verify", "arguments": []}}, -32602, 7)):
            self.client.tell({**request, **change})
            self.assertCode(self.client.hear(), code, id_is)
        for lone in ({"jsonrpc": "2.0", "id": 7}, {"id": 7, "method": "ping"}):
            self.client.tell(lone)
            self.assertCode(self.client.hear(), -32600, 7)
        for value in (1, "ping", None, True):
            self.client.tell(value)
            self.assertCode(self.client.hear(), -32600, None)
        # Nobody answers notifications and answers.
        for silent in ({"jsonrpc": "2.0", "method": "notifications/frobnicate"}, {"jsonrpc": "2.0", "method": "tools/call"},
                       {"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 99}},
                       {"jsonrpc": "2.0", "method": "notifications/cancelled", "params": []},
                       {"jsonrpc": "2.0", "id": 1, "result": {}}, {"jsonrpc": "2.0", "id": 1, "error": {"code": 1, "message": ""}}):
            self.client.tell(silent)
        self.assertEqual(self.client.ask("ping")["result"], {})

    def test_lists_of_messages_where_the_version_has_them(self):
        client = self.open(begin=False)
        client.begin("2025-03-26")
        ping = {"jsonrpc": "2.0", "id": "a", "method": "ping"}
        client.tell([ping, {"jsonrpc": "2.0", "method": "x"}, 5, {**ping, "id": "b"}])
        self.assertEqual([one.get("id") for one in client.hear()], ["a", None, "b"])
        client.tell([])
        self.assertCode(client.hear(), -32600, None)
        client.tell([{"jsonrpc": "2.0", "method": "x"}])
        self.assertEqual(client.ask("ping")["result"], {})
        self.client.tell([ping])
        self.assertCode(self.client.hear(), -32600, None)

    def test_the_end(self):
        self.client.tell({"jsonrpc": "2.0", "id": "x", "method": "tools/call",
                          "params": {"name": "design", "arguments": {"spec": TEN, "folder": "a"}}})
        self.client.write(b'{"jsonrpc": "2.0", "id": "y", "method": "ping"}')  # no line's end
        said, code = self.client.end()
        self.assertEqual(code, 0)
        self.assertEqual({one["id"] for one in said}, {"x", "y"})
        self.assertTrue((self.served / "a" / "design.json").exists())
        self.assertEqual(self.client.server.stderr.read(), b"")

    def test_a_closed_stdout(self):
        self.client.server.stdout.close()
        with self.assertRaises(OSError):
            for _ in range(1000):
                self.client.tell({"jsonrpc": "2.0", "id": 1, "method": "ping"})
                time.sleep(0.01)
        self.assertEqual(self.client.server.wait(PATIENCE), 5)

    def test_what_the_command_line_refuses(self):
        for arguments in ((), ("--folder", self.scratch / "absent"), ("--folder", self.served, "--time-limit", "0"),
                          ("--folder", self.served, "--time-limit", "nan"), ("--folder", self.served, "-j", "0")):
            run = kempe("mcp", *arguments, stdin=subprocess.DEVNULL)
            self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
            self.assertIn("--folder" if "--folder" not in map(str, arguments) else str(arguments[-1])[:4], run.stderr)


class Tools(Case):
    def test_a_design_is_that_of_the_command(self):
        shutil.copy(EXAMPLES / "plagiograph.toml", self.served)
        result = self.client.call("design", spec_file="plagiograph.toml", folder="jobs/one", seed=3)
        run = kempe("synthesize", EXAMPLES / "plagiograph.toml", "-o", self.scratch / "out", "--seed", 3)
        self.assertEqual((run.returncode, result["isError"]), (0, False))
        for name in ("design.json", "drawing.dxf", "report.html", "certificate.jsonl"):
            self.assertEqual((self.served / "jobs/one" / name).read_bytes(), (self.scratch / "out" / name).read_bytes(), name)
        self.assertEqual(result["content"][0]["text"], run.stdout.replace(str(self.scratch / "out"), "jobs/one").rstrip("\n"))
        answer = result["structuredContent"]
        self.assertEqual((answer["exit_code"], answer["folder"]), (0, "jobs/one"))
        self.assertEqual(answer["quality"], json.loads((self.scratch / "out/design.json").read_text())["quality"])
        self.assertLess(len(json.dumps(result)), 8000)

    def test_tables_in_the_message_are_as_good_as_a_file(self):
        self.assertIs(self.client.call("design", spec=TEN, folder="a")["isError"], False)
        spec = self.served / "ten.toml"
        spec.write_text(program.TEN_LINES)
        self.client.call("design", spec_file="ten.toml", folder="b")
        self.assertEqual((self.served / "a/design.json").read_bytes(), (self.served / "b/design.json").read_bytes())

    def test_without_a_design_the_least_changes_are_told(self):
        narrow = dict(TEN, links=dict(TEN["links"], longest_mm=20))
        result = self.client.call("design", spec=narrow, folder="a")
        answer = result["structuredContent"]
        self.assertEqual((result["isError"], answer["exit_code"], answer["proven"]), (False, 3, True))
        least = answer["relaxations"][0]
        self.assertEqual((least["key"], least["least"]), ("links.longest_mm", True))
        self.assertIn(least["sentence"], result["content"][0]["text"])
        enough = float(re.search(r"([\d.]+) would do", least["sentence"])[1])
        wider = dict(TEN, links=dict(TEN["links"], longest_mm=enough))
        self.assertEqual(self.client.call("design", spec=wider, folder="a")["structuredContent"]["exit_code"], 0)

    def test_faults_of_a_spec_are_all_told_as_the_command_tells_them(self):
        bad = {"copy": {"scale": 0}, "links": {"widht_mm": 6, "pin_diameter_mm": 3}, "objectve": {}, "region": {"rectangle_mm": {"at": [0, 0]}}}
        keys = self.refused(self.client.call("design", spec=bad, folder="a"))
        file = self.scratch / "bad.toml"
        file.write_text('[copy]\nscale = 0\n[links]\nwidht_mm = 6\npin_diameter_mm = 3\n[objectve]\n[region]\nrectangle_mm = {at = [0, 0]}\n')
        run = kempe("synthesize", file, "-o", self.scratch / "out", "--json")
        faults = json.loads(run.stdout)["error"]["faults"]
        self.assertEqual(keys, [fault["key"] for fault in faults])
        self.assertGreater(len(keys), 2)
        (self.served / "bad.toml").write_text(file.read_text())
        told = self.client.call("map", spec_file="bad.toml", folder="a")
        self.refused(told)
        self.assertEqual([(one["file"], one["line"]) for one in told["structuredContent"]["error"]["faults"]][:2], [("bad.toml", 2), ("bad.toml", 4)])
        self.assertEqual(list(self.served.iterdir()), [self.served / "bad.toml"])  # and nothing is written
        for spec in ({"copy": None}, {"copy": {"scale": None}}, {}, {"copy": []}):
            self.assertTrue(self.refused(self.client.call("design", spec=spec, folder="a")) is not None)

    def test_arguments_of_wrong_kinds(self):
        for tool, arguments, keys in (
                ("design", {}, ["spec", "folder"]), ("design", {"spec": TEN, "spec_file": "x", "folder": "a"}, ["spec"]),
                ("design", {"spec": "copy", "folder": 5, "seed": 1.5}, ["spec", "folder", "seed"]),
                ("design", {"spec": TEN, "folder": "a", "time_limit_s": -1}, ["time_limit_s"]),
                ("design", {"spec": TEN, "folder": "a", "time_limit_s": "1"}, ["time_limit_s"]),
                ("verify", {"design": "x"}, ["design", "design_file"]), ("verify", {"design_file": ["x"]}, ["design_file"]),
                ("explain", {"spec": GIVEN, "at": [1]}, ["at"]), ("explain", {"spec": GIVEN, "at": [1, "2"]}, ["at"]),
                ("calibrate", {"measurements_file": "x", "ratios": ["1:2,1:3"], "plan": 1}, ["ratios", "plan"])):
            self.assertEqual(self.refused(self.client.call(tool, **arguments)), keys, (tool, arguments))
        self.assertIn("design_file (the nearest known argument)", self.client.call("verify", desing_file="x")["content"][0]["text"])
        # Ranges are those of the command's options.
        for tool, arguments, key, allowed in (
                ("explain", {"spec": GIVEN, "at": [0, 1e300]}, "at", "a number from -1e+07 to 1e+07"),
                ("design", {"spec": TEN, "folder": "a", "map_tolerance": 7}, "map_tolerance", "a number from 1e-05 to 0.5"),
                ("design", {"spec": TEN, "folder": "a", "seed": -1}, "seed", "a whole number from 0"),
                ("calibrate", {"measurements_file": "x", "plan_readings": 101}, "plan_readings", "100"),
                ("trace", {"design_file": "x", "drawing_file": "x", "copy_file": "x.svg", "fit": True, "scale": 2}, "trace", "--help")):
            result = self.client.call(tool, **arguments)
            self.assertEqual(self.refused(result), [key])
            self.assertIn(allowed, result["content"][0]["text"])
        # What looks like an option is a path.
        self.assertEqual(self.refused(self.client.call("verify", design_file="--help")), [None])
        self.assertIs(self.client.call("design", spec=TEN, folder="--help")["isError"], False)

    def test_map_explain_verify(self):
        result = self.client.call("map", spec=GIVEN, folder="m")
        self.assertIs(result["isError"], False, result)
        self.assertIn("workspace", result["structuredContent"])
        for place in ([65, 0], [300, 0], [60, -5.5]):
            by_spec = self.client.call("explain", spec=GIVEN, at=place)
            by_file = self.client.call("explain", design_file="m/design.json", at=place)
            for result in (by_spec, by_file):
                self.assertIs(result["isError"], False)
                self.assertIn(result["structuredContent"]["sentence"], result["content"][0]["text"])
            self.assertEqual(by_spec["structuredContent"], by_file["structuredContent"])
            self.assertEqual(by_spec["structuredContent"]["free"], place != [300, 0])
        self.assertEqual(self.refused(self.client.call("explain", spec=TEN, at=[65, 0])), ["mechanism"])
        self.assertEqual(self.client.call("verify", design_file="m/design.json")["structuredContent"]["exit_code"], 0)
        text = (self.served / "m/design.json").read_text()
        (self.served / "lie.json").write_text(re.sub(r'("size_mm": )\d+', r"\g<1>9", text))
        result = self.client.call("verify", design_file="lie.json")
        self.assertEqual((result["isError"], result["structuredContent"]["exit_code"]), (False, 4))
        self.assertIn("quality.size_mm", result["content"][0]["text"])
        self.assertEqual(self.refused(self.client.call("verify", design_file="absent.json")), [None])

    def test_trace_and_calibrate(self):
        self.client.call("design", spec=TEN, folder="a")
        (self.served / "line.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="8mm" height="8mm" viewBox="0 0 8 8">'
                                              '<path d="M1 1H7V7"/></svg>')
        drawn = self.client.call("trace", design_file="a/design.json", drawing_file="line.svg", copy_file="copy.svg", fit=True)
        self.assertEqual((drawn["isError"], drawn["structuredContent"]["left_out"]), (False, 0))
        self.assertIn('id="copy"', (self.served / "copy.svg").read_text())
        lost = self.client.call("trace", design_file="a/design.json", drawing_file="line.svg", copy_file="copy.svg", at=[-60.5, 3])
        self.assertEqual((lost["isError"], lost["structuredContent"]["exit_code"]), (False, 4))
        self.assertIn("left out", lost["content"][0]["text"])
        for name in ("knight.toml", "plotter.toml", "drawing-pantograph.json"):
            shutil.copy(EXAMPLES / "calibration" / name, self.served)
        for name in ("knight.toml", "plotter.toml"):
            found = self.client.call("calibrate", measurements_file=name)
            run = kempe("calibrate", name, cwd=self.served)
            self.assertEqual(found["content"][0]["text"], run.stdout.rstrip("\n"))
            self.assertNotIn("error", found["structuredContent"])
        self.refused(self.client.call("calibrate", measurements={"instrument": {"arm_mm": 1}}))


class Paths(Case):
    def setUp(self):
        super().setUp()
        self.outside = self.scratch / "outside"
        self.outside.mkdir()
        (self.outside / "ten.toml").write_text(program.TEN_LINES)
        shutil.copy(EXAMPLES / "calibration/drawing-pantograph.json", self.outside / "design.json")
        (self.outside / "square.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="8mm" height="8mm" viewBox="0 0 8 8">'
                                                 '<path d="M1 1H7V7H1Z"/></svg>')
        (self.served / "in").mkdir()
        (self.served / "way").symlink_to(self.outside)
        (self.served / "in/way").symlink_to("..")
        (self.served / "ten.toml").symlink_to(self.outside / "ten.toml")
        (self.served / "new").symlink_to(self.outside / "new")
        self.before = self.listing()

    def listing(self):
        return sorted((str(path), path.stat().st_mtime_ns) for path in self.outside.rglob("*"))

    def test_nothing_leads_out(self):
        outside = str(self.outside)
        for path in ("../outside", outside, "in/../../outside", "way", "in/way/way", "./../outside", "new", "in/way/../../outside", "~/../..", "//etc"):
            keys = self.refused(self.client.call("verify", design_file=path + "/design.json"))
            if not path.startswith("~"):
                self.assertEqual(keys, ["design_file"], path)
                self.assertEqual(self.refused(self.client.call("design", spec=TEN, folder=path + "/a")), ["folder"], path)
            self.refused(self.client.call("design", spec_file=path + "/ten.toml", folder="a"))
        for name in ("", ".", "in/..", "a\0b", "x" * 2000, "way", "new", "ten.toml", "/dev/stdin", "/proc/self/environ"):
            self.assertEqual(self.refused(self.client.call("design", spec=TEN, folder=name)), ["folder"], name)
        for name in ("ten.toml", "way/ten.toml", "in", "/dev/zero"):
            self.assertEqual(self.refused(self.client.call("design", spec_file=name, folder="a")), ["spec_file"], name)
        os.mkfifo(self.served / "pipe")
        self.assertEqual(self.refused(self.client.call("verify", design_file="pipe")), ["design_file"])
        self.assertFalse((self.served / "a").exists())
        self.assertEqual(self.listing(), self.before)

    def test_files_that_files_name(self):
        for named in ("../outside/square.svg", str(self.outside / "square.svg"), "way/square.svg", "in/../../outside/square.svg"):
            spec = dict(TEN, region={"file": named})
            self.assertEqual(self.refused(self.client.call("design", spec=spec, folder="a")), ["region.file"], named)
            (self.served / "spec.toml").write_text(f'[copy]\nscale = 2\n[region]\nfile = "{named}"\n[links]\nwidth_mm = 6\npin_diameter_mm = 3\n')
            self.assertEqual(self.refused(self.client.call("map", spec_file="spec.toml", folder="a")), ["region.file"], named)
            for key in ("spec_file", "design_file"):
                self.assertEqual(self.refused(self.client.call("explain", at=[1, 1], **{key: "spec.toml"})), ["region.file"], named)
            text = (EXAMPLES / "calibration/plotter.toml").read_text()
            (self.served / "m.toml").write_text(text.replace("drawing-pantograph.json", named.replace("square.svg", "design.json")))
            self.assertEqual(self.refused(self.client.call("calibrate", measurements_file="m.toml")), ["design"], named)
        shutil.copy(self.outside / "square.svg", self.served / "square.svg")
        shutil.copy(self.outside / "ten.toml", self.served / "in/spec.toml")
        (self.served / "in/spec.toml").write_text('[copy]\nscale = 2\n[region]\nfile = "../square.svg"\n[links]\nwidth_mm = 6\npin_diameter_mm = 3\n')
        self.assertIs(self.client.call("design", spec_file="in/spec.toml", folder="a")["isError"], False)
        self.assertEqual(self.listing(), self.before)

    def test_links_where_files_are_written(self):
        (self.served / "a/parts").mkdir(parents=True)
        for link in ("a/design.json", "a/parts/link_VA.dxf"):
            (self.served / link).symlink_to(self.outside / "ten.toml")
            self.assertEqual(self.refused(self.client.call("design", spec=TEN, folder="a")), ["folder"])
            (self.served / link).unlink()
        self.client.call("design", spec=TEN, folder="a")
        (self.served / "line.svg").write_text((self.outside / "square.svg").read_text())
        (self.served / "copy.svg").symlink_to(self.outside / "square.svg")
        for copy in ("copy.svg", "a/design.json", "copy", "../copy.svg"):
            keys = self.refused(self.client.call("trace", design_file="a/design.json", drawing_file="line.svg", copy_file=copy, fit=True))
            self.assertEqual(keys, ["copy_file"], copy)
        self.refused(self.client.call("trace", design_file="a/design.json", drawing_file="line.svg", copy_file="line.svg", fit=True))
        self.assertEqual(self.listing(), self.before)


class Limits(Case):
    def slow(self):
        """A call that would last many seconds: a copy of a long line in four million poses."""
        self.client.call("design", spec=TEN, folder="a")
        lines = "".join(f"M0 {y / 100}H8" for y in range(800))
        (self.served / "long.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="8mm" height="8mm" viewBox="0 0 8 8"><path d="{lines}"/></svg>')
        return {"jsonrpc": "2.0", "id": "slow", "method": "tools/call", "params": {"name": "trace", "arguments": {
            "design_file": "a/design.json", "drawing_file": "long.svg", "copy_file": "copy.svg", "fit": True, "step_mm": 2e-3}}}

    def test_a_call_ends_at_its_time(self):
        client = self.open("--time-limit", 0.3, *self.OPTIONS)
        client.tell(self.slow())
        result = client.hear()["result"]
        self.assertIs(result["isError"], True)
        self.assertEqual(result["content"][0]["text"], "stopped (time limit of 0.3 s) before an answer")
        self.assertFalse((self.served / "copy.svg").exists())
        result = client.call("design", spec=dict(TEN, objective={"minimize": "footprint"}), folder="b", time_limit_s=1e-6)
        self.assertIn(result["structuredContent"]["exit_code"], (0, 6))
        self.assertIn("STOPPED" if result["structuredContent"]["exit_code"] == 0 else "stopped", result["content"][0]["text"])

    def test_pings_and_cancelling_while_a_call_runs(self):
        ping = {"jsonrpc": "2.0", "id": "p", "method": "ping"}
        slow = self.slow()
        self.client.tell(slow)
        self.client.tell(ping)
        first = self.client.hear()
        self.assertEqual(first["id"], "p", first)  # before the call
        self.client.tell({**slow, "id": "waits"})
        for which in ("other", "waits", "slow"):
            self.client.tell({"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": which}})
        self.assertEqual(self.client.ask("ping")["result"], {})
        # All at once, as one piece.
        self.client.write(b"".join(json.dumps(one).encode() + b"\n" for one in (
            slow, ping, {"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": "slow"}}, {**ping, "id": "q"})))
        self.assertEqual({self.client.hear()["id"], self.client.hear()["id"]}, {"p", "q"})
        said, code = self.client.end()
        self.assertEqual((said, code), ([], 0))

    def test_a_call_does_not_outlive_the_server(self):
        self.client.tell(self.slow())
        self.client.tell({"jsonrpc": "2.0", "id": "p", "method": "ping"})
        self.client.hear()
        listed = pathlib.Path(f"/proc/{self.client.server.pid}/task/{self.client.server.pid}/children")
        if not listed.exists():
            self.skipTest("the system lists no children")
        children = listed.read_text().split()
        self.assertEqual(len(children), 1)
        self.client.server.send_signal(signal.SIGTERM)
        self.client.server.wait(PATIENCE)
        end = time.monotonic() + PATIENCE

        def lives(child):
            try:
                return " Z " not in pathlib.Path(f"/proc/{child}/stat").read_text()
            except OSError:
                return False
        while lives(children[0]):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def test_texts_that_are_no_messages(self):
        deep = 100_000
        for line in (b"{", b"frobnicate", b'"', b"\xff\xfe{}", b'{"a": "\xff"}', b"[" * deep, b'{"a":' * deep, b"[" * 100 + b"]" * 100,
                     b'{"jsonrpc": "2.0", "jsonrpc": "2.0", "id": 1, "method": "ping"}', b"{}{}", b"\x00", b"nan", b'{"a": 1e999}',
                     b'{"a": "\\ud800"}', b"{'a': 1}", b"// x"):
            self.client.write(line + b"\n")
            self.assertCode(self.client.hear(), -32700, None)
        self.client.write(b"\n \r\n\t\n")  # nothing is said, nothing is answered
        for size in (1 << 20, 3 << 20):
            self.client.write(b'{"jsonrpc": "2.0", "id": 1, "method": "' + b"x" * size + b'"}\n')
            self.assertCode(self.client.hear(), -32600, None)
        self.client.write(b'{"jsonrpc": "2.0", "id": 5, "method": "ping"}\r\n')
        self.assertEqual(self.client.hear()["id"], 5)

    def test_messages_with_wrong_bytes_have_one_answer_at_most(self):
        lot = random.Random(24)
        messages = [json.dumps({"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": {"name": "verify", "arguments": {"design_file": "x"}}}),
                    json.dumps({"jsonrpc": "2.0", "id": "a", "method": "initialize", "params": {"protocolVersion": NEWEST, "capabilities": {}}}),
                    json.dumps({"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 1}})]
        answered = 0

        def hear_until(mark):
            nonlocal answered
            while self.client.hear().get("id") != mark:
                answered += 1

        for sent in range(1, 301):
            line = bytearray(lot.choice(messages).encode())
            for _ in range(lot.randint(1, 4)):
                at = lot.randrange(len(line))
                line[at:at + lot.randint(0, 3)] = bytes(lot.choice(b'{}[]",:0e\\ \xff\x00') for _ in range(lot.randint(0, 3)))
            self.client.write(bytes(line).replace(b"\n", b" ") + b"\n")
            self.client.tell({"jsonrpc": "2.0", "id": "end", "method": "ping"})
            hear_until("end")  # a ping may overtake a call, whose answer then comes later
            self.assertLessEqual(answered, sent)
        self.client.tell({"jsonrpc": "2.0", "id": "last", "method": "ping"})
        hear_until("last")
        self.assertLessEqual(answered, 300)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
