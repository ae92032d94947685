package simrobot.pioneer;

/** The way to a robot, as its core uses it; none of this waits. */
public interface PioneerLine {
    /** Sends a whole packet, frame and all; without a connection it is lost. */
    void send(byte[] packet);

    /** Wants to be connected, now and whenever the connection is lost. */
    void call();

    /** Ends the connection; it is made again if that is still wanted. */
    void drop();

    /** Ends the connection and wants none. */
    void hangUp();
}
