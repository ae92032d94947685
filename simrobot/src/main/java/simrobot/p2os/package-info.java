/**
 * The Pioneer's own protocol, P2OS, so that real robot software drives a simulated robot: packets
 * ({@link simrobot.p2os.P2osPacket}, {@link simrobot.p2os.P2osPacketReader}), commands ({@link simrobot.p2os.Command}), a
 * client's session on a robot ({@link simrobot.p2os.P2osSession}, read it first), and the sockets
 * ({@link simrobot.p2os.P2osServer}). Sessions belong to the simulation's thread and know no clock and no socket.
 * Numbers are those of the Pioneer 2 Operations Manual and of ARIA's robot files. Arrows: p2os -&gt; simulation -&gt; robot.
 */
package simrobot.p2os;
