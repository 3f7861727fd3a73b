# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests take from npm, or from npm's cache: nothing of it is shipped."""
import pathlib
import shutil
import subprocess


def node_modules(lock, into):
    """Installs what the package-lock.json in the folder `lock` names into the folder `into`, once. None: there is no
    npm, or it has not got them and cannot fetch them."""
    modules = pathlib.Path(into) / "node_modules"
    names = ("package.json", "package-lock.json")
    if modules.exists() and all((modules.parent / name).read_bytes() == (lock / name).read_bytes() for name in names):
        return modules
    if not shutil.which("npm"):
        return None
    modules.parent.mkdir(parents=True, exist_ok=True)
    for name in names:
        shutil.copy(lock / name, modules.parent / name)
    done = subprocess.run(
        ["npm", "ci", "--prefer-offline", "--ignore-scripts", "--no-audit", "--no-fund", "--fetch-retries=0"],
        cwd=modules.parent, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=240, check=False)
    if done.returncode == 0 and modules.exists():
        return modules
    shutil.rmtree(modules, ignore_errors=True)  # an incomplete installation is useless
    return None
