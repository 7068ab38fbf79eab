from setuptools import setup

setup(
    name="policy",
    version="1.0.0",
    packages=["policy"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/policy"]),
        ("share/policy", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="rosml",
    maintainer_email="rosml@example.org",
    description="Moves a robot by a policy of LeRobot",
    license="Apache-2.0",
    tests_require=["pytest"],
    entry_points={"console_scripts": ["act = policy.node:main"]},
)
