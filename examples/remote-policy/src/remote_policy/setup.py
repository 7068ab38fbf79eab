from setuptools import setup

setup(
    name="remote_policy",
    version="1.0.0",
    packages=["remote_policy"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/remote_policy"]),
        ("share/remote_policy", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="rosml",
    maintainer_email="rosml@example.org",
    description="Moves a robot by a policy in another process",
    license="Apache-2.0",
    tests_require=["pytest"],
    entry_points={"console_scripts": ["act = remote_policy.node:main"]},
)
