package vericommand;

/** The endings of a process. */
public enum ProcessEnding {
    /** The process has reached its goal. */
    DONE,
    /** The process did not free the robot from a collision. */
    COLLISION,
    /** The process has given up or failed. */
    FAILED,
    /** An order, another process or a brake ended the process; it gets no reply. */
    REPLACED
}
