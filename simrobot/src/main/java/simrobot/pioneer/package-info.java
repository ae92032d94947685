/**
 * A real Pioneer, or another P2OS server (MobileSim, SimRobot's own P2OS port), in place of a simulated robot: it
 * executes the same orders by telephone. Read first {@link simrobot.pioneer.RealPioneer}: it is owned by the
 * simulation's thread and uses no clock and no socket; {@link simrobot.pioneer.PioneerCall} supplies the time and the
 * connection.
 *
 * <pre>
 *   PioneerCall - RealPioneer - P2osClientSession, VelocityLoop, DeadReckoning - InformationPacket
 * </pre>
 *
 * Arrows: pioneer -&gt; p2os -&gt; simulation -&gt; robot.
 */
package simrobot.pioneer;
