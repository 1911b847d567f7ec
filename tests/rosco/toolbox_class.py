# SPDX-License-Identifier: Apache-2.0
"""Runs a script that uses ROSCO's real ControllerInterface, from an unpacked wheel:

    toolbox_class.py FOLDER SCRIPT ARGUMENTS...

FOLDER holds rosco/ and numpy/. What the class imports without need for it here (messaging, YAML
files) is replaced by empty modules. Ends with 77 and the reason where it cannot run."""
import runpy
import sys
import types

folder, script = sys.argv[1:3]
sys.path.insert(0, folder)
for name, content in (("zmq", {}), ("rosco.toolbox.ofTools.util.FileTools", {"load_yaml": lambda file: {}})):
    sys.modules[name] = types.ModuleType(name)
    sys.modules[name].__dict__.update(content)
try:
    import rosco.toolbox.control_interface  # noqa: F401
except ImportError as reason:
    print(f"ROSCO's Python class cannot be imported from {folder}: {reason}")
    sys.exit(77)
sys.argv = sys.argv[2:]
runpy.run_path(script, run_name="__main__")
