package simgsm.cells.snapshot;

/**
 * One step of signalling between a mobile, its towers and the controller.
 *
 * @param nanos the owner thread's time
 * @param number of the mobile
 * @param from the serving tower; the old one of a handover
 * @param to the new tower of a handover; the reason of a refusal; empty for the other kinds
 * @param figure the report's number, the cause of a failure, the gap in milliseconds, the location area
 */
public record PassingStep(long nanos, String number, Kind kind, String from, String to, int figure) {
    /** The kinds, in the order of a handover. */
    public enum Kind {
        /** MEASUREMENT REPORT; figure: its number. */
        REPORT,
        /** HANDOVER COMMAND. */
        HANDOVER_COMMAND,
        /** HANDOVER ACCESS on the new cell. */
        HANDOVER_ACCESS,
        /** PHYSICAL INFORMATION; figure: the timing advance. */
        PHYSICAL_INFORMATION,
        HANDOVER_COMPLETE,
        /** Return to the old channel; figure: the cause. */
        HANDOVER_FAILURE,
        /** Silence during a handover; figure: milliseconds. */
        SPEECH_GAP,
        /** Another cell was selected in idle mode. */
        RESELECTION,
        /** Figure: the new location area. */
        LOCATION_UPDATE,
        ASSIGNMENT_COMMAND,
        ASSIGNMENT_COMPLETE,
        CHANNEL_REQUEST,
        IMMEDIATE_ASSIGNMENT,
        CHANNEL_RELEASE,
        /** CIPHERING MODE COMPLETE; figure: N of A5/N. */
        CIPHERING,
        PAGING,
        RADIO_LINK_FAILURE,
        TOWER_ON,
        TOWER_OFF,
        /** By the controller; {@code to}: the reason. */
        TOWER_REFUSED
    }
}
