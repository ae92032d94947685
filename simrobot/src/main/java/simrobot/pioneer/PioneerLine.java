package simrobot.pioneer;

/** Connection to a robot; no method blocks. */
public interface PioneerLine {
    /** Sends a framed packet; without a connection it is dropped. */
    void send(byte[] packet);

    /** Connects, and reconnects whenever the connection is lost. */
    void call();

    /** Closes the connection; reconnects unless {@link #hangUp} was called. */
    void drop();

    /** Closes the connection and does not reconnect. */
    void hangUp();
}
