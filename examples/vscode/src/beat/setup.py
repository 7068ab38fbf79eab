from setuptools import setup

setup(
    name="beat",
    version="1.0.0",
    packages=["beat"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/beat"]),
        ("share/beat", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="rosml",
    maintainer_email="rosml@example.org",
    description="Says that it lives",
    license="Apache-2.0",
    tests_require=["pytest"],
    entry_points={"console_scripts": ["beat = beat.node:main"]},
)
