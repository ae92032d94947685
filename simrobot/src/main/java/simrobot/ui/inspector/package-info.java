/**
 * The inspector next to SimRobot's floor: robots and their status, pose, odometry, sonar, camera, the log of events and
 * the processes, each a card. The cards draw the newest snapshot; the robot's owner performs the requests of their
 * buttons.
 */
package simrobot.ui.inspector;
