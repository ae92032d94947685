package simgsm.gateway.sip;

import static simgsm.gateway.sip.ClientTransactionTable.ClientTransactionAction.*;
import static simgsm.gateway.sip.ClientTransactionTable.ClientTransactionEvent.*;
import static simgsm.gateway.sip.ClientTransactionTable.ClientTransactionState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** A request to a phone, INVITE or other (RFC 3261, 17.1; RFC 6026, 7.2). */
final class ClientTransactionTable {
    /** States. */
    enum ClientTransactionState {
        /** INVITE: calling; others: trying. */
        SENT,
        /** INVITE has a provisional response. */
        PROCEEDING,
        /** INVITE has 200. */
        ACCEPTED,
        COMPLETED,
        TERMINATED
    }

    /** Events. */
    enum ClientTransactionEvent {
        RINGING,
        ACCEPT,
        REFUSE,
        /** The final response to a request other than INVITE. */
        FINAL,
        /** The call is given up. */
        CANCEL,
        /** Timer A or E. */
        RESEND_EXPIRED,
        /** Timer B or F. */
        LIMIT_EXPIRED,
        /** Timer D, K or M. */
        LINGER_EXPIRED
    }

    /** Actions of {@link ClientTransaction}. */
    enum ClientTransactionAction {
        SEND,
        SEND_ACK,
        START_RESEND,
        START_LIMIT,
        START_LINGER,
        STOP_TIMERS,
        REPORT,
        REPORT_TIMEOUT,
        REMOVE
    }

    static final StateTable<ClientTransactionState, ClientTransactionEvent, ClientTransactionAction> TABLE =
            new StateTable<>("SIP client transaction", SENT);

    static {
        TABLE.stay(EnumSet.of(SENT), RESEND_EXPIRED, SEND, START_RESEND)
                .on(SENT, RINGING, PROCEEDING, STOP_TIMERS, REPORT)
                .stay(EnumSet.of(PROCEEDING), RINGING, REPORT)
                .stay(EnumSet.of(PROCEEDING), CANCEL, START_LIMIT)
                .on(EnumSet.of(SENT, PROCEEDING), LIMIT_EXPIRED, TERMINATED, STOP_TIMERS, REMOVE, REPORT_TIMEOUT)
                .on(EnumSet.of(SENT, PROCEEDING), ACCEPT, ACCEPTED, STOP_TIMERS, START_LINGER, REPORT)
                .on(EnumSet.of(SENT, PROCEEDING), REFUSE, COMPLETED, STOP_TIMERS, SEND_ACK, START_LINGER, REPORT)
                .on(SENT, FINAL, COMPLETED, STOP_TIMERS, START_LINGER, REPORT)
                .stay(EnumSet.of(ACCEPTED), ACCEPT, REPORT)
                .stay(EnumSet.of(COMPLETED), REFUSE, SEND_ACK)
                .on(EnumSet.of(ACCEPTED, COMPLETED), LINGER_EXPIRED, TERMINATED, REMOVE);
    }

    private ClientTransactionTable() {}
}
