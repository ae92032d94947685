package vericommand;

/** Ending of a process. */
public enum ProcessEnding {
    /** It has reached what it was for. */
    DONE,
    /** It did not free the robot from a collision. */
    COLLISION,
    /** It has given up or failed. */
    FAILED,
    /** An order, another process or a brake has ended it: it gets no reply. */
    REPLACED
}
