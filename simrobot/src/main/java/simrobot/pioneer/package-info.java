/**
 * A real Pioneer, or whatever speaks as one (MobileSim, SimRobot's own P2OS port), in a simulated one's place: the same
 * orders by telephone drive it. Read first {@link simrobot.pioneer.RealPioneer}: it belongs to the simulation's thread and
 * knows no clock and no socket; {@link simrobot.pioneer.PioneerCall} gives it time and a line.
 *
 * <pre>
 *   PioneerCall - RealPioneer - Conversation, Travel, DeadReckoning - Information
 * </pre>
 *
 * Arrows: pioneer -&gt; p2os -&gt; simulation -&gt; robot.
 */
package simrobot.pioneer;
