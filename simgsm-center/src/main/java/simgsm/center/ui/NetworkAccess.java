package simgsm.center.ui;

/** Who may register. */
public enum NetworkAccess {
    /** Anybody on this machine, under any free number. */
    OPEN,
    /** Anybody who reaches the port from another machine, too. */
    OPEN_TO_OTHERS,
    /** The SIMs of a list alone. */
    CLOSED
}
