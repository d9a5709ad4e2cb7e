"""An example run on the simulated Mega against a simulated autopilot, for a person to watch.

    from demonstration.demonstration import Demonstration, Settings
    Demonstration(Settings("UploadMission", autopilot="px4", loss_percent=10)).run()

What looks at the words of a command, asked.py and frame_names.py, needs nothing that is installed.
"""
