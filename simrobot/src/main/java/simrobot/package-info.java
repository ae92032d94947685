/** SimRobot: the robot's side of the suite. */
package simrobot;
