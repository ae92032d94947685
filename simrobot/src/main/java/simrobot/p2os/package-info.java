/**
 * The Pioneer's protocol, P2OS, by which real robot software drives a simulated robot: packets ({@link
 * simrobot.p2os.P2osPacket}, {@link simrobot.p2os.P2osPacketReader}), commands ({@link simrobot.p2os.P2osCommand}), a
 * client's session on a robot ({@link simrobot.p2os.P2osSession}, read it first), and the sockets ({@link
 * simrobot.p2os.P2osServer}). Sessions are owned by the simulation's thread and use no clock and no socket. Constants
 * are from the Pioneer 2 Operations Manual and ARIA's robot files. Arrows: p2os -&gt; simulation -&gt; robot.
 */
package simrobot.p2os;
