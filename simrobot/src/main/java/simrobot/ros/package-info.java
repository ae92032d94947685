/**
 * The rosbridge protocol, version 2, in JSON on a WebSocket: ROS programs read the robots' sensors and drive them. Read first {@link
 * simrobot.ros.RosTopic}, the table of the topics.
 *
 * <pre>
 *   RosServer - RosSession - RosRequest, RosServices, Twist
 *             - RosTopic - RosMessages
 *             - VelocityCommands -&gt; DirectControl
 * </pre>
 *
 * One thread owns the sockets and their subscriptions; a second one makes messages from snapshots of the simulation, at most 20
 * times a second for all clients together, and none without subscriptions; velocities act on the simulation's thread.
 */
package simrobot.ros;
