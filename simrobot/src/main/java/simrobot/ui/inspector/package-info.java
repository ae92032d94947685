/**
 * The inspector beside SimRobot's floor: robots and their status, pose, odometry, sonar, camera, the log of events and the processes, each a
 * card. The cards draw the newest snapshot; the robot's owner does what their buttons ask for.
 */
package simrobot.ui.inspector;
