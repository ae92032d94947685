package simgsm.center.msc.call;

import java.util.Optional;
import simgsm.center.msc.link.NetworkTimer;

/**
 * States of a call leg on the network side (TS 24.008, 5.1.1.2). N8 (connect request) and N11 (disconnect request) do not
 * occur, because CONNECT and DISCONNECT are answered at once.
 */
public enum NetworkCallState {
    /** N0: no call. */
    NULL(0),
    /** N0.1: the called mobile is being paged. */
    MM_CONNECTION_PENDING(2),
    /** N1: the mobile has sent SETUP. */
    CALL_INITIATED(1),
    /** N3: CALL PROCEEDING is sent. */
    CALL_PROCEEDING(3),
    /** N4: ALERTING is sent to the caller. */
    CALL_DELIVERED(4),
    /** N6: SETUP is sent to the called mobile. */
    CALL_PRESENT(6, NetworkTimer.T303),
    /** N7: the called mobile alerts. */
    CALL_RECEIVED(7, NetworkTimer.T301),
    /** N9: the called mobile has confirmed SETUP. */
    CALL_CONFIRMED(9, NetworkTimer.T310),
    /** N10: connected. */
    ACTIVE(10),
    /** N12: DISCONNECT is sent. */
    DISCONNECT_INDICATION(12, NetworkTimer.T305),
    /** N19: RELEASE is sent. */
    RELEASE_REQUEST(19, NetworkTimer.T308),
    /** N28: CONNECT is sent to the caller. */
    CONNECT_INDICATION(28, NetworkTimer.T313);

    private final int code;
    private final NetworkTimer guard;

    NetworkCallState(int code) {
        this(code, null);
    }

    NetworkCallState(int code, NetworkTimer guard) {
        this.code = code;
        this.guard = guard;
    }

    /** The call state of STATUS (TS 24.008, 10.5.4.6). */
    public int code() {
        return code;
    }

    /**
     * The timer that runs in this state.
     *
     * @param withTone whether the network plays a tone to the mobile in it
     */
    Optional<NetworkTimer> guard(boolean withTone) {
        return Optional.ofNullable(withTone && this == DISCONNECT_INDICATION ? NetworkTimer.T306 : guard);
    }

    /** Whether speech passes: from CONNECT on, so that none is lost before its acknowledgement. */
    boolean speaks() {
        return this == ACTIVE || this == CONNECT_INDICATION;
    }

    /**
     * Whether a tower gives the mobile a traffic channel: from CALL PROCEEDING or CALL CONFIRMED on, so that it is there when the
     * called party answers.
     */
    boolean needsSpeechPath() {
        return this == CALL_PROCEEDING || this == CALL_CONFIRMED || mayHear();
    }

    /** Whether the mobile may hear something: from alerting to the end of clearing. */
    boolean mayHear() {
        return this == CALL_DELIVERED || this == CALL_RECEIVED || this == DISCONNECT_INDICATION || speaks();
    }

    boolean isClearing() {
        return this == NULL || this == DISCONNECT_INDICATION || this == RELEASE_REQUEST;
    }
}
