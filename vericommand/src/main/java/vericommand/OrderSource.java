package vericommand;

/** The way by which an order is given and answered. */
public enum OrderSource {
    /** Keys of a call, answered by tones. */
    CALL,
    /** A short message, answered by another one. */
    MESSAGE,
    /** A program, as over HTTP or ROS, which follows an {@link OrderReport}. */
    PROGRAM
}
