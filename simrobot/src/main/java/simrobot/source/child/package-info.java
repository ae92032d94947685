/**
 * Runs in the child: an operating system process that executes one student's file for all its robots.
 * {@link simrobot.source.child.ChildMain} answers the lines of {@link simrobot.source.child.PipeLine} that SimRobot writes
 * to its standard input. {@code docs/BEHAVIOUR.md} describes them.
 */
package simrobot.source.child;
