package simgsm.center.ui;

/** Terminals that may register. */
public enum NetworkAccess {
    /** Terminals on this machine, with any free number. */
    OPEN,
    /** Terminals on other machines too. */
    OPEN_TO_OTHERS,
    /** Only SIMs of a list. */
    CLOSED
}
