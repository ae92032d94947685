package simgsm.center.msc;

import java.util.Optional;

/**
 * The network's side of one call leg (TS 24.008, 5.1.1.2). N8 (connect request) and N11 (disconnect request) are missing
 * because this exchange answers CONNECT and DISCONNECT at once and never rests there.
 */
enum NetworkCallState {
    /** N0: no call. */
    NULL(0),
    /** N0.1: waiting for the called mobile to answer paging. */
    MM_CONNECTION_PENDING(2),
    /** N1: SETUP has come from the mobile. */
    CALL_INITIATED(1),
    /** N3: CALL PROCEEDING is sent. */
    CALL_PROCEEDING(3),
    /** N4: ALERTING is sent to the caller. */
    CALL_DELIVERED(4),
    /** N6: SETUP is sent to the called mobile. */
    CALL_PRESENT(6, NetworkCallTimer.T303),
    /** N7: the called mobile rings. */
    CALL_RECEIVED(7, NetworkCallTimer.T301),
    /** N9: the called mobile has confirmed SETUP. */
    CALL_CONFIRMED(9, NetworkCallTimer.T310),
    /** N10: connected. */
    ACTIVE(10),
    /** N12: DISCONNECT is sent. */
    DISCONNECT_INDICATION(12, NetworkCallTimer.T305),
    /** N19: RELEASE is sent. */
    RELEASE_REQUEST(19, NetworkCallTimer.T308),
    /** N28: CONNECT is sent to the caller. */
    CONNECT_INDICATION(28, NetworkCallTimer.T313);

    private final int code;
    private final NetworkCallTimer guard;

    NetworkCallState(int code) {
        this(code, null);
    }

    NetworkCallState(int code, NetworkCallTimer guard) {
        this.code = code;
        this.guard = guard;
    }

    /** The call state octet of STATUS (TS 24.008, 10.5.4.6). */
    int code() {
        return code;
    }

    /**
     * The timer that runs for as long as the leg rests in this state.
     *
     * @param withTone whether the mobile hears a tone of the network's meanwhile
     */
    Optional<NetworkCallTimer> guard(boolean withTone) {
        return Optional.ofNullable(withTone && this == DISCONNECT_INDICATION ? NetworkCallTimer.T306 : guard);
    }

    /** Whether speech passes: from CONNECT on, so that nothing said before its acknowledgement is lost. */
    boolean speaks() {
        return this == ACTIVE || this == CONNECT_INDICATION;
    }

    boolean isClearing() {
        return this == NULL || this == DISCONNECT_INDICATION || this == RELEASE_REQUEST;
    }
}
