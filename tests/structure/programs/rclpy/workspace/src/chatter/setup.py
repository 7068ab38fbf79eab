from setuptools import setup

setup(
    name="chatter",
    version="0.0.0",
    packages=["chatter"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/chatter"]),
        ("share/chatter", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    entry_points={"console_scripts": ["talk = chatter.talk:main"]},
)
