from setuptools import setup

setup(
    name="counter",
    version="1.0.0",
    packages=["counter"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/counter"]),
        ("share/counter", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="rosml",
    maintainer_email="rosml@example.org",
    description="Counts, and tells when it has come to a round number",
    license="Apache-2.0",
    tests_require=["pytest"],
    entry_points={"console_scripts": ["count = counter.node:main"]},
)
