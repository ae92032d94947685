package simgsm.center.smpp;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;

/** The states of a session (2.2) and, as a table, which request is for which state and where it leads (2.3). */
enum SessionState {
    OPEN,
    BOUND_TX,
    BOUND_RX,
    BOUND_TRX,
    UNBOUND;

    private static final Map<SessionState, Map<SmppCommand, SessionState>> TABLE = new EnumMap<>(SessionState.class);

    static {
        row(OPEN, SmppCommand.BIND_TRANSMITTER, BOUND_TX);
        row(OPEN, SmppCommand.BIND_RECEIVER, BOUND_RX);
        row(OPEN, SmppCommand.BIND_TRANSCEIVER, BOUND_TRX);
        row(OPEN, SmppCommand.ENQUIRE_LINK, OPEN);
        for (SessionState sending : new SessionState[] {BOUND_TX, BOUND_TRX}) {
            row(sending, SmppCommand.SUBMIT_SM, sending);
            row(sending, SmppCommand.DATA_SM, sending);
            row(sending, SmppCommand.QUERY_SM, sending);
            row(sending, SmppCommand.CANCEL_SM, sending);
        }
        for (SessionState bound : new SessionState[] {BOUND_TX, BOUND_RX, BOUND_TRX}) {
            row(bound, SmppCommand.ENQUIRE_LINK, bound);
            row(bound, SmppCommand.UNBIND, UNBOUND);
        }
    }

    private static void row(SessionState state, SmppCommand command, SessionState next) {
        TABLE.computeIfAbsent(state, key -> new EnumMap<>(SmppCommand.class)).put(command, next);
    }

    boolean isBound() {
        return this == BOUND_TX || this == BOUND_RX || this == BOUND_TRX;
    }

    /** Whether deliver_sm goes to such a session. */
    boolean receives() {
        return this == BOUND_RX || this == BOUND_TRX;
    }

    /** The state after the request is fulfilled; empty if it is not for this state. */
    Optional<SessionState> after(SmppCommand request) {
        return Optional.ofNullable(TABLE.getOrDefault(this, Map.of()).get(request));
    }

    /** The status that refuses a request that is not for this state. */
    int refusal(SmppCommand request) {
        return request.isBind() && isBound() ? SmppStatus.ALREADY_BOUND : SmppStatus.INVALID_BIND_STATUS;
    }
}
