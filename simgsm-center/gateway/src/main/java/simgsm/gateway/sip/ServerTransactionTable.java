package simgsm.gateway.sip;

import static simgsm.gateway.sip.ServerTransactionTable.ServerTransactionAction.*;
import static simgsm.gateway.sip.ServerTransactionTable.ServerTransactionEvent.*;
import static simgsm.gateway.sip.ServerTransactionTable.ServerTransactionState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** A request of a phone, INVITE or other (RFC 3261, 17.2; RFC 6026, 7.1). */
final class ServerTransactionTable {
    /** States. */
    enum ServerTransactionState {
        TRYING,
        PROCEEDING,
        /** A request other than INVITE has its final response. */
        COMPLETED,
        /** INVITE has 200, repeated until ACK. */
        ACCEPTED,
        /** INVITE has a final response from 300 on, repeated until ACK. */
        REFUSED,
        CONFIRMED,
        TERMINATED
    }

    /** Events. */
    enum ServerTransactionEvent {
        REPEATED,
        PROVISIONAL,
        FINAL,
        ACCEPT,
        REFUSE,
        ACK,
        G_EXPIRED,
        H_EXPIRED,
        /** Timer I or J. */
        LINGER_EXPIRED
    }

    /** Actions of {@link ServerTransaction}. */
    enum ServerTransactionAction {
        SEND,
        START_G,
        START_H,
        START_LINGER,
        STOP_TIMERS,
        REPORT_UNACKNOWLEDGED,
        REMOVE
    }

    static final StateTable<ServerTransactionState, ServerTransactionEvent, ServerTransactionAction> TABLE =
            new StateTable<>("SIP server transaction", TRYING);

    static {
        TABLE.stay(EnumSet.of(TRYING), REPEATED)
                .on(EnumSet.of(TRYING, PROCEEDING), PROVISIONAL, PROCEEDING, SEND)
                .on(EnumSet.of(TRYING, PROCEEDING), FINAL, COMPLETED, SEND, START_LINGER)
                .on(EnumSet.of(TRYING, PROCEEDING), ACCEPT, ACCEPTED, SEND, START_G, START_H)
                .on(EnumSet.of(TRYING, PROCEEDING), REFUSE, REFUSED, SEND, START_G, START_H)
                .stay(EnumSet.of(PROCEEDING, COMPLETED, ACCEPTED, REFUSED), REPEATED, SEND)
                .stay(EnumSet.of(ACCEPTED, REFUSED), G_EXPIRED, SEND, START_G)
                .on(EnumSet.of(ACCEPTED, REFUSED), ACK, CONFIRMED, STOP_TIMERS, START_LINGER)
                .on(ACCEPTED, H_EXPIRED, TERMINATED, STOP_TIMERS, REMOVE, REPORT_UNACKNOWLEDGED)
                .on(REFUSED, H_EXPIRED, TERMINATED, STOP_TIMERS, REMOVE)
                .on(EnumSet.of(COMPLETED, CONFIRMED), LINGER_EXPIRED, TERMINATED, REMOVE);
    }

    private ServerTransactionTable() {}
}
