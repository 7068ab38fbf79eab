from setuptools import setup

setup(
    name="guard",
    version="1.0.0",
    packages=["guard"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/guard"]),
        ("share/guard", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="rosml",
    maintainer_email="rosml@example.org",
    description="Says whether something stands in the way",
    license="Apache-2.0",
    tests_require=["pytest"],
    entry_points={"console_scripts": ["watch = guard.node:main"]},
)
