from setuptools import setup

setup(
    name="lights",
    version="1.0.0",
    packages=["lights"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/lights"]),
        ("share/lights", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="rosml",
    maintainer_email="rosml@example.org",
    description="A light that moves, and a node that follows it",
    license="Apache-2.0",
    tests_require=["pytest"],
    entry_points={"console_scripts": ["camera = lights.camera:main", "watcher = lights.watcher:main"]},
)
