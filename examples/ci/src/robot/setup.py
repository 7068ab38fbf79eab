from setuptools import setup

setup(
    name="robot",
    version="1.0.0",
    packages=["robot"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/robot"]),
        ("share/robot", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="rosml",
    maintainer_email="rosml@example.org",
    description="Keeps a robot to the speed that its driver allows",
    license="Apache-2.0",
    tests_require=["pytest"],
    entry_points={"console_scripts": ["limit = robot.node:main"]},
)
