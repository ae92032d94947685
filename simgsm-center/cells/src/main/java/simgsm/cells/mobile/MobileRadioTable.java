package simgsm.cells.mobile;

import static simgsm.cells.mobile.MobileRadioTable.MobileRadioAction.*;
import static simgsm.cells.mobile.MobileRadioTable.MobileRadioEvent.*;
import static simgsm.cells.mobile.MobileRadioTable.MobileRadioState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** A mobile's access to a channel, its change and release (TS 44.018, 3.3, 3.4 and 3.5). */
public final class MobileRadioTable {
    /** An action of a mobile's radio part (TS 44.018, 3). */
    public enum MobileRadioState {
        /** Without a channel. */
        IDLE,
        /** CHANNEL REQUEST is sent. */
        ACCESS,
        /** On a channel. */
        DEDICATED,
        /** Between two channels of a cell; layer 3 waits. */
        ASSIGNMENT,
        /** Between two cells; layer 3 waits. */
        HANDOVER
    }

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
        /** The controller or the tower has released the channel. */
        CHANNEL_LOST,
        /** The radio link counter is 0. */
        LINK_FAILED,
        /** The terminal is gone. */
        TERMINAL_LOST
    }

    /** Actions of {@link MobileRadioTable}. */
    public enum MobileRadioAction {
        REQUEST_CHANNEL,
        END_ACCESS,
        ESTABLISH,
        BEGIN_ASSIGNMENT,
        COMPLETE_ASSIGNMENT,
        FAIL_ASSIGNMENT,
        BEGIN_HANDOVER,
        COMPLETE_HANDOVER,
        FAIL_HANDOVER,
        SEND_HELD,
        LEAVE_CHANNEL,
        FORSAKE_CHANNEL,
        RELEASE_TERMINAL,
        FORGET
    }

    public static final StateTable<MobileRadioState, MobileRadioEvent, MobileRadioAction> TABLE =
            new StateTable<>("mobile radio", IDLE);

    private static final Set<MobileRadioState> ON_CHANNEL = EnumSet.of(DEDICATED, ASSIGNMENT, HANDOVER);

    static {
        TABLE.on(IDLE, FIRST_MESSAGE, ACCESS, REQUEST_CHANNEL)
                .on(ACCESS, GRANTED, DEDICATED, ESTABLISH, SEND_HELD)
                .on(ACCESS, ACCESS_FAILED, IDLE, END_ACCESS, RELEASE_TERMINAL, FORGET)
                .on(EnumSet.of(ACCESS), EnumSet.of(LEFT, TERMINAL_LOST), IDLE, END_ACCESS, FORGET)
                .on(DEDICATED, ASSIGNMENT_COMMAND, ASSIGNMENT, BEGIN_ASSIGNMENT)
                .on(ASSIGNMENT, ARRIVED, DEDICATED, COMPLETE_ASSIGNMENT, SEND_HELD)
                .on(ASSIGNMENT, CHANGE_FAILED, DEDICATED, FAIL_ASSIGNMENT, SEND_HELD)
                .on(DEDICATED, HANDOVER_COMMAND, HANDOVER, BEGIN_HANDOVER)
                .on(HANDOVER, ARRIVED, DEDICATED, COMPLETE_HANDOVER, SEND_HELD)
                .on(HANDOVER, CHANGE_FAILED, DEDICATED, FAIL_HANDOVER, SEND_HELD)
                .on(ON_CHANNEL, LEFT, IDLE, LEAVE_CHANNEL, FORGET)
                .on(ON_CHANNEL, EnumSet.of(CHANNEL_LOST, LINK_FAILED), IDLE, FORSAKE_CHANNEL, RELEASE_TERMINAL, FORGET)
                .on(ON_CHANNEL, TERMINAL_LOST, IDLE, FORSAKE_CHANNEL, FORGET);
    }

    private MobileRadioTable() {}
}
