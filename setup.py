"""What pip asks setuptools for: CMake builds the module and the libraries it stands on, in DUMBBELL_BUILD or build/pip."""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
VERSION = re.search(r"^project\(dumbbell VERSION ([0-9.]+) ", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]


class BuildByCMake(build_ext):
    def build_extension(self, ext):
        folder = Path(os.environ.get("DUMBBELL_BUILD", ROOT / "build/pip")).resolve()
        options = ["-DDUMBBELL_PYTHON_MODULE=ON", f"-DPython_EXECUTABLE={Path(sys.executable).resolve()}"]
        if not (folder / "CMakeCache.txt").exists():
            options.append("-DBUILD_TESTING=OFF")
        subprocess.run(["cmake", "--preset", "release", "-B", folder, *options], cwd=ROOT, check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "dumbbell_python"], check=True)
        module = Path(self.get_ext_fullpath(ext.name))
        module.parent.mkdir(parents=True, exist_ok=True)
        built = folder / "src/wings/api"
        shutil.copy(built / module.name, module)
        for library in built.glob("libdumbbell-*.so.[0-9]*"):
            if re.fullmatch(r".*\.so\.\d+\.\d+", library.name):  # as the module asks for it
                shutil.copy(library, module.parent)


(ROOT / "build").mkdir(exist_ok=True)
setup(
    version=VERSION,
    packages=["dumbbell"],
    package_dir={"dumbbell": "src/wings/python"},
    package_data={"dumbbell": ["__init__.pyi", "py.typed"]},
    ext_modules=[Extension("dumbbell._dumbbell", [])],
    cmdclass={"build_ext": BuildByCMake},
    options={"egg_info": {"egg_base": "build"}},
)
