package simgsm.cells.mobile;

import static simgsm.cells.mobile.MobileRadioAction.*;
import static simgsm.cells.mobile.MobileRadioEvent.*;
import static simgsm.cells.mobile.MobileRadioState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** How a mobile comes onto a channel, changes it and leaves it (TS 44.018, 3.3, 3.4 and 3.5). */
public final class MobileRadioTable {
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
