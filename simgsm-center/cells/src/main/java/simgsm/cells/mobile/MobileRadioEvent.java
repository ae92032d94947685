package simgsm.cells.mobile;

/** Events of {@link MobileRadioTable}. */
public enum MobileRadioEvent {
    /** The terminal has a first message. */
    FIRST_MESSAGE,
    /** IMMEDIATE ASSIGNMENT. */
    GRANTED,
    /** No answer to the last CHANNEL REQUEST, or no cell. */
    ACCESS_FAILED,
    ASSIGNMENT_COMMAND,
    HANDOVER_COMMAND,
    /** The link layer is established on the new channel. */
    ARRIVED,
    /** The new channel cannot be used. */
    CHANGE_FAILED,
    /** The terminal leaves the channel. */
    LEFT,
    /** The controller or the tower has taken the channel away. */
    CHANNEL_LOST,
    /** The radio link counter is 0. */
    LINK_FAILED,
    /** The terminal is gone. */
    TERMINAL_LOST
}
