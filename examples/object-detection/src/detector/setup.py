from setuptools import setup

setup(
    name="detector",
    version="1.0.0",
    packages=["detector"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/detector"]),
        ("share/detector", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    maintainer="rosml",
    maintainer_email="rosml@example.org",
    description="Finds things in pictures, in Python",
    license="Apache-2.0",
    tests_require=["pytest"],
    entry_points={"console_scripts": ["detect = detector.ros2:detect", "camera = detector.ros2:camera"]},
)
