package simgsm.center.smpp;

import static simgsm.center.smpp.SmppSessionTable.SmppSessionAction.*;
import static simgsm.center.smpp.SmppSessionTable.SmppSessionEvent.*;
import static simgsm.center.smpp.SmppSessionTable.SmppSessionState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.smpp.SmppCommand;
import simgsm.state.StateTable;

/** States of a session (2.2) and the requests that each accepts (2.3). */
public final class SmppSessionTable {
    public enum SmppSessionState {
        OPEN,
        BOUND_TX,
        BOUND_RX,
        BOUND_TRX,
        UNBOUND;

        boolean isBound() {
            return BOUND.contains(this);
        }

        /** True if deliver_sm is sent on such a session. */
        boolean receives() {
            return this == BOUND_RX || this == BOUND_TRX;
        }
    }

    /** A request of the application, named as its {@link SmppCommand}; or the session's end. */
    public enum SmppSessionEvent {
        BIND_RECEIVER,
        BIND_TRANSMITTER,
        QUERY_SM,
        SUBMIT_SM,
        DELIVER_SM,
        UNBIND,
        REPLACE_SM,
        CANCEL_SM,
        BIND_TRANSCEIVER,
        ENQUIRE_LINK,
        SUBMIT_MULTI,
        DATA_SM,
        /** The connection is lost, or closed by the centre. */
        END;

        static SmppSessionEvent of(SmppCommand request) {
            return valueOf(request.name());
        }
    }

    public enum SmppSessionAction {
        /** The application receives its waiting messages. */
        ADD_TO_ROUTES,
        /** Unanswered deliver_sm return to their queues. */
        REMOVE_FROM_ROUTES,
        CLOSE_CONNECTION
    }

    private static final Set<SmppSessionState> BOUND = EnumSet.of(BOUND_TX, BOUND_RX, BOUND_TRX);
    private static final Set<SmppSessionState> SENDING = EnumSet.of(BOUND_TX, BOUND_TRX);

    public static final StateTable<SmppSessionState, SmppSessionEvent, SmppSessionAction> ROWS = new StateTable<
                    SmppSessionState, SmppSessionEvent, SmppSessionAction>("SMPP session", OPEN)
            .on(OPEN, BIND_TRANSMITTER, BOUND_TX, ADD_TO_ROUTES)
            .on(OPEN, BIND_RECEIVER, BOUND_RX, ADD_TO_ROUTES)
            .on(OPEN, BIND_TRANSCEIVER, BOUND_TRX, ADD_TO_ROUTES)
            .stay(EnumSet.of(OPEN, BOUND_TX, BOUND_RX, BOUND_TRX), ENQUIRE_LINK)
            .stay(SENDING, SUBMIT_SM)
            .stay(SENDING, DATA_SM)
            .stay(SENDING, SUBMIT_MULTI)
            .stay(SENDING, REPLACE_SM)
            .stay(SENDING, QUERY_SM)
            .stay(SENDING, CANCEL_SM)
            .on(BOUND, UNBIND, UNBOUND, REMOVE_FROM_ROUTES, CLOSE_CONNECTION)
            .on(BOUND, END, UNBOUND, REMOVE_FROM_ROUTES)
            .on(OPEN, END, UNBOUND);

    private SmppSessionTable() {}
}
