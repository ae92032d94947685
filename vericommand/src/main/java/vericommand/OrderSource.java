package vericommand;

/** The way an order is given and answered. */
public enum OrderSource {
    /** Keys of a call, answered by tones. */
    CALL,
    /** A short message, answered by a short message. */
    MESSAGE,
    /** A program, over HTTP or ROS, which follows an {@link OrderReport}. */
    PROGRAM
}
