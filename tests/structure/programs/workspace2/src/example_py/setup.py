from setuptools import setup

setup(
    name="example_py",
    version="0.0.0",
    packages=["example_py"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/example_py"]),
        ("share/example_py", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    entry_points={"console_scripts": ["score = example_py.score:main", "count = example_py.count:main"]},
)
