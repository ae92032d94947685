package simgsm.modem.client;

import static simgsm.modem.client.ModemServiceTable.ServiceAction.*;
import static simgsm.modem.client.ModemServiceTable.ServiceEvent.*;
import static simgsm.modem.client.ModemServiceTable.ServiceState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** The set-up of an attached modem, and its repetition after a loss or restart. */
final class ModemServiceTable {
    enum ServiceState {
        NO_LINE,
        /** Sends AT until the modem answers. */
        STARTING,
        PREPARING,
        READY
    }

    enum ServiceEvent {
        LINE_UP,
        LINE_DOWN,
        ATTENTIVE,
        PREPARED,
        /** The modem has restarted: its settings and its call are lost. */
        BOOTED,
        /** A command was not answered, or the set-up cannot be completed. */
        STALLED
    }

    enum ServiceAction {
        FORGET,
        CALL_FOR_ATTENTION,
        PREPARE,
        SERVE
    }

    private static final Set<ServiceState> WITH_LINE = EnumSet.of(STARTING, PREPARING, READY);

    static final StateTable<ServiceState, ServiceEvent, ServiceAction> TABLE = new StateTable<
                    ServiceState, ServiceEvent, ServiceAction>("attached modem", NO_LINE)
            .on(NO_LINE, LINE_UP, STARTING, CALL_FOR_ATTENTION)
            .on(STARTING, ATTENTIVE, PREPARING, PREPARE)
            .on(PREPARING, PREPARED, READY, SERVE)
            .on(WITH_LINE, EnumSet.of(BOOTED, STALLED), STARTING, FORGET, CALL_FOR_ATTENTION)
            .on(WITH_LINE, LINE_DOWN, NO_LINE, FORGET);

    private ModemServiceTable() {}
}
