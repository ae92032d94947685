"""Writes a world of Stage with the walls and homes of an ARIA map: stage_world.py FILE.map > FILE.world"""

import math
import sys

print('include "pioneer.inc"\ninterval_sim 100\ndefine wall model (color "gray" boundary 0 gui_nose 0 obstacle_return 1)')
print('define robot pioneer2dx (localization "gps" odom_error [0 0 0 0])')
lines, robots = False, 0
for line in open(sys.argv[1]):
    words = line.split()
    if words[:2] == ["Cairn:", "RobotHome"]:
        x, y, heading = (float(word) for word in words[2:5])
        print(f'robot (name "r{robots}" pose [{x / 1000} {y / 1000} 0 {heading}])')
        robots += 1
    elif words and words[0] in ("LINES", "DATA"):
        lines = words[0] == "LINES"
    elif lines and len(words) == 4:
        x1, y1, x2, y2 = (float(word) / 1000 for word in words)
        length = math.hypot(x2 - x1, y2 - y1)
        turn = math.degrees(math.atan2(y2 - y1, x2 - x1))
        print(f"wall (pose [{(x1 + x2) / 2} {(y1 + y2) / 2} 0 {turn}] size [{length} 0.02 1])")
